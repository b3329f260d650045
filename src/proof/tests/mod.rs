//! Hand-made programs with known answers.

mod bench_lathe;
mod running;

use super::*;
use bench_lathe::*;
