//! The stations of a roll-forming line: the shape of the strip there, and what its rolls are designed by.

use serde::{Deserialize, Serialize};

/// One stage of the line.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Station {
    /// Stable id.
    pub id: u32,
    /// Bend angles that change here; a bend that is not named keeps its angle from the station before.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub bends: Vec<BendAngle>,
    /// Radius of the bottom roll at the base of the strip.
    pub pass_height: f64,
    /// Distance of the axes of top and bottom roll.
    pub centre_distance: f64,
    /// Clearance between the left edge of the strip and the roll.
    #[serde(default, skip_serializing_if = "super::super::is_default")]
    pub tolerance_left: f64,
    /// Clearance between the right edge of the strip and the roll.
    #[serde(default, skip_serializing_if = "super::super::is_default")]
    pub tolerance_right: f64,
    /// Opening between the rolls on driving and on clearing surfaces.
    #[serde(default, skip_serializing_if = "super::super::is_default")]
    pub pinch: Pinch,
    /// Which elements drive the strip on the left; for a symmetrical section only the right side is asked.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub drive_left: Option<DriveSurface>,
    /// Which elements drive the strip on the right.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub drive_right: Option<DriveSurface>,
    /// What the contours of top and bottom roll go on with beyond the left edge of the strip.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub extension_left: Vec<ExtensionContour>,
    /// The same beyond the right edge.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub extension_right: Vec<ExtensionContour>,
    /// Roll on an upright axis left of the strip.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub side_left: Option<SideRoll>,
    /// Roll on an upright axis right of the strip.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub side_right: Option<SideRoll>,
    /// Speed of its top shaft divided by that of its bottom shaft, where it is not that of the line.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub gear_ratio: Option<f64>,
    /// True if the station has no rolls.
    #[serde(default, skip_serializing_if = "super::super::is_default")]
    pub without_rolls: bool,
}

/// Angle of a bend at a station.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct BendAngle {
    /// Id of the element.
    pub element: u32,
    /// Cumulative angle, degrees, signed as in the finished section.
    pub angle_deg: f64,
}

/// What stays constant while the radius of a bend opens towards the flat strip.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Opening {
    /// Radius of the mean line times angle; what the published rolls follow.
    #[default]
    MeanLine,
    /// Inside radius times angle; what the published text says.
    InsideRadius,
    /// The inside radius itself: only a part of the bend's length is bent yet, the rest stays straight.
    ConstantRadius,
}

/// At which stations a bend gets its finished radius at once, whatever its angle.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Sharpening {
    /// Nowhere.
    #[default]
    None,
    /// At these stations, by id.
    Stations(Vec<u32>),
    /// At all but the last.
    AllButLast,
}

/// A bend that consists of a straight piece, an arc and a straight piece while it is being formed.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Composite {
    /// Id of the element.
    pub element: u32,
    /// Parts of its mean length, percent, 100 in all: leading line, arc, trailing line.
    pub percent: [f64; 3],
    /// Stations at which it has these parts; elsewhere it is one arc that opens. Everywhere, until the bend has its finished
    /// angle, when absent. Of several compositions of one element the last one that holds at a station counts.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub fixed: Option<FixedComposite>,
}

/// Stations at which a composite bend has its parts, by id.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FixedComposite {
    /// First station.
    pub first: u32,
    /// Last station.
    pub last: u32,
}

/// Opening between the rolls.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Pinch {
    /// The thickness everywhere (published 0).
    #[default]
    None,
    /// Openings of one's own (published 1 and -1).
    Gaps {
        /// On driving surfaces.
        drive: f64,
        /// On clearing surfaces.
        clearance: f64,
    },
    /// The thickness on driving surfaces; elsewhere 8 percent and this much more (published 2 and -2).
    Clearance {
        /// Added to 1.08 times the thickness.
        added: f64,
    },
}

/// The run of elements over which the rolls drive the strip.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct DriveSurface {
    /// Id of the first element, counted from the origin.
    pub first: u32,
    /// Id of the last element.
    pub last: u32,
}

/// What a roll contour goes on with beyond the edge of the strip.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ExtensionContour {
    /// Kind.
    pub kind: ExtensionKind,
    /// Lengths of its four parts from the strip outwards; 0 leaves a part out.
    pub lengths: [f64; 4],
}

/// Kinds of extension contour.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum ExtensionKind {
    /// Of a side roll (published type 1).
    SideRoll,
    /// Spigot A: both rolls share the line (type 2).
    SpigotA,
    /// Spigot B (type 3).
    SpigotB,
}

