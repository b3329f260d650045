//! Millimetres and inches in one program.

use super::{Program, Remark, has};

pub(super) fn check(program: &Program<'_>) -> Vec<Remark> {
    let mut first: Option<(usize, bool)> = None;
    for (block, words) in program.blocks() {
        for (code, inch) in [(20.0, true), (21.0, false)] {
            if !has(words, 'G', code) {
                continue;
            }
            match first {
                Some((before, unit)) if unit != inch => {
                    let message = format!(
                        "The program changes its unit here (G{code}; block {before} has the other): lengths before and behind differ by 25.4."
                    );
                    return vec![Remark::error(block, code, 0.0, message)];
                }
                Some(_) => {}
                None => first = Some((block, inch)),
            }
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
        assert_eq!(blocks(check, "fanuc-0i", "O1\nG21\nG0 X1.\nG20"), [4]);
    }

    #[test]
    fn does_not_fire() {
        assert_eq!(blocks(check, "fanuc-0i", "O1\nG21\nG0 X1.\nG21"), [0_usize; 0]);
    }
}
