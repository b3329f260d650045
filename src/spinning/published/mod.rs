//! The published controller of 1988, exactly: parameters, tables, integer interpolation.
//!
//! Source: Mohamad 1988, chapters 5 and 6 and the modules CONEGE, CONEMC, PARAGE and PARAMC of its appendix 2.

mod parameters;
mod steps;
mod tables;

pub use parameters::{ConeParameters, Field, OutOfRange, ParabolaParameters, RollerStart};
pub use steps::{Arithmetic, PublishedPoint, cone_points, parabola_points};
pub use tables::{PARABOLA_CONSTANT_MM, PARABOLA_POINTS, form_length_pulses, parabola_ratio, tangent_ratio};

/// Travel of the carriage for one pulse of the encoder, mm: 100 pulses a turn of the 6.35 mm leadscrew.
pub const MM_PER_PULSE: f64 = 0.0635;

/// Travel of the roller for one step of the transducer, mm.
pub const MM_PER_STEP: f64 = 0.125;

/// Largest reading of the transducer, steps.
pub const LARGEST_STEP: u16 = 1023;
