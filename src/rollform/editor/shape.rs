//! The carrier of a new element from the ways of defining one (chapter 6.5).

use super::carrier::Carrier;
use super::fault::{self, Reason};
use super::find;
use crate::document::{NewElement, RollPoint, TangentSide};
use crate::geometry::{Point, Segment, Vector};
use crate::rollform::roll::RollElement;

/// The neighbours between which a new element comes.
pub(super) struct Between {
    pub before: Segment,
    pub after: Segment,
    /// The corner or element that it comes near to.
    pub near: Point,
}

/// The carrier of a new element.
pub(super) fn carrier(elements: &[RollElement], shape: &NewElement, between: &Between) -> Result<Carrier, Reason> {
    match *shape {
        NewElement::LineTwoPoints { first, second } => {
            let (first, second) = (point(first)?, point(second)?);
            let along =
                (second - first).try_normalize(0.0).ok_or_else(|| fault::figure("distance of the points", 0.0))?;
            Ok(Carrier::Line(first, along))
        }
        NewElement::LineAngle { point: through, angle_deg } => {
            let (sin, cos) = number("angle", angle_deg)?.to_radians().sin_cos();
            Ok(Carrier::Line(point(through)?, Vector::new(cos, sin)))
        }
        NewElement::LineParallel { point: through, to } => {
            let other = elements.get(find(elements, to)?).and_then(|e| Carrier::of(&e.segment));
            match other {
                Some(Carrier::Line(_, along)) => Ok(Carrier::Line(point(through)?, along)),
                _ => Err(wrong_kind("parallel to a line", "an arc")),
            }
        }
        NewElement::CircleRadius { center, radius } => Ok(Carrier::Circle(point(center)?, positive("radius", radius)?)),
        NewElement::CirclePoint { center, point: through } => {
            let center = point(center)?;
            Ok(Carrier::Circle(center, positive("radius", center.distance(point(through)?))?))
        }
        NewElement::CircleMoved { of, dz, dr } => {
            let other = elements.get(find(elements, of)?).and_then(|e| Carrier::of(&e.segment));
            match other {
                Some(Carrier::Circle(center, radius)) => {
                    let by = Vector::new(number("distance along the axis", dz)?, number("distance from the axis", dr)?);
                    Ok(Carrier::Circle(center + by, radius))
                }
                _ => Err(wrong_kind("another arc moved", "a line")),
            }
        }
        NewElement::CircleTangent { radius, before, after } => {
            tangent(positive("radius", radius)?, before, after, between)
        }
    }
}

/// The circle of a radius that touches both neighbours, on the given sides; of two the one nearer to the corner.
fn tangent(radius: f64, before: TangentSide, after: TangentSide, between: &Between) -> Result<Carrier, Reason> {
    let first = moved(&between.before, before, radius)?;
    let second = moved(&between.after, after, radius)?;
    let center = first.meeting(second, between.near);
    center.map(|c| Carrier::Circle(c, radius)).ok_or_else(|| {
        let message = format!("No circle of radius {radius:.3} mm touches both elements on these sides.");
        ("edit-no-meeting", message, "Choose another radius or other sides.")
    })
}

/// The carrier on which the centres of circles lie that touch a segment.
fn moved(segment: &Segment, side: TangentSide, radius: f64) -> Result<Carrier, Reason> {
    match (Carrier::of(segment), side) {
        (Some(Carrier::Line(on, along)), TangentSide::Above | TangentSide::Below) => {
            // Rightwards, or upwards if the line is upright, the left side is above or to the left.
            let forward = if along.x < 0.0 || (along.x == 0.0 && along.y < 0.0) { -along } else { along };
            let left = Vector::new(-forward.y, forward.x);
            Ok(Carrier::Line(on + left * if side == TangentSide::Above { radius } else { -radius }, along))
        }
        (Some(Carrier::Circle(center, own)), TangentSide::Inside) => {
            Ok(Carrier::Circle(center, positive("difference of the radii", (own - radius).abs())?))
        }
        (Some(Carrier::Circle(center, own)), TangentSide::Outside) => Ok(Carrier::Circle(center, own + radius)),
        (Some(Carrier::Line(..)), _) => Err(wrong_kind("inside or outside of a circle", "a line")),
        (Some(Carrier::Circle(..)), _) => Err(wrong_kind("above or below a line", "an arc")),
        (None, _) => Err(fault::figure("length of the neighbour", 0.0)),
    }
}

fn wrong_kind(wanted: &str, found: &str) -> Reason {
    (
        "edit-kind",
        format!("The new element is to lie {wanted}, and the element named is {found}."),
        "Choose another one.",
    )
}

fn point(p: RollPoint) -> Result<Point, Reason> {
    Ok(Point::new(number("position", p.z)?, number("diameter", p.diameter)? / 2.0))
}

fn number(name: &str, value: f64) -> Result<f64, Reason> {
    if value.is_finite() { Ok(value) } else { Err(fault::figure(name, value)) }
}

fn positive(name: &str, value: f64) -> Result<f64, Reason> {
    if value.is_finite() && value > 0.0 { Ok(value) } else { Err(fault::figure(name, value)) }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn center(before: Segment, after: Segment, radius: f64, sides: [TangentSide; 2], near: Point) -> Point {
        let between = Between { before, after, near };
        match tangent(radius, sides[0], sides[1], &between) {
            Ok(Carrier::Circle(center, found)) if found == radius => center,
            other => panic!("{:?}", other.err()),
        }
    }

    #[test]
    fn a_tangent_circle_lies_on_the_chosen_side_of_both_neighbours() {
        use TangentSide::{Above, Below, Inside, Outside};
        let p = Point::new;
        let corner = p(20.0, 30.0);
        let (face, wall) = (Segment::line(p(0.0, 30.0), corner), Segment::line(corner, p(20.0, 50.0)));
        for (sides, wanted) in [
            ([Above, Above], p(15.0, 35.0)),
            ([Above, Below], p(25.0, 35.0)),
            ([Below, Above], p(15.0, 25.0)),
            ([Below, Below], p(25.0, 25.0)),
        ] {
            assert!(center(face, wall, 5.0, sides, corner).distance(wanted) < 1e-9, "{sides:?}");
        }
        // A circle of 10 mm about the origin and the line through it: 4 mm above the line, 6 or 14 mm from the origin.
        let arc = Segment::Arc { start: p(-10.0, 0.0), end: p(10.0, 0.0), center: p(0.0, 0.0), ccw: false };
        let line = Segment::line(p(10.0, 0.0), p(30.0, 0.0));
        for (side, z) in [(Inside, 20.0_f64.sqrt()), (Outside, 180.0_f64.sqrt())] {
            assert!(center(arc, line, 4.0, [side, Above], p(10.0, 0.0)).distance(p(z, 4.0)) < 1e-9, "{side:?}");
            assert!(center(arc, line, 4.0, [side, Above], p(-10.0, 0.0)).distance(p(-z, 4.0)) < 1e-9, "{side:?}");
        }
        let between = Between { before: arc, after: line, near: corner };
        assert!(tangent(4.0, Above, Above, &between).is_err(), "an arc has an inside and an outside");
    }
}
