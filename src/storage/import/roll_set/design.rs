//! The roll design: group C of the published inputs.

use super::json::{Fields, MOST, Reader};
use crate::document::{
    CrossSection, DriveSurface, ExtensionContour, ExtensionKind, Face, Origin, Pinch, RollSet, Side, SideEnd, SideRoll,
    Station,
};
use std::collections::BTreeMap;

/// Most entries of a list.
const MOST_ENTRIES: usize = 100_000;

/// Gives the stations of a set in mm what their rolls are designed by.
pub(super) fn apply(reader: &mut Reader<'_>, fields: &Fields<'_>, set: &mut RollSet) -> Option<()> {
    if set.stations.is_empty() {
        reader.refuse("", "The set has no stations yet; read its flower first.");
        return None;
    }
    let heights = reader.object(fields, "pass_height_and_centres")?;
    for (indices, entry) in by_stage(reader, &heights, "stages", set.stations.len()) {
        let height = reader.length_mm(&entry, "PASHT", 0.0)?;
        let distance = reader.length_mm(&entry, "CTOC", 0.0)?;
        on(set, &indices, |s| (s.pass_height, s.centre_distance) = (height, distance));
    }
    tolerances(reader, fields, set)?;
    if let Some(drawing) = fields.has("drawing").then(|| reader.object(fields, "drawing")).flatten() {
        set.line.drawn_gap = reader.length_mm(&drawing, "RGAP", 0.0)?;
    }
    selection(reader, fields, set);
    pinch(reader, fields, set)?;
    sides(reader, fields, set)?;
    extensions(reader, fields, set)
}

/// Changes stations by index.
fn on(set: &mut RollSet, indices: &[usize], change: impl Fn(&mut Station)) {
    for &index in indices {
        if let Some(station) = set.stations.get_mut(index) {
            change(station);
        }
    }
}

/// The entries of a list with the stations that they are for: the one that they name, or all.
fn by_stage<'v>(
    reader: &mut Reader<'_>,
    fields: &Fields<'v>,
    key: &str,
    stations: usize,
) -> Vec<(Vec<usize>, Fields<'v>)> {
    let mut all = Vec::new();
    for entry in reader.list(fields, key, MOST_ENTRIES) {
        if !entry.has("stage") {
            all.push(((0..stations).collect(), entry));
        } else if let Some(index) = stage(reader, &entry, "stage", stations) {
            all.push((vec![index], entry));
        }
    }
    all
}

/// The station whose number a field gives, by index; `None` for 0, which ends a list.
fn stage(reader: &mut Reader<'_>, entry: &Fields<'_>, key: &str, stations: usize) -> Option<usize> {
    let number = reader.whole(entry, key, 0, i64::try_from(stations).unwrap_or(i64::MAX))?;
    usize::try_from(number).ok()?.checked_sub(1)
}

fn tolerances(reader: &mut Reader<'_>, fields: &Fields<'_>, set: &mut RollSet) -> Option<()> {
    let group = reader.object(fields, "tolerances")?;
    let all: Vec<usize> = (0..set.stations.len()).collect();
    let entries =
        if group.has("stages") { by_stage(reader, &group, "stages", set.stations.len()) } else { vec![(all, group)] };
    for (indices, entry) in entries {
        let left = reader.length_mm(&entry, "TOLLH", 0.0)?;
        let right = reader.length_mm(&entry, "TOLRH", 0.0)?;
        on(set, &indices, |s| (s.tolerance_left, s.tolerance_right) = (left, right));
    }
    Some(())
}

/// Which stations have rolls: −1 all, 0 none, or their numbers.
fn selection(reader: &mut Reader<'_>, fields: &Fields<'_>, set: &mut RollSet) {
    let Some(list) = fields.get("JSTAGE").and_then(|v| v.as_array()) else { return };
    let numbers: Vec<i64> = list.iter().filter_map(serde_json::Value::as_i64).collect();
    if numbers.len() != list.len() {
        reader.refuse(&fields.path("JSTAGE"), "`JSTAGE` must be a list of whole numbers.");
    }
    let all = numbers.first() == Some(&-1);
    for (number, station) in (1_i64..).zip(&mut set.stations) {
        station.without_rolls = !all && !numbers.contains(&number);
    }
}

