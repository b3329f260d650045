//! Subroutines: Fanuc's M98 and M99, LinuxCNC's O words.

use super::block::Taken;
use super::{Next, Run};
use crate::machine::Dialect;
use crate::proof::reader::words::{Flow, Tape};
use std::collections::HashMap;

/// Subroutines that may be open at once: four on Fanuc controls, ten on LinuxCNC.
const FANUC_DEPTH: usize = 4;
const LINUXCNC_DEPTH: usize = 10;

/// Where the subroutines of a text are, and which are open.
#[derive(Debug, Default)]
pub(super) struct Calls {
    /// First block of every program in the text by its O number.
    programs: HashMap<u32, usize>,
    /// First and last block of every O sub by name.
    subs: HashMap<String, (usize, usize)>,
    open: Vec<Open>,
}

/// A subroutine that is running.
#[derive(Debug, Clone, Copy)]
struct Open {
    /// Block of the call.
    from: usize,
    /// First block.
    first: usize,
    /// Runs that are left after this one.
    left: u32,
}

impl Calls {
    /// Finds the subroutines of a text.
    pub(super) fn of(tape: &Tape) -> Self {
        let mut calls = Self::default();
        let mut started: HashMap<&str, usize> = HashMap::new();
        for (index, block) in tape.blocks.iter().enumerate() {
            if let Some(number) = block.number('O').and_then(|o| o.whole()) {
                calls.programs.entry(number).or_insert(index);
            }
            match &block.flow {
                Some(Flow::Sub(name)) => _ = started.insert(name, index),
                Some(Flow::EndSub(name)) => {
                    if let Some(&first) = started.get(name.as_str()) {
                        calls.subs.insert(name.clone(), (first, index));
                    }
                }
                _ => {}
            }
        }
        calls
    }

    /// True if the block is the first of a subroutine that is just being called.
    pub(super) fn is_entry(&self, index: usize) -> bool {
        self.open.last().is_some_and(|open| open.first == index)
    }
}

impl Run<'_, '_> {
    /// A Fanuc text begins with the main program.
    pub(super) fn first_block(&self) -> Next {
        if self.tape.blocks.is_empty() { Next::End } else { Next::Block(0) }
    }

    /// The program has not ended before the next one begins.
    pub(super) fn runs_into_next_program(&mut self) -> Next {
        let what = if self.calls.open.is_empty() { "M30 or M02" } else { "M99" };
        self.control_error(
            "no end",
            0.0,
            1.0,
            format!("The program before this one has no {what}; the control would look for its end here."),
        );
        self.calls.open.clear();
        Next::End
    }

    /// M98 and M99.
    pub(super) fn call_or_return(&mut self, index: usize, call: bool, words: &mut Taken<'_>) -> Option<Next> {
        let p = words.take('P').map(|p| p.whole());
        if !call {
            return Some(self.return_to(p.flatten()));
        }
        let Some(Some(p)) = p else {
            self.control_error("call", 0.0, 1.0, "M98 needs the number of a subroutine, P.".to_owned());
            return None;
        };
        // Today's controls have repeats in front of four digits (P00031000), older ones in L.
        let (repeats, number) = if p > 9999 { (p / 10_000, p % 10_000) } else { (1, p) };
        let repeats = words.take('L').and_then(|l| l.whole()).unwrap_or(repeats);
        if let Some(&first) = self.calls.programs.get(&number) {
            return self.enter(index, first, repeats, &format!("O{number}"), FANUC_DEPTH);
        }
        let message = format!("Subroutine O{number} is called, but the text does not contain it.");
        self.control_error("call", f64::from(number), 0.0, message);
        None
    }

    fn enter(&mut self, index: usize, first: usize, repeats: u32, name: &str, most: usize) -> Option<Next> {
        let deep = self.calls.open.len();
        let again = self.calls.open.iter().any(|open| open.first == first);
        if again || deep >= most {
            let message = if again {
                format!("Subroutine {name} calls itself; the call is not followed.")
            } else {
                format!("Subroutine {name} is nested {} deep; {most} is the limit.", deep + 1)
            };
            self.control_error("call", (deep + 1) as f64, most as f64, message);
            return None;
        }
        if repeats == 0 {
            return None;
        }
        self.calls.open.push(Open { from: index, first, left: repeats - 1 });
        Some(Next::Block(first))
    }

    fn return_to(&mut self, block_number: Option<u32>) -> Next {
        let Some(open) = self.calls.open.last_mut() else {
            let message = "M99 stands in the main program, which then runs again and again.".to_owned();
            self.control_error("return", 1.0, 0.0, message);
            return Next::End;
        };
        if open.left > 0 {
            open.left -= 1;
            return Next::Block(open.first);
        }
        let from = open.from;
        self.calls.open.pop();
        let target = block_number.map(|n| (n, self.tape.blocks.iter().position(|b| b.printed == Some(n))));
        match target {
            Some((_, Some(block))) => Next::Block(block),
            Some((n, None)) => {
                self.control_error(
                    "return",
                    f64::from(n),
                    0.0,
                    format!("M99 goes to N{n}, which the text does not contain."),
                );
                Next::Block(from + 1)
            }
            None => Next::Block(from + 1),
        }
    }

    /// LinuxCNC's O words.
    pub(super) fn flow(&mut self, index: usize) -> Next {
        debug_assert_eq!(
            self.control.machine.dialect,
            Dialect::Linuxcnc,
            "the reader makes flow words of LinuxCNC only"
        );
        let on = Next::Block(index + 1);
        match self.tape.blocks[index].flow.clone() {
            // Entered by a call; otherwise passed over.
            Some(Flow::Sub(_)) if self.calls.is_entry(index) => on,
            Some(Flow::Sub(name)) => {
                self.calls.subs.get(&name).filter(|sub| sub.0 == index).map_or(on, |sub| Next::Block(sub.1 + 1))
            }
            Some(Flow::EndSub(_) | Flow::Return(_)) if !self.calls.open.is_empty() => self.return_to(None),
            Some(Flow::Call(name)) => {
                if let Some((first, _)) = self.calls.subs.get(&name).copied() {
                    return self.enter(index, first, 1, &format!("O{name}"), LINUXCNC_DEPTH).unwrap_or(on);
                }
                let message = format!("Subroutine O{name} is called, but the text does not contain it.");
                self.control_error("call", 0.0, 1.0, message);
                on
            }
            Some(Flow::EndSub(name) | Flow::Return(name)) => {
                self.control_error("return", 0.0, 1.0, format!("O{name} ends here, but it was not called."));
                on
            }
            None => on,
        }
    }
}
