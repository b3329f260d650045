//! A rig without metal, with its own time.

use super::faults::Fault;
use super::model::RigModel;
use super::valve::{self, STOP};
use super::{Reading, Rig};
use crate::spinning::published::{LARGEST_STEP, MM_PER_PULSE, MM_PER_STEP};

/// The datum switch closes below this place of the roller, mm.
const DATUM_MM: f64 = 0.25;
/// Stroke of the transducer, mm.
const STROKE_MM: f64 = 127.9;

/// Encoder, transducer, valve, carriage and switches, each as slow and as wrong as the published ones.
#[derive(Debug, Clone)]
pub struct SimulatedRig {
    model: RigModel,
    faults: Vec<Fault>,
    time_s: f64,
    /// Carriage travel since it was engaged, mm.
    carriage_mm: f64,
    /// Carriage travel at which the counter was reset, mm.
    counted_from_mm: f64,
    roller_mm: f64,
    roller_mm_per_s: f64,
    code: u8,
    lathe: bool,
    pump: bool,
}

impl SimulatedRig {
    /// A rig at rest, its roller drawn back and its carriage at the start.
    #[must_use]
    pub const fn new(model: RigModel, faults: Vec<Fault>) -> Self {
        Self {
            model,
            faults,
            time_s: 0.0,
            carriage_mm: 0.0,
            counted_from_mm: 0.0,
            roller_mm: 10.0,
            roller_mm_per_s: 0.0,
            code: STOP,
            lathe: false,
            pump: false,
        }
    }

    /// Time since the rig was switched on, s.
    #[must_use]
    pub const fn time_s(&self) -> f64 {
        self.time_s
    }

    /// True travel of the carriage past the former's tip, mm; negative before it.
    #[must_use]
    pub fn carriage_mm(&self) -> f64 {
        self.carriage_mm - self.model.run_up_mm
    }

    /// True place of the roller, mm, growing towards the axis.
    #[must_use]
    pub const fn roller_mm(&self) -> f64 {
        self.roller_mm
    }

    /// True if the spindle turns.
    #[must_use]
    pub const fn lathe_is_on(&self) -> bool {
        self.lathe
    }

    /// True if the pump runs.
    #[must_use]
    pub const fn pump_is_on(&self) -> bool {
        self.pump
    }

    /// The carriage is brought back by its handwheel, another blank put in.
    pub const fn bring_back(&mut self) {
        self.carriage_mm = 0.0;
        self.counted_from_mm = 0.0;
    }

    /// Puts a fault in.
    pub fn break_with(&mut self, fault: Fault) {
        self.faults.push(fault);
    }

    /// True if the carriage is so many pulses past the tip.
    fn is_past(&self, pulses: u32) -> bool {
        self.carriage_mm() >= f64::from(pulses) * MM_PER_PULSE
    }

    fn advance(&mut self, seconds: f64) {
        self.time_s += seconds;
        self.move_carriage(seconds);
        self.move_roller(seconds);
    }

    fn move_carriage(&mut self, seconds: f64) {
        let stalled = |f: &Fault| matches!(f, Fault::StalledCarriage { after_pulses } if self.is_past(*after_pulses));
        if self.lathe && !self.faults.iter().any(stalled) {
            self.carriage_mm += self.model.carriage_mm_per_s() * seconds;
        }
    }

    /// First order: the speed comes near what the valve asks for with the lag's time constant.
    fn move_roller(&mut self, seconds: f64) {
        let wanted = if self.pump { valve::speed_mm_per_s(self.effective_code()) } else { 0.0 };
        let kept = (-seconds / self.model.lag_s.max(1e-6)).exp();
        let difference = self.roller_mm_per_s - wanted;
        let to = self.roller_mm + wanted * seconds + difference * self.model.lag_s * (1.0 - kept);
        self.roller_mm_per_s = wanted + difference * kept;
        self.roller_mm = to.clamp(0.0, STROKE_MM);
        if self.roller_mm != to {
            self.roller_mm_per_s = 0.0;
        }
    }

    /// What the valve makes of its code.
    fn effective_code(&self) -> u8 {
        let stuck = self.faults.iter().find_map(|f| match f {
            Fault::StuckValve { after_pulses, open } if self.is_past(*after_pulses) => Some(*open),
            _ => None,
        });
        match stuck {
            Some(true) => valve::RETRACT,
            Some(false) => STOP,
            None => self.code,
        }
    }

    fn pulses(&self) -> u32 {
        let lost: u32 = self
            .faults
            .iter()
            .filter_map(|f| match f {
                Fault::LostCounts { after_pulses, count } if self.is_past(*after_pulses) => Some(*count),
                _ => None,
            })
            .sum();
        whole((self.carriage_mm - self.counted_from_mm) / MM_PER_PULSE).saturating_sub(lost)
    }

