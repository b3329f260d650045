//! What lights up together: the row under the pointer with the blocks that cut it, or a block with its rows.

use crate::document::{Generator, TurnedPart};
use crate::proof::{BlockRef, CutBy};
use crate::regen::{self, Derived, Operations, SetupDerived};

/// What the pointer is on, in whatever panel.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Hovered {
    /// A row of the section table or its line in a plot, by id.
    Section(u32),
    /// A block of a program of the clamping shown, or its path.
    Block(BlockRef),
    /// An operation of the clamping shown, by index in its path.
    Operation(usize),
}

/// What is lit: sections by row id, and blocks of the clamping shown.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Lit {
    /// Row ids.
    pub sections: Vec<u32>,
    /// Blocks in the order of the programs.
    pub blocks: Vec<BlockRef>,
}

impl Lit {
    fn of(hovered: Hovered, cut_by: &CutBy, derived: Option<&Derived>, setup: usize) -> Self {
        match hovered {
            Hovered::Section(id) => Self { sections: vec![id], blocks: cut_by.blocks_of(id).collect() },
            Hovered::Block(block) => Self { sections: cut_by.sections_of(block).collect(), blocks: vec![block] },
            Hovered::Operation(index) => {
                let shown = derived.and_then(|d| d.setups.get(setup));
                shown.map(|s| Self::of_operation(index, cut_by, s)).unwrap_or_default()
            }
        }
    }

    fn of_operation(index: usize, cut_by: &CutBy, setup: &SetupDerived) -> Self {
        let operations = Operations::of(setup);
        let blocks = operations.blocks(index);
        let mut sections = instructed_rows(&setup.part, index).unwrap_or_default();
        if sections.is_empty() {
            sections = cut_by.sections_of_any(&blocks);
        }
        if sections.is_empty() {
            sections = rows_within(setup, operations.reach(index));
        }
        Self { sections, blocks }
    }
}

/// The rows between which an instruction works, if the operations are instructed.
fn instructed_rows(part: &TurnedPart, index: usize) -> Option<Vec<u32>> {
    let Generator::Cycles { instructions } = &part.generator else { return None };
    let instruction = instructions.get(index)?;
    let row = |id| part.sections.iter().position(|s| s.id == id);
    let (from, to) = (row(instruction.from)?, row(instruction.to)?);
    Some(part.sections.get(from.min(to)..=from.max(to))?.iter().map(|s| s.id).collect())
}

/// The rows that lie where an operation cuts, for one that leaves stock on all of them.
fn rows_within(setup: &SetupDerived, reach: Option<(f64, f64)>) -> Vec<u32> {
    let Some((from, to)) = reach else { return Vec::new() };
    let contour = &setup.contour;
    let mut rows: Vec<u32> = Vec::new();
    for (segment, &row) in contour.contour.segments.iter().zip(&contour.sections) {
        let middle = f64::midpoint(segment.start().z, segment.end().z);
        if (from..=to).contains(&middle) && !rows.contains(&row) {
            rows.push(row);
        }
    }
    rows
}

/// What is lit, and which blocks cut which section of one clamping once somebody asked.
#[derive(Debug, Default)]
pub(super) struct Light {
    hovered: Option<Hovered>,
    lit: Lit,
    /// Of the clamping with this index.
    cut_by: Option<(usize, CutBy)>,
}

impl Light {
    /// What is lit.
    pub(super) const fn lit(&self) -> &Lit {
        &self.lit
    }

    /// Forgets what belonged to an older document.
    pub(super) fn forget(&mut self) {
        self.cut_by = None;
    }

    /// Lights up what belongs to `hovered` in the clamping `setup`; true if something else is lit than before.
    pub(super) fn turn_to(&mut self, hovered: Option<Hovered>, derived: Option<&Derived>, setup: usize) -> bool {
        let known = self.cut_by.as_ref().is_some_and(|(of, _)| *of == setup);
        if hovered == self.hovered && (known || hovered.is_none()) {
            return false;
        }
        self.hovered = hovered;
        let lit = match hovered {
            Some(hovered) => Lit::of(hovered, self.cut_by(derived, setup), derived, setup),
            None => Lit::default(),
        };
        let changed = lit != self.lit;
        self.lit = lit;
        changed
    }

    fn cut_by(&mut self, derived: Option<&Derived>, setup: usize) -> &CutBy {
        let known = self.cut_by.take().filter(|(of, _)| *of == setup);
        let fresh = || {
            let input = derived.and_then(|d| d.setups.get(setup).and_then(|s| Some((regen::proof_input(d, s)?, s))));
            (setup, input.map(|(input, s)| CutBy::new(&input, &s.proof)).unwrap_or_default())
        };
        &self.cut_by.insert(known.unwrap_or_else(fresh)).1
    }
}
