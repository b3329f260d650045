//! The operator's sequence as a pure state machine: keys and events in, commands and a screen out.
//!
//! Order and rules: Mohamad 1988, modules INITIA, SETUP, SHAPE, CONEGE, PARAGE, CONEMC and PARAMC. A wrong entry rings the
//! bell, says what is expected and leaves the question open. Besides the published cone and parabola the shell of the
//! document can be run.

mod events;
mod job;
mod prompts;
mod screen;
mod sequence;

pub use events::{Command, Event, Key};
pub use job::Job;
pub use screen::{Choice, Screen};
pub use sequence::Sequence;
