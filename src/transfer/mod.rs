//! Programs over the wire: links, protocols, the virtual lathe.
//!
//! | module | duty |
//! |---|---|
//! | [`orac`] | the protocol as pure state machines: bytes and times in, bytes and verdicts out |
//! | [`job`] | the worker that drives one transfer: progress, log, abort, exactly one [`Outcome`] |
//! | [`link`] | what bytes travel over: a serial port or a pipe in this process |
//! | [`ports`](mod@ports) | what can be chosen as a port, and opening it |
//! | [`virtual_lathe`] | a lathe without metal, with a fault switch |
//! | [`compare`](mod@compare) | what was sent against what came back, page by page |
//! | [`commands`] | `send`, `receive` and `lathe` for the command line |
//!
//! A transfer is never called verified before the program came back from the control and compared equal.

pub mod commands;
pub mod compare;
pub mod job;
pub mod line;
pub mod link;
pub mod log;
pub mod orac;
pub mod pages;
mod port_thread;
pub mod ports;
#[cfg(feature = "serial")]
mod serial;
pub mod virtual_lathe;

pub use compare::{Blanks, Difference, compare};
pub use job::{Event, Job, Outcome, Progress, Request, State, Task, Timing};
pub use link::Link;
pub use ports::{Port, PortChoice, ports};
