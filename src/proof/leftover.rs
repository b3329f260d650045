//! What is left on the finished contour after the last program.

use super::cut::Region;
use super::cut::grid::{contains, edges, from_grid, to_grid};
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
pub(super) fn measure(work: &Work, stock: &Region) -> Vec<Leftover> {
    let border = border(stock);
    let mut sums: BTreeMap<usize, Sum> = BTreeMap::new();
    let mut order: Vec<u32> = Vec::new();
    for (segment, &section) in work.target.contour.segments.iter().zip(&work.target.sections) {
        for (p, weight) in samples(segment, work.target.machined_from_z) {
            let index = order.iter().position(|&s| s == section).unwrap_or(order.len());
            if index == order.len() {
                order.push(section);
            }
            sums.entry(index).or_default().add(p, weight, left_at(p, stock, &border));
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

/// The surface of the stock: its edges but those on the axis.
fn border(stock: &Region) -> Vec<(Point, Point)> {
    let all = stock.rings().iter().flat_map(|ring| edges(ring));
    all.map(|(a, b)| (from_grid(a), from_grid(b))).filter(|(a, b)| a.r.max(b.r) > 0.0).collect()
}

/// Thickness of the stock on the contour at a point of it: the way to the nearest surface, mm; 0 if the point is free.
fn left_at(p: Point, stock: &Region, border: &[(Point, Point)]) -> f64 {
    if !contains(stock.rings(), to_grid(p)) {
        return 0.0;
    }
    let mut nearest = f64::INFINITY;
    for &(a, b) in border {
        let dz = (a.z.min(b.z) - p.z).max(p.z - a.z.max(b.z));
        if dz < nearest {
            nearest = nearest.min(distance_to_line(a, b, p));
        }
    }
    if nearest.is_finite() { nearest } else { 0.0 }
}
