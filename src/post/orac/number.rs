//! Numbers of ORAC texts, kept as whole thousandths or units.

use super::instruction::Field;

/// Thousandths in one unit of length or time.
const THOUSANDTHS: f64 = 1000.0;

/// Rounding noise of a decimal fraction read as binary, thousandths.
const NOISE: f64 = 1e-4;

/// Reads a value of `field`. The error names field, value and limit.
pub(super) fn parse(field: Field, text: &str) -> Result<i32, String> {
    let label = field.label();
    let plain = text.bytes().all(|b| b.is_ascii_digit() || matches!(b, b'+' | b'-' | b'.'));
    let value = text.parse::<f64>().ok().filter(|v| plain && v.is_finite());
    let value = value.ok_or_else(|| format!("{label} is '{text}', which is not a number."))?;
    let scaled = if field.is_decimal() { value * THOUSANDTHS } else { value };
    if (scaled - scaled.round()).abs() > NOISE {
        let most = if field.is_decimal() { "at most three decimals" } else { "no decimals" };
        return Err(format!("{label} is {text}; it must have {most}."));
    }
    checked(field, rounded(scaled))
}

/// The value if the number layout can hold it; else a sentence with value and limits.
pub(super) fn checked(field: Field, value: i32) -> Result<i32, String> {
    let range = field.range();
    if range.contains(&value) {
        return Ok(value);
    }
    let (value, low, high) = (field.written(value), field.written(*range.start()), field.written(*range.end()));
    Err(format!("{} is {value}; it must lie between {low} and {high}.", field.label()))
}

/// Adds a value of `field` to a text, right-aligned in `width` characters.
pub(super) fn push(text: &mut String, field: Field, value: i32, width: usize) {
    /// Ten digits, a point and a sign.
    const MOST: usize = 12;
    let mut places = ['0'; MOST];
    let (mut count, mut rest) = (0, value.unsigned_abs());
    let mut put = |c: char| {
        if let Some(place) = places.iter_mut().rev().nth(count) {
            *place = c;
        }
        count += 1;
    };
    let least = if field.is_decimal() { 4 } else { 1 };
    let mut digits = 0;
    while digits < least || rest > 0 {
        if field.is_decimal() && digits == 3 {
            put('.');
        }
        put(char::from_digit(rest % 10, 10).unwrap_or('0'));
        rest /= 10;
        digits += 1;
    }
    if value < 0 {
        put('-');
    }
    text.extend(std::iter::repeat_n(' ', width.saturating_sub(count)));
    text.extend(places.iter().skip(MOST.saturating_sub(count)));
}

/// Whole thousandths of a length in mm or a time in s.
pub(super) fn thousandths(value: f64) -> i32 {
    rounded(value * THOUSANDTHS)
}

/// The nearest whole number; what does not fit becomes the largest that does.
#[allow(clippy::cast_possible_truncation, reason = "`as` saturates, and a range check follows")]
pub(super) fn rounded(value: f64) -> i32 {
    value.round() as i32
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_are_written_as_the_formatter_writes_them() {
        let mut text = String::new();
        for value in [0, 1, -1, 12, 999, -999, 1000, -1234, 99_999, 1_234_567, i32::MAX, i32::MIN] {
            for width in [0, 5, 9] {
                text.clear();
                push(&mut text, Field::X, value, width);
                let sign = if value < 0 { "-" } else { "" };
                let size = value.unsigned_abs();
                assert_eq!(text, format!("{:>width$}", format!("{sign}{}.{:03}", size / 1000, size % 1000)));
                text.clear();
                push(&mut text, Field::Rpm, value, width);
                assert_eq!(text, format!("{value:>width$}"));
            }
        }
    }
}
