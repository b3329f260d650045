//! The flower: group B of the published inputs.

use super::json::{Fields, Reader};
use crate::document::{
    BendAngle, Composite, CrossSection, Element, FixedComposite, Origin, RollSet, Sharpening, Station,
};
use serde_json::Value;

/// Most stations; the published limit of 50 is none here.
const MOST_STATIONS: i64 = 1000;
/// Most bends of a flower.
const MOST_BENDS: usize = 100_000;

/// Gives a set in mm the stations of a flower. Stations that are there already keep everything but their bends.
pub(super) fn apply(reader: &mut Reader<'_>, fields: &Fields<'_>, set: &mut RollSet) -> Option<()> {
    let count = reader.whole(fields, "NSTAGE", 1, MOST_STATIONS)?;
    let count = usize::try_from(count).ok()?;
    let mut stations: Vec<Station> = Vec::with_capacity(count);
    for (id, index) in (1_u32..).zip(0..count) {
        let station = set.stations.get(index).cloned().unwrap_or_else(|| Station::new(id, &set.line));
        stations.push(Station { bends: Vec::new(), ..station });
    }
    let with_parts = fields.has("JBEND") && reader.whole(fields, "JBEND", 0, 1)? == 1;
    let mut composites = Vec::new();
    for entry in reader.list(fields, "bends", MOST_BENDS) {
        let Some(index) = pass(reader, &entry, "pass", count) else { continue };
        for side in [Side::Left, Side::Right] {
            let Some(bend) = bend(reader, &entry, &set.section, side) else { continue };
            if let Some(station) = stations.get_mut(index) {
                station.bends.push(bend);
            }
            if with_parts {
                composites.extend(parts(reader, &entry, side).map(|percent| (bend.element, index, percent)));
            }
        }
    }
    set.stations = stations;
    set.sharpening = sharpening(reader, fields, set)?;
    set.composites = composites_of(&composites, set);
    fixed_parts(reader, fields, set);
    Some(())
}

/// The columns of the published tables.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Side {
    Left,
    Right,
}

impl Side {
    const fn element_key(self) -> &'static str {
        match self {
            Self::Left => "element_left",
            Self::Right => "element_right",
        }
    }

    const fn angle_key(self) -> &'static str {
        match self {
            Self::Left => "cumulative_angle_left_deg",
            Self::Right => "cumulative_angle_right_deg",
        }
    }

    const fn parts_key(self) -> &'static str {
        match self {
            Self::Left => "IPCL",
            Self::Right => "IPCR",
        }
    }

    const fn fixed_key(self) -> &'static str {
        match self {
            Self::Left => "IECL",
            Self::Right => "IECR",
        }
    }

    /// The list whose numbers a column has.
    fn list(self, section: &CrossSection) -> &[Element] {
        match (section.origin, self) {
            (Origin::CentreRightFirst, Self::Left) | (Origin::CentreLeftFirst, Self::Right) => &section.other_side,
            _ => &section.elements,
        }
    }
}

/// Index of the station that a field gives from 1.
fn pass(reader: &mut Reader<'_>, entry: &Fields<'_>, key: &str, count: usize) -> Option<usize> {
    let number = reader.whole(entry, key, 1, i64::try_from(count).unwrap_or(i64::MAX))?;
    usize::try_from(number).ok()?.checked_sub(1)
}

/// The bend of one side; 0 or no field where that side has none.
fn bend(reader: &mut Reader<'_>, entry: &Fields<'_>, section: &CrossSection, side: Side) -> Option<BendAngle> {
    let element = element(reader, entry, side.element_key(), section, side)?;
    let key = if entry.has(side.angle_key()) { side.angle_key() } else { "cumulative_angle_deg" };
    Some(BendAngle { element, angle_deg: reader.number(entry, key, -360.0, 360.0)? })
}

/// The id of the element whose number a field gives.
fn element(reader: &mut Reader<'_>, entry: &Fields<'_>, key: &str, section: &CrossSection, side: Side) -> Option<u32> {
    if !entry.has(key) {
        return None;
    }
    let list = side.list(section);
    let number = reader.whole(entry, key, 0, i64::try_from(list.len()).unwrap_or(i64::MAX))?;
    list.get(usize::try_from(number).ok()?.checked_sub(1)?).map(|e| e.id)
}

