//! Machines, tools and materials: data from files, never code.

mod catalog;
mod check;
mod file;
mod material;
mod outline;
mod tool;

use crate::geometry::Contour;
pub use material::Material;
pub use outline::outlines;
use serde::{Deserialize, Serialize};
pub use tool::{Hand, Tool, ToolShape};

/// A lathe with its control, as read from a machine file. Lengths in mm, feeds in mm/min.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Machine {
    /// Short name, used on the command line and in documents: `orac`.
    pub id: String,
    /// Name for people.
    pub name: String,
    /// Program language of the control.
    pub dialect: Dialect,
    /// What the machine and control cannot exceed.
    pub limits: Limits,
    /// Spindle speed by radius.
    pub spindle: SpindleRule,
    /// Where programs begin and end, relative to the bar.
    pub datum: DatumRule,
    /// How the bar is held.
    pub chuck: Chuck,
    /// Feed at and above which a move counts as rapid, mm/min.
    pub rapid_feed_mm_per_min: f64,
    /// Time for one tool change, s.
    pub tool_change_s: f64,
    /// Tools in the turret.
    pub tools: Vec<TurretTool>,
    /// How programs reach the control.
    pub serial: SerialProfile,
}

/// Program languages.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Dialect {
    /// Pages of the Denford ORAC.
    Orac,
}

/// Limits of machine and control.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Limits {
    /// Largest bar diameter, mm.
    pub bar_diameter_mm: f64,
    /// Travel of the cross slide, mm.
    pub travel_x_mm: f64,
    /// Travel along the spindle, mm.
    pub travel_z_mm: f64,
    /// A taper whose longer leg is more than this many times the shorter one cannot be programmed.
    pub taper_ratio: f64,
    /// Smallest arc radius, mm.
    pub arc_radius_min_mm: f64,
    /// Largest arc radius, mm.
    pub arc_radius_max_mm: f64,
    /// Arcs must stay within one quadrant.
    pub arc_one_quadrant: bool,
    /// Smallest thread pitch, mm.
    pub pitch_min_mm: f64,
    /// Largest thread pitch, mm.
    pub pitch_max_mm: f64,
    /// Lowest feed, mm/min.
    pub feed_min_mm_per_min: f64,
    /// Highest feed, mm/min.
    pub feed_max_mm_per_min: f64,
    /// Highest spindle speed, rev/min.
    pub spindle_max_rpm: f64,
    /// Blocks (pages) that a program may hold.
    pub blocks_per_program: usize,
}

/// Spindle speed as a line over the radius being cut: `at_center_rpm - per_mm_radius * radius`.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SpindleRule {
    /// Speed at the spindle axis, rev/min.
    pub at_center_rpm: f64,
    /// Fall of the speed per mm of radius, rev/min.
    pub per_mm_radius_rpm: f64,
    /// Threads are cut at `thread_feed_mm_per_min / pitch`, rev/min.
    pub thread_feed_mm_per_min: f64,
}

/// The program datum relative to the bar: where the tool starts, changes and ends.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct DatumRule {
    /// Clearance above the bar's radius, mm.
    pub radial_clearance_mm: f64,
    /// Distance in front of the free end, mm.
    pub axial_clearance_mm: f64,
}

/// Chuck or collet that holds the bar.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Chuck {
    /// Outside radius of the jaws, mm.
    pub radius_mm: f64,
    /// Depth of the jaws along the spindle, mm.
    pub depth_mm: f64,
    /// Distance kept between the chuck's face and what is machined, mm.
    pub gap_mm: f64,
    /// Length of bar that the jaws grip, mm.
    pub grip_mm: f64,
    /// Length that the jaws grip with automatic part handling, plus the length left for the handling, mm.
    pub automatic_grip_mm: f64,
}

/// One tool in its turret station.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct TurretTool {
    /// Number that calls it in a program.
    pub station: u32,
    /// Tool id in the tool table.
    pub tool: String,
}

/// How a program goes over the wire to a control.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SerialProfile {
    /// Speed, bits per second.
    pub baud: u32,
    /// Data bits, 7 or 8.
    pub data_bits: u8,
    /// Parity bit.
    pub parity: Parity,
    /// Stop bits, 1 or 2.
    pub stop_bits: u8,
    /// Flow control.
    pub flow: FlowControl,
    /// Character that begins a page, as a number.
    pub page_start: u8,
    /// Character that ends the transfer, as a number.
    pub end: u8,
}

/// Parity of a serial line.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Parity {
    /// No parity bit.
    None,
    /// Odd number of ones.
    Odd,
    /// Even number of ones.
    Even,
}

/// Flow control of a serial line.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum FlowControl {
    /// None: the receiver must keep up.
    None,
    /// DC1/DC3 characters.
    Software,
    /// RTS/CTS lines.
    Hardware,
}

/// The true outline of a tool in tool space, closed, counter-clockwise, mm.
///
/// Tool space: the origin is the point that the program moves; `z` and `r` as in part space.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct ToolOutline {
    /// The cutting insert or blade.
    pub insert: Contour,
    /// Everything else that moves with it and must touch nothing.
    pub holder: Contour,
}

/// Everything that was loaded: machines, tools and materials, shipped and the user's own.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Catalog {
    /// Machines by id.
    pub machines: Vec<Machine>,
    /// Tools by id.
    pub tools: Vec<Tool>,
    /// Materials by name.
    pub materials: Vec<Material>,
}
