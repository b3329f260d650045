//! The shipped shells from document to proved program and tables.

use std::sync::Arc;
use turnwright::cancel::Cancel;
use turnwright::diagnostic::has_errors;
use turnwright::document::{Content, Document, FormerShape, Forming, Kind};
use turnwright::geometry::{Contour, Location};
use turnwright::machine::Catalog;
use turnwright::output;
use turnwright::part::{Section, SectionKind};
use turnwright::regen::{self, Cache, Derived};
use turnwright::storage::{document_from_text, examples_of};

fn example(name: &str) -> Document {
    let example = examples_of(Kind::Shell).find(|e| e.name == name).unwrap();
    document_from_text(name, example.text).unwrap()
}

fn derived(document: Document) -> Derived {
    regen::regenerate(&Arc::new(document), &Catalog::shipped(), &mut Cache::default(), &Cancel::default()).unwrap()
}

#[test]
fn every_example_is_proved_without_a_word() {
    assert_eq!(examples_of(Kind::Shell).count(), 3);
    for example in examples_of(Kind::Shell) {
        let made = derived(document_from_text(example.name, example.text).unwrap());
        assert_eq!(made.diagnostics, [], "{}", example.name);
        let shell = made.shell.as_ref().unwrap();
        assert!(shell.proof.passed && !shell.programs.is_empty(), "{}", example.name);
        assert!(!output::has_errors(&made));
        println!(
            "{}: gap {:+.4} to {:+.4} mm of the wall, clearance {:.2} mm, {:.1} s, {} blocks",
            example.name,
            shell.proof.tightest_mm,
            shell.proof.widest_mm,
            shell.proof.clearance_mm,
            shell.proof.times.total_s,
            shell.post.programs[0].blocks.len()
        );
    }
}

#[test]
fn a_build_holds_program_tables_and_report() {
    let files = output::files(&derived(example("CONE")));
    let names: Vec<&str> = files.iter().map(|f| f.name.as_str()).collect();
    assert_eq!(names, ["CONE.ngc", "CONE.csv", "CONE.h", "CONE.shell.json", "CONE.proof.json", "report.json"]);
    let report: serde_json::Value = serde_json::from_str(&files[5].text).unwrap();
    assert_eq!((&report["good"], &report["items"][0]["proved"]), (&true.into(), &true.into()));
    // 50 mm of contour in steps of eight pulses, start and end included.
    assert_eq!(files[1].text.lines().count(), 1 + 787 / 8 + 2);
}

#[test]
fn arcs_of_the_contour_are_arcs_in_the_program() {
    let made = derived(example("DISH"));
    let text = &made.shell.as_ref().unwrap().programs[0].text;
    assert!(text.lines().filter(|l| l.contains("G2") || l.contains("G3")).count() >= 2, "{text}");
    assert!(text.contains("G96"), "{text}");
}

#[test]
fn a_shell_that_cannot_be_formed_gets_its_rule_and_no_program() {
    let mut document = example("CONE");
    let Content::Shell(shell) = &mut document.content else { unreachable!("a shell") };
    let FormerShape::Cone { half_angle_deg, .. } = &mut shell.former.shape else { unreachable!("a cone") };
    *half_angle_deg = 7.0;
    let made = derived(document);
    let codes: Vec<&str> = made.diagnostics.iter().map(|d| d.code.as_str()).collect();
    assert_eq!(codes, ["half-angle-small", "passes-few", "reduction", "surface-speed"]);
    assert!(output::has_errors(&made));
    let shell = made.shell.unwrap();
    assert!(shell.programs.is_empty() && !shell.shape.stations.is_empty());
}

#[test]
fn an_edit_of_the_rig_leaves_program_and_proof_alone() {
    let catalog = Catalog::shipped();
    let mut cache = Cache::default();
    let mut document = example("CONE");
    let first = regen::regenerate(&Arc::new(document.clone()), &catalog, &mut cache, &Cancel::default())
        .unwrap()
        .shell
        .unwrap();
    let Content::Shell(shell) = &mut document.content else { unreachable!("a shell") };
    shell.rig.rpm = 135.0;
    let second =
        regen::regenerate(&Arc::new(document), &catalog, &mut cache, &Cancel::default()).unwrap().shell.unwrap();
    assert!(Arc::ptr_eq(&first.post, &second.post) && Arc::ptr_eq(&first.shape, &second.shape));
    assert!(Arc::ptr_eq(&first.proof, &second.proof));
}

