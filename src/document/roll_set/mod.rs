//! A set of form-rolls: the cross-section of the finished strip, its way through the stations, and what is decided about
//! single rolls. Lengths are in the unit of the document, angles in degrees.

mod edit;
mod rates;
mod roll;
mod section;
mod station;

use serde::{Deserialize, Serialize};

pub use edit::{EditAction, ElementName, NewElement, PieceKind, RollEdit, RollPoint, Side, TangentSide};
pub use rates::Rates;
pub use roll::{RollCopy, RollKind, RollRef, RollWork, fingerprint};
pub use section::{CrossSection, DevelopedWidth, Element, ElementKind, Origin, StripMaterial};
pub use station::{
    BendAngle, Composite, DriveSurface, ExtensionContour, ExtensionKind, Face, FixedComposite, FormingLine, Opening,
    Pinch, Sharpening, SideEnd, SideRoll, Station,
};

/// A set of form-rolls.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RollSet {
    /// Machine id of the lathe that turns the rolls.
    pub machine: String,
    /// Material of the rolls, as in the material table; a roll may have its own.
    pub material: String,
    /// What the strip is made of.
    pub strip: StripMaterial,
    /// The finished section.
    pub section: CrossSection,
    /// How the radius of a bend goes down from station to station.
    #[serde(default, skip_serializing_if = "super::is_default")]
    pub opening: Opening,
    /// At which stations bends get their finished radius at once.
    #[serde(default, skip_serializing_if = "super::is_default")]
    pub sharpening: Sharpening,
    /// Bends that are made of a leading line, an arc and a trailing line while they are being formed.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub composites: Vec<Composite>,
    /// What the stations share.
    pub line: FormingLine,
    /// The stations in the direction of the strip.
    pub stations: Vec<Station>,
    /// Deviation from its contour that the proof of a roll allows.
    pub form_tolerance: f64,
    /// Clearance of the die block's aperture around the finished strip; [`RollSet::DIE_CLEARANCE_MM`] when absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub die_clearance: Option<f64>,
    /// What machining and material cost for this set.
    #[serde(default, skip_serializing_if = "super::is_default")]
    pub rates: Rates,
    /// What was decided about single rolls; a roll that is not named is as it was designed, and planned.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub rolls: Vec<RollWork>,
}

impl RollSet {
    /// Clearance of a die block's aperture where none is given, mm: room for the strip to slide through.
    pub const DIE_CLEARANCE_MM: f64 = 0.05;

    /// Clearance of the die block's aperture of a set in mm.
    #[must_use]
    pub fn die_clearance_mm(&self) -> f64 {
        self.die_clearance.unwrap_or(Self::DIE_CLEARANCE_MM)
    }

    /// The same set with every length multiplied by `factor`, as when the unit changes.
    #[must_use]
    pub fn scaled(&self, factor: f64) -> Self {
        Self {
            section: self.section.scaled(factor),
            line: self.line.scaled(factor),
            stations: self.stations.iter().map(|s| s.scaled(factor)).collect(),
            form_tolerance: self.form_tolerance * factor,
            die_clearance: self.die_clearance.map(|clearance| clearance * factor),
            rolls: self.rolls.iter().map(|r| r.scaled(factor)).collect(),
            ..self.clone()
        }
    }

    /// The station with this id and its number in the line, from 1.
    #[must_use]
    pub fn station(&self, id: u32) -> Option<(usize, &Station)> {
        (1..).zip(&self.stations).find(|(_, s)| s.id == id)
    }

    /// What was decided about a roll.
    #[must_use]
    pub fn roll(&self, roll: RollRef) -> Option<&RollWork> {
        self.rolls.iter().find(|r| r.roll == roll)
    }

    /// What a roll is made of, as in the material table.
    #[must_use]
    pub fn material_of(&self, roll: RollRef) -> &str {
        self.roll(roll).and_then(|work| work.material.as_deref()).unwrap_or(&self.material)
    }

    /// What was decided about a roll, to be changed; begun if nothing was.
    pub fn roll_mut(&mut self, roll: RollRef) -> &mut RollWork {
        let known = self.rolls.iter().position(|r| r.roll == roll);
        let at = known.unwrap_or_else(|| {
            self.rolls.push(RollWork::of(roll));
            self.rolls.len() - 1
        });
        &mut self.rolls[at]
    }
}
