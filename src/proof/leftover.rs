//! What is left on the finished contour after the last program.

use super::cut::Stock;
use super::cut::grid::{GridPoint, above_odd, edges, from_grid, to_grid};
use super::form::distance_to_line;
use super::input::Work;
use super::report::{Leftover, Target};
use super::strips::Strips;
use crate::geometry::{Point, Segment};
use std::collections::HashMap;

/// Distance between the points of the contour where stock is measured, mm.
const SAMPLE_MM: f64 = 0.2;
/// Positions closer than this are the same, mm: the rounding of lengths converted from inches.
const SAME_PLACE_MM: f64 = 1e-6;
/// Points measured on one segment at most.
const MOST_SAMPLES: u32 = 2_000;

/// Measures the stock on every machined section of outside and bore, in order of the contours.
pub(super) fn measure(work: &Work, stock: &Stock) -> Vec<Leftover> {
    let border = Border::of(stock);
    let mut sums: Vec<(u32, Sum)> = Vec::new();
    let mut places: HashMap<u32, usize> = HashMap::new();
    for (segment, section, from_z) in machined(&work.target) {
        let samples = samples(segment, from_z);
        if samples.is_empty() {
            continue;
        }
        let place = *places.entry(section).or_insert(sums.len());
        if place == sums.len() {
            sums.push((section, Sum::default()));
        }
        for (p, weight) in samples {
            sums[place].1.add(p, weight, border.thickness_at(p));
        }
    }
    let report = |(section, sum): (u32, Sum)| Leftover {
        section,
        largest_mm: sum.largest,
        mean_mm: if sum.weight > 0.0 { sum.total / sum.weight } else { 0.0 },
        at: sum.at,
    };
    sums.into_iter().map(report).collect()
}

/// The segments of outside and bore with row id and where machining begins; what lies on the axis is no surface.
fn machined(target: &Target) -> impl Iterator<Item = (&Segment, u32, f64)> {
    let outside = target.contour.segments.iter().zip(&target.sections).map(|(s, &id)| (s, id, target.machined_from_z));
    let bore = target.bore.iter().flat_map(|bore| {
        bore.contour.segments.iter().zip(&bore.sections).map(|(s, &id)| (s, id, bore.machined_from_z))
    });
    outside.chain(bore.filter(|(segment, ..)| segment.bounds().max.r > SAME_PLACE_MM))
}

/// Running figures of one section.
#[derive(Default)]
struct Sum {
    total: f64,
    weight: f64,
    largest: f64,
    at: Point,
    any: bool,
}

impl Sum {
    fn add(&mut self, p: Point, weight: f64, left: f64) {
        self.total += left * weight;
        self.weight += weight;
        if left > self.largest || !self.any {
            (self.largest, self.at, self.any) = (left, p, true);
        }
    }
}

/// Middles of equal parts of a segment, with the length that each stands for. A face just where this set-up's machining
/// ends belongs to the other end of the part.
fn samples(segment: &Segment, from_z: f64) -> Vec<(Point, f64)> {
    let length = segment.length();
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped to 1..=MOST_SAMPLES")]
    let count = (length / SAMPLE_MM).ceil().clamp(1.0, f64::from(MOST_SAMPLES)) as u32;
    let middle = move |k: u32| segment.point_at((f64::from(k) + 0.5) / f64::from(count));
    (0..count)
        .map(middle)
        .filter(move |p| p.z > from_z + SAME_PLACE_MM)
        .map(move |p| (p, length / f64::from(count)))
        .collect()
}

/// The edges of the stock.
struct Border(Strips<Edge>);

/// An edge on the grid and in mm.
#[derive(Debug, Clone, Copy)]
struct Edge {
    on_grid: (GridPoint, GridPoint),
    start: Point,
    end: Point,
}

impl Border {
    fn of(stock: &Stock) -> Self {
        let edge = |on_grid: (GridPoint, GridPoint)| {
            let (start, end) = (from_grid(on_grid.0), from_grid(on_grid.1));
            (start.z.min(end.z), start.z.max(end.z), Edge { on_grid, start, end })
        };
        let all: Vec<_> = stock.rings().iter().flat_map(|ring| edges(ring)).map(edge).collect();
        Self(Strips::of(&all))
    }

    /// Thickness of the stock on the contour at a point of it: the way to the nearest surface, mm; 0 if the point is free.
    fn thickness_at(&self, p: Point) -> f64 {
        let on_grid = to_grid(p);
        let z = from_grid(on_grid).z;
        if !above_odd(self.0.at(z).iter().map(|edge| edge.on_grid), on_grid) {
            return 0.0;
        }
        let nearest = self.0.nearest(z, |Edge { start, end, .. }, nearest| {
            // The edges on the axis are no surface.
            if start.r.max(end.r) > 0.0 { distance_to_line(start, end, p) } else { nearest }
        });
        if nearest.is_finite() { nearest } else { 0.0 }
    }
}
