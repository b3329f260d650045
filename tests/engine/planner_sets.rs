//! The planner with whatever tools a turret holds: random parts with bores on every shipped machine, with some of its tools only.
//! Judged by the proof of the programs' text.

use crate::support::planned::{bent, drawn, hundredths, is_named};
use proptest::prelude::*;
use proptest::sample::Index;
use proptest::test_runner::TestRunner;
use std::ops::RangeInclusive;
use std::sync::Arc;
use turnwright::cancel::Cancel;
use turnwright::diagnostic::{Diagnostic, Severity};
use turnwright::document::{Content, Document, Generator, TurnedPart};
use turnwright::geometry::{Point, Segment};
use turnwright::machine::{Catalog, TurretTool};
use turnwright::part::Section;
use turnwright::proof::{Leftover, Motion, ProofReport};
use turnwright::regen::{Cache, Derived, SetupDerived, regenerate};
use turnwright::turning::{CutMove, CutterPath};
use turnwright::units::Unit;

/// Machines of every dialect and kind of turret, with the material that each of them has data of.
const MACHINES: [(&str, &str); 5] = [
    ("orac", "ALUMINUM"),
    ("mori-fanuc-6t", "ALUMINUM"),
    ("fanuc-0i", "C45"),
    ("linuxcnc", "C45"),
    ("swedish-1970s", "C45"),
];

/// What may stay without being named, mm.
const NAMED_FROM_MM: f64 = 0.03;

/// How far programs may cut below the contour, mm.
const GOUGE_MM: f64 = 0.001;

/// How far the moves of the text may be from those of the path, mm.
const READ_BACK_MM: f64 = 0.001;

/// Moves shorter than this may be lost to rounding, mm.
const NO_MOVE_MM: f64 = 0.002;

/// Tools of the whole table in one turret.
const MOST_TOOLS: usize = 6;

/// One row: width, both diameters as shares of the largest, bend (0 and 3 none, 1 hollow, 2 bulge), radius over chord.
type Row = (f64, f64, f64, u8, f64);

fn row() -> impl Strategy<Value = Row> {
    (1.0..9.0_f64, 0.3..1.0_f64, 0.3..1.0_f64, 0..4_u8, 0.6..3.0_f64)
}

/// A part with everything that is drawn: machine, which tools of its turret are there, rows outside and inside.
#[derive(Debug, Clone)]
struct Case {
    machine: usize,
    tools: u16,
    outside: Vec<Row>,
    bore: Vec<Row>,
    facing: bool,
}

fn case() -> impl Strategy<Value = Case> {
    let rows = proptest::collection::vec(row(), 1..7);
    let bore = prop_oneof![2 => Just(Vec::new()), 1 => proptest::collection::vec(row(), 1..4)];
    (0..MACHINES.len(), any::<u16>(), rows, bore, any::<bool>())
        .prop_map(|(machine, tools, outside, bore, facing)| Case { machine, tools, outside, bore, facing })
}

/// Rows one behind the other up to `end`, between two diameters.
fn sections(rows: &[Row], first: u32, end: f64, (least, most): (f64, f64)) -> Vec<Section> {
    let scale = end / rows.iter().map(|row| row.0).sum::<f64>();
    let diameter = |share: f64| hundredths(least + (most - least) * share);
    let mut z = 0.0;
    let mut sections = Vec::new();
    for (id, &(width, d1, d2, bend, share)) in (first..).zip(rows) {
        let to = hundredths(z + width * scale);
        let (d1, d2) = (diameter(d1), if bend == 3 { diameter(d1) } else { diameter(d2) });
        let kind = bent(bend, to - z, (d1, d2), share);
        sections.push(Section { kind, ..Section::line(id, z, d1, to, d2) });
        z = to;
    }
    if let Some(last) = sections.last_mut() {
        last.z2 = end;
    }
    sections
}

/// A bar of 26 mm outside, or with a bore one of 60 mm whose outside stays above 45 mm.
fn part(case: &Case) -> TurnedPart {
    let (machine, material) = MACHINES[case.machine];
    let length = hundredths(case.outside.iter().map(|row| row.0).sum());
    let bored = !case.bore.is_empty() && ["fanuc-0i", "linuxcnc"].contains(&machine);
    let (bar_diameter, outside, inside) =
        if bored { (60.0, (45.0, 59.0), (14.0, 40.0)) } else { (26.0, (4.0, 25.0), (0.0, 0.0)) };
    TurnedPart {
        machine: machine.to_owned(),
        material: material.to_owned(),
        bar_diameter,
        length,
        facing_allowance: if case.facing { 0.8 } else { 0.0 },
        sections: sections(&case.outside, 1, length, outside),
        bore: if bored { sections(&case.bore, 100, length, inside) } else { Vec::new() },
        generator: Generator::Planned { separate_programs: false },
        form_tolerance: GOUGE_MM,
        ..TurnedPart::default()
    }
}

