//! How a control writes its words: everything in which word-address controls differ, as data.
//!
//! The list follows what the MTIRA turning processor (1977) asked about a control: absolute or incremental moves, arc
//! centres absolute or incremental and with or without sign, the length of every word, zeros, constant cutting speed or a
//! table of speeds.

use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// The words of a control, table `[words]` of a machine file.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[allow(clippy::struct_excessive_bools, reason = "each is a choice of the control's maker, independent of the others")]
pub struct Words {
    /// X (and U) is a diameter; otherwise a radius. I is a radius either way.
    pub x_is_diameter: bool,
    /// 1, or −1 if X is written negative because the tool stands on the far side of the axis.
    #[serde(default = "one")]
    pub x_sign: i8,
    /// Decimal places of lengths in mm.
    pub decimals_mm: u8,
    /// Decimal places of lengths in inches.
    pub decimals_inch: u8,
    /// Whether numbers that may have decimal places carry a point.
    pub decimal_point: DecimalPoint,
    /// Which zeros a length without decimal point may lose.
    #[serde(default)]
    pub zeros: Zeros,
    /// Digits of a length before the point, at most.
    pub digits_before: u8,
    /// Decimal places of a feed per turn, in mm (or inches).
    pub feed_per_rev_decimals: u8,
    /// Decimal places of a feed per minute, in mm (or inches).
    pub feed_per_min_decimals: u8,
    /// Number of digits of whole-number words by address letter, such as `G = { least = 2, most = 2 }`; a word that is not
    /// named has as many as it needs.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub digits: BTreeMap<char, Digits>,
    /// Moves are written as displacements U and W; otherwise as positions X and Z.
    #[serde(default)]
    pub incremental: bool,
    /// How an arc says where its centre is.
    pub arc_center: ArcCenter,
    /// I and K carry a sign; otherwise they are magnitudes: the control finds the quadrant of increments, and takes positions
    /// as positive.
    #[serde(default = "yes")]
    pub arc_center_signed: bool,
    /// G2 is counter-clockwise seen with z to the right and r (always positive) upwards.
    pub g2_is_ccw: bool,
    /// The control keeps a constant cutting speed (G96).
    pub surface_speed: bool,
    /// The S words of a control that has steps of speed, with their speeds; without any, S is rev/min.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub speed_codes: Vec<SpeedCode>,
    /// The control feeds per turn of the spindle; otherwise per minute only.
    pub feed_per_rev: bool,
    /// N words; none without.
    #[serde(default)]
    pub sequence_numbers: Option<SequenceNumbers>,
    /// The word that names a program at its head; none without.
    #[serde(default)]
    pub program_number: Option<ProgramNumber>,
    /// A program begins and ends with a line `%`.
    pub tape_marks: bool,
    /// A blank stands between words.
    #[serde(default)]
    pub word_space: bool,
    /// Extension of program files, without the dot.
    #[serde(default = "usual_extension")]
    pub extension: String,
    /// What ends a block in the text.
    #[serde(default = "line_feed")]
    pub block_end: String,
    /// Characters that a block may have, its end not counted; no limit without.
    #[serde(default)]
    pub max_line_chars: Option<usize>,
    /// Characters that a program may have; no limit without.
    #[serde(default)]
    pub max_program_chars: Option<usize>,
    /// How comments are written.
    pub comments: Comments,
    /// How a tool is called.
    pub tool_word: ToolWord,
    /// How the highest speed under constant cutting speed is given; none without.
    #[serde(default)]
    pub clamp_word: Option<ClampWord>,
    /// The clamp is written only for operations that would turn faster; otherwise for all with constant cutting speed.
    #[serde(default)]
    pub clamp_where_reached: bool,
    /// How the control learns where the program zero is.
    pub preset: Preset,
    /// At most one M word stands in a block.
    #[serde(default = "yes")]
    pub one_m_per_block: bool,
    /// Codes of coolant, spindle and program.
    #[serde(default)]
    pub codes: Codes,
    /// How a threading pass is written.
    pub thread: ThreadWord,
    /// How the start angle of a threading pass is written; without it the pass starts further away instead.
    #[serde(default)]
    pub thread_angle: Option<ThreadAngle>,
    /// How a dwell is written.
    pub dwell: DwellWord,
    /// Programs may use the control's own roughing, finishing and threading cycles (G71, G70, G76).
    #[serde(default)]
    pub canned_cycles: bool,
}

/// Decimal points in numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum DecimalPoint {
    /// Always written, as most controls read a number without one in least increments.
    Always,
    /// Never: numbers count least increments.
    Never,
}

/// Zeros of a number without decimal point.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Zeros {
    /// All digits of the format are written.
    #[default]
    Keep,
    /// Zeros in front are left out.
    DropLeading,
    /// Zeros at the end are left out; the control counts from the front.
    DropTrailing,
}

