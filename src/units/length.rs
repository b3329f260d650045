//! Lengths as a person types them: figures, fractions, sums and units.

use super::{MM_PER_INCH, Unit};

/// Depth of brackets that an expression may have; a person never needs more.
const DEEPEST: usize = 32;

/// Reads a length or an expression of lengths, in `unit` where no other is written: `12.5`, `25.4/2`, `1in`, `3/8"`,
/// `(2 + 3/16) in - 1 mm`. A comma may stand for the decimal point. The result is in `unit`.
///
/// # Errors
/// A sentence that says what cannot be read and what would be right.
pub fn parse_length(text: &str, unit: Unit) -> Result<f64, String> {
    let mut reader = Reader { rest: text.trim(), unit, depth: 0 };
    if reader.rest.is_empty() {
        return Err("A length is missing. Type a figure such as 12.5, 1in or 3/8\".".to_owned());
    }
    let value = reader.sum()?;
    if !reader.rest.is_empty() {
        return Err(format!("“{}” cannot be read as a part of a length.", reader.rest));
    }
    let length = match value.mm_per_unit {
        None if text.trim().parse() == Ok(value.figure) => value.figure,
        None => settled(value.figure),
        Some(mm) => settled(value.figure * mm / unit.in_mm()),
    };
    if length.is_finite() { Ok(length) } else { Err("The length is not a finite figure.".to_owned()) }
}

/// A computed length without the last bits that the arithmetic left on it: 3/8 in is 9.525 mm, not 9.524999999999999.
fn settled(length: f64) -> f64 {
    /// Steps of a length unit that are kept: 1e-9 mm or in, far below any control's last decimal.
    const STEPS: f64 = 1e9;
    if length.abs() < 1e6 { (length * STEPS).round() / STEPS } else { length }
}

/// A figure with or without a unit of its own.
#[derive(Debug, Clone, Copy)]
struct Value {
    figure: f64,
    mm_per_unit: Option<f64>,
}

impl Value {
    fn mm(self, unit: Unit) -> f64 {
        self.figure * self.mm_per_unit.unwrap_or_else(|| unit.in_mm())
    }
}

struct Reader<'a> {
    rest: &'a str,
    unit: Unit,
    depth: usize,
}

