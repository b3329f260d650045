//! Cutter location data: where the programmed point of the tool goes, before any control's words.

use super::Recipe;
pub use crate::document::OperationKind;
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

/// Moves of one tool for one purpose, from its change position back to it.
#[derive(Debug, Clone, PartialEq)]
pub struct Operation {
    /// Purpose.
    pub kind: OperationKind,
    /// Name for people, used in program comments and on the setup sheet.
    pub name: String,
    /// Turret station of the tool.
    pub tool: u32,
    /// Where the programmed point is while the turret turns; `None` stands for the path's datum.
    pub change: Option<Point>,
    /// Moves in order.
    pub moves: Vec<CutMove>,
    /// What some of them were made from, in their order; generators that do not tell leave it empty.
    pub recipes: Vec<Recipe>,
}

/// How a cutting move is made.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cut {
    /// How fast the tool travels.
    pub feed: Feed,
    /// How fast the work turns.
    pub speed: Speed,
}

/// Feed of a cutting move.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Feed {
    /// mm/min.
    PerMinute(f64),
    /// mm/rev.
    PerRev(f64),
}

/// Speed of the spindle during a cutting move.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Speed {
    /// A fixed speed, rev/min.
    Rpm(f64),
    /// Constant cutting speed.
    Surface {
        /// Cutting speed, m/min.
        m_per_min: f64,
        /// Spindle speed that the control must not exceed, rev/min.
        max_rpm: f64,
    },
}

/// One move of the programmed point.
#[derive(Debug, Clone, PartialEq)]
pub enum CutMove {
    /// Through air, straight to `to`, both axes together.
    Rapid {
        /// End point.
        to: Point,
    },
    /// Straight to `to`.
    Line {
        /// End point.
        to: Point,
        /// Feed and speed.
        cut: Cut,
    },
    /// On an arc of at most half a turn to `to`.
    Arc {
        /// End point.
        to: Point,
        /// Centre.
        center: Point,
        /// Counter-clockwise with z right and r up.
        ccw: bool,
        /// Feed and speed.
        cut: Cut,
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
    /// One threading pass: straight to `to` with the slide coupled to the spindle.
    ThreadPass {
        /// End point.
        to: Point,
        /// Advance along the spindle per turn, mm.
        lead: f64,
        /// Angle of the spindle at which the pass starts, degrees; tells the starts of a multi-start thread apart.
        start_deg: f64,
        /// Spindle speed, rev/min.
        rpm: f64,
    },
    /// The tool waits with the spindle turning.
    Dwell {
        /// Seconds.
        seconds: f64,
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

impl Cut {
    /// Feed in mm/min at a fixed spindle speed.
    #[must_use]
    pub const fn per_minute(feed_mm_per_min: f64, rpm: f64) -> Self {
        Self { feed: Feed::PerMinute(feed_mm_per_min), speed: Speed::Rpm(rpm) }
    }

    /// The same speed with a share of the feed.
    #[must_use]
    pub fn slower(self, share: f64) -> Self {
        let feed = match self.feed {
            Feed::PerMinute(feed) => Feed::PerMinute(feed * share),
            Feed::PerRev(feed) => Feed::PerRev(feed * share),
        };
        Self { feed, ..self }
    }

    /// Spindle speed with the tool at `radius` mm, rev/min: `v / (2πr)` of a constant cutting speed, at most its clamp.
    #[must_use]
    pub fn rpm_at(&self, radius: f64) -> f64 {
        match self.speed {
            Speed::Rpm(rpm) => rpm,
            Speed::Surface { m_per_min, max_rpm } => {
                (m_per_min * 1000.0 / (std::f64::consts::TAU * radius.abs())).min(max_rpm)
            }
        }
    }

    /// Feed with the tool at `radius` mm, mm/min.
    #[must_use]
    pub fn mm_per_min_at(&self, radius: f64) -> f64 {
        match self.feed {
            Feed::PerMinute(feed) => feed,
            Feed::PerRev(feed) => feed * self.rpm_at(radius),
        }
    }
}
