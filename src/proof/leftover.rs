//! What is left on the finished contour after the last program.

use super::cut::Stock;
use super::cut::grid::{GridPoint, above_odd, edges, from_grid, to_grid};
use super::form::distance_to_line;
use super::input::Work;
use super::report::Leftover;
use crate::geometry::{Point, Segment};
use std::collections::BTreeMap;

/// Distance between the points of the contour where stock is measured, mm.
const SAMPLE_MM: f64 = 0.2;
/// Positions closer than this are the same, mm: the rounding of lengths converted from inches.
const SAME_PLACE_MM: f64 = 1e-6;
/// Points measured on one segment at most.
const MOST_SAMPLES: u32 = 2_000;

/// Measures the stock on every machined section, in order of the contour.
pub(super) fn measure(work: &Work, stock: &Stock) -> Vec<Leftover> {
    let border = Border::of(stock);
    let mut sums: BTreeMap<usize, Sum> = BTreeMap::new();
    let mut order: Vec<u32> = Vec::new();
    for (segment, section, from_z) in machined(work) {
        for (p, weight) in samples(segment, from_z) {
            let index = order.iter().position(|&s| s == section).unwrap_or(order.len());
            if index == order.len() {
                order.push(section);
            }
            sums.entry(index).or_default().add(p, weight, border.thickness_at(p));
        }
    }
    let report = |(&section, sum): (&u32, &Sum)| Leftover {
        section,
        largest_mm: sum.largest,
        mean_mm: if sum.weight > 0.0 { sum.total / sum.weight } else { 0.0 },
        at: sum.at,
    };
    order.iter().zip(sums.values()).map(report).collect()
}

/// Segments of the outside and of the bore, with their rows and where their machining begins.
fn machined(work: &Work) -> impl Iterator<Item = (&Segment, u32, f64)> {
    let target = &work.target;
    let outside = target.contour.segments.iter().zip(&target.sections);
    let outside = outside.map(|(segment, &section)| (segment, section, target.machined_from_z));
    let bore = target.bore.iter().flat_map(|bore| {
        let segments = bore.contour.segments.iter().zip(&bore.sections);
        segments.map(|(segment, &section)| (segment, section, bore.machined_from_z))
    });
    // What lies on the axis is no surface.
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
fn samples(segment: &Segment, from_z: f64) -> impl Iterator<Item = (Point, f64)> {
    let length = segment.length();
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped to 1..=MOST_SAMPLES")]
    let count = (length / SAMPLE_MM).ceil().clamp(1.0, f64::from(MOST_SAMPLES)) as u32;
    let middle = move |k: u32| segment.point_at((f64::from(k) + 0.5) / f64::from(count));
    (0..count)
        .map(middle)
        .filter(move |p| p.z > from_z + SAME_PLACE_MM)
        .map(move |p| (p, length / f64::from(count)))
        .collect::<Vec<_>>()
        .into_iter()
}

/// The edges of the stock, sorted into strips of equal width along z, so that a point needs to look at a few of them only.
struct Border {
    /// Position of the first strip on the grid.
    first: i32,
    strips: Vec<Vec<(GridPoint, GridPoint)>>,
}

impl Border {
    /// Width of a strip on the grid: 0.5 mm.
    const WIDTH: i32 = 50_000;
    /// Strips at most; a longer stock has longer last strips.
    const MOST: usize = 10_000;

    fn of(stock: &Stock) -> Self {
        let rings = stock.rings();
        let all = || rings.iter().flat_map(|ring| edges(ring));
        let first = all().map(|(a, _)| a.x).min().unwrap_or(0);
        let mut border = Self { first, strips: Vec::new() };
        for (a, b) in all() {
            let (from, to) = (border.strip(a.x.min(b.x)), border.strip(a.x.max(b.x)));
            if border.strips.len() <= to {
                border.strips.resize_with(to + 1, Vec::new);
            }
            border.strips[from..=to].iter_mut().for_each(|strip| strip.push((a, b)));
        }
        border
    }

    /// The strip that a position belongs to; positions before the first belong to the first.
    fn strip(&self, x: i32) -> usize {
        let steps = x.saturating_sub(self.first) / Self::WIDTH;
        usize::try_from(steps).unwrap_or(0).min(Self::MOST - 1)
    }

    /// Thickness of the stock on the contour at a point of it: the way to the nearest surface, mm; 0 if the point is free.
    fn thickness_at(&self, p: Point) -> f64 {
        let middle = self.strip(to_grid(p).x);
        let here = self.strips.get(middle).map_or(&[][..], Vec::as_slice);
        if !above_odd(here.iter().copied(), to_grid(p)) {
            return 0.0;
        }
        let width = from_grid(GridPoint::new(Self::WIDTH, 0)).z;
        let mut nearest = f64::INFINITY;
        for away in 0..self.strips.len() {
            if away > 0 && (away as f64 - 1.0) * width >= nearest {
                break;
            }
            let sides = [middle.checked_sub(away), middle.checked_add(away).filter(|_| away > 0)];
            for strip in sides.into_iter().flatten().filter_map(|k| self.strips.get(k)) {
                // The edges on the axis are no surface.
                for (a, b) in
                    strip.iter().map(|&(a, b)| (from_grid(a), from_grid(b))).filter(|(a, b)| a.r.max(b.r) > 0.0)
                {
                    nearest = nearest.min(distance_to_line(a, b, p));
                }
            }
        }
        if nearest.is_finite() { nearest } else { 0.0 }
    }
}
