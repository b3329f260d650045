//! Programs of every word-address control, read again by a scanner of their own, make the moves of the path.

use crate::words_scan::paths::{
    CUT, all_sorts, compare, finish_with_recipe, operation, rough_and_finish_with_recipes, thread_running_out,
    thread_with_recipe, wanted,
};
use crate::words_scan::read::read;
use crate::words_scan::scan;
use proptest::prelude::*;
use turnwright::geometry::{Point, Segment, Vector};
use turnwright::machine::{ArcCenter, Catalog, Comments, Machine};
use turnwright::post::{Header, Options, PostOutput, post};
use turnwright::turning::{CutMove, CutterPath, OperationKind};

/// Counts of the last decimal that a move may be off: half a count on either axis for its ends and as much for its centre,
/// which adds up on arcs of half a turn.
const COUNTS: f64 = 2.0;

/// Every shipped machine with words, and one that writes arcs by their radius; all with memory enough.
fn machines() -> Vec<Machine> {
    let mut shipped: Vec<Machine> = Catalog::shipped().machines.into_iter().filter(|m| m.words.is_some()).collect();
    for machine in &mut shipped {
        machine.limits.blocks_per_program = 1_000_000;
        machine.words.as_mut().unwrap().max_program_chars = None;
    }
    assert_eq!(shipped.len(), 4);
    let mut by_radius = shipped.iter().find(|m| m.id == "fanuc-0i").unwrap().clone();
    by_radius.words.as_mut().unwrap().arc_center = ArcCenter::Radius;
    shipped.into_iter().chain([by_radius]).collect()
}

fn posted(path: &CutterPath, machine: &Machine) -> PostOutput {
    post("TEST", path, &Options::default(), &Header::default(), machine)
}

fn check(path: &CutterPath, machine: &Machine) -> Result<(), String> {
    let output = posted(path, machine);
    if !output.diagnostics.is_empty() {
        return Err(format!("{:?}", output.diagnostics));
    }
    let [program] = output.programs.as_slice() else { return Err(format!("{} programs", output.programs.len())) };
    let words = program.text.lines().filter(|l| !l.starts_with('O')).flat_map(scan);
    if let Some(word) = words.into_iter().find(|w| w.number.starts_with('-') && w.value == 0.0) {
        return Err(format!("{} is a negative zero", word.text()));
    }
    let words = machine.words.as_ref().unwrap();
    let shifts = words.thread_angle.is_none();
    let start = path.operations[0].change.unwrap() + Vector::new(-path.program_zero_z, 0.0);
    let steps = read(&program.text, machine, start);
    let all: Vec<_> = path.operations.iter().flat_map(|o| wanted(path, o, shifts)).collect();
    let tolerance = COUNTS / 10_f64.powi(i32::from(words.decimals_mm));
    compare(&steps, &all, start, tolerance).map_err(|e| format!("{}: {e}\n{}", machine.id, program.text))
}

#[test]
fn all_sorts_of_moves_are_written_for_every_control() {
    for machine in machines() {
        check(&all_sorts(), &machine).unwrap();
    }
}

#[test]
fn heads_say_what_the_operator_needs() {
    let header = Header {
        part: "Nut (left)".into(),
        material: "STEEL".into(),
        stock: "BAR D60 X 100 MM".into(),
        holding: "CHUCK".into(),
        tools: [(1, "Roughing tool 80°".to_owned())].into(),
    };
    for machine in machines().iter().filter(|m| m.words.as_ref().unwrap().comments == Comments::Parentheses) {
        let output = post("TEST", &all_sorts(), &Options::default(), &header, machine);
        let head: String = output.programs[0].text.lines().take(14).collect::<Vec<_>>().join("\n");
        for part in
            ["(PART NUT <LEFT>)", "(MATERIAL STEEL)", "(STOCK BAR D60 X 100 MM)", "(TOOL 1 ROUGHING TOOL 80 DEG)"]
        {
            assert!(head.contains(part), "{head}");
        }
        assert!(head.contains("(TIME "), "{head}");
    }
}

#[test]
fn a_position_that_its_word_cannot_hold_is_an_error_with_block_value_and_limit() {
    let mut path = all_sorts();
    path.operations[0].moves[1] = CutMove::Line { to: Point::new(-12_345.0, 25.0), cut: CUT };
    let swedish = machines().into_iter().find(|m| m.id == "swedish-1970s").unwrap();
    let output = posted(&path, &swedish);
    let found = output.diagnostics.iter().find(|d| d.code == "word-too-long").unwrap();
    assert!(matches!(&found.at, turnwright::diagnostic::Place::Block { program, .. } if program == "TEST"));
    assert_eq!(found.message, "W is -12407000; the largest number that its word can hold is 9999999.");
    let mori = Catalog::shipped().machine("mori-fanuc-6t").unwrap().clone();
    let message = &posted(&path, &mori).diagnostics[0].message;
    assert_eq!(message, "Z is -12405.000; the largest number that its word can hold is 9999.999.");
}

