use super::*;
use crate::document::FormerShape;
use crate::geometry::{Contour, Point};
use crate::machine::{self, Catalog};
use crate::post;
use crate::spinning::{path, program, roller, shape};

fn input(shell: &Shell) -> ShellProofInput {
    let catalog = Catalog::shipped();
    let machine = catalog.machine(&shell.machine).unwrap();
    let shape = shape(shell).unwrap();
    let path = path::path(shell, &shape);
    let cutter = program::cutter_path(shell, &shape, &path, machine);
    let header = program::header("TEST", shell, &shape);
    let made = post::post("TEST", &cutter, &post::Options::default(), &header, machine);
    assert_eq!(made.diagnostics, []);
    let text = |p: &post::Program| ProgramText { name: p.name.clone(), text: p.text.clone(), edited: false };
    ShellProofInput {
        tools: Arc::new(machine::outlines(machine, &catalog)),
        machine: Arc::new(machine.clone()),
        programs: Arc::new(made.programs.iter().map(text).collect()),
        program_zero_z: cutter.program_zero_z,
        shell: shell.clone(),
        shape: Arc::new(shape),
    }
}

fn proved(input: &ShellProofInput) -> ShellProof {
    prove(input, &Cancel::default()).unwrap()
}

/// Kinds of the errors.
fn errors(proof: &ShellProof) -> Vec<FindingKind> {
    let mut kinds: Vec<FindingKind> =
        proof.findings.iter().filter(|f| f.severity == Severity::Error).map(|f| f.kind).collect();
    kinds.dedup();
    kinds
}

#[test]
fn the_cone_is_proved_in_both_dialects() {
    for machine in ["linuxcnc", "fanuc-0i"] {
        let shell = Shell { machine: machine.to_owned(), ..Shell::default() };
        let proof = proved(&input(&shell));
        println!("{machine}: {} {} {}", proof.tightest_mm, proof.widest_mm, proof.clearance_mm);
        assert!(proof.passed, "{machine}: {:?}", proof.findings);
        assert!(proof.tightest_mm.abs() < 0.002 && proof.widest_mm < 0.002);
        assert!(proof.clearance_mm > 0.0);
    }
}

#[test]
fn curved_shells_and_several_passes_are_proved() {
    let mut dish = Shell { passes: 2, ..Shell::default() };
    dish.former.shape = FormerShape::Dish { focal_length: 60.0, tip_diameter: 40.0, rim_diameter: 160.0 };
    dish.blank.follower_diameter = 24.0;
    dish.roller.swivel_deg = 10.0;
    let mut bell = Shell { forming: crate::document::Forming::Spinning, passes: 3, ..Shell::default() };
    bell.roller.swivel_deg = 0.0;
    bell.blank.follower_diameter = 30.0;
    bell.former.shape = FormerShape::Parabola { constant: 273.8, tip_diameter: 40.0, length: 70.0 };
    for shell in [dish, bell] {
        let proof = proved(&input(&shell));
        println!("{:?}: {} {} {}", shell.former.shape, proof.tightest_mm, proof.widest_mm, proof.clearance_mm);
        assert!(proof.passed, "{:?}: {:?}", shell.former.shape, proof.findings);
        assert!(proof.tightest_mm > -0.005 && proof.widest_mm < 0.005);
    }
}

/// Distance of two outlines that do not cross: that of a corner of either.
fn apart(a: &[Point], b: &[Point]) -> f64 {
    let from = |corners: &[Point], to: &[Point]| {
        let ring = Contour::polygon(to);
        corners.iter().map(|p| ring.distance_to(*p)).fold(f64::INFINITY, f64::min)
    };
    from(a, b).min(from(b, a))
}

#[test]
fn the_clearance_is_the_smallest_distance_of_all_places() {
    let mut dish = Shell::default();
    dish.former.shape = FormerShape::Dish { focal_length: 60.0, tip_diameter: 40.0, rim_diameter: 160.0 };
    (dish.blank.follower_diameter, dish.roller.swivel_deg) = (24.0, 10.0);
    for shell in [Shell::default(), dish] {
        let input = input(&shell);
        let proof = proved(&input);
        let (body, nose) = (roller::body(&shell.roller), shell.roller.nose_radius);
        let mut least = f64::INFINITY;
        for m in &proof.moves {
            for share in shares(&m.path, 1.0) {
                let centre = m.path.point_at(share);
                let placed: Vec<Point> = body.iter().map(|p| *p + (centre - Point::default())).collect();
                for thing in obstacles::obstacles(&input) {
                    let of_nose = Contour::polygon(&thing.outline).distance_to(centre) - nose;
                    let of_nose = if thing.formed_on { f64::INFINITY } else { of_nose };
                    least = least.min(apart(&placed, &thing.outline)).min(of_nose);
                }
            }
        }
        assert!((proof.clearance_mm - least).abs() < 1e-9, "{} {least}", proof.clearance_mm);
    }
}

/// The program with one word of its text changed.
fn with_text(input: &ShellProofInput, change: impl Fn(&str) -> String) -> ShellProofInput {
    let programs =
        input.programs.iter().map(|p| ProgramText { text: change(&p.text), ..p.clone() }).collect::<Vec<_>>();
    assert_ne!(programs, **input.programs);
    ShellProofInput { programs: Arc::new(programs), ..input.clone() }
}

#[test]
fn a_tighter_gap_is_found_with_value_and_block() {
    let good = input(&Shell::default());
    // The same program over a former whose contour is 0.1 mm wider.
    let mut wide = Shell::default();
    wide.former.shape = FormerShape::Cone { half_angle_deg: 30.0, tip_diameter: 40.2, length: 50.0 };
    let wrong = ShellProofInput { shape: Arc::new(shape(&wide).unwrap()), ..good };
    let proof = proved(&wrong);
    assert_eq!(errors(&proof)[0], FindingKind::Gouge);
    let first = &proof.findings[0];
    let least = 0.1 * 30.0_f64.to_radians().cos();
    assert!(first.value > least - 0.001 && first.value < 0.1, "{first:?}");
    assert!(first.message.contains("0.71") && first.message.contains("0.020 mm"), "{}", first.message);
}

#[test]
fn a_shell_not_formed_is_found() {
    let good = input(&Shell::default());
    // Another end of the contour: the last part is not formed.
    let lines: Vec<&str> = good.programs[0].text.lines().collect();
    let last = lines.iter().rposition(|l| l.contains('Z') && l.contains('X') && l.contains("Z-")).unwrap();
    let shorter = with_text(&good, |text| {
        let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
        lines.remove(last);
        lines.join("\n") + "\n"
    });
    assert!(errors(&proved(&shorter)).contains(&FindingKind::Leftover));
}

#[test]
fn contacts_with_follower_chuck_and_former_are_found() {
    let mut shell = Shell::default();
    shell.blank.follower_diameter = 60.0;
    assert!(errors(&proved(&input(&shell))).contains(&FindingKind::TailstockCollision));
    let mut short = Shell::default();
    short.former.base_length = 2.0;
    assert!(errors(&proved(&input(&short))).contains(&FindingKind::ChuckCollision));
    let mut leaning = Shell::default();
    leaning.roller.swivel_deg = -60.0;
    assert!(errors(&proved(&input(&leaning))).contains(&FindingKind::Gouge));
}
