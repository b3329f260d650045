//! What the operator enters, and its ranges.

use std::fmt;
use std::ops::RangeInclusive;

/// A field that the operator fills in.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Field {
    /// Length of the form along the axis, mm.
    FormLength,
    /// Encoder pulses from one point to the next.
    Increment,
    /// Half angle of the cone, degrees.
    ConeAngle,
    /// Adjustment of the roller, 1/8 mm each.
    Adjustment,
}

impl Field {
    /// Values that the controller takes.
    #[must_use]
    pub const fn range(self) -> RangeInclusive<u32> {
        match self {
            Self::FormLength => 30..=74,
            Self::Increment => 8..=16,
            Self::ConeAngle => 30..=45,
            Self::Adjustment => 1..=80,
        }
    }

    /// Name with its unit, for people.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::FormLength => "Form length in mm",
            Self::Increment => "Increment in encoder pulses",
            Self::ConeAngle => "Cone angle in degrees",
            Self::Adjustment => "Adjustment in increments of 1/8 mm",
        }
    }

    /// The value, if the controller takes it.
    ///
    /// # Errors
    /// The field, the value and its range.
    pub fn checked(self, value: u32) -> Result<u32, OutOfRange> {
        if self.range().contains(&value) { Ok(value) } else { Err(OutOfRange { field: self, value }) }
    }
}

/// A value that the controller does not take.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct OutOfRange {
    /// The field.
    pub field: Field,
    /// What was entered.
    pub value: u32,
}

impl fmt::Display for OutOfRange {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (range, name) = (self.field.range(), self.field.name());
        write!(f, "{name} is {}; enter {} to {}.", self.value, range.start(), range.end())
    }
}

/// Where the roller stands when it begins to follow.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum RollerStart {
    /// At the former's tip.
    #[default]
    AtTip,
    /// At the test position, clear of the former, to draw the contour.
    Test,
    /// Nearer to the axis (positive, the letter R) or further (negative, the letter F), steps.
    Adjusted(i32),
}

impl RollerStart {
    /// Transducer reading of the test position: 69 mm.
    const TEST_STEPS: i32 = 552;

    /// The reading for a contour whose tip lies at `tip` steps.
    const fn steps(self, tip: i32) -> i32 {
        match self {
            Self::AtTip => tip,
            Self::Test => Self::TEST_STEPS,
            Self::Adjusted(by) => tip + by,
        }
    }
}

/// Parameters of a cone.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ConeParameters {
    form_length_mm: u32,
    increment_pulses: u32,
    angle_deg: u32,
    start: RollerStart,
}

/// Parameters of the parabola.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ParabolaParameters {
    form_length_mm: u32,
    start: RollerStart,
}

/// Reading at the former's tip, steps: 74 mm.
const TIP_STEPS: i32 = 592;
/// Compensation of the roller's radius at a cone: 9 mm · (1 − cos 30°) = 1.206 mm, taken as ten steps.
const CONE_COMPENSATION_STEPS: i32 = 10;

impl ConeParameters {
    /// Parameters within their ranges.
    ///
    /// # Errors
    /// The first that is not.
    pub fn new(form_length_mm: u32, increment_pulses: u32, angle_deg: u32) -> Result<Self, OutOfRange> {
        Ok(Self {
            form_length_mm: Field::FormLength.checked(form_length_mm)?,
            increment_pulses: Field::Increment.checked(increment_pulses)?,
            angle_deg: Field::ConeAngle.checked(angle_deg)?,
            start: RollerStart::AtTip,
        })
    }

    /// The same with another start of the roller.
    #[must_use]
    pub const fn starting(self, start: RollerStart) -> Self {
        Self { start, ..self }
    }

    /// Length of the form, mm.
    #[must_use]
    pub const fn form_length_mm(&self) -> u32 {
        self.form_length_mm
    }

    /// Encoder pulses from point to point.
    #[must_use]
    pub const fn increment_pulses(&self) -> u32 {
        self.increment_pulses
    }

    /// Half angle, degrees.
    #[must_use]
    pub const fn angle_deg(&self) -> u32 {
        self.angle_deg
    }

    /// Reading of the transducer where the roller begins, steps.
    #[must_use]
    pub const fn roller_position(&self) -> i32 {
        self.start.steps(TIP_STEPS + CONE_COMPENSATION_STEPS)
    }
}

impl ParabolaParameters {
    /// Encoder pulses from point to point: the table has no others.
    pub const INCREMENT_PULSES: u32 = 16;

    /// Parameters within their ranges.
    ///
    /// # Errors
    /// The length, if it is not.
    pub fn new(form_length_mm: u32) -> Result<Self, OutOfRange> {
        Ok(Self { form_length_mm: Field::FormLength.checked(form_length_mm)?, start: RollerStart::AtTip })
    }

    /// The same with another start of the roller.
    #[must_use]
    pub const fn starting(self, start: RollerStart) -> Self {
        Self { start, ..self }
    }

    /// Length of the form, mm.
    #[must_use]
    pub const fn form_length_mm(&self) -> u32 {
        self.form_length_mm
    }

    /// Reading of the transducer where the roller begins, steps.
    #[must_use]
    pub const fn roller_position(&self) -> i32 {
        self.start.steps(TIP_STEPS)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranges_are_the_published_ones_and_are_named() {
        assert!(ConeParameters::new(30, 8, 30).is_ok() && ConeParameters::new(74, 16, 45).is_ok());
        let said = ConeParameters::new(75, 8, 30).unwrap_err().to_string();
        assert_eq!(said, "Form length in mm is 75; enter 30 to 74.");
        assert_eq!(ConeParameters::new(40, 7, 30).unwrap_err().field, Field::Increment);
        assert_eq!(ConeParameters::new(40, 8, 46).unwrap_err().field, Field::ConeAngle);
        assert_eq!(ParabolaParameters::new(29).unwrap_err().value, 29);
    }

    #[test]
    fn roller_positions_are_the_published_ones() {
        let cone = ConeParameters::new(50, 16, 30).unwrap();
        assert_eq!(cone.roller_position(), 602);
        assert_eq!(cone.starting(RollerStart::Test).roller_position(), 552);
        assert_eq!(cone.starting(RollerStart::Adjusted(-8)).roller_position(), 594);
        assert_eq!(ParabolaParameters::new(50).unwrap().roller_position(), 592);
    }
}
