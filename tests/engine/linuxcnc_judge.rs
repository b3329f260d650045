//! LinuxCNC's own interpreter judges the programs: it must accept them, and its moves must be those of the paths.
//!
//! Runs where `rs274` is installed (package linuxcnc-uspace) and says so where it is not. Programs of other controls are
//! put into LinuxCNC's words first.

use crate::words_scan::listing::path_of_listing;
use crate::words_scan::paths::{
    Wanted, all_sorts, compare, finish_with_recipe, thread_running_out, thread_with_recipe, wanted,
};
use crate::words_scan::read::{Step, read};
use std::fmt::Write as _;
use std::process::Command;
use std::sync::Arc;
use turnwright::cancel::Cancel;
use turnwright::document::{Content, Document, Generator, Kind};
use turnwright::geometry::{Point, Vector};
use turnwright::machine::{Catalog, Machine};
use turnwright::part::{Section, SectionKind};
use turnwright::post::{Header, Options, post};
use turnwright::regen::{Cache, regenerate};
use turnwright::spinning;
use turnwright::storage::{document_from_text, examples_of};
use turnwright::turning::CutterPath;
use turnwright::units::Unit;

/// What LinuxCNC's moves may differ from ours, mm.
const TOLERANCE: f64 = 0.001;

/// The same where the program has three decimals only: half a count on either axis and as much for a centre.
const TOLERANCE_3_DECIMALS: f64 = 0.002;

/// The two radii of an arc of the published listing differ by up to 0.016 mm, so that no circle has both ends.
const TOLERANCE_LISTING: f64 = 0.017;

fn catalog() -> Catalog {
    Catalog::shipped()
}

fn machine(id: &str) -> Machine {
    catalog().machine(id).unwrap().clone()
}

fn is_installed() -> bool {
    let there = Command::new("rs274").arg("-h").output().is_ok();
    if !there {
        println!(
            "rs274 is not installed (apt-get install --no-install-recommends linuxcnc-uspace): nothing was judged."
        );
    }
    there
}

/// LinuxCNC's canonical moves of `text`, in program space.
fn judge(text: &str) -> Result<Vec<Step>, String> {
    let dir = tempfile::tempdir().unwrap();
    let file = |name: &str, content: &str| {
        let path = dir.path().join(name);
        std::fs::write(&path, content).unwrap();
        path
    };
    let ini = "[EMC]\nMACHINE=judge\n[RS274NGC]\nPARAMETER_FILE=judge.var\n[EMCIO]\nTOOL_TABLE=judge.tbl\n[TRAJ]\nAXES=3\n\
               COORDINATES=X Z\nLINEAR_UNITS=mm\nANGULAR_UNITS=degree\n[DISPLAY]\nLATHE=1\n";
    let tools: Vec<String> = (1..=12).map(|t| format!("T{t} P{t} X0 Z0 D0\n")).collect();
    let (ini, tools) = (file("judge.ini", ini), file("judge.tbl", &tools.concat()));
    let (vars, program, out) = (file("judge.var", ""), file("program.ngc", text), dir.path().join("out"));
    let run = Command::new("rs274")
        .arg("-g")
        .args([std::ffi::OsStr::new("-i"), ini.as_os_str(), "-t".as_ref(), tools.as_os_str()])
        .args(["-v".as_ref(), vars.as_os_str(), "-n".as_ref(), "2".as_ref(), program.as_os_str(), out.as_os_str()])
        // It keeps its tool table in a file of the home folder, which programs judged side by side would share.
        .env("HOME", dir.path())
        .current_dir(dir.path())
        .output()
        .unwrap();
    let canon = std::fs::read_to_string(&out).unwrap_or_default();
    let said = String::from_utf8_lossy(&run.stderr).into_owned();
    if !run.status.success() || !canon.contains("PROGRAM_END") {
        return Err(format!("LinuxCNC refuses the program: {said}"));
    }
    Ok(canonical(&canon))
}

/// Canonical commands as moves; X is a radius there.
fn canonical(text: &str) -> Vec<Step> {
    let mut steps = Vec::new();
    let mut lead = None;
    for line in text.lines() {
        let Some((name, rest)) = line.split_once('(') else { continue };
        let name = name.split_whitespace().last().unwrap_or_default();
        let numbers: Vec<f64> =
            rest.trim_end_matches(')').split([',', ' ']).filter_map(|n| n.trim().parse().ok()).collect();
        match (name, numbers.as_slice()) {
            ("STRAIGHT_TRAVERSE", [x, _, z, ..]) => {
                steps.push(Step::Rapid { to: Point::new(*z, *x) });
            }
            ("STRAIGHT_FEED", [x, _, z, ..]) => {
                let to = Point::new(*z, *x);
                steps.push(lead.map_or(Step::Line { to, feed: 0.0 }, |lead| Step::Thread { to, lead }));
            }
            ("ARC_FEED", [z, x, center_z, center_x, turns, ..]) => {
                let (to, center) = (Point::new(*z, *x), Point::new(*center_z, *center_x));
                steps.push(Step::Arc { to, center, ccw: *turns > 0.0, feed: 0.0 });
            }
            ("START_SPEED_FEED_SYNC", [l, ..]) => lead = Some(*l),
            ("STOP_SPEED_FEED_SYNCH", _) => lead = None,
            ("DWELL", [seconds]) => steps.push(Step::Dwell { seconds: *seconds }),
            _ => {}
        }
    }
    steps
}

