//! Where a preset says the place of every tool (G50), an offset that is not cancelled before the next preset shifts it.

use super::{Program, Remark, has};
use crate::machine::{Preset, ToolWord};

pub(super) fn check(program: &Program<'_>) -> Vec<Remark> {
    if program.words.preset != Preset::G50 || program.words.tool_word != ToolWord::StationAndOffset {
        return Vec::new();
    }
    let mut remarks = Vec::new();
    let mut open: Option<u32> = None;
    for (block, words) in program.blocks() {
        let t = words.number('T').and_then(|t| t.whole());
        let ends = has(words, 'M', 30.0) || has(words, 'M', 2.0);
        let presets = has(words, 'G', 50.0) && (words.has('X') || words.has('Z'));
        let next_tool = t.is_some_and(|t| t % 100 != 0 && open.is_some_and(|old| old / 100 != t / 100));
        if let Some(old) = open.filter(|_| ends || presets || next_tool) {
            let message = format!(
                "The offset of T{old:04} is not cancelled (T{:02}00) before this block: its wear shifts everything that follows.",
                old / 100
            );
            remarks.push(Remark::warning(block, f64::from(old % 100), 0.0, message));
            open = None;
        }
        if let Some(t) = t {
            open = (t % 100 != 0).then_some(t);
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
        assert_eq!(blocks(check, "mori-fanuc-6t", "O1\nT0202\nT0606\nT0600\nM30"), [3]);
        assert_eq!(blocks(check, "mori-fanuc-6t", "O1\nT0202\nG50X-1.Z1.\nM30"), [3]);
        assert_eq!(blocks(check, "mori-fanuc-6t", "O1\nT0202\nM30"), [3]);
    }

    #[test]
    fn does_not_fire() {
        assert_eq!(
            blocks(check, "mori-fanuc-6t", "O1\nG50X-1.Z1.\nT0202\nG0X-1.\nT0200\nT0606\nT0600\nM30"),
            [0_usize; 0]
        );
        assert_eq!(blocks(check, "fanuc-0i", "O1\nT0202\nT0606\nM30"), [0_usize; 0]);
    }
}
