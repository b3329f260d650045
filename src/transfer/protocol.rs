//! What the protocols differ in, behind one door: how a text goes out, how it comes in, how it is compared.

use super::compare::{Blanks, Difference};
use super::log::visible;
use super::receiver::Frame;
use super::{fanuc, orac};
use crate::machine::{DC4, Protocol};

/// Why a text is not sent at all.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum Refused {
    /// The settings of the line are impossible.
    #[error("{0}")]
    Line(String),
    /// A character that seven bits cannot carry.
    #[error(
        "Line {line}, character {column}: `{character}` is character {}; only characters up to 127 can be sent. \
         Replace it.", u32::from(*character)
    )]
    NotSevenBit {
        /// Line from 1.
        line: usize,
        /// Character within the line, from 1.
        column: usize,
        /// The character.
        character: char,
    },
    /// A control character that would end the transfer or confuse the control.
    #[error(
        "Line {line}, character {column}: {} is the control character {value}; a program may hold {allowed} only. \
         Remove it.", visible(*value)
    )]
    ControlCharacter {
        /// Line from 1.
        line: usize,
        /// Character within the line, from 1.
        column: usize,
        /// Its value.
        value: u8,
        /// What is allowed.
        allowed: &'static str,
    },
    /// The text is not a page file.
    #[error(
        "The text does not begin with a page mark (character {page_start}): it is no page file. Assemble the program \
         to pages first."
    )]
    NoPages {
        /// The page mark.
        page_start: u8,
    },
    /// A character that the control's code does not have.
    #[error("Line {line}, character {column}: `{character}` {why}.")]
    NotInCode {
        /// Line from 1.
        line: usize,
        /// Character within the line, from 1.
        column: usize,
        /// The character.
        character: char,
        /// What is wrong with it and what to do.
        why: &'static str,
    },
    /// There is nothing to send.
    #[error("The text holds no program: there is no block in it.")]
    Empty,
}

/// A text as it goes over the wire.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Outgoing {
    /// The bytes, marks included.
    pub bytes: Vec<u8>,
    /// Where the blocks or pages begin, in ascending order.
    pub block_starts: Vec<usize>,
}

/// Checks a whole text and makes the bytes that go out.
///
/// # Errors
/// [`Refused`] with place and value.
pub fn outgoing(text: &str, protocol: Protocol) -> Result<Outgoing, Refused> {
    match protocol {
        Protocol::OracPages(marks) => orac::outgoing(text, marks),
        Protocol::FanucReaderPunch(habits) => fanuc::outgoing(text, habits),
    }
}

/// What finds the program in what comes in.
pub(super) fn frame(protocol: Protocol) -> Box<dyn Frame> {
    match protocol {
        Protocol::OracPages(marks) => Box::new(orac::PageFrame::new(marks)),
        Protocol::FanucReaderPunch(_) => Box::new(fanuc::PunchFrame::default()),
    }
}

/// The character that ends what comes in.
#[must_use]
pub const fn end_mark(protocol: Protocol) -> u8 {
    match protocol {
        Protocol::OracPages(marks) => marks.end,
        Protocol::FanucReaderPunch(_) => DC4,
    }
}

/// The text of a program as it came in: line feeds for the control's ends of blocks, without what only the wire needs.
#[must_use]
pub fn text_of(received: String, protocol: Protocol) -> String {
    match protocol {
        Protocol::OracPages(_) => received,
        Protocol::FanucReaderPunch(habits) => fanuc::text_of(&received, habits),
    }
}

/// What is wrong with the form of a program as it came in, in sentences; empty if it is well-formed.
#[must_use]
pub fn problems(received: &str, protocol: Protocol) -> Vec<String> {
    match protocol {
        Protocol::OracPages(marks) => orac::pages::problems(received, marks.page_start),
        Protocol::FanucReaderPunch(habits) => fanuc::problems(received, habits),
    }
}

/// Compares a text that was sent with what came in; no differences means that the control holds what was sent.
#[must_use]
pub fn compare(sent: &str, received: &str, protocol: Protocol, blanks: Blanks) -> Vec<Difference> {
    match protocol {
        Protocol::OracPages(marks) => orac::compare(sent, received, marks, blanks),
        Protocol::FanucReaderPunch(habits) => fanuc::compare(sent, received, habits, blanks),
    }
}
