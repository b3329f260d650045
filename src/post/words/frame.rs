//! What stands before, between and after the operations of a program.

use super::control::Control;
use super::spindle::Speeds;
use super::writer::Writer;
use crate::geometry::Point;
use crate::machine::{Preset, ToolWord};
use crate::turning::{CutterPath, Operation};
use crate::units::Unit;

impl Writer<'_> {
    /// First blocks: unit and modes, then a safe place. The tool is taken to stand at `first` where the program says so.
    pub(super) fn begin(&mut self, first: Point) {
        let control = self.control;
        let mut line = self.line();
        line.word(if control.options.unit == Unit::Mm { "G21" } else { "G20" });
        if control.is_linuxcnc() {
            line.code(&linuxcnc_modes(control));
        }
        line.code(&control.words.codes.start);
        self.push(line);
        self.state.exact = first;
        self.state.at = control.words.incremental.then(|| control.grid.counts(first));
        self.retract();
    }

    /// The whole of an operation between its change position and the way back to it. It sets its own clamp and feed, so that
    /// the operator can begin again with any of them; in the published form, which writes a clamp only where it is reached,
    /// a feed that stays is not written again.
    pub(super) fn operation(&mut self, index: usize, operation: &Operation, path: &CutterPath) {
        self.operation = Some(index);
        self.state.clamp = None;
        if !self.control.words.clamp_where_reached {
            self.state.feed = None;
        }
        let change = operation.change.unwrap_or(path.datum);
        let speeds = Speeds::of(operation, self, change);
        self.title(index, operation);
        self.preset(change);
        self.clamp_for(&speeds);
        self.call_tool(operation.tool, &speeds);
        self.state.motion = None;
        self.state.exact = change;
        if let Some(first) = speeds.first {
            self.speed(first, &self.control.words.codes.spindle_on);
        }
        if self.control.words.preset != Preset::G50 {
            self.coolant_on();
        }
        self.body(operation);
        self.rapid(change);
        self.leave(operation.tool);
        self.operation = None;
    }

    fn clamp_for(&mut self, speeds: &Speeds) {
        if let Some(first) = speeds.first {
            self.clamp(first, !self.control.words.clamp_where_reached || speeds.reach_clamp());
        }
    }

    /// Tells the control where the tool stands while it is changed.
    fn preset(&mut self, change: Point) {
        if self.control.words.preset != Preset::G50 {
            return;
        }
        let counts = self.control.grid.counts(change);
        let mut line = self.line();
        line.word("G50").length('X', counts.x).length('Z', counts.z);
        line.code(self.control.words.codes.coolant_on.as_deref().unwrap_or_default());
        self.push(line);
        self.state.at = Some(counts);
    }

    fn call_tool(&mut self, station: u32, speeds: &Speeds) {
        let control = self.control;
        let offset = control.machine.turret_tool(station).map_or(station, crate::machine::TurretTool::offset_number);
        let range = control.machine.spindle.ranges.iter().find(|r| speeds.highest_rpm <= r.max_rpm);
        let range = range.or(control.machine.spindle.ranges.last()).map(|r| r.code.as_str()).unwrap_or_default();
        let mut line = self.line();
        match control.words.tool_word {
            ToolWord::StationAndOffset => {
                line.word(&format!("T{station:02}{offset:02}")).code(range);
                if station.max(offset) > MOST_STATION {
                    let message =
                        format!("Station {station} with offset {offset} has no T word; both go up to {MOST_STATION}.");
                    line.fault("word-too-long", message, "Number stations and offsets from 1 to 99.");
                }
                self.push(line);
            }
            ToolWord::Change => {
                line.whole('T', station).word("M6").word("G43");
                if offset != station {
                    line.whole('H', offset);
                }
                self.push(line);
                self.push_code(range);
            }
        }
    }

    fn coolant_on(&mut self) {
        if let Some(code) = &self.control.words.codes.coolant_on {
            self.push_code(code);
        }
    }

    /// After the last move of an operation: coolant off, a safe place, offset off.
    fn leave(&mut self, station: u32) {
        let codes = &self.control.words.codes;
        self.push_code(codes.coolant_off.as_deref().unwrap_or_default());
        self.retract();
        if self.control.words.tool_word == ToolWord::StationAndOffset {
            self.push_code(&format!("T{station:02}00"));
        }
        self.push_code(codes.spindle_stop.as_deref().unwrap_or_default());
        self.state.spindle = None;
    }

    fn retract(&mut self) {
        for code in &self.control.words.codes.retract {
            self.push_code(code);
            self.state.at = None;
        }
    }

    /// Between two operations.
    pub(super) fn between(&mut self) {
        self.push_code(self.control.words.codes.optional_stop.as_deref().unwrap_or_default());
    }

    /// The last block.
    pub(super) fn end(&mut self) {
        self.push_code(&self.control.words.codes.program_end);
    }
}

/// Stations and offsets have two digits.
const MOST_STATION: u32 = 99;

/// Modes of LinuxCNC that the words of a program rely on: plane, diameters or radii, positions, arc centres, no
/// compensation, no cycle, feed per turn or minute, first work offset.
fn linuxcnc_modes(control: &Control<'_>) -> String {
    let words = control.words;
    let x = if words.x_is_diameter { "G7" } else { "G8" };
    let center = if words.arc_center == crate::machine::ArcCenter::Absolute { "G90.1" } else { "G91.1" };
    let feed = if words.feed_per_rev { "G95" } else { "G94" };
    let zero = if words.preset == Preset::G54 { " G54" } else { "" };
    format!("G18 {x} G90 {center} G40 G49 G80 {feed}{zero}")
}
