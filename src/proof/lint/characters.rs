//! Characters that the control's code does not have.

use super::{Program, Remark};
use crate::machine::Dialect;

/// Signs of the ISO code of tapes besides capitals, digits and blanks (ISO 840 as Fanuc controls read it).
const ISO_SIGNS: &str = "%()+-./:;,=#[]*&<>?!@\"'$_";

pub(super) fn check(program: &Program<'_>) -> Vec<Remark> {
    program.lines().filter_map(|(line, text)| remark(program, line, text)).collect()
}

fn remark(program: &Program<'_>, line: usize, text: &str) -> Option<Remark> {
    let fanuc = program.machine.dialect == Dialect::Fanuc;
    let text = text.trim_matches(|c: char| c.is_control() || c == '\u{feff}');
    let known = |c: char| {
        if fanuc {
            c.is_ascii_uppercase() || c.is_ascii_digit() || c == ' ' || ISO_SIGNS.contains(c)
        } else {
            !c.is_control() || c == '\t'
        }
    };
    let bad = text.chars().find(|&c| !known(c))?;
    let block = program.block_at(line);
    let why = if bad.is_ascii_lowercase() { "; the control has capitals only" } else { "" };
    let message = format!(
        "Line {line} has the character \"{}\", which the control's code does not have{why}.",
        bad.escape_default()
    );
    // A comment may lose a character on the way; a word may not.
    let in_comment = text.find(bad).is_some_and(|at| text[..at].matches('(').count() > text[..at].matches(')').count());
    let count = text.chars().filter(|&c| !known(c)).count() as f64;
    Some(if in_comment {
        Remark::warning(block, count, 0.0, message)
    } else {
        Remark::error(block, count, 0.0, message)
    })
}

#[cfg(test)]
mod tests {
    use super::super::fixture::{blocks, remarks};
    use super::*;
    use crate::diagnostic::Severity;

    #[test]
    fn fires() {
        assert_eq!(blocks(check, "fanuc-0i", "O1\nG1 X1.\ng0 Z1.\n"), [3]);
        assert_eq!(blocks(check, "fanuc-0i", "O1\nG1 X1.\u{e4}\n"), [2]);
        assert_eq!(remarks(check, "fanuc-0i", "O1(Stütze)\n")[0].severity, Severity::Warning);
        assert_eq!(blocks(check, "linuxcnc", "G0 X1\nG1\u{7} X1"), [2]);
    }

    #[test]
    fn does_not_fire() {
        assert_eq!(
            blocks(check, "fanuc-0i", "\u{12}%\r\nO0001(ROLL 1470B-2T, D=150.)\r\nG1X-1.\r\n%\u{14}"),
            [0_usize; 0]
        );
        assert_eq!(blocks(check, "linuxcnc", "g0 x1 (Stütze)\n"), [0_usize; 0]);
    }
}
