//! Which of several overlapping surfaces is that of the part, the one that takes most off it: outside at every position
//! the one with the smallest radius, in a bore the one with the largest.

use super::crossing::crossings;
use super::shape::SAME_PLACE_MM;
use super::{Curve, PieceRole};
use crate::diagnostic::SectionTable;

/// The surface of one row.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Surface {
    /// Its curve, z growing.
    pub curve: Curve,
    /// Its row.
    pub section: u32,
    /// What it is.
    pub role: PieceRole,
}

impl Surface {
    fn z1(&self) -> f64 {
        self.curve.start().z
    }

    fn z2(&self) -> f64 {
        self.curve.end().z
    }
}

/// A range of positions with the surface of the part there; `None` where no row says anything.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Run<'a> {
    /// From this position, mm.
    pub z1: f64,
    /// To this position, mm.
    pub z2: f64,
    /// The surface that takes most off the part.
    pub surface: Option<&'a Surface>,
}

/// Divides `from..to` into runs, each with the surface of the part. `surfaces` are in order of their first position.
pub(super) fn runs(table: SectionTable, surfaces: &[Surface], from: f64, to: f64) -> Vec<Run<'_>> {
    let mut runs: Vec<Run<'_>> = Vec::new();
    let mut waiting = surfaces.iter().peekable();
    let mut active: Vec<&Surface> = Vec::new();
    let breaks = breaks(surfaces, from, to);
    for (&z1, &z2) in breaks.iter().zip(breaks.iter().skip(1)) {
        let middle = f64::midpoint(z1, z2);
        while let Some(surface) = waiting.next_if(|s| s.z1() < middle) {
            active.push(surface);
        }
        active.retain(|s| s.z2() > middle);
        let surface = active.iter().copied().reduce(|a, b| cut_at(table, a, b, middle));
        match runs.last_mut() {
            Some(last) if last.surface == surface => last.z2 = z2,
            _ => runs.push(Run { z1, z2, surface }),
        }
    }
    runs
}

/// The one of two surfaces that takes more off at `z`; the first one where they coincide.
fn cut_at<'a>(table: SectionTable, a: &'a Surface, b: &'a Surface, z: f64) -> &'a Surface {
    let higher = b.curve.radius_at(z) - a.curve.radius_at(z);
    let more = match table {
        SectionTable::Outside => -higher,
        SectionTable::Bore => higher,
    };
    if more > SAME_PLACE_MM { b } else { a }
}

/// Positions where that surface can change, `from` and `to` included, none closer than [`SAME_PLACE_MM`].
fn breaks(surfaces: &[Surface], from: f64, to: f64) -> Vec<f64> {
    let mut all: Vec<f64> = surfaces.iter().flat_map(|s| [s.z1(), s.z2()]).collect();
    for (index, a) in surfaces.iter().enumerate() {
        let overlapping = surfaces.iter().skip(index + 1).take_while(|b| b.z1() < a.z2() - SAME_PLACE_MM);
        all.extend(overlapping.flat_map(|b| crossings(&a.curve, &b.curve)));
    }
    all.retain(|&z| z > from + SAME_PLACE_MM && z < to - SAME_PLACE_MM);
    all.push(from);
    all.push(to);
    all.sort_by(f64::total_cmp);
    all.dedup_by(|next, kept| *next - *kept <= SAME_PLACE_MM);
    all
}
