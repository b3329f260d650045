//! Threads pass by pass.

use super::writer::Writer;
use crate::geometry::Point;
use crate::machine::{ThreadAngle, ThreadWord};

/// How far the end of a pass may be off because its lead was rounded, mm: a tenth of what a 6g thread's pitch may be off.
const LEAD_DRIFT_MM: f64 = 0.01;

/// Passes that a thread of the control's own cycle may become.
const MOST_PASSES: u32 = 1000;

impl Writer<'_> {
    /// One pass to `to` with the slide coupled to the spindle.
    pub(super) fn thread_pass(&mut self, to: Point, lead: f64, start_deg: f64, rpm: f64) {
        let control = self.control;
        self.spindle(control.fixed(rpm));
        let turn = start_deg.rem_euclid(360.0) / 360.0;
        if turn > 0.0 && control.words.thread_angle.is_none() {
            self.run_up(to, lead * turn);
        }
        let counts = control.grid.counts(to);
        let mut line = self.line();
        line.whole('G', if control.words.thread == ThreadWord::G33 { 33 } else { 32 });
        self.position(&mut line, counts);
        let lead_counts = control.lead.counts(control.in_unit(lead));
        let address = if control.words.thread == ThreadWord::G33 { 'K' } else { 'F' };
        line.number(address, control.lead, lead_counts);
        if turn > 0.0 && control.words.thread_angle == Some(ThreadAngle::QMillidegrees) {
            line.word(&format!("Q{:.0}", turn * 360_000.0));
        }
        let written = control.lead.value(lead_counts) * control.options.unit.in_mm();
        let drift = (written - lead).abs() / lead * (to.z - self.state.exact.z).abs();
        if drift > LEAD_DRIFT_MM {
            let message = format!(
                "The lead of {lead:.5} mm is written as {written:.5} mm; over this pass that is {drift:.3} mm, more than \
                 {LEAD_DRIFT_MM} mm."
            );
            line.warn("lead-rounded", message, "Write the program in the unit of the thread.");
        }
        self.push(line);
        self.state.motion = None;
        self.state.feed = None;
        self.arrived(to, counts);
    }

    /// Starts further away from the end of the pass by `distance`, mm: the spindle turns on while the tool comes.
    fn run_up(&mut self, to: Point, distance: f64) {
        let at = self.state.exact;
        let back = if at.z >= to.z { distance } else { -distance };
        self.rapid(Point::new(at.z + back, at.r));
    }

    /// A thread that a generator leaves to the control's own cycle, from the present point: in to each depth, along, out and
    /// back. `depths`: outside radius, base radius and depth of one cut, mm.
    pub(super) fn whole_thread(&mut self, to_z: f64, depths: (f64, f64, f64), pitch: f64, rpm: f64) {
        let start = self.state.exact;
        let (outside, base, per_cut) = depths;
        let mut radius = outside;
        for _ in 0..MOST_PASSES {
            radius = if per_cut > 0.0 { (radius - per_cut).max(base) } else { base };
            self.rapid(Point::new(start.z, radius));
            self.thread_pass(Point::new(to_z, radius), pitch, 0.0, rpm);
            self.rapid(Point::new(to_z, start.r));
            self.rapid(start);
            if radius <= base {
                break;
            }
        }
    }
}
