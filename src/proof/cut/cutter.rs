//! A tool as the simulation needs it: convex pieces on the grid and the edges that cannot cut.

use super::grid::{GridPoint, Ring, Window, hull, to_grid, turn};
use super::stock::CHORD_TOLERANCE_MM;
use crate::geometry::{Contour, Point, Segment};
use crate::machine::ToolOutline;

/// A line whose ends differ by less than this in radius, mm, lies level at the nose.
const LEVEL_MM: f64 = 0.001;

/// An edge of an outline, in its direction.
pub(super) type Edge = [GridPoint; 2];

/// A tool on the grid; the programmed point is the origin.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::proof) struct Cutter {
    /// Convex pieces of the insert.
    pub insert: Vec<Ring>,
    /// The rectangle around the insert.
    pub insert_window: Window,
    /// Edges of the insert that cannot cut.
    pub back: Vec<Edge>,
    /// The rectangle around those edges.
    pub back_window: Window,
    /// Convex pieces of the holder.
    pub holder: Vec<Ring>,
    /// The rectangle around the holder.
    pub holder_window: Window,
    /// Edges of the holder.
    pub holder_edges: Vec<Edge>,
}

impl Cutter {
    /// Makes a tool from its outlines.
    pub(in crate::proof) fn new(outline: &ToolOutline) -> Self {
        let (insert, holder) = (convex_pieces(&outline.insert), convex_pieces(&outline.holder));
        let back = back_edges(outline);
        Self {
            insert_window: window_of(&insert),
            insert,
            back_window: Window::around(back.as_flattened()),
            back,
            holder_window: window_of(&holder),
            holder,
            holder_edges: outline.holder.segments.iter().flat_map(chords).collect(),
        }
    }
}

/// The edges that cannot cut: those that the tool's data says, or else all but the nose and the two straight edges next to
/// it.
fn back_edges(outline: &ToolOutline) -> Vec<Edge> {
    let segments = &outline.insert.segments;
    let told = (outline.cutting.len() == segments.len()).then(|| outline.cutting.clone());
    let back = segments.iter().zip(told.unwrap_or_else(|| around_nose(segments))).filter(|(_, cuts)| !cuts);
    back.flat_map(|(s, _)| chords(s)).collect()
}

/// Marks the nose and the two straight edges next to it. The nose is the lowest point of the outline with the arcs and level
/// lines around it.
fn around_nose(segments: &[Segment]) -> Vec<bool> {
    let count = segments.len();
    let low = |s: &Segment| s.bounds().min.r;
    let Some(lowest) = (0..count).min_by(|&a, &b| low(&segments[a]).total_cmp(&low(&segments[b]))) else {
        return Vec::new();
    };
    let rises = |i: usize| matches!(segments[i], Segment::Line { start, end } if (start.r - end.r).abs() > LEVEL_MM);
    let mut cuts = vec![false; count];
    cuts[lowest] = true;
    // From the lowest segment over the nose to the first rising line on either side.
    let falls = rises(lowest) && segments[lowest].end().r < segments[lowest].start().r;
    for (step, needed) in [(1, falls || !rises(lowest)), (count - 1, !falls)] {
        let mut at = lowest;
        let mut goes_on = needed;
        while goes_on {
            at = (at + step) % count;
            goes_on = !cuts[at] && !rises(at);
            cuts[at] = true;
        }
    }
    cuts
}

fn window_of(pieces: &[Ring]) -> Window {
    Window::around(&pieces.concat())
}

fn chords(segment: &Segment) -> Vec<Edge> {
    let points: Vec<GridPoint> = std::iter::once(segment.start()).chain(points(segment)).map(to_grid).collect();
    points.windows(2).map(|w| [w[0], w[1]]).collect()
}

/// Points along a segment without its start. A nose has a corner wherever it touches a wall, a cylinder or a face: the chords of
/// those would leave half a micrometre on them, in which whatever passes later would seem to stand.
fn points(segment: &Segment) -> Vec<Point> {
    segment.quarters().iter().flat_map(|part| part.polyline_points(CHORD_TOLERANCE_MM)).collect()
}

/// Convex rings, counter-clockwise, that cover the inside of a closed contour.
fn convex_pieces(contour: &Contour) -> Vec<Ring> {
    let first = contour.segments.first().map(Segment::start);
    let mut ring: Ring = first.into_iter().chain(contour.segments.iter().flat_map(points)).map(to_grid).collect();
    ring.dedup();
    if ring.len() > 1 && ring.first() == ring.last() {
        ring.pop();
    }
    if ring.len() < 3 {
        return Vec::new();
    }
    let whole = hull(ring.clone());
    let convex = ring.iter().all(|p| on_border(*p, &whole));
    if convex { vec![whole] } else { joined(triangles(ring)) }
}

fn on_border(p: GridPoint, ring: &[GridPoint]) -> bool {
    super::grid::edges(ring).any(|(a, b)| turn(a, b, p) == 0)
}

