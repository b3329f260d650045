//! Nose radius compensation that is still in force where the tool changes, goes home, or the program ends shifts what follows by
//! the nose, or stops the control with an alarm.

use super::{Program, Remark, has};

pub(super) fn check(program: &Program<'_>) -> Vec<Remark> {
    let mut remarks = Vec::new();
    let mut since: Option<(usize, f64)> = None;
    for (block, words) in program.blocks() {
        let starts = [41.0, 42.0].into_iter().find(|g| has(words, 'G', *g));
        if has(words, 'G', 40.0) {
            since = None;
        } else if let Some(g) = starts {
            since = Some((block, g));
        }
        let ends = [
            (has(words, 'M', 30.0) || has(words, 'M', 2.0), "the program ends"),
            (words.has('T'), "the tool changes"),
            (has(words, 'G', 28.0), "the tool goes to its reference point"),
        ];
        let met = ends.into_iter().find(|(here, _)| *here);
        if let Some(((begun, g), (_, what))) = since.filter(|_| starts.is_none()).zip(met) {
            let message = format!(
                "G{g} of block {begun} is not cancelled by G40 before {what} here: what follows is shifted by the nose radius or stops with an alarm."
            );
            remarks.push(Remark::warning(block, g, 40.0, message));
            since = None;
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
        assert_eq!(blocks(check, "fanuc-0i", "O1\nG42 G1 X20. F.1\nZ-10.\nM30"), [4]);
        assert_eq!(blocks(check, "fanuc-0i", "O1\nG41 G1 X20. F.1\nG28 U0.\nG40 M30"), [3]);
        assert_eq!(blocks(check, "linuxcnc", "G42 G1 X20\nT2 M6 G43\nM2"), [2]);
    }

    #[test]
    fn does_not_fire() {
        assert_eq!(
            blocks(check, "fanuc-0i", "O1\nT0101\nG42 G1 X20. F.1\nZ-10.\nG40 X60.\nG28 U0.\nM30"),
            [0_usize; 0]
        );
        assert_eq!(blocks(check, "linuxcnc", "G40 G42 G41.1\nG40\nM2"), [0_usize; 0]);
    }
}
