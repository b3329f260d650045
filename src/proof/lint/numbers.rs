//! Program numbers (O) and sequence numbers (N).

use super::{Program, Remark};
use std::collections::HashMap;

pub(super) fn check(program: &Program<'_>) -> Vec<Remark> {
    let mut remarks = Vec::new();
    program_number(program, &mut remarks);
    double_programs(program, &mut remarks);
    sequence_numbers(program, &mut remarks);
    remarks
}

/// A control that stores programs by number cannot store one without.
fn program_number(program: &Program<'_>, remarks: &mut Vec<Remark>) {
    let Some(wanted) = program.words.program_number.as_ref().filter(|n| n.prefix == "O") else { return };
    if program.blocks().next().is_none_or(|(_, b)| !b.has('O')) {
        let example = format!("{}{:0width$}", wanted.prefix, wanted.first, width = usize::from(wanted.digits));
        let message =
            format!("The program does not begin with its number, such as {example}; the control stores it under one.");
        remarks.push(Remark::error(1, 0.0, 1.0, message));
    }
}

fn double_programs(program: &Program<'_>, remarks: &mut Vec<Remark>) {
    let mut first: HashMap<u32, usize> = HashMap::new();
    for (block, words) in program.blocks() {
        let Some(number) = words.number('O').and_then(|o| o.whole()) else { continue };
        if let Some(before) = first.get(&number) {
            let message = format!(
                "Program number O{number:04} stands here and in block {before}; the second replaces the first or is refused."
            );
            remarks.push(Remark::error(block, f64::from(number), 0.0, message));
        } else {
            first.insert(number, block);
        }
    }
}

/// A number that stands twice within a program makes jumps and contours ambiguous, and searching for a block too.
fn sequence_numbers(program: &Program<'_>, remarks: &mut Vec<Remark>) {
    let mut first: HashMap<u32, usize> = HashMap::new();
    let (mut missing, mut at) = (0_u32, 0);
    for (block, words) in program.blocks() {
        if words.has('O') {
            first.clear();
            continue;
        }
        match words.printed {
            None => {
                missing += 1;
                at = if at == 0 { block } else { at };
            }
            Some(n) => {
                if let Some(before) = first.insert(n, block) {
                    let message = format!(
                        "N{n} stands here and in block {before}; a search or a cycle that names it finds the wrong one."
                    );
                    remarks.push(Remark::warning(block, f64::from(n), 0.0, message));
                }
            }
        }
    }
    if missing > 0 && program.words.sequence_numbers.is_some() && !first.is_empty() {
        let message =
            format!("{missing} blocks have no sequence number, the first one here; a restart cannot search for them.");
        remarks.push(Remark::info(at, f64::from(missing), 0.0, message));
    }
}

#[cfg(test)]
mod tests {
    use super::super::fixture::{blocks, remarks};
    use super::*;

    #[test]
    fn fires() {
        assert_eq!(blocks(check, "fanuc-0i", "N10 G0 X1."), [1]);
        assert_eq!(blocks(check, "fanuc-0i", "O1\nN10 M30\nO1\nN10 M99"), [3]);
        assert_eq!(blocks(check, "fanuc-0i", "O1\nN10 G0 X1.\nN10 M30"), [3]);
        assert_eq!(remarks(check, "fanuc-0i", "O1\nN10 G0 X1.\nM30")[0].block, 3);
    }

    #[test]
    fn does_not_fire() {
        assert_eq!(blocks(check, "fanuc-0i", "O1\nN10 G0 X1.\nN20 M30\nO2\nN10 M99"), [0_usize; 0]);
        assert_eq!(blocks(check, "fanuc-0i", "O1\nG0 X1.\nM30"), [0_usize; 0]);
        assert_eq!(blocks(check, "linuxcnc", "G0 X1\nM2"), [0_usize; 0]);
    }
}