/// Ear clipping; what is left of an outline that crosses itself is covered by its hull, so nothing is forgotten.
fn triangles(mut ring: Ring) -> Vec<Ring> {
    let mut pieces = Vec::new();
    while ring.len() > 3 {
        let count = ring.len();
        let corner = |i: usize| [ring[(i + count - 1) % count], ring[i], ring[(i + 1) % count]];
        let is_ear = |i: &usize| {
            let [a, b, c] = corner(*i);
            let inside = |p: &GridPoint| turn(a, b, *p) >= 0 && turn(b, c, *p) >= 0 && turn(c, a, *p) >= 0;
            turn(a, b, c) > 0 && !ring.iter().any(|p| ![a, b, c].contains(p) && inside(p))
        };
        let straight = |i: &usize| {
            let [a, b, c] = corner(*i);
            turn(a, b, c) == 0
        };
        if let Some(flat) = (0..count).find(straight) {
            ring.remove(flat);
        } else if let Some(ear) = (0..count).find(is_ear) {
            pieces.push(corner(ear).to_vec());
            ring.remove(ear);
        } else {
            break;
        }
    }
    pieces.push(hull(ring));
    pieces
}

/// Joins convex pieces with a common edge as long as what comes out is convex.
fn joined(mut pieces: Vec<Ring>) -> Vec<Ring> {
    let both = |a: &Ring, b: &Ring| {
        let start = |i: usize| (a[i], a[(i + 1) % a.len()]);
        let shared = |i: &usize| super::grid::edges(b).any(|(p, q)| (q, p) == start(*i));
        (0..a.len()).find(shared)?;
        let whole = hull(a.iter().chain(b).copied().collect());
        let doubled = |ring: &Ring| ring.windows(2).map(|w| turn(ring[0], w[0], w[1])).sum::<i64>();
        (doubled(&whole) == doubled(a) + doubled(b)).then_some(whole)
    };
    loop {
        let mut pairs = (0..pieces.len()).flat_map(|j| (0..j).map(move |i| (i, j)));
        let Some((i, j, whole)) = pairs.find_map(|(i, j)| Some((i, j, both(&pieces[i], &pieces[j])?))) else {
            return pieces;
        };
        pieces.remove(j);
        pieces[i] = whole;
    }
}

#[cfg(test)]
mod tests {
    use super::super::grid::area_mm2;
    use super::*;

    fn polygon(points: &[(f64, f64)]) -> Contour {
        Contour::polygon(&points.iter().map(|&(z, r)| Point::new(z, r)).collect::<Vec<_>>())
    }

    #[test]
    fn all_but_the_edges_at_the_nose_are_back_edges() {
        // Each outline is tried with every segment as the first.
        let rhombus = polygon(&[(0.0, 0.0), (5.0, 4.0), (5.5, 10.0), (0.5, 6.0)]);
        let blade = polygon(&[(0.0, 0.0), (3.0, 0.0), (3.0, 20.0), (0.0, 20.0)]);
        let corner = |z, r| Point::new(z, r);
        let arc = Segment::Arc { start: corner(0.0, 1.0), end: corner(1.0, 0.0), center: corner(1.0, 1.0), ccw: true };
        let rest = [(1.0, 0.0), (6.0, 2.0), (5.0, 9.0), (0.0, 1.0)].map(|(z, r)| corner(z, r));
        let rounded =
            Contour::new(std::iter::once(arc).chain(rest.windows(2).map(|w| Segment::line(w[0], w[1]))).collect());
        for (mut outline, back) in [(rhombus, 2), (blade, 1), (rounded, 1)] {
            for _ in 0..outline.segments.len() {
                outline.segments.rotate_left(1);
                let tool = ToolOutline { insert: outline.clone(), ..ToolOutline::default() };
                assert_eq!(back_edges(&tool).len(), back, "{outline:?}");
            }
        }
    }

    #[test]
    fn what_the_tool_says_of_its_edges_counts() {
        let insert = polygon(&[(0.0, 0.0), (5.0, 4.0), (5.5, 10.0), (0.5, 6.0)]);
        let tool = ToolOutline { insert, cutting: vec![true, true, true, false], ..ToolOutline::default() };
        assert_eq!(back_edges(&tool).len(), 1);
    }

    #[test]
    fn a_nose_touches_walls_and_cylinders_with_a_corner() {
        // A nose of 0.4 mm between edges that lean by 3 and by 52 degrees: chords of equal length would miss both sides.
        let (center, on) =
            (Point::new(0.4, 0.4), |deg: f64| (deg.to_radians().cos() * 0.4, deg.to_radians().sin() * 0.4));
        let at = |deg: f64| Point::new(center.z + on(deg).0, center.r + on(deg).1);
        let nose = Segment::Arc { start: at(177.0), end: at(318.0), center, ccw: true };
        let insert = Contour::new(vec![
            nose,
            Segment::line(at(318.0), Point::new(4.0, 6.0)),
            Segment::line(Point::new(4.0, 6.0), at(177.0)),
        ]);
        let window = window_of(&convex_pieces(&insert));
        assert_eq!(window.min, GridPoint::new(0, 0), "{window:?}");
    }

    #[test]
    fn pieces_are_convex_and_cover_the_outline() {
        let hook = polygon(&[(0.0, 0.0), (10.0, 0.0), (10.0, 2.0), (2.0, 2.0), (2.0, 8.0), (0.0, 8.0)]);
        let pieces = convex_pieces(&hook);
        assert!((pieces.iter().map(|p| area_mm2(p)).sum::<f64>() - 32.0).abs() < 1e-9);
        assert!(pieces.iter().all(|p| hull(p.clone()).len() == p.len()));
        assert_eq!(pieces.len(), 2);
        assert!(convex_pieces(&Contour::default()).is_empty());
        let crossing = polygon(&[(0.0, 0.0), (10.0, 10.0), (10.0, 0.0), (0.0, 10.0)]);
        assert!(!convex_pieces(&crossing).is_empty());
    }
}
