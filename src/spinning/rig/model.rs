//! The figures that a simulated rig behaves by.

/// How fast a simulated rig is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RigModel {
    /// Spindle speed, rev/min.
    pub rpm: f64,
    /// Carriage feed for one turn, mm.
    pub feed_per_rev: f64,
    /// Time of one turn of the control loop, s.
    pub loop_s: f64,
    /// Time constant with which the cylinder follows its valve, s.
    pub lag_s: f64,
    /// Travel of the carriage from where it is engaged to the switch at the former's tip, mm.
    pub run_up_mm: f64,
}

impl RigModel {
    /// A rig with these speeds and the delays of the published one.
    ///
    /// The delays are guide values: with them a roller at the published speeds overshoots by about 0.9 mm and misses two of
    /// five points of a 30° cone, as was observed (Mohamad 1988, section 7.1).
    #[must_use]
    pub const fn new(rpm: f64, feed_per_rev: f64) -> Self {
        Self { rpm, feed_per_rev, loop_s: 0.001_5, lag_s: 0.022, run_up_mm: 4.0 }
    }

    /// Speed of the carriage, mm/s.
    #[must_use]
    pub fn carriage_mm_per_s(&self) -> f64 {
        let speed = self.rpm / 60.0 * self.feed_per_rev;
        if speed.is_finite() { speed.max(0.0) } else { 0.0 }
    }

    /// True if the roller can finish a step before the carriage has made the next: roller step / roller speed is less than
    /// carriage step / carriage speed (Mohamad 1988, section 6.5).
    #[must_use]
    pub fn keeps_up(&self, slope: f64, roller_mm_per_s: f64) -> bool {
        slope * self.carriage_mm_per_s() < roller_mm_per_s
    }
}
