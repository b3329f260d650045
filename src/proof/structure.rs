//! What must be right about a program before it runs: numbering, end, and the pairs of loops and subroutines.

use super::findings::{Breach, Findings, Place};
use super::reader::{Block, Layout, Listing, Op, Word};
use super::report::FindingKind;
use std::collections::HashMap;

/// Where the control jumps to, by index of block.
#[derive(Debug, Default)]
pub(super) struct Structure {
    /// Of a SUB, its ESUB.
    pub end_of_sub: HashMap<usize, usize>,
    /// First block of each subroutine by number.
    pub subs: HashMap<u64, usize>,
}

/// A loop or subroutine that is not closed yet.
struct Open {
    block: usize,
    op: Op,
}

/// Checks a listing and finds its jumps.
pub(super) fn check(listing: &Listing, program: usize, findings: &mut Findings) -> Structure {
    let mut error = |block: usize, rule, value, limit, message| {
        let place = Place { program, block: block.max(1) };
        findings.add(place, Breach::error(rule, FindingKind::Structure, value, limit, message));
    };
    numbering(&listing.blocks, &mut error);
    end(listing, &mut error);
    pairs(&listing.blocks, &mut error)
}

fn numbering(blocks: &[Block], error: &mut impl FnMut(usize, &'static str, f64, f64, String)) {
    let mut expected = 1;
    for (index, printed) in blocks.iter().enumerate().filter_map(|(i, b)| Some((i, b.printed?))) {
        if printed != expected {
            let message =
                format!("Block number {printed} stands where {expected} is due: a block is lost, double or moved.");
            error(index + 1, "numbering", f64::from(printed), f64::from(expected), message);
        }
        expected = printed.saturating_add(1);
    }
}

fn end(listing: &Listing, error: &mut impl FnMut(usize, &'static str, f64, f64, String)) {
    let blocks = &listing.blocks;
    if blocks.is_empty() {
        return error(1, "empty", 0.0, 1.0, "The program has no blocks.".to_owned());
    }
    match blocks.iter().position(|b| b.op == Some(Op::End)) {
        // Lists of instructions get their end when they are assembled to pages.
        None if listing.layout == Layout::Instructions => {}
        None => {
            error(blocks.len(), "no end", 0.0, 1.0, "The last block is not the end of the program (M02).".to_owned());
        }
        Some(index) => {
            let beyond = outside_subroutines(&blocks[index + 1..]);
            if beyond > 0 {
                let message = format!("The program ends here, but {beyond} blocks follow that never run.");
                error(index + 1, "after the end", beyond as f64, 0.0, message);
            }
        }
    }
}

/// Blocks that belong to no subroutine; subroutines may stand behind the end.
fn outside_subroutines(blocks: &[Block]) -> usize {
    let mut inside = false;
    let mut outside = 0;
    for block in blocks {
        inside |= block.op == Some(Op::Sub);
        outside += usize::from(!inside);
        inside &= block.op != Some(Op::EndSub);
    }
    outside
}

fn pairs(blocks: &[Block], error: &mut impl FnMut(usize, &'static str, f64, f64, String)) -> Structure {
    let mut structure = Structure::default();
    let mut open: Vec<Open> = Vec::new();
    for (index, block) in blocks.iter().enumerate() {
        let Some(op) = block.op else { continue };
        match op {
            Op::Do => open.push(Open { block: index, op }),
            Op::Sub => {
                if let Some(outer) = open.last() {
                    let message =
                        format!("A subroutine starts inside the {} of block {}.", outer.op.mnemonic(), outer.block + 1);
                    error(index + 1, "subroutine inside", 1.0, 0.0, message);
                }
                name_subroutine(&mut structure, block, index, error);
                open.push(Open { block: index, op });
            }
            Op::EndDo | Op::EndSub => match open.pop_if(|top| closes(op, top.op)) {
                Some(top) if op == Op::EndSub => {
                    structure.end_of_sub.insert(top.block, index);
                }
                Some(_) => {}
                None => {
                    error(index + 1, "not open", 0.0, 1.0, format!("{} closes nothing that is open.", op.mnemonic()));
                }
            },
            _ => {}
        }
    }
    for top in open {
        error(
            top.block + 1,
            "not closed",
            0.0,
            1.0,
            format!("The {} of this block is never closed.", top.op.mnemonic()),
        );
    }
    structure
}

fn name_subroutine(
    structure: &mut Structure,
    block: &Block,
    index: usize,
    error: &mut impl FnMut(usize, &'static str, f64, f64, String),
) {
    let Some(number) = block.value(Word::Number).map(whole) else { return };
    if let Some(first) = structure.subs.get(&number) {
        let message = format!("Subroutine {number} starts here and in block {}.", first + 1);
        error(index + 1, "double subroutine", number as f64, 0.0, message);
    } else {
        structure.subs.insert(number, index);
    }
}

fn closes(end: Op, start: Op) -> bool {
    matches!((end, start), (Op::EndDo, Op::Do) | (Op::EndSub, Op::Sub))
}

/// A value that the reader has checked to be whole and not negative.
#[allow(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "the reader bounds whole words to 0..=99999"
)]
pub(super) fn whole(value: f64) -> u64 {
    value.max(0.0) as u64
}
