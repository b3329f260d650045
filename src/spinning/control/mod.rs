//! The controller: leads the roller along set points, watches that it stays on its path, and stops when it does not.

mod controller;
mod plan;
mod watch;

pub use controller::{Controller, Phase, TraceSample};
pub use plan::{Moves, Plan, Target};
pub use watch::{StopReason, Watch};
