//! Sets of form-rolls with something wrong: it is said at its place with value and limit, and everything else still works.

use std::sync::Arc;
use std::time::{Duration, Instant};
use turnwright::cancel::Cancel;
use turnwright::diagnostic::{Place, Severity};
use turnwright::document::{BendAngle, Content, Document, Element, ElementKind, Pinch, RollSet};
use turnwright::machine::Catalog;
use turnwright::regen::{Cache, Derived, regenerate};
use turnwright::storage::{document_from_text, examples_of};

/// Regenerates the published set with one thing changed after the other; what is alike is not made twice.
struct Bench {
    document: Document,
    catalog: Catalog,
    cache: Cache,
}

impl Bench {
    fn new() -> Self {
        let example = examples_of(turnwright::document::Kind::RollSet).find(|e| e.name == "1470b").unwrap();
        let document = document_from_text(example.name, example.text).unwrap();
        Self { document, catalog: Catalog::shipped(), cache: Cache::default() }
    }

    fn with(&mut self, change: impl FnOnce(&mut RollSet)) -> Derived {
        let mut document = self.document.clone();
        let Content::RollSet(set) = &mut document.content else { unreachable!("a set") };
        change(set);
        regenerate(&Arc::new(document), &self.catalog, &mut self.cache, &Cancel::default()).unwrap()
    }
}

/// The place of the first message with this code, which names a value.
fn place_of(derived: &Derived, code: &str) -> Place {
    let found = derived.diagnostics.iter().find(|d| d.code == code);
    let found = found.unwrap_or_else(|| panic!("no {code} in {:?}", derived.diagnostics));
    assert!(found.message.contains(|c: char| c.is_ascii_digit()), "{code} names no value: {}", found.message);
    found.at.clone()
}

/// Names of the rolls that are proved, without that of the set.
fn proved(derived: &Derived) -> String {
    let rolls = derived.rolls.as_ref().unwrap().rolls.iter().filter(|r| r.is_proved());
    rolls.map(|r| r.name.trim_start_matches("1470b-")).collect::<Vec<_>>().join(" ")
}

fn station(number: usize) -> Place {
    Place::Station { id: u32::try_from(number).unwrap(), number }
}

fn roll(name: &str) -> Place {
    Place::Roll { name: format!("1470b-{name}") }
}

#[test]
fn what_is_wrong_is_said_at_its_place_and_the_rest_is_proved() {
    let mut bench = Bench::new();
    let all = "1T 1B 2T 2B 3T 3B 3L 3R";
    assert_eq!(proved(&bench.with(|_| {})), all);
    // An impossible flower: a bend that goes the other way at station 2, and is beyond all metal at station 3.
    let bend = |element, angle_deg| BendAngle { element, angle_deg };
    let found = bench.with(|s| s.stations[1].bends.push(bend(12, -20.0)));
    assert_eq!(place_of(&found, "opposite-bend"), station(2));
    assert!(proved(&found).starts_with("1T 1B"), "{}", proved(&found));
    let found = bench.with(|s| s.stations[2].bends.push(bend(20, -400.0)));
    assert_eq!(place_of(&found, "beyond-finished"), station(3));
    assert!(proved(&found).starts_with("1T 1B 2T 2B"), "{}", proved(&found));
    // A roll that is thinner than its bore.
    let found = bench.with(|s| s.stations[1].pass_height = 20.0);
    assert_eq!(place_of(&found, "roll-thin"), roll("2B"));
    assert!(proved(&found).starts_with("1T 1B ") && proved(&found).ends_with("3T 3B 3L 3R"), "{}", proved(&found));
    assert!(!proved(&found).contains("2B"), "{}", proved(&found));
    // Rolls that stand in one another.
    let found = bench.with(|s| s.stations[2].side_right.as_mut().unwrap().extensions[1].lengths[2] = -20.0);
    assert!(matches!(place_of(&found, "roll-overlap"), Place::Roll { .. }));
    assert!(proved(&found).starts_with("1T 1B 2T 2B"), "{}", proved(&found));
    // Clearances and tolerances below nothing.
    let found = bench.with(|s| s.stations[1].pinch = Pinch::Clearance { added: -0.1 });
    assert_eq!(place_of(&found, "roll-clearance-negative"), station(2));
    assert_eq!(proved(&found), "1T 1B 3T 3B 3L 3R");
    let found = bench.with(|s| s.stations[0].tolerance_left = -0.2);
    assert_eq!(place_of(&found, "roll-tolerance"), station(1));
    assert_eq!(proved(&found), "2T 2B 3T 3B 3L 3R");
    // Openings that are none: the station has no rolls.
    let found = bench.with(|s| s.stations[1].pinch = Pinch::Gaps { drive: 0.0, clearance: -1.0 });
    assert_eq!(place_of(&found, "roll-opening"), station(2));
    assert_eq!(proved(&found), "1T 1B 3T 3B 3L 3R");
    // A gear ratio that cannot be, and one that does not fit: the latter is a warning.
    let found = bench.with(|s| s.stations[1].gear_ratio = Some(-1.0));
    assert_eq!(place_of(&found, "gear-ratio"), station(2));
    let found = bench.with(|s| s.line.gear_ratio = Some(1.1));
    assert_eq!((place_of(&found, "roll-drive-ratio"), proved(&found).as_str()), (station(1), all));
    // And after all that the set is as it was.
    assert_eq!(proved(&bench.with(|_| {})), all);
}

