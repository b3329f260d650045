//! Hand-made programs with known answers.

mod bench_lathe;
mod cutting;
mod mutation;
mod queen;
mod running;
mod words;

use super::*;
use crate::geometry::{Contour, Point, Segment};
pub(in crate::proof) use bench_lathe::*;
