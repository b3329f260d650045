//! What a proof found.

use super::MayCut;
use super::cut::StockHistory;
use crate::diagnostic::Severity;
use crate::geometry::{Contour, Point, Segment};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::sync::Arc;

/// The proof of the programs of one set-up, in the order they are run on the same stock.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct ProofReport {
    /// True if there is no finding of severity error.
    pub passed: bool,
    /// Findings in order of program and block.
    pub findings: Vec<Finding>,
    /// Times of all programs together.
    pub times: Times,
    /// What the part costs, if the machine's file names its rates.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cost: Option<PartCost>,
    /// Largest chip cross-section (depth × feed per revolution), mm².
    pub largest_chip_mm2: f64,
    /// Deepest gouge into the contour, mm.
    pub deepest_gouge_mm: f64,
    /// What is left on every section.
    pub leftover: Vec<Leftover>,
    /// One entry a block, in order of program and text.
    pub blocks: Vec<BlockReport>,
    /// Every move that was run, loops and subroutines unrolled; for playback.
    #[serde(skip)]
    pub moves: Vec<Move>,
    /// Stock states in order; moves refer to them by index. The first is the stock before the first move.
    #[serde(skip)]
    pub stock: StockHistory,
}

impl ProofReport {
    /// The findings that must not be.
    pub fn errors(&self) -> impl Iterator<Item = &Finding> {
        self.findings.iter().filter(|finding| finding.severity == Severity::Error)
    }

    /// Program name and block of the first error in the order of the programs.
    #[must_use]
    pub fn first_wrong_block(&self) -> Option<(&str, usize)> {
        self.errors().next().map(|finding| (finding.program.as_str(), finding.block))
    }
}

/// The cost of one part by its programs, in the currency of the machine's file.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct PartCost {
    /// Name of the currency.
    pub currency: String,
    /// Setting up, once for a batch.
    pub setup: f64,
    /// Blank of one part; `None` if the material's mass or price is not known.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub blank: Option<f64>,
    /// Machine and operator for the time of one part.
    pub machining: f64,
    /// Blank and machining together.
    pub part: f64,
}

/// Times by kind, s.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Times {
    /// All together.
    pub total_s: f64,
    /// Moves at cutting feed.
    pub feed_s: f64,
    /// Moves at rapid feed.
    pub rapid_s: f64,
    /// Dwells.
    pub dwell_s: f64,
    /// Tool changes.
    pub tool_change_s: f64,
}

/// Something that the proof found.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Finding {
    /// How much it matters.
    pub severity: Severity,
    /// What it is.
    pub kind: FindingKind,
    /// Program name without extension.
    pub program: String,
    /// Block from 1 in the text of the program.
    pub block: usize,
    /// Where, in part space of the set-up, if it has a place.
    pub at: Option<Point>,
    /// Measured value, in the unit that the message names.
    pub value: f64,
    /// Limit that it is compared with, same unit.
    pub limit: f64,
    /// A sentence with value, limit and unit.
    pub message: String,
}

/// Kinds of finding.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum FindingKind {
    /// A word or instruction that cannot be read or is not known.
    Unreadable,
    /// The insert cut below the finished contour.
    Gouge,
    /// Stock touched at rapid feed.
    RapidContact,
    /// A side or back of the insert that cannot cut ran into stock.
    FlankCollision,
    /// The holder ran into stock.
    HolderCollision,
    /// Insert or holder ran into the chuck, the mandrel or the tailstock.
    ChuckCollision,
    /// Insert or holder ran into the tailstock.
    TailstockCollision,
    /// Material is left on a section.
    Leftover,
    /// A travel limit was exceeded.
    OverTravel,
    /// Feed, speed, pitch, radius or taper outside the machine's limits.
    OutsideLimits,
    /// The program does not end where it began, so its increments do not add up.
    NotClosed,
    /// The program or a loop ran past the step budget, or a subroutine is missing or nested too deep.
    Control,
    /// More blocks than the control holds, no end, or blocks after the end.
    Structure,
    /// Something in the text of the program that the control demands otherwise, told without running it.
    Lint,
    /// The cut needs more power than the spindle has.
    Power,
}

