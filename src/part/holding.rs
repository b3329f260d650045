//! How the work is held in a set-up: by the chuck, or between a mandrel or driver and the tailstock.

use crate::document::Holding;
use crate::geometry::{Contour, Point};
use crate::machine::{Directions, Machine, Outline};

/// What holds the work, in part space of the set-up, mm.
pub(super) struct Held {
    /// Position of the chuck's face.
    pub chuck_face_z: f64,
    /// Outline of what drives the work in front of the chuck's face.
    pub mandrel: Option<Contour>,
    /// Outline of the tailstock's centre.
    pub tailstock: Option<Contour>,
    /// Directions in which may be cut.
    pub directions: Directions,
}

/// The work between `from_z` and `to_z`, held in the chuck with its face at `chuck_face_z`, or between centres at its ends.
pub(super) fn held(holding: Holding, machine: &Machine, chuck_face_z: f64, from_z: f64, to_z: f64) -> Held {
    match holding {
        Holding::Chuck => Held { chuck_face_z, mandrel: None, tailstock: None, directions: machine.chuck.cuts },
        Holding::BetweenCentres => {
            let mandrel = machine.mandrel.as_ref().map(|outline| at(outline, from_z));
            let driven_at = mandrel.as_ref().and_then(Contour::bounds).map(|b| b.min.z);
            Held {
                chuck_face_z: driven_at.unwrap_or(from_z - machine.chuck.gap_mm),
                mandrel,
                tailstock: machine.tailstock.as_ref().map(|outline| at(outline, to_z)),
                directions: Directions::Both,
            }
        }
    }
}

/// An outline of the machine with its zero at position `z`.
fn at(outline: &Outline, z: f64) -> Contour {
    let corners: Vec<Point> = outline.outline.iter().map(|&[dz, r]| Point::new(z + dz, r)).collect();
    Contour::polygon(&corners)
}
