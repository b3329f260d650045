//! Figures as people write them.

use crate::units::{Unit, trimmed};

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
}
