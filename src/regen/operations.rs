//! Which operation the moves and blocks of a clamping belong to.

use super::SetupDerived;
use crate::post::Program;
use crate::proof::{BlockRef, Motion, Move};

/// Operations of a clamping with the blocks and moves that carry them out.
#[derive(Debug)]
pub struct Operations<'a> {
    derived: &'a SetupDerived,
    /// The generated program of each program that is sent; `None` for one edited by hand.
    generated: Vec<Option<&'a Program>>,
}

/// Where the time of one operation goes, s.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct OperationTime {
    /// Cutting and threading.
    pub cutting_s: f64,
    /// Ways through air, dwells, tool changes.
    pub other_s: f64,
}

impl OperationTime {
    /// All of it, s.
    #[must_use]
    pub fn total_s(&self) -> f64 {
        self.cutting_s + self.other_s
    }
}

impl<'a> Operations<'a> {
    /// Those of one clamping.
    #[must_use]
    pub fn of(derived: &'a SetupDerived) -> Self {
        let generated = |text: &crate::proof::ProgramText| {
            derived.post.programs.iter().find(|p| p.name == text.name).filter(|_| !text.edited)
        };
        Self { derived, generated: derived.programs.iter().map(generated).collect() }
    }

    /// The operation that a move belongs to, by index in the path; of a program edited by hand, the first one of its tool.
    #[must_use]
    pub fn of_move(&self, m: &Move) -> Option<usize> {
        match self.generated.get(m.program)? {
            Some(program) => program.blocks.get(m.block.checked_sub(1)?)?.operation_index,
            None => self.derived.path.operations.iter().position(|o| o.tool == m.tool && !o.moves.is_empty()),
        }
    }

    /// The blocks that belong to the operation with this index, in the order of the programs.
    #[must_use]
    pub fn blocks(&self, operation: usize) -> Vec<BlockRef> {
        let mut blocks: Vec<BlockRef> = Vec::new();
        for (program, generated) in self.generated.iter().enumerate() {
            let of_generated = generated.iter().flat_map(|g| g.blocks.iter().zip(1..));
            let own = of_generated.filter(|(info, _)| info.operation_index == Some(operation));
            blocks.extend(own.map(|(_, block)| BlockRef { program, block }));
        }
        let by_hand = |m: &&Move| self.generated.get(m.program).is_some_and(Option::is_none);
        let moves = self.derived.proof.moves.iter().filter(by_hand);
        blocks.extend(moves.filter(|m| self.of_move(m) == Some(operation)).map(BlockRef::of));
        blocks.sort_unstable();
        blocks.dedup();
        blocks
    }

    /// Time of every operation of the path, and of what belongs to none: starts and ends of programs.
    #[must_use]
    pub fn times(&self) -> (Vec<OperationTime>, OperationTime) {
        let mut times = vec![OperationTime::default(); self.derived.path.operations.len()];
        let mut none = OperationTime::default();
        for m in &self.derived.proof.moves {
            let of = self.of_move(m).and_then(|index| times.get_mut(index)).unwrap_or(&mut none);
            match m.motion {
                Motion::Feed | Motion::Thread => of.cutting_s += m.lasts_s,
                Motion::Rapid | Motion::Pause => of.other_s += m.lasts_s,
            }
        }
        (times, none)
    }

    /// From where to where along the spindle the operation cuts, part space, mm; `None` if it does not.
    #[must_use]
    pub fn reach(&self, operation: usize) -> Option<(f64, f64)> {
        let cuts = |m: &&Move| matches!(m.motion, Motion::Feed | Motion::Thread);
        let moves = self.derived.proof.moves.iter().filter(cuts).filter(|m| self.of_move(m) == Some(operation));
        let ends = moves.flat_map(|m| [m.path.start().z, m.path.end().z]);
        ends.fold(None, |reach: Option<(f64, f64)>, z| Some(reach.map_or((z, z), |(a, b)| (a.min(z), b.max(z)))))
    }
}