#[test]
fn without_strip_there_are_no_rolls_and_a_reason() {
    let mut bench = Bench::new();
    for (change, code) in [
        ((|s| s.section.thickness = 0.0) as fn(&mut RollSet), "strip-thickness"),
        (|s| s.section.thickness = -1.0, "strip-thickness"),
        (|s| s.section.elements.clear(), "no-elements"),
    ] {
        let found = bench.with(change);
        assert!(found.diagnostics.iter().any(|d| d.code == code && d.severity == Severity::Error), "{code}");
        assert_eq!(place_of(&found, "roll-no-strip"), station(1));
        assert!(found.rolls.as_ref().unwrap().rolls.is_empty());
    }
    let found = bench.with(|s| s.stations.clear());
    assert!(found.rolls.as_ref().unwrap().rolls.is_empty());
}

/// A strip of 1,000 elements, bent to and fro.
#[test]
fn a_thousand_elements_are_designed_before_anybody_waits() {
    let mut set = Bench::new().document.content.roll_set().unwrap().clone();
    let kind = |k: u32| match k % 4 {
        1 => ElementKind::Bend { inside_radius: 1.0, angle_deg: 20.0 },
        3 => ElementKind::Bend { inside_radius: 1.0, angle_deg: -20.0 },
        _ => ElementKind::Line { length: 2.0 },
    };
    set.section.elements = (0..1001).map(|k| Element { id: k + 1, kind: kind(k) }).collect();
    set.stations.truncate(1);
    let station = &mut set.stations[0];
    let bends = set.section.elements.iter().filter_map(|e| match e.kind {
        ElementKind::Bend { angle_deg, .. } => Some(BendAngle { element: e.id, angle_deg: angle_deg / 2.0 }),
        ElementKind::Line { .. } => None,
    });
    station.bends = bends.collect();
    station.drive_right = None;
    let start = Instant::now();
    let design = turnwright::rollform::design("x", &set);
    let took = start.elapsed();
    println!(
        "1,001 elements: designed in {took:?}, {} elements of rolls",
        design.rolls().map(|r| r.elements.len()).sum::<usize>()
    );
    assert_eq!(design.rolls().count(), 2, "{:?}", design.diagnostics);
    assert!(design.rolls().all(|r| r.elements.len() > 1000));
    assert!(took < Duration::from_secs(20), "{took:?}");
}

/// Every number of a set in turn replaced by nonsense: the design ends, what it makes is finite, or an error says why not,
/// and the stations that the number does not concern are as they were.
#[test]
fn whatever_number_is_nonsense_the_design_ends_and_only_sound_rolls_are_left() {
    let set = Bench::new().document.content.roll_set().unwrap().clone();
    let whole = serde_json::to_value(&set).unwrap();
    let mut paths = Vec::new();
    numbers(&whole, String::new(), &mut paths);
    assert!(paths.len() > 150, "{}", paths.len());
    let plain = turnwright::rollform::design("x", &set);
    let (mut tried, mut slowest) = (0, (Duration::ZERO, String::new()));
    for path in &paths {
        for nonsense in [0.0, -1.0, 1e300, -1e300, 1e-300, 1e9] {
            let mut value = whole.clone();
            let place = value.pointer_mut(path).unwrap();
            *place = if place.is_u64() { (nonsense as u32).into() } else { nonsense.into() };
            let Ok(broken) = serde_json::from_value::<RollSet>(value) else { continue };
            let start = Instant::now();
            let design = turnwright::rollform::design("x", &broken);
            let flower = turnwright::rollform::flower::Flower::of(&broken);
            _ = turnwright::rollform::rules::check(&broken, &flower, turnwright::units::Unit::Mm);
            slowest = slowest.max((start.elapsed(), format!("{path} = {nonsense}")));
            tried += 1;
            for roll in design.rolls().filter(|roll| design.is_sound(roll)) {
                let finite = roll.contour().bounds().is_some_and(|b| b.min.is_finite() && b.max.is_finite());
                assert!(finite, "{} is called sound with {path} = {nonsense}", roll.name);
            }
            if let Some(station) = path.strip_prefix("/stations/").and_then(|p| p.chars().next()?.to_digit(10))
                && !path.contains("/bends/")
                && !path.ends_with("/id")
            {
                let others = |d: &turnwright::rollform::RollDesign| -> Vec<_> {
                    let others = d.stations.iter().filter(|s| s.number != station as usize + 1);
                    others.flat_map(|s| s.rolls.iter().map(|r| r.elements.clone())).collect()
                };
                assert_eq!(others(&design), others(&plain), "{path} = {nonsense}");
            }
        }
    }
    println!("{tried} sets with nonsense; the slowest design took {:?}: {}", slowest.0, slowest.1);
    assert!(slowest.0 < Duration::from_secs(5), "{slowest:?}");
}

