//! One clamping of the part.

use super::{Profile, ThreadSpec};
use crate::document::Holding;
use crate::geometry::Contour;
use crate::machine::Directions;

/// One clamping of the part: what is machined while it is held, in the space of that set-up (free end at the largest z), mm.
#[derive(Debug, Clone, PartialEq)]
pub struct Setup {
    /// Suffix of file names: empty with one end, `A` and `B` with two.
    pub suffix: String,
    /// The whole finished outside, with the face of the free end down to the bore, or to the axis where there is none.
    pub profile: Profile,
    /// Threads cut outside in this set-up.
    pub threads: Vec<ThreadSpec>,
    /// What is machined outside in this set-up: z from here to `length`.
    pub machined_from_z: f64,
    /// The whole finished inside, the hole of a tube included (row 0); `None` in a solid part.
    ///
    /// It begins or ends with a face down to the axis at the bottom of a blind hole; a web between two holes is a piece on
    /// the axis. An open end has no face.
    pub bore: Option<Profile>,
    /// Threads cut in the bore in this set-up.
    pub bore_threads: Vec<ThreadSpec>,
    /// What is machined of the bore in this set-up: z from here to `length`; `length` if nothing of it. A part machined at
    /// both ends is bored from each down to its narrowest place.
    pub bored_from_z: f64,
    /// Length of the finished part.
    pub length: f64,
    /// Radius of the bar.
    pub bar_radius: f64,
    /// Closed outline of the material before this set-up, counter-clockwise: the axis is part of it in solid material, the
    /// wall of the hole in a tube. It reaches beyond `length` by the facing allowance.
    pub stock: Contour,
    /// How the work is held.
    pub holding: Holding,
    /// Directions along the spindle in which this holding allows to cut.
    pub directions: Directions,
    /// Position of the chuck's face; the jaws lie to its left.
    pub chuck_face_z: f64,
    /// Closed outline of what drives work held between centres at its clamped end, in front of the chuck's face; the chuck
    /// itself without.
    pub mandrel: Option<Contour>,
    /// Closed outline of the tailstock's centre, if it holds the work.
    pub tailstock: Option<Contour>,
    /// Width to be parted off at the clamped end, if any.
    pub part_off_width: Option<f64>,
    /// True if z runs against the document's positions (second end): document position = length − z.
    pub turned_round: bool,
}

impl Setup {
    /// True if tools may cut away from the headstock, too.
    #[must_use]
    pub fn may_cut_both_ways(&self) -> bool {
        self.directions == Directions::Both
    }
}
