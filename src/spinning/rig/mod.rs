//! A rig: a lathe with a carriage that is read by an encoder, and a hydraulic roller that is read by a transducer.
//!
//! Source of the hardware: Mohamad 1988, chapters 4 and 5.

mod faults;
mod model;
mod simulated;
pub mod valve;

pub use faults::Fault;
pub use model::RigModel;
pub use simulated::SimulatedRig;

/// What a rig tells at one moment.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Reading {
    /// Time since the rig was switched on, s.
    pub time_s: f64,
    /// Encoder pulses of the carriage since the counter was reset.
    pub pulses: u32,
    /// Transducer steps of the roller; grows towards the axis.
    pub steps: u16,
    /// The roller has closed the datum switch: it is drawn back.
    pub at_datum: bool,
    /// The carriage has closed the switch at the former's tip.
    pub at_tip: bool,
}

/// A rig that can be driven. Reading takes time; commands take effect at once.
pub trait Rig {
    /// Reads encoder, transducer and switches.
    fn read(&mut self) -> Reading;
    /// Sets the valve by its code: 128 stands, more advances towards the axis, less retracts.
    fn set_valve(&mut self, code: u8);
    /// Switches the spindle, and with it the carriage feed.
    fn set_lathe(&mut self, on: bool);
    /// Switches the oil pump.
    fn set_pump(&mut self, on: bool);
    /// Sets the carriage counter to 0.
    fn reset_counter(&mut self);
}
