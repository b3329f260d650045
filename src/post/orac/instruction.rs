//! The seventeen instructions of the ORAC and their fields.
//!
//! A value is a whole number: thousandths for lengths and times, units for everything else. So texts and pages round-trip
//! exactly.

use super::number;
use std::ops::RangeInclusive;

/// One instruction of a program.
///
/// Lengths are thousandths of the program's unit (mm or inch). `x` is a radius; in the incremental format `x` and `z` are
/// moves, in the absolute format positions from the program zero.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[allow(missing_docs, reason = "the fields carry the names and meanings of `Field`")]
pub enum Instruction {
    /// Incremental format: positions are moves.
    Inc,
    /// Absolute format: positions count from the program zero.
    Abs,
    /// Lengths in mm.
    Mm,
    /// Lengths in inches.
    Inch,
    /// The tool goes to this position, from which the program counts.
    Pdat { x: i32, z: i32 },
    /// Straight move.
    Ptp { x: i32, z: i32, feed: i32, tool: i32, rpm: i32 },
    /// Move on a circular arc of at most half a turn.
    Circ { x: i32, z: i32, radius: i32, sense: Sense, feed: i32, tool: i32, rpm: i32 },
    /// Complete thread from the present position.
    Thrd { z: i32, outside_diameter: i32, base_diameter: i32, pitch: i32, cut_depth: i32, tool: i32, rpm: i32 },
    /// Wait.
    Dwel { time: i32 },
    /// Wait for an auxiliary input.
    Ixua { channel: i32 },
    /// Switch an auxiliary output.
    Oxua { channel: i32, state: i32 },
    /// Run a subroutine.
    Call { number: i32 },
    /// A subroutine begins.
    Sub { number: i32 },
    /// The subroutine ends.
    Esub,
    /// The instructions up to the matching end are run several times.
    Do { count: i32 },
    /// The loop ends.
    Edo,
    /// The program ends.
    End,
}

/// Sense of an arc, seen with z to the right and x upwards.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Sense {
    /// Clockwise.
    Cw,
    /// Counter-clockwise.
    Ccw,
}

/// The kinds of instruction: what is chosen before its fields are known.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Kind {
    /// [`Instruction::Inc`]
    Inc,
    /// [`Instruction::Abs`]
    Abs,
    /// [`Instruction::Mm`]
    Mm,
    /// [`Instruction::Inch`]
    Inch,
    /// [`Instruction::Pdat`]
    Pdat,
    /// [`Instruction::Ptp`]
    Ptp,
    /// [`Instruction::Circ`], clockwise
    CircCw,
    /// [`Instruction::Circ`], counter-clockwise
    CircCcw,
    /// [`Instruction::Thrd`]
    Thrd,
    /// [`Instruction::Dwel`]
    Dwel,
    /// [`Instruction::Ixua`]
    Ixua,
    /// [`Instruction::Oxua`]
    Oxua,
    /// [`Instruction::Call`]
    Call,
    /// [`Instruction::Sub`]
    Sub,
    /// [`Instruction::Esub`]
    Esub,
    /// [`Instruction::Do`]
    Do,
    /// [`Instruction::Edo`]
    Edo,
    /// [`Instruction::End`]
    End,
}

/// A value that an instruction carries.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Field {
    /// Radius, or change of radius.
    X,
    /// Position along the spindle, or change of it.
    Z,
    /// Radius of an arc.
    Radius,
    /// Feed per minute.
    Feed,
    /// Turret station.
    Tool,
    /// Spindle speed, rev/min.
    Rpm,
    /// Outside diameter of a thread.
    OutsideDiameter,
    /// Base (root) diameter of a thread.
    BaseDiameter,
    /// Pitch of a thread.
    Pitch,
    /// Depth of one cut of a thread, on the radius.
    CutDepth,
    /// Time, s.
    Time,
    /// Auxiliary channel.
    Channel,
    /// State of an output, 0 or 1.
    State,
    /// Number of a subroutine.
    Number,
    /// Times a loop is run.
    Count,
}

