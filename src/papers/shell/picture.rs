//! The set-up to scale: former, blank, shell, follower, and the roller where it begins.

use super::Subject;
use crate::geometry::{Bounds, Contour, Point, Segment, Vector};
use crate::papers::page::{Ink, Page, Pen};
use crate::papers::setup_sheet::writer::{LEFT_MM, RIGHT_MM, Writer};
use crate::papers::view::{View, mirrored};
use crate::spinning::roller;

/// Height of the picture, mm.
const PICTURE_MM: f64 = 78.0;
/// Room at its sides, mm.
const SIDE_MM: f64 = 4.0;
/// Distance of chords from arcs, mm.
const CHORD_MM: f64 = 0.02;
/// Width of the shell's edges, mm.
const EDGE_MM: f64 = 0.35;

/// Draws the set-up, as large as the page allows.
pub(super) fn picture(subject: &Subject<'_>, to: &mut Writer) {
    to.need(PICTURE_MM + 4.0);
    let (low, high) = (to.r - PICTURE_MM, to.r - 4.0);
    let bodies = Bodies::of(subject);
    let Some(shown) = bodies.bounds() else { return };
    let size = shown.max - shown.min;
    let scale = ((RIGHT_MM - LEFT_MM - 2.0 * SIDE_MM) / size.x).min((high - low) / size.y);
    if !(scale.is_finite() && scale > 0.0) {
        return;
    }
    let left = f64::midpoint(LEFT_MM, RIGHT_MM) - f64::midpoint(shown.min.z, shown.max.z) * scale;
    let view = View { origin: Point::new(left, low - shown.min.r * scale), scale };
    bodies.draw(&mut to.page, &view);
    view.axis(&mut to.page, shown.min.z, shown.max.z);
    to.r = low - 2.0;
}

/// What the picture shows, upper halves.
struct Bodies {
    former: Contour,
    follower: Contour,
    blank: Contour,
    shell: Contour,
    /// Body and nose of the roller.
    roller: Option<(Contour, Contour)>,
    /// The path of the roller's nose centre.
    path: Vec<Segment>,
}

impl Bodies {
    fn of(subject: &Subject<'_>) -> Self {
        let (shape, shell) = (&subject.made.shape, subject.shell());
        let tip = shape.tip();
        let face = tip.z + shape.thickness;
        let block = |z1: f64, z2: f64, r: f64| {
            Contour::polygon(&[Point::new(z1, 0.0), Point::new(z2, 0.0), Point::new(z2, r), Point::new(z1, r)])
        };
        let start = subject.made.path.passes.first().map(|pass| pass.approach);
        let roller = start.map(|at| {
            let by = at - Point::default();
            let corners: Vec<Point> = roller::body(&shell.roller).into_iter().map(|p| p + by).collect();
            (Contour::polygon(&corners), circle(at, shell.roller.nose_radius))
        });
        Self {
            former: Contour::polygon(&shape.former_outline(CHORD_MM)),
            follower: block(face, face + shell.blank.follower_length, shell.blank.follower_diameter / 2.0),
            blank: block(tip.z, face, shape.blank_radius),
            shell: Contour::polygon(&shape.shell_outline(CHORD_MM)),
            roller,
            path: subject.made.path.passes.iter().flat_map(|pass| pass.contour.segments.iter().copied()).collect(),
        }
    }

    fn bounds(&self) -> Option<Bounds> {
        let halves = [&self.former, &self.follower, &self.blank, &self.shell];
        let upper = halves.into_iter().filter_map(Contour::bounds).reduce(Bounds::union)?;
        let both = upper.including(Point::new(upper.min.z, -upper.max.r));
        let roller = self.roller.iter().flat_map(|(body, nose)| [body.bounds(), nose.bounds()]).flatten();
        Some(roller.fold(both, Bounds::union))
    }

    fn draw(&self, page: &mut Page, view: &View) {
        let grey = Pen { ink: Ink::Grey, ..Pen::THIN };
        for (body, fill) in [(&self.former, Ink::Pale), (&self.follower, Ink::Pale)] {
            for half in halves(body, view) {
                page.area(half, fill, Some(grey));
            }
        }
        for half in halves(&self.blank, view) {
            page.area(half, Ink::Sand, Some(Pen::DASHED));
        }
        for half in halves(&self.shell, view) {
            page.path(half, Pen { width_mm: EDGE_MM, ..Pen::EDGE });
        }
        for segment in &self.path {
            page.path(vec![view.segment(segment)], Pen { ink: Ink::Green, ..Pen::THIN });
        }
        for body in self.roller.iter().flat_map(|(body, nose)| [body, nose]) {
            page.area(view.segments(&body.segments), Ink::Sand, Some(Pen::THIN));
        }
    }
}

fn halves(body: &Contour, view: &View) -> [Vec<Segment>; 2] {
    [view.segments(&body.segments), body.segments.iter().map(|s| view.segment(&mirrored(s))).collect()]
}

fn circle(center: Point, radius: f64) -> Contour {
    let across = Vector::new(radius, 0.0);
    let half = |start: Point, end: Point| Segment::Arc { start, end, center, ccw: true };
    let (a, b) = (center + across, center - across);
    Contour::new(vec![half(a, b), half(b, a)])
}