#[test]
fn what_is_no_number_gives_no_program() {
    for bad in [f64::NAN, f64::INFINITY] {
        let mut path = all_sorts();
        path.operations[1].moves[0] = CutMove::Rapid { to: Point::new(bad, 25.0) };
        let output = posted(&path, &machines()[0]);
        assert!(output.programs.is_empty());
        assert_eq!(output.diagnostics[0].code, "path-not-finite");
    }
}

#[test]
fn a_feed_that_rounds_to_nothing_is_an_error() {
    let mut path = all_sorts();
    let slow = turnwright::turning::Cut { feed: turnwright::turning::Feed::PerRev(0.000_01), ..CUT };
    path.operations[0].moves[1] = CutMove::Line { to: Point::new(61.0, 25.0), cut: slow };
    let mori = Catalog::shipped().machine("mori-fanuc-6t").unwrap().clone();
    let found = &posted(&path, &mori).diagnostics[0];
    assert_eq!(found.message, "The feed rounds to 0 mm/rev; the smallest that can be written is 0.01 mm/rev.");
}

#[test]
fn lines_too_long_for_the_control_are_an_error() {
    let mut machine = machines().remove(0);
    machine.words.as_mut().unwrap().max_line_chars = Some(20);
    let output = posted(&all_sorts(), &machine);
    assert!(output.diagnostics.iter().any(|d| d.code == "line-too-long" && d.message.contains("reads 20")));
}

#[test]
fn the_opposite_control_writes_words_of_fixed_length() {
    let swedish = machines().into_iter().find(|m| m.id == "swedish-1970s").unwrap();
    // From the clamped end, so that the centres have positions that need no sign.
    let path = CutterPath { program_zero_z: 0.0, ..all_sorts() };
    let text = posted(&path, &swedish).programs[0].text.clone();
    for line in text.lines().filter(|line| *line != "%") {
        for word in scan(line) {
            let digits = word.number.trim_start_matches('-').len();
            let length = match word.letter {
                'N' => 3,
                'G' | 'M' | 'S' => 2,
                'T' | 'F' => 4,
                _ => 7,
            };
            assert_eq!(digits, length, "{line}");
            assert!(!matches!(word.letter, 'I' | 'K') || !word.number.starts_with('-'), "{line}");
        }
    }
}

/// A chain of lines and arcs of at most half a turn, as a path of one operation.
fn chains() -> impl Strategy<Value = CutterPath> {
    let move_ = (0..3_u8, -20.0..20.0_f64, -8.0..8.0_f64, 1.0..60.0_f64, any::<bool>());
    (prop::collection::vec(move_, 1..25), 0.0..100.0_f64).prop_map(|(parts, zero)| {
        let zero = zero - 50.0;
        let change = Point::new(200.0, 120.0);
        let mut at = Point::new(60.0, 40.0);
        let mut moves = vec![CutMove::Rapid { to: at }];
        for (kind, dz, dr, radius, ccw) in parts {
            let to = Point::new(at.z + dz, (at.r + dr).clamp(1.0, 100.0));
            let chord = to - at;
            if kind == 0 || chord.norm() < 0.01 {
                moves.push(CutMove::Line { to, cut: CUT });
            } else {
                let radius = radius.max(chord.norm() / 2.0 * 1.000_001);
                let height = (radius * radius - chord.norm_squared() / 4.0).sqrt() / chord.norm();
                let side = if ccw { height } else { -height };
                let middle = at + chord * 0.5;
                let center = Point::new(middle.z - chord.y * side, middle.r + chord.x * side);
                let arc = Segment::Arc { start: at, end: to, center, ccw };
                assert!(arc.sweep().abs() < 3.15);
                moves.push(CutMove::Arc { to, center, ccw, cut: CUT });
            }
            at = to;
        }
        moves.push(CutMove::Rapid { to: change });
        let operations = vec![operation(OperationKind::FinishRight, 1, change, moves)];
        CutterPath { datum: change, program_zero_z: zero, operations }
    })
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(200) })]
    #[test]
    fn any_chain_of_lines_and_arcs_is_written_for_every_control(path in chains()) {
        for machine in machines() {
            if let Err(message) = check(&path, &machine) {
                return Err(TestCaseError::fail(message));
            }
        }
    }
}

fn fanuc() -> Machine {
    machines().into_iter().find(|m| m.id == "fanuc-0i").unwrap()
}

