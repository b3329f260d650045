//! The files of a shell: programs, set-point tables, former and wall, proof.

use super::{OutputFile, pretty};
use crate::geometry::Contour;
use crate::regen::ShellDerived;
use crate::spinning::table;
use serde_json::{Value, json};

/// Every file of a shell.
pub(super) fn files(made: &ShellDerived) -> Vec<OutputFile> {
    let named = |ending: &str, text: String| OutputFile { name: format!("{}.{ending}", made.name), text };
    let programs = made.programs.iter().zip(&made.post.programs).map(|(text, program)| OutputFile {
        name: format!("{}.{}", program.name, program.extension),
        text: text.text.clone(),
    });
    let mut files: Vec<OutputFile> = programs.collect();
    files.extend([
        named("csv", table::csv(&made.set_points)),
        named("h", table::c_header(&made.name, &made.set_points)),
        named("shell.json", pretty(&shell(made))),
        named("proof.json", pretty(&proof(made))),
    ]);
    files
}

/// The shell in the report.
pub(super) fn item(made: &ShellDerived) -> Value {
    let programs = made.programs.iter().zip(&made.post.programs).map(|(text, program)| {
        json!({
            "name": program.name,
            "file": format!("{}.{}", program.name, program.extension),
            "blocks": program.blocks.len(),
            "edited_by_hand": text.edited,
        })
    });
    json!({
        "name": made.name,
        "shell": format!("{}.shell.json", made.name),
        "proof": format!("{}.proof.json", made.name),
        "tables": [format!("{}.csv", made.name), format!("{}.h", made.name)],
        "set_points": made.set_points.len(),
        "programs": programs.collect::<Vec<_>>(),
        "proved": made.proof.passed,
        "times": made.proof.times,
        "findings": made.proof.findings.len(),
    })
}

/// Former, shell and roller path. Lengths in mm.
fn shell(made: &ShellDerived) -> Value {
    let shape = &made.shape;
    json!({
        "unit": "mm",
        "former": contour(&shape.former),
        "inside": contour(&shape.inside),
        "outside": contour(&shape.outside),
        "passes": made.path.passes.iter().map(|p| json!({
            "approach": p.approach,
            "contour": contour(&p.contour),
            "retreat": p.retreat,
        })).collect::<Vec<_>>(),
        "wall": shape.stations.iter().map(|s| json!({
            "along_mm": s.along,
            "z_mm": s.at.z,
            "r_mm": s.at.r,
            "half_angle_deg": s.half_angle.to_degrees(),
            "wall_mm": s.wall,
            "reduction": s.reduction,
        })).collect::<Vec<_>>(),
        "blank_diameter_mm": 2.0 * shape.blank_radius,
        "blank_diameter_by_volume_mm": 2.0 * shape.volume_radius,
        "blank_thickness_mm": shape.thickness,
        "volume_mm3": shape.volume,
    })
}

fn contour(contour: &Contour) -> Value {
    json!(contour.segments)
}

fn proof(made: &ShellDerived) -> Value {
    let proof = &made.proof;
    json!({
        "passed": proof.passed,
        "times": proof.times,
        "gap_less_wall_mm": { "smallest": proof.tightest_mm, "largest": proof.widest_mm },
        "gap_tolerance_mm": made.shell.gap_tolerance,
        "clearance_mm": proof.clearance_mm,
        "findings": proof.findings,
    })
}
