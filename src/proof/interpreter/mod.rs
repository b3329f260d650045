//! Runs programs of words as the control would: modal words, positions, offsets, cycles and subroutines.
//! Emits moves in part space, the same steps as the ORAC's control.

mod arc;
mod block;
mod calls;
mod codes;
mod compensation;
mod cycles;
mod motion;
mod state;
mod threads;
mod tool;

use super::control::Sink;
use super::findings::{Breach, Findings, Place};
use super::reader::words::Tape;
use super::report::FindingKind;
use super::step::{STEP_BUDGET, Step};
use crate::cancel::Cancelled;
use crate::geometry::Point;
use crate::machine::{Machine, ToolOutline, Words};
use calls::Calls;
use compensation::Compensation;
use state::State;
use std::collections::BTreeMap;

/// Positions closer than this, mm, are the same: half of what controls resolve.
const SAME_MM: f64 = 0.000_5;

/// What the control and the machine remember from one program to the next.
pub(super) struct Interpreter<'a> {
    machine: &'a Machine,
    words: &'a Words,
    tools: &'a BTreeMap<u32, ToolOutline>,
    /// Part-space position of the program zero.
    zero_z: f64,
    /// Where the tool is taken to be at the start if neither machine nor program says so, from the program zero.
    assumed: Point,
    tool: Option<u32>,
    /// True place of the programmed point, from the true program zero.
    place: Option<Point>,
}

impl<'a> Interpreter<'a> {
    /// A control that knows nothing yet; `None` if the machine's control has no words.
    pub(super) fn new(
        machine: &'a Machine,
        tools: &'a BTreeMap<u32, ToolOutline>,
        zero_z: f64,
        assumed: Point,
    ) -> Option<Self> {
        let words = machine.words.as_ref()?;
        Some(Self { machine, words, tools, zero_z, assumed, tool: None, place: None })
    }

    /// Runs a program to its end.
    pub(super) fn run(
        &mut self,
        tape: &Tape,
        program: usize,
        findings: &mut Findings,
        sink: &mut dyn Sink,
    ) -> Result<(), Cancelled> {
        let state = State::new(self.machine, self.words);
        let calls = Calls::of(tape);
        let mut run = Run {
            control: self,
            tape,
            program,
            findings,
            sink,
            state,
            calls,
            compensation: Compensation::default(),
            at_block: 0,
            steps: 0,
            contour_only: false,
            begun: false,
        };
        run.run()
    }
}

/// One program being run.
struct Run<'r, 'a> {
    control: &'r mut Interpreter<'a>,
    tape: &'r Tape,
    program: usize,
    findings: &'r mut Findings,
    sink: &'r mut dyn Sink,
    state: State,
    calls: Calls,
    compensation: Compensation,
    /// Index of the block that is run.
    at_block: usize,
    steps: u32,
    /// The blocks are the contour of a cycle: tool and speed do not change.
    contour_only: bool,
    /// A block with words has been run.
    begun: bool,
}

/// Where the program goes on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Next {
    /// With the block of this index.
    Block(usize),
    /// Nowhere: it has ended.
    End,
}

impl Run<'_, '_> {
    fn run(&mut self) -> Result<(), Cancelled> {
        let mut next = self.first_block();
        while let Next::Block(index) = next {
            if index >= self.tape.blocks.len() {
                break;
            }
            self.at_block = index;
            if !self.count_step() {
                break;
            }
            self.sink.block(index + 1);
            next = self.block(index)?;
        }
        self.end_compensation()?;
        Ok(())
    }

    /// Counts a block or move; false, with a finding, when a program runs on without end.
    fn count_step(&mut self) -> bool {
        self.steps += 1;
        if self.steps == STEP_BUDGET {
            let message =
                format!("The program runs more than {STEP_BUDGET} blocks and was stopped: a loop without end.");
            self.control_error("endless", f64::from(STEP_BUDGET), f64::from(STEP_BUDGET), message);
        }
        self.steps < STEP_BUDGET
    }

    fn place(&self) -> Place {
        Place { program: self.program, block: self.at_block + 1 }
    }

    fn find(&mut self, breach: Breach) {
        let place = self.place();
        self.findings.add(place, breach);
    }

    /// A word that the control does not know or that has no meaning where it stands.
    fn unreadable(&mut self, message: String) {
        let place = self.place();
        self.findings.add_each(place, Breach::error("unreadable", FindingKind::Unreadable, 1.0, 0.0, message));
    }

    fn control_error(&mut self, rule: &'static str, value: f64, limit: f64, message: String) {
        self.find(Breach::error(rule, FindingKind::Control, value, limit, message));
    }

    fn structure_warning(&mut self, rule: &'static str, message: &str) {
        self.find(Breach::error(rule, FindingKind::Structure, 0.0, 1.0, message.to_owned()).into_warning());
    }

    fn limit_error(&mut self, rule: &'static str, value: f64, limit: f64, message: String) {
        self.find(Breach::error(rule, FindingKind::OutsideLimits, value, limit, message));
    }

    fn step(&mut self, step: Step) -> Result<(), Cancelled> {
        self.sink.step(self.at_block + 1, step, self.findings)
    }
}

#[cfg(test)]
mod tests;
