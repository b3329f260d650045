//! Rolls of a station do not stand in one another; they may touch.

use super::Checked;
use crate::diagnostic::{Diagnostic, Place};
use crate::geometry::{Bounds, Contour, Point, Segment};
use crate::rollform::Roll;

/// Contours that lie in one another by less touch, mm.
const TOUCHING_MM: f64 = 0.001;

/// Distance of the points that are looked at from their arcs, mm.
const CHORD_MM: f64 = 0.01;

/// Pairs of rolls that overlap.
pub(super) fn check(checked: &Checked<'_>) -> Vec<Diagnostic> {
    let outlines: Vec<(&Roll, Area)> =
        checked.design.rolls.iter().filter_map(|roll| Some((roll, Area::of(roll.outline())?))).collect();
    let mut found = Vec::new();
    for (index, (a, first)) in outlines.iter().enumerate() {
        for (b, second) in outlines.iter().skip(index + 1) {
            if let Some(at) = common(first, second).or_else(|| common(second, first)) {
                found.push(said(a, b, at));
            }
        }
    }
    found
}

/// A point of the first outline within the second one.
fn common(first: &Area, second: &Area) -> Option<Point> {
    if !first.bounds.touches(second.bounds) {
        return None;
    }
    let corners = first.contour.polyline(CHORD_MM);
    let middles = corners.iter().zip(corners.iter().skip(1)).map(|(p, q)| *p + (*q - *p) * 0.5);
    let mut candidates =
        corners.iter().copied().chain(middles).filter(|p| second.bounds.touches(Bounds { min: *p, max: *p }));
    candidates.find(|p| second.holds(*p))
}

/// What a closed outline goes around. Its segments, arcs in quarters, lie in drawers by their place along z, so that a point is
/// compared with those above and below it alone: outlines may have thousands.
struct Area {
    contour: Contour,
    bounds: Bounds,
    drawers: Vec<Vec<Segment>>,
}

impl Area {
    /// `None` without segments or with an extent that is no number.
    fn of(contour: Contour) -> Option<Self> {
        let bounds = contour.bounds().filter(|b| b.min.is_finite() && b.max.is_finite())?;
        let drawers = vec![Vec::new(); contour.segments.len().max(1)];
        let mut area = Self { contour, bounds, drawers };
        for part in area.contour.segments.iter().flat_map(Segment::quarters).collect::<Vec<_>>() {
            let b = part.bounds();
            let (from, to) = (area.drawer(b.min.z - TOUCHING_MM), area.drawer(b.max.z + TOUCHING_MM));
            area.drawers.iter_mut().take(to + 1).skip(from).for_each(|drawer| drawer.push(part));
        }
        Some(area)
    }

    /// The drawer of a place along z.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped to the drawers")]
    fn drawer(&self, z: f64) -> usize {
        let last = self.drawers.len().saturating_sub(1);
        let part = (z - self.bounds.min.z) / (self.bounds.max.z - self.bounds.min.z);
        if part.is_finite() { (part * self.drawers.len() as f64).clamp(0.0, last as f64) as usize } else { 0 }
    }

    /// True if a point lies inside by more than a touch: an odd number of segments lies above it, and none is near.
    fn holds(&self, p: Point) -> bool {
        let Some(drawer) = self.drawers.get(self.drawer(p.z)) else { return false };
        let above = drawer.iter().filter(|s| height_at(s, p.z).is_some_and(|r| r > p.r)).count();
        above % 2 == 1 && drawer.iter().all(|s| s.distance_to(p) > TOUCHING_MM)
    }
}

/// Height of a segment above a place along z, its right end excluded; an arc is at most a quarter. `None` beside it.
fn height_at(segment: &Segment, z: f64) -> Option<f64> {
    let (a, b) = (segment.start(), segment.end());
    if !(a.z.min(b.z) <= z && z < a.z.max(b.z)) {
        return None;
    }
    Some(match *segment {
        Segment::Line { .. } => a.r + (b.r - a.r) * (z - a.z) / (b.z - a.z),
        Segment::Arc { center, .. } => {
            let radius = a.distance(center);
            let up = (radius * radius - (z - center.z).powi(2)).max(0.0).sqrt();
            if f64::midpoint(a.r, b.r) >= center.r { center.r + up } else { center.r - up }
        }
    })
}

fn said(a: &Roll, b: &Roll, at: Point) -> Diagnostic {
    let name = |roll: &Roll| roll.name.clone();
    let message = format!(
        "The rolls {} and {} stand in one another at {:.3} mm across and {:.3} mm height of the strip; there must be none or more \
         between them.",
        name(a),
        name(b),
        at.z,
        at.r
    );
    Diagnostic::error("roll-overlap", Place::Roll { name: name(a) }, message)
        .with_related(Place::Roll { name: name(b) })
        .with_hint("Change the extension contours, or the distance of the axes.")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Location;
    use crate::rollform::design;
    use crate::rollform::fixtures::published_rolls;

    #[test]
    fn a_point_is_inside_as_the_whole_contour_says() {
        let design = design("x", &published_rolls());
        let mut compared = 0;
        for roll in design.rolls() {
            let area = Area::of(roll.outline()).unwrap();
            let (min, size) = (area.bounds.min, area.bounds.max - area.bounds.min);
            for k in 0..2000_u32 {
                // A sequence that fills the square evenly, and a little beyond.
                let part = |step: f64| (f64::from(k) * step).fract() * 1.1 - 0.05;
                let p = Point::new(min.z + size.x * part(0.618_034), min.r + size.y * part(0.754_878));
                assert_eq!(
                    area.holds(p),
                    area.contour.locate(p, TOUCHING_MM) == Location::Inside,
                    "{} {p:?}",
                    roll.name
                );
                compared += 1;
            }
        }
        assert_eq!(compared, 16_000);
    }
}