impl Reader<'_> {
    fn take(&mut self, word: &str) -> bool {
        let Some(rest) = self.rest.strip_prefix(word) else { return false };
        self.rest = rest.trim_start();
        true
    }

    fn sum(&mut self) -> Result<Value, String> {
        let mut left = self.product()?;
        loop {
            let sign = match () {
                () if self.take("+") => 1.0,
                () if self.take("-") || self.take("−") => -1.0,
                () => return Ok(left),
            };
            let right = self.product()?;
            left = if left.mm_per_unit.is_none() && right.mm_per_unit.is_none() {
                Value { figure: left.figure + sign * right.figure, mm_per_unit: None }
            } else {
                Value { figure: left.mm(self.unit) + sign * right.mm(self.unit), mm_per_unit: Some(1.0) }
            };
        }
    }

    fn product(&mut self) -> Result<Value, String> {
        let mut left = self.factor()?;
        loop {
            let divides = match () {
                () if self.take("*") || self.take("×") => false,
                () if self.take("/") => true,
                () => return Ok(left),
            };
            let right = self.factor()?;
            if left.mm_per_unit.is_some() && right.mm_per_unit.is_some() {
                return Err(
                    "A length times or by a length is not a length. Give one of them without a unit.".to_owned()
                );
            }
            if divides && right.figure == 0.0 {
                return Err("A length cannot be divided by zero.".to_owned());
            }
            let figure = if divides { left.figure / right.figure } else { left.figure * right.figure };
            left = Value { figure, mm_per_unit: left.mm_per_unit.or(right.mm_per_unit) };
        }
    }

    fn factor(&mut self) -> Result<Value, String> {
        self.depth += 1;
        if self.depth > DEEPEST {
            return Err(format!("The expression is nested deeper than {DEEPEST} levels."));
        }
        let value = if self.take("-") || self.take("−") {
            let value = self.factor()?;
            Value { figure: -value.figure, ..value }
        } else if self.take("+") {
            self.factor()?
        } else if self.take("(") {
            let value = self.sum()?;
            if !self.take(")") {
                return Err("A closing bracket is missing.".to_owned());
            }
            self.with_unit(value)?
        } else {
            let figure = self.figure()?;
            self.with_unit(Value { figure, mm_per_unit: None })?
        };
        self.depth -= 1;
        Ok(value)
    }

    fn with_unit(&mut self, value: Value) -> Result<Value, String> {
        const UNITS: [(&str, f64); 6] = [
            ("mm", 1.0),
            ("cm", 10.0),
            ("inch", MM_PER_INCH),
            ("in", MM_PER_INCH),
            ("\"", MM_PER_INCH),
            ("″", MM_PER_INCH),
        ];
        let Some((_, mm)) = UNITS.iter().find(|(word, _)| self.take(word)) else { return Ok(value) };
        if value.mm_per_unit.is_some() {
            return Err("The expression has two units for one figure.".to_owned());
        }
        Ok(Value { figure: value.figure, mm_per_unit: Some(*mm) })
    }

    fn figure(&mut self) -> Result<f64, String> {
        let end = self.rest.find(|c: char| !(c.is_ascii_digit() || c == '.' || c == ',')).unwrap_or(self.rest.len());
        let (word, rest) = self.rest.split_at(end);
        if word.is_empty() {
            let found = self.rest.split_whitespace().next().unwrap_or("the end");
            return Err(format!("A figure was expected where “{found}” stands. Type one such as 12.5, 1in or 3/8\"."));
        }
        let figure = word.replace(',', ".").parse::<f64>().ok().filter(|f| f.is_finite());
        let figure = figure.ok_or_else(|| format!("“{word}” is not a figure."))?;
        self.rest = rest.trim_start();
        Ok(figure)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn mm(text: &str) -> f64 {
        parse_length(text, Unit::Mm).expect(text)
    }

    #[test]
    fn figures_fractions_sums_and_units() {
        assert_eq!(mm("12.5"), 12.5);
        assert_eq!(mm("12,5"), 12.5);
        assert_eq!(mm(" 25.4/2 "), 12.7);
        assert_eq!(mm("1in"), 25.4);
        assert_eq!(mm("3/8\""), 9.525);
        assert_eq!(mm("1 in - 0.4"), 25.0);
        assert_eq!(mm("(2+3)*2 cm"), 100.0);
        assert_eq!(mm("-(1 + 1)"), -2.0);
        assert_eq!(parse_length("25.4mm", Unit::Inch), Ok(1.0));
        assert_eq!(parse_length("1/2", Unit::Inch), Ok(0.5));
        assert_eq!(parse_length("1 + 25.4mm", Unit::Inch), Ok(2.0));
    }

    #[test]
    fn what_is_no_length_is_refused() {
        for text in
            ["", "  ", "abc", "1/0", "1in*1in", "(1", "1)", "1 2", "1..2", "1e999", "nan", "inf", "1in mm", "--"]
        {
            assert!(parse_length(text, Unit::Mm).is_err(), "{text}");
        }
        assert!(parse_length(&"(".repeat(5000), Unit::Mm).is_err());
        assert!(parse_length(&"9".repeat(400), Unit::Mm).is_err());
    }

    proptest! {
        #[test]
        fn no_text_makes_it_panic(text in "[-+*/().,0-9 a-z\"″−×]{0,24}") {
            if let Ok(length) = parse_length(&text, Unit::Mm) {
                prop_assert!(length.is_finite());
            }
        }

        #[test]
        fn a_printed_figure_is_read_back(value in -1e6f64..1e6) {
            prop_assert_eq!(parse_length(&format!("{value}"), Unit::Mm), Ok(value));
        }
    }
}
