//! WRITE: entering instructions one field after the other, as on the control's keypad, without any window.

use super::instruction::{Field, Instruction, Kind};
use super::number;
use crate::machine::Limits;
use crate::units::Unit;
use std::collections::BTreeMap;
use std::ops::RangeInclusive;

/// An answer that cannot be taken; the text says why, with value and limit.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{0}")]
pub struct Refusal(String);

/// What the entry asks for next.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Prompt {
    /// Instruction being entered.
    pub kind: Kind,
    /// Field wanted.
    pub field: Field,
    /// Value of the same field in an earlier instruction; an empty answer takes it.
    pub previous: Option<String>,
    /// Smallest value allowed.
    pub lowest: String,
    /// Largest value allowed.
    pub highest: String,
}

/// An instruction being entered, and what was entered before it.
#[derive(Debug, Clone)]
pub struct Entry {
    limits: Limits,
    unit: Unit,
    previous: BTreeMap<Field, i32>,
    pending: Option<(Kind, Vec<i32>)>,
}

impl Entry {
    /// Nothing entered yet, in mm, for a machine with these limits.
    #[must_use]
    pub const fn new(limits: Limits) -> Self {
        Self { limits, unit: Unit::Mm, previous: BTreeMap::new(), pending: None }
    }

    /// Offers the values of `instruction` for the fields of the next one, and follows its unit. Call it with the instructions
    /// above the place of entry, or with one that is to be changed.
    pub fn remember(&mut self, instruction: &Instruction) {
        self.previous.extend(instruction.fields());
        match instruction {
            Instruction::Mm => self.unit = Unit::Mm,
            Instruction::Inch => self.unit = Unit::Inch,
            _ => {}
        }
    }

    /// Begins an instruction. One without fields is complete at once.
    pub fn choose(&mut self, kind: Kind) -> Option<Instruction> {
        self.pending = Some((kind, Vec::new()));
        self.complete()
    }

    /// What is asked for; `None` while no instruction is being entered.
    #[must_use]
    pub fn prompt(&self) -> Option<Prompt> {
        let (kind, field) = self.wanted()?;
        let range = self.range(field);
        let previous = self.previous.get(&field).filter(|v| range.contains(v)).map(|&v| field.written(v));
        let (lowest, highest) = (field.written(*range.start()), field.written(*range.end()));
        Some(Prompt { kind, field, previous, lowest, highest })
    }

    /// Takes the answer to the prompt: a number, or nothing for the previous value. Returns the instruction when it is
    /// complete. A refused answer changes nothing.
    pub fn answer(&mut self, text: &str) -> Result<Option<Instruction>, Refusal> {
        let Some((_, field)) = self.wanted() else {
            return Err(Refusal("No instruction is being entered; choose one first.".to_owned()));
        };
        let value = self.value(field, text.trim())?;
        if let Some((_, values)) = &mut self.pending {
            values.push(value);
        }
        Ok(self.complete())
    }

    /// Goes back to the field before; from the first field the instruction is given up.
    pub fn back(&mut self) {
        if self.pending.as_mut().is_some_and(|(_, values)| values.pop().is_none()) {
            self.pending = None;
        }
    }

    fn wanted(&self) -> Option<(Kind, Field)> {
        let (kind, values) = self.pending.as_ref()?;
        kind.fields().get(values.len()).map(|&field| (*kind, field))
    }

    fn value(&self, field: Field, text: &str) -> Result<i32, Refusal> {
        let label = field.label();
        let value = if text.is_empty() {
            let previous = self.previous.get(&field).copied();
            previous.ok_or_else(|| Refusal(format!("{label} has no previous value; enter a number.")))?
        } else {
            number::parse(field, text).map_err(Refusal)?
        };
        let range = self.range(field);
        if range.contains(&value) {
            return Ok(value);
        }
        let [value, low, high] = [value, *range.start(), *range.end()].map(|v| field.written(v));
        Err(Refusal(format!("{label} is {value}; the machine allows {low} to {high}.")))
    }

