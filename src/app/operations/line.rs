//! The lines of the list: one for every operation that does something or is instructed.

use crate::app::plots::Palette;
use crate::document::{Document, Instruction, TurnedPart};
use crate::machine::Machine;
use crate::regen::{Derived, OperationTime, Operations, SetupDerived};
use crate::session::Session;
use crate::turning::figures::{Figures, short};
use crate::units::Unit;
use egui::Color32;
use std::sync::Arc;

/// One operation of the list.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Line {
    /// Index of the operation in the path, which is that of the instruction.
    pub(super) index: usize,
    /// Its colour in the plots.
    pub(super) color: Color32,
    /// What it is called.
    pub(super) name: String,
    /// Turret station.
    pub(super) tool: u32,
    /// Its time; `None` until its program is there.
    pub(super) time: Option<OperationTime>,
    /// Its parameters in one line.
    pub(super) figures: String,
}

/// What the lines are made from: document, what follows from it, clamping shown, dark theme.
type Source = (Arc<Document>, Option<Arc<Derived>>, usize, bool);

/// The lines, made anew only when what they are made from changes.
#[derive(Debug, Default)]
pub(super) struct Lines {
    made_for: Option<Source>,
    /// One a line of the list.
    pub(super) all: Vec<Line>,
    /// Time that belongs to no operation.
    pub(super) rest: OperationTime,
}

impl Lines {
    /// Makes the lines of the clamping that is shown, if they are not made.
    pub(super) fn update(&mut self, session: &Session, palette: &Palette) {
        let (document, derived, setup) = (session.document(), session.derived(), session.selection.setup);
        let known = self.made_for.as_ref().is_some_and(|(of, from, shown, dark)| {
            let same = match (from, derived) {
                (Some(a), Some(b)) => Arc::ptr_eq(a, b),
                (None, None) => true,
                _ => false,
            };
            same && Arc::ptr_eq(of, document) && *shown == setup && *dark == palette.dark
        });
        if known {
            return;
        }
        self.make(session, palette);
        self.made_for = Some((Arc::clone(document), derived.cloned(), setup, palette.dark));
    }

    fn make(&mut self, session: &Session, palette: &Palette) {
        let unit = session.document().unit;
        let (times, rest) = session.setup().map(|s| Operations::of(s).times()).unwrap_or_default();
        self.rest = rest;
        let part = session.part();
        let instructions = part.generator.instructions();
        self.all = match session.setup() {
            _ if !instructions.is_empty() => instructed(part, unit, session.setup(), palette),
            Some(setup) => {
                let machine = session.derived().and_then(|d| d.machine.as_deref());
                generated(setup, machine, unit, palette)
            }
            None => Vec::new(),
        };
        for line in &mut self.all {
            line.time = times.get(line.index).copied().filter(|time| time.total_s() > 0.0);
        }
    }
}

/// The operations of the path that do something.
fn generated(setup: &SetupDerived, machine: Option<&Machine>, unit: Unit, palette: &Palette) -> Vec<Line> {
    let operations = &setup.path.operations;
    let colors = palette.operations(operations);
    let busy = operations.iter().zip(colors).enumerate().filter(|(_, (operation, _))| !operation.moves.is_empty());
    busy.map(|(index, (operation, color))| {
        let texts = Figures::of(operation, machine).texts(unit);
        let figures: Vec<String> = texts.into_iter().map(|(_, text)| text).collect();
        Line {
            index,
            color,
            name: operation.name.clone(),
            tool: operation.tool,
            time: None,
            figures: figures.join(" · "),
        }
    })
    .collect()
}

/// The instructions, whether the cycles can carry them out or not.
fn instructed(part: &TurnedPart, unit: Unit, setup: Option<&SetupDerived>, palette: &Palette) -> Vec<Line> {
    let colors = setup.map(|s| palette.operations(&s.path.operations)).unwrap_or_default();
    let line = |(index, instruction): (usize, &Instruction)| Line {
        index,
        color: colors.get(index).copied().unwrap_or(palette.quiet),
        name: name(part, instruction),
        tool: instruction.tool,
        time: None,
        figures: figures(instruction, unit),
    };
    part.generator.instructions().iter().enumerate().map(line).collect()
}

fn name(part: &TurnedPart, instruction: &Instruction) -> String {
    let row = |id: u32| {
        let index = part.sections.iter().position(|s| s.id == id);
        index.map_or_else(|| "?".to_owned(), |index| (index + 1).to_string())
    };
    let cycle = instruction.cycle.name();
    let mut letters = cycle.chars();
    let capital: String = letters.next().into_iter().flat_map(char::to_uppercase).chain(letters).collect();
    format!("{capital}, rows {} to {}", row(instruction.from), row(instruction.to))
}

fn figures(instruction: &Instruction, unit: Unit) -> String {
    let symbol = unit.symbol();
    let depth = (instruction.depth != 0.0).then(|| format!("{} {symbol}", short(instruction.depth)));
    let left = (instruction.stock_left != 0.0).then(|| format!("{} {symbol} left", short(instruction.stock_left)));
    let feed = format!("{} {symbol}/rev", short(instruction.feed_per_rev));
    let speed = format!("{} m/min", short(instruction.speed_m_per_min));
    depth.into_iter().chain(left).chain([feed, speed]).collect::<Vec<_>>().join(" · ")
}
