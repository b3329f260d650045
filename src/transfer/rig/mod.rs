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
//! | `Q` | `P …` | tell the position |
//! | `X` | `K 0` | emergency stop: draw back, lathe and pump off |
//!
//! | device | meaning |
//! |---|---|
//! | `P ms pulses steps state` | time since the run began (ms), carriage (pulses), roller's reading (steps), state: `I` idle, `T` to datum, `A` advance, `U` run-up, `F` follow, `R` retract, `W` waits for the leadscrew, `C` completed, `X` stopping, `D` stopped and drawn back, `N` stopped and not drawn back |
//! | `E code` | the line before was not understood or not allowed: `sum`, `line`, `order`, `table`, `range` |
//!
//! A line that is damaged is answered with `E sum` and may be sent again: set points are numbered, so a repeated one does
//! no harm. A device that hears nothing for two seconds while it runs stops as on `X`.

mod device;
mod frame;
mod host;

pub use device::Device;
pub use frame::{Frame, FrameError};
pub use host::{Host, HostError, Position};
