//! A program in what a control punches.

use super::TAPE_MARK;
use crate::machine::{DC2, DC4};
use crate::transfer::log::visible;
use crate::transfer::receiver::{Frame, Taken, is_filling};

/// Finds DC2, `%`, the blocks, `%`, DC4, with filling before the first and after the last `%`.
#[derive(Debug, Default)]
pub(in crate::transfer) struct PunchFrame {
    place: Place,
    has_blocks: bool,
}

#[derive(Debug, Clone, Copy, Default)]
enum Place {
    #[default]
    /// Before the first `%`.
    Leader,
    /// Between it and the first end of block, which the control skips.
    Label,
    Program,
    Trailer,
}

impl Frame for PunchFrame {
    fn take(&mut self, byte: u8, _: &str) -> Taken {
        match self.place {
            Place::Leader => self.leader(byte),
            Place::Label | Place::Program => self.tape(byte),
            Place::Trailer => self.trailer(byte),
        }
    }
}

const NO_PROGRAM: &str = "The control punched an empty tape: it holds no program of this number.";

impl PunchFrame {
    fn leader(&mut self, byte: u8) -> Taken {
        match byte {
            DC4 => Taken::Wrong(NO_PROGRAM.to_owned()),
            _ if byte == TAPE_MARK as u8 => {
                self.place = Place::Label;
                Taken::Kept
            }
            _ if is_filling(byte) => Taken::Skipped,
            _ => Taken::Wrong(format!(
                "What came begins with `{}` instead of %: its beginning was lost, or this is no program.",
                visible(byte)
            )),
        }
    }

    fn tape(&mut self, byte: u8) -> Taken {
        match byte {
            b'\n' if matches!(self.place, Place::Label) => {
                self.place = Place::Program;
                Taken::Kept
            }
            b'\n' => Taken::KeptMark,
            b'\r' | 0 => Taken::Kept,
            DC4 => Taken::Wrong("The control ended its punch (DC4) before the closing %.".to_owned()),
            DC2 => Taken::Wrong("The control began a new punch (DC2) before the closing % of the last.".to_owned()),
            _ if byte == TAPE_MARK as u8 => {
                self.place = Place::Trailer;
                Taken::Kept
            }
            _ if byte.is_ascii_control() => {
                let sign = visible(byte);
                Taken::Wrong(format!("The control character {sign} ({byte}) came, which no program holds."))
            }
            _ => {
                self.has_blocks |= matches!(self.place, Place::Program);
                Taken::Kept
            }
        }
    }

    fn trailer(&self, byte: u8) -> Taken {
        match byte {
            DC4 if self.has_blocks => Taken::Ended,
            DC4 => Taken::Wrong(NO_PROGRAM.to_owned()),
            _ if byte != DC2 && is_filling(byte) => Taken::Skipped,
            _ => Taken::Wrong(format!("`{}` came after the closing %: a % inside the program?", visible(byte))),
        }
    }
}
