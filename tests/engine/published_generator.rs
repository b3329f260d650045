//! What the published generator promises for every part: it never cuts into the part, every operation begins and ends at
//! the datum, and the finishing passes end on the contour.

use crate::support::{Part, master, orac, queen, stepped};
use proptest::prelude::*;
use turnwright::diagnostic::has_errors;
use turnwright::geometry::Point;
use turnwright::machine::{Catalog, Material, OracData};
use turnwright::post::Options;
use turnwright::post::orac::{Instruction, files, optimize, post};
use turnwright::turning::published::generate;
use turnwright::turning::{CutMove, CutterPath, OperationKind};
use turnwright::units::Unit;

fn material() -> Material {
    Catalog::shipped().material("aluminum", Unit::Mm).unwrap().in_mm()
}

fn path((setup, part): &Part) -> CutterPath {
    generate(setup, part, &orac(), &material()).0
}

/// Feed through air of the ORAC, mm/min.
const RAPID_MM_PER_MIN: f64 = 1000.0;

/// Ends of all moves in order, loops run.
fn places(moves: &[CutMove], shift: f64, out: &mut Vec<Point>) {
    for m in moves {
        match m {
            CutMove::Line { to, .. } | CutMove::Arc { to, .. } | CutMove::Rapid { to } => {
                out.push(Point::new(to.z, to.r + shift));
            }
            CutMove::Thread { .. } | CutMove::ThreadPass { .. } | CutMove::Dwell { .. } => {}
            CutMove::Repeat { count, step, body } => {
                (0..*count).for_each(|k| places(body, shift + step.y * f64::from(k), out));
            }
        }
    }
}

fn operation_places(path: &CutterPath, kind: OperationKind) -> Vec<Point> {
    let mut out = vec![path.datum];
    let moves = path.operations.iter().filter(|o| o.kind == kind).flat_map(|o| o.moves.clone());
    places(&moves.collect::<Vec<_>>(), 0.0, &mut out);
    out
}

#[test]
fn every_operation_ends_at_the_datum_and_never_beyond_the_axis() {
    for part in [queen(), master()] {
        let path = path(&part);
        for operation in &path.operations {
            let places = operation_places(&path, operation.kind);
            assert!(places.last().unwrap().distance(path.datum) < 1e-9, "{:?}", operation.kind);
            assert!(places.iter().all(|p| p.r > -1e-9), "{:?}", operation.kind);
        }
    }
}

#[test]
fn every_example_becomes_programs_that_the_lathe_can_hold() {
    for (name, clampings) in crate::support::all_examples() {
        for part in clampings {
            let machine = orac();
            let (path, diagnostics) = generate(&part.0, &part.1, &machine, &material());
            assert!(!has_errors(&diagnostics), "{name}: {diagnostics:?}");
            let output =
                post(name, &path, &Options { optimize: true, automatic: true, ..Options::default() }, &machine);
            assert_eq!(output.diagnostics, [], "{name}");
            assert!(output.programs.iter().all(|p| p.blocks.len() <= machine.limits.blocks_per_program));
            assert!(!output.programs.is_empty(), "{name}");
        }
    }
}

#[test]
fn the_moves_of_every_file_add_up_to_zero() {
    for part in [queen(), master()] {
        for file in files(&path(&part), RAPID_MM_PER_MIN) {
            for list in [file.instructions.clone(), optimize(&file.instructions)] {
                assert_eq!(sum(&list), (0, 0), "file {}", file.number);
            }
        }
    }
}

/// Way that the moves lead, loops run.
fn sum(list: &[Instruction]) -> (i32, i32) {
    let mut times = 1;
    list.iter().fold((0, 0), |at, i| match *i {
        Instruction::Do { count } => {
            times = count;
            at
        }
        Instruction::Edo => {
            times = 1;
            at
        }
        Instruction::Ptp { x, z, .. } | Instruction::Circ { x, z, .. } => (at.0 + times * x, at.1 + times * z),
        _ => at,
    })
}

