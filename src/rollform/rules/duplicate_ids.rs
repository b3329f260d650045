//! Stations, rolls and edits refer to elements and stations by their ids: every one has its own.

use super::subject::Subject;
use crate::diagnostic::{Diagnostic, Place};
use std::collections::BTreeMap;

/// Elements and stations with the id of another one.
pub(super) fn check(subject: &Subject<'_>) -> Vec<Diagnostic> {
    let elements = subject.lists().into_iter().flat_map(|(list, other_side)| {
        (1..).zip(list).map(move |(number, e)| (e.id, Place::Element { id: e.id, number, other_side }))
    });
    let stations = subject.stations().map(|(place, station)| (station.id, place));
    doubles(elements).chain(doubles(stations)).collect()
}

fn doubles(places: impl Iterator<Item = (u32, Place)>) -> impl Iterator<Item = Diagnostic> {
    let mut known = BTreeMap::new();
    let mut found = Vec::new();
    for (id, place) in places {
        if let Some(first) = known.get(&id) {
            let message = format!("The id is {id}, which is that of {first} too; every one has its own.");
            found.push(Diagnostic::error("duplicate-id", place, message).with_related(Place::clone(first)));
        } else {
            known.insert(id, place);
        }
    }
    found.into_iter()
}

#[cfg(test)]
mod tests {
    use super::super::subject::found;
    use super::*;
    use crate::rollform::fixtures::vee;

    #[test]
    fn fires_for_elements_and_stations() {
        let mut set = vee(&[30.0, 90.0]);
        assert!(found(check, &set).is_empty());
        set.section.elements[2].id = 1;
        set.stations[1].id = 1;
        let places: Vec<String> = found(check, &set).iter().map(|d| d.at.to_string()).collect();
        assert_eq!(places, ["element 3", "station 2"]);
    }
}