/// Paths of all numbers of a value.
fn numbers(value: &serde_json::Value, path: String, found: &mut Vec<String>) {
    match value {
        serde_json::Value::Number(_) => found.push(path),
        serde_json::Value::Array(list) => {
            list.iter().enumerate().for_each(|(index, child)| numbers(child, format!("{path}/{index}"), found));
        }
        serde_json::Value::Object(map) => {
            map.iter().for_each(|(key, child)| numbers(child, format!("{path}/{key}"), found));
        }
        _ => {}
    }
}

/// Numbers that are none cannot stand in a file, but an edit may bring them: they are refused or told, and nothing else suffers.
#[test]
fn what_is_no_number_is_told_and_the_other_stations_are_proved() {
    let mut bench = Bench::new();
    let others = "1T 1B 3T 3B 3L 3R";
    for (what, change) in [
        ("pass height", (|s| s.stations[1].pass_height = f64::NAN) as fn(&mut RollSet)),
        ("infinite pass height", |s| s.stations[1].pass_height = f64::INFINITY),
        ("pass height of 1e300", |s| s.stations[1].pass_height = 1e300),
        ("centre distance", |s| s.stations[1].centre_distance = f64::NAN),
        ("centre distance of 1e300", |s| s.stations[1].centre_distance = 1e300),
        ("tolerance", |s| s.stations[1].tolerance_right = f64::NAN),
        ("opening", |s| s.stations[1].pinch = Pinch::Gaps { drive: f64::NAN, clearance: 0.6 }),
        ("extension", |s| s.stations[1].extension_right[0].lengths[2] = f64::NAN),
        ("extension of 1e300", |s| s.stations[1].extension_right[0].lengths[1] = 1e300),
    ] {
        let start = Instant::now();
        let found = bench.with(change);
        let place = station(2);
        let roll_of_2 = |at: &Place| matches!(at, Place::Roll { name } if name.starts_with("1470b-2"));
        let told =
            found.diagnostics.iter().any(|d| d.severity == Severity::Error && (d.at == place || roll_of_2(&d.at)));
        assert!(told, "{what}: {:?}", found.diagnostics);
        let proved = proved(&found);
        assert!(proved.starts_with("1T 1B ") && proved.ends_with("3T 3B 3L 3R"), "{what}: {proved}");
        assert!(start.elapsed() < Duration::from_secs(50), "{what} took {:?}", start.elapsed());
    }
    for change in [
        (|s| s.section.elements[0].kind = ElementKind::Line { length: f64::NAN }) as fn(&mut RollSet),
        |s| s.section.elements[1].kind = ElementKind::Bend { inside_radius: f64::NAN, angle_deg: 10.0 },
        |s| s.section.elements[1].kind = ElementKind::Bend { inside_radius: 1.0, angle_deg: f64::INFINITY },
        |s| s.section.thickness = f64::NAN,
        |s| s.section.elements[0].kind = ElementKind::Line { length: 1e9 },
        |s| s.section.elements[0].kind = ElementKind::Line { length: 1e300 },
        |s| s.stations[0].bends[0].angle_deg = f64::NAN,
    ] {
        let found = bench.with(change);
        assert!(found.diagnostics.iter().any(|d| d.severity == Severity::Error), "{:?}", found.diagnostics);
        assert_eq!(proved(&found), "", "{:?}", found.diagnostics);
    }
    // A bore that is no number concerns the rolls on those shafts alone.
    assert_eq!(proved(&bench.with(|s| s.line.shaft_diameter = f64::NAN)), "3L 3R");
    assert_eq!(proved(&bench.with(|s| s.stations[1].pass_height = -5.0)), others);
}
