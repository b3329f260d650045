//! The offset contour: the way of the nose's centre at an even distance from the elements of an area.
//!
//! Elements are shifted to the tool's side. At a hollow corner the shifted elements are cut off where they meet; around a
//! bulging corner the nose rolls on an arc about it (Wong 1983, 8.5.5). The published programs do not roll around every
//! small corner but prolong one element to the other; when they do so is known only from their joints, see [`Joint::of`].

use super::area::{Direction, turn_deg};
use super::fault::Fault;
use crate::geometry::{Point, Segment, Vector};

/// An arc and its neighbour that turn by less than this join smoothly, degrees. Ends rounded to 0.001 mm turn a line of
/// half a mm by up to 0.2°; the smallest published corner that is one has 3.3°.
const TANGENT_DEG: f64 = 0.5;

/// Two lines that turn by less than this are prolonged to their meeting on either side, degrees. Published joints of up to
/// 0.06° are prolonged and those from 45° on rolled around.
const NEARLY_PARALLEL_DEG: f64 = 0.5;

/// A bulging corner of an arc and its neighbour may be prolonged up to this turn, degrees. Published joints of 12.5° are
/// prolonged, those from 45° on are rolled around.
const PROLONGED_BELOW_DEG: f64 = 30.0;

/// Offsets below this are none, mm.
const NO_OFFSET_MM: f64 = 1e-9;

/// The centre of an arc must stay at least this far from its offset arc, mm.
const LEAST_RADIUS_MM: f64 = 1e-6;

/// What an element may run backwards after its ends were cut off, mm: rounding.
const BACKWARDS_MM: f64 = 1e-3;

/// The elements of an area, shifted by `amount` mm to the tool's side and joined.
pub(super) fn offset(elements: &[Segment], amount: f64, direction: Direction) -> Result<Vec<Segment>, Fault> {
    if amount <= NO_OFFSET_MM {
        return Ok(elements.to_vec());
    }
    let shift = Shift { amount, sign: direction.sign() };
    let shifted: Vec<Segment> = elements.iter().map(|e| shift.of(e)).collect::<Result<_, _>>()?;
    let corners = elements.windows(2).zip(shifted.windows(2));
    let joints: Vec<Joint> = corners
        .map(|(contour, shifted)| Joint::of([&contour[0], &contour[1]], [&shifted[0], &shifted[1]], shift))
        .collect::<Result<_, _>>()?;
    assembled(&shifted, &joints, shift)
}

/// How far and to which side.
#[derive(Debug, Clone, Copy)]
struct Shift {
    amount: f64,
    /// +1: the tool is on the left of the way.
    sign: f64,
}

impl Shift {
    fn of(self, element: &Segment) -> Result<Segment, Fault> {
        let moved = |p: Point, along: Vector| p + Vector::new(-along.y, along.x) * (self.sign * self.amount);
        let (start, end) =
            (moved(element.start(), element.direction_at(0.0)), moved(element.end(), element.direction_at(1.0)));
        let Segment::Arc { center, ccw, .. } = *element else { return Ok(Segment::line(start, end)) };
        let radius = element.radius().unwrap_or_default();
        if is_hollow(element, self) && radius - self.amount < LEAST_RADIUS_MM {
            return Err(no_room(element, self.amount, &format!("the hollow arc of radius {radius:.3} mm")));
        }
        Ok(Segment::Arc { start, end, center, ccw })
    }
}

/// True for an arc with its centre on the tool's side.
fn is_hollow(element: &Segment, shift: Shift) -> bool {
    matches!(element, Segment::Arc { ccw, .. } if *ccw == (shift.sign > 0.0))
}

fn no_room(element: &Segment, amount: f64, what: &str) -> Fault {
    let (start, end) = (element.start(), element.end());
    let message = format!(
        "Nose radius and stock left, together {amount:.3} mm, have no room in {what} between z {:.3} mm and z {:.3} mm.",
        start.z, end.z
    );
    Fault::new(
        "no-room-for-nose",
        message,
        "Use a tool with a smaller nose, leave less stock, or leave these elements out.",
    )
}

/// How two shifted elements are joined.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Joint {
    /// They end and begin here.
    At(Point),
    /// The nose rolls around this corner of the contour.
    Around(Point),
}

