//! Hollows of a former that are narrower than the roller's nose and the wall: the roller rests on both their sides, and the
//! shell spans what lies between.

use super::chain::with_ends;
use super::offset::{Cut, Distance, Offset, along, half_angle, outward};
use crate::document::Forming;
use crate::geometry::{Contour, Point, Segment, Vector, biarc};
use std::ops::RangeInclusive;

/// Sides that differ by less than this make no hollow, radians.
const STRAIGHT_RAD: f64 = 1e-6;

/// A hollow that the roller does not reach into.
#[derive(Debug, Clone, PartialEq)]
pub struct Hollow {
    /// The former's segments from the one that the shell leaves to the one that it comes back to.
    pub segments: RangeInclusive<usize>,
    /// The place of the former that is furthest from the shell.
    pub at: Point,
    /// Its distance from the shell's inside, mm.
    pub stands_off: f64,
    /// Smallest radius of the former there, mm; 0 for a sharp corner.
    pub former_radius: f64,
    /// Inside radius of the shell there, mm: that of the nose, in spinning with the wall.
    pub shell_radius: f64,
}

/// The inside of the shell that a roller makes over `former`, and the hollows that it spans. `centres` is the path of the
/// nose's centre, at `distance` from the former.
pub(super) fn formed(former: &Contour, centres: &Offset, distance: Distance) -> (Contour, Vec<Hollow>) {
    let mut inside = former.segments.clone();
    let mut hollows = Vec::new();
    // From the base, so that places before a hollow keep their number.
    for cut in centres.cuts.iter().rev() {
        let Some(span) = Span::new(former, cut, distance) else { continue };
        let next: Vec<Segment> = inside.split_off((cut.behind + 1).min(inside.len()));
        inside.truncate(cut.before + 1);
        if let Some(last) = inside.last_mut() {
            *last = with_ends(last, last.start(), span.leaves);
        }
        inside.extend(span.segments());
        inside.extend(former.segments.get(cut.behind).map(|s| with_ends(s, span.returns, s.end())));
        inside.extend(next);
        hollows.push(span.hollow(former, cut, distance));
    }
    hollows.reverse();
    inside.retain(|s| s.length() > 0.0);
    (Contour::new(inside), hollows)
}

/// What the shell spans with the roller's nose centre at one place.
struct Span {
    /// Where the shell leaves the former, and the angle of the wall there.
    leaves: Point,
    from: f64,
    /// Where it comes back, and the angle of the wall there.
    returns: Point,
    to: f64,
}

impl Span {
    /// `None` where there is no hollow.
    ///
    /// The nose leaves its own arc on the outside. In flow-turning the inside is the same arc, shifted along the axis by the
    /// blank's thickness, for every element keeps its radius and its thickness along the axis; in spinning it lies the wall
    /// further in. Both touch the former's sides.
    fn new(former: &Contour, cut: &Cut, distance: Distance) -> Option<Self> {
        let touches = |index: usize| {
            let side = former.segments.get(index)?;
            let outward = outward(angle_from(side.nearest_point(cut.at), cut.at)?);
            let inside = match distance.forming {
                Forming::Shear => cut.at - outward * distance.more - Vector::new(distance.thickness, 0.0),
                Forming::Spinning => cut.at - outward * (distance.more + distance.thickness),
            };
            let at = side.nearest_point(inside);
            Some((at, half_angle(side.direction_at(share_of(side, at)))))
        };
        let ((leaves, from), (returns, to)) = (touches(cut.before)?, touches(cut.behind)?);
        (to - from > STRAIGHT_RAD && distance.more > 0.0).then_some(Self { leaves, from, returns, to })
    }

    /// The inside of the shell.
    fn segments(&self) -> [Segment; 2] {
        biarc(self.leaves, along(self.from), self.returns, along(self.to))
    }

    fn hollow(&self, former: &Contour, cut: &Cut, distance: Distance) -> Hollow {
        /// Places along a spanned arc at which its distance is measured.
        const PLACES: u32 = 16;
        let spanned = former.segments.get(cut.before..=cut.behind).unwrap_or_default();
        let corners = spanned.windows(2).filter_map(|pair| pair.first()).map(Segment::end);
        let arcs = spanned.iter().filter(|s| s.sweep() < 0.0);
        let between = |p: &Point| (self.returns.z..=self.leaves.z).contains(&p.z);
        let on_arcs = arcs.clone().flat_map(|s| (0..=PLACES).map(|k| s.point_at(f64::from(k) / f64::from(PLACES))));
        let inside = self.segments();
        let off = |p: Point| (p, inside.iter().map(|s| s.distance_to(p)).fold(f64::INFINITY, f64::min));
        let furthest = corners.chain(on_arcs.filter(between)).map(off).max_by(|a, b| a.1.total_cmp(&b.1));
        let (at, stands_off) = furthest.unwrap_or((self.leaves, 0.0));
        let sharp = spanned.windows(2).any(|pair| match pair {
            [a, b] => half_angle(b.direction_at(0.0)) - half_angle(a.direction_at(1.0)) > STRAIGHT_RAD,
            _ => false,
        });
        let narrowest = arcs.filter_map(Segment::radius).fold(f64::INFINITY, f64::min);
        let wall = if distance.forming == Forming::Spinning { distance.thickness } else { 0.0 };
        Hollow {
            segments: cut.before..=cut.behind,
            at,
            stands_off,
            former_radius: if sharp { 0.0 } else { narrowest },
            shell_radius: distance.more + wall,
        }
    }
}

