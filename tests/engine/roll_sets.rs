//! The example sets of form-rolls: every roll is designed, planned and proved.

use std::sync::Arc;
use turnwright::cancel::Cancel;
use turnwright::diagnostic::has_errors;
use turnwright::document::Kind;
use turnwright::machine::Catalog;
use turnwright::regen::{Cache, Derived, regenerate};
use turnwright::storage::{document_from_text, examples_of};

fn derived(text: &str, name: &str) -> Derived {
    let document = Arc::new(document_from_text(name, text).unwrap());
    regenerate(&document, &Catalog::shipped(), &mut Cache::default(), &Cancel::default()).unwrap()
}

#[test]
fn every_roll_of_every_example_is_proved() {
    for example in examples_of(Kind::RollSet) {
        let derived = derived(example.text, example.name);
        let set = derived.rolls.as_ref().unwrap();
        let stations = set.design.stations.len();
        assert!(set.rolls.len() >= 2 * stations, "{}: {} rolls", example.name, set.rolls.len());
        assert!(!has_errors(&derived.diagnostics), "{}: {:?}", example.name, derived.diagnostics);
        let minutes: f64 = set.rolls.iter().flat_map(|r| &r.derived.setups).map(|s| s.proof.times.total_s / 60.0).sum();
        println!("{}: {stations} stations, {} rolls, {minutes:.0} min", example.name, set.rolls.len());
        for roll in &set.rolls {
            assert!(roll.is_proved(), "{}", roll.name);
        }
    }
}