fn pinch(reader: &mut Reader<'_>, fields: &Fields<'_>, set: &mut RollSet) -> Option<()> {
    let group = reader.object(fields, "pinch")?;
    let kind = reader.whole(&group, "JPINCH", -2, 2)?;
    if kind == 0 {
        let all: Vec<usize> = (0..set.stations.len()).collect();
        on(set, &all, |s| s.pinch = Pinch::None);
        return Some(());
    }
    for (indices, entry) in by_stage(reader, &group, "stages", set.stations.len()) {
        let pinch = if kind.abs() == 1 {
            let drive = reader.length_mm(&entry, "PDIM1", 0.0)?;
            Pinch::Gaps { drive, clearance: reader.length_mm(&entry, "PDIM2", 0.0)? }
        } else {
            Pinch::Clearance { added: reader.length_mm(&entry, "CLEAR", 0.0)? }
        };
        on(set, &indices, |s| s.pinch = pinch);
    }
    // Two rows a station: where the drive surface begins and where it ends.
    let mut rows: BTreeMap<usize, [Vec<u32>; 2]> = BTreeMap::new();
    for entry in reader.list(&group, "drive_surface", MOST_ENTRIES) {
        let Some(index) = stage(reader, &entry, "ISQP", set.stations.len()) else { continue };
        let row = rows.entry(index).or_default();
        for (ends, (key, side)) in row.iter_mut().zip([("IEPL", Side::Left), ("IEPR", Side::Right)]) {
            ends.extend(element(reader, &entry, key, &set.section, side));
        }
    }
    for (index, [left, right]) in rows {
        let surface = |ends: &[u32]| Some(DriveSurface { first: *ends.first()?, last: *ends.get(1)? });
        let symmetrical = set.section.origin == Origin::Symmetrical;
        on(set, &[index], |s| {
            s.drive_right = surface(&right);
            s.drive_left = surface(&left).filter(|left| !symmetrical || s.drive_right != Some(*left));
        });
    }
    Some(())
}

/// The id of the element whose number a field gives; `None` for 0.
fn element(reader: &mut Reader<'_>, entry: &Fields<'_>, key: &str, section: &CrossSection, side: Side) -> Option<u32> {
    let list = match (section.origin, side) {
        (Origin::CentreRightFirst, Side::Left) | (Origin::CentreLeftFirst, Side::Right) => &section.other_side,
        _ => &section.elements,
    };
    let most = i64::try_from(list.len()).unwrap_or(i64::MAX);
    let number = reader.whole(entry, key, 0, most)?;
    list.get(usize::try_from(number).ok()?.checked_sub(1)?).map(|e| e.id)
}

fn sides(reader: &mut Reader<'_>, fields: &Fields<'_>, set: &mut RollSet) -> Option<()> {
    let Some(group) = fields.has("side_rolls").then(|| reader.object(fields, "side_rolls")).flatten() else {
        return Some(());
    };
    if reader.whole(&group, "ISROL", 0, 1)? == 0 {
        return Some(());
    }
    let mut axes: BTreeMap<usize, [f64; 2]> = BTreeMap::new();
    for (indices, entry) in by_stage(reader, &group, "axes", set.stations.len()) {
        let pair = [reader.length_mm(&entry, "OTOSL", 0.0)?, reader.length_mm(&entry, "OTOSR", 0.0)?];
        axes.extend(indices.into_iter().map(|index| (index, pair)));
    }
    let mut rows: BTreeMap<usize, [Vec<SideEnd>; 2]> = BTreeMap::new();
    for entry in reader.list(&group, "contour", MOST_ENTRIES) {
        let Some(index) = stage(reader, &entry, "ISQS", set.stations.len()) else { continue };
        let row = rows.entry(index).or_default();
        let keys = [("IESL1", "IESL2", Side::Left), ("IESR1", "IESR2", Side::Right)];
        for (ends, (number, face_key, side)) in row.iter_mut().zip(keys) {
            if let Some(element) = element(reader, &entry, number, &set.section, side) {
                ends.push(SideEnd { element, face: face(reader.whole(&entry, face_key, 1, 4)?) });
            }
        }
    }
    for (index, [left, right]) in rows {
        let [left_axis, right_axis] = axes.get(&index).copied().unwrap_or([MOST; 2]);
        let roll = |ends: &[SideEnd], axis_distance: f64| {
            let (from, to) = (*ends.first()?, *ends.get(1)?);
            Some(SideRoll { axis_distance, from, to, extensions: Vec::new() })
        };
        on(set, &[index], |s| {
            (s.side_left, s.side_right) = (roll(&left, left_axis), roll(&right, right_axis));
        });
    }
    Some(())
}

