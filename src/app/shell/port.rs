//! Which rig runs the shell: the simulated one, or one at a serial port.

use crate::transfer::rig::{RigEvent, RigLine};
use crate::transfer::{Port, PortChoice, serial_ports};
use egui::Context;

/// The rig that is chosen, and the line to it.
#[derive(Debug, Default)]
pub(super) struct RigPort {
    /// The port's name; `None` for the simulated rig.
    chosen: Option<String>,
    listed: Vec<PortChoice>,
    line: Option<RigLine>,
    /// Settings that the port did not take.
    pub(super) remarks: Vec<String>,
}

impl RigPort {
    /// The port's name; `None` for the simulated rig.
    pub(super) fn name(&self) -> Option<&str> {
        self.chosen.as_deref()
    }

    /// True while a line is open, or being opened.
    pub(super) const fn is_open(&self) -> bool {
        self.line.is_some()
    }

    /// The rigs to choose from, with their names for people; the last one is a port whose path is typed.
    pub(super) fn choices(&self) -> Vec<(Option<String>, String)> {
        let mut all = vec![(None, "simulated rig".to_owned())];
        all.extend(self.listed.iter().map(|port| (Some(port.name.clone()), port.label.clone())));
        let typed = if self.is_typed() { self.chosen.clone().unwrap_or_default() } else { String::new() };
        let name = if typed.is_empty() { "rig at a port…".to_owned() } else { format!("rig at {typed}") };
        all.push((Some(typed), name));
        all
    }

    /// True if the port is none of those that the system lists.
    pub(super) fn is_typed(&self) -> bool {
        self.chosen.as_ref().is_some_and(|name| !self.listed.iter().any(|port| port.name == *name))
    }

    /// Chooses a rig; a line that is open is closed.
    pub(super) fn choose(&mut self, chosen: Option<String>) {
        self.close();
        self.listed = serial_ports();
        self.chosen = chosen.map(|name| name.trim().to_owned());
    }

    /// Draws the roller back to its datum; opens the line first if it is not open. Why not, if that makes no sense.
    pub(super) fn seek_datum(&mut self, ctx: Option<&Context>) -> Result<(), String> {
        let name = self.chosen.clone().unwrap_or_default();
        if name.is_empty() {
            return Err("No port is named. Choose one, or type its path, in the panel Rig.".to_owned());
        }
        if let Some(line) = &self.line {
            line.seek_datum();
        } else {
            let ctx = ctx.cloned();
            let wake = move || ctx.iter().for_each(Context::request_repaint);
            self.line = Some(RigLine::open(Port::Serial(name), wake));
        }
        Ok(())
    }

    /// The open line.
    pub(super) const fn line(&self) -> Option<&RigLine> {
        self.line.as_ref()
    }

    /// What the rig told since.
    pub(super) fn events(&self) -> Vec<RigEvent> {
        self.line.iter().flat_map(RigLine::events).collect()
    }

    /// Closes the line.
    pub(super) fn close(&mut self) {
        self.line = None;
        self.remarks.clear();
    }
}