#[test]
fn two_finishing_passes_follow_the_contour_the_last_one_on_it() {
    let path = path(&queen());
    let places = operation_places(&path, OperationKind::FinishRight);
    // The ends of the queen's sections that the right-hand tool reaches, from the free end.
    let corners = [
        (56.0, 0.5),
        (53.5, 2.0),
        (53.5, 6.45),
        (50.4, 8.1),
        (42.7, 5.1),
        (41.8, 5.75),
        (41.0, 5.1),
        (38.6, 5.1),
        (36.0, 8.75),
    ];
    for (z, r) in corners {
        for above in [0.08, 0.0] {
            let wanted = Point::new(z, r + above);
            assert!(places.iter().any(|p| p.distance(wanted) < 1e-9), "no pass through {wanted:?}");
        }
    }
    assert!(!places.iter().any(|p| (p.z - 34.0).abs() < 1e-9), "section 5 is left to the other tool");
    let left = operation_places(&path, OperationKind::FinishLeft);
    for (z, r) in [(34.0, 3.75), (36.0, 6.75), (36.0, 8.75)] {
        assert!(left.iter().any(|p| p.distance(Point::new(z, r)) < 1e-9), "no pass through {z} {r}");
    }
}

#[test]
fn a_part_off_runs_to_the_axis_at_its_own_feed() {
    let path = path(&master());
    let places = operation_places(&path, OperationKind::PartOff);
    assert!(places.iter().any(|p| p.distance(Point::new(-3.0, 0.0)) < 1e-9));
}

#[test]
fn figures_of_the_material_that_cannot_be_are_refused() {
    let (setup, part) = queen();
    for depth_rough in [0.0, -0.8, f64::NAN, f64::INFINITY] {
        let figures = OracData { depth_rough, ..material().orac.unwrap() };
        let (path, diagnostics) = generate(&setup, &part, &orac(), &Material { orac: Some(figures), ..material() });
        assert!(path.operations.is_empty());
        assert_eq!(diagnostics[0].code, "material-figure");
    }
}

/// Half of the control's smallest step, mm: nothing finer can be programmed.
const HALF_STEP_MM: f64 = 0.0005;

/// Radius of a stepped part at `z`, the greater one at a corner.
fn radius_at(corners: &[Point], z: f64) -> f64 {
    let on = corners.windows(2).filter(|w| z >= w[0].z - 1e-9 && z <= w[1].z + 1e-9);
    on.map(|w| {
        let width = w[1].z - w[0].z;
        let t = if width > 0.0 { ((z - w[0].z) / width).clamp(0.0, 1.0) } else { 1.0 };
        if width > 0.0 { w[0].r + (w[1].r - w[0].r) * t } else { w[0].r.max(w[1].r) }
    })
    .fold(0.0, f64::max)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn no_move_enters_the_part(radii in proptest::collection::vec((0.5..13.0_f64, 0.5..13.0_f64, 0.3..8.0_f64), 2..8)) {
        let part = stepped(&radii);
        let corners = crate::support::corners(&part.0);
        let path = path(&part);
        for operation in &path.operations {
            let places = operation_places(&path, operation.kind);
            for w in places.windows(2) {
                for k in 0..=8 {
                    let p = w[0] + (w[1] - w[0]) * (f64::from(k) / 8.0);
                    if p.z > part.0.length - 1e-9 {
                        continue; // in front of the end face
                    }
                    let z = p.z.max(1e-9);
                    // Along a face the lower side counts, and strokes that are equal in steps of the control share a loop.
                    let beside = [-HALF_STEP_MM, -1e-7, 0.0, 1e-7, HALF_STEP_MM].map(|d| radius_at(&corners, z + d));
                    let lowest = beside.into_iter().fold(f64::INFINITY, f64::min);
                    prop_assert!(p.r >= lowest - HALF_STEP_MM, "{:?} at {:?}, part {}", operation.kind, p, lowest);
                }
            }
        }
    }

    #[test]
    fn every_file_ends_at_the_datum_shortened_or_not(radii in proptest::collection::vec((0.5..13.0_f64, 0.5..13.0_f64, 0.3..8.0_f64), 2..8)) {
        for file in files(&path(&stepped(&radii)), RAPID_MM_PER_MIN) {
            prop_assert_eq!(sum(&file.instructions), (0, 0));
            prop_assert_eq!(sum(&optimize(&file.instructions)), (0, 0));
        }
    }
}
