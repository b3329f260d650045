//! Tools, offsets and presets: where the programmed point truly is.

use super::block::{Ms, Taken};
use super::codes::G;
use super::{Run, SAME_MM};
use crate::cancel::Cancelled;
use crate::geometry::{Point, Vector};
use crate::machine::{Dialect, Preset, ToolWord};
use crate::proof::findings::Breach;
use crate::proof::report::FindingKind;
use crate::proof::step::Drive;

/// A preset may differ from the tool's change position by this much, mm: both are written to 0.001.
const PRESET_TOLERANCE_MM: f64 = 0.001_5;

impl Run<'_, '_> {
    /// T, M6 and G43.
    pub(super) fn tool_words(&mut self, codes: &[G], ms: &Ms, words: &mut Taken<'_>) {
        if self.contour_only {
            words.take('T');
            return;
        }
        match self.control.words.tool_word {
            ToolWord::StationAndOffset => {
                if let Some(t) = words.take('T') {
                    match t.whole() {
                        Some(number) => self.call(number / 100, number % 100),
                        None => self.unreadable(format!("T{} is not a whole number from 0 up.", t.plain())),
                    }
                }
            }
            ToolWord::Change => {
                if let Some(t) = words.take('T') {
                    self.state.prepared = t.whole();
                }
                if ms.change {
                    match self.state.prepared {
                        Some(tool) => self.change_to(tool),
                        None => self.control_error(
                            "no tool",
                            0.0,
                            1.0,
                            "M6 changes the tool, but no T word has named one.".into(),
                        ),
                    }
                }
                let offset = codes.iter().find_map(|c| if let G::ToolOffset(on) = c { Some(*on) } else { None });
                if let Some(on) = offset {
                    let number = words.take('H').map(|h| h.whole().unwrap_or(0)).or(self.control.tool);
                    self.state.offset = if on { number.unwrap_or(0) } else { 0 };
                    self.check_offset();
                }
            }
        }
    }

    /// `T0203`: station 2 with offset 3; offset 0 takes the offset off.
    fn call(&mut self, station: u32, offset: u32) {
        self.state.offset = offset;
        if station != 0 {
            self.change_to(station);
        }
        self.check_offset();
    }

    /// An offset of another tool moves the tip by what the two tools differ.
    fn check_offset(&mut self) {
        let Some(tool) = self.control.tool else { return };
        let own = self.control.machine.turret_tool(tool).map_or(tool, crate::machine::TurretTool::offset_number);
        let given = self.state.offset;
        if given != 0 && given != own {
            let message = format!("Tool {tool} is called with offset {given}; its own is {own}.");
            self.limit_error("offset", f64::from(given), f64::from(own), message);
        }
    }

    /// Puts a tool into place. The turret stays; the tip of the new tool is elsewhere if the tools have change positions of
    /// their own.
    fn change_to(&mut self, tool: u32) {
        if self.control.tool == Some(tool) {
            return;
        }
        let place = self.control.place;
        let old = self.control.tool.and_then(|old| self.change_position(old));
        let new = self.change_position(tool);
        self.control.tool = Some(tool);
        match (place, old, new) {
            (Some(place), Some(old), Some(new)) => self.control.place = Some(new + (place - old)),
            (None, _, new) => self.control.place = new,
            _ => {}
        }
        // Offsets that hold the tools' shapes take the program's count along; presets do not.
        if self.control.words.preset == Preset::G50 {
            self.state.shifted_by = Some("the call of the tool");
        } else if let (Some(at), Some(old), Some(new)) = (self.state.at, old, new) {
            self.state.at = Some(at + (new - old));
        }
    }

    fn change_position(&self, tool: u32) -> Option<Point> {
        let position = self.control.machine.change_position(tool)?;
        Some(Point::new(position.z_mm, position.diameter_mm / 2.0))
    }

    /// The reference point of the tool in place, from the true program zero.
    pub(super) fn reference(&self) -> Point {
        self.control.tool.and_then(|tool| self.change_position(tool)).unwrap_or(self.rest())
    }

    fn rest(&self) -> Point {
        let rest = self.control.machine.rest;
        rest.map_or(self.control.assumed, |rest| Point::new(rest.z_mm, rest.diameter_mm / 2.0))
    }

    /// Where the programmed point truly is; at the start where the turret rests.
    pub(super) fn true_place(&mut self) -> Point {
        let reference = self.reference();
        *self.control.place.get_or_insert(reference)
    }

    /// G50 of Fanuc, G92 of LinuxCNC: the present place gets these coordinates.
    pub(super) fn preset(&mut self, words: &mut Taken<'_>) -> Result<(), Cancelled> {
        if !words.moves() {
            return Ok(());
        }
        self.end_compensation()?;
        // Without a tool and a change position nobody but the program knows where the tool is.
        let anchored = self.control.place.is_some() || self.anchored();
        if self.state.at.is_none() {
            let place = self.control.place.unwrap_or(self.reference());
            self.state.at = Some(place);
        }
        let to = self.target(words);
        self.state.at = Some(to);
        if !anchored && self.control.words.preset == Preset::G50 {
            self.control.place = Some(to);
        }
        self.state.shifted_by = Some("the preset");
        Ok(())
    }

    /// True if the machine's file says where tools are changed.
    fn anchored(&self) -> bool {
        self.control.machine.tools.iter().any(|tool| self.change_position(tool.station).is_some())
    }

    /// LinuxCNC's G92.1 and G92.2.
    pub(super) fn preset_off(&mut self) -> Result<(), Cancelled> {
        self.end_compensation()?;
        let place = self.true_place();
        self.state.at = Some(place);
        Ok(())
    }

    /// What must be right before the tool moves.
    pub(super) fn check_before_move(&mut self, drive: Drive) {
        if let Some(by) = self.state.shifted_by.take() {
            self.check_shift(by);
        }
        let linuxcnc = self.control.machine.dialect == Dialect::Linuxcnc;
        // Where a preset says the place of every tool, the offsets hold wear alone and cutting without them is a choice.
        let needs_offset = linuxcnc || self.control.words.preset != Preset::G50;
        if needs_offset && !drive.rapid && self.state.offset == 0 && self.control.tool.is_some() {
            let message = "The tool cuts without its offset; nobody knows where its tip is.".to_owned();
            self.find(Breach::error("no offset", FindingKind::Structure, 0.0, 1.0, message));
        }
    }

    fn check_shift(&mut self, by: &str) {
        let shift: Vector = self.shift();
        let largest = shift.x.abs().max(shift.y.abs());
        if largest <= PRESET_TOLERANCE_MM.max(SAME_MM) {
            return;
        }
        let (place, at) = (self.true_place(), self.here());
        let words = self.control.words;
        let message = format!(
            "After {by} the program counts X {:.3} Z {:.3}, but the tool's point is at X {:.3} Z {:.3}, {largest:.3} mm away; \
             {PRESET_TOLERANCE_MM} mm is allowed. Everything from here is cut out of place by that.",
            words.x_at(at.r),
            at.z,
            words.x_at(place.r),
            place.z
        );
        let breach = Breach::error("preset", FindingKind::Control, largest, PRESET_TOLERANCE_MM, message);
        self.find(breach);
    }
}
