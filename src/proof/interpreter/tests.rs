//! Programs with known paths.

use super::*;
use crate::machine::{Catalog, outlines};
use crate::proof::reader::words;
use crate::proof::step::Drive;

mod compensation;
mod cycles;
mod fanuc;
mod linuxcnc;
mod listing;

/// A move as a test spells it: kind, z, x (radius).
type Spelled = (char, f64, f64);

/// Keeps what a program does.
#[derive(Default)]
pub(super) struct Path {
    pub steps: Vec<(usize, Step)>,
}

impl Sink for Path {
    fn block(&mut self, _block: usize) {}

    fn step(&mut self, block: usize, step: Step, _findings: &mut Findings) -> Result<(), Cancelled> {
        self.steps.push((block, step));
        Ok(())
    }
}

impl Path {
    /// The ends of all moves: `r` rapid, `l` line, `a` counter-clockwise, `c` clockwise, `t` thread.
    pub(super) fn spelled(&self) -> Vec<Spelled> {
        let round = |v: f64| (v * 1000.0).round() / 1000.0 + 0.0;
        let kind = |step: &Step| match step {
            Step::Move { path, drive: Drive { rapid, .. }, .. } => {
                let kind = match path {
                    crate::geometry::Segment::Arc { ccw, .. } => {
                        if *ccw {
                            'a'
                        } else {
                            'c'
                        }
                    }
                    _ if *rapid => 'r',
                    crate::geometry::Segment::Line { .. } => 'l',
                };
                Some((kind, round(path.end().z), round(path.end().r)))
            }
            Step::ThreadPass { path, .. } => Some(('t', round(path.end().z), round(path.end().r))),
            _ => None,
        };
        self.steps.iter().filter_map(|(_, step)| kind(step)).collect()
    }

    /// Paths of all moves in order.
    pub(super) fn paths(&self) -> Vec<crate::geometry::Segment> {
        let path = |step: &Step| match step {
            Step::Move { path, .. } | Step::ThreadPass { path, .. } => Some(*path),
            _ => None,
        };
        self.steps.iter().filter_map(|(_, step)| path(step)).collect()
    }

    pub(super) fn drives(&self) -> Vec<Drive> {
        self.steps
            .iter()
            .filter_map(|(_, s)| if let Step::Move { drive, .. } = s { Some(*drive) } else { None })
            .collect()
    }
}

/// Runs a text on a shipped machine, or on a changed one; program zero and part zero are the same.
pub(super) fn run_on(machine: &Machine, text: &str) -> (Path, Vec<crate::proof::Finding>) {
    let tools = outlines(machine, &Catalog::shipped());
    let tape = words::read(text, machine.dialect);
    assert_eq!(tape.troubles, [], "{text}");
    let mut findings = Findings::default();
    let mut path = Path::default();
    let mut control = Interpreter::new(machine, &tools, 0.0, Point::new(5.0, 50.0)).unwrap();
    control.run(&tape, 0, &mut findings, &mut path).unwrap();
    (path, findings.in_order(&["TEST".to_owned()]))
}

pub(super) fn machine(id: &str) -> Machine {
    Catalog::shipped().machine(id).unwrap().clone()
}

/// Runs a text that nothing is wrong with.
pub(super) fn good(id: &str, text: &str) -> Path {
    let (path, findings) = run_on(&machine(id), text);
    assert_eq!(findings, [], "{text}");
    path
}

/// The messages about a text.
pub(super) fn said(id: &str, text: &str) -> Vec<String> {
    run_on(&machine(id), text).1.into_iter().map(|f| f.message).collect()
}
