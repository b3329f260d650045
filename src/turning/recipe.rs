//! What some moves of an operation were made from, for controls that can make such moves by themselves.
//!
//! The moves stay the reference: a post may write the recipe in place of the moves that it stands for, and must write the
//! moves where the control or the user does without.

use super::{Cut, CutMove};
use crate::geometry::Point;
use std::ops::Range;

/// What some moves of an operation were made from.
#[derive(Debug, Clone, PartialEq)]
pub struct Recipe {
    /// Which of the operation's moves it stands for.
    pub moves: Range<usize>,
    /// What they do.
    pub kind: RecipeKind,
}

/// What the moves of a recipe do.
#[derive(Debug, Clone, PartialEq)]
pub enum RecipeKind {
    /// One pass along a contour.
    Finish(FinishRecipe),
    /// Cuts along the spindle down to a contour.
    Rough(RoughRecipe),
    /// A thread.
    Thread(ThreadRecipe),
}

/// Side of the direction of travel on which the tool is, with z right and the radius up.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Side {
    /// Left of it.
    Left,
    /// Right of it: outside turning towards the chuck.
    Right,
}

/// One pass along a contour, as a control with nose compensation wants it.
#[derive(Debug, Clone, PartialEq)]
pub struct FinishRecipe {
    /// From the point before the recipe's moves to the contour's first point, at least the nose's diameter away, then lines
    /// and arcs along the contour itself.
    pub contour: Vec<CutMove>,
    /// Where the tool is.
    pub side: Side,
    /// Nose radius, mm.
    pub nose_radius: f64,
    /// Tip orientation, 1 to 9, as on a rear turret: 3 turns outside towards the chuck.
    pub orientation: u8,
}

/// Cuts along the spindle down to a contour that neither falls nor turns back on the way.
#[derive(Debug, Clone, PartialEq)]
pub struct RoughRecipe {
    /// Where the cycle begins and ends: outside the stock, in front of the contour.
    pub start: Point,
    /// Path of the finishing tool's programmed point; its first move goes from the start in across the spindle.
    pub contour: Vec<CutMove>,
    /// Depth of one cut on the radius, mm.
    pub depth: f64,
    /// How far the tool lifts on the radius for its way back, mm.
    pub retract: f64,
    /// What is left on the radius, mm.
    pub allowance_radius: f64,
    /// What is left along the spindle, mm.
    pub allowance_z: f64,
    /// Feed and speed.
    pub cut: Cut,
}

/// A thread along the spindle, one start, from the point before the recipe's moves.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ThreadRecipe {
    /// Position of the thread's far end, mm.
    pub to_z: f64,
    /// Radius at which the first cut touches, mm: the crest.
    pub crest_radius: f64,
    /// Radius of the last cut, mm.
    pub root_radius: f64,
    /// Advance along the spindle per turn, mm.
    pub lead: f64,
    /// Depth of the first cut on the radius, mm; further cuts keep the chip's area.
    pub first_depth: f64,
    /// Smallest depth of a further cut on the radius, mm.
    pub least_depth: f64,
    /// What the last cut takes, mm on the radius.
    pub finish_depth: f64,
    /// Cuts at full depth that only clean.
    pub spring_passes: u8,
    /// Angle of the infeed from the radial direction, degrees: 0, or up to half the thread's angle along a flank.
    pub flank_deg: f64,
    /// Length beyond `to_z` on which the tool leaves the work while the slide is still coupled, mm; 0 for a groove behind
    /// the thread.
    pub run_out: f64,
    /// Spindle speed, rev/min.
    pub rpm: f64,
}
