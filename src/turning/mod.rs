//! Generators and planners: from a set-up of a part to cutter location data.

mod cutter_path;
pub mod published;

pub use cutter_path::{CutMove, CutterPath, Operation, OperationKind};