impl Field {
    /// The word in front of the value on a page.
    #[must_use]
    pub const fn label(self) -> &'static str {
        match self {
            Self::X => "X",
            Self::Z => "Z",
            Self::Radius => "RADIUS",
            Self::Feed => "FEEDRATE",
            Self::Tool => "TOOL-NO",
            Self::Rpm => "SPINDLE-SPEED",
            Self::OutsideDiameter => "OUTSIDE-DIA",
            Self::BaseDiameter => "BASE-DIA",
            Self::Pitch => "PITCH",
            Self::CutDepth => "CUT-DEPTH",
            Self::Time => "TIME",
            Self::Channel => "CHANNEL",
            Self::State => "STATE",
            Self::Number => "NUMBER",
            Self::Count => "COUNT",
        }
    }

    /// True if the value is written with three decimals and kept in thousandths.
    #[must_use]
    pub const fn is_decimal(self) -> bool {
        matches!(
            self,
            Self::X
                | Self::Z
                | Self::Radius
                | Self::OutsideDiameter
                | Self::BaseDiameter
                | Self::Pitch
                | Self::CutDepth
                | Self::Time
        )
    }

    /// Values that the number layout can hold: four digits before the point without a sign, three with one.
    #[must_use]
    pub const fn range(self) -> RangeInclusive<i32> {
        match self {
            Self::X | Self::Z => -999_999..=999_999,
            Self::Radius | Self::OutsideDiameter | Self::BaseDiameter | Self::Pitch | Self::CutDepth | Self::Time => {
                0..=9_999_999
            }
            Self::Feed | Self::Rpm => 0..=9_999,
            Self::Tool | Self::Channel | Self::Number => 0..=99,
            Self::State => 0..=1,
            Self::Count => 1..=999,
        }
    }

    /// The value as it is written, without padding.
    #[must_use]
    pub fn written(self, value: i32) -> String {
        let mut text = String::new();
        number::push(&mut text, self, value, 0);
        text
    }
}

impl Kind {
    /// All kinds, in the order of the control's manual.
    pub const ALL: [Self; 18] = [
        Self::Inc,
        Self::Abs,
        Self::Mm,
        Self::Inch,
        Self::Pdat,
        Self::Ptp,
        Self::CircCw,
        Self::CircCcw,
        Self::Thrd,
        Self::Dwel,
        Self::Ixua,
        Self::Oxua,
        Self::Call,
        Self::Sub,
        Self::Esub,
        Self::Do,
        Self::Edo,
        Self::End,
    ];

