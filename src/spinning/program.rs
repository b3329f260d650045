//! The roller path as cutter location data, and what the program says of itself. The programmed point is the centre of the
//! roller's nose.

use super::path::RollerPath;
use super::shape::ShellShape;
use crate::document::Shell;
use crate::geometry::{Contour, Point, Segment};
use crate::machine::Machine;
use crate::post::Header;
use crate::turning::{Cut, CutMove, CutterPath, Feed, Operation, OperationKind, Speed};
use std::collections::BTreeMap;

/// Cutter location data of a design in mm. The program's zero is the face of the former's tip.
#[must_use]
pub fn cutter_path(shell_mm: &Shell, shape: &ShellShape, path: &RollerPath, machine: &Machine) -> CutterPath {
    let zero = shape.tip().z;
    let datum = Point::new(
        zero + shape.thickness + machine.datum.axial_clearance_mm + shell_mm.roller.nose_radius,
        path.free_radius,
    );
    let change = machine
        .change_position(shell_mm.roller.station)
        .map(|at| Point::new(zero + at.z_mm, (at.diameter_mm / 2.0).max(path.free_radius)));
    let cut = cut(shell_mm, shape, machine);
    let count = path.passes.len();
    let mut moves = Vec::new();
    for pass in &path.passes {
        moves.push(CutMove::Rapid { to: Point::new(pass.approach.z, path.free_radius) });
        moves.push(CutMove::Rapid { to: pass.approach });
        moves.extend(pass.contour.segments.first().map(|s| CutMove::Line { to: s.start(), cut }));
        moves.extend(along(&pass.contour, cut));
        moves.push(CutMove::Line { to: pass.retreat, cut });
    }
    let operation = Operation {
        kind: OperationKind::FinishRight,
        name: if count > 1 { format!("Form in {count} passes") } else { "Form".to_owned() },
        tool: shell_mm.roller.station,
        change,
        moves,
        recipes: Vec::new(),
    };
    CutterPath { datum, program_zero_z: zero, operations: vec![operation] }
}

fn along(contour: &Contour, cut: Cut) -> impl Iterator<Item = CutMove> + '_ {
    contour.segments.iter().map(move |segment| match *segment {
        Segment::Line { end, .. } => CutMove::Line { to: end, cut },
        Segment::Arc { end, center, ccw, .. } => CutMove::Arc { to: end, center, ccw, cut },
    })
}

/// Constant surface speed where the control has it. Else one speed all along: the one that gives the surface speed at the
/// base, where the contour is widest, so that the metal is nowhere worked faster than was asked for; never more than the
/// highest speed.
pub(crate) fn cut(shell_mm: &Shell, shape: &ShellShape, machine: &Machine) -> Cut {
    let speeds = &shell_mm.speeds;
    let max_rpm = speeds.max_rpm.min(machine.rpm_limit());
    let has_surface_speed = machine.words.as_ref().is_some_and(|w| w.surface_speed);
    let surface = Speed::Surface { m_per_min: speeds.surface_m_per_min, max_rpm };
    let cut = Cut { feed: Feed::PerRev(speeds.feed_per_rev), speed: surface };
    if has_surface_speed { cut } else { Cut { speed: Speed::Rpm(cut.rpm_at(shape.base().r)), ..cut } }
}

/// What the program of a design in mm says about itself.
#[must_use]
pub fn header(name: &str, shell_mm: &Shell, shape: &ShellShape) -> Header {
    let roller = &shell_mm.roller;
    let tool = format!("ROLLER D{:.1} NOSE R{:.2}, PROGRAMMED AT NOSE CENTRE", roller.diameter, roller.nose_radius);
    Header {
        part: name.to_owned(),
        material: shell_mm.material.clone(),
        stock: format!("DISC D{:.2} X {:.2} MM", 2.0 * shape.blank_radius, shape.thickness),
        holding: format!("FORMER AND FOLLOWER D{:.1}", shell_mm.blank.follower_diameter),
        tools: BTreeMap::from([(roller.station, tool)]),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::machine::Catalog;
    use crate::spinning::shape;

    /// The speed of a shell on a machine, and the radius of its base.
    fn speed(machine: &str, shell: &Shell) -> (Speed, f64) {
        let shape = shape(shell).unwrap();
        let cut = cut(shell, &shape, Catalog::shipped().machine(machine).unwrap());
        (cut.speed, shape.base().r)
    }

    #[test]
    fn a_control_with_surface_speed_is_given_it_with_its_clamp() {
        let (speed, _) = speed("linuxcnc", &Shell::default());
        assert!(matches!(speed, Speed::Surface { m_per_min: 350.0, max_rpm: 1500.0 }), "{speed:?}");
    }

    #[test]
    fn without_it_the_surface_speed_is_reached_at_the_base_and_nowhere_exceeded() {
        let mut shell = Shell::default();
        let (Speed::Rpm(rpm), base) = speed("swedish-1970s", &shell) else { panic!("a fixed speed") };
        let m_per_min = rpm * std::f64::consts::TAU * base / 1000.0;
        assert!((m_per_min - 350.0).abs() < 1e-9 && rpm < 1500.0, "{rpm} {m_per_min}");
        shell.speeds.max_rpm = 500.0;
        assert!(matches!(speed("swedish-1970s", &shell).0, Speed::Rpm(500.0)));
    }
}
