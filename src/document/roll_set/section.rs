//! The finished cross-section of the strip.

use serde::{Deserialize, Serialize};

/// What the strip is made of. Figures that need it say that they are guide values.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct StripMaterial {
    /// Name for people.
    pub name: String,
    /// Yield strength, MPa.
    pub yield_strength_mpa: f64,
    /// Young's modulus, GPa.
    pub youngs_modulus_gpa: f64,
    /// Density, g/cm³.
    pub density_g_per_cm3: f64,
    /// Least inside radius that the material bears, as a multiple of its thickness.
    pub least_radius_per_thickness: f64,
}

impl Default for StripMaterial {
    /// Cold-rolled mild steel.
    fn default() -> Self {
        Self {
            name: "DC01".to_owned(),
            yield_strength_mpa: 210.0,
            youngs_modulus_gpa: 210.0,
            density_g_per_cm3: 7.85,
            least_radius_per_thickness: 0.0,
        }
    }
}

/// The finished cross-section as a chain of lines and bends.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CrossSection {
    /// Thickness of the strip.
    pub thickness: f64,
    /// Where the list of elements starts.
    pub origin: Origin,
    /// Slope of the first element to the horizontal, degrees, positive upwards in its direction; 0 for a symmetrical section.
    #[serde(default, skip_serializing_if = "super::super::is_default")]
    pub first_angle_deg: f64,
    /// How the developed width is reckoned for the strip size; the rolls always use the mean line.
    #[serde(default, skip_serializing_if = "super::super::is_default")]
    pub developed_width: DevelopedWidth,
    /// The elements from the origin on.
    pub elements: Vec<Element>,
    /// The elements of the other side, from the centre outwards; only where the origin asks for two lists.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub other_side: Vec<Element>,
}

/// Where the list of elements starts and which way it runs.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Origin {
    /// From the left edge to the right one (published origin 1).
    LeftToRight,
    /// From the right edge to the left one (2).
    RightToLeft,
    /// From the centre to the right, then a list from the centre to the left (3).
    CentreRightFirst,
    /// From the centre to the left, then a list from the centre to the right (4).
    CentreLeftFirst,
    /// From the centre to the right, the left side being its mirror image (5).
    #[default]
    Symmetrical,
}

/// How the length of a bend in the flat strip is reckoned.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum DevelopedWidth {
    /// On the line in the middle of the thickness, r + t/2; what the published rolls use.
    #[default]
    MeanLine,
    /// The published table: r + k·t with k by the bend angle.
    RolfomTable,
    /// DIN 6935.
    Din6935,
    /// The rule of the American Society for Metals.
    Asm,
    /// The same rule for metal that is less formable: bends without a radius count with half the thickness.
    AsmLessFormable,
    /// Angel's formula.
    Angel,
    /// r + k·t with a k of one's own.
    Own {
        /// Distance of the neutral line from the inside, as a part of the thickness, 0 to 1.
        k: f64,
    },
}

/// One element of a cross-section.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(from = "ElementRow", into = "ElementRow")]
pub struct Element {
    /// Stable id, unique over both lists.
    pub id: u32,
    /// Line or bend.
    pub kind: ElementKind,
}

/// An element as it stands in a file, id and kind as one.
#[derive(Serialize, Deserialize)]
#[serde(tag = "type", rename_all = "snake_case", deny_unknown_fields)]
enum ElementRow {
    Line { id: u32, length: f64 },
    Bend { id: u32, inside_radius: f64, angle_deg: f64 },
}

impl From<ElementRow> for Element {
    fn from(row: ElementRow) -> Self {
        match row {
            ElementRow::Line { id, length } => Self { id, kind: ElementKind::Line { length } },
            ElementRow::Bend { id, inside_radius, angle_deg } => {
                Self { id, kind: ElementKind::Bend { inside_radius, angle_deg } }
            }
        }
    }
}

impl From<Element> for ElementRow {
    fn from(element: Element) -> Self {
        let id = element.id;
        match element.kind {
            ElementKind::Line { length } => Self::Line { id, length },
            ElementKind::Bend { inside_radius, angle_deg } => Self::Bend { id, inside_radius, angle_deg },
        }
    }
}

/// Line or bend.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ElementKind {
    /// A straight piece.
    Line {
        /// Its length.
        length: f64,
    },
    /// A bend.
    Bend {
        /// Inside radius of the finished bend; 0 is allowed.
        inside_radius: f64,
        /// Angle of the finished bend, degrees, positive if the strip turns upwards on its way from the origin.
        angle_deg: f64,
    },
}

impl CrossSection {
    /// The same section with every length multiplied by `factor`.
    #[must_use]
    pub fn scaled(&self, factor: f64) -> Self {
        let scale = |all: &[Element]| all.iter().map(|e| e.scaled(factor)).collect();
        Self {
            thickness: self.thickness * factor,
            elements: scale(&self.elements),
            other_side: scale(&self.other_side),
            ..self.clone()
        }
    }

    /// Every element of both lists.
    pub fn all(&self) -> impl Iterator<Item = &Element> {
        self.elements.iter().chain(&self.other_side)
    }

    /// An id that no element has yet.
    #[must_use]
    pub fn unused_id(&self) -> u32 {
        self.all().map(|e| e.id).max().map_or(1, |id| id.saturating_add(1))
    }
}

impl Origin {
    /// True if the section has a second list of elements.
    #[must_use]
    pub const fn has_other_side(self) -> bool {
        matches!(self, Self::CentreRightFirst | Self::CentreLeftFirst)
    }
}

impl Element {
    fn scaled(&self, factor: f64) -> Self {
        let kind = match self.kind {
            ElementKind::Line { length } => ElementKind::Line { length: length * factor },
            ElementKind::Bend { inside_radius, angle_deg } => {
                ElementKind::Bend { inside_radius: inside_radius * factor, angle_deg }
            }
        };
        Self { kind, ..*self }
    }
}