impl Joint {
    /// The joint between two elements and their shifted images.
    ///
    /// Bulging corners of less than [`PROLONGED_BELOW_DEG`] are prolonged where an arc comes first, or where a line runs
    /// into a hollow arc whose offset is smaller than the offset's amount; other bulging corners are rolled around. The
    /// published joints show both (12.5° from an arc with 0.4 and 0.9 mm offset; 3.3° from a line into an arc of radius
    /// 1.366 mm: prolonged with 0.9 mm, rolled around with 0.4 mm), not why.
    fn of(contour: [&Segment; 2], shifted: [&Segment; 2], shift: Shift) -> Result<Self, Fault> {
        let ([before, after], [a, b]) = (contour, shifted);
        // Positive where the contour turns towards the tool: a hollow corner.
        let turn = turn_deg(before, after) * shift.sign;
        let middle = Point::new(f64::midpoint(a.end().z, b.start().z), f64::midpoint(a.end().r, b.start().r));
        let lines = is_line(before) && is_line(after);
        if !lines && turn.abs() < TANGENT_DEG {
            return Ok(Self::At(middle));
        }
        if turn >= 0.0 || (lines && -turn < NEARLY_PARALLEL_DEG) {
            let at = a.prolonged_meeting(b, middle).map(Self::At);
            return at.ok_or_else(|| no_room(after, shift.amount, "the hollow corner"));
        }
        let into_small_arc = is_hollow(after, shift) && b.radius().is_some_and(|r| r < shift.amount);
        let prolonged = -turn < PROLONGED_BELOW_DEG && !lines && (!is_line(before) || into_small_arc);
        let at = if prolonged { a.prolonged_meeting(b, middle) } else { None };
        Ok(at.map_or(Self::Around(before.end()), Self::At))
    }
}

const fn is_line(element: &Segment) -> bool {
    matches!(element, Segment::Line { .. })
}

/// The shifted elements cut off or prolonged to their joints, with the arcs around corners between them.
fn assembled(shifted: &[Segment], joints: &[Joint], shift: Shift) -> Result<Vec<Segment>, Fault> {
    let mut chain = Chain::default();
    for (index, element) in shifted.iter().enumerate() {
        let next = shifted.get(index + 1);
        match (joints.get(index), next) {
            (Some(Joint::At(p)), _) => chain.add(*element, *p),
            (Some(Joint::Around(center)), Some(next)) => {
                let (start, end) = (element.end(), next.start());
                chain.add(*element, start);
                chain.add(Segment::Arc { start, end, center: *center, ccw: shift.sign < 0.0 }, end);
            }
            _ => chain.add(*element, element.end()),
        }
    }
    chain.without_the_consumed(shift.amount)
}

/// Elements one after another, each with the point where it ends.
#[derive(Debug, Default)]
struct Chain {
    /// As shifted, not cut off.
    elements: Vec<Segment>,
    ends: Vec<Point>,
}

impl Chain {
    fn add(&mut self, element: Segment, end: Point) {
        self.elements.push(element);
        self.ends.push(end);
    }

    /// The elements cut off to their ends. One that would run backwards has no room between its neighbours: the nose
    /// touches both before it reaches it. It is left out, and its neighbours meet.
    fn without_the_consumed(self, amount: f64) -> Result<Vec<Segment>, Fault> {
        let mut kept: Vec<(Segment, Point)> = Vec::with_capacity(self.elements.len());
        for (element, end) in self.elements.into_iter().zip(self.ends) {
            // Where the newest element starts; moved when the one before it is left out.
            while let Some(&(last, last_end)) = kept.last() {
                let start = kept.len().checked_sub(2).and_then(|i| kept.get(i)).map_or(last.start(), |(_, end)| *end);
                if !runs_backwards(&last, &with_ends(&last, start, last_end)) {
                    break;
                }
                kept.pop();
                let near = Point::new(f64::midpoint(start.z, last_end.z), f64::midpoint(start.r, last_end.r));
                let (before, before_end) = kept.last_mut().ok_or_else(|| no_room(&last, amount, "the hollow"))?;
                *before_end =
                    before.prolonged_meeting(&element, near).ok_or_else(|| no_room(&last, amount, "the hollow"))?;
            }
            kept.push((element, end));
        }
        let mut start = kept.first().map(|(first, _)| first.start()).unwrap_or_default();
        let mut way = Vec::with_capacity(kept.len());
        for (element, end) in kept {
            let cut = with_ends(&element, start, end);
            if runs_backwards(&element, &cut) {
                return Err(no_room(&element, amount, "the hollow"));
            }
            if cut.start() != cut.end() {
                way.push(cut);
            }
            start = end;
        }
        Ok(way)
    }
}

