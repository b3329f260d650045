//! A length without decimal point counts least increments: `X150` is 0.15 mm.

use super::{Program, Remark};
use crate::machine::{DecimalPoint, Dialect};

/// Words that are lengths wherever they stand. P, Q and D count increments by rule; I and K are lengths in arcs and threads.
const LENGTHS: [char; 7] = ['X', 'Z', 'U', 'W', 'I', 'K', 'R'];

pub(super) fn check(program: &Program<'_>) -> Vec<Remark> {
    let always = program.words.decimal_point == DecimalPoint::Always;
    if !always || program.machine.dialect != Dialect::Fanuc {
        return Vec::new();
    }
    let mut remarks = Vec::new();
    for (block, words) in program.blocks() {
        // The number of cuts of G73 is a whole number.
        let counts = super::has(words, 'G', 73.0) && !words.has('P');
        for word in words.words.iter().filter(|w| LENGTHS.contains(&w.letter) && !(counts && w.letter == 'R')) {
            let plain = word.number.plain();
            if !word.number.has_point() && plain != 0.0 {
                let read = word.number.in_increments(program.words.decimals_mm, program.words);
                let message = format!(
                    "{}{plain} has no decimal point: the control counts least increments and reads {read} mm.",
                    word.letter
                );
                remarks.push(Remark::error(block, plain, read, message));
            }
        }
    }
    remarks
}

#[cfg(test)]
mod tests {
    use super::super::fixture::blocks;
    use super::*;

    #[test]
    fn fires() {
        assert_eq!(blocks(check, "fanuc-0i", "O1\nG1 X150 Z1.\nZ-2"), [2, 3]);
    }

    #[test]
    fn does_not_fire() {
        assert_eq!(
            blocks(check, "fanuc-0i", "O1\nG28 U0 W0\nG1 X150. Z0 F200 S500\nG71 P10 Q20 U.5 W.1"),
            [0_usize; 0]
        );
        assert_eq!(blocks(check, "swedish-1970s", "G01 W0001500"), [0_usize; 0]);
        assert_eq!(blocks(check, "linuxcnc", "G1 X150"), [0_usize; 0]);
    }
}
