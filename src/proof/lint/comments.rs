//! Comments: controls take the first `)` as the end, so a comment within a comment leaves text behind that is run.

use super::{Program, Remark};
use crate::machine::Comments;

pub(super) fn check(program: &Program<'_>) -> Vec<Remark> {
    program.lines().filter_map(|(line, text)| remark(program, line, text)).collect()
}

fn remark(program: &Program<'_>, line: usize, text: &str) -> Option<Remark> {
    let block = program.block_at(line);
    if program.words.comments == Comments::None {
        let message = format!("Line {line} has a comment; the control knows none and reads it as words.");
        return text.contains('(').then(|| Remark::error(block, 1.0, 0.0, message));
    }
    let mut depth = 0_u32;
    let mut deepest = 0;
    for c in text.chars() {
        match c {
            '(' => depth += 1,
            ')' => depth = depth.saturating_sub(1),
            _ => {}
        }
        deepest = deepest.max(depth);
    }
    let message = format!(
        "Line {line} has a comment within a comment; the control ends both at the first \")\" and runs the rest."
    );
    (deepest > 1).then(|| Remark::error(block, f64::from(deepest), 1.0, message))
}

#[cfg(test)]
mod tests {
    use super::super::fixture::blocks;
    use super::*;

    #[test]
    fn fires() {
        assert_eq!(blocks(check, "fanuc-0i", "O1\nG1 X1. (A (B) C)"), [2]);
        assert_eq!(blocks(check, "mori-fanuc-6t", "O1\nG1 X1. (A)"), [2]);
    }

    #[test]
    fn does_not_fire() {
        assert_eq!(blocks(check, "fanuc-0i", "O1 (A) (B)\nG1 X1. (C)"), [0_usize; 0]);
        assert_eq!(blocks(check, "mori-fanuc-6t", "O1\nG1 X1."), [0_usize; 0]);
    }
}
