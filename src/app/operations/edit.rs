//! Edits of the instructions for the published cycles.

use crate::document::{Cycle, Generator, Instruction, TurnedPart};

/// The published cycles.
pub(super) const CYCLES: [Cycle; 4] = [Cycle::Rough, Cycle::Groove, Cycle::Pocket, Cycle::Finish];

/// Cutting speed of the first instruction, m/min, and its feed per turn and depth, mm: careful figures for steel with carbide.
const FIRST: (f64, f64, f64) = (100.0, 0.2, 1.0);

/// A change of the list that moves its entries about.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum ListEdit {
    /// A new instruction after this one, or at the end.
    Add(Option<usize>),
    /// A copy behind it.
    Duplicate(usize),
    /// Take it out.
    Delete(usize),
    /// One place earlier.
    Up(usize),
    /// One place later.
    Down(usize),
}

impl ListEdit {
    /// Name of the step of undo.
    pub(super) fn label(self) -> String {
        match self {
            Self::Add(_) => "add an operation".to_owned(),
            Self::Duplicate(index) => format!("duplicate operation {}", index + 1),
            Self::Delete(index) => format!("delete operation {}", index + 1),
            Self::Up(index) | Self::Down(index) => format!("move operation {}", index + 1),
        }
    }

    /// Makes the edit; which entry is to be selected afterwards. Nothing happens where it cannot be made.
    pub(super) fn apply(self, part: &mut TurnedPart, mm: f64) -> Option<usize> {
        let fresh = fresh(part, mm);
        let Generator::Cycles { instructions } = &mut part.generator else { return None };
        let len = instructions.len();
        match self {
            Self::Add(after) => {
                let at = after.map_or(len, |index| (index + 1).min(len));
                let like = at.checked_sub(1).and_then(|before| instructions.get(before)).cloned();
                instructions.insert(at, like.map_or(fresh, |like| Instruction { cut_in: None, ..like }));
                Some(at)
            }
            Self::Duplicate(index) => {
                let copy = instructions.get(index)?.clone();
                instructions.insert(index + 1, copy);
                Some(index + 1)
            }
            Self::Delete(index) if index < len => {
                instructions.remove(index);
                index.min(len.saturating_sub(2)).into()
            }
            Self::Up(index) if index > 0 && index < len => {
                instructions.swap(index, index - 1);
                Some(index - 1)
            }
            Self::Down(index) if index + 1 < len => {
                instructions.swap(index, index + 1);
                Some(index + 1)
            }
            Self::Delete(_) | Self::Up(_) | Self::Down(_) => None,
        }
    }
}

/// Roughing of the whole part with the first tool, for a person to go on from. `mm` is the document's unit in mm.
fn fresh(part: &TurnedPart, mm: f64) -> Instruction {
    let (speed_m_per_min, feed, depth) = FIRST;
    Instruction {
        cycle: Cycle::Rough,
        from: part.sections.last().map_or(0, |s| s.id),
        to: part.sections.first().map_or(0, |s| s.id),
        stock_left: 0.0,
        tool: 1,
        depth: depth / mm,
        speed_m_per_min,
        feed_per_rev: feed / mm,
        cut_in: None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn tools(part: &TurnedPart) -> Vec<u32> {
        part.generator.instructions().iter().map(|i| i.tool).collect()
    }

    fn part() -> TurnedPart {
        let mut part = TurnedPart {
            generator: Generator::Cycles { instructions: Vec::new() },
            sections: vec![crate::part::Section::line(7, 0.0, 20.0, 10.0, 20.0)],
            ..TurnedPart::default()
        };
        for tool in 1..=3 {
            ListEdit::Add(None).apply(&mut part, 1.0);
            if let Generator::Cycles { instructions } = &mut part.generator {
                instructions.last_mut().unwrap().tool = tool;
            }
        }
        part
    }

    #[test]
    fn the_list_is_edited_in_place() {
        let mut part = part();
        assert_eq!(tools(&part), [1, 2, 3]);
        assert_eq!(part.generator.instructions()[0].from, 7);
        assert_eq!(ListEdit::Up(2).apply(&mut part, 1.0), Some(1));
        assert_eq!(tools(&part), [1, 3, 2]);
        assert_eq!(ListEdit::Down(0).apply(&mut part, 1.0), Some(1));
        assert_eq!(tools(&part), [3, 1, 2]);
        assert_eq!(ListEdit::Duplicate(0).apply(&mut part, 1.0), Some(1));
        assert_eq!(tools(&part), [3, 3, 1, 2]);
        assert_eq!(ListEdit::Delete(3).apply(&mut part, 1.0), Some(2));
        assert_eq!(tools(&part), [3, 3, 1]);
        assert_eq!(ListEdit::Add(Some(0)).apply(&mut part, 1.0), Some(1));
        assert_eq!(tools(&part), [3, 3, 3, 1]);
    }

    #[test]
    fn what_cannot_be_done_changes_nothing() {
        let mut part = part();
        for edit in [ListEdit::Up(0), ListEdit::Down(2), ListEdit::Delete(9), ListEdit::Duplicate(9)] {
            assert_eq!(edit.apply(&mut part, 1.0), None, "{edit:?}");
        }
        assert_eq!(tools(&part), [1, 2, 3]);
        let mut published = TurnedPart::default();
        assert_eq!(ListEdit::Add(None).apply(&mut published, 1.0), None);
    }
}
