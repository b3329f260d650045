//! The cut-in line: the straight way by which a tool enters a hollow.

use super::fault::Fault;
use super::job::Job;
use crate::document::CutIn;
use crate::geometry::{Intersection, Point, Segment, Vector};

/// A line flatter than this has no point at a given radius, sine of its angle to the spindle: 1°.
const FLATTEST: f64 = 0.017;

/// The line is drawn this far to both sides of its point to find what it crosses, mm: beyond any lathe.
const FAR_MM: f64 = 1e4;

/// How exactly the line must meet the element, mm.
const MEETS_MM: f64 = 1e-6;

/// The way of the nose's centre into the material.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct CutInLine {
    /// The given point, shifted by the nose radius to the side that is cut.
    pub point: Point,
    /// Direction of unit length.
    along: Vector,
    /// Where the centre of the nose comes to the offset of the first element.
    pub entry: Point,
}

impl CutInLine {
    /// The line of an instruction; it must cross the first element of the area (Wong 1983, 8.6.2).
    pub(super) fn of(job: &Job<'_>, cut_in: &CutIn) -> Result<Self, Fault> {
        let angle = cut_in.angle_deg.to_radians();
        let along = Vector::new(angle.cos(), angle.sin());
        if !(along.y.abs() >= FLATTEST && cut_in.z.is_finite() && cut_in.diameter.is_finite()) {
            let message =
                format!("The cut-in line has an angle of {}° to the spindle; it needs 1° or more.", cut_in.angle_deg);
            return Err(Fault::new("cut-in-flat", message, "Enter a steeper angle."));
        }
        let given = Point::new(cut_in.z, cut_in.diameter / 2.0);
        let crossing = crossing(job, given, along)?;
        // The nose keeps its own radius from the line, not the stock: it stays on the side that is cut.
        let side = Vector::new(along.y, -along.x) * (job.sign() * along.y.signum());
        let point = given + side * job.tool.nose_radius;
        let line = Segment::line(point, point + along);
        let entry = job.contour.first().and_then(|first| {
            first.prolonged_meeting(&line, crossing).filter(|entry| first.distance_to(*entry) <= MEETS_MM)
        });
        let entry = entry.ok_or_else(|| {
            let message = format!(
                "The nose does not come to the first element along the cut-in line through z {:.3} mm: a corner of the \
                 contour is in its way.",
                cut_in.z
            );
            Fault::new("cut-in-misses", message, "Move the point of the line away from the ends of the first element.")
        })?;
        Ok(Self { point, along, entry })
    }

    /// The point of the line at radius `r`.
    pub(super) fn at_radius(&self, r: f64) -> Point {
        Point::new(self.point.z + self.along.x / self.along.y * (r - self.point.r), r)
    }
}

/// Where the given line crosses the first element.
fn crossing(job: &Job<'_>, given: Point, along: Vector) -> Result<Point, Fault> {
    let line = Segment::line(given - along * FAR_MM, given + along * FAR_MM);
    let first = job.area.elements.first().copied().unwrap_or(Segment::line(given, given));
    match first.intersection(&line, MEETS_MM) {
        Intersection::Apart => {
            let (start, end) = (first.start(), first.end());
            let message = format!(
                "The cut-in line through z {:.3} mm, ⌀ {:.3} mm does not cross the first element, z {:.3} mm ⌀ {:.3} mm to \
                 z {:.3} mm ⌀ {:.3} mm.",
                given.z,
                2.0 * given.r,
                start.z,
                2.0 * start.r,
                end.z,
                2.0 * end.r
            );
            Err(Fault::new("cut-in-misses", message, "Choose a point or an angle with which it does."))
        }
        found => Ok(found.points().first().copied().unwrap_or(given)),
    }
}
