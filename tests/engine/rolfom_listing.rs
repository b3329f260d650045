//! The published programs of the form-rolls 1470b-2 (Wong 1983, figures 6.17, 8.31 and 8.32).
//!
//! The top roll's listing is compared move by move and, posted, block by block; `cargo test --test engine rolfom_listing:: --
//! --nocapture` prints the table. Of the bottom roll's program the block numbers and values that the description of the rules quotes are checked.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use turnwright::diagnostic::Severity;
use turnwright::document::{Content, Document};
use turnwright::geometry::Point;
use turnwright::machine::{Catalog, outlines};
use turnwright::part::setups;
use turnwright::post::{Header, Options, post};
use turnwright::storage::{document_to_text, import};
use turnwright::turning::{self, CutMove, CutterPath, Feed, Speed, Task};

/// Numbers of the listing may differ by so much, mm: its last digits are clipped and come from single precision.
const WITHIN: f64 = 0.0025;

/// Differences of a noise block may deviate from the table by so much, mm: the last figure.
const TABLE: f64 = 0.001_5;

/// Words of blocks that differ by more than [`WITHIN`], ours less the listing's, mm. They are those that the description
/// of the published rules lists as noise.
///
/// N560, N850, N1040, N1240: two lines at 0.03° to 0.06°; their meeting slides along both. N575 to N590, N860 to N880,
/// N1250 to N1260: corners of 3.3° and 12.5° between a line and an arc, where single precision lost the last figures (the
/// listing's own arcs miss their radius there by up to 0.016 mm); N590 and N880 have only their start, and with it I and
/// K, from such a corner.
const NOISE: [(u32, &[(char, f64)]); 16] = [
    (560, &[('X', -0.007)]),
    (575, &[('X', 0.006), ('Z', 0.003)]),
    (580, &[('X', -0.005), ('Z', -0.005)]),
    (585, &[('X', -0.028), ('Z', 0.007)]),
    (590, &[('I', 0.014), ('K', -0.007)]),
    (850, &[('X', -0.036), ('Z', 0.006)]),
    (860, &[('X', -0.003)]),
    (865, &[('X', -0.006)]),
    (870, &[('X', 0.016), ('Z', -0.028), ('I', 0.003)]),
    (875, &[('X', -0.022), ('Z', -0.007)]),
    (880, &[('I', 0.011), ('K', 0.007)]),
    (1040, &[('X', -0.009)]),
    (1240, &[('X', 0.047), ('Z', -0.009)]),
    (1250, &[('X', 0.004), ('Z', -0.005)]),
    (1255, &[('Z', -0.003)]),
    (1260, &[('X', -0.006), ('Z', -0.023), ('K', 0.005)]),
];

fn case(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/cases/1470b").join(name)
}

/// The document of a roll, `T` or `B`, as `convert --instructions` makes it.
fn document(roll: &str) -> Document {
    let (document, _) = import::any(&case(&format!("E1470b-2{roll}.txt")), "orac").unwrap();
    import::with_instructions(document, &case(&format!("CU1470b-2{roll}.json"))).unwrap().0
}

fn path(roll: &str) -> CutterPath {
    let Content::TurnedPart(part) = document(roll).content else { unreachable!("a turned part") };
    let catalog = Catalog::shipped();
    let machine = catalog.machine(&part.machine).unwrap();
    let tools = outlines(machine, &catalog);
    let (setups, _) = setups(&part, machine);
    let material = catalog.material(&part.material, turnwright::units::Unit::Mm).unwrap().in_mm();
    let task = Task { setup: &setups[0], part_mm: &part, machine, tools: &tools, material_mm: &material };
    let (path, diagnostics) = turning::generate(&task);
    assert!(diagnostics.iter().all(|d| d.severity != Severity::Error), "{diagnostics:?}");
    path
}

/// Words of one block by their letter.
type Words = BTreeMap<char, f64>;