/// The moves of the path with those to the machine's zero at the start and after every operation.
fn wanted_with_retracts(path: &CutterPath) -> Vec<Wanted> {
    let mut all = Vec::new();
    for operation in path.operations.iter().filter(|o| !o.moves.is_empty()) {
        all.extend(wanted(path, operation, true));
        let at = operation.change.unwrap_or(path.datum) + Vector::new(-path.program_zero_z, 0.0);
        all.extend([Wanted::Rapid(Point::new(at.z, 0.0)), Wanted::Rapid(Point::default())]);
    }
    all
}

/// Leaves out moves to where the tool is already.
fn without_standing(steps: Vec<Step>) -> Vec<Step> {
    let mut at = Point::default();
    let mut moving = Vec::new();
    for step in steps {
        if step.to().is_some_and(|to| to == at) {
            continue;
        }
        at = step.to().unwrap_or(at);
        moving.push(step);
    }
    moving
}

/// LinuxCNC prints four decimals, in inches for programs in inches.
const TOLERANCE_INCH: f64 = 0.003;

fn judge_linuxcnc(path: &CutterPath, tolerance: f64, what: &str) {
    let machine = machine("linuxcnc");
    let output = post("JUDGED", path, &Options::default(), &Header::default(), &machine);
    assert_eq!(output.diagnostics, [], "{what}");
    let program = &output.programs[0];
    let steps = judge(&program.text).unwrap_or_else(|e| panic!("{what}: {e}\n{}", program.text));
    let steps = without_standing(steps);
    compare(&steps, &wanted_with_retracts(path), Point::default(), tolerance)
        .unwrap_or_else(|e| panic!("{what}: {e}\n{}", program.text));
    println!("{what}: {} canonical moves agree within {tolerance} mm", steps.len());
}

/// A program of another control in the words of LinuxCNC, from `start` in program space.
fn translated(text: &str, machine: &Machine, start: Point) -> String {
    let mut out = "G21 G18 G7 G90 G91.1 G40 G49 G80 G95\nF0.1 S500 M3\n".to_owned();
    let _ = writeln!(out, "G0 X{:.4} Z{:.4}", 2.0 * start.r, start.z);
    let mut at = start;
    for step in read(text, machine, start) {
        let xz = |to: Point| format!("X{:.4} Z{:.4}", 2.0 * to.r, to.z);
        let _ = match step {
            Step::Rapid { to } => writeln!(out, "G0 {}", xz(to)),
            Step::Line { to, .. } => writeln!(out, "G1 {}", xz(to)),
            Step::Arc { to, center, ccw, .. } => {
                let (i, k) = (center.r - at.r, center.z - at.z);
                writeln!(out, "G{} {} I{i:.4} K{k:.4}", if ccw { 3 } else { 2 }, xz(to))
            }
            Step::Thread { to, lead } => writeln!(out, "G33 {} K{lead:.4}", xz(to)),
            Step::Dwell { seconds } => writeln!(out, "G4 P{seconds}"),
        };
        at = step.to().unwrap_or(at);
    }
    out + "M2\n"
}

fn judge_translated(path: &CutterPath, id: &str, what: &str) {
    let mut machine = machine(id);
    machine.words.as_mut().unwrap().max_program_chars = None;
    let options = Options { program_number: Some(1), ..Options::default() };
    let output = post("JUDGED", path, &options, &Header::default(), &machine);
    assert_eq!(output.diagnostics, [], "{what}");
    let start = path.operations[0].change.unwrap() + Vector::new(-path.program_zero_z, 0.0);
    let shifts = machine.words.as_ref().unwrap().thread_angle.is_none();
    let operations = path.operations.iter().filter(|o| !o.moves.is_empty());
    let moves = operations.flat_map(|operation| wanted(path, operation, shifts));
    let all: Vec<Wanted> = std::iter::once(Wanted::Rapid(start)).chain(moves).collect();
    for program in &output.programs {
        let text = translated(&program.text, &machine, start);
        let steps = judge(&text).unwrap_or_else(|e| panic!("{what} on {id}: {e}\n{text}"));
        compare(&steps, &all, Point::default(), TOLERANCE_3_DECIMALS)
            .unwrap_or_else(|e| panic!("{what} on {id}: {e}\n{}", program.text));
        println!("{what} on {id}: {} canonical moves agree within {TOLERANCE_3_DECIMALS} mm", steps.len());
    }
}