/// A roll on an upright axis.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SideRoll {
    /// Distance of its axis from the origin of the section.
    pub axis_distance: f64,
    /// Where its contour begins on the strip, at the bottom.
    pub from: SideEnd,
    /// Where it ends, at the top.
    pub to: SideEnd,
    /// Contours that it goes on with: below, then above.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub extensions: Vec<ExtensionContour>,
}

/// A face of an element of the strip.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SideEnd {
    /// Id of the element.
    pub element: u32,
    /// Its face.
    pub face: Face,
}

/// Faces of an element of the strip.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Face {
    /// Published 1.
    Bottom,
    /// Published 2.
    Top,
    /// Published 3: the end at which the element begins.
    Leading,
    /// Published 4: the end at which it stops.
    Trailing,
}

/// What the stations share.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FormingLine {
    /// Distance from station to station.
    pub station_pitch: f64,
    /// Diameter of the shafts and of the bores of top and bottom rolls.
    pub shaft_diameter: f64,
    /// Diameter of the axles of side rolls and of their bores.
    pub side_shaft_diameter: f64,
    /// Speed of the top shafts divided by that of the bottom shafts; absent if the top shafts are not geared, or it is not
    /// known.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub gear_ratio: Option<f64>,
    /// Speed of the bottom shafts, rev/min, the same at every station; absent if it is not known.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub bottom_rpm: Option<f64>,
    /// Gap between the rolls in a drawing.
    #[serde(default, skip_serializing_if = "super::super::is_default")]
    pub drawn_gap: f64,
}

impl FormingLine {
    /// The same line with every length multiplied by `factor`.
    #[must_use]
    pub fn scaled(self, factor: f64) -> Self {
        Self {
            station_pitch: self.station_pitch * factor,
            shaft_diameter: self.shaft_diameter * factor,
            side_shaft_diameter: self.side_shaft_diameter * factor,
            drawn_gap: self.drawn_gap * factor,
            ..self
        }
    }
}

impl Station {
    /// A station that bends nothing, with rolls of a size that suits the shafts of its line.
    #[must_use]
    pub fn new(id: u32, line: &FormingLine) -> Self {
        /// Radius of a roll at the base of the strip, in diameters of its shaft: it leaves a wall as thick as the shaft.
        const RADIUS_PER_SHAFT: f64 = 1.5;
        let radius = line.shaft_diameter * RADIUS_PER_SHAFT;
        Self {
            id,
            bends: Vec::new(),
            pass_height: radius,
            centre_distance: 2.0 * radius,
            tolerance_left: 0.0,
            tolerance_right: 0.0,
            pinch: Pinch::None,
            drive_left: None,
            drive_right: None,
            extension_left: Vec::new(),
            extension_right: Vec::new(),
            side_left: None,
            side_right: None,
            gear_ratio: None,
            without_rolls: false,
        }
    }

    /// The same station with every length multiplied by `factor`.
    #[must_use]
    pub fn scaled(&self, factor: f64) -> Self {
        let contours = |all: &[ExtensionContour]| all.iter().map(|c| c.scaled(factor)).collect();
        Self {
            pass_height: self.pass_height * factor,
            centre_distance: self.centre_distance * factor,
            tolerance_left: self.tolerance_left * factor,
            tolerance_right: self.tolerance_right * factor,
            pinch: self.pinch.scaled(factor),
            extension_left: contours(&self.extension_left),
            extension_right: contours(&self.extension_right),
            side_left: self.side_left.as_ref().map(|s| s.scaled(factor)),
            side_right: self.side_right.as_ref().map(|s| s.scaled(factor)),
            ..self.clone()
        }
    }
}

impl Pinch {
    fn scaled(self, factor: f64) -> Self {
        match self {
            Self::None => Self::None,
            Self::Gaps { drive, clearance } => Self::Gaps { drive: drive * factor, clearance: clearance * factor },
            Self::Clearance { added } => Self::Clearance { added: added * factor },
        }
    }
}

impl ExtensionContour {
    fn scaled(&self, factor: f64) -> Self {
        Self { lengths: self.lengths.map(|l| l * factor), ..*self }
    }
}

impl SideRoll {
    fn scaled(&self, factor: f64) -> Self {
        Self {
            axis_distance: self.axis_distance * factor,
            extensions: self.extensions.iter().map(|c| c.scaled(factor)).collect(),
            ..self.clone()
        }
    }
}
