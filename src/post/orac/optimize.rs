//! OPTIMIZE: fewer instructions for the same cuts, by the published program's rules.
//!
//! Instructions are taken one after the other; whenever the last ones match a rule they are replaced:
//! 1. a move of zero is dropped;
//! 2. a retraction followed at once by a deeper infeed becomes one infeed;
//! 3. along, out, along towards the chuck, deeper in, along: the three in the middle become one diagonal;
//! 4. two moves along the spindle in the same direction with the same feed, tool and speed become one.
//!
//! Rules 1 to 3 turn the printed 124 instructions of the queen into the printed 91; rule 4 explains the printed number of
//! the master's second file. Rule 3 has a guard of ours that changes none of the printed files: the diagonal stays over what
//! has just been cut, for beyond it a wall may stand. The rule sees the text only: over the crown of a large arc the straight
//! diagonal cuts up to a quarter of the roughing depth below the curve, of which the finishing allowance takes most; the
//! proof shows what remains.

use super::instruction::Instruction;
use Instruction::Ptp;

/// Thousandths of a mm by which two rounded lengths that are equal may differ.
const ROUNDING: i32 = 1;

/// The instructions of one file, shortened. Moves are taken as increments unless the absolute format is switched on; what is
/// absolute stays as it is.
#[must_use]
pub fn optimize(instructions: &[Instruction]) -> Vec<Instruction> {
    let mut out: Vec<Instruction> = Vec::with_capacity(instructions.len());
    let mut window = 0;
    let mut incremental = true;
    for &instruction in instructions {
        match instruction {
            Instruction::Inc => incremental = true,
            Instruction::Abs => incremental = false,
            _ => {}
        }
        out.push(instruction);
        if !incremental {
            window = out.len();
        }
        while let Some((count, shorter)) = shorter(out.get(window..).unwrap_or_default()) {
            out.truncate(out.len() - count);
            out.extend(shorter);
        }
    }
    out
}

/// How many of the last instructions a rule replaces, and by what.
fn shorter(tail: &[Instruction]) -> Option<(usize, Vec<Instruction>)> {
    match *tail {
        [.., Ptp { x: 0, z: 0, .. }] => Some((1, Vec::new())),
        [.., Ptp { x: out, z: 0, tool: before, .. }, Ptp { x, z: 0, feed, tool, rpm }]
            if out > 0 && x < -out && before == tool =>
        {
            Some((2, vec![Ptp { x: x + out, z: 0, feed, tool, rpm }]))
        }
        [.., Ptp { x: 0, z: a, feed: f, tool: t, rpm: r }, Ptp { x: 0, z: b, feed, tool, rpm }]
            if a.signum() == b.signum() && (f, t, r) == (feed, tool, rpm) =>
        {
            Some((2, vec![Ptp { x: 0, z: a.saturating_add(b), feed, tool, rpm }]))
        }
        [
            ..,
            Ptp { x: 0, z: back, tool: t, .. },
            Ptp { x: out, z: 0, .. },
            Ptp { x: 0, z: shift, .. },
            Ptp { x, z: 0, feed, tool, rpm },
            cut @ Ptp { x: 0, z: along, .. },
        ] if out > 0 && x < -out && t == tool && diagonal_is_free(back, shift, x + out, along) => {
            Some((4, vec![Ptp { x: x + out, z: shift, feed, tool, rpm }, cut]))
        }
        _ => None,
    }
}

/// True if the diagonal by `infeed` (negative) and `shift` stays over what is cut. `back` is the travel back over the last
/// cut, `along` the next cut.
///
/// Towards the chuck the shift must not leave the run just cut. Away from the chuck it leads over the right-hand tool's
/// 45-degree line and must not be flatter than that.
fn diagonal_is_free(back: i32, shift: i32, infeed: i32, along: i32) -> bool {
    let towards_chuck = back > 0 && along < 0;
    let from_chuck = back < 0 && along > 0;
    shift < 0 && ((towards_chuck && -shift <= back) || (from_chuck && -shift <= -infeed + ROUNDING))
}

#[cfg(test)]
mod tests {
    use super::super::text::parse_instructions;
    use super::*;

    fn list(lines: &str) -> Vec<Instruction> {
        let (list, diagnostics) = parse_instructions(lines, "A.anc");
        assert_eq!(diagnostics, []);
        list
    }

    #[test]
    fn a_retraction_and_a_deeper_infeed_become_one_but_not_equal_ones() {
        let deeper = list("PTP 2 0 1000 1 1214\nPTP 0 0 1000 1 1262\nPTP -2.8 0 80 1 1262");
        assert_eq!(optimize(&deeper), list("PTP -0.8 0 80 1 1262"));
        let equal = list("PTP 8.4 0 1000 1 1598\nPTP -8.4 0 1000 1 1646\nDO 5");
        assert_eq!(optimize(&equal), equal);
    }

    #[test]
    fn the_diagonal_works_for_both_hands() {
        let right = "PTP 0 5 1000 1 9\nPTP 2 0 1000 1 9\nPTP 0 -0.8 1000 1 8\nPTP -2.8 0 80 1 8\nPTP 0 -4 80 1 8";
        assert_eq!(optimize(&list(right)), list("PTP 0 5 1000 1 9\nPTP -0.8 -0.8 80 1 8\nPTP 0 -4 80 1 8"));
        let left = "PTP 0 -5 1000 2 9\nPTP 2 0 1000 2 9\nPTP 0 -0.8 1000 2 8\nPTP -2.8 0 80 2 8\nPTP 0 4 80 2 8";
        assert_eq!(optimize(&list(left)), list("PTP 0 -5 1000 2 9\nPTP -0.8 -0.8 80 2 8\nPTP 0 4 80 2 8"));
    }

    #[test]
    fn no_diagonal_leads_out_of_what_was_cut() {
        let over_a_wall =
            list("PTP 0 5 1000 1 9\nPTP 2 0 1000 1 9\nPTP 0 -8 1000 1 8\nPTP -2.8 0 80 1 8\nPTP 0 -4 80 1 8");
        assert_eq!(optimize(&over_a_wall), over_a_wall);
    }

    #[test]
    fn absolute_positions_are_left_alone() {
        let absolute = list("ABS\nPTP 0 0 80 1 9\nPTP 0 -5 80 1 9\nPTP 0 -9 80 1 9");
        assert_eq!(optimize(&absolute), absolute);
        let back = list("ABS\nPTP 0 0 80 1 9\nINC\nPTP 0 0 80 1 9");
        assert_eq!(optimize(&back), list("ABS\nPTP 0 0 80 1 9\nINC"));
    }
}
