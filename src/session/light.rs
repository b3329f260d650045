//! What lights up together: the row under the pointer with the blocks that cut it, or a block with its rows.

use crate::proof::{BlockRef, CutBy};
use crate::regen::{self, Derived};

/// What the pointer is on, in whatever panel.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Hovered {
    /// A row of the section table or its line in a plot, by id.
    Section(u32),
    /// A block of a program of the clamping shown, or its path.
    Block(BlockRef),
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
    fn of(hovered: Hovered, cut_by: &CutBy) -> Self {
        match hovered {
            Hovered::Section(id) => Self { sections: vec![id], blocks: cut_by.blocks_of(id).collect() },
            Hovered::Block(block) => Self { sections: cut_by.sections_of(block).collect(), blocks: vec![block] },
        }
    }
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
            Some(hovered) => Lit::of(hovered, self.cut_by(derived, setup)),
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
