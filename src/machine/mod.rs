//! Machines, tools and materials: data from files, never code.

mod catalog;
mod check;
mod file;
mod iso;
mod material;
mod motion;
mod outline;
mod power;
mod save;
mod serial;
mod spindle;
mod tool;
mod words;

pub use check::Fault;
pub use material::{CuttingData, CuttingOperation, Material, OperationData, OracData, ToolMaterial};
pub use motion::{Axis, Motion};
pub use outline::{ToolKind, ToolOutline, outlines};
pub use power::Chip;
pub use save::{Item, faults, save_user, to_toml};
use serde::{Deserialize, Serialize};
pub use serial::{
    BAUD, DC1, DC2, DC3, DC4, Delivery, EndOfBlock, FlowControl, FolderProfile, PageMarks, Parity, Protocol,
    ReaderPunch, SerialProfile, WrongKey,
};
pub use spindle::{SpeedRule, Spindle, SpindleRange};
pub use tool::{Hand, PECKS_FROM, Shank, Tool, ToolShape};
pub use words::{
    ArcCenter, ClampWord, Codes, Comments, DecimalPoint, Digits, DwellWord, Preset, ProgramNumber, SequenceNumbers,
    SpeedCode, ThreadAngle, ThreadWord, ToolWord, Words, Zeros,
};

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
    /// Feed at and above which a move counts as rapid, mm/min, on a control that has no word for rapid; `None` on others.
    #[serde(default)]
    pub rapid_feed_mm_per_min: Option<f64>,
    /// Time for one tool change, s.
    pub tool_change_s: f64,
    /// Side of the axis on which the turret stands.
    #[serde(default)]
    pub turret_side: TurretSide,
    /// How the control writes its words; `None` for the ORAC, whose pages have none.
    #[serde(default)]
    pub words: Option<Words>,
    /// What the machine and control cannot exceed.
    pub limits: Limits,
    /// Speeds and power of the spindle.
    pub spindle: Spindle,
    /// Rapid rates; `None` on a control that has no word for rapid.
    #[serde(default)]
    pub motion: Option<Motion>,
    /// Where programs begin and end, relative to the bar.
    pub datum: DatumRule,
    /// Where the turret rests and tools are changed that have no place of their own, in program coordinates; the datum
    /// without.
    #[serde(default)]
    pub rest: Option<Position>,
    /// How the bar is held.
    pub chuck: Chuck,
    /// What holds the bored work or drives it at the clamped end when it is held between centres; the chuck without.
    #[serde(default)]
    pub mandrel: Option<Outline>,
    /// The tailstock's centre; none without.
    #[serde(default)]
    pub tailstock: Option<Outline>,
    /// What the machine costs; unknown without.
    #[serde(default)]
    pub cost: Option<Cost>,
    /// Tools in the turret.
    pub tools: Vec<TurretTool>,
    /// How programs reach the control.
    pub serial: Delivery,
}

/// Program languages.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Dialect {
    /// Pages of the Denford ORAC.
    Orac,
    /// Words as Fanuc lathe controls read them, G-code system A.
    Fanuc,
    /// Words as `LinuxCNC` reads them on a lathe.
    Linuxcnc,
}

/// Side of the axis on which the turret stands, seen by the operator.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum TurretSide {
    /// Behind the axis, as on slant beds.
    #[default]
    Rear,
    /// Between axis and operator.
    Front,
}

/// A place of the programmed point in program coordinates.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Position {
    /// Along the spindle from the program zero, mm.
    pub z_mm: f64,
    /// Diameter, mm, positive whatever sign the control writes.
    pub diameter_mm: f64,
}

/// Outline of a part of the machine, the half above the axis.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Outline {
    /// Corners as `[z, r]`, mm, counter-clockwise. z counts from the end of the work that it holds: on the tailstock 0 is
    /// the free end and the body lies at positive z; on the mandrel 0 is the clamped end and the body at negative z.
    pub outline: Vec<[f64; 2]>,
}

/// What running the machine costs, in the currency of the user's choice.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Cost {
    /// Name of the currency: `EUR`.
    pub currency: String,
    /// Machine and operator, per hour.
    pub machine_per_hour: f64,
    /// Setting up, once for a batch.
    pub setup: f64,
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