/// Free contours: a corner, a bulge and a hollow.
fn free_contours() -> Vec<Vec<Section>> {
    let row = |id, z1, d1, z2, d2, kind| Section { id, z1, d1, z2, d2, kind };
    vec![
        vec![Section::line(1, 0.0, 120.0, 25.0, 90.0), Section::line(2, 25.0, 90.0, 40.0, 50.0)],
        vec![row(1, 0.0, 120.0, 30.0, 60.0, SectionKind::Convex { radius: 60.0 })],
        vec![row(1, 0.0, 120.0, 40.0, 60.0, SectionKind::Concave { radius: 90.0 })],
    ]
}

#[test]
fn the_gap_is_the_wall_along_every_contour() {
    let cones = (19..=79).step_by(5).map(|deg| FormerShape::Cone {
        half_angle_deg: f64::from(deg),
        tip_diameter: 50.0,
        length: 30.0 / f64::from(deg).to_radians().tan().max(0.7),
    });
    let ellipses = [(50.0, 100.0), (35.0, 120.0), (60.0, 110.0)].map(|(semi_axis, diameter)| FormerShape::Ellipse {
        semi_axis,
        diameter,
        tip_diameter: 40.0,
        length: 0.5 * semi_axis,
    });
    let free = free_contours().into_iter().map(|sections| FormerShape::Sections { sections });
    for shape in cones.chain(ellipses).chain(free) {
        for (forming, passes) in [(Forming::Shear, 1), (Forming::Spinning, 2)] {
            let mut document = example("CONE");
            let Content::Shell(shell) = &mut document.content else { unreachable!("a shell") };
            (shell.former.shape, shell.forming, shell.passes) = (shape.clone(), forming, passes);
            (shell.blank.follower_diameter, shell.roller.swivel_deg, shell.roller.nose_radius) = (10.0, 15.0, 6.0);
            let made = derived(document);
            assert!(!has_errors(&made.diagnostics), "{shape:?} {forming:?}: {:?}", made.diagnostics);
            let proof = &made.shell.as_ref().unwrap().proof;
            assert!(proof.tightest_mm > -0.003 && proof.widest_mm < 0.003, "{shape:?} {forming:?}: {proof:?}");
        }
    }
}

/// A former of two rows whose hollow corner, 30 mm from the tip, is sharp.
fn hollow(base: f64, corner: f64) -> FormerShape {
    let sections = vec![Section::line(1, 0.0, base, 10.0, corner), Section::line(2, 10.0, corner, 40.0, 60.0)];
    FormerShape::Sections { sections }
}

#[test]
fn a_sharp_hollow_corner_is_told_shown_and_programmed_and_the_proof_agrees() {
    for (base, corner) in [(120.0, 90.0), (140.0, 86.0), (110.0, 95.0)] {
        for (forming, nose) in [(Forming::Shear, 6.0), (Forming::Shear, 9.0), (Forming::Spinning, 9.0)] {
            let mut document = example("CONE");
            let Content::Shell(shell) = &mut document.content else { unreachable!("a shell") };
            (shell.former.shape, shell.forming, shell.roller.nose_radius) = (hollow(base, corner), forming, nose);
            (shell.blank.follower_diameter, shell.roller.swivel_deg) = (30.0, 0.0);
            let made = derived(document);
            let codes: Vec<&str> = made.diagnostics.iter().map(|d| d.code.as_str()).collect();
            let shell = made.shell.as_ref().unwrap();
            // A corner that turns by 7° only leaves the shell within the tolerance.
            let is_told = codes.contains(&"hollow-not-formed");
            assert_eq!(is_told, shell.shape.hollows[0].stands_off > 0.02, "{codes:?}");
            assert!(!codes.contains(&"roller-too-large"), "{codes:?}");
            let rules = made.diagnostics.iter().filter(|d| d.code != "shell-proof");
            if rules.clone().any(|d| d.severity == turnwright::diagnostic::Severity::Error) {
                continue;
            }
            let (proof, told) = (&shell.proof, &shell.shape.hollows[0]);
            assert!(proof.passed, "{base} {corner} {forming:?} {nose}: {:?}", proof.findings);
            assert!(proof.tightest_mm > -0.003 && proof.widest_mm < 0.02, "{proof:?}");
            // Rule and proof measure the same place, each in its own way.
            assert!((proof.spanned_mm - told.stands_off).abs() < 0.003, "{} {}", proof.spanned_mm, told.stands_off);
            assert!((told.at.z - shell.shape.base().z - 10.0).abs() < 1e-9);
            println!("{base} {corner} {forming:?} nose {nose}: stands off {:.3} mm", told.stands_off);
            // Nowhere is the shell inside the former.
            let former = Contour::polygon(&shell.shape.former_outline(1e-4));
            for station in &shell.shape.stations {
                assert_ne!(former.locate(station.at, 0.002), Location::Inside, "{:?}", station.at);
            }
            let thinnest = shell.shape.stations.iter().map(|s| s.wall).fold(f64::INFINITY, f64::min);
            assert!(thinnest > 0.0);
        }
    }
}

