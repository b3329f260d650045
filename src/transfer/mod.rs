//! Programs over the wire: links, protocols, the virtual lathe.
//!
//! | module | duty |
//! |---|---|
//! | [`sender`], [`receiver`] | pure state machines of every protocol: bytes and times in, bytes and verdicts out |
//! | [`protocol`] | what the protocols differ in, behind one door |
//! | `orac`, `fanuc` | one protocol each: what goes out, what comes in, what is compared |
//! | [`job`] | the worker that drives one transfer: progress, log, abort, exactly one [`Outcome`] |
//! | [`link`] | what bytes travel over: a serial port or a pipe in this process |
//! | [`ports`](mod@ports) | what can be chosen as a target, and opening it |
//! | `folder` | programs for controls that read them from a folder |
//! | [`virtual_lathe`] | a control without metal, with a fault switch |
//! | [`rig`] | a flow-turning rig behind a line: protocol, host, simulated device |
//! | [`compare`](mod@compare) | what was sent against what came back, page by page or block by block |
//! | [`commands`] | `send`, `receive` and `lathe` for the command line |
//!
//! A transfer is never called verified before the program came back from the control and compared equal.

pub mod commands;
pub mod compare;
mod fanuc;
mod folder;
pub mod job;
pub mod line;
pub mod link;
pub mod log;
mod orac;
mod port_thread;
pub mod ports;
pub mod protocol;
pub mod receiver;
pub mod rig;
pub mod sender;
#[cfg(feature = "serial")]
mod serial;
pub mod virtual_lathe;

pub use compare::{Blanks, Difference};
pub use job::{Event, Job, Outcome, Progress, Request, State, Task, Timing};
pub use link::Link;
pub use ports::{Port, PortChoice, Target, ports, serial_ports};
