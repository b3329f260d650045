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

/// Whole thousandths of a length in mm or a time in s.
pub(super) fn thousandths(value: f64) -> i32 {
    rounded(value * THOUSANDTHS)
}

/// The nearest whole number; what does not fit becomes the largest that does.
#[allow(clippy::cast_possible_truncation, reason = "`as` saturates, and a range check follows")]
pub(super) fn rounded(value: f64) -> i32 {
    value.round() as i32
}
