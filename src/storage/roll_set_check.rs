//! What every set of form-rolls on disk fulfils: finite numbers, ids that are unique, lists of a size that can be shown.

use super::check::Fault;
use crate::diagnostic::Place;
use crate::document::{CrossSection, RollSet, Station};
use serde_json::Value;
use std::collections::BTreeMap;

/// Most elements of a list.
const MOST_ELEMENTS: usize = 10_000;
/// Most stations of a line.
const MOST_STATIONS: usize = 1_000;
/// Where a set lies in its file.
const ROOT: &str = "content.roll_set";

/// Every fault of a set, in the order of the file.
pub(super) fn faults(set: &RollSet, faults: &mut Vec<Fault>) {
    numbers(set, faults);
    let tolerance = set.form_tolerance;
    if tolerance.is_finite() && tolerance <= 0.0 {
        let message = format!("The tolerance is {tolerance}; it must be a number greater than 0.");
        faults.push(fault("form_tolerance", Place::Document, message));
    }
    elements(&set.section, faults);
    stations(&set.stations, faults);
}

fn fault(path: &str, at: Place, message: String) -> Fault {
    Fault { path: format!("{ROOT}.{path}"), at, message }
}

/// Numbers that are not finite: the one thing that a document can have and its file cannot, so that they come out empty.
fn numbers(set: &RollSet, faults: &mut Vec<Fault>) {
    match serde_json::to_value(set) {
        Ok(value) => empty_values(&value, &mut String::new(), set, faults),
        Err(error) => faults.push(fault("", Place::Document, format!("The set cannot be written: {error}."))),
    }
}

fn empty_values(value: &Value, path: &mut String, set: &RollSet, faults: &mut Vec<Fault>) {
    let length = path.len();
    let mut into = |key: &str, child: &Value| {
        if !path.is_empty() {
            path.push('.');
        }
        path.push_str(key);
        empty_values(child, path, set, faults);
        path.truncate(length);
    };
    match value {
        Value::Null => {
            let message = "The value is not a finite number; it must be one.".to_owned();
            faults.push(fault(path, place_of(path, set), message));
        }
        Value::Array(list) => list.iter().enumerate().for_each(|(index, child)| into(&index.to_string(), child)),
        Value::Object(map) => map.iter().for_each(|(key, child)| into(key, child)),
        Value::Bool(_) | Value::Number(_) | Value::String(_) => {}
    }
}

/// The element or station that a path leads into.
fn place_of(path: &str, set: &RollSet) -> Place {
    let keys: Vec<&str> = path.split('.').collect();
    let index = |at: usize| keys.get(at).and_then(|key| key.parse::<usize>().ok());
    let section = &set.section;
    match keys.as_slice() {
        ["section", list @ ("elements" | "other_side"), ..] => {
            let other_side = *list == "other_side";
            let list = if other_side { &section.other_side } else { &section.elements };
            let element = index(2).and_then(|i| Some((i + 1, list.get(i)?)));
            element.map_or(Place::Document, |(number, e)| Place::Element { id: e.id, number, other_side })
        }
        ["stations", ..] => {
            let station = index(1).and_then(|i| Some((i + 1, set.stations.get(i)?)));
            station.map_or(Place::Document, |(number, s)| Place::Station { id: s.id, number })
        }
        _ => Place::Document,
    }
}

fn elements(section: &CrossSection, faults: &mut Vec<Fault>) {
    let mut known = BTreeMap::new();
    for (key, list, other_side) in [("elements", &section.elements, false), ("other_side", &section.other_side, true)] {
        too_many(&format!("section.{key}"), list.len(), MOST_ELEMENTS, faults);
        let places = (1..).zip(list).map(|(number, e)| (e.id, Place::Element { id: e.id, number, other_side }));
        unique(&format!("section.{key}"), places, &mut known, faults);
    }
}

fn stations(stations: &[Station], faults: &mut Vec<Fault>) {
    too_many("stations", stations.len(), MOST_STATIONS, faults);
    let places = (1..).zip(stations).map(|(number, s)| (s.id, Place::Station { id: s.id, number }));
    unique("stations", places, &mut BTreeMap::new(), faults);
}

fn too_many(path: &str, count: usize, most: usize, faults: &mut Vec<Fault>) {
    if count > most {
        let message = format!("The list has {count} entries; the limit is {most}.");
        faults.push(fault(path, Place::Document, message));
    }
}

/// Ids that an entry before has already; `known` has those of the lists before.
fn unique(
    path: &str,
    places: impl Iterator<Item = (u32, Place)>,
    known: &mut BTreeMap<u32, Place>,
    faults: &mut Vec<Fault>,
) {
    for (index, (id, place)) in places.enumerate() {
        if let Some(first) = known.insert(id, place.clone()) {
            let message = format!("There are {first} and {place} with the same id, {id}; every one has its own.");
            faults.push(fault(&format!("{path}.{index}.id"), place, message));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::{ElementKind, Origin};
    use crate::rollform::fixtures::{line, published};

    fn found(change: impl FnOnce(&mut RollSet)) -> Vec<(String, String)> {
        let mut set = published();
        change(&mut set);
        let mut found = Vec::new();
        faults(&set, &mut found);
        found.into_iter().map(|f| (f.path, f.at.to_string())).collect()
    }

    #[test]
    fn the_published_set_can_be_saved() {
        assert_eq!(found(|_| {}), []);
    }

    #[test]
    fn numbers_that_are_not_finite_are_found_wherever_they_are() {
        let names = |path: &str, at: &str| vec![(format!("{ROOT}.{path}"), at.to_owned())];
        assert_eq!(
            found(|s| s.section.elements[2].kind = ElementKind::Line { length: f64::NAN }),
            names("section.elements.2.length", "element 3")
        );
        assert_eq!(
            found(|s| s.stations[1].bends[0].angle_deg = f64::INFINITY),
            names("stations.1.bends.0.angle_deg", "station 2")
        );
        assert_eq!(found(|s| s.line.station_pitch = f64::NAN), names("line.station_pitch", "document"));
        assert_eq!(found(|s| s.form_tolerance = f64::NAN), names("form_tolerance", "document"));
    }

    #[test]
    fn ids_are_unique_over_both_lists() {
        let double = found(|s| {
            s.section.origin = Origin::CentreRightFirst;
            s.section.other_side = vec![line(40, 1.0), line(21, 1.0)];
            s.stations[2].id = 1;
        });
        let paths: Vec<&str> = double.iter().map(|(path, _)| path.as_str()).collect();
        assert_eq!(paths, ["content.roll_set.section.other_side.1.id", "content.roll_set.stations.2.id"]);
    }

    #[test]
    fn tolerance_and_size_have_limits() {
        assert_eq!(found(|s| s.form_tolerance = 0.0).len(), 1);
        let many = found(|s| s.section.elements = (0..10_001).map(|id| line(id, 1.0)).collect());
        assert_eq!(many.len(), 1);
    }
}
