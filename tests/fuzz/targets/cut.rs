//! ORAC programs run on the queen's bar: stock removal, gouges, collisions, leftover.
#![no_main]

mod watch;

use libfuzzer_sys::fuzz_target;
use std::sync::{Arc, LazyLock};
use turnwright::cancel::Cancel;
use turnwright::machine::Catalog;
use turnwright::proof::{ProgramText, ProofInput, prove};
use turnwright::regen::{Cache, proof_input, regenerate};
use turnwright::storage::{document_from_text, examples};

static QUEEN: LazyLock<ProofInput> = LazyLock::new(|| {
    let example = examples().iter().find(|e| e.name == "QUEEN").expect("shipped");
    let document = document_from_text("QUEEN", example.text).expect("shipped");
    let derived =
        regenerate(&Arc::new(document), &Catalog::shipped(), &mut Cache::default(), &Cancel::default()).expect("works");
    proof_input(&derived, &derived.setups[0]).expect("shipped")
});

fuzz_target!(|text: &str| {
    let programs = Arc::new(vec![ProgramText { name: "FUZZ".to_owned(), text: text.to_owned(), edited: true }]);
    let input = ProofInput { programs, ..QUEEN.clone() };
    watch::bounded(|cancel| {
        if let Ok(report) = prove(&input, cancel) {
            assert!(report.deepest_gouge_mm.is_finite() && report.largest_chip_mm2.is_finite());
        }
    });
});