/// The moves of a path as the blocks of a published program, by block number: all words of every move. Between the moves of
/// two operations the program has five blocks: T, M and of the next one G50, T, G96.
fn blocks(path: &CutterPath) -> BTreeMap<u32, Words> {
    let mut number = 10;
    let mut blocks = BTreeMap::new();
    for operation in &path.operations {
        number += 15;
        let mut at = operation.change.unwrap_or(path.datum);
        for made in &operation.moves {
            number += 5;
            let words = words(made, at, path.program_zero_z);
            at = Point::new(words[&'Z'] + path.program_zero_z, -words[&'X'] / 2.0);
            let rounded = words.into_iter().map(|(letter, value)| (letter, (value * 1000.0).round() / 1000.0));
            blocks.insert(number, rounded.collect());
        }
        number += 10;
    }
    blocks
}

fn words(made: &CutMove, from: Point, zero: f64) -> Words {
    let to = |g: f64, to: Point| vec![('G', g), ('X', -2.0 * to.r), ('Z', to.z - zero)];
    let mut words = match *made {
        CutMove::Rapid { to: p } => to(0.0, p),
        CutMove::Line { to: p, .. } => to(1.0, p),
        CutMove::Arc { to: p, center, ccw, .. } => {
            let mut words = to(if ccw { 2.0 } else { 3.0 }, p);
            words.extend([('I', from.r - center.r), ('K', center.z - from.z)]);
            words
        }
        ref other => panic!("no move of these cycles: {other:?}"),
    };
    if let CutMove::Line { cut, .. } | CutMove::Arc { cut, .. } = made
        && let (Feed::PerRev(feed), Speed::Surface { m_per_min, .. }) = (cut.feed, cut.speed)
    {
        words.extend([('F', feed), ('S', m_per_min)]);
    }
    words.into_iter().collect()
}

/// The words of a line of a program in their order.
fn parsed(line: &str) -> Vec<(char, f64)> {
    let starts: Vec<usize> = line.char_indices().filter(|(_, c)| c.is_ascii_uppercase()).map(|(i, _)| i).collect();
    let ends = starts.iter().skip(1).copied().chain([line.len()]);
    let words = starts.iter().zip(ends).map(|(&start, end)| &line[start..end]);
    words.map(|w| (w.chars().next().unwrap(), w[1..].trim().parse().unwrap())).collect()
}

/// The moves of the published listing by block number, with G, X and Z of every move and the F and S that hold.
fn listing() -> BTreeMap<u32, Words> {
    let text = std::fs::read_to_string(case("NC1470b-2T.nc")).unwrap();
    let mut modal: Words = BTreeMap::new();
    let mut moves = BTreeMap::new();
    for line in text.lines().filter(|l| l.starts_with('N')) {
        let words = parsed(line);
        let has = |letter| words.iter().any(|(l, _)| *l == letter);
        let is_move = (has('X') || has('Z')) && !words.contains(&('G', 50.0));
        modal.retain(|letter, _| !"IK".contains(*letter));
        modal.extend(words.iter().copied().filter(|(letter, value)| *letter != 'G' || *value < 4.0));
        if is_move {
            let mut made: Words =
                modal.iter().filter(|(l, _)| "GXZIKFS".contains(**l)).map(|(l, v)| (*l, *v)).collect();
            if made[&'G'] == 0.0 {
                made.retain(|letter, _| !"FS".contains(*letter));
            }
            moves.insert(line[1..].split('G').next().unwrap().split(['X', 'Z']).next().unwrap().parse().unwrap(), made);
        }
    }
    moves
}

