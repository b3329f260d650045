//! Cutter location data: where the programmed point of the tool goes, before any control's words.

use crate::geometry::{Point, Vector};

/// All operations of one set-up. Points are in the set-up's part space, mm, unrounded.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct CutterPath {
    /// Where every operation begins and ends.
    pub datum: Point,
    /// Part-space position of the control's zero along the spindle: program z = part z − this.
    pub program_zero_z: f64,
    /// Operations in order of cutting; one without moves stands for a stage that has nothing to do.
    pub operations: Vec<Operation>,
}

/// Moves of one tool for one purpose, from the datum back to the datum.
#[derive(Debug, Clone, PartialEq)]
pub struct Operation {
    /// Purpose.
    pub kind: OperationKind,
    /// Turret station of the tool.
    pub tool: u32,
    /// Moves in order.
    pub moves: Vec<CutMove>,
}

/// Purpose of an operation.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum OperationKind {
    /// Roughing towards the chuck.
    RoughRight,
    /// Finishing towards the chuck.
    FinishRight,
    /// Roughing what the right-hand tool leaves.
    RoughLeft,
    /// Finishing what the right-hand tool leaves.
    FinishLeft,
    /// Threading.
    Thread,
    /// Parting off.
    PartOff,
}

/// One move of the programmed point.
#[derive(Debug, Clone, PartialEq)]
pub enum CutMove {
    /// Straight to `to`.
    Line {
        /// End point.
        to: Point,
        /// Feed, mm/min.
        feed_mm_per_min: f64,
        /// Spindle speed, rev/min.
        rpm: f64,
    },
    /// On an arc of at most half a turn to `to`.
    Arc {
        /// End point.
        to: Point,
        /// Centre.
        center: Point,
        /// Counter-clockwise with z right and r up.
        ccw: bool,
        /// Feed, mm/min.
        feed_mm_per_min: f64,
        /// Spindle speed, rev/min.
        rpm: f64,
    },
    /// A complete thread by the control's own cycle, from the present point; the tool ends where it began.
    Thread {
        /// Position of the thread's far end.
        to_z: f64,
        /// Outside radius.
        outside_radius: f64,
        /// Base radius.
        base_radius: f64,
        /// Pitch, mm.
        pitch: f64,
        /// Depth of one cut on the radius, mm.
        depth_per_cut: f64,
        /// Spindle speed, rev/min.
        rpm: f64,
    },
    /// The moves of `body`, `count` times, each time displaced by `step` from the time before.
    Repeat {
        /// How often.
        count: u32,
        /// Displacement from one time to the next, mm.
        step: Vector,
        /// The moves of the first time.
        body: Vec<CutMove>,
    },
}
