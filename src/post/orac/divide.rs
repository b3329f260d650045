//! Divides the moves of a file that is too long for one program.
//!
//! A part ends between two instructions outside of a loop: best where the tool is at the datum's radius, else anywhere. From
//! there the tool goes straight out and back to the datum; the next part brings it to the same place by the same way. Outside
//! turning never has material above the tool's point, so the way is free. A loop too long for a program is written out.

use super::instruction::Instruction;

/// Blocks of the longest way from or to the datum: one move across and one along the spindle.
const LONGEST_WAY: usize = 2;

/// A part of a file that begins and ends at the datum.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Part {
    pub(super) instructions: Vec<Instruction>,
}

impl Part {
    /// A file that needs no division.
    pub(super) fn whole(body: &[Instruction]) -> Self {
        Self { instructions: body.to_vec() }
    }
}

/// Instructions that stay together, a single one or a whole loop, and where the tool is afterwards, as a distance from the
/// datum in thousandths.
struct Atom {
    instructions: Vec<Instruction>,
    after: (i32, i32),
}

/// `body` in parts of at most `room` blocks. A single instruction is kept even if `room` is too small for it.
pub(super) fn divide(body: &[Instruction], room: usize) -> Vec<Part> {
    let atoms = atoms(body, room.saturating_sub(2 * LONGEST_WAY));
    let travel_feed = body.iter().filter_map(|i| speeds(i).map(|s| s.0)).max().unwrap_or_default();
    let mut parts = Vec::new();
    let mut rest = atoms.as_slice();
    let mut at = (0, 0);
    while !rest.is_empty() {
        let count = fitting(rest, at, room);
        let (now, later) = rest.split_at(count);
        parts.push(part(now, at, travel_feed));
        at = now.last().map_or(at, |a| a.after);
        rest = later;
    }
    parts
}

/// How many atoms the next part takes, at least one: as many as fit, or up to the last place at the datum's radius if that
/// leaves at least half of them.
fn fitting(atoms: &[Atom], at: (i32, i32), room: usize) -> usize {
    let mut length = way(at);
    let mut most = 1;
    for (k, atom) in atoms.iter().enumerate() {
        length += atom.instructions.len();
        if length > room {
            break;
        }
        if length + way(atom.after) <= room {
            most = k + 1;
        }
    }
    if most == atoms.len() {
        return most;
    }
    let is_out = |count: &usize| atoms.get(count - 1).is_some_and(|a| a.after.0 == 0);
    (most.div_ceil(2)..=most).rev().find(is_out).unwrap_or(most)
}

/// Blocks needed between a place and the datum.
fn way(at: (i32, i32)) -> usize {
    usize::from(at.0 != 0) + usize::from(at.1 != 0)
}

fn part(atoms: &[Atom], from: (i32, i32), feed: i32) -> Part {
    let mut instructions: Vec<Instruction> = atoms.iter().flat_map(|a| a.instructions.iter().copied()).collect();
    let to = atoms.last().map_or(from, |a| a.after);
    let mut moves = |at: usize, x: i32, z: i32, like: Option<(i32, i32, i32)>| {
        if let Some((_, tool, rpm)) = like.filter(|_| (x, z) != (0, 0)) {
            instructions.insert(at.min(instructions.len()), Instruction::Ptp { x, z, feed, tool, rpm });
        }
    };
    let first = atoms.iter().flat_map(|a| &a.instructions).find_map(speeds);
    let last = atoms.iter().rev().flat_map(|a| a.instructions.iter().rev()).find_map(speeds);
    moves(0, from.0, 0, first);
    moves(0, 0, from.1, first);
    moves(usize::MAX, -to.0, 0, last);
    moves(usize::MAX, 0, -to.1, last);
    Part { instructions }
}

/// Feed, tool and speed of a move.
const fn speeds(instruction: &Instruction) -> Option<(i32, i32, i32)> {
    match *instruction {
        Instruction::Ptp { feed, tool, rpm, .. } | Instruction::Circ { feed, tool, rpm, .. } => Some((feed, tool, rpm)),
        _ => None,
    }
}

