//! Figures as people write them.

use crate::units::{Unit, trimmed};

/// A length of mm in the document's unit with all its decimals, as the figures of one column have them.
pub(super) fn fixed(mm: f64, unit: Unit) -> String {
    let decimals = unit.decimals();
    let text = format!("{:.decimals$}", mm / unit.in_mm());
    // No minus before nothing.
    if text.trim_start_matches('-').trim_matches(['0', '.']).is_empty() {
        text.trim_start_matches('-').to_owned()
    } else {
        text
    }
}

/// A length of mm in the document's unit, without trailing zeros.
pub(super) fn number(mm: f64, unit: Unit) -> String {
    trimmed(mm / unit.in_mm(), unit.decimals())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lengths_lose_their_trailing_zeros_only() {
        assert_eq!(number(12.3456, Unit::Mm), "12.346");
        assert_eq!(number(100.0, Unit::Mm), "100");
        assert_eq!(number(-0.0001, Unit::Mm), "0");
        assert_eq!(number(25.4, Unit::Inch), "1");
    }

    #[test]
    fn figures_of_a_column_have_the_same_decimals() {
        assert_eq!((fixed(12.5, Unit::Mm), fixed(100.0, Unit::Mm)), ("12.500".to_owned(), "100.000".to_owned()));
        assert_eq!((fixed(-0.0001, Unit::Mm), fixed(-2.54, Unit::Inch)), ("0.000".to_owned(), "-0.1000".to_owned()));
    }
}
