//! Hatching of cut material: thin lines at 45° (ISO 128-50).

use super::page::{Page, Pen};
use crate::geometry::{Contour, Point, Segment};

/// Largest distance of a chord from its arc where a line is cut off at it, mm on paper.
const CHORD_MM: f64 = 0.02;
/// Hatch lines in one area at most; keeps a wrong spacing from filling the page.
const MOST_LINES: f64 = 4000.0;

/// Hatches the area within closed rings on paper, `spacing` mm from line to line.
pub(super) fn hatch(page: &mut Page, rings: &[Vec<Segment>], spacing: f64) {
    let edges: Vec<(Point, Point)> = rings.iter().flat_map(|ring| edges(ring)).collect();
    // A line is the points with the same z − r; along it z counts.
    let offset = |p: Point| p.z - p.r;
    let offsets = || edges.iter().map(|(a, _)| offset(*a));
    let (low, high) = (offsets().fold(f64::INFINITY, f64::min), offsets().fold(f64::NEG_INFINITY, f64::max));
    let step = spacing * std::f64::consts::SQRT_2;
    if !(step > 0.0 && (high - low) / step < MOST_LINES) {
        return;
    }
    let mut at = (low / step).floor() * step + step;
    while at < high {
        let mut crossings: Vec<f64> = edges.iter().filter_map(|(a, b)| crossing(*a, *b, at, offset)).collect();
        crossings.sort_by(f64::total_cmp);
        for pair in crossings.chunks_exact(2) {
            page.line(Point::new(pair[0], pair[0] - at), Point::new(pair[1], pair[1] - at), Pen::THIN);
        }
        at += step;
    }
}

/// Where the line of this offset crosses an edge; its first end belongs to the edge, its second to the next one.
fn crossing(a: Point, b: Point, at: f64, offset: impl Fn(Point) -> f64) -> Option<f64> {
    let (from, to) = (offset(a) - at, offset(b) - at);
    ((from < 0.0) != (to < 0.0)).then(|| a.z + (b.z - a.z) * from / (from - to))
}

/// The edges of a ring as chords.
fn edges(ring: &[Segment]) -> Vec<(Point, Point)> {
    let points = Contour::new(ring.to_vec()).polyline(CHORD_MM);
    let next = points.iter().cycle().skip(1);
    points.iter().copied().zip(next.copied()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::papers::Item;

    #[test]
    fn lines_stay_within_the_material_and_leave_holes_free() {
        let square = |from: f64, to: f64| {
            let corners = [(from, from), (to, from), (to, to), (from, to)].map(|(z, r)| Point::new(z, r));
            Contour::polygon(&corners).segments
        };
        let mut page = Page::new(100.0, 100.0, "");
        hatch(&mut page, &[square(10.0, 50.0), square(20.0, 40.0)], 2.0);
        let mut length = 0.0;
        for item in &page.items {
            let Item::Path { path, .. } = item else { panic!("a line") };
            length += path.length();
            for t in [0.01, 0.5, 0.99] {
                let p = path.segments[0].point_at(t);
                let within = |from: f64, to: f64| (from..=to).contains(&p.z) && (from..=to).contains(&p.r);
                assert!(within(10.0, 50.0) && !within(20.1, 39.9), "{p:?}");
            }
        }
        let area = 40.0 * 40.0 - 20.0 * 20.0;
        assert!((length * 2.0 / area - 1.0).abs() < 0.05, "lines 2 mm apart cover the area: {length}");
    }
}
