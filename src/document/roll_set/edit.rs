//! Edits of roll contours: a list of operations on top of what was designed. Lengths in the unit of the document.
//!
//! An edit finds its place by what made the element there, not by its number, so that it keeps its place when the design
//! changes.

use serde::{Deserialize, Serialize};

/// The side of the origin of a section on which an element lies; of a side roll, below (left) and above (right).
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Side {
    /// Left of the origin.
    Left,
    /// Right of the origin.
    Right,
}

/// What a piece of the strip is of its element.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Default, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum PieceKind {
    /// The whole of a line.
    #[default]
    Line,
    /// What of a bend is still straight, on the side of the origin; all of it while it is flat.
    Leading,
    /// The arc of a bend.
    Arc,
    /// What of a bend is still straight, on the far side.
    Trailing,
}

/// The name of an element of a roll contour: what made it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(tag = "of", rename_all = "snake_case", deny_unknown_fields)]
pub enum ElementName {
    /// A piece of the strip.
    Strip {
        /// Id of the element of the section.
        element: u32,
        /// Side of the origin.
        side: Side,
        /// What it is of the element.
        #[serde(default, skip_serializing_if = "crate::document::is_default")]
        kind: PieceKind,
    },
    /// The end face that traps an edge of the strip.
    Edge {
        /// Which edge.
        side: Side,
    },
    /// A part of an extension contour.
    Extension {
        /// At which end of the contour.
        side: Side,
        /// Part, 1 to 4 from the strip outwards.
        part: u32,
    },
    /// A straight line in place of what the roll cannot reach, named by the element at which it begins.
    Unreached {
        /// Id of the element of the section; 0 for the edge of the strip.
        element: u32,
        /// Side of the origin.
        side: Side,
    },
    /// A side face of the roll.
    Flank {
        /// Which one: left or lower, right or upper.
        side: Side,
    },
    /// An element that an edit made.
    Edit {
        /// Id of the edit.
        edit: u32,
    },
}

/// An edit of a roll contour.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct RollEdit {
    /// Stable id, unique in the list of the roll.
    pub id: u32,
    /// What is done.
    #[serde(flatten)]
    pub action: EditAction,
}

/// What an edit does.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(tag = "do", rename_all = "snake_case", deny_unknown_fields)]
pub enum EditAction {
    /// A new element between an element and the next one; both are prolonged or cut to where they meet it.
    Insert {
        /// The element before it.
        after: ElementName,
        /// The new element.
        shape: NewElement,
    },
    /// A new element in place of one.
    Replace {
        /// The element that goes.
        element: ElementName,
        /// The new element.
        shape: NewElement,
    },
    /// An element goes, and its neighbours are prolonged or cut to where they meet.
    Delete {
        /// The element that goes.
        element: ElementName,
    },
    /// A chamfer at the corner of two lines.
    Chamfer {
        /// The line before the corner.
        after: ElementName,
        /// Depth: distance of the chamfer's ends from the other line.
        depth: f64,
    },
    /// An arc at the corner of two lines.
    Blend {
        /// The line before the corner.
        after: ElementName,
        /// Radius.
        radius: f64,
    },
}

/// A point of a roll.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RollPoint {
    /// Distance from the left (of a side roll the lower) face of the roll.
    pub z: f64,
    /// Diameter.
    pub diameter: f64,
}

/// A new element of a roll contour: an unbounded line or a circle; its ends follow from its neighbours.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(tag = "by", rename_all = "snake_case", deny_unknown_fields)]
pub enum NewElement {
    /// A line through two points.
    LineTwoPoints {
        /// One point.
        first: RollPoint,
        /// Another one.
        second: RollPoint,
    },
    /// A line through a point at an angle.
    LineAngle {
        /// The point.
        point: RollPoint,
        /// Angle to the axis, degrees, counter-clockwise.
        angle_deg: f64,
    },
    /// A line through a point, parallel to another element.
    LineParallel {
        /// The point.
        point: RollPoint,
        /// The other element, a line.
        to: ElementName,
    },
    /// A circle by its centre and radius.
    CircleRadius {
        /// Centre.
        center: RollPoint,
        /// Radius.
        radius: f64,
    },
    /// A circle by its centre and a point of it.
    CirclePoint {
        /// Centre.
        center: RollPoint,
        /// A point of it.
        point: RollPoint,
    },
    /// Another arc's circle, moved.
    CircleMoved {
        /// The other element, an arc.
        of: ElementName,
        /// Along the axis.
        dz: f64,
        /// Away from the axis, on the radius.
        dr: f64,
    },
    /// A circle of a radius that touches both neighbours.
    CircleTangent {
        /// Radius.
        radius: f64,
        /// Where it lies, seen from the element before.
        before: TangentSide,
        /// Where it lies, seen from the element after.
        after: TangentSide,
    },
}

