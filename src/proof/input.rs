//! What a proof needs to know.

use super::{ProgramText, Target};
use crate::geometry::Contour;
use crate::machine::{Machine, Material, ToolOutline};
use std::collections::BTreeMap;
use std::sync::Arc;

/// Programs to prove and what they are proved against. Geometry in part space of the set-up, mm.
#[derive(Debug, Clone, PartialEq)]
pub struct ProofInput {
    /// The machine that will run them.
    pub machine: Arc<Machine>,
    /// True outline of every tool by turret station.
    pub tools: Arc<BTreeMap<u32, ToolOutline>>,
    /// Programs in the order they are run on the same stock.
    pub programs: Arc<Vec<ProgramText>>,
    /// The bar, the part and how it is held; without it only what the machine can do is checked.
    pub work: Option<Work>,
}

/// The material in the machine and what is to come out of it.
#[derive(Debug, Clone, PartialEq)]
pub struct Work {
    /// Closed outline of the stock, counter-clockwise, axis included.
    pub stock: Contour,
    /// What must come out.
    pub target: Target,
    /// Part-space position of the control's zero along the spindle.
    pub program_zero_z: f64,
    /// Position of the chuck's face.
    pub chuck_face_z: f64,
    /// Closed outline of what drives work held between centres at its clamped end, in front of the chuck's face.
    pub mandrel: Option<Contour>,
    /// Closed outline of the tailstock's centre, if it holds the work.
    pub tailstock: Option<Contour>,
    /// What the stock is made of, for the power of the cuts; without it or its specific force power is not looked at.
    pub material: Option<Material>,
    /// Deviation from the contour that is allowed, mm.
    pub form_tolerance_mm: f64,
    /// Where threads and the parting groove may cut below the contour: z range and lowest radius.
    pub may_cut: Vec<MayCut>,
}

/// A region below the contour that may be cut: a thread's groove or the parting-off.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MayCut {
    /// From this position.
    pub z1: f64,
    /// To this position.
    pub z2: f64,
    /// Down to this radius.
    pub radius: f64,
}