/// The tools of a case in their stations, at least one.
fn turret(case: &Case) -> Vec<TurretTool> {
    let all = Catalog::shipped().machine(MACHINES[case.machine].0).unwrap().tools.clone();
    let is_there = |k: usize| (case.tools >> k) & 1 == 1;
    let drawn: Vec<TurretTool> = (0..).zip(&all).filter(|(k, _)| is_there(*k)).map(|(_, tool)| tool.clone()).collect();
    if drawn.is_empty() { all[..1].to_vec() } else { drawn }
}

/// A case, and tools of the whole table for it.
fn case_with_tools() -> impl Strategy<Value = (Case, Vec<Index>)> {
    (case(), proptest::collection::vec(any::<Index>(), 1..=MOST_TOOLS))
}

/// Tools of the whole table in stations from 1 on.
fn turret_of(tools: &[Index]) -> Vec<TurretTool> {
    let table = Catalog::shipped().tools;
    let ids = tools.iter().map(|tool| tool.get(&table).id.clone());
    let plain =
        |(station, tool)| TurretTool { station, tool, offset: None, change_z_mm: None, change_diameter_mm: None };
    (1..).zip(ids).map(plain).collect()
}

/// Some stations of a machine's own turret.
fn stations(machine: &str, stations: &[u32]) -> Vec<TurretTool> {
    let mut tools = Catalog::shipped().machine(machine).unwrap().tools.clone();
    tools.retain(|t| stations.contains(&t.station));
    assert_eq!(tools.len(), stations.len());
    tools
}

/// A way of the tool: rapid or not, along a segment.
type Step = (bool, Segment);

fn wanted(path: &CutterPath) -> Vec<Step> {
    let mut at = path.datum;
    let mut step = |m: &CutMove| {
        let step = match *m {
            CutMove::Rapid { to } => (true, Segment::line(at, to)),
            CutMove::Line { to, .. } => (false, Segment::line(at, to)),
            CutMove::Arc { to, center, ccw, .. } => (false, Segment::Arc { start: at, end: to, center, ccw }),
            _ => return None,
        };
        at = step.1.end();
        Some(step)
    };
    path.operations.iter().flat_map(|o| &o.moves).filter_map(&mut step).collect()
}

fn read_back(proof: &ProofReport) -> Vec<Step> {
    let moves = proof.moves.iter().filter(|m| m.motion != Motion::Pause && m.path.length() > NO_MOVE_MM);
    moves.map(|m| (m.motion == Motion::Rapid, m.path)).collect()
}

fn near(a: Point, b: Point) -> bool {
    a.distance(b) <= READ_BACK_MM
}

/// The first move of the path that the program's text does not make, and what it makes instead. Rapid moves of the text between
/// operations are its own, and an arc may be several of its moves.
fn first_lost(wanted: &[Step], made: &[Step]) -> Option<(Step, Option<Step>)> {
    let mut rest = made;
    for &(rapid, way) in wanted {
        let done = if rapid { after_rapid(rest, &way) } else { after_cut(rest, &way) };
        match done {
            Some(later) => rest = later,
            None if way.length() <= NO_MOVE_MM + READ_BACK_MM => {}
            None => return Some(((rapid, way), rest.first().copied())),
        }
    }
    rest.iter().find(|m| !m.0).map(|m| (*m, None))
}

/// What comes after the rapid move that ends where one of the path does.
fn after_rapid<'a>(made: &'a [Step], way: &Segment) -> Option<&'a [Step]> {
    let there = made.iter().take_while(|m| m.0).position(|m| near(m.1.end(), way.end()))?;
    made.get(there + 1..)
}

/// What comes after the moves that make a cut of the path.
fn after_cut<'a>(mut made: &'a [Step], way: &Segment) -> Option<&'a [Step]> {
    let on = |made: &Segment| {
        [0.5, 1.0].map(|share| made.point_at(share)).iter().all(|p| way.distance_to(*p) <= READ_BACK_MM)
    };
    loop {
        let ((rapid, part), later) = after_return(made).split_first()?;
        if *rapid || !on(part) {
            return None;
        }
        if near(part.end(), way.end()) {
            return Some(later);
        }
        made = later;
    }
}

