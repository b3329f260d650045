//! G28 goes over the place that its axis words say. With X0 Z0 that is the program zero: through the work.

use super::{Program, Remark, has};
use crate::machine::Dialect;

pub(super) fn check(program: &Program<'_>) -> Vec<Remark> {
    let fanuc = program.machine.dialect == Dialect::Fanuc;
    let mut absolute = true;
    let mut remarks = Vec::new();
    for (block, words) in program.blocks() {
        if !fanuc {
            absolute = (absolute || has(words, 'G', 90.0)) && !has(words, 'G', 91.0);
        }
        if absolute && (has(words, 'G', 28.0) || has(words, 'G', 30.0)) && (words.has('X') || words.has('Z')) {
            let way = if fanuc { "U0 and W0" } else { "no axis words, or G91" };
            let message = format!(
                "G28 goes over the place that X and Z say, in program coordinates; {way} would leave from where the tool is."
            );
            remarks.push(Remark::warning(block, 1.0, 0.0, message));
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
        assert_eq!(blocks(check, "fanuc-0i", "O1\nG28 X0 Z0"), [2]);
        assert_eq!(blocks(check, "linuxcnc", "G91\nG28 X0\nG90\nG28 Z0"), [4]);
    }

    #[test]
    fn does_not_fire() {
        assert_eq!(blocks(check, "fanuc-0i", "O1\nG28 U0\nG28 W0\nG0 X1. Z1."), [0_usize; 0]);
        assert_eq!(blocks(check, "linuxcnc", "G28\nG91 G28 Z0"), [0_usize; 0]);
    }
}
