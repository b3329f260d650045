//! The contour pass of roughing: undercuts and hollows are left as they are, the tool crosses them on their level.

use super::area::Direction;
use super::level::first_crossing;
use crate::geometry::{Point, Segment};

/// Differences of radius up to this are no fall, mm: twice the last figure of the published profiles.
const LEVEL_MM: f64 = 0.002;

/// A rest of an element shorter than this is not travelled, mm: the last figure of a program.
const NO_REST_MM: f64 = 1e-3;

/// The way along `contour` in the direction of cutting that never falls: where an element falls, the way goes on parallel
/// to the spindle to where the contour comes back to that radius; if it never does, the way ends there.
pub(super) fn without_undercuts(contour: &[Segment], direction: Direction) -> Vec<Segment> {
    let pieces: Vec<Segment> = contour.iter().flat_map(rising_and_falling).collect();
    let mut way = Vec::with_capacity(pieces.len());
    let mut index = 0;
    while let Some(piece) = pieces.get(index) {
        if !falls(piece) {
            way.push(*piece);
            index += 1;
            continue;
        }
        let from = piece.start();
        let Some((back, rest)) = return_to(&pieces, index + 1, from, direction) else { break };
        let to = rest.map_or_else(|| pieces.get(back).map_or(from, Segment::end), |rest| rest.start());
        way.push(Segment::line(from, to));
        way.extend(rest);
        index = back + 1;
    }
    way
}

fn falls(piece: &Segment) -> bool {
    piece.end().r < piece.start().r - LEVEL_MM
}

/// The first piece from `index` on that comes back to the radius of `from`, and what is left of it from there.
fn return_to(pieces: &[Segment], index: usize, from: Point, direction: Direction) -> Option<(usize, Option<Segment>)> {
    let rising = |p: &Segment| p.end().r > p.start().r && p.end().r >= from.r - LEVEL_MM;
    let back = index + pieces.get(index..)?.iter().position(rising)?;
    let piece = pieces.get(back)?;
    let crossing = first_crossing(std::slice::from_ref(piece), from.r, from.z, direction);
    let rest = crossing.map(|z| starting_at(piece, Point::new(z, from.r)));
    Some((back, rest.filter(|rest| rest.start().distance(rest.end()) > NO_REST_MM)))
}

fn starting_at(piece: &Segment, start: Point) -> Segment {
    match *piece {
        Segment::Line { end, .. } => Segment::Line { start, end },
        Segment::Arc { end, center, ccw, .. } => Segment::Arc { start, end, center, ccw },
    }
}

/// An arc divided at its highest or lowest point, if it really rises and falls.
fn rising_and_falling(segment: &Segment) -> Vec<Segment> {
    let Segment::Arc { start, end, center, ccw } = *segment else { return vec![*segment] };
    let radius = start.distance(center);
    let turning = [center.r + radius, center.r - radius].into_iter().map(|r| Point::new(center.z, r));
    let both_sides = |p: &Point| (p.r - start.r).abs() > LEVEL_MM && (p.r - end.r).abs() > LEVEL_MM;
    let mut inside = turning.filter(|p| both_sides(p) && segment.distance_to(*p) <= LEVEL_MM);
    inside.next().map_or_else(
        || vec![*segment],
        |top| vec![Segment::Arc { start, end: top, center, ccw }, Segment::Arc { start: top, end, center, ccw }],
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    fn path(points: &[(f64, f64)]) -> Vec<Segment> {
        let points: Vec<Point> = points.iter().map(|&(z, r)| Point::new(z, r)).collect();
        points.windows(2).map(|w| Segment::line(w[0], w[1])).collect()
    }

    fn ends(way: &[Segment]) -> Vec<(f64, f64)> {
        way.iter().map(|s| (s.end().z, s.end().r)).collect()
    }

    #[test]
    fn a_hollow_is_crossed_on_its_level() {
        let way = without_undercuts(
            &path(&[(0.0, 5.0), (2.0, 5.0), (3.0, 4.0), (5.0, 4.0), (7.0, 6.0), (9.0, 6.0)]),
            Direction::TowardsFreeEnd,
        );
        assert_eq!(ends(&way), [(2.0, 5.0), (6.0, 5.0), (7.0, 6.0), (9.0, 6.0)]);
    }

    #[test]
    fn the_way_ends_before_a_fall_for_good() {
        let way =
            without_undercuts(&path(&[(0.0, 5.0), (2.0, 5.0), (3.0, 4.0), (9.0, 4.5)]), Direction::TowardsFreeEnd);
        assert_eq!(ends(&way), [(2.0, 5.0)]);
    }

    #[test]
    fn an_arc_is_left_at_its_top_and_a_return_to_the_same_level_has_no_rest() {
        let p = Point::new;
        let mut contour = vec![Segment::Arc { start: p(0.0, 5.0), end: p(4.0, 5.0), center: p(2.0, 5.0), ccw: false }];
        contour.extend(path(&[(4.0, 5.0), (5.0, 5.0), (6.0, 7.0), (8.0, 7.0)]));
        let way = without_undercuts(&contour, Direction::TowardsFreeEnd);
        assert_eq!(ends(&way), [(2.0, 7.0), (6.0, 7.0), (8.0, 7.0)]);
    }
}
