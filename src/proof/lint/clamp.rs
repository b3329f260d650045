//! Constant cutting speed needs a highest speed: towards the axis the spindle would run as fast as it can.

use super::{Program, Remark, has};
use crate::machine::ClampWord;

pub(super) fn check(program: &Program<'_>) -> Vec<Remark> {
    // Where speeds stay low by the diameters that are turned, programs are written without.
    let Some(word) = program.words.clamp_word.filter(|_| !program.words.clamp_where_reached) else { return Vec::new() };
    let (g, letter, shown) = match word {
        ClampWord::G50 => (50.0, 'S', "G50 S"),
        ClampWord::G92 => (92.0, 'S', "G92 S"),
        ClampWord::OnG96 => (96.0, 'D', "D in the block of G96"),
    };
    let mut clamped = false;
    for (block, words) in program.blocks() {
        clamped |= has(words, 'G', g) && words.has(letter);
        if has(words, 'G', 96.0) && !clamped {
            let limit = program.machine.rpm_limit();
            let message = format!(
                "Constant cutting speed (G96) starts without a highest speed ({shown}): near the axis the spindle runs up to its \
                 limit of {limit:.0} rev/min, whatever chuck and work can bear."
            );
            return vec![Remark::warning(block, 0.0, 1.0, message)];
        }
    }
    Vec::new()
}

#[cfg(test)]
mod tests {
    use super::super::fixture::blocks;
    use super::*;

    #[test]
    fn fires() {
        assert_eq!(blocks(check, "fanuc-0i", "O1\nG96 S200 M03\nG50 S2000"), [2]);
        assert_eq!(blocks(check, "linuxcnc", "G96 S200 M3"), [1]);
    }

    #[test]
    fn does_not_fire() {
        assert_eq!(blocks(check, "fanuc-0i", "O1\nG50 S2000\nG96 S200 M03"), [0_usize; 0]);
        assert_eq!(blocks(check, "linuxcnc", "G96 D2000 S200 M3"), [0_usize; 0]);
        assert_eq!(blocks(check, "mori-fanuc-6t", "O1\nG96S200M03"), [0_usize; 0]);
        assert_eq!(blocks(check, "swedish-1970s", "G97 S05 M03"), [0_usize; 0]);
    }
}
