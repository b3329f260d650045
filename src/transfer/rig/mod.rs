//! A rig behind a serial line: a microcontroller takes the set points down and tells positions up.
//!
//! # The line protocol
//!
//! Lines of ASCII end with a line feed; a carriage return before it is ignored. Every line begins with one letter and ends
//! with `*` and two hexadecimal digits: the exclusive-or of all bytes before the `*`. Figures are decimal. The device
//! answers every line of the host with one line.
//!
//! | host | answer | meaning |
//! |---|---|---|
//! | `H` | `H turnwright-rig 1` | who is there, version of the protocol |
//! | `B n roller advance retract limit speed` | `K n` | a table of n set points follows; reading at which the roller begins (steps), valve codes, limit off the path (µm; 0: nothing is watched), speed of the carriage (µm/s) |
//! | `S i pulses steps` | `K i` | set point i, from 0, in order |
//! | `G` | `K n` | go; only with a complete table |
//! | `Z` | `K 0` | draw the roller back to its datum; not while a run goes on |
//! | `Q` | `P …` | tell the position |
//! | `Y` | `Y word value limit` | why the last run stopped |
//! | `X` | `K 0` | emergency stop: draw back, lathe and pump off |
//!
//! | device | meaning |
//! |---|---|
//! | `P ms pulses steps state` | time since the run began (ms), carriage (pulses), roller's reading (steps), state: `I` idle, `T` to datum, `A` advance, `U` run-up, `F` follow, `R` retract, `W` waits for the leadscrew, `C` completed, `X` stopping, `D` stopped and drawn back, `N` stopped and not drawn back |
//! | `E code` | the line before was not understood or not allowed: `sum`, `line`, `order`, `table`, `range` |
//!
//! A line that is damaged is answered with `E sum` and may be sent again: set points are numbered, so a repeated one does
//! no harm. A device that hears nothing for two seconds while it runs stops as on `X`.
//!
//! Words of `Y`: `none`; `emergency`; `silence` (nothing was heard); `path` (µm off the path, positive towards the axis);
//! `carriage` (µm counted less µm expected); `creep` (µm that readings drift with the valve shut); `late` (ms waited); `reach`
//! (reading asked for). Value and limit are 0 where there are none.
//!
//! The line: 115,200 bit/s, eight data bits, no parity, one stop bit, no flow control ([`profile`]).

mod device;
mod frame;
mod host;
mod line;
#[cfg(all(unix, feature = "serial"))]
mod pty;
mod remote;
mod why;

pub use device::Device;
pub use frame::{Frame, FrameError};
pub use host::{Host, HostError, Position};
pub use line::{RigEvent, RigLine, profile};
#[cfg(all(unix, feature = "serial"))]
pub use pty::run_on_pty;
pub use remote::{RemoteEnd, RemoteRun};
pub use why::Why;