/// Where a circle lies that touches an element.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum TangentSide {
    /// Further from the roll's axis than the line; of an upright line, to its left.
    Above,
    /// Nearer to the roll's axis than the line; of an upright line, to its right.
    Below,
    /// Inside the circle.
    Inside,
    /// Outside the circle.
    Outside,
}

impl RollEdit {
    /// The same edit with every length multiplied by `factor`.
    #[must_use]
    pub fn scaled(&self, factor: f64) -> Self {
        let action = match self.action {
            EditAction::Insert { after, ref shape } => EditAction::Insert { after, shape: shape.scaled(factor) },
            EditAction::Replace { element, ref shape } => EditAction::Replace { element, shape: shape.scaled(factor) },
            EditAction::Delete { element } => EditAction::Delete { element },
            EditAction::Chamfer { after, depth } => EditAction::Chamfer { after, depth: depth * factor },
            EditAction::Blend { after, radius } => EditAction::Blend { after, radius: radius * factor },
        };
        Self { id: self.id, action }
    }
}

impl RollPoint {
    fn scaled(self, factor: f64) -> Self {
        Self { z: self.z * factor, diameter: self.diameter * factor }
    }
}

impl NewElement {
    fn scaled(&self, factor: f64) -> Self {
        match *self {
            Self::LineTwoPoints { first, second } => {
                Self::LineTwoPoints { first: first.scaled(factor), second: second.scaled(factor) }
            }
            Self::LineAngle { point, angle_deg } => Self::LineAngle { point: point.scaled(factor), angle_deg },
            Self::LineParallel { point, to } => Self::LineParallel { point: point.scaled(factor), to },
            Self::CircleRadius { center, radius } => {
                Self::CircleRadius { center: center.scaled(factor), radius: radius * factor }
            }
            Self::CirclePoint { center, point } => {
                Self::CirclePoint { center: center.scaled(factor), point: point.scaled(factor) }
            }
            Self::CircleMoved { of, dz, dr } => Self::CircleMoved { of, dz: dz * factor, dr: dr * factor },
            Self::CircleTangent { radius, before, after } => {
                Self::CircleTangent { radius: radius * factor, before, after }
            }
        }
    }
}

impl Side {
    /// Both sides.
    pub const BOTH: [Self; 2] = [Self::Left, Self::Right];

    /// Name for people.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Left => "left",
            Self::Right => "right",
        }
    }

    /// −1 left, 1 right: the direction outwards along z.
    #[must_use]
    pub const fn sign(self) -> f64 {
        match self {
            Self::Left => -1.0,
            Self::Right => 1.0,
        }
    }

    /// The other side.
    #[must_use]
    pub const fn other(self) -> Self {
        match self {
            Self::Left => Self::Right,
            Self::Right => Self::Left,
        }
    }
}

impl ElementName {
    /// The name on the mirror image of a roll.
    #[must_use]
    pub const fn mirrored(self) -> Self {
        match self {
            Self::Strip { element, side, kind } => Self::Strip { element, side: side.other(), kind },
            Self::Edge { side } => Self::Edge { side: side.other() },
            Self::Extension { side, part } => Self::Extension { side: side.other(), part },
            Self::Unreached { element, side } => Self::Unreached { element, side: side.other() },
            Self::Flank { side } => Self::Flank { side: side.other() },
            Self::Edit { edit } => Self::Edit { edit },
        }
    }
}
