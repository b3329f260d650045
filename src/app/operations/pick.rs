//! Picking the elements of an instruction on the profile: a click on the first, a click on the last.

use super::OperationsView;
use crate::document::{Generator, Instruction};
use crate::session::Session;

/// Elements that are being picked.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Pick {
    /// Index of the instruction.
    pub(super) instruction: usize,
    /// The first element, once it is picked.
    pub(super) from: Option<u32>,
}

impl OperationsView {
    /// What is asked of the person who picks, for the head of the profile; `None` while nobody does.
    pub(crate) fn asks(&self) -> Option<String> {
        let Pick { instruction, from } = self.pick?;
        let which = if from.is_none() { "first" } else { "last" };
        Some(format!("Click the {which} element of operation {} · Escape gives up", instruction + 1))
    }

    /// The element that is picked already.
    pub(crate) fn picked(&self) -> Option<u32> {
        self.pick.and_then(|pick| pick.from)
    }

    /// Stops to pick.
    pub(crate) const fn stop_picking(&mut self) {
        self.pick = None;
    }

    /// Takes a click on an element; false if nobody picks.
    pub(crate) fn take_click(&mut self, session: &mut Session, section: u32) -> bool {
        let Some(pick) = &mut self.pick else { return false };
        let Some(from) = pick.from else {
            pick.from = Some(section);
            return true;
        };
        let index = pick.instruction;
        self.pick = None;
        let label = format!("area of operation {}", index + 1);
        change(session, index, &label, |instruction| (instruction.from, instruction.to) = (from, section));
        true
    }
}

/// Changes one instruction as one step of undo.
pub(super) fn change(session: &mut Session, index: usize, label: &str, change: impl FnOnce(&mut Instruction)) {
    session.edit_part(label, None, |part| {
        if let Generator::Cycles { instructions } = &mut part.generator
            && let Some(instruction) = instructions.get_mut(index)
        {
            change(instruction);
        }
    });
}
