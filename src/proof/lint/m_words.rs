//! Controls that obey one M word a block obey the last one and forget the others.

use super::{Program, Remark};

pub(super) fn check(program: &Program<'_>) -> Vec<Remark> {
    if !program.words.one_m_per_block || program.machine.dialect == crate::machine::Dialect::Linuxcnc {
        return Vec::new();
    }
    let count = |b: &super::WordBlock| b.all('M').count();
    let remark = |(block, words): (usize, &super::WordBlock)| {
        let count = count(words);
        let message = format!("The block has {count} M words; the control obeys one a block.");
        Remark::error(block, count as f64, 1.0, message)
    };
    program.blocks().filter(|(_, words)| count(words) > 1).map(remark).collect()
}

#[cfg(test)]
mod tests {
    use super::super::fixture::blocks;
    use super::*;

    #[test]
    fn fires() {
        assert_eq!(blocks(check, "mori-fanuc-6t", "O1\nG96S200M03M08"), [2]);
    }

    #[test]
    fn does_not_fire() {
        assert_eq!(blocks(check, "mori-fanuc-6t", "O1\nG96S200M03\nM08"), [0_usize; 0]);
        assert_eq!(blocks(check, "linuxcnc", "S200 M3 M8"), [0_usize; 0]);
    }
}