/// The program datum relative to the bar: where the tool starts, changes and ends.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct DatumRule {
    /// Clearance above the bar's radius, mm.
    pub radial_clearance_mm: f64,
    /// Distance in front of the free end, mm.
    pub axial_clearance_mm: f64,
    /// End of the part at which the program's z is zero.
    #[serde(default)]
    pub zero: ZeroEnd,
}

/// An end of the part.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum ZeroEnd {
    /// The face away from the chuck.
    #[default]
    FreeEnd,
    /// The face towards the chuck.
    ClampedEnd,
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
    /// Directions along the spindle in which work held in the chuck is cut.
    #[serde(default)]
    pub cuts: Directions,
}

/// Directions along the spindle in which may be cut.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Directions {
    /// Towards the headstock only: the cut presses the work into the chuck.
    #[default]
    TowardsHeadstock,
    /// Both.
    Both,
}

/// One tool in its turret station.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct TurretTool {
    /// Number that calls it in a program.
    pub station: u32,
    /// Tool id in the tool table.
    pub tool: String,
    /// Number of its offset; that of the station without.
    #[serde(default)]
    pub offset: Option<u32>,
    /// Where this tool is changed along the spindle, program coordinates, mm; the machine's rest position without.
    #[serde(default)]
    pub change_z_mm: Option<f64>,
    /// Diameter at which this tool is changed, mm, positive; the machine's rest position without.
    #[serde(default)]
    pub change_diameter_mm: Option<f64>,
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

impl Machine {
    /// Rapid rate of an axis, mm/min. A control without a word for rapid moves at [`Self::rapid_feed_mm_per_min`].
    #[must_use]
    pub fn rapid_mm_per_min(&self, axis: Axis) -> f64 {
        match (self.motion, axis) {
            (Some(motion), Axis::X) => motion.rapid_x_mm_per_min,
            (Some(motion), Axis::Z) => motion.rapid_z_mm_per_min,
            (None, _) => self.rapid_feed_mm_per_min.unwrap_or(self.limits.feed_max_mm_per_min),
        }
    }

    /// True if a move at this feed, mm/min, counts as a rapid move though it is written as a cut.
    #[must_use]
    pub fn counts_as_rapid(&self, feed_mm_per_min: f64) -> bool {
        self.rapid_feed_mm_per_min.is_some_and(|rapid| feed_mm_per_min >= rapid)
    }

    /// The tool in a station.
    #[must_use]
    pub fn turret_tool(&self, station: u32) -> Option<&TurretTool> {
        self.tools.iter().find(|t| t.station == station)
    }

    /// Where the tool of a station is changed, in program coordinates: its own place, or the machine's rest position.
    /// `None` stands for the datum.
    #[must_use]
    pub fn change_position(&self, station: u32) -> Option<Position> {
        let tool = self.turret_tool(station);
        let own = tool.and_then(|t| Some(Position { z_mm: t.change_z_mm?, diameter_mm: t.change_diameter_mm? }));
        own.or(self.rest)
    }

    /// Highest spindle speed, rev/min: the lower one of the machine's limit and its fastest range.
    #[must_use]
    pub fn rpm_limit(&self) -> f64 {
        let ranges = self.spindle.ranges.iter().map(|r| r.max_rpm).reduce(f64::max);
        ranges.map_or(self.limits.spindle_max_rpm, |fastest| fastest.min(self.limits.spindle_max_rpm))
    }

    /// The speed that the machine can turn at for a wanted one, rev/min: within its limits, and on a machine with a table
    /// of speeds the next lower step (the lowest one if there is none lower).
    #[must_use]
    pub fn nearest_rpm(&self, wanted_rpm: f64) -> f64 {
        let within = wanted_rpm.min(self.rpm_limit()).max(self.spindle.min_rpm);
        let Some(words) = self.words.as_ref().filter(|_| self.spindle.speed == SpeedRule::Table) else { return within };
        let steps = || words.speed_codes.iter().map(|step| step.rpm);
        let lower = steps().filter(|&rpm| rpm <= within).reduce(f64::max);
        lower.or_else(|| steps().reduce(f64::min)).unwrap_or(within)
    }
}

impl TurretTool {
    /// A tool whose offset and change position are the machine's usual ones.
    #[must_use]
    pub fn new(station: u32, tool: &str) -> Self {
        Self { station, tool: tool.to_owned(), offset: None, change_z_mm: None, change_diameter_mm: None }
    }

    /// Number of its offset.
    #[must_use]
    pub fn offset_number(&self) -> u32 {
        self.offset.unwrap_or(self.station)
    }
}
