//! Numbers behind address letters, kept as they are written: what they mean depends on the control and on the unit.

use crate::machine::{DecimalPoint, Words, Zeros};

/// Digits that a number may have. No control takes more than eight or nine; more would not fit the arithmetic.
const MOST_DIGITS: usize = 12;

/// A number as it is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Number {
    negative: bool,
    /// All digits, the point left out.
    digits: u64,
    /// How many digits were written.
    count: u8,
    /// Digits after the point; `None` without a point.
    after: Option<u8>,
}

impl Number {
    /// Reads a sign, digits and at most one point. Blanks must be gone.
    #[must_use]
    pub fn parse(text: &str) -> Option<Self> {
        let (negative, rest) = match text.as_bytes().first()? {
            b'-' => (true, &text[1..]),
            b'+' => (false, &text[1..]),
            _ => (false, text),
        };
        let (before, after) = rest.split_once('.').map_or((rest, None), |(before, after)| (before, Some(after)));
        let digits: String = [before, after.unwrap_or("")].concat();
        if digits.is_empty() || digits.len() > MOST_DIGITS || !digits.bytes().all(|b| b.is_ascii_digit()) {
            return None;
        }
        Some(Self {
            negative,
            digits: digits.parse().ok()?,
            count: u8::try_from(digits.len()).ok()?,
            after: after.map(|a| u8::try_from(a.len()).unwrap_or(u8::MAX)),
        })
    }

    /// True if it is written with a decimal point.
    #[must_use]
    pub const fn has_point(&self) -> bool {
        self.after.is_some()
    }

    /// Digits written before the point, or all without one.
    #[must_use]
    pub fn digits_before(&self) -> u8 {
        self.count - self.after.unwrap_or(0)
    }

    /// The value with its point where it is written; without one a whole number. Never −0.
    #[must_use]
    pub fn plain(&self) -> f64 {
        self.scaled(self.after.unwrap_or(0))
    }

    /// The number if it is whole and not negative; a point with nothing but zeros behind it does no harm.
    #[must_use]
    pub fn whole(&self) -> Option<u32> {
        let unit = 10_u64.checked_pow(u32::from(self.after.unwrap_or(0)))?;
        let fits = self.digits.is_multiple_of(unit) && (!self.negative || self.digits == 0);
        u32::try_from(self.digits / unit).ok().filter(|_| fits)
    }

    /// The value of a word that may have `decimals` places: without a point it counts least increments, or from the front
    /// where the control drops zeros at the end.
    #[must_use]
    pub fn in_increments(&self, decimals: u8, words: &Words) -> f64 {
        if self.has_point() {
            return self.plain();
        }
        if words.decimal_point == DecimalPoint::Never && words.zeros == Zeros::DropTrailing {
            return match self.count.checked_sub(words.digits_before) {
                Some(behind) => self.scaled(behind),
                None => self.scaled(0) * 10_f64.powi(i32::from(words.digits_before - self.count)),
            };
        }
        self.scaled(decimals)
    }

    /// `digits` with so many of them behind the point, correctly rounded.
    fn scaled(&self, decimals: u8) -> f64 {
        let value = self.digits as f64 / 10_f64.powi(i32::from(decimals));
        if self.negative && value != 0.0 { -value } else { value }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::proof::tests::word_lathe;

    #[test]
    fn numbers_are_read_as_they_are_written() {
        for (text, value) in [("-455.000", -455.0), ("+.5", 0.5), ("7.", 7.0), ("-0.000", 0.0), ("0201", 201.0)] {
            let number = Number::parse(text).unwrap();
            assert_eq!((number.plain(), number.has_point()), (value, text.contains('.')), "{text}");
        }
        for text in ["", "-", ".", "1.2.3", "--1", "1e5", "NaN", "1234567890123", "½"] {
            assert_eq!(Number::parse(text), None, "{text}");
        }
        assert!(Number::parse("-0").unwrap().plain().is_sign_positive());
        assert_eq!(Number::parse("3.0").unwrap().whole(), Some(3));
        assert_eq!(Number::parse("3.5").unwrap().whole(), None);
        assert_eq!(Number::parse("-3").unwrap().whole(), None);
    }

    #[test]
    fn without_a_point_increments_count() {
        let mut words = word_lathe().words.unwrap();
        let mm = |words: &Words, text: &str| Number::parse(text).unwrap().in_increments(3, words);
        assert_eq!(mm(&words, "1500"), 1.5);
        assert_eq!(mm(&words, "1500."), 1500.0);
        (words.decimal_point, words.zeros, words.digits_before) = (DecimalPoint::Never, Zeros::DropTrailing, 4);
        assert_eq!(mm(&words, "0123"), 123.0);
        assert_eq!(mm(&words, "-00015"), -1.5);
        assert_eq!(mm(&words, "01234567"), 123.4567);
        words.zeros = Zeros::DropLeading;
        assert_eq!(mm(&words, "15"), 0.015);
    }
}