/// The lines between the calls of a tool and the next coolant off, sequence numbers left out.
fn lines_of(path: &CutterPath, options: &Options, machine: &Machine) -> String {
    let output = post("TEST", path, options, &Header::default(), machine);
    assert_eq!(output.diagnostics, []);
    output.programs[0].text.clone()
}

#[test]
fn recipes_are_written_only_where_asked_for() {
    let plain = lines_of(&rough_and_finish_with_recipes(), &Options::default(), &fanuc());
    assert!(!plain.contains("G71") && !plain.contains("G42"), "{plain}");
    let mori = machines().into_iter().find(|m| m.id == "mori-fanuc-6t").unwrap();
    let options = Options { canned_cycles: true, ..Options::default() };
    assert!(!lines_of(&rough_and_finish_with_recipes(), &options, &mori).contains("G71"), "a control without cycles");
}

#[test]
fn a_fanuc_roughs_by_g71_and_finishes_by_g70() {
    let options = Options { canned_cycles: true, ..Options::default() };
    let text = lines_of(&rough_and_finish_with_recipes(), &options, &fanuc());
    let block = |start: &str| {
        text.lines().find(|l| l.contains(start)).unwrap_or_else(|| panic!("{start} is missing\n{text}")).to_owned()
    };
    assert!(block("G71 U").ends_with("G71 U2.000 R0.500"));
    let cycle = block("G71 P");
    let words = scan(&cycle);
    let value = |letter| words.iter().find(|w| w.letter == letter).unwrap().value;
    assert_eq!((value('U'), value('W'), value('F')), (0.4, 0.1, 0.2));
    let (first, last) = (value('P'), value('Q'));
    assert!(block(&format!("N{first} ")).ends_with("G1 X40.000 F0.200"), "{text}");
    assert!(block(&format!("N{last} ")).ends_with("X62.000"), "{text}");
    assert!(block("G70").ends_with(&format!("G70 P{first} Q{last}")), "{text}");
    assert_eq!(text.matches("Z-20.000").count(), 1, "the finishing moves are not written again\n{text}");
}

#[test]
fn a_fanuc_cuts_a_thread_by_g76() {
    let options = Options { canned_cycles: true, ..Options::default() };
    let text = lines_of(&thread_with_recipe(20.0, 18.773, 22.0), &options, &fanuc());
    assert!(text.contains("G76 P020000 Q50 R0.020\n"), "{text}");
    assert!(text.contains("G76 X37.546 Z-30.000 P1227 Q300 F2.000\n"), "{text}");
    assert!(!text.contains("G32"), "{text}");
    // A run-out of 1 mm is five tenths of the lead, and the thread's end lies behind it.
    let text = lines_of(&thread_running_out(20.0, 18.773, 22.0, 1.0), &options, &fanuc());
    assert!(text.contains("G76 P020500 Q50 R0.020\n"), "{text}");
    assert!(text.contains("G76 X37.546 Z-31.000 P1227 Q300 F2.000\n"), "{text}");
}

#[test]
fn every_stage_sets_its_clamp_and_its_feed_again() {
    let first = finish_with_recipe();
    let mut path = first.clone();
    path.operations.extend(first.operations.iter().cloned());
    path.operations[1].tool = 7;
    for machine in machines().iter().filter(|m| m.words.as_ref().is_some_and(|w| w.surface_speed)) {
        let text = lines_of(&path, &Options::default(), machine);
        let stages: Vec<&str> = text.split("T07").collect();
        let speed = |stage: &str| ["G50S", "G50 S", "G92 S", "G96 D"].iter().any(|word| stage.contains(word));
        if machine.words.as_ref().is_some_and(|w| w.clamp_where_reached) {
            continue;
        }
        let clamps = ["G50 S", "G92 S", "G96 D"].iter().map(|word| text.matches(word).count()).max();
        assert_eq!(clamps, Some(2), "{}\n{text}", machine.id);
        assert!(speed(stages[0]));
        assert_eq!(text.matches(" F0.2").count(), 2, "the first cut of each stage has its feed\n{text}");
    }
}

#[test]
fn a_control_compensates_the_nose_on_the_side_where_the_tool_is() {
    let options = Options { compensated_by_control: true, ..Options::default() };
    let text = lines_of(&finish_with_recipe(), &options, &fanuc());
    for block in ["G42 G1 X36.000 Z0.000 F0.200", "G40 G0 X80.000 Z-15.000"] {
        assert!(text.contains(block), "{text}");
    }
    let mori = machines().into_iter().find(|m| m.id == "mori-fanuc-6t").unwrap();
    assert!(lines_of(&finish_with_recipe(), &options, &mori).contains("G41G1X-36.000"), "X negative: seen in a mirror");
}