    /// The word in an instruction file.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::Inc => "INC",
            Self::Abs => "ABS",
            Self::Mm => "MM",
            Self::Inch => "IN",
            Self::Pdat => "PDAT",
            Self::Ptp => "PTP",
            Self::CircCw | Self::CircCcw => "CIRC",
            Self::Thrd => "THRD",
            Self::Dwel => "DWEL",
            Self::Ixua => "IXUA",
            Self::Oxua => "OXUA",
            Self::Call => "CALL",
            Self::Sub => "SUB",
            Self::Esub => "ESUB",
            Self::Do => "DO",
            Self::Edo => "EDO",
            Self::End => "END",
        }
    }

    /// The heading of its page.
    #[must_use]
    pub const fn heading(self) -> &'static str {
        match self {
            Self::Inc => "INCREMENTAL-FORMAT.G91",
            Self::Abs => "ABSOLUTE-FORMAT.G90",
            Self::Mm => "MM-UNITS",
            Self::Inch => "INCH-UNITS",
            Self::Pdat => "PROGRAM-DATUM",
            Self::Ptp => "POINT-TO-POINT.G00,G01",
            Self::CircCw => "CIRCULAR.G02",
            Self::CircCcw => "CIRCULAR.G03",
            Self::Thrd => "THREADING.G33",
            Self::Dwel => "DWELL.G04",
            Self::Ixua => "AUXILIARY-INPUT",
            Self::Oxua => "AUXILIARY-OUTPUT",
            Self::Call => "CALL-SUBROUTINE",
            Self::Sub => "SUBROUTINE-START",
            Self::Esub => "END-SUBROUTINE",
            Self::Do => "START-DO-LOOP",
            Self::Edo => "END-DO-LOOP",
            Self::End => "END-PROGRAM..M02",
        }
    }

    /// The word that follows the lengths in an instruction file: the sense of an arc.
    #[must_use]
    pub const fn sense_word(self) -> Option<&'static str> {
        match self {
            Self::CircCw => Some("CW"),
            Self::CircCcw => Some("CCW"),
            _ => None,
        }
    }

    /// The fields in order.
    #[must_use]
    pub const fn fields(self) -> &'static [Field] {
        use Field::{
            BaseDiameter, Channel, Count, CutDepth, Feed, Number, OutsideDiameter, Pitch, Radius, Rpm, State, Time,
            Tool, X, Z,
        };
        match self {
            Self::Inc | Self::Abs | Self::Mm | Self::Inch | Self::Esub | Self::Edo | Self::End => &[],
            Self::Pdat => &[X, Z],
            Self::Ptp => &[X, Z, Feed, Tool, Rpm],
            Self::CircCw | Self::CircCcw => &[X, Z, Radius, Feed, Tool, Rpm],
            Self::Thrd => &[Z, OutsideDiameter, BaseDiameter, Pitch, CutDepth, Tool, Rpm],
            Self::Dwel => &[Time],
            Self::Ixua => &[Channel],
            Self::Oxua => &[Channel, State],
            Self::Call | Self::Sub => &[Number],
            Self::Do => &[Count],
        }
    }

    /// The instruction with these values in the order of [`Kind::fields`]; `None` if their number is wrong.
    #[must_use]
    pub fn instruction(self, values: &[i32]) -> Option<Instruction> {
        use Instruction as I;
        let arc = |sense, &[x, z, radius, feed, tool, rpm]: &[i32; 6]| I::Circ { x, z, radius, sense, feed, tool, rpm };
        Some(match (self, values) {
            (Self::Inc, []) => I::Inc,
            (Self::Abs, []) => I::Abs,
            (Self::Mm, []) => I::Mm,
            (Self::Inch, []) => I::Inch,
            (Self::Pdat, &[x, z]) => I::Pdat { x, z },
            (Self::Ptp, &[x, z, feed, tool, rpm]) => I::Ptp { x, z, feed, tool, rpm },
            (Self::CircCw, six) => arc(Sense::Cw, six.try_into().ok()?),
            (Self::CircCcw, six) => arc(Sense::Ccw, six.try_into().ok()?),
            (Self::Thrd, &[z, outside_diameter, base_diameter, pitch, cut_depth, tool, rpm]) => {
                I::Thrd { z, outside_diameter, base_diameter, pitch, cut_depth, tool, rpm }
            }
            (Self::Dwel, &[time]) => I::Dwel { time },
            (Self::Ixua, &[channel]) => I::Ixua { channel },
            (Self::Oxua, &[channel, state]) => I::Oxua { channel, state },
            (Self::Call, &[number]) => I::Call { number },
            (Self::Sub, &[number]) => I::Sub { number },
            (Self::Esub, []) => I::Esub,
            (Self::Do, &[count]) => I::Do { count },
            (Self::Edo, []) => I::Edo,
            (Self::End, []) => I::End,
            _ => return None,
        })
    }
}

impl Instruction {
    /// Its kind.
    #[must_use]
    pub const fn kind(&self) -> Kind {
        match self {
            Self::Inc => Kind::Inc,
            Self::Abs => Kind::Abs,
            Self::Mm => Kind::Mm,
            Self::Inch => Kind::Inch,
            Self::Pdat { .. } => Kind::Pdat,
            Self::Ptp { .. } => Kind::Ptp,
            Self::Circ { sense: Sense::Cw, .. } => Kind::CircCw,
            Self::Circ { sense: Sense::Ccw, .. } => Kind::CircCcw,
            Self::Thrd { .. } => Kind::Thrd,
            Self::Dwel { .. } => Kind::Dwel,
            Self::Ixua { .. } => Kind::Ixua,
            Self::Oxua { .. } => Kind::Oxua,
            Self::Call { .. } => Kind::Call,
            Self::Sub { .. } => Kind::Sub,
            Self::Esub => Kind::Esub,
            Self::Do { .. } => Kind::Do,
            Self::Edo => Kind::Edo,
            Self::End => Kind::End,
        }
    }

