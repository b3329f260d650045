//! A tool of the tool table.

use super::{ToolKind, ToolMaterial};
use serde::{Deserialize, Serialize};

/// Depth of a hole in diameters that a drill makes in one go where its file does not say: what text books give for twist drills of
/// high-speed steel (guide value).
pub const PECKS_FROM: f64 = 3.0;

const fn pecks_from() -> f64 {
    PECKS_FROM
}

/// A turning tool with its insert and holder, as read from a tool file. Lengths in mm, angles in degrees.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Tool {
    /// Short name, used in machine files: `orac-right`.
    pub id: String,
    /// Name for people.
    pub name: String,
    /// What its edge is made of.
    #[serde(default)]
    pub edge: ToolMaterial,
    /// Shape of its cutting part.
    pub shape: ToolShape,
    /// Shank or bar from which a common holder is drawn; none with [`Self::holder`] or a holder code.
    #[serde(default)]
    pub shank: Option<Shank>,
    /// Holder outline as `[z, r]` points in tool space, counter-clockwise; empty with a shank or a holder code.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub holder: Vec<[f64; 2]>,
    /// Holder by its interference lines from end point to end point, `[z1, r1, z2, r2]` in tool space, in counter-clockwise
    /// order (MTIRA turning processor, 1977); gaps between them are closed. Instead of [`Self::holder`].
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub interference_lines: Vec<[f64; 4]>,
}

/// Shank of an outside tool or bar of an inside tool.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Shank {
    /// Width of the shank along the spindle, or diameter of the bar.
    pub width: f64,
    /// Length from the tip to the far end of the shank; of a bar the length that stands out of its sleeve.
    pub length: f64,
}

/// Shape of the cutting part; lengths in mm, angles in degrees.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(tag = "kind", rename_all = "kebab-case", deny_unknown_fields)]
pub enum ToolShape {
    /// Insert and holder by their codes: ISO 1832 with ISO 5608 or ISO 6261; laydown threading inserts by the makers' common
    /// codes.
    Iso {
        /// Insert: `CNMG120408`, `16ER AG60`.
        insert: String,
        /// Holder: `PCLNR2525M12`, `S20S-SCLCR09`, `SER2525M16`.
        holder: String,
    },
    /// A turning tool with a pointed insert.
    Turning {
        /// Cuts towards the chuck (`right`) or away from it (`left`).
        hand: Hand,
        /// Nose radius.
        nose_radius: f64,
        /// Angle of the insert's corner.
        corner_angle: f64,
        /// Angle between the cutting edge and the direction of feed.
        approach_angle: f64,
        /// Length of the insert's edges.
        edge_length: f64,
    },
    /// A turning tool that points straight at the work and cuts in both directions; the programmed point is its lowest.
    Copying {
        /// Nose radius.
        nose_radius: f64,
        /// Angle of the insert's corner.
        corner_angle: f64,
        /// Length of the insert's edges.
        edge_length: f64,
    },
    /// A round insert; the programmed point is its lowest.
    Button {
        /// Diameter of the insert.
        diameter: f64,
    },
    /// A turning tool for bores; as `turning`, with its tip outwards.
    Boring {
        /// Cuts towards the chuck (`right`) or away from it (`left`).
        hand: Hand,
        /// Nose radius.
        nose_radius: f64,
        /// Angle of the insert's corner.
        corner_angle: f64,
        /// Angle between the cutting edge and the direction of feed.
        approach_angle: f64,
        /// Length of the insert's edges.
        edge_length: f64,
    },
    /// A pointed tool for threads, symmetrical about the radial line.
    Threading {
        /// Nose radius.
        nose_radius: f64,
        /// Angle of the point, 60 for metric threads.
        corner_angle: f64,
        /// Length of the insert's edges.
        edge_length: f64,
        /// For threads in a bore.
        #[serde(default)]
        inside: bool,
    },
    /// A parting or grooving blade. The programmed point is its corner towards the chuck; of a left-hand one, the mirror
    /// image, its corner away from the chuck.
    Parting {
        /// Side on which the holder lies flush with the blade: towards the chuck (`right`) or away from it (`left`).
        #[serde(default)]
        hand: Hand,
        /// Width of the cutting edge.
        width: f64,
        /// Corner radius; 0 for sharp corners.
        nose_radius: f64,
        /// Depth that it can reach.
        depth: f64,
        /// For grooves in a bore.
        #[serde(default)]
        inside: bool,
    },
    /// A drill on the axis; the programmed point is its tip.
    Drill {
        /// Diameter.
        diameter: f64,
        /// Angle of its point.
        point_angle: f64,
        /// Length from the tip that stands out of its holder.
        length: f64,
        /// Depth of a hole in diameters from which on the drill is drawn out again and again to clear its chips.
        #[serde(default = "pecks_from")]
        pecks_from: f64,
    },
    /// Any outline.
    Outline {
        /// What the tool is for.
        #[serde(rename = "use")]
        purpose: ToolKind,
        /// Tip orientation, 1 to 9; see [`super::ToolOutline::orientation`].
        orientation: u8,
        /// Nose radius, which rounds the first corner; 0 for a sharp one.
        nose_radius: f64,
        /// Corners as `[z, r]` in tool space, counter-clockwise, the tip first.
        corners: Vec<[f64; 2]>,
        /// Edges that cut by number, from 0: edge n goes from corner n to the next. Without any, the two beside the tip.
        #[serde(default)]
        cuts: Vec<usize>,
    },
    /// A contouring tool by interference lines (MTIRA turning processor, 1977): a front edge square to the spindle, a flank
    /// that rises at an angle from the nose, a body as wide as the tool with a margin for safety behind it.
    Interference {
        /// Cuts towards the chuck (`right`) or away from it (`left`).
        hand: Hand,
        /// Nose radius.
        nose_radius: f64,
        /// Width of the tool.
        width: f64,
        /// Angle between flank and spindle.
        angle: f64,
        /// Margin behind the tool.
        margin: f64,
    },
}

/// Hand of a tool.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Hand {
    /// Cuts towards the chuck; tip orientation 3 outside, 2 in a bore.
    #[default]
    Right,
    /// Cuts away from the chuck; tip orientation 4 outside, 1 in a bore.
    Left,
}