fn with_ends(element: &Segment, start: Point, end: Point) -> Segment {
    match *element {
        Segment::Line { .. } => Segment::Line { start, end },
        Segment::Arc { center, ccw, .. } => Segment::Arc { start, end, center, ccw },
    }
}

/// True if cutting off its ends has turned an element round, so that its neighbours would have to meet instead of it.
fn runs_backwards(element: &Segment, cut: &Segment) -> bool {
    match cut {
        Segment::Line { start, end } => (*end - *start).dot(&element.direction_at(0.0)) < -BACKWARDS_MM,
        // An arc that was turned round goes nearly all the way about its centre.
        Segment::Arc { .. } => {
            let radius = cut.radius().unwrap_or_default();
            cut.sweep().abs() > std::f64::consts::PI.max(element.sweep().abs() + 1.0)
                && (std::f64::consts::TAU - cut.sweep().abs()) * radius > BACKWARDS_MM
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use Direction::{TowardsClampedEnd, TowardsFreeEnd};

    fn path(points: &[(f64, f64)]) -> Vec<Segment> {
        let points: Vec<Point> = points.iter().map(|&(z, r)| Point::new(z, r)).collect();
        points.windows(2).map(|w| Segment::line(w[0], w[1])).collect()
    }

    #[test]
    fn the_nose_rolls_around_an_edge_and_stops_in_a_corner() {
        let made = offset(&path(&[(0.0, 5.0), (10.0, 5.0), (10.0, 3.0), (20.0, 3.0)]), 0.5, TowardsFreeEnd).unwrap();
        assert_eq!(made.len(), 4);
        assert_eq!((made[0].start(), made[0].end()), (Point::new(0.0, 5.5), Point::new(10.0, 5.5)));
        let Segment::Arc { center, ccw, end, .. } = made[1] else { panic!("an arc") };
        assert_eq!((center, ccw, end), (Point::new(10.0, 5.0), false, Point::new(10.5, 5.0)));
        assert_eq!((made[2].end(), made[3].end()), (Point::new(10.5, 3.5), Point::new(20.0, 3.5)));
    }

    #[test]
    fn the_other_direction_gives_the_same_way_backwards() {
        let contour = path(&[(0.0, 5.0), (10.0, 5.0), (10.0, 3.0), (20.0, 8.0)]);
        let back: Vec<Segment> = contour.iter().rev().map(Segment::reversed).collect();
        let there = offset(&contour, 0.5, TowardsFreeEnd).unwrap();
        let again: Vec<Segment> =
            offset(&back, 0.5, TowardsClampedEnd).unwrap().iter().rev().map(Segment::reversed).collect();
        assert_eq!(there.len(), again.len());
        assert!(there.iter().zip(&again).all(|(a, b)| a.end().distance(b.end()) < 1e-12));
    }

    #[test]
    fn an_element_that_the_nose_cannot_reach_is_left_out() {
        // A step of 1 mm in the flank of a hollow; the nose touches the flank above and the floor below it.
        let contour = path(&[(0.0, 9.0), (4.0, 5.0), (4.2, 5.0), (4.2, 3.0), (9.0, 3.0)]);
        let made = offset(&contour, 1.0, TowardsFreeEnd).unwrap();
        assert!(made.windows(2).all(|w| w[0].end() == w[1].start()));
        let whole = crate::geometry::Contour::new(contour);
        let near = made.iter().map(|s| whole.distance_to(s.point_at(0.5))).fold(f64::INFINITY, f64::min);
        assert!(near > 1.0 - 1e-9, "{near}");
    }

    #[test]
    fn a_nose_without_room_is_refused_with_its_place() {
        let groove = path(&[(0.0, 5.0), (10.0, 5.0), (10.0, 3.0), (10.8, 3.0), (10.8, 5.0), (20.0, 5.0)]);
        let fault = offset(&groove, 0.5, TowardsFreeEnd).unwrap_err();
        assert_eq!(fault.code, "no-room-for-nose");
        assert!(fault.message.contains("0.500 mm"), "{}", fault.message);
        let arc = Segment::Arc {
            start: Point::new(0.0, 5.0),
            end: Point::new(0.8, 5.0),
            center: Point::new(0.4, 5.0),
            ccw: true,
        };
        assert!(offset(&[arc], 0.5, TowardsFreeEnd).unwrap_err().message.contains("radius 0.400 mm"));
    }

    #[test]
    fn a_smooth_joint_has_one_point_at_the_full_distance() {
        let p = Point::new;
        let contour = [
            Segment::line(p(0.0, 5.0), p(10.0, 5.0)),
            Segment::Arc { start: p(10.0, 5.0), end: p(12.0, 3.0), center: p(10.0, 3.0), ccw: false },
            Segment::line(p(12.0, 3.0), p(12.0, 1.0)),
        ];
        let made = offset(&contour, 0.5, TowardsFreeEnd).unwrap();
        assert_eq!(made.len(), 3);
        assert!(made[0].end().distance(p(10.0, 5.5)) < 1e-12 && made[1].end().distance(p(12.5, 3.0)) < 1e-12);
    }

    mod random_contours {
        use super::*;
        use crate::geometry::Contour;
        use proptest::prelude::*;

        /// How exactly the distance must be kept, mm.
        const EXACT_MM: f64 = 1e-6;

        /// A chain of lines and arcs with growing z: legs of 1 to 8 mm, flat enough for the offsets tried on them.
        fn contour() -> impl Strategy<Value = Vec<Segment>> {
            let leg = (2.0..8.0_f64, -1.2..1.2_f64, 0_u8..3);
            proptest::collection::vec(leg, 1..8).prop_map(|legs| {
                let mut at = Point::new(0.0, 50.0);
                let mut out = Vec::new();
                for (length, slope, kind) in legs {
                    let to = at + Vector::new(slope.cos(), slope.sin()) * length;
                    let along = to - at;
                    // Arcs of 30 degrees: centre √3/2 / sin 30° … off the chord, on either side.
                    let away = Vector::new(-along.y, along.x) * (0.5 / 15.0_f64.to_radians().tan());
                    let middle = Point::new(f64::midpoint(at.z, to.z), f64::midpoint(at.r, to.r));
                    out.push(match kind {
                        0 => Segment::line(at, to),
                        1 => Segment::Arc { start: at, end: to, center: middle + away, ccw: true },
                        _ => Segment::Arc { start: at, end: to, center: middle - away, ccw: false },
                    });
                    at = to;
                }
                out
            })
        }

        /// Corners that are prolonged on purpose, where the distance grows.
        fn has_prolonged_corner(contour: &[Segment]) -> bool {
            contour.windows(2).any(|w| {
                let turn = turn_deg(&w[0], &w[1]);
                turn < 0.0 && turn > -PROLONGED_BELOW_DEG && !(is_line(&w[0]) && is_line(&w[1]) && turn < -1.0)
            })
        }

        /// Joints that count as smooth but are not quite: there the way cuts the corner by some 1e-6 mm.
        fn has_nearly_smooth_joint(contour: &[Segment]) -> bool {
            contour.windows(2).any(|w| turn_deg(&w[0], &w[1]).abs() < TANGENT_DEG)
        }

        proptest! {
            #![proptest_config(ProptestConfig::with_cases(400))]

            #[test]
            fn every_point_keeps_its_distance(contour in contour(), amount in 0.1..0.9_f64) {
                prop_assume!(!has_nearly_smooth_joint(&contour));
                let Ok(made) = offset(&contour, amount, TowardsFreeEnd) else { return Ok(()) };
                prop_assert!(Contour::new(made.clone()).largest_gap() < EXACT_MM);
                let prolonged = has_prolonged_corner(&contour);
                let whole = Contour::new(contour);
                for segment in &made {
                    for k in 0..=10 {
                        let distance = whole.distance_to(segment.point_at(f64::from(k) / 10.0));
                        prop_assert!(distance > amount - EXACT_MM, "{distance} of {amount}");
                        let most = if prolonged { amount / PROLONGED_BELOW_DEG.to_radians().cos() } else { amount };
                        prop_assert!(distance < most + EXACT_MM, "{distance} of {amount}");
                    }
                }
            }
        }
    }
}
