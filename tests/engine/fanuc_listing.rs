//! The published program of a form-roll for the Fanuc 6T (Wong 1983, Fig. 8.31 a): its moves, posted again, give its text.

use crate::words_scan::listing::{LISTING, path_of_listing};
use crate::words_scan::{Word, scan};
use turnwright::machine::{Catalog, Machine};
use turnwright::post::{Header, Options, PostOutput, post};

/// The listing's program number: stage 02, roll 01.
const NUMBER: u32 = 201;

/// Blocks in which the two radii of the listing's arc differ by 0.005 mm and more: "noise" of the published program. Their
/// centres cannot be kept, for ours lie equally far from both ends.
const UNEQUAL_RADII: [u32; 3] = [590, 880, 1260];

/// The radii of the listing's other arcs differ by up to 0.002 mm, which moves their centres by about as much.
const CENTRE: f64 = 0.0045;

fn mori() -> Machine {
    Catalog::shipped().machine("mori-fanuc-6t").unwrap().clone()
}

fn posted(machine: &Machine, options: &Options) -> PostOutput {
    post("1470b-2T", &path_of_listing(), options, &Header::default(), machine)
}

#[test]
fn the_moves_of_the_listing_give_the_text_of_the_listing() {
    let output = posted(&mori(), &Options { program_number: Some(NUMBER), ..Options::default() });
    assert_eq!(output.diagnostics, []);
    assert_eq!(output.programs.len(), 1);
    let program = &output.programs[0];
    assert_eq!((program.name.as_str(), program.extension.as_str()), ("1470b-2T", "nc"));
    let ours: Vec<&str> = program.text.lines().collect();
    let theirs: Vec<&str> = LISTING.lines().collect();
    assert_eq!(ours.len(), theirs.len(), "{}", program.text);
    let mut other = 0;
    for (a, b) in ours.iter().zip(&theirs) {
        if a == b {
            continue;
        }
        other += 1;
        let (a_words, b_words) = (scan(a), scan(b));
        let letters = |words: &[Word]| words.iter().map(|w| w.letter).collect::<String>();
        assert_eq!(letters(&a_words), letters(&b_words), "{a} against {b}");
        let number = b_words[0].value as u32;
        for (ours, theirs) in a_words.iter().zip(&b_words) {
            let centre = matches!(ours.letter, 'I' | 'K');
            let tolerance = if UNEQUAL_RADII.contains(&number) { 0.025 } else { CENTRE };
            let near = centre && (ours.value - theirs.value).abs() < tolerance;
            assert!(near || ours.text() == theirs.text(), "{a} against {b}");
        }
    }
    println!("{other} of {} blocks differ, by the centres of their arcs alone", theirs.len());
    assert!(other < 40, "{other} blocks differ");
}

#[test]
fn every_block_tells_its_operation() {
    let output = posted(&mori(), &Options::default());
    let blocks = &output.programs[0].blocks;
    assert_eq!(blocks.len(), output.programs[0].text.lines().count());
    assert_eq!(blocks[0].summary, "O0201");
    let first = blocks.iter().position(|b| b.operation_index == Some(0)).unwrap();
    assert_eq!(blocks[first].summary, "G50 X-455.000 Z320.000 M08");
    assert!(blocks.iter().any(|b| b.summary == "G1 X-150.000"));
    assert!(blocks.iter().any(|b| b.summary == "G1 Z-2.800"), "the motion that is not repeated is told");
    assert_eq!(blocks.iter().filter_map(|b| b.operation_index).max(), Some(7));
}

#[test]
fn programs_for_every_operation_each_begin_and_end() {
    let output = posted(&mori(), &Options { separate_programs: true, ..Options::default() });
    assert_eq!(output.programs.len(), 8);
    for (k, program) in (1..).zip(&output.programs) {
        let lines: Vec<&str> = program.text.lines().collect();
        assert_eq!(program.name, format!("1470b-2T-{k}"));
        assert_eq!(lines[..2], [format!("O{:04}", 200 + k).as_str(), "N10G21"]);
        assert!(lines[2].starts_with("N15G50X-"), "{}", lines[2]);
        assert!(lines.iter().any(|l| l.contains('F')), "no program relies on the feed of another");
        assert!(lines.last().unwrap().ends_with("M30"));
    }
}

#[test]
fn a_small_memory_divides_the_program_between_operations() {
    let mut machine = mori();
    machine.words.as_mut().unwrap().max_program_chars = Some(2200);
    let output = posted(&machine, &Options::default());
    assert_eq!(output.diagnostics, []);
    assert!(output.programs.len() > 1 && output.programs.len() < 8, "{}", output.programs.len());
    assert!(output.programs.iter().all(|p| p.text.len() <= 2200));
    machine.words.as_mut().unwrap().max_program_chars = Some(1200);
    let output = posted(&machine, &Options::default());
    let found = output.diagnostics.iter().find(|d| d.code == "program-too-long").unwrap();
    assert!(found.message.contains("holds 1200"), "{}", found.message);
}