/// The body as atoms of at most `longest` instructions; longer loops are written out.
fn atoms(body: &[Instruction], longest: usize) -> Vec<Atom> {
    let mut atoms = Vec::new();
    let mut at = (0, 0);
    let mut rest = body.to_vec();
    rest.reverse();
    while let Some(next) = rest.pop() {
        let mut instructions = vec![next];
        if let Instruction::Do { count } = next {
            take_loop(&mut rest, &mut instructions);
            if instructions.len() > longest {
                let inner = instructions.get(1..instructions.len().saturating_sub(1)).unwrap_or_default();
                for _ in 0..count {
                    rest.extend(inner.iter().rev());
                }
                continue;
            }
        }
        let step = travel(&instructions);
        at = (at.0 + step.0, at.1 + step.1);
        atoms.push(Atom { instructions, after: at });
    }
    atoms
}

/// Moves the rest of a loop, up to its matching end, from `rest` (reversed) to `taken`.
fn take_loop(rest: &mut Vec<Instruction>, taken: &mut Vec<Instruction>) {
    let mut depth = 1;
    while depth > 0
        && let Some(next) = rest.pop()
    {
        match next {
            Instruction::Do { .. } => depth += 1,
            Instruction::Edo => depth -= 1,
            _ => {}
        }
        taken.push(next);
    }
}

/// The way that incremental moves lead, loops counted as often as they are run.
pub(super) fn travel(instructions: &[Instruction]) -> (i32, i32) {
    let mut loops = vec![1_i32];
    let mut sum = (0_i32, 0_i32);
    for instruction in instructions {
        let times = loops.last().copied().unwrap_or(1);
        match *instruction {
            Instruction::Do { count } => loops.push(times.saturating_mul(count)),
            Instruction::Edo => {
                loops.pop();
            }
            Instruction::Ptp { x, z, .. } | Instruction::Circ { x, z, .. } => {
                sum = (sum.0.saturating_add(x.saturating_mul(times)), sum.1.saturating_add(z.saturating_mul(times)));
            }
            _ => {}
        }
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const TRAVEL: i32 = 1000;

    fn ptp(x: i32, z: i32, feed: i32) -> Instruction {
        Instruction::Ptp { x, z, feed, tool: 1, rpm: 500 }
    }

    /// Every place that a cutting move reaches, loops run.
    fn cuts(instructions: &[Instruction]) -> Vec<(i32, i32)> {
        let mut at = (0, 0);
        let single = atoms(instructions, 0);
        let mut reached = Vec::new();
        for atom in single {
            if speeds(&atom.instructions[0]).is_some_and(|s| s.0 != TRAVEL) {
                reached.push(atom.after);
            }
            at = atom.after;
        }
        assert_eq!(at, (0, 0), "ends at the datum");
        reached
    }

    fn any_body() -> impl Strategy<Value = Vec<Instruction>> {
        let step = (-9..=9_i32, -9..=9_i32).prop_map(|(x, z)| ptp(x, z, 80));
        let stroke = proptest::collection::vec(step, 1..8);
        let repeated = (stroke.clone(), 1..5_i32).prop_map(|(body, count)| {
            let mut all = vec![Instruction::Do { count }];
            all.extend(body);
            all.push(Instruction::Edo);
            all
        });
        proptest::collection::vec(prop_oneof![stroke, repeated], 1..12).prop_map(|strokes| {
            let mut all = vec![ptp(0, -20, TRAVEL)];
            all.extend(strokes.concat());
            let (x, z) = travel(&all);
            all.extend([ptp(-x, 0, TRAVEL), ptp(0, -z, TRAVEL)]);
            all
        })
    }

    proptest! {
        #[test]
        fn parts_fit_end_at_the_datum_and_cut_the_same_places(body in any_body(), room in 6..30_usize) {
            let parts = divide(&body, room);
            prop_assert!(parts.iter().all(|p| p.instructions.len() <= room));
            let reached: Vec<_> = parts.iter().flat_map(|p| cuts(&p.instructions)).collect();
            prop_assert_eq!(reached, cuts(&body));
        }
    }

    #[test]
    fn a_part_ends_at_the_datums_radius_where_it_can() {
        let stroke = [ptp(-5, 0, 80), ptp(0, -3, 80), ptp(0, 3, TRAVEL), ptp(5, 0, TRAVEL)];
        let mut body = vec![ptp(0, -20, TRAVEL)];
        body.extend(stroke.iter().cycle().take(20));
        body.push(ptp(0, 20, TRAVEL));
        for part in divide(&body, 12) {
            let ways = part.instructions.iter().filter(|i| **i == ptp(0, -20, TRAVEL) || **i == ptp(0, 20, TRAVEL));
            assert_eq!(ways.count(), 2);
        }
    }
}
