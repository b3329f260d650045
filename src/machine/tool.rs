//! A tool of the tool table.

use serde::{Deserialize, Serialize};

/// A turning tool with its insert and holder, as read from a tool file. Lengths in mm, angles in degrees.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Tool {
    /// Short name, used in machine files: `orac-right`.
    pub id: String,
    /// Name for people.
    pub name: String,
    /// Shape of its cutting part.
    pub shape: ToolShape,
    /// Holder outline as `[z, r]` points in tool space, counter-clockwise.
    pub holder: Vec<[f64; 2]>,
}

/// Shape of the cutting part; lengths in mm, angles in degrees.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(tag = "kind", rename_all = "kebab-case", deny_unknown_fields)]
pub enum ToolShape {
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
    /// A pointed tool for outside threads, symmetrical about the radial line.
    Threading {
        /// Nose radius.
        nose_radius: f64,
        /// Angle of the point, 60 for metric threads.
        corner_angle: f64,
        /// Length of the insert's edges.
        edge_length: f64,
    },
    /// A parting or grooving blade; the programmed point is its corner towards the chuck.
    Parting {
        /// Width of the cutting edge.
        width: f64,
        /// Corner radius.
        nose_radius: f64,
        /// Depth that it can reach.
        depth: f64,
    },
}

/// Hand of a turning tool.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Hand {
    /// Cuts towards the chuck; tip orientation 3.
    Right,
    /// Cuts away from the chuck; tip orientation 4.
    Left,
}
