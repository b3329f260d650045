//! What the writer of a program has to know of machine and control, worked out once.

use super::arc::ArcRules;
use super::grid::Grid;
use super::number::NumberFormat;
use crate::machine::{DecimalPoint, Dialect, Machine, Words};
use crate::post::Options;
use crate::turning::{Cut, CutterPath, Feed, Speed};
use crate::units::Unit;

/// Metres in one foot: cutting speeds of programs in inches are ft/min.
const M_PER_FOOT: f64 = 0.3048;

/// A control with the numbers of its words.
#[derive(Debug)]
pub(super) struct Control<'a> {
    pub(super) machine: &'a Machine,
    pub(super) words: &'a Words,
    pub(super) options: &'a Options,
    pub(super) grid: Grid,
    pub(super) arcs: ArcRules,
    pub(super) feed: NumberFormat,
    pub(super) lead: NumberFormat,
}

/// Speed of the spindle as a program states it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Spindle {
    /// Constant cutting speed, m/min (ft/min), and the speed that is not to be exceeded, rev/min.
    Surface { speed: u32, most_rpm: u32 },
    /// rev/min.
    Rpm(u32),
    /// Number of a table of speeds.
    Code(u32),
}

impl<'a> Control<'a> {
    pub(super) fn new(machine: &'a Machine, words: &'a Words, options: &'a Options, path: &CutterPath) -> Self {
        let grid = Grid::new(words, options.unit, path.program_zero_z);
        let decimals = if words.feed_per_rev { words.feed_per_rev_decimals } else { words.feed_per_min_decimals };
        // An inch holds more than ten of the feed's counts in mm: one decimal more keeps their fineness.
        let finer = u8::from(options.unit == Unit::Inch);
        let feed = NumberFormat::feed(words, decimals + finer);
        let lead = match words.decimal_point {
            DecimalPoint::Always => grid.format,
            DecimalPoint::Never => NumberFormat::feed(words, words.feed_per_rev_decimals + finer),
        };
        let arcs = ArcRules::new(words, &machine.limits);
        Self { machine, words, options, grid, arcs, feed, lead }
    }

    pub(super) fn is_linuxcnc(&self) -> bool {
        self.machine.dialect == Dialect::Linuxcnc
    }

    /// A length, feed or lead in mm as the program's unit has it.
    pub(super) fn in_unit(&self, mm: f64) -> f64 {
        mm / self.options.unit.in_mm()
    }

    /// The spindle for a cut of which `radius` is the largest, mm: below the table's first speed its first.
    pub(super) fn spindle(&self, cut: &Cut, radius: f64) -> Spindle {
        match cut.speed {
            Speed::Surface { m_per_min, max_rpm } if self.words.surface_speed => {
                let speed = match self.options.unit {
                    Unit::Mm => m_per_min,
                    Unit::Inch => m_per_min / M_PER_FOOT,
                };
                Spindle::Surface { speed: rounded(speed), most_rpm: rounded(max_rpm.min(self.machine.rpm_limit())) }
            }
            Speed::Surface { .. } | Speed::Rpm(_) => self.fixed(cut.rpm_at(radius)),
        }
    }

    /// The spindle at a fixed speed, rev/min.
    pub(super) fn fixed(&self, rpm: f64) -> Spindle {
        let codes = &self.words.speed_codes;
        let lower = codes.iter().filter(|code| code.rpm <= rpm).max_by(|a, b| a.rpm.total_cmp(&b.rpm));
        let lowest = || codes.iter().min_by(|a, b| a.rpm.total_cmp(&b.rpm));
        lower.or_else(lowest).map_or_else(|| Spindle::Rpm(rounded(rpm)), |code| Spindle::Code(code.code))
    }

    /// The speed that the spindle really has in a cut at `radius` mm, rev/min.
    fn true_rpm(&self, cut: &Cut, radius: f64) -> f64 {
        match self.spindle(cut, radius) {
            Spindle::Code(code) => self.words.speed_codes.iter().find(|c| c.code == code).map_or(0.0, |c| c.rpm),
            Spindle::Rpm(rpm) => f64::from(rpm),
            Spindle::Surface { .. } => cut.rpm_at(radius).min(self.machine.rpm_limit()),
        }
    }

    /// Counts of the feed word of a cut of which `radius` is the largest, mm.
    pub(super) fn feed_counts(&self, cut: &Cut, radius: f64) -> i64 {
        let mm = match (cut.feed, self.words.feed_per_rev) {
            (Feed::PerRev(feed), true) | (Feed::PerMinute(feed), false) => feed,
            (Feed::PerRev(feed), false) => feed * self.true_rpm(cut, radius),
            (Feed::PerMinute(feed), true) => feed / self.true_rpm(cut, radius),
        };
        self.feed.counts(self.in_unit(mm))
    }

    /// What the feed word counts, for messages.
    pub(super) fn feed_unit(&self) -> String {
        let per = if self.words.feed_per_rev { "rev" } else { "min" };
        format!("{}/{per}", self.options.unit.symbol())
    }
}

/// The nearest whole number that a word can hold.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "`as` saturates, and no speed is below 0")]
pub(super) fn rounded(value: f64) -> u32 {
    value.round() as u32
}