#[test]
fn every_move_of_the_top_roll_is_the_published_one() {
    let (ours, published) = (blocks(&path("T")), listing());
    let numbers = |blocks: &BTreeMap<u32, Words>| blocks.keys().copied().collect::<Vec<_>>();
    assert_eq!(numbers(&ours), numbers(&published));
    let noise = BTreeMap::from(NOISE);
    let (mut equal, mut within, mut noisy) = (0, 0, Vec::new());
    for (number, block) in &ours {
        let theirs = &published[number];
        assert_eq!(block.keys().collect::<String>(), theirs.keys().collect::<String>(), "words of N{number}");
        assert_eq!(block[&'G'], theirs[&'G'], "kind of N{number}");
        let off: Vec<(char, f64)> = block.iter().map(|(l, v)| (*l, v - theirs[l])).collect();
        let beyond: Vec<(char, f64)> = off.iter().copied().filter(|(_, d)| d.abs() > WITHIN).collect();
        let known = noise.get(number).copied().unwrap_or_default();
        let as_known = |(letter, d): &(char, f64)| known.iter().any(|(l, k)| l == letter && (d - k).abs() < TABLE);
        assert!(beyond.iter().all(as_known), "N{number} differs by {beyond:?}, known is {known:?}");
        match () {
            () if !beyond.is_empty() => noisy.push((number, beyond)),
            () if off.iter().any(|(_, d)| d.abs() > 1e-6) => within += 1,
            () => equal += 1,
        }
    }
    println!("{equal} moves equal, {within} within {WITHIN} mm, {} noise", noisy.len());
    for (number, words) in &noisy {
        let words: Vec<String> = words.iter().map(|(letter, d)| format!("{letter} {d:+.3}")).collect();
        println!("  N{number}: {}", words.join(", "));
    }
    assert_eq!((ours.len(), noisy.len()), (220, NOISE.len()));
}

/// First and last block of every operation, as the figures of the instructions give them.
fn ranges(roll: &str) -> Vec<(u32, u32)> {
    let text = std::fs::read_to_string(case(&format!("CU1470b-2{roll}.json"))).unwrap();
    let file: serde_json::Value = serde_json::from_str(&text).unwrap();
    let number = |s: &str| s.trim_start_matches('N').parse().unwrap();
    let ranges = file["operations"].as_array().unwrap().iter().map(|o| o["nc_blocks"].as_str().unwrap());
    ranges.map(|r| r.split_once('-').unwrap()).map(|(a, b)| (number(a), number(b))).collect()
}

#[test]
fn the_operations_of_both_rolls_have_their_published_block_numbers() {
    for roll in ["T", "B"] {
        let mut number = 10;
        let made = path(roll).operations.into_iter().map(|operation| {
            let first = number + 5;
            // G50, T, G96; the moves; T and M.
            number += 5 * (3 + u32::try_from(operation.moves.len()).unwrap() + 2);
            (first, number)
        });
        assert_eq!(made.collect::<Vec<_>>(), ranges(roll), "{roll}");
    }
}

