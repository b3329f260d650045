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
    Move { path: Segment, drive: Drive, tool: u32 },
    /// One straight pass with the slide coupled to the spindle; `lead` is its advance along `path` for one turn, mm.
    ThreadPass { path: Segment, lead: f64, rpm: f64, tool: u32 },
    /// The threading cycle of the ORAC.
    Thread(Thread),
    /// A dwell, s; a wait for a signal counts as none.
    Pause(f64),
}

/// How fast slide and spindle go along a move.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Drive {
    /// A rapid move: the feed does not count.
    pub rapid: bool,
    /// Feed of the slide.
    pub feed: Feed,
    /// Speed of the spindle.
    pub speed: Speed,
}

/// Feed of the slide.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Feed {
    /// mm/min.
    PerMinute(f64),
    /// mm/rev.
    PerRev(f64),
}

/// Speed of the spindle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Speed {
    /// rev/min.
    Rpm(f64),
    /// Constant cutting speed, mm/min, and the speeds that the spindle keeps between, rev/min.
    Surface { mm_per_min: f64, least: f64, most: f64 },
}

impl Speed {
    /// Spindle speed with the tool at `radius` mm, rev/min: `n = v / (2πr)`.
    pub(super) fn rpm_at(self, radius: f64) -> f64 {
        match self {
            Self::Rpm(rpm) => rpm,
            Self::Surface { mm_per_min, least, most } => {
                let rpm = mm_per_min / (std::f64::consts::TAU * radius.abs());
                if rpm.is_nan() { most } else { rpm.min(most).max(least.min(most)) }
            }
        }
    }
}

impl Drive {
    /// Feed of the slide with the tool at `radius` mm, mm/min.
    pub(super) fn feed_at(&self, radius: f64) -> f64 {
        match self.feed {
            Feed::PerMinute(feed) => feed,
            Feed::PerRev(feed) => feed * self.speed.rpm_at(radius),
        }
    }

    /// Time for a move at cutting feed, s, by Simpson's rule where the spindle speed changes along it; 0 without feed.
    pub(super) fn cutting_seconds(&self, path: &Segment) -> f64 {
        /// Parts of the path: with eight, a facing cut from any radius to the axis is right within 0.1 %.
        const PARTS: u32 = 8;
        let per_mm = |t: f64| 60.0 / self.feed_at(path.point_at(t).r);
        let constant = matches!((self.feed, self.speed), (Feed::PerMinute(_), _) | (_, Speed::Rpm(_)));
        let mean = if constant {
            per_mm(0.0)
        } else {
            let weight = |k: u32| {
                if k == 0 || k == PARTS {
                    1.0
                } else if k % 2 == 1 {
                    4.0
                } else {
                    2.0
                }
            };
            let sum: f64 = (0..=PARTS).map(|k| weight(k) * per_mm(f64::from(k) / f64::from(PARTS))).sum();
            sum / (3.0 * f64::from(PARTS))
        };
        let seconds = mean * path.length();
        if seconds.is_finite() { seconds.max(0.0) } else { 0.0 }
    }
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
