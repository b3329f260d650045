//! Numbers as controls and people write them: blanks after the sign, no leading or trailing digits.

/// Largest number that fits the control's nine columns with three decimals.
pub(crate) const LARGEST_NUMBER: f64 = 99_999.999;

/// Why a text is not a number of the control.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum BadNumber {
    /// It has other characters than a sign, digits and one point.
    Form,
    /// It is larger than the control can hold.
    TooLarge,
}

/// Reads `- 20.000`, `+.5`, `7.`; exponents, `NaN` and infinities are not numbers here.
pub(super) fn number(text: &str) -> Result<f64, BadNumber> {
    let text = text.trim();
    let (negative, digits) = match text.as_bytes().first() {
        Some(b'-') => (true, text[1..].trim_start()),
        Some(b'+') => (false, text[1..].trim_start()),
        _ => (false, text),
    };
    let well_formed = digits.bytes().all(|b| b.is_ascii_digit() || b == b'.')
        && digits.bytes().filter(|&b| b == b'.').count() <= 1
        && digits.bytes().any(|b| b.is_ascii_digit());
    let value =
        if well_formed { digits.parse::<f64>().map_err(|_| BadNumber::Form)? } else { return Err(BadNumber::Form) };
    if value > LARGEST_NUMBER {
        return Err(BadNumber::TooLarge);
    }
    Ok(if negative && value != 0.0 { -value } else { value })
}

/// Parts a line of values at blanks and before signs; a sign keeps the digits that follow it, blanks between or not.
pub(super) fn fields(text: &str) -> Vec<String> {
    let mut fields: Vec<String> = Vec::new();
    let mut open = false;
    for c in text.chars() {
        let sign = c == '-' || c == '+';
        let after_lone_sign = fields.last().is_some_and(|f| f == "-" || f == "+");
        if c.is_whitespace() {
            open = open && after_lone_sign;
        } else if open && !sign {
            if let Some(last) = fields.last_mut() {
                last.push(c);
            }
        } else {
            fields.push(c.to_string());
            open = true;
        }
    }
    fields
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lenient_numbers_are_read() {
        for (text, value) in [("- 20.000", -20.0), ("+.5", 0.5), (" 7. ", 7.0), ("-0.000", 0.0), ("1094", 1094.0)] {
            assert_eq!(number(text), Ok(value), "{text}");
        }
        assert!(number("-0.000").is_ok_and(f64::is_sign_positive));
    }

    #[test]
    fn anything_else_is_refused() {
        for text in ["", "-", ".", "NaN", "inf", "1e5", "1.2.3", "2 0", "12O", "0x1", "--1", "1,5"] {
            assert_eq!(number(text), Err(BadNumber::Form), "{text}");
        }
        assert_eq!(number("100000"), Err(BadNumber::TooLarge));
        assert_eq!(number(&"9".repeat(400)), Err(BadNumber::TooLarge));
    }

    #[test]
    fn fields_part_at_blanks_and_signs() {
        assert_eq!(fields("   0.000  -20.000 1000 1"), ["0.000", "-20.000", "1000", "1"]);
        assert_eq!(fields("0.000-20.000"), ["0.000", "-20.000"]);
        assert_eq!(fields("- 20.000 - 3"), ["-20.000", "-3"]);
        assert_eq!(fields("5-"), ["5", "-"]);
    }
}
