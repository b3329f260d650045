//! What every operation of the published generator needs: surface, depths, feeds and speeds; and the builder of its moves.

use super::envelope::{Envelope, Shadow};
use super::surface::Surface;
use crate::geometry::{Point, Segment, Vector};
use crate::machine::{Machine, OracData};
use crate::turning::{Cut, CutMove};

/// Smallest step of the control's numbers, mm. Depths are multiples of it, so that the passes of a loop are equal.
const CONTROL_STEP_MM: f64 = 0.001;

/// Finishing passes over a contour; roughing leaves their depths together.
pub(super) const FINISHING_PASSES: u32 = 2;

/// One set-up seen by the generator, mm.
pub(super) struct Plan<'a> {
    pub(super) machine: &'a Machine,
    pub(super) material: &'a OracData,
    /// Where every operation begins and ends.
    pub(super) datum: Point,
    pub(super) bar_radius: f64,
    /// The contour to be made, z from the clamped to the free end.
    pub(super) surface: Surface,
    /// What the right-hand tool can reach of it.
    pub(super) right: Envelope,
    /// What the left-hand tool can reach of it; z runs the other way round.
    pub(super) left: Envelope,
    pub(super) rough_depth: f64,
    pub(super) finish_depth: f64,
}

impl<'a> Plan<'a> {
    pub(super) fn new(
        surface: Surface,
        datum: Point,
        bar_radius: f64,
        machine: &'a Machine,
        material: &'a OracData,
    ) -> Self {
        let right = Envelope::of(&surface);
        let left = Envelope::of(&surface.mirrored());
        let step = |depth: f64| ((depth / CONTROL_STEP_MM).round() * CONTROL_STEP_MM).max(CONTROL_STEP_MM);
        let (rough_depth, finish_depth) = (step(material.depth_rough), step(material.depth_finish));
        Self { machine, material, datum, bar_radius, surface, right, left, rough_depth, finish_depth }
    }

    /// What roughing leaves, on the radius.
    pub(super) fn allowance(&self) -> f64 {
        self.finish_depth * f64::from(FINISHING_PASSES)
    }

    /// Position of the free end.
    pub(super) fn face_z(&self) -> f64 {
        self.datum.z - self.machine.datum.axial_clearance_mm
    }

    /// Radius of roughing level `k`, from 0: the bar's surface first, then one depth after the other.
    pub(super) fn level(&self, k: u32) -> f64 {
        self.bar_radius - f64::from(k) * self.rough_depth
    }

    /// Areas that the right-hand tool leaves to the left-hand one, in order of z.
    pub(super) fn left_areas(&self) -> impl Iterator<Item = &Shadow> {
        self.right.shadows.iter().filter(|s| s.is_worth_cutting())
    }

    /// Spindle speed for cutting at `radius`, within what the machine can do; the highest one on a machine whose speed does
    /// not follow the radius.
    pub(super) fn rpm(&self, radius: f64) -> f64 {
        let highest = self.machine.limits.spindle_max_rpm;
        self.machine.spindle.rpm_by_radius(radius).map_or(highest, |rpm| rpm.min(highest))
    }

    /// Moves from the datum.
    pub(super) fn moves(&self) -> Moves<'_> {
        Moves { plan: self, at: self.datum, list: Vec::new() }
    }
}

/// Builds the moves of an operation; knows where the tool is.
pub(super) struct Moves<'a> {
    plan: &'a Plan<'a>,
    at: Point,
    list: Vec<CutMove>,
}

impl Moves<'_> {
    /// Straight to `to` at any feed.
    pub(super) fn line(&mut self, to: Point, feed_mm_per_min: f64, rpm: f64) {
        self.list.push(CutMove::Line { to, cut: Cut::per_minute(feed_mm_per_min, rpm) });
        self.at = to;
    }

    /// Along the spindle at the feed of travel.
    pub(super) fn travel_z(&mut self, z: f64, rpm: f64) {
        self.line(Point::new(z, self.at.r), self.plan.material.feed_travel, rpm);
    }

    /// Across the spindle at the feed of travel.
    pub(super) fn travel_r(&mut self, r: f64, rpm: f64) {
        self.line(Point::new(self.at.z, r), self.plan.material.feed_travel, rpm);
    }

    /// Along the spindle at the feed of cutting.
    pub(super) fn cut_z(&mut self, z: f64, rpm: f64) {
        self.line(Point::new(z, self.at.r), self.plan.material.feed_cut, rpm);
    }

    /// Across the spindle at the feed of cutting.
    pub(super) fn cut_r(&mut self, r: f64, rpm: f64) {
        self.line(Point::new(self.at.z, r), self.plan.material.feed_cut, rpm);
    }

    /// Across the spindle at a feed of its own.
    pub(super) fn feed_r(&mut self, r: f64, feed_mm_per_min: f64, rpm: f64) {
        self.line(Point::new(self.at.z, r), feed_mm_per_min, rpm);
    }

    /// Along `segment`, which lies `above` the contour; the speed follows the contour's radius at its end.
    pub(super) fn cut_along(&mut self, segment: &Segment, above: f64) {
        let (plan, rpm) = (self.plan, self.plan.rpm(segment.end().r));
        let lifted = segment.translated(Vector::new(0.0, above));
        match lifted {
            Segment::Line { end, .. } => self.line(end, plan.material.feed_cut, rpm),
            Segment::Arc { end: to, center, ccw, .. } => {
                let cut = Cut::per_minute(plan.material.feed_cut, rpm);
                self.list.push(CutMove::Arc { to, center, ccw, cut });
                self.at = to;
            }
        }
    }

    /// Out to the datum's radius and back to the datum.
    pub(super) fn home(&mut self) {
        let rpm = self.plan.rpm(self.plan.datum.r);
        self.travel_r(self.plan.datum.r, rpm);
        self.travel_z(self.plan.datum.z, rpm);
    }

    /// A move that ends where it began, such as a thread.
    pub(super) fn push(&mut self, cycle: CutMove) {
        self.list.push(cycle);
    }

    /// `count` times what `body` makes, each time `step_r` mm further out; a negative step goes inwards.
    pub(super) fn repeat(&mut self, count: u32, step_r: f64, body: impl FnOnce(&mut Self)) {
        let start = self.at;
        let before = std::mem::take(&mut self.list);
        body(self);
        let body = std::mem::replace(&mut self.list, before);
        self.list.push(CutMove::Repeat { count, step: Vector::new(0.0, step_r), body });
        self.at = Point::new(self.at.z, start.r + step_r * f64::from(count));
    }

    /// The moves made.
    pub(super) fn done(self) -> Vec<CutMove> {
        self.list
    }
}