/// What comes after rapid moves that bring the tool back to where it was: a text too long for one program is divided anywhere.
fn after_return(made: &[Step]) -> &[Step] {
    let back = |start: Point| made.iter().take_while(|m| m.0).position(|m| near(m.1.end(), start));
    let later = made.first().and_then(|m| back(m.1.start())).and_then(|k| made.get(k + 1..));
    later.unwrap_or(made)
}

fn derived(part: TurnedPart, turret: Vec<TurretTool>) -> Derived {
    let mut catalog = Catalog::shipped();
    catalog.machines.iter_mut().find(|m| m.id == part.machine).unwrap().tools = turret;
    let content = Content::TurnedPart(part);
    let document = Document { turnwright: 1, name: "SETS".to_owned(), unit: Unit::Mm, content };
    regenerate(&Arc::new(document), &catalog, &mut Cache::default(), &Cancel::default()).unwrap()
}

fn derived_with(part: TurnedPart, own: &[u32]) -> Derived {
    let turret = stations(&part.machine, own);
    derived(part, turret)
}

/// What is wrong with one clamping.
fn broken(derived: &Derived, setup: &SetupDerived) -> Option<String> {
    let proof = &setup.proof;
    if let Some(error) = proof.errors().next() {
        return Some(format!("{error:?}"));
    }
    if proof.deepest_gouge_mm > GOUGE_MM {
        return Some(format!("gouge {} mm", proof.deepest_gouge_mm));
    }
    let unnamed = |l: &&Leftover| l.largest_mm > NAMED_FROM_MM && !is_named(derived, l.section);
    if let Some(left) = proof.leftover.iter().find(unnamed) {
        return Some(format!("not named: {left:?}"));
    }
    first_lost(&wanted(&setup.path), &read_back(proof)).map(|step| format!("not in the text: {step:?}"))
}

/// No gouge beyond rounding, nothing touched at rapid or by what cannot cut, nothing left that was not named, and every program
/// read back to the moves of its path. A part that the checks refuse needs no program.
fn promises_hold(case: &Case, turret: Vec<TurretTool>) -> Result<(), TestCaseError> {
    let derived = derived(part(case), turret);
    first_broken(&derived).map_or(Ok(()), |why| Err(TestCaseError::fail(why)))
}

fn first_broken(derived: &Derived) -> Option<String> {
    if is_refused(derived) { None } else { derived.setups.iter().find_map(|setup| broken(derived, setup)) }
}

fn is_refused(derived: &Derived) -> bool {
    derived.diagnostics.iter().any(|d| d.severity == Severity::Error)
}

/// One part and one set of tools for every seed, so that a failing one is found again by its number.
fn run<S: Strategy>(
    seeds: RangeInclusive<u64>,
    drawn_from: &S,
    promises: impl Fn(S::Value) -> Result<(), TestCaseError>,
) {
    for seed in seeds {
        let ran = TestRunner::new(drawn(1, seed)).run(drawn_from, &promises);
        assert!(ran.is_ok(), "seed {seed}: {}", ran.unwrap_err());
    }
}

fn run_with_tools_that_are_there(seeds: RangeInclusive<u64>) {
    run(seeds, &case(), |case| promises_hold(&case, turret(&case)));
}

fn run_with_tools_of_the_table(seeds: RangeInclusive<u64>) {
    run(seeds, &case_with_tools(), |(case, tools)| promises_hold(&case, turret_of(&tools)));
}

#[test]
fn random_parts_are_cut_with_the_tools_that_are_there() {
    run_with_tools_that_are_there(1..=300);
}

/// `cargo test --release --test engine planner_sets:: -- --ignored`
#[test]
#[ignore = "takes minutes; seeds 301 to 5300"]
fn five_thousand_random_parts_are_cut_with_the_tools_that_are_there() {
    run_with_tools_that_are_there(301..=5300);
}

#[test]
fn random_parts_are_cut_with_tools_of_the_whole_table() {
    run_with_tools_of_the_table(1..=200);
}

/// `cargo test --release --test engine planner_sets:: -- --ignored`
#[test]
#[ignore = "takes minutes; seeds 201 to 5200"]
fn five_thousand_random_parts_are_cut_with_tools_of_the_whole_table() {
    run_with_tools_of_the_table(201..=5200);
}

