//! The example sets of form-rolls: every roll is designed, planned and proved.

use std::sync::Arc;
use turnwright::cancel::Cancel;
use turnwright::diagnostic::has_errors;
use turnwright::document::{Content, Kind, RollKind, RollRef};
use turnwright::machine::Catalog;
use turnwright::papers::{RollLine, parts_list_csv, roll_lines};
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
        let blanks_kg: f64 = roll_lines(&derived).iter().filter_map(|line| line.blank_kg).sum();
        // What a shop may reckon with; the documents name no prices.
        let (per_hour, per_kg) = (60.0, 2.0);
        println!(
            "{}: {stations} stations, {} rolls, {} proved, {minutes:.1} min, blanks {blanks_kg:.1} kg, cost {:.0} at {per_hour} an \
             hour and {per_kg} a kg",
            example.name,
            set.rolls.len(),
            set.rolls.iter().filter(|roll| roll.is_proved()).count(),
            minutes / 60.0 * per_hour + blanks_kg * per_kg
        );
        // The published rolls keep their sharp corners; the corners of the others are as a shop would have them.
        let found = set.rolls.iter().flat_map(|r| &r.derived.setups).map(|s| s.proof.findings.len()).sum::<usize>();
        let said = derived.diagnostics.len() + found;
        println!("{}: {said} remarks", example.name);
        assert!(example.name == "1470b" || said <= 20, "{}: {:?}", example.name, derived.diagnostics);
        for roll in &set.rolls {
            let wrong = roll.derived.setups.iter().find_map(|s| s.proof.errors().next());
            assert!(roll.is_proved(), "{}: {wrong:?}", roll.name);
        }
    }
}

/// A roll of its own material: planned for it, weighed and paid by it, named by programs, drawing and lists.
#[test]
fn a_roll_has_a_material_of_its_own() {
    let example = examples_of(Kind::RollSet).find(|e| e.name == "1470b").unwrap();
    let mut document = document_from_text(example.name, example.text).unwrap();
    let Content::RollSet(set) = &mut document.content else { unreachable!("a set") };
    set.stations.truncate(1);
    let (top, bottom) = (RollKind::Top, RollKind::Bottom);
    let roll = |kind| RollRef { station: set.stations[0].id, kind };
    let (top, bottom) = (roll(top), roll(bottom));
    set.material = "C45".to_owned();
    set.rates.price_per_kg = Some(2.0);
    set.roll_mut(top).material = Some("CuSn8".to_owned());
    let mut catalog = Catalog::shipped();
    for material in catalog.materials.iter_mut().filter(|m| m.name == "CuSn8") {
        material.price_per_kg = Some(11.0);
    }
    let derived = regenerate(&Arc::new(document), &catalog, &mut Cache::default(), &Cancel::default()).unwrap();
    let set = derived.rolls.as_ref().unwrap();
    let texts = [top, bottom].map(|roll| {
        let made = set.of_roll(roll).unwrap();
        assert!(made.is_proved(), "{:?}", derived.diagnostics);
        made.derived.setups[0].programs[0].text.clone()
    });
    let first_speed = |text: &String| {
        let word = text.lines().find_map(|line| line.split_once("G96S")).map(|(_, rest)| rest.to_owned()).unwrap();
        word.chars().take_while(char::is_ascii_digit).collect::<String>().parse::<f64>().unwrap()
    };
    // Roughing bronze and steel with carbide, by the material table.
    assert_eq!(texts.each_ref().map(first_speed), [180.0, 220.0]);
    let lines = roll_lines(&derived);
    let [of_top, of_bottom] = lines.as_slice() else { panic!("{lines:?}") };
    assert_eq!((of_top.material.as_str(), of_bottom.material.as_str()), ("CuSn8", "C45"));
    let weight = |line: &RollLine, density: f64| {
        let bar = std::f64::consts::FRAC_PI_4 * (line.blank_diameter_mm.powi(2) - line.bore_mm.powi(2));
        assert!((line.blank_kg.unwrap() - bar * line.width_mm * density * 1e-6).abs() < 1e-9, "{line:?}");
    };
    weight(of_top, 8.8);
    weight(of_bottom, 7.85);
    let price = |line: &RollLine| line.blank_cost.unwrap() / line.blank_kg.unwrap();
    assert!((price(of_top) - 11.0).abs() < 1e-9 && (price(of_bottom) - 2.0).abs() < 1e-9);
    let csv = parts_list_csv(&lines);
    assert!(csv.contains(",CuSn8,") && csv.contains(",C45,"), "{csv}");
}
