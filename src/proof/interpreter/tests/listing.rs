//! The published listing of roll 1470b-2T, read whole.

use super::*;

const LISTING: &str = include_str!("../../../../tests/cases/1470b/NC1470b-2T.nc");

#[test]
fn it_is_read_and_run_without_a_word() {
    let (path, findings) = run_on(&machine("mori-fanuc-6t"), LISTING);
    assert_eq!(findings, []);
    let tape = words::read(LISTING, crate::machine::Dialect::Fanuc);
    assert_eq!(tape.blocks.iter().filter(|b| b.printed.is_some()).count(), 261);
    // Every G2 runs counter-clockwise and every G3 clockwise.
    let count = |kind| path.spelled().iter().filter(|m| m.0 == kind).count();
    let codes = |text: &str| LISTING.matches(text).count();
    assert_eq!((count('a'), count('c')), (codes("G2X"), codes("G3X")));
    assert_eq!(count('a') + count('c'), 34);
    assert_eq!(count('r'), codes("G0"));
}
