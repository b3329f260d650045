//! Single rolls of a set: which there are, and what is decided about them.

use super::RollEdit;
use crate::document::{Generator, PlanEdits, ProgramChoices, TurnedPart};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// A roll of a set.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RollRef {
    /// Id of its station.
    pub station: u32,
    /// Its place there.
    pub kind: RollKind,
}

/// The rolls of a station.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum RollKind {
    /// Above the strip.
    Top,
    /// Below the strip.
    Bottom,
    /// Left of the strip on an upright axis.
    Left,
    /// Right of the strip on an upright axis.
    Right,
}

impl RollKind {
    /// All kinds in the order of a list.
    pub const ALL: [Self; 4] = [Self::Top, Self::Bottom, Self::Left, Self::Right];

    /// The letter in the name of a roll: `T` in `1470b-2T`.
    #[must_use]
    pub const fn letter(self) -> char {
        match self {
            Self::Top => 'T',
            Self::Bottom => 'B',
            Self::Left => 'L',
            Self::Right => 'R',
        }
    }

    /// Name for people.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Top => "top roll",
            Self::Bottom => "bottom roll",
            Self::Left => "left roll",
            Self::Right => "right roll",
        }
    }
}

/// A roll used again.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RollCopy {
    /// The roll whose contour is taken.
    pub roll: RollRef,
    /// Turned round on its shaft: left and right exchanged.
    #[serde(default, skip_serializing_if = "crate::document::is_default")]
    pub mirrored: bool,
}

/// What is decided about a roll beyond its design.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RollWork {
    /// The roll.
    pub roll: RollRef,
    /// Changes of the designed contour, in order.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub edits: Vec<RollEdit>,
    /// Another roll whose contour it has, edits included, in place of one designed for its station.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub same_as: Option<RollCopy>,
    /// True of the left roll of a symmetrical section whose contour is its own, edits or none: otherwise it is as the right one.
    #[serde(default, skip_serializing_if = "crate::document::is_default")]
    pub own_contour: bool,
    /// What it is made of, as in the material table; the material of the set when absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub material: Option<String>,
    /// Diameter of the blank; the next standard one when absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub blank_diameter: Option<f64>,
    /// Which generator makes the program; the planner when absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub generator: Option<Generator>,
    /// What was changed of the planner's operations.
    #[serde(default, skip_serializing_if = "crate::document::is_default")]
    pub plan: PlanEdits,
    /// How the programs are written.
    #[serde(default, skip_serializing_if = "crate::document::is_default")]
    pub program: ProgramChoices,
    /// Programs edited by hand, by program name.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub overrides: BTreeMap<String, String>,
    /// Programs that went to the lathe, by name, with the [`fingerprint`] of what was sent: whether that is the roll as it is
    /// now shows by comparing.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub sent: BTreeMap<String, String>,
}

/// A short text that differs for different texts: 64 bits of FNV-1a in hexadecimal digits. It tells changes apart, it does not
/// keep anybody from forging.
#[must_use]
pub fn fingerprint(text: &str) -> String {
    const OFFSET: u64 = 0xcbf2_9ce4_8422_2325;
    const PRIME: u64 = 0x0100_0000_01b3;
    let hash = text.bytes().fold(OFFSET, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(PRIME));
    format!("{hash:016x}")
}

impl RollWork {
    /// Nothing decided yet.
    #[must_use]
    pub fn of(roll: RollRef) -> Self {
        Self {
            roll,
            edits: Vec::new(),
            same_as: None,
            own_contour: false,
            material: None,
            blank_diameter: None,
            generator: None,
            plan: PlanEdits::default(),
            program: ProgramChoices::default(),
            overrides: BTreeMap::new(),
            sent: BTreeMap::new(),
        }
    }

    /// Puts what is decided into the part that the roll is turned as; its blank stays as it is if none was chosen.
    pub fn put_into(&self, part: &mut TurnedPart) {
        part.bar_diameter = self.blank_diameter.unwrap_or(part.bar_diameter);
        part.generator = self.generator.clone().unwrap_or(Generator::Planned { separate_programs: false });
        part.plan = self.plan.clone();
        part.program = self.program;
        part.overrides.clone_from(&self.overrides);
    }

    /// Takes over what an edit of that part changed.
    pub fn take_from(&mut self, before: &TurnedPart, after: TurnedPart) {
        if after.material != before.material {
            self.material = Some(after.material);
        }
        if (after.bar_diameter - before.bar_diameter).abs() > 0.0 {
            self.blank_diameter = Some(after.bar_diameter);
        }
        if after.generator != before.generator {
            self.generator = Some(after.generator);
        }
        self.plan = after.plan;
        self.program = after.program;
        self.overrides = after.overrides;
    }

    /// The same with every length multiplied by `factor`.
    #[must_use]
    pub fn scaled(&self, factor: f64) -> Self {
        Self {
            edits: self.edits.iter().map(|e| e.scaled(factor)).collect(),
            blank_diameter: self.blank_diameter.map(|d| d * factor),
            generator: self.generator.as_ref().map(|g| g.scaled(factor)),
            plan: self.plan.scaled(factor),
            ..self.clone()
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fingerprints_are_those_of_the_published_hash() {
        // Fowler, Noll, Vo: test vectors of FNV-1a, 64 bits.
        assert_eq!(fingerprint(""), "cbf29ce484222325");
        assert_eq!(fingerprint("a"), "af63dc4c8601ec8c");
        assert_eq!(fingerprint("foobar"), "85944171f73967e8");
    }
}