#[test]
fn programs_by_hand_are_accepted_and_move_as_the_path() {
    if !is_installed() {
        return;
    }
    judge_linuxcnc(&all_sorts(), TOLERANCE, "all sorts of moves");
    for id in ["fanuc-0i", "mori-fanuc-6t", "swedish-1970s"] {
        judge_translated(&all_sorts(), id, "all sorts of moves");
    }
}

#[test]
fn the_published_form_roll_is_accepted_and_moves_as_the_listing() {
    if is_installed() {
        judge_linuxcnc(&path_of_listing(), TOLERANCE_LISTING, "form-roll 1470b-2T");
    }
}

/// Judges every clamping of a document.
fn judge_document(document: Document, what: &str) {
    let derived = regenerate(&Arc::new(document), &catalog(), &mut Cache::default(), &Cancel::default()).unwrap();
    for setup in &derived.setups {
        if setup.path.operations.iter().all(|o| o.moves.is_empty()) {
            println!("{}, {what}: there are no moves; not judged", setup.name);
            continue;
        }
        judge_linuxcnc(&setup.path, TOLERANCE, &format!("{}, {what}", setup.name));
    }
}

#[test]
fn examples_are_accepted_and_move_as_planned_and_as_instructed() {
    if !is_installed() {
        return;
    }
    for example in examples_of(turnwright::document::Kind::TurnedPart) {
        let mut document: Document = document_from_text(example.name, example.text).unwrap();
        let Content::TurnedPart(part) = &mut document.content else { unreachable!("a turned part") };
        if matches!(part.generator, Generator::Cycles { .. }) {
            judge_document(document.clone(), "by published cycles");
        }
        let Content::TurnedPart(part) = &mut document.content else { unreachable!("a turned part") };
        part.machine = "linuxcnc".to_owned();
        part.generator = Generator::Planned { separate_programs: false };
        judge_document(document, "planned");
    }
}

/// The bearing housing with threads outside and in its bore.
#[test]
fn shells_are_accepted_and_move_as_the_roller_path() {
    if !is_installed() {
        return;
    }
    let machine = machine("linuxcnc");
    for example in examples_of(Kind::Shell) {
        let document = document_from_text(example.name, example.text).unwrap();
        let Content::Shell(shell) = &document.content else { unreachable!("a shell") };
        let shape = spinning::shape(shell).unwrap();
        let path = spinning::path::path(shell, &shape);
        let cutter = spinning::program::cutter_path(shell, &shape, &path, &machine);
        judge_linuxcnc(&cutter, TOLERANCE, example.name);
    }
}

fn threaded_housing(starts: u32) -> Document {
    let mut document = document_from_text("housing", include_str!("../cases/parts/bearing-housing.turn")).unwrap();
    let Content::TurnedPart(part) = &mut document.content else { unreachable!("a turned part") };
    "linuxcnc".clone_into(&mut part.machine);
    let thread = SectionKind::Thread { pitch: 1.5, starts };
    part.sections[2] = Section { kind: thread.clone(), ..Section::line(3, 18.0, 52.0, 48.0, 50.16) };
    part.bore[1] = Section { kind: thread, ..Section::line(6, 22.0, 40.376, 49.0, 42.0) };
    document
}

#[test]
fn a_bored_and_threaded_part_is_accepted_and_moves_as_planned() {
    if is_installed() {
        judge_document(threaded_housing(2), "planned");
    }
}

#[test]
fn a_planned_part_with_compensation_and_cycles_by_the_control_is_accepted() {
    if !is_installed() {
        return;
    }
    let mut document = threaded_housing(1);
    let Content::TurnedPart(part) = &mut document.content else { unreachable!("a turned part") };
    part.program.canned_cycles = true;
    part.program.compensated_by_control = true;
    let derived = regenerate(&Arc::new(document), &catalog(), &mut Cache::default(), &Cancel::default()).unwrap();
    let text = &derived.setups[0].programs[0].text;
    assert!(["G41.1", "G42.1", "G76"].iter().all(|word| text.contains(word)), "{text}");
    judge(text).unwrap_or_else(|e| panic!("{e}\n{text}"));
}

