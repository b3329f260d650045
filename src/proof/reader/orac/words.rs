//! The words of the control: its 17 instructions and the values that each one carries.

use serde::Serialize;

/// An instruction of the control.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Op {
    /// Moves are increments from here on.
    Incremental,
    /// Moves are positions from the program zero from here on.
    Absolute,
    /// Lengths are millimetres from here on.
    Millimetre,
    /// Lengths are inches from here on.
    Inch,
    /// The tool goes to this position, which becomes the known one.
    Datum,
    /// Straight move.
    Straight,
    /// Move on an arc of at most half a turn.
    Arc,
    /// Complete threading cycle.
    Thread,
    /// Wait for a time.
    Dwell,
    /// Wait for an outside signal.
    Input,
    /// Set an outside signal.
    Output,
    /// Run a subroutine.
    Call,
    /// Start of a subroutine.
    Sub,
    /// End of a subroutine.
    EndSub,
    /// Start of a loop.
    Do,
    /// End of a loop.
    EndDo,
    /// End of the program.
    End,
}

/// A value of an instruction.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Word {
    /// Radius, or its change.
    X,
    /// Position along the spindle, or its change.
    Z,
    /// Radius of an arc.
    Radius,
    /// Sense of an arc: 2 clockwise (G02), 3 counter-clockwise (G03).
    Sense,
    /// Feed per minute.
    Feed,
    /// Turret station.
    Tool,
    /// Spindle speed, rev/min.
    Speed,
    /// Outside diameter of a thread.
    Outside,
    /// Base diameter of a thread.
    Base,
    /// Pitch of a thread.
    Pitch,
    /// Depth of one threading cut, on the radius.
    Depth,
    /// Time, s.
    Seconds,
    /// Number of an outside signal.
    Channel,
    /// State of an outside signal, 0 or 1.
    State,
    /// Number of a subroutine.
    Number,
    /// How often a loop runs.
    Count,
}

/// Every instruction.
const ALL: [Op; 17] = [
    Op::Incremental,
    Op::Absolute,
    Op::Millimetre,
    Op::Inch,
    Op::Datum,
    Op::Straight,
    Op::Arc,
    Op::Thread,
    Op::Dwell,
    Op::Input,
    Op::Output,
    Op::Call,
    Op::Sub,
    Op::EndSub,
    Op::Do,
    Op::EndDo,
    Op::End,
];

/// Sense of a clockwise arc, as in G02.
pub(crate) const CLOCKWISE: f64 = 2.0;
/// Sense of a counter-clockwise arc, as in G03.
pub(crate) const COUNTER_CLOCKWISE: f64 = 3.0;
/// Page header of a clockwise arc; every other instruction has one header.
const CLOCKWISE_HEADER: &str = "CIRCULAR.G02";

impl Op {
    /// The instruction of a mnemonic such as `PTP`, in capitals.
    #[must_use]
    pub fn from_mnemonic(text: &str) -> Option<Self> {
        ALL.into_iter().find(|op| op.mnemonic() == text)
    }

    /// The instruction of a page header in capitals without blanks, and the sense if it is an arc's.
    #[must_use]
    pub fn from_header(text: &str) -> Option<(Self, Option<f64>)> {
        if text == CLOCKWISE_HEADER {
            return Some((Self::Arc, Some(CLOCKWISE)));
        }
        let op = ALL.into_iter().find(|op| op.header() == text)?;
        Some((op, (op == Self::Arc).then_some(COUNTER_CLOCKWISE)))
    }

    /// Name in instruction files.
    #[must_use]
    pub const fn mnemonic(self) -> &'static str {
        match self {
            Self::Incremental => "INC",
            Self::Absolute => "ABS",
            Self::Millimetre => "MM",
            Self::Inch => "IN",
            Self::Datum => "PDAT",
            Self::Straight => "PTP",
            Self::Arc => "CIRC",
            Self::Thread => "THRD",
            Self::Dwell => "DWEL",
            Self::Input => "IXUA",
            Self::Output => "OXUA",
            Self::Call => "CALL",
            Self::Sub => "SUB",
            Self::EndSub => "ESUB",
            Self::Do => "DO",
            Self::EndDo => "EDO",
            Self::End => "END",
        }
    }

    const fn header(self) -> &'static str {
        match self {
            Self::Incremental => "INCREMENTAL-FORMAT.G91",
            Self::Absolute => "ABSOLUTE-FORMAT.G90",
            Self::Millimetre => "MM-UNITS",
            Self::Inch => "INCH-UNITS",
            Self::Datum => "PROGRAM-DATUM",
            Self::Straight => "POINT-TO-POINT.G00,G01",
            Self::Arc => "CIRCULAR.G03",
            Self::Thread => "THREADING.G33",
            Self::Dwell => "DWELL.G04",
            Self::Input => "AUXILIARY-INPUT",
            Self::Output => "AUXILIARY-OUTPUT",
            Self::Call => "CALL-SUBROUTINE",
            Self::Sub => "SUBROUTINE-START",
            Self::EndSub => "END-SUBROUTINE",
            Self::Do => "START-DO-LOOP",
            Self::EndDo => "END-DO-LOOP",
            Self::End => "END-PROGRAM..M02",
        }
    }

    /// The values that it carries, in the order of the text.
    #[must_use]
    pub const fn words(self) -> &'static [Word] {
        match self {
            Self::Datum => &[Word::X, Word::Z],
            Self::Straight => &[Word::X, Word::Z, Word::Feed, Word::Tool, Word::Speed],
            Self::Arc => &[Word::X, Word::Z, Word::Radius, Word::Sense, Word::Feed, Word::Tool, Word::Speed],
            Self::Thread => &[Word::Z, Word::Outside, Word::Base, Word::Pitch, Word::Depth, Word::Tool, Word::Speed],
            Self::Dwell => &[Word::Seconds],
            Self::Input => &[Word::Channel],
            Self::Output => &[Word::Channel, Word::State],
            Self::Call | Self::Sub => &[Word::Number],
            Self::Do => &[Word::Count],
            _ => &[],
        }
    }
}

impl Word {
    /// Name on a page, which is also its name in messages.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::X => "X",
            Self::Z => "Z",
            Self::Radius => "RADIUS",
            Self::Sense => "G",
            Self::Feed => "FEEDRATE",
            Self::Tool => "TOOL-NO",
            Self::Speed => "SPINDLE-SPEED",
            Self::Outside => "OUTSIDE-DIA",
            Self::Base => "BASE-DIA",
            Self::Pitch => "PITCH",
            Self::Depth => "CUT-DEPTH",
            Self::Seconds => "TIME",
            Self::Channel => "CHANNEL",
            Self::State => "STATE",
            Self::Number => "NUMBER",
            Self::Count => "COUNT",
        }
    }

    /// True if its value must be a whole number that is not negative.
    #[must_use]
    pub const fn is_whole(self) -> bool {
        matches!(self, Self::Tool | Self::Channel | Self::State | Self::Number | Self::Count | Self::Sense)
    }
}
