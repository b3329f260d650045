//! How high a form reaches over narrow stretches of z: most of what is cut lies above it, and need not be looked at.

use crate::geometry::{Point, Segment};

/// A stretch is about this wide, mm: narrow enough that roughing a taper stays above it.
const WIDTH_MM: f64 = 0.1;
/// Stretches at most; those of a longer form are wider.
const MOST: usize = 20_000;

/// The largest radius of a form over every stretch.
#[derive(Debug, Clone)]
pub(super) struct Tops {
    first: f64,
    width: f64,
    radii: Vec<f64>,
}

impl Tops {
    /// The tops of lines and of arcs along which z runs one way only.
    pub(super) fn of(segments: &[Segment]) -> Self {
        let ends = segments.iter().flat_map(|s| [s.start().z, s.end().z]);
        let (first, last) = ends.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), z| (a.min(z), b.max(z)));
        let width = WIDTH_MM.max((last - first) / MOST as f64);
        let mut tops = Self { first, width, radii: Vec::new() };
        if !segments.is_empty() {
            tops.radii.resize(tops.index(last) + 1, f64::NEG_INFINITY);
        }
        for segment in segments {
            tops.add(segment);
        }
        tops
    }

    fn add(&mut self, segment: &Segment) {
        let (a, b) = (segment.start().z, segment.end().z);
        let (from, to) = (a.min(b), a.max(b));
        for k in self.index(from)..=self.index(to) {
            let begin = self.first + self.width * k as f64;
            let top = top(segment, begin.clamp(from, to), (begin + self.width).clamp(from, to));
            if let Some(known) = self.radii.get_mut(k) {
                *known = known.max(top);
            }
        }
    }

    /// The stretch of a position; positions before the first belong to the first.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped to 0..=2·MOST")]
    fn index(&self, z: f64) -> usize {
        ((z - self.first) / self.width).clamp(0.0, 2.0 * MOST as f64) as usize
    }

    /// True if the form may reach above a radius somewhere between two positions.
    pub(super) fn rise_above(&self, from: f64, to: f64, r: f64) -> bool {
        let end = (self.index(to) + 1).min(self.radii.len());
        self.radii.get(self.index(from)..end).unwrap_or(&[]).iter().any(|&top| top > r)
    }
}

/// Largest radius of a segment between two of its positions.
fn top(segment: &Segment, from: f64, to: f64) -> f64 {
    let (start, end) = (segment.start(), segment.end());
    if start.z == end.z || start.r == end.r && matches!(segment, Segment::Line { .. }) {
        return start.r.max(end.r);
    }
    let ends = radius_at(segment, from).max(radius_at(segment, to));
    match *segment {
        Segment::Arc { center, ccw, .. } if is_upper(start, end, ccw) && from < center.z && center.z < to => {
            center.r + start.distance(center)
        }
        _ => ends,
    }
}

/// True if an arc that runs one way along z lies above its centre: a counter-clockwise one runs to smaller z there.
fn is_upper(start: Point, end: Point, ccw: bool) -> bool {
    ccw == (end.z < start.z)
}

/// Radius of a one-way segment at a position between its ends.
pub(super) fn radius_at(segment: &Segment, z: f64) -> f64 {
    match *segment {
        Segment::Line { start, end } => start.r + (end.r - start.r) * (z - start.z) / (end.z - start.z),
        Segment::Arc { start, end, center, ccw } => {
            let radius = start.distance(center);
            let height = (radius * radius - (z - center.z).powi(2)).max(0.0).sqrt();
            if is_upper(start, end, ccw) { center.r + height } else { center.r - height }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// A wall, a cylinder, a taper, a crown and a hollow.
    fn form() -> Vec<Segment> {
        let p = Point::new;
        let crown = Segment::Arc { start: p(6.0, 4.0), end: p(12.0, 4.0), center: p(9.0, 4.0), ccw: false };
        let hollow = Segment::Arc { start: p(12.0, 4.0), end: p(16.0, 4.0), center: p(14.0, 4.0), ccw: true };
        let lines = [p(0.0, 1.0), p(0.0, 5.0), p(2.0, 5.0), p(6.0, 4.0)];
        lines.windows(2).map(|w| Segment::line(w[0], w[1])).chain([crown, hollow]).collect()
    }

    proptest! {
        #[test]
        fn nothing_of_the_form_is_above_its_tops(z in 0.0..16.0_f64, wide in 0.0..3.0_f64, r in 1.0..8.0_f64) {
            let (tops, form) = (Tops::of(&form()), form());
            let within = |s: &&Segment| s.start().z <= z && z <= s.end().z && s.start().z < s.end().z;
            let radius = form.iter().filter(within).map(|s| radius_at(s, z)).fold(f64::NEG_INFINITY, f64::max);
            prop_assert!(r >= radius || tops.rise_above(z - wide, z + wide, r));
        }
    }

    #[test]
    fn what_is_cut_above_or_on_the_form_is_not_below_its_top() {
        let tops = Tops::of(&form());
        assert!(!tops.rise_above(0.5, 1.5, 5.0) && tops.rise_above(0.5, 1.5, 4.999_999), "on the cylinder");
        // The taper falls by 0.025 mm in a stretch.
        assert!(!tops.rise_above(4.0, 4.0, 4.526) && tops.rise_above(4.0, 4.0, 4.499));
        assert!(!tops.rise_above(8.0, 10.0, 7.0) && tops.rise_above(8.0, 10.0, 6.999), "the crown");
        assert!(tops.rise_above(-3.0, 0.05, 4.9), "the wall");
        assert!(!tops.rise_above(17.0, 20.0, 0.0) && !Tops::of(&[]).rise_above(0.0, 1.0, 0.0), "beyond the form");
    }
}
