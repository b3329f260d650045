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
