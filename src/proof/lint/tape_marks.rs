//! `%` before and behind a program: without the first some controls skip everything, without the second they wait for more.

use super::{Program, Remark};
use crate::machine::Dialect;

pub(super) fn check(program: &Program<'_>) -> Vec<Remark> {
    let (opened, closed) = (program.tape.opened, program.tape.closed);
    let last = program.tape.blocks.len();
    let mut remarks = Vec::new();
    // LinuxCNC takes a program without marks that ends with M2 or M30, but not one with the first mark alone.
    let linuxcnc = program.machine.dialect == Dialect::Linuxcnc;
    let demanded = if linuxcnc { opened } else { program.words.tape_marks };
    if demanded && !opened {
        let message = "The line % that begins a tape is missing: the control skips everything before it.".to_owned();
        remarks.push(Remark::error(1, 0.0, 1.0, message));
    }
    if demanded && !closed {
        let message = "The line % that ends a tape is missing: the control waits for more.".to_owned();
        remarks.push(Remark::error(last, 0.0, 1.0, message));
    }
    remarks
}

#[cfg(test)]
mod tests {
    use super::super::fixture::blocks;
    use super::*;

    #[test]
    fn fires() {
        assert_eq!(blocks(check, "fanuc-0i", "O1\nM30"), [1, 2]);
        assert_eq!(blocks(check, "fanuc-0i", "%\nO1\nM30"), [3]);
        assert_eq!(blocks(check, "linuxcnc", "%\nG0 X1\nM2"), [3]);
    }

    #[test]
    fn does_not_fire() {
        assert_eq!(blocks(check, "fanuc-0i", "%\nO1\nM30\n%"), [0_usize; 0]);
        assert_eq!(blocks(check, "linuxcnc", "G0 X1\nM2"), [0_usize; 0]);
        assert_eq!(blocks(check, "mori-fanuc-6t", "O1\nM30"), [0_usize; 0]);
    }
}
