//! Limits of what a control's words may be.

use super::Check;
use crate::machine::{ClampWord, DecimalPoint, SpeedRule, Spindle, ThreadWord, Words};
use std::ops::RangeInclusive;

/// Decimal places of lengths and feeds.
const DECIMALS: RangeInclusive<u8> = 0..=6;
/// Digits in front of the point.
const DIGITS: RangeInclusive<u8> = 1..=9;
/// Fewest characters of a block: two positions, an arc centre and a sequence number must fit.
const FEWEST_LINE_CHARS: usize = 40;
/// Fewest characters of a program: start, one move and end must fit.
const FEWEST_PROGRAM_CHARS: usize = 500;

/// Everything that cannot be right in the words of a control.
pub(super) fn words(check: &mut Check, words: &Words, spindle: &Spindle) {
    if words.x_sign.abs() != 1 {
        check.fault("words.x_sign", format!("The sign is {}; it must be 1 or -1.", words.x_sign));
    }
    numbers(check, words);
    speeds(check, words, spindle);
    blocks(check, words);
    codes(check, words);
}

fn numbers(check: &mut Check, words: &Words) {
    for (path, places) in [
        ("words.decimals_mm", words.decimals_mm),
        ("words.decimals_inch", words.decimals_inch),
        ("words.feed_per_rev_decimals", words.feed_per_rev_decimals),
        ("words.feed_per_min_decimals", words.feed_per_min_decimals),
    ] {
        count(check, path, places, DECIMALS);
    }
    count(check, "words.digits_before", words.digits_before, DIGITS);
    for (letter, digits) in &words.digits {
        let path = format!("words.digits.{letter}");
        if !letter.is_ascii_uppercase() {
            check.fault(&path, format!("The address is \"{letter}\"; it must be a capital letter."));
        }
        count(check, &path, digits.most, DIGITS);
        if digits.least > digits.most {
            let message =
                format!("The word has at least {} digits, more than its most, {}.", digits.least, digits.most);
            check.fault(&path, message);
        }
    }
}

fn count(check: &mut Check, path: &str, value: u8, range: RangeInclusive<u8>) {
    if !range.contains(&value) {
        let (low, high) = range.into_inner();
        check.fault(path, format!("The value is {value} digits; it must be {low} to {high}."));
    }
}

fn speeds(check: &mut Check, words: &Words, spindle: &Spindle) {
    for (i, step) in words.speed_codes.iter().enumerate() {
        check.range(&format!("words.speed_codes.{i}.rpm"), step.rpm, super::SPEED_RPM, "rev/min");
        if words.speed_codes.iter().take(i).any(|earlier| earlier.code == step.code) {
            check.fault(&format!("words.speed_codes.{i}.code"), format!("S{} is in the table twice.", step.code));
        }
    }
    let message = match (spindle.speed, words.surface_speed, words.speed_codes.is_empty()) {
        (SpeedRule::Surface, false, _) => "The speed goes `by = \"surface\"`; that needs `words.surface_speed = true`.",
        (SpeedRule::Table, _, true) => "The speed goes `by = \"table\"`; that needs `words.speed_codes`.",
        (SpeedRule::Surface | SpeedRule::Radius { .. }, _, false) => {
            "The control has `words.speed_codes`; then the speed must go `by = \"table\"`."
        }
        _ => return,
    };
    check.fault("spindle.speed", message.to_owned());
}

fn blocks(check: &mut Check, words: &Words) {
    if let Some(numbers) = words.sequence_numbers {
        if numbers.step == 0 {
            check.fault("words.sequence_numbers.step", "The step is 0; it must be at least 1.".to_owned());
        }
        count(check, "words.sequence_numbers.digits", numbers.digits, DIGITS);
    }
    if let Some(number) = &words.program_number {
        check.text("words.program_number.prefix", &number.prefix);
        count(check, "words.program_number.digits", number.digits, DIGITS);
        if number.first.to_string().len() > usize::from(number.digits) {
            let message = format!("The number is {}; {} digits are too few for it.", number.first, number.digits);
            check.fault("words.program_number.first", message);
        }
    }
    let control = |c: char| c.is_ascii_control() || c == ';' || c == '*';
    if words.block_end.is_empty() || !words.block_end.chars().all(control) {
        let message =
            format!("The end of a block is {:?}; it must be control characters, `;` or `*`.", words.block_end);
        check.fault("words.block_end", message);
    }
    for (path, value, least) in [
        ("words.max_line_chars", words.max_line_chars, FEWEST_LINE_CHARS),
        ("words.max_program_chars", words.max_program_chars, FEWEST_PROGRAM_CHARS),
    ] {
        if let Some(value) = value.filter(|&v| v < least) {
            check.fault(path, format!("The value is {value} characters; it must be at least {least}."));
        }
    }
    if words.decimal_point == DecimalPoint::Always && words.zeros != crate::machine::Zeros::Keep {
        let message = "Zeros may be left out only where numbers have no decimal point; take it out.".to_owned();
        check.fault("words.zeros", message);
    }
}

fn codes(check: &mut Check, words: &Words) {
    let codes = &words.codes;
    for (path, code) in [
        ("words.codes.coolant_on", codes.coolant_on.as_deref()),
        ("words.codes.coolant_off", codes.coolant_off.as_deref()),
        ("words.codes.spindle_on", Some(codes.spindle_on.as_str())),
        ("words.codes.spindle_reverse", Some(codes.spindle_reverse.as_str())),
        ("words.codes.spindle_stop", codes.spindle_stop.as_deref()),
        ("words.codes.optional_stop", codes.optional_stop.as_deref()),
        ("words.codes.program_end", Some(codes.program_end.as_str())),
    ] {
        if let Some(code) = code {
            check.code(path, code);
        }
    }
    for (path, text) in std::iter::once(("words.codes.start".to_owned(), &codes.start))
        .chain(codes.retract.iter().enumerate().map(|(i, text)| (format!("words.codes.retract.{i}"), text)))
    {
        if !text.split(' ').filter(|word| !word.is_empty()).all(is_word) {
            let message =
                format!("The text is \"{text}\"; it must be words such as G28 U0., with blanks between them.");
            check.fault(&path, message);
        }
    }
    if !words.extension.chars().all(|c| c.is_ascii_alphanumeric()) || words.extension.is_empty() {
        let message = format!("The extension is \"{}\"; it must be letters and digits.", words.extension);
        check.fault("words.extension", message);
    }
    if words.clamp_word.is_some_and(|w| w != ClampWord::G92) && !words.surface_speed {
        let message = "A clamp belongs to constant cutting speed, which `surface_speed = false` excludes.".to_owned();
        check.fault("words.clamp_word", message);
    }
    if words.thread == ThreadWord::G33 && words.incremental {
        let message = "G33 with its lead K needs absolute moves; with `incremental = true` choose g32.".to_owned();
        check.fault("words.thread", message);
    }
}

/// A capital letter and a number.
fn is_word(word: &str) -> bool {
    let mut characters = word.chars();
    let letter = characters.next().is_some_and(|c| c.is_ascii_uppercase());
    letter && characters.as_str().parse::<f64>().is_ok_and(f64::is_finite)
}