    fn steps(&self) -> u16 {
        let drift: f64 = self
            .faults
            .iter()
            .map(|f| match f {
                Fault::DriftingSupply { percent_per_min } => percent_per_min / 100.0 * self.time_s / 60.0,
                _ => 0.0,
            })
            .sum();
        let steps = whole(self.roller_mm / MM_PER_STEP * (1.0 + drift)).min(u32::from(LARGEST_STEP));
        u16::try_from(steps).unwrap_or(LARGEST_STEP)
    }
}

/// Whole counts of a measure.
fn whole(value: f64) -> u32 {
    /// Rounding of a measure that is a whole number of counts.
    const ROUNDING: f64 = 1e-9;
    let counts = (value + ROUNDING).floor().clamp(0.0, 1e9);
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped to 0..=1e9")]
    if counts.is_finite() { counts as u32 } else { 0 }
}

impl Rig for SimulatedRig {
    fn read(&mut self) -> Reading {
        self.advance(self.model.loop_s);
        Reading {
            time_s: self.time_s,
            pulses: self.pulses(),
            steps: self.steps(),
            at_datum: self.roller_mm <= DATUM_MM,
            at_tip: self.carriage_mm >= self.model.run_up_mm,
        }
    }

    fn set_valve(&mut self, code: u8) {
        self.code = code;
    }

    fn set_lathe(&mut self, on: bool) {
        self.lathe = on;
    }

    fn set_pump(&mut self, on: bool) {
        self.pump = on;
    }

    fn reset_counter(&mut self) {
        self.counted_from_mm = self.carriage_mm;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rig(faults: Vec<Fault>) -> SimulatedRig {
        let mut rig = SimulatedRig::new(RigModel::new(95.0, 1.27), faults);
        rig.set_pump(true);
        rig
    }

    /// Reads for a time.
    fn after(rig: &mut SimulatedRig, seconds: f64) -> Reading {
        let until = rig.time_s + seconds;
        loop {
            let reading = rig.read();
            if reading.time_s >= until {
                return reading;
            }
        }
    }

    #[test]
    fn carriage_counts_by_speed_and_feed() {
        let mut rig = rig(Vec::new());
        rig.set_lathe(true);
        let reading = after(&mut rig, 10.0);
        let travelled = 95.0 / 60.0 * 1.27 * 10.0;
        assert!((f64::from(reading.pulses) * MM_PER_PULSE - travelled).abs() < 0.1, "{reading:?}");
        assert!(reading.at_tip);
    }

    #[test]
    fn the_roller_overshoots_after_the_valve_has_shut() {
        let mut rig = rig(Vec::new());
        rig.set_valve(valve::ADVANCE_AS_LISTED);
        let moving = after(&mut rig, 0.5);
        rig.set_valve(STOP);
        let rest = after(&mut rig, 0.4);
        let over = f64::from(rest.steps - moving.steps) * MM_PER_STEP;
        assert!(over > 0.7 && over < 1.4, "{over}");
        assert_eq!(after(&mut rig, 1.0).steps, rest.steps);
    }

    #[test]
    fn without_the_pump_nothing_moves_and_the_stroke_ends() {
        let mut rig = rig(Vec::new());
        rig.set_pump(false);
        rig.set_valve(255);
        let before = after(&mut rig, 0.1).steps;
        assert_eq!(after(&mut rig, 1.0).steps, before);
        rig.set_pump(true);
        assert_eq!(after(&mut rig, 5.0).steps, LARGEST_STEP);
        rig.set_valve(0);
        assert!(after(&mut rig, 5.0).at_datum);
    }

    #[test]
    fn every_fault_shows() {
        let mut lost = rig(vec![Fault::LostCounts { after_pulses: 0, count: 50 }]);
        lost.set_lathe(true);
        assert!(after(&mut lost, 5.0).pulses < 120);
        let mut stalled = rig(vec![Fault::StalledCarriage { after_pulses: 10 }]);
        stalled.set_lathe(true);
        assert!((after(&mut stalled, 20.0).pulses) < 80);
        let mut drift = rig(vec![Fault::DriftingSupply { percent_per_min: 60.0 }]);
        let (early, late) = (after(&mut drift, 0.01).steps, after(&mut drift, 60.0).steps);
        assert!(late > early + 40, "{early} {late}");
        let mut stuck = rig(vec![Fault::StuckValve { after_pulses: 0, open: false }]);
        stuck.set_lathe(true);
        after(&mut stuck, 5.0);
        stuck.set_valve(valve::ADVANCE);
        let before = after(&mut stuck, 0.1).steps;
        assert_eq!(after(&mut stuck, 1.0).steps, before);
    }
}