const fn face(number: i64) -> Face {
    match number {
        1 => Face::Bottom,
        2 => Face::Top,
        3 => Face::Leading,
        _ => Face::Trailing,
    }
}

fn extensions(reader: &mut Reader<'_>, fields: &Fields<'_>, set: &mut RollSet) -> Option<()> {
    let key = "extension_contours";
    let Some(group) = fields.has(key).then(|| reader.object(fields, key)).flatten() else { return Some(()) };
    if reader.whole(&group, "IEXTN", 0, 1)? == 0 {
        return Some(());
    }
    let mut known: BTreeMap<i64, ExtensionContour> = BTreeMap::new();
    for entry in reader.list(&group, "definitions", MOST_ENTRIES) {
        let number = reader.whole(&entry, "ISC1", 0, 1_000_000)?;
        if number == 0 {
            break;
        }
        let kind = kind(reader.whole(&entry, "ISC2", 1, 3)?);
        let mut lengths = [0.0; 4];
        for (part, length) in (1..).zip(&mut lengths) {
            *length = reader.length_mm(&entry, &format!("SCDIM{part}"), 0.0)?;
        }
        known.insert(number, ExtensionContour { kind, lengths });
    }
    for station in &mut set.stations {
        station.extension_left.clear();
        station.extension_right.clear();
    }
    for entry in reader.list(&group, "selection", MOST_ENTRIES) {
        let Some(index) = stage(reader, &entry, "ISQD", set.stations.len()) else { continue };
        for (key, side) in [("IELD2", Side::Left), ("IERD2", Side::Right)] {
            let number = reader.whole(&entry, key, 0, 1_000_000)?;
            let Some(contour) = known.get(&number).copied() else {
                if number != 0 {
                    reader.refuse(&entry.path(key), format!("`{key}` is {number}; no contour has this number."));
                }
                continue;
            };
            on(set, &[index], |s| put(s, side, contour));
        }
    }
    Some(())
}

const fn kind(number: i64) -> ExtensionKind {
    match number {
        1 => ExtensionKind::SideRoll,
        2 => ExtensionKind::SpigotA,
        _ => ExtensionKind::SpigotB,
    }
}

/// Contours of side rolls belong to the side roll, below first, the others to top and bottom roll.
fn put(station: &mut Station, side: Side, contour: ExtensionContour) {
    let (own, roll) = match side {
        Side::Left => (&mut station.extension_left, &mut station.side_left),
        Side::Right => (&mut station.extension_right, &mut station.side_right),
    };
    match roll {
        Some(roll) if contour.kind == ExtensionKind::SideRoll => roll.extensions.push(contour),
        _ => own.push(contour),
    }
}

#[cfg(test)]
mod tests {
    use super::super::roll_design;
    use crate::document::{Content, Document};
    use crate::rollform::fixtures::{published, published_rolls};
    use crate::units::Unit;

    const DESIGN: &str = include_str!("../../../../tests/cases/1470b/1470b-roll-design.json");

    fn document() -> Document {
        Document { turnwright: 1, name: "1470b".to_owned(), unit: Unit::Mm, content: Content::RollSet(published()) }
    }

    #[test]
    fn the_published_input_gives_the_published_rolls() {
        let (read, said) = roll_design("1470b-roll-design.json", DESIGN, document()).unwrap();
        assert_eq!(said, []);
        let Content::RollSet(set) = &read.content else { unreachable!("a set") };
        let names = |set| {
            let design = crate::rollform::design("1470b", set);
            design.rolls().map(|r| (r.name.clone(), r.elements.clone())).collect::<Vec<_>>()
        };
        assert_eq!(names(set), names(&published_rolls()));
    }

    #[test]
    fn wrong_figures_are_named_with_their_line() {
        let broken = DESIGN.replace("\"JPINCH\": -1", "\"JPINCH\": 7");
        let found = roll_design("d.json", &broken, document()).unwrap_err();
        assert!(found.iter().any(|d| d.message.contains("`JPINCH` is 7")), "{found:?}");
        let missing = DESIGN.replace("\"IELD2\": 4", "\"IELD2\": 9");
        assert!(roll_design("d.json", &missing, document()).is_err());
        assert!(roll_design("d.json", "{}", document()).is_err());
    }
}