/// The three percentages of a composite bend.
fn parts(reader: &mut Reader<'_>, entry: &Fields<'_>, side: Side) -> Option<[f64; 3]> {
    let key = side.parts_key();
    let list = entry.get(key)?.as_array().map(|list| list.iter().filter_map(Value::as_f64).collect::<Vec<f64>>());
    let percent = list.and_then(|list| <[f64; 3]>::try_from(list).ok());
    if percent.is_none() {
        reader.refuse(&entry.path(key), format!("`{key}` must be a list of 3 numbers, percent."));
    }
    percent
}

fn sharpening(reader: &mut Reader<'_>, fields: &Fields<'_>, set: &RollSet) -> Option<Sharpening> {
    if !fields.has("JSHARP") {
        return Some(Sharpening::None);
    }
    Some(match reader.whole(fields, "JSHARP", -1, 1)? {
        0 => Sharpening::None,
        -1 => Sharpening::AllButLast,
        _ => {
            let numbers: Vec<u64> = fields
                .get("ISQSH")
                .and_then(Value::as_array)
                .map(|list| list.iter().filter_map(Value::as_u64).filter(|n| *n > 0).collect())
                .unwrap_or_default();
            let index = |number: u64| usize::try_from(number).ok()?.checked_sub(1);
            let station = |number: &u64| Some(set.stations.get(index(*number)?)?.id);
            let ids: Vec<u32> = numbers.iter().filter_map(station).collect();
            if ids.len() != numbers.len() || ids.is_empty() {
                let most = set.stations.len();
                reader.refuse("JSHARP", format!("`ISQSH` must list the stations to sharpen, from 1 to {most}."));
            }
            Sharpening::Stations(ids)
        }
    })
}

/// Parts hold from the pass that gives them to the one before the next that gives the same element others.
fn composites_of(given: &[(u32, usize, [f64; 3])], set: &RollSet) -> Vec<Composite> {
    let last_of = |element: u32, from: usize| {
        let next =
            given.iter().filter(|(other, index, _)| *other == element && *index > from).map(|(_, index, _)| *index);
        next.min().map_or(set.stations.len(), |next| next).saturating_sub(1)
    };
    let station = |index: usize| set.stations.get(index).map(|s| s.id);
    let composite = |&(element, index, percent): &(u32, usize, [f64; 3])| {
        let fixed = FixedComposite { first: station(index)?, last: station(last_of(element, index))? };
        Some(Composite { element, percent, fixed: Some(fixed) })
    };
    given.iter().filter_map(composite).collect()
}

/// The stations at which the parts of an element are active, where the file says so.
fn fixed_parts(reader: &mut Reader<'_>, fields: &Fields<'_>, set: &mut RollSet) {
    if !fields.has("ISQCP") {
        return;
    }
    for entry in reader.list(fields, "ISQCP", MOST_BENDS) {
        for side in [Side::Left, Side::Right] {
            let key = side.fixed_key();
            let Some(list) = entry.get(key).and_then(Value::as_array) else { continue };
            let figures: Vec<usize> =
                list.iter().filter_map(Value::as_u64).filter_map(|n| usize::try_from(n).ok()).collect();
            let id_of = |number: usize| side.list(&set.section).get(number.checked_sub(1)?).map(|e| e.id);
            let station = |number: usize| set.stations.get(number.checked_sub(1)?).map(|s| s.id);
            let found = match figures.as_slice() {
                [0, ..] => continue,
                [element, first, last] => id_of(*element).zip(station(*first)).zip(station(*last)),
                _ => None,
            };
            let Some(((element, first), last)) = found else {
                reader.refuse(
                    &entry.path(key),
                    format!("`{key}` must be an element, its first and its last active stage."),
                );
                continue;
            };
            for composite in set.composites.iter_mut().filter(|c| c.element == element) {
                composite.fixed = Some(FixedComposite { first, last });
            }
        }
    }
}
