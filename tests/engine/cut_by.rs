//! Which blocks cut which row of the published parts.

use std::sync::Arc;
use turnwright::cancel::Cancel;
use turnwright::document::{Content, Document};
use turnwright::machine::Catalog;
use turnwright::proof::{BlockRef, CutBy};
use turnwright::regen::{Cache, proof_input, regenerate};
use turnwright::storage::{document_from_text, examples};

fn example(name: &str) -> Document {
    let example = examples().iter().find(|e| e.name == name).unwrap();
    document_from_text(name, example.text).unwrap()
}

/// The blocks that cut each row of the first clamping, as program and block.
fn blocks_of_rows(document: Document) -> Vec<Vec<(usize, usize)>> {
    let ids: Vec<u32> = {
        let Content::TurnedPart(part) = &document.content else { unreachable!("a turned part") };
        part.sections.iter().map(|s| s.id).collect()
    };
    let document = Arc::new(document);
    let derived = regenerate(&document, &Catalog::shipped(), &mut Cache::default(), &Cancel::default()).unwrap();
    let setup = &derived.setups[0];
    let cut_by = CutBy::new(&proof_input(&derived, setup).unwrap(), &setup.proof);
    let pairs = |id: &u32| cut_by.blocks_of(*id).map(|b| (b.program, b.block)).collect();
    for id in &ids {
        assert!(cut_by.blocks_of(*id).all(|block| cut_by.sections_of(block).any(|section| section == *id)));
    }
    assert_eq!(cut_by.sections_of(BlockRef { program: 0, block: 1 }).count(), 0, "INC cuts nothing");
    ids.iter().map(pairs).collect()
}

/// Finishing runs once along the queen from its free end: blocks 8 to 22 of QUEEN2 with the right-hand tool, 54 to 56 with
/// the left-hand tool. Three more leave a surface: block 7 feeds down the end face, block 17 sets out from the top of row 6's
/// face, and a roughing cut of QUEEN1 enters along row 10.
#[test]
fn every_row_of_the_queen_is_cut_by_the_blocks_that_finish_it() {
    let blocks = blocks_of_rows(example("QUEEN"));
    let expected: [&[(usize, usize)]; 12] = [
        &[(1, 22)],
        &[(1, 20), (1, 21)],
        &[(1, 19)],
        &[(1, 18), (1, 54)],
        &[(1, 55)],
        &[(1, 16), (1, 17), (1, 56)],
        &[(1, 15)],
        &[(1, 14)],
        &[(1, 13)],
        &[(0, 79), (1, 12)],
        &[(1, 11)],
        &[(1, 7), (1, 8), (1, 9), (1, 10)],
    ];
    assert_eq!(blocks, expected);
}

/// A chord each of the parabola, and the thread's cycle beside the finishing of its outside.
#[test]
fn parabolas_and_threads_find_their_blocks() {
    let blocks = blocks_of_rows(example("MASTER"));
    assert_eq!(blocks[1], (12..=21).map(|block| (1, block)).collect::<Vec<_>>());
    assert_eq!(blocks[5], [(1, 9), (1, 32)]);
}

/// An edit by hand changes the blocks, not who they belong to.
#[test]
fn a_program_edited_by_hand_is_followed() {
    let document = Arc::new(example("QUEEN"));
    let derived = regenerate(&document, &Catalog::shipped(), &mut Cache::default(), &Cancel::default()).unwrap();
    let generated = &derived.setups[0].programs[1];
    let mut instructions = turnwright::post::orac::compress(&generated.text, &generated.name).0;
    instructions.insert(3, turnwright::post::orac::Instruction::Dwel { time: 1000 });
    let text = turnwright::post::orac::pages_text(&instructions);
    let mut edited = Document::clone(&document);
    let Content::TurnedPart(part) = &mut edited.content else { unreachable!("a turned part") };
    part.overrides.insert(generated.name.clone(), text);
    let rows = blocks_of_rows(edited);
    assert_eq!(rows[6], [(1, 16)], "one block later than generated");
    assert_eq!(rows[3], [(1, 19), (1, 55)]);
}