#[test]
fn a_program_that_spans_a_hollow_further_than_it_must_is_not_excused() {
    // The path of a larger nose, proved as one of the smaller: what the smaller could have formed is missing.
    use turnwright::spinning::proof::{ShellProofInput, prove};
    let with_nose = |nose: f64| {
        let mut document = example("CONE");
        let Content::Shell(shell) = &mut document.content else { unreachable!("a shell") };
        (shell.former.shape, shell.forming, shell.roller.nose_radius) = (hollow(120.0, 90.0), Forming::Spinning, nose);
        (shell.blank.follower_diameter, shell.roller.swivel_deg) = (30.0, 0.0);
        derived(document).shell.unwrap()
    };
    let catalog = Catalog::shipped();
    let machine = Arc::new(catalog.machine("linuxcnc").unwrap().clone());
    let (wide, narrow) = (with_nose(9.0), with_nose(6.0));
    let input = |programs, shell: &turnwright::regen::ShellDerived| ShellProofInput {
        tools: Arc::new(turnwright::machine::outlines(&machine, &catalog)),
        machine: Arc::clone(&machine),
        programs,
        program_zero_z: shell.shape.tip().z,
        shell: (*shell.shell).clone(),
        shape: Arc::clone(&shell.shape),
    };
    let own = prove(&input(Arc::clone(&narrow.programs), &narrow), &Cancel::default()).unwrap();
    assert!(own.passed, "{:?}", own.findings);
    let other = prove(&input(Arc::clone(&wide.programs), &narrow), &Cancel::default()).unwrap();
    assert!(!other.passed && other.widest_mm > 0.1, "{other:?}");
}

#[test]
fn a_program_edited_by_hand_is_proved_again_and_a_stray_one_is_told() {
    let mut document = example("CONE");
    let text = derived(document.clone()).shell.unwrap().programs[0].text.clone();
    // 0.1 mm nearer to the axis where the contour begins.
    let line = text.lines().filter(|l| l.contains('X')).nth(2).unwrap();
    let word = line.split_whitespace().find(|w| w.starts_with('X')).unwrap();
    let nearer = format!("X{:.3}", word[1..].parse::<f64>().unwrap() - 0.2);
    let edited = text.replacen(line, &line.replace(word, &nearer), 1);
    let put = |document: &mut Document, name: &str, text: &str| {
        let Content::Shell(shell) = &mut document.content else { unreachable!("a shell") };
        shell.overrides = [(name.to_owned(), text.to_owned())].into();
    };
    put(&mut document, "CONE", &edited);
    let made = derived(document.clone());
    let shell = made.shell.as_ref().unwrap();
    assert!(shell.programs[0].edited && shell.programs[0].text == edited);
    assert!(!shell.proof.passed && output::has_errors(&made), "{nearer} for {word}: {:?}", shell.proof.findings);
    let files = output::files(&made);
    assert_eq!(files[0].text, edited);
    // A remark changes nothing that is proved.
    put(&mut document, "CONE", &text.replacen('(', "(BY HAND ", 1));
    assert!(derived(document.clone()).shell.unwrap().proof.passed);
    put(&mut document, "OLD", &text);
    let codes: Vec<String> = derived(document).diagnostics.into_iter().map(|d| d.code).collect();
    assert_eq!(codes, ["override-without-program"]);
}