#[test]
fn quoted_blocks_of_the_bottom_roll() {
    let blocks = blocks(&path("B"));
    let is = |number: u32, letter: char, value: f64| {
        let made = blocks[&number][&letter];
        assert!((made - value).abs() < WITHIN, "N{number} {letter}: {made} for {value}");
    };
    let at = |number: u32| (blocks[&number][&'Z'], blocks[&number][&'X']);
    // Approaches: 5 mm in front of the area, 10 mm above what is left of the blank.
    for (number, x, z) in [
        (30, -180.0, 164.303),
        (245, -170.0, -5.0),
        (425, -170.0, 153.303),
        (610, -170.0, 6.0),
        (795, -170.0, 151.303),
        (915, -170.0, 31.0),
        (990, -170.0, 8.0),
        (1105, -170.0, 128.303),
    ] {
        is(number, 'G', 0.0);
        is(number, 'X', x);
        is(number, 'Z', z);
    }
    // Lead-ins: 3 mm along the spindle and on the radius to the start of the first element, an arc.
    for (lead_in, start, sign) in [(140, 145, 1.0), (325, 330, -1.0)] {
        let ((z1, x1), (z2, x2)) = (at(lead_in), at(start));
        assert!((z1 - z2 - 3.0 * sign).abs() < WITHIN && (x1 - x2 - 6.0).abs() < WITHIN, "N{lead_in}");
        is(start + 5, 'G', if sign > 0.0 { 2.0 } else { 3.0 });
    }
    // The undercut behind 148.303 is crossed at a centre radius of 65.915; the rest of element 28 follows.
    is(155, 'Z', 147.503);
    is(160, 'X', -2.0 * (65.915 - 0.8));
    is(155, 'X', -2.0 * (65.915 - 0.8));
    assert!(at(165).0 < at(160).0 && blocks[&165][&'G'] == 1.0);
    // The pass ends before the falling element, and the tool goes home.
    is(210, 'G', 1.0);
    is(215, 'X', -455.0);
    is(215, 'Z', 320.0);
    // Grooving: from above the blank, the blade's corner on the area, to the offset end of elements 25 and 12.
    is(430, 'X', -156.0);
    is(430, 'Z', 144.203);
    is(615, 'X', -156.0);
    is(615, 'Z', 11.0);
    is(565, 'Z', 126.765);
    is(750, 'Z', 28.438);
    let steps: Vec<f64> = (0..10).map(|k| at(430 + 15 * k).0).collect();
    assert!(steps.windows(2).take(8).all(|w| (w[0] - w[1] - 2.05).abs() < WITHIN), "{steps:?}");
    assert!((steps[8] - steps[9] - 1.038).abs() < WITHIN, "{steps:?}");
    // Starting points of finishing, the nose radius beside the given line.
    for (number, z) in [(800, 137.7), (920, 20.2), (995, 20.8), (1110, 138.3)] {
        is(number, 'Z', z);
        is(number, 'X', -159.2);
    }
    // Corners: a hollow one is a meeting, an edge of 90° is rolled around.
    is(810, 'G', 1.0);
    is(820, 'G', 2.0);
    is(1015, 'G', 3.0);
    // Retreats.
    for (number, z) in [(880, 31.77), (955, -5.0), (1070, 127.533), (1145, 164.303)] {
        is(number, 'G', 0.0);
        is(number, 'X', -180.0);
        is(number, 'Z', z);
    }
    // Feeds.
    is(35, 'F', 0.25);
    is(430, 'F', 0.1);
    assert_eq!(blocks.len(), 190);
}

/// Blocks of the listing that repeat a Z word though the tool does not move along Z: the same place is printed as -1.200
/// in the block before, as -1.199 here.
const REPEATED_Z: [u32; 2] = [225, 240];

/// Words that differ in the posted program alone: around an edge of 3.3° the nose rolls on an arc 0.023 mm long, and the post
/// moves an arc's centre so far along it that both of its rounded ends lie on one circle.
const POSTED: [(u32, &[(char, f64)]); 2] = [(1070, &[('K', -0.003)]), (1270, &[('K', 0.003)])];

#[test]
fn every_block_of_the_posted_program_is_the_published_one() {
    let Content::TurnedPart(part) = document("T").content else { unreachable!("a turned part") };
    let catalog = Catalog::shipped();
    let machine = catalog.machine(&part.machine).unwrap();
    let options = Options { program_number: part.program.number, ..Options::default() };
    let output = post("1470b-2T", &path("T"), &options, &Header::default(), machine);
    assert_eq!(output.diagnostics, []);
    let text = std::fs::read_to_string(case("NC1470b-2T.nc")).unwrap();
    let (ours, published): (Vec<&str>, Vec<&str>) = (output.programs[0].text.lines().collect(), text.lines().collect());
    assert_eq!((ours.len(), ours[0]), (published.len(), published[0]));
    let noise: BTreeMap<u32, &[(char, f64)]> = NOISE.into_iter().chain(POSTED).collect();
    let (mut equal, mut within, mut noisy) = (0, 0, 0);
    for (a, b) in ours.iter().zip(&published).skip(1) {
        let (ours, mut theirs) = (parsed(a), parsed(b));
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a block number")]
        let number = theirs[0].1 as u32;
        if REPEATED_Z.contains(&number) {
            theirs.retain(|(letter, _)| *letter != 'Z');
        }
        let letters = |words: &[(char, f64)]| words.iter().map(|(letter, _)| *letter).collect::<String>();
        assert_eq!(letters(&ours), letters(&theirs), "{a} for {b}");
        let off: Vec<(char, f64)> = ours.iter().zip(&theirs).map(|((l, x), (_, y))| (*l, x - y)).collect();
        let beyond: Vec<(char, f64)> = off.iter().copied().filter(|(_, d)| d.abs() > WITHIN).collect();
        let known = noise.get(&number).copied().unwrap_or_default();
        let as_known = |(letter, d): &(char, f64)| known.iter().any(|(l, k)| l == letter && (d - k).abs() < TABLE);
        assert!(beyond.iter().all(as_known), "{a} for {b}, known is {known:?}");
        match () {
            () if !beyond.is_empty() => noisy += 1,
            () if off.iter().any(|(_, d)| d.abs() > 1e-6) => within += 1,
            () => equal += 1,
        }
    }
    println!("{equal} blocks equal, {within} within {WITHIN} mm, {noisy} noise, of {}", equal + within + noisy);
    assert_eq!((equal + within + noisy, noisy), (261, noise.len()));
}