/// How an arc says where its centre is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum ArcCenter {
    /// I and K from the arc's start.
    Incremental,
    /// I and K from the program zero.
    Absolute,
    /// The radius, R.
    Radius,
}

/// Digits of a whole-number word.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Digits {
    /// Zeros in front fill the word up to so many.
    pub least: u8,
    /// More do not fit.
    pub most: u8,
}

/// One step of a spindle with a table of speeds.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SpeedCode {
    /// Number after S.
    pub code: u32,
    /// Speed, rev/min.
    pub rpm: f64,
}

/// N words.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SequenceNumbers {
    /// Number of the first block.
    pub first: u32,
    /// Difference from block to block.
    pub step: u32,
    /// Digits written at least, with zeros in front.
    #[serde(default = "one_digit")]
    pub digits: u8,
}

/// The word that names a program.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ProgramNumber {
    /// What stands before the number: `O`.
    pub prefix: String,
    /// Digits, with zeros in front.
    pub digits: u8,
    /// Number of the first program, where the document names none.
    pub first: u32,
}

/// Comments in programs.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Comments {
    /// `(TEXT)`.
    Parentheses,
    /// The control knows none.
    None,
}

/// How a tool is called.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum ToolWord {
    /// `T0203`: station 2 with offset 3; `T0200` takes the offset off.
    #[serde(rename = "TxxYY")]
    StationAndOffset,
    /// `T2 M6 G43`.
    #[serde(rename = "T M6 G43")]
    Change,
}

/// How the highest speed under constant cutting speed is given.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum ClampWord {
    /// `G50 S3000`.
    #[serde(rename = "G50 S")]
    G50,
    /// `G92 S3000`.
    #[serde(rename = "G92 S")]
    G92,
    /// `G96 D3000 S200`.
    #[serde(rename = "D on G96")]
    OnG96,
}

/// How the control learns where the program zero is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Preset {
    /// Every tool's change position is given with G50 before its call.
    G50,
    /// A work offset, G54.
    G54,
    /// The operator sets it; the program says nothing.
    None,
}

/// How a threading pass is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum ThreadWord {
    /// `G32 X Z F`, F the lead.
    G32,
    /// `G33 X Z K`, K the lead.
    G33,
}

/// How the start angle of a threading pass is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum ThreadAngle {
    /// `Q180000`, thousandths of a degree.
    QMillidegrees,
}

/// How a dwell is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum DwellWord {
    /// `G4 P1500`, milliseconds.
    PMilliseconds,
    /// `G4 P1.5`, seconds.
    PSeconds,
    /// `G4 X1.5`, seconds, as a length is written.
    XSeconds,
}

/// Codes of coolant, spindle and program; a code that the control lacks is left out of its programs.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Codes {
    /// Words that follow G21 or G20 in the first block: `G18 G40 G80 G99`. On `LinuxCNC` those that its programs need come
    /// first by themselves.
    #[serde(skip_serializing_if = "String::is_empty")]
    pub start: String,
    /// Blocks that take the tool to a safe place from wherever it is, such as `G28 U0.` and `G28 W0.`: at the start and
    /// after every operation.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub retract: Vec<String>,
    /// Coolant on.
    pub coolant_on: Option<String>,
    /// Coolant off.
    pub coolant_off: Option<String>,
    /// Spindle on in the direction for tools that cut with their face up on this turret.
    pub spindle_on: String,
    /// Spindle on the other way round.
    pub spindle_reverse: String,
    /// Spindle off, after every operation.
    pub spindle_stop: Option<String>,
    /// Stop if the operator wants it, between operations.
    pub optional_stop: Option<String>,
    /// Program end with return to its beginning.
    pub program_end: String,
}

impl Default for Codes {
    /// Codes that ISO 6983 gives to what no program does without: M03, M04, M30. What a control lacks is not printed.
    fn default() -> Self {
        Self {
            start: String::new(),
            retract: Vec::new(),
            coolant_on: None,
            coolant_off: None,
            spindle_on: "M03".to_owned(),
            spindle_reverse: "M04".to_owned(),
            spindle_stop: None,
            optional_stop: None,
            program_end: "M30".to_owned(),
        }
    }
}

impl Words {
    /// What X says at `radius` mm, in mm: sign and diameter as the control wants them.
    #[must_use]
    pub fn x_at(&self, radius: f64) -> f64 {
        radius * self.x_per_radius()
    }

    /// The radius at which X says `x`, mm; negative beyond the axis.
    #[must_use]
    pub fn radius_at(&self, x: f64) -> f64 {
        x / self.x_per_radius()
    }

    fn x_per_radius(&self) -> f64 {
        f64::from(self.x_sign) * if self.x_is_diameter { 2.0 } else { 1.0 }
    }
}

const fn one() -> i8 {
    1
}

const fn one_digit() -> u8 {
    1
}

const fn yes() -> bool {
    true
}

fn usual_extension() -> String {
    "nc".to_owned()
}

fn line_feed() -> String {
    "\n".to_owned()
}