/// How far along a segment a point of it lies, as a share of its length.
fn share_of(segment: &Segment, p: Point) -> f64 {
    let whole = segment.length();
    let part = match *segment {
        Segment::Line { start, .. } => start.distance(p),
        Segment::Arc { start, center, ccw, .. } => Segment::Arc { start, end: p, center, ccw }.length(),
    };
    if start_is(segment, p) || whole <= 0.0 { 0.0 } else { (part / whole).clamp(0.0, 1.0) }
}

/// An arc from a point to itself would be a whole circle.
fn start_is(segment: &Segment, p: Point) -> bool {
    segment.start().distance(p) < 1e-9
}

/// Angle to the axis of a wall whose outside is towards `centre`; `None` where they are the same place.
fn angle_from(p: Point, centre: Point) -> Option<f64> {
    let away = (centre - p).try_normalize(1e-9)?;
    Some(away.x.atan2(away.y))
}

#[cfg(test)]
mod tests {
    use super::super::offset::offset;
    use super::*;

    const TOLERANCE: f64 = 0.0005;

    fn p(z: f64, r: f64) -> Point {
        Point::new(z, r)
    }

    fn lines(corners: &[Point]) -> Contour {
        Contour::new(corners.windows(2).map(|w| Segment::line(w[0], w[1])).collect())
    }

    fn over(former: &Contour, distance: Distance) -> (Contour, Vec<Hollow>, Offset) {
        let centres = offset(former, distance, TOLERANCE);
        let (inside, hollows) = formed(former, &centres, distance);
        (inside, hollows, centres)
    }

    fn spinning(nose: f64) -> Distance {
        Distance { forming: Forming::Spinning, thickness: 2.0, more: nose }
    }

    fn shear(nose: f64) -> Distance {
        Distance { forming: Forming::Shear, ..spinning(nose) }
    }

    #[test]
    fn a_square_corner_is_spanned_by_nose_and_wall() {
        // A quarter of a turn from 45° below to 45° above the axis' direction, seen as 20° and 70° walls: turn 50°.
        let (flat, steep) = (20.0_f64.to_radians(), 70.0_f64.to_radians());
        let corner = p(50.0, 40.0);
        let former = lines(&[corner - along(flat) * 40.0, corner, corner + along(steep) * 40.0]);
        let (inside, hollows, _) = over(&former, spinning(6.0));
        assert_eq!(inside.segments.len(), 4);
        assert!(inside.segments[1..3].iter().all(|s| (s.radius().unwrap() - 8.0).abs() < 1e-6), "{inside:?}");
        let [hollow] = hollows.as_slice() else { panic!("{hollows:?}") };
        assert_eq!((hollow.at, hollow.former_radius, hollow.segments.clone()), (corner, 0.0, 0..=1));
        // A fillet of radius ρ in a corner that turns by φ stands off it by ρ (1/cos(φ/2) − 1).
        let want = 8.0 * (1.0 / 25.0_f64.to_radians().cos() - 1.0);
        assert!((hollow.stands_off - want).abs() < 1e-6, "{} {want}", hollow.stands_off);
    }

    #[test]
    fn in_shear_every_element_keeps_its_thickness_along_the_axis() {
        let former = lines(&[p(60.0, 20.0), p(30.0, 32.0), p(18.0, 60.0)]);
        let (inside, hollows, centres) = over(&former, shear(6.0));
        assert!(hollows.len() == 1 && inside.largest_gap() < 1e-6, "{hollows:?} {}", inside.largest_gap());
        // Tangent to both sides, with the nose's own radius about its centre, shifted by the blank's thickness.
        let centre = centres.cuts[0].at - Vector::new(2.0, 0.0);
        for segment in &inside.segments[1..3] {
            for k in 0..=10 {
                let at = segment.point_at(f64::from(k) / 10.0);
                assert!((at.distance(centre) - 6.0).abs() < 1e-6, "{at:?}");
            }
        }
        for pair in inside.segments.windows(2) {
            let turn = half_angle(pair[1].direction_at(0.0)) - half_angle(pair[0].direction_at(1.0));
            assert!(turn.abs() < 1e-6, "{turn}");
        }
    }

    #[test]
    fn a_hollow_wider_than_the_roller_is_formed_whole() {
        let hollow = Segment::Arc { start: p(50.0, 20.0), end: p(20.0, 50.0), center: p(50.0, 50.0), ccw: false };
        let (inside, hollows, _) = over(&Contour::new(vec![hollow]), shear(9.0));
        assert_eq!((inside.segments.as_slice(), hollows.len()), ([hollow].as_slice(), 0));
    }

    #[test]
    fn a_groove_of_several_walls_is_spanned_at_once() {
        // A floor 3 mm long between two walls, far narrower than the nose; and a narrow arc between two lines.
        let walls = lines(&[p(60.0, 20.0), p(40.0, 24.0), p(37.5, 25.5), p(30.0, 50.0)]);
        let round = Contour::new(vec![
            Segment::line(p(60.0, 30.0), p(42.0, 30.0)),
            Segment::Arc { start: p(42.0, 30.0), end: p(40.0, 32.0), center: p(42.0, 32.0), ccw: false },
            Segment::line(p(40.0, 32.0), p(40.0, 60.0)),
        ]);
        for (former, radius) in [(walls, 0.0), (round, 2.0)] {
            let (inside, hollows, centres) = over(&former, spinning(9.0));
            let [hollow] = hollows.as_slice() else { panic!("{hollows:?} {centres:?}") };
            assert!((hollow.former_radius - radius).abs() < 1e-9 && hollow.stands_off > 0.5, "{hollow:?}");
            assert!(inside.largest_gap() < 1e-6);
            for segment in &centres.contour.segments {
                for k in 0..=20 {
                    let distance = former.distance_to(segment.point_at(f64::from(k) / 20.0));
                    assert!(distance > 11.0 - 1e-6, "{distance}");
                }
            }
        }
    }
}