#[test]
fn the_nose_that_linuxcnc_compensates_goes_the_way_of_the_path() {
    if !is_installed() {
        return;
    }
    let path = finish_with_recipe();
    let options = Options { compensated_by_control: true, ..Options::default() };
    let output = post("JUDGED", &path, &options, &Header::default(), &machine("linuxcnc"));
    assert_eq!(output.diagnostics, []);
    let text = &output.programs[0].text;
    assert!(text.contains("G42.1 D1.6000 L2 G1 X36.0000 Z0.0000 F0.2000"), "{text}");
    assert!(text.contains("G40 G0 X"), "{text}");
    let steps = without_standing(judge(text).unwrap_or_else(|e| panic!("{e}\n{text}")));
    compare(&steps, &wanted_with_retracts(&path), Point::default(), TOLERANCE)
        .unwrap_or_else(|e| panic!("{e}\n{text}\n{steps:#?}"));
}

#[test]
fn the_thread_that_linuxcnc_cuts_by_itself_is_the_thread_of_the_path() {
    if !is_installed() {
        return;
    }
    for (crest, root, drive) in [(20.0, 18.773, 22.0), (17.294, 18.6, 15.0)] {
        let path = thread_with_recipe(crest, root, drive);
        let options = Options { canned_cycles: true, ..Options::default() };
        let output = post("JUDGED", &path, &options, &Header::default(), &machine("linuxcnc"));
        let text = &output.programs[0].text;
        assert!(text.contains("G76 P2.0000 Z-30.0000"), "{text}");
        let steps = judge(text).unwrap_or_else(|e| panic!("{e}\n{text}"));
        let passes: Vec<(f64, f64)> = steps
            .iter()
            .filter_map(|s| match s {
                Step::Thread { to, lead } => Some((to.r, *lead)),
                _ => None,
            })
            .collect();
        let (deepest, lead) = *passes.last().unwrap();
        assert!((deepest - root).abs() < TOLERANCE && (lead - 2.0).abs() < TOLERANCE, "{text}\n{passes:?}");
        let first = (passes[0].0 - crest).abs();
        assert!((first - 0.3).abs() < TOLERANCE, "the first cut takes {first} mm\n{text}\n{passes:?}");
    }
}

#[test]
fn a_thread_that_linuxcnc_cuts_by_itself_runs_out_as_it_was_asked() {
    if !is_installed() {
        return;
    }
    for (crest, root, drive) in [(20.0, 18.773, 22.0), (17.294, 18.6, 15.0)] {
        let path = thread_running_out(crest, root, drive, 1.5);
        let options = Options { canned_cycles: true, ..Options::default() };
        let output = post("JUDGED", &path, &options, &Header::default(), &machine("linuxcnc"));
        let text = &output.programs[0].text;
        assert!(text.contains("Z-31.5000") && text.contains("E1.5000 L2"), "{text}");
        let steps = judge(text).unwrap_or_else(|e| panic!("{e}\n{text}"));
        let passes: Vec<Point> = steps
            .iter()
            .filter_map(|s| match s {
                Step::Thread { to, .. } => Some(*to),
                _ => None,
            })
            .collect();
        // Every pass ends at depth where the run-out begins, and goes out of the work on it.
        let [.., along, out] = passes.as_slice() else { panic!("{text}\n{passes:?}") };
        assert!((along.z + 30.0).abs() < TOLERANCE && (along.r - root).abs() < TOLERANCE, "{text}\n{passes:?}");
        assert!((out.z + 31.5).abs() < TOLERANCE && (out.r - crest).abs() < TOLERANCE, "{text}\n{passes:?}");
    }
}

#[test]
fn a_program_in_inches_moves_as_the_path() {
    if !is_installed() {
        return;
    }
    let path = all_sorts();
    let options = Options { unit: Unit::Inch, ..Options::default() };
    let output = post("JUDGED", &path, &options, &Header::default(), &machine("linuxcnc"));
    assert_eq!(output.diagnostics, []);
    let text = &output.programs[0].text;
    let mm = |p: Point| Point::new(p.z * 25.4, p.r * 25.4);
    let in_mm = |step: Step| match step {
        Step::Rapid { to } => Step::Rapid { to: mm(to) },
        Step::Line { to, feed } => Step::Line { to: mm(to), feed },
        Step::Arc { to, center, ccw, feed } => Step::Arc { to: mm(to), center: mm(center), ccw, feed },
        Step::Thread { to, lead } => Step::Thread { to: mm(to), lead: lead * 25.4 },
        dwell @ Step::Dwell { .. } => dwell,
    };
    let steps = judge(text).unwrap_or_else(|e| panic!("{e}\n{text}"));
    let steps = without_standing(steps.into_iter().map(in_mm).collect());
    compare(&steps, &wanted_with_retracts(&path), Point::default(), TOLERANCE_INCH)
        .unwrap_or_else(|e| panic!("{e}\n{text}"));
}