    /// Its values in the order of [`Kind::fields`].
    #[must_use]
    pub fn values(&self) -> Vec<i32> {
        match *self {
            Self::Inc | Self::Abs | Self::Mm | Self::Inch | Self::Esub | Self::Edo | Self::End => Vec::new(),
            Self::Pdat { x, z } => vec![x, z],
            Self::Ptp { x, z, feed, tool, rpm } => vec![x, z, feed, tool, rpm],
            Self::Circ { x, z, radius, sense: _, feed, tool, rpm } => vec![x, z, radius, feed, tool, rpm],
            Self::Thrd { z, outside_diameter, base_diameter, pitch, cut_depth, tool, rpm } => {
                vec![z, outside_diameter, base_diameter, pitch, cut_depth, tool, rpm]
            }
            Self::Dwel { time } => vec![time],
            Self::Ixua { channel } => vec![channel],
            Self::Oxua { channel, state } => vec![channel, state],
            Self::Call { number } | Self::Sub { number } => vec![number],
            Self::Do { count } => vec![count],
        }
    }

    /// Its fields with their values.
    pub fn fields(&self) -> impl Iterator<Item = (Field, i32)> {
        self.kind().fields().iter().copied().zip(self.values())
    }

    /// Turret station that it calls, if any.
    #[must_use]
    pub const fn tool(&self) -> Option<i32> {
        match *self {
            Self::Ptp { tool, .. } | Self::Circ { tool, .. } | Self::Thrd { tool, .. } => Some(tool),
            _ => None,
        }
    }

    /// One line for people: `PTP X -0.800 Z 0.000 F 80 T1 S1262`.
    #[must_use]
    pub fn summary(&self) -> String {
        let mut line = self.kind().word().to_owned();
        for (field, value) in self.fields() {
            let before = match field {
                Field::Radius => " R ",
                Field::Feed => " F ",
                Field::Tool => " T",
                Field::Rpm => " S",
                Field::Number | Field::Count | Field::Channel => " ",
                _ => {
                    line.push(' ');
                    line.push_str(field.label());
                    " "
                }
            };
            line.push_str(before);
            number::push(&mut line, field, value, 0);
        }
        if let Some(sense) = self.kind().sense_word() {
            line.push(' ');
            line.push_str(sense);
        }
        line
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use proptest::prelude::*;

    /// Any instruction whose values fit the number layout.
    pub(in crate::post::orac) fn any_instruction() -> impl Strategy<Value = Instruction> {
        (0..Kind::ALL.len()).prop_flat_map(|k| {
            let kind = Kind::ALL[k];
            let values: Vec<_> = kind.fields().iter().map(|f| f.range()).collect();
            values.prop_map(move |v| kind.instruction(&v).unwrap())
        })
    }

    proptest! {
        #[test]
        fn kind_and_values_make_the_instruction_again(instruction in any_instruction()) {
            prop_assert_eq!(instruction.kind().instruction(&instruction.values()), Some(instruction));
        }
    }

    #[test]
    fn small_negative_values_keep_their_sign_and_zero_has_none() {
        assert_eq!(Field::X.written(-5), "-0.005");
        assert_eq!(Field::X.written(0), "0.000");
    }

    #[test]
    fn a_summary_reads_like_the_instruction() {
        let line = Instruction::Ptp { x: -800, z: 0, feed: 80, tool: 1, rpm: 1262 };
        assert_eq!(line.summary(), "PTP X -0.800 Z 0.000 F 80 T1 S1262");
    }
}
