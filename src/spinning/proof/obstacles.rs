//! What the roller must not run into: former, chuck, follower, tailstock.

use super::ShellProofInput;
use crate::geometry::Point;
use crate::proof::FindingKind;

/// A body above the axis.
pub(super) struct Obstacle {
    /// Name for people.
    pub name: &'static str,
    /// What a contact counts as.
    pub kind: FindingKind,
    /// Its closed outline.
    pub outline: Vec<Point>,
    /// The nose may come as near as the wall: it is looked at by the gap.
    pub formed_on: bool,
}

/// Chords of the former's outline stay within this, mm.
const CHORD_MM: f64 = 0.02;

/// All of them.
pub(super) fn obstacles(input: &ShellProofInput) -> Vec<Obstacle> {
    let (shape, machine) = (&input.shape, &input.machine);
    let face = shape.tip().z + shape.thickness;
    let blank = &input.shell.blank;
    let block =
        |z1: f64, z2: f64, r: f64| vec![Point::new(z1, 0.0), Point::new(z2, 0.0), Point::new(z2, r), Point::new(z1, r)];
    let mut all = vec![
        Obstacle { name: "former", kind: FindingKind::Gouge, outline: shape.former_outline(CHORD_MM), formed_on: true },
        Obstacle {
            name: "chuck",
            kind: FindingKind::ChuckCollision,
            outline: block(-machine.chuck.depth_mm, 0.0, machine.chuck.radius_mm),
            formed_on: false,
        },
        Obstacle {
            name: "follower",
            kind: FindingKind::TailstockCollision,
            outline: block(face, face + blank.follower_length, blank.follower_diameter / 2.0),
            formed_on: false,
        },
    ];
    if let Some(tailstock) = &machine.tailstock {
        let behind = face + blank.follower_length;
        let outline = tailstock.outline.iter().map(|[z, r]| Point::new(z + behind, *r)).collect();
        let kind = FindingKind::TailstockCollision;
        all.push(Obstacle { name: "tailstock", kind, outline, formed_on: false });
    }
    all
}
