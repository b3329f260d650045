//! Numbers of words: whole counts of the last decimal, so that a value is rounded once and `-0.000` cannot come about.

use crate::machine::{DecimalPoint, Digits, Words, Zeros};

/// How the numbers of one kind of word are written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct NumberFormat {
    decimals: u8,
    /// Digits in front of the point, at most; no limit without.
    before: Option<u8>,
    point: DecimalPoint,
    zeros: Zeros,
}

impl NumberFormat {
    /// Lengths: X, Z, U, W, I, K, R.
    pub(super) const fn length(words: &Words, decimals: u8) -> Self {
        Self { decimals, before: Some(words.digits_before), point: words.decimal_point, zeros: words.zeros }
    }

    /// Feeds and leads with `decimals`; without a point `digits` says how long they are.
    pub(super) fn feed(words: &Words, decimals: u8) -> Self {
        let before = words.digits.get(&'F').map(|digits| digits.most.saturating_sub(decimals));
        Self { decimals, before, point: words.decimal_point, zeros: words.zeros }
    }

    /// The nearest number of counts; what no count can hold becomes the largest.
    #[allow(clippy::cast_possible_truncation, reason = "`as` saturates, and a range check follows")]
    pub(super) fn counts(self, value: f64) -> i64 {
        (value * self.scale()).round() as i64
    }

    /// The value of `counts`.
    pub(super) fn value(self, counts: i64) -> f64 {
        counts as f64 / self.scale()
    }

    /// Counts in one unit.
    pub(super) fn scale(self) -> f64 {
        10_f64.powi(i32::from(self.decimals))
    }

    /// The largest number of counts that fits.
    pub(super) fn most(self) -> i64 {
        self.before.map_or(i64::MAX, |before| 10_i64.saturating_pow(u32::from(before + self.decimals)) - 1)
    }

    /// The number as it is written.
    pub(super) fn text(self, counts: i64) -> String {
        let sign = if counts < 0 { "-" } else { "" };
        let digits = counts.unsigned_abs();
        let decimals = usize::from(self.decimals);
        if self.point == DecimalPoint::Never {
            return format!("{sign}{}", self.without_point(digits));
        }
        let digits = format!("{digits:0>width$}", width = decimals + 1);
        let (whole, fraction) = digits.split_at(digits.len() - decimals);
        if decimals == 0 { format!("{sign}{whole}") } else { format!("{sign}{whole}.{fraction}") }
    }

    fn without_point(self, digits: u64) -> String {
        let width = usize::from(self.before.unwrap_or(0) + self.decimals);
        match self.zeros {
            Zeros::DropLeading => digits.to_string(),
            Zeros::Keep => format!("{digits:0>width$}"),
            Zeros::DropTrailing => {
                let full = format!("{digits:0>width$}");
                let short = full.trim_end_matches('0');
                if short.is_empty() { "0".to_owned() } else { short.to_owned() }
            }
        }
    }
}

/// A whole-number word such as `T0202`; the error is the number of digits that fit.
pub(super) fn whole(words: &Words, address: char, number: u32) -> Result<String, u8> {
    let Some(&Digits { least, most }) = words.digits.get(&address) else { return Ok(format!("{address}{number}")) };
    let text = format!("{address}{number:0>width$}", width = usize::from(least));
    if text.len() - address.len_utf8() > usize::from(most) { Err(most) } else { Ok(text) }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn format(decimals: u8, before: u8, point: DecimalPoint, zeros: Zeros) -> NumberFormat {
        NumberFormat { decimals, before: Some(before), point, zeros }
    }

    #[test]
    fn numbers_with_a_point_keep_their_decimals() {
        let f = format(3, 4, DecimalPoint::Always, Zeros::Keep);
        let text = |value| f.text(f.counts(value));
        assert_eq!([text(-180.0), text(0.5), text(-0.0004), text(0.0)], ["-180.000", "0.500", "0.000", "0.000"]);
        assert_eq!([text(12.3455), text(-12.3456)], ["12.346", "-12.346"]);
        assert_eq!(format(0, 4, DecimalPoint::Always, Zeros::Keep).text(80), "80");
    }

    #[test]
    fn numbers_without_a_point_count_the_last_decimal() {
        let text = |zeros, value| {
            let f = format(3, 4, DecimalPoint::Never, zeros);
            f.text(f.counts(value))
        };
        assert_eq!([text(Zeros::Keep, 12.5), text(Zeros::Keep, -0.25)], ["0012500", "-0000250"]);
        assert_eq!([text(Zeros::DropLeading, 12.5), text(Zeros::DropLeading, 0.0)], ["12500", "0"]);
        assert_eq!([text(Zeros::DropTrailing, 12.5), text(Zeros::DropTrailing, -0.25)], ["00125", "-000025"]);
        assert_eq!(text(Zeros::DropTrailing, -0.0001), "0");
    }

    #[test]
    fn the_largest_number_has_all_its_digits() {
        assert_eq!(format(3, 4, DecimalPoint::Always, Zeros::Keep).most(), 9_999_999);
    }
}
