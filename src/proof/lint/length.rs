//! Lengths of words, lines and programs: what does not fit is cut off or refused.

use super::{Program, Remark};

pub(super) fn check(program: &Program<'_>) -> Vec<Remark> {
    let mut remarks = Vec::new();
    if let Some(most) = program.words.max_line_chars {
        for (line, text) in program.lines() {
            let count = text.chars().count();
            if count > most {
                let message = format!("Line {line} has {count} characters; the control takes {most}.");
                remarks.push(Remark::error(program.block_at(line), count as f64, most as f64, message));
            }
        }
    }
    memory(program, &mut remarks);
    for (block, words) in program.blocks() {
        for word in &words.words {
            let (letter, digits) = (word.letter, word.number.digits_before());
            let most = if "XZUWIKR".contains(letter) && word.number.has_point() {
                program.words.digits_before
            } else if word.number.has_point() {
                continue;
            } else {
                program.words.digits.get(&letter).map_or(u8::MAX, |d| d.most)
            };
            if digits > most {
                let message =
                    format!("The word {letter} has {digits} digits before its point; the control takes {most}.");
                remarks.push(Remark::error(block, f64::from(digits), f64::from(most), message));
            }
        }
    }
    remarks
}

fn memory(program: &Program<'_>, remarks: &mut Vec<Remark>) {
    let (blocks, most) = (program.tape.blocks.len(), program.machine.limits.blocks_per_program);
    if blocks > most {
        let message = format!("The program has {blocks} blocks; the control takes {most}.");
        remarks.push(Remark::error(most + 1, blocks as f64, most as f64, message));
    }
    let count = program.text.chars().count();
    if let Some(most) = program.words.max_program_chars.filter(|&most| count > most) {
        let message =
            format!("The program has {count} characters; the control's memory takes {most}. Run it in parts.");
        remarks.push(Remark::warning(blocks, count as f64, most as f64, message));
    }
}

#[cfg(test)]
mod tests {
    use super::super::fixture::blocks;
    use super::*;

    #[test]
    fn fires() {
        let long = format!("G01 {}", "W0000001 ".repeat(10));
        assert_eq!(blocks(check, "swedish-1970s", &long), [1]);
        assert_eq!(blocks(check, "fanuc-0i", "O1\nG1 X123456.0\nG0 Z1. M1234"), [2, 3]);
        assert_eq!(blocks(check, "mori-fanuc-6t", &"N1G1X1.\n".repeat(1999)), [1999, 1999]);
    }

    #[test]
    fn does_not_fire() {
        assert_eq!(blocks(check, "swedish-1970s", "N001G01W0001500F0100"), [0_usize; 0]);
        assert_eq!(blocks(check, "fanuc-0i", "O0001\nG1 X12345.000 S4000"), [0_usize; 0]);
    }
}