/// `UPDATE_EXAMPLES=1 cargo test --test engine rolfom_listing::` writes the example anew.
#[test]
fn the_example_is_what_the_importers_make() {
    let example = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/examples/roll-top.turn");
    let text = document_to_text(&document("T")).unwrap();
    if std::env::var_os("UPDATE_EXAMPLES").is_some_and(|v| v == "1") {
        std::fs::write(&example, &text).unwrap();
    }
    assert_eq!(std::fs::read_to_string(&example).unwrap(), text);
}

/// The published finishing of the bottom roll goes with 35° inserts over the R2 edges of both side faces, down to where the
/// face is upright (operation 6 with tool 11 on the left, operation 8 with tool 3 on the right). The nose runs where it should, as
/// the top roll's does, which has chamfers of 45° there. But the back edge of the insert follows it: at `α` to the axis it cuts
/// the edge of radius `R` down to `(R + n)·sin α − n` around its centre, `n` being the nose radius. An insert of 35° that cuts an
/// upright wall before, as both operations do, has `α` of 55° at most, so that it takes 0.434 mm or more; with the usual 93° in
/// front it is 52° and 0.509 mm. The published system looked at the nose alone; the proof is right, and the cycles are as
/// published.
#[test]
fn the_published_finishing_of_the_bottom_roll_gouges_its_edges_with_the_back_of_the_insert() {
    use std::sync::Arc;
    use turnwright::cancel::Cancel;
    use turnwright::proof::FindingKind;
    use turnwright::regen::{Cache, regenerate};
    let depth = |back_deg: f64| 2.0 - ((2.0 + 0.4) * back_deg.to_radians().sin() - 0.4);
    assert!((depth(180.0 - 93.0 - 35.0) - 0.509).abs() < 0.0005 && (depth(90.0 - 35.0) - 0.434).abs() < 0.0005);
    let document = Arc::new(document("B"));
    let derived = regenerate(&document, &Catalog::shipped(), &mut Cache::default(), &Cancel::default()).unwrap();
    let setup = &derived.setups[0];
    let errors: Vec<_> = setup.proof.errors().collect();
    let lines: Vec<&str> = setup.programs[0].text.lines().collect();
    let blocks: Vec<&str> = errors.iter().map(|f| &lines[f.block - 1][..5]).collect();
    assert_eq!(blocks, ["N960G", "N1160"], "{errors:?}");
    for (finding, center) in errors.iter().zip([Point::new(2.0, 63.015), Point::new(157.303, 63.015)]) {
        let at = finding.at.unwrap();
        assert_eq!(finding.kind, FindingKind::Gouge);
        assert!((finding.value - depth(52.0)).abs() < 0.001, "{finding:?}");
        assert!((2.0 - at.distance(center) - finding.value).abs() < 0.005, "on the rounded edge: {finding:?}");
    }
}