/// A planned part of a bar of 26 mm.
fn turned((machine, material): (&str, &str), facing_allowance: f64, sections: Vec<Section>) -> TurnedPart {
    TurnedPart {
        machine: machine.to_owned(),
        material: material.to_owned(),
        bar_diameter: 26.0,
        length: sections.last().unwrap().z2,
        facing_allowance,
        sections,
        generator: Generator::Planned { separate_programs: false },
        form_tolerance: GOUGE_MM,
        ..TurnedPart::default()
    }
}

fn codes(derived: &Derived) -> Vec<&str> {
    derived.diagnostics.iter().map(|d| d.code.as_str()).collect()
}

#[test]
fn a_tool_leaves_a_faced_end_beside_what_its_flank_left_in_the_middle() {
    let pin = turned(MACHINES[0], 0.8, vec![Section::line(1, 0.0, 20.0, 20.0, 20.0)]);
    assert_eq!(first_broken(&derived_with(pin, &[1])), None);
}

#[test]
fn every_orac_program_of_a_left_hand_tool_begins_like_the_first() {
    let rows = vec![Section::line(1, 0.0, 10.3, 8.76, 22.82), Section::line(2, 8.76, 10.3, 15.76, 10.3)];
    let derived = derived_with(turned(MACHINES[0], 0.8, rows), &[2, 4]);
    assert_eq!(first_broken(&derived), None);
    assert!(derived.setups[0].post.programs.len() > 1, "what begins a program is asked of a second one");
}

#[test]
fn an_end_that_is_flush_with_the_bar_is_not_named() {
    let rows = vec![Section::line(1, 0.0, 20.0, 8.88, 20.0), Section::line(2, 8.88, 24.0, 9.88, 20.0)];
    let derived = derived_with(turned(MACHINES[1], 0.0, rows), &[1, 6]);
    let at_the_end = |d: &&Diagnostic| d.code == "not-reached" && d.message.contains("z 9.880");
    assert_eq!(derived.diagnostics.iter().find(at_the_end), None);
}

#[test]
fn what_is_missing_is_named_and_the_rest_is_programmed() {
    let rows = vec![Section::line(1, 0.0, 24.0, 8.0, 24.0), Section::line(2, 8.0, 14.0, 20.0, 14.0)];
    let blade = derived_with(turned(MACHINES[0], 0.0, rows.clone()), &[3, 4]);
    assert!(codes(&blade).contains(&"turning-tool-missing"), "{:?}", codes(&blade));
    assert!(blade.setups[0].path.operations.iter().any(|o| o.tool == 4), "the blade cuts what it can");
    let mut bush = turned(MACHINES[2], 0.0, rows);
    bush.bore = vec![Section::line(9, 0.0, 12.0, 20.0, 12.0)];
    let solid = derived_with(bush.clone(), &[1, 2]);
    assert!(["drill-missing", "boring-bar-missing"].iter().all(|c| codes(&solid).contains(c)), "{:?}", codes(&solid));
    bush.part_off = true;
    let whole = derived_with(bush, &[1, 7]);
    assert!(["drill-missing", "blade-missing"].iter().all(|c| codes(&whole).contains(c)), "{:?}", codes(&whole));
    assert!([&blade, &solid, &whole].iter().all(|d| first_broken(d).is_none()));
}

#[test]
fn the_head_of_a_program_says_the_time_that_the_proof_measures() {
    let rows = vec![
        Section::line(1, 0.0, 24.0, 30.0, 24.0),
        Section::line(2, 30.0, 14.0, 50.0, 12.0),
        Section::line(3, 50.0, 8.0, 60.0, 8.0),
    ];
    for machine in [MACHINES[2], MACHINES[3]] {
        let derived = derived_with(turned(machine, 0.8, rows.clone()), &[1, 2]);
        let [setup] = &derived.setups[..] else { panic!("one clamping") };
        let [program] = &setup.post.programs[..] else { panic!("one program") };
        let said = program.text.lines().find_map(|line| line.strip_prefix("(TIME ")).unwrap();
        let words: Vec<f64> = said.split(' ').filter_map(|word| word.parse().ok()).collect();
        // The proof takes the first tool to be in its place.
        let measured = setup.proof.times.total_s + derived.machine.as_ref().unwrap().tool_change_s;
        let told = 60.0 * words[0] + words[1];
        assert!((told - measured).abs() < 1.0 + 0.02 * measured, "{}: {told} s, {measured} s", machine.0);
    }
}
