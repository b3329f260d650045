//! A program must end with M30 or M02, and should stop the spindle itself.

use super::{Program, Remark, has};

pub(super) fn check(program: &Program<'_>) -> Vec<Remark> {
    let count = program.tape.blocks.len();
    let end = program.blocks().find(|(_, b)| has(b, 'M', 30.0) || has(b, 'M', 2.0)).map(|(block, _)| block);
    let Some(end) = end else {
        let message =
            "The program has no end (M30 or M02): the control would run on into what stands behind it in its memory.";
        return vec![Remark::error(count, 0.0, 1.0, message.to_owned())];
    };
    let turns = |b: &super::WordBlock| has(b, 'M', 3.0) || has(b, 'M', 4.0);
    let last = |test: &dyn Fn(&super::WordBlock) -> bool| {
        program.blocks().rev().find(|(block, b)| *block <= end && test(b)).map(|(block, _)| block)
    };
    let stops = last(&|b| has(b, 'M', 5.0)).unwrap_or(0);
    match (last(&turns), &program.words.codes.spindle_stop) {
        (Some(on), Some(stop)) if on > stops => {
            let message = format!(
                "The spindle is not stopped by {stop} before the end; that M30 stops it is the machine builder's choice."
            );
            vec![Remark::info(end, 0.0, 1.0, message)]
        }
        _ => Vec::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::super::fixture::remarks;
    use super::*;
    use crate::diagnostic::Severity;

    #[test]
    fn fires() {
        assert_eq!(remarks(check, "fanuc-0i", "O1\nM03\nM05")[0].severity, Severity::Error);
        assert_eq!(remarks(check, "fanuc-0i", "O1\nM05\nM03\nM30")[0].severity, Severity::Info);
    }

    #[test]
    fn does_not_fire() {
        for text in ["O1\nM03\nM05\nM30\nO2\nM99", "O1\nG0 X1.\nM02", "O1\nM03\nM05 M30"] {
            assert_eq!(remarks(check, "fanuc-0i", text), []);
        }
        assert_eq!(remarks(check, "mori-fanuc-6t", "O1\nM03\nM30"), []);
    }
}
