//! Regeneration: what an edit reruns, and that a result always comes.

use std::sync::Arc;
use turnwright::cancel::Cancel;
use turnwright::document::{Content, Document, TurnedPart};
use turnwright::machine::Catalog;
use turnwright::regen::{Cache, Derived, StageRuns, regenerate};
use turnwright::storage;

fn example(name: &str) -> Document {
    let example = storage::examples().iter().find(|e| e.name == name).expect("the example is shipped");
    storage::document_from_text(name, example.text).expect("shipped examples can be read")
}

fn edited(document: &Document, edit: impl FnOnce(&mut TurnedPart)) -> Arc<Document> {
    let mut document = document.clone();
    let Content::TurnedPart(part) = &mut document.content else { unreachable!("a turned part") };
    edit(part);
    Arc::new(document)
}

fn run(document: &Arc<Document>, cache: &mut Cache) -> Derived {
    regenerate(document, &Catalog::shipped(), cache, &Cancel::default()).expect("nobody cancels")
}

const ONE_EACH: StageRuns = StageRuns { checks: 1, setups: 1, contour: 1, unreachable: 1, path: 1, post: 1, proof: 1 };

#[test]
fn the_same_document_reruns_nothing() {
    let mut cache = Cache::default();
    let queen = Arc::new(example("QUEEN"));
    let first = run(&queen, &mut cache);
    let second = run(&Arc::new(example("QUEEN")), &mut cache);
    assert_eq!(cache.runs(), ONE_EACH);
    assert!(Arc::ptr_eq(&first.setups[0].proof, &second.setups[0].proof));
}

#[test]
fn the_form_tolerance_reruns_checks_and_proof_only() {
    let mut cache = Cache::default();
    let queen = example("QUEEN");
    run(&Arc::new(queen.clone()), &mut cache);
    run(&edited(&queen, |part| part.form_tolerance = 0.3), &mut cache);
    assert_eq!(cache.runs(), StageRuns { checks: 2, proof: 2, ..ONE_EACH });
}

#[test]
fn the_material_reruns_path_and_what_follows() {
    let mut cache = Cache::default();
    let queen = example("QUEEN");
    run(&Arc::new(queen.clone()), &mut cache);
    run(&edited(&queen, |part| part.material = "STEEL".to_owned()), &mut cache);
    let runs = cache.runs();
    assert_eq!((runs.contour, runs.unreachable, runs.path, runs.proof), (1, 1, 2, 2));
}

#[test]
fn an_override_is_proved_in_place_of_the_generated_text() {
    let mut cache = Cache::default();
    let queen = example("QUEEN");
    let derived = run(&Arc::new(queen.clone()), &mut cache);
    let text = derived.setups[0].programs[0].text.replacen("Z  -56.000", "Z  -75.000", 1);
    let changed = run(&edited(&queen, |part| drop(part.overrides.insert("QUEEN1".to_owned(), text))), &mut cache);
    assert!(changed.setups[0].programs[0].edited);
    assert!(!changed.setups[0].proof.passed, "19 mm too far runs into the chuck");
    assert_eq!(cache.runs().post, 1);
}

#[test]
fn a_row_that_is_wrong_leaves_the_rest_alive() {
    let broken = edited(&example("QUEEN"), |part| part.sections[3].d1 = f64::NAN);
    let derived = run(&broken, &mut Cache::default());
    assert!(turnwright::diagnostic::has_errors(&derived.diagnostics));
    assert!(derived.setups[0].setup.profile.pieces.len() > 8);
}

#[test]
fn unknown_machine_and_material_are_said() {
    let queen = example("QUEEN");
    let no_machine = run(&edited(&queen, |part| part.machine = "lathe-9".to_owned()), &mut Cache::default());
    assert_eq!(no_machine.diagnostics[0].code, "unknown-machine");
    let no_material = run(&edited(&queen, |part| part.material = "CHEESE".to_owned()), &mut Cache::default());
    assert!(no_material.diagnostics.iter().any(|d| d.code == "unknown-material"));
}

#[test]
fn a_cancelled_run_says_so_and_the_next_one_works() {
    let cancel = Cancel::default();
    cancel.cancel();
    let mut cache = Cache::default();
    let queen = Arc::new(example("QUEEN"));
    assert!(regenerate(&queen, &Catalog::shipped(), &mut cache, &cancel).is_err());
    assert_eq!(run(&queen, &mut cache).setups.len(), 1);
}

#[test]
fn an_inch_document_gives_the_same_part() {
    let mm = example("QUEEN");
    let Content::TurnedPart(part) = &mm.content else { unreachable!("a turned part") };
    let inch = Document {
        unit: turnwright::units::Unit::Inch,
        content: Content::TurnedPart(part.scaled(1.0 / 25.4)),
        ..mm.clone()
    };
    let (a, b) = (run(&Arc::new(mm), &mut Cache::default()), run(&Arc::new(inch), &mut Cache::default()));
    let (a, b) = (&a.setups[0].contour.contour, &b.setups[0].contour.contour);
    assert_eq!(a.segments.len(), b.segments.len());
    let largest = a.segments.iter().zip(&b.segments).map(|(a, b)| a.end().distance(b.end())).fold(0.0, f64::max);
    assert!(largest < 1e-9, "{largest} mm");
}
