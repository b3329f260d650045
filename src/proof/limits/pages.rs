//! Pages that the ORAC's memory holds.

use crate::proof::findings::{Breach, Findings, Place};
use crate::proof::reader::{Layout, Listing};
use crate::proof::report::FindingKind;

/// Compares the number of pages with what the control holds. Lists of instructions are not loaded and may be longer.
pub(in crate::proof) fn check(listing: &Listing, program: usize, most: usize, findings: &mut Findings) {
    let count = listing.blocks.len();
    if count > most && listing.layout == Layout::Pages {
        let message = format!("The program has {count} blocks; the control holds {most}.");
        let breach = Breach::error("too many blocks", FindingKind::Structure, count as f64, most as f64, message);
        findings.add(Place { program, block: most + 1 }, breach);
    }
}

#[cfg(test)]
mod tests {
    use super::super::fixture::found;
    use super::*;
    use crate::proof::reader::read;

    /// Blocks that are found in a program of pages, and in one of instructions, of which the control holds 99.
    fn found_with(count: usize) -> [Vec<usize>; 2] {
        let pages = (1..=count).map(|n| format!("PAGE {n:02} MM-UNITS\n")).collect::<Vec<_>>().concat();
        let instructions = (1..=count).map(|n| format!("{n:>3}  MM\n")).collect::<Vec<_>>().concat();
        [pages, instructions].map(|text| {
            let found = found(|_, findings| check(&read(&text), 0, 99, findings));
            found.iter().map(|f| f.block).collect()
        })
    }

    #[test]
    fn fires() {
        assert_eq!(found_with(101)[0], [100]);
    }

    #[test]
    fn does_not_fire() {
        assert_eq!(found_with(99), [const { Vec::<usize>::new() }; 2]);
        assert_eq!(found_with(101)[1], [0_usize; 0]);
    }
}