    /// The instruction if all its fields are there; it is then remembered.
    fn complete(&mut self) -> Option<Instruction> {
        let (kind, values) = self.pending.as_ref()?;
        let instruction = kind.instruction(values)?;
        self.pending = None;
        self.remember(&instruction);
        Some(instruction)
    }

    /// What machine and number layout allow, in the unit of the program.
    fn range(&self, field: Field) -> RangeInclusive<i32> {
        let limits = &self.limits;
        let (low, high) = match field {
            Field::X => (-limits.travel_x_mm, limits.travel_x_mm),
            Field::Z => (-limits.travel_z_mm, limits.travel_z_mm),
            Field::Radius => (limits.arc_radius_min_mm, limits.arc_radius_max_mm),
            Field::OutsideDiameter | Field::BaseDiameter => (0.0, limits.bar_diameter_mm),
            Field::Pitch => (limits.pitch_min_mm, limits.pitch_max_mm),
            Field::Feed => (limits.feed_min_mm_per_min, limits.feed_max_mm_per_min),
            Field::Rpm => (0.0, limits.spindle_max_rpm),
            _ => return field.range(),
        };
        let per_unit = if field == Field::Rpm { 1.0 } else { self.unit.in_mm() };
        let scale = if field.is_decimal() { 1000.0 } else { 1.0 };
        let inside = |value: f64, round: fn(f64) -> f64| number::rounded(round(value / per_unit * scale));
        let (least, most) = (*field.range().start(), *field.range().end());
        inside(low, f64::ceil).max(least)..=inside(high, f64::floor).min(most)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::machine::Catalog;

    fn entry() -> Entry {
        Entry::new(Catalog::shipped().machine("orac").unwrap().limits)
    }

    #[test]
    fn fields_are_asked_one_after_the_other_and_offer_what_was_there_before() {
        let mut entry = entry();
        assert_eq!(entry.choose(Kind::Inc), Some(Instruction::Inc));
        assert_eq!(entry.choose(Kind::Ptp), None);
        assert_eq!(entry.prompt().unwrap().previous, None);
        for answer in ["-2", "0", "80", "1"] {
            assert_eq!(entry.answer(answer), Ok(None));
        }
        let first = Instruction::Ptp { x: -2000, z: 0, feed: 80, tool: 1, rpm: 1214 };
        assert_eq!(entry.answer("1214"), Ok(Some(first)));
        assert_eq!(entry.prompt(), None);
        entry.choose(Kind::Ptp);
        assert_eq!(entry.prompt().unwrap().previous.as_deref(), Some("-2.000"));
        let again: Vec<_> = (0..5).map(|_| entry.answer("")).collect();
        assert_eq!(again[4], Ok(Some(first)));
    }

    #[test]
    fn values_out_of_range_are_refused_with_value_and_limit_and_change_nothing() {
        let mut entry = entry();
        entry.choose(Kind::Ptp);
        let refusal = entry.answer("95.5").unwrap_err().to_string();
        assert_eq!(refusal, "X is 95.500; the machine allows -95.000 to 95.000.");
        assert_eq!(entry.answer("abc").unwrap_err().to_string(), "X is 'abc', which is not a number.");
        assert_eq!(entry.answer("").unwrap_err().to_string(), "X has no previous value; enter a number.");
        assert_eq!(entry.prompt().unwrap().field, Field::X);
        assert!(entry.answer("NaN").is_err());
    }

    #[test]
    fn inches_change_the_limits() {
        let mut entry = entry();
        entry.choose(Kind::Inch);
        entry.choose(Kind::Thrd);
        let prompt = entry.prompt().unwrap();
        assert_eq!((prompt.lowest.as_str(), prompt.highest.as_str()), ("-13.779", "13.779"));
    }

    #[test]
    fn going_back_asks_for_the_field_before_and_then_gives_up() {
        let mut entry = entry();
        entry.choose(Kind::Oxua);
        entry.answer("3").unwrap();
        entry.back();
        assert_eq!(entry.prompt().unwrap().field, Field::Channel);
        entry.back();
        assert_eq!(entry.prompt(), None);
        assert!(entry.answer("1").is_err());
    }
}
