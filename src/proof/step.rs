//! What a running program asks of the machine.

use crate::geometry::{Point, Segment};

/// Blocks that one program may run before it counts as endless. The longest honest program is far shorter: at 30 ms a block
/// this is more than four hours of machining.
pub(super) const STEP_BUDGET: u32 = 500_000;

/// What the tool does next. Part space, mm, mm/min.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Step {
    /// To the program's datum; `from` is `None` if nobody knows where the tool was.
    Datum { from: Option<Point>, to: Point },
    /// Along a line or arc.
    Move { path: Segment, feed: f64, tool: u32, rpm: f64 },
    /// The threading cycle.
    Thread(Thread),
    /// A dwell, s; a wait for a signal counts as none.
    Pause(f64),
}

/// A complete thread by the control's own cycle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Thread {
    /// Where it begins and ends.
    pub from: Point,
    /// Far end.
    pub to_z: f64,
    /// Outside radius.
    pub outside_radius: f64,
    /// Base radius.
    pub base_radius: f64,
    /// Pitch.
    pub pitch: f64,
    /// Depth of one cut on the radius.
    pub depth: f64,
    /// Turret station.
    pub tool: u32,
    /// Spindle speed, rev/min.
    pub rpm: f64,
}

impl Thread {
    /// Cuts from the outside to the base radius; at least one, and no more than a program may run blocks.
    pub(super) fn passes(&self) -> u32 {
        /// A last cut thinner than this, mm, is none: numbers have three decimals.
        const THINNEST: f64 = 0.0005;
        let cuts = ((self.outside_radius - self.base_radius - THINNEST) / self.depth).ceil();
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped to 1..=STEP_BUDGET")]
        if self.depth > 0.0 && cuts.is_finite() { cuts.clamp(1.0, f64::from(STEP_BUDGET)) as u32 } else { 1 }
    }
}