/// What is left on one section after the last program.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Leftover {
    /// Row id.
    pub section: u32,
    /// Largest distance of the stock from the contour, mm.
    pub largest_mm: f64,
    /// Mean distance along the section, mm.
    pub mean_mm: f64,
    /// Where it is largest.
    pub at: Point,
}

/// One block of one program, all its executions together.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct BlockReport {
    /// Program name without extension.
    pub program: String,
    /// Block from 1.
    pub block: usize,
    /// Its own number in the text: a page's, or the N word.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub printed: Option<u32>,
    /// How often it was run.
    pub runs: u32,
    /// Time of all runs, s.
    pub time_s: f64,
    /// Area of stock removed in the half-plane, mm².
    pub removed_mm2: f64,
    /// Largest chip cross-section, mm².
    pub chip_mm2: f64,
}

/// How the tool moves.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Motion {
    /// At or above the machine's rapid feed.
    Rapid,
    /// At cutting feed.
    Feed,
    /// A threading pass.
    Thread,
    /// No motion: a dwell, a tool change or a wait.
    Pause,
}

/// One move of the programmed point in part space of the set-up.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Move {
    /// Program by index in the order of the proof.
    pub program: usize,
    /// Block from 1 in that program.
    pub block: usize,
    /// Path of the programmed point; a pause has a line of no length.
    pub path: Segment,
    /// Kind of motion.
    pub motion: Motion,
    /// Turret station of the tool.
    pub tool: u32,
    /// Feed, mm/min.
    pub feed_mm_per_min: f64,
    /// Spindle speed, rev/min.
    pub rpm: f64,
    /// Time from the start of the first program to the start of this move, s.
    pub starts_s: f64,
    /// Duration, s.
    pub lasts_s: f64,
    /// Index of the stock state after this move.
    pub stock_after: usize,
}

/// A block of one of the programs of a proof.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct BlockRef {
    /// Program by index in the order of the proof.
    pub program: usize,
    /// Block from 1.
    pub block: usize,
}

impl BlockRef {
    /// The block that a move belongs to.
    #[must_use]
    pub const fn of(m: &Move) -> Self {
        Self { program: m.program, block: m.block }
    }
}

/// The stock at one moment: closed polygons in part space, outer ones counter-clockwise, holes clockwise.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct StockState {
    /// The rings.
    pub rings: Arc<Vec<Vec<Point>>>,
}

/// A part as the proof needs it: what must come out, and what it is cut from.
#[derive(Debug, Clone, PartialEq)]
pub struct Target {
    /// The finished outside from the clamped end to the free end, lines and arcs.
    pub contour: Contour,
    /// Row id of each segment of `contour`.
    pub sections: Vec<u32>,
    /// What people call a section, by row id: `line 3`.
    pub names: BTreeMap<u32, String>,
    /// Part of the contour that this set-up machines: z from here up.
    pub machined_from_z: f64,
    /// The finished bore, if there is one.
    pub bore: Option<BoreTarget>,
}

/// The bore of a part as the proof needs it.
#[derive(Debug, Clone, PartialEq)]
pub struct BoreTarget {
    /// The finished inside from the clamped end to the free end, lines and arcs; it begins or ends on the axis at the
    /// bottom of a blind hole, and lies on the axis where a web divides two holes.
    pub contour: Contour,
    /// Row id of each segment of `contour`; 0 for the hole of a tube that no row describes.
    pub sections: Vec<u32>,
    /// Part of the contour that this set-up machines: z from here up; the length of the part if nothing of it.
    pub machined_from_z: f64,
    /// Where inside threads may cut beyond the contour: z range and largest radius.
    pub may_cut: Vec<MayCut>,
}

/// The text of one program and its name without extension.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ProgramText {
    /// Name without extension: `QUEEN1`.
    pub name: String,
    /// The text as it is or will be on the control.
    pub text: String,
    /// True if it was edited by hand and differs from the generated text.
    pub edited: bool,
}
