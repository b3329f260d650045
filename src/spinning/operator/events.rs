//! What happens to the sequence, and what it wants done.

use super::job::Job;

/// A key of the operator's keyboard.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Key {
    /// The space bar.
    Space,
    /// Return.
    Return,
    /// Deletes one digit.
    Delete,
    /// A letter or digit.
    Char(char),
    /// Emergency stop.
    Emergency,
}

/// Something that happens to the sequence.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Event {
    /// A key was pressed.
    Key(Key),
    /// The datum switch is closed.
    AtDatum,
    /// The run has ended as planned.
    Completed,
    /// The run was stopped by the controller, with its reason.
    Stopped(String),
    /// The rig cannot be reached: what it does is not known.
    Lost(String),
}

/// What the sequence wants done.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Command {
    /// Ring the bell: the key means nothing here.
    Bell,
    /// Start the oil pump.
    StartPump,
    /// Draw the roller back until the datum switch closes.
    SeekDatum,
    /// Run a job.
    Run(Job),
    /// Draw the roller back and switch everything off.
    EmergencyStop,
}
