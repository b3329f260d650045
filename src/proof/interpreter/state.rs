//! Modal words of a running program.

use crate::geometry::Point;
use crate::machine::{ArcCenter, Dialect, Machine, Words};
use crate::proof::step::{Feed, Speed};
use crate::units::{MM_PER_INCH, Unit};

/// What the words of a program set until others change it.
#[derive(Debug, Clone)]
#[allow(clippy::struct_excessive_bools, reason = "each is a modal state of its own")]
pub(super) struct State {
    /// The G word that moves without being said again.
    pub motion: Motion,
    /// Unit of lengths; `None` until the program says so.
    pub unit: Option<Unit>,
    /// X and Z are positions; otherwise moves (LinuxCNC's G91).
    pub absolute: bool,
    /// X counts diameters.
    pub diameter: bool,
    /// The program has said whether X is a diameter (LinuxCNC's G7 and G8).
    pub diameter_said: bool,
    /// Where I and K count from.
    pub arc_center: ArcCenter,
    /// The feed is per turn.
    pub per_rev: bool,
    /// Feed per minute or turn, mm; `None` until the program says so.
    pub feed: Option<f64>,
    /// Lead of threads, mm.
    pub lead: Option<f64>,
    /// S is a cutting speed.
    pub surface: bool,
    /// Cutting speed, m/min, or spindle speed, rev/min; `None` until the program says so.
    pub speed: Option<f64>,
    /// Highest speed under constant cutting speed, rev/min.
    pub clamp: Option<f64>,
    /// The spindle turns.
    pub turning: bool,
    /// Gear range by its index in the machine's list.
    pub range: Option<usize>,
    /// Tool that the next M6 puts into place.
    pub prepared: Option<u32>,
    /// Number of the offset that counts for the tool in place; 0 for none.
    pub offset: u32,
    /// Programmed point as the program counts it, without compensation.
    pub at: Option<Point>,
    /// What the program says about the point differs from the truth since block and for this reason.
    pub shifted_by: Option<&'static str>,
    /// First lines of two-line cycles.
    pub cycle: CycleSettings,
    /// X, Z, R and depth of a cycle that goes on with the next block.
    pub repeated: Repeated,
}

/// The G words of group 1.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Motion {
    /// G0.
    Rapid,
    /// G1.
    Line,
    /// G2 and G3, seen with z to the right and r upwards.
    Arc {
        /// Counter-clockwise.
        ccw: bool,
    },
    /// G32 of Fanuc, G33 of LinuxCNC.
    Thread,
    /// Fanuc's G90: one turning cut.
    TurnCycle,
    /// Fanuc's G92: one threading cut.
    ThreadCycle,
    /// Fanuc's G94: one facing cut.
    FaceCycle,
    /// None: G80.
    None,
}

/// Values that a two-line cycle reads from its first line. mm, radius values.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct CycleSettings {
    /// Depth of cut of G71 and G72.
    pub depth: Option<f64>,
    /// Retraction of G71, G72, G74 and G75.
    pub retract: f64,
    /// G73: distance of the first cut from the contour.
    pub repeat_away: Option<(f64, f64)>,
    /// G73: number of cuts.
    pub repeats: u32,
    /// G76: repetitions of the last cut.
    pub finishes: u32,
    /// G76: length of the run-out, leads.
    pub run_out_leads: f64,
    /// G76: angle between the flanks, degrees.
    pub angle: f64,
    /// G76: thinnest cut.
    pub thinnest: f64,
    /// G76: depth of the last cut.
    pub finish_depth: f64,
}

/// Values of G90, G92 and G94 that the next block need not repeat.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Repeated {
    /// End point.
    pub end: Option<Point>,
    /// Taper: start less end, on the radius or along z, mm.
    pub taper: f64,
}

impl State {
    /// The words in force when a program starts: those that the controls take after a reset.
    pub(super) fn new(machine: &Machine, words: &Words) -> Self {
        Self {
            motion: Motion::Rapid,
            unit: None,
            absolute: true,
            diameter: words.x_is_diameter,
            diameter_said: false,
            arc_center: words.arc_center,
            per_rev: machine.dialect == Dialect::Fanuc && words.feed_per_rev,
            feed: None,
            lead: None,
            surface: false,
            speed: None,
            clamp: None,
            turning: false,
            range: None,
            prepared: None,
            offset: 0,
            at: None,
            shifted_by: None,
            cycle: CycleSettings { finishes: 1, ..CycleSettings::default() },
            repeated: Repeated::default(),
        }
    }

    /// Millimetres of one unit of length of the program.
    pub(super) fn mm_per_unit(&self) -> f64 {
        if self.unit == Some(Unit::Inch) { MM_PER_INCH } else { 1.0 }
    }

    /// Feed of the slide; 0 if the program gave none.
    pub(super) fn drive_feed(&self) -> Feed {
        let feed = self.feed.unwrap_or(0.0);
        if self.per_rev { Feed::PerRev(feed) } else { Feed::PerMinute(feed) }
    }

    /// Speed of the spindle: 0 at rest; within the gear range that is engaged.
    pub(super) fn drive_speed(&self, machine: &Machine) -> Speed {
        let Some(speed) = self.speed.filter(|_| self.turning) else { return Speed::Rpm(0.0) };
        if !self.surface {
            return Speed::Rpm(speed);
        }
        let range = self.range.and_then(|index| machine.spindle.ranges.get(index));
        let most = range.map_or(f64::INFINITY, |r| r.max_rpm).min(machine.rpm_limit());
        let most = self.clamp.map_or(most, |clamp| clamp.min(most));
        Speed::Surface { mm_per_min: speed * 1000.0, least: machine.spindle.min_rpm, most }
    }
}
