//! A suggested flower: how many stations, and which angles there.
//!
//! Guide values for a roll designer to begin with. The number of stations comes from the forming-angle method (the strip is
//! as long as the height of the leg times cot 1°25') or from the mean strain of the edges staying below the yield strain.

mod sequence;

use super::bends::{BendState, Stage, angles_deg, bend_states};
use super::strain::{legs, limit, strain_between};
use super::strip::Strip;
use crate::document::{BendAngle, FormingLine, RollSet, Station};
use std::collections::BTreeMap;

pub use sequence::Sequence;

/// Forming angle for carbon steel, 1°25', radians.
const FORMING_ANGLE_RAD: f64 = (1.0 + 25.0 / 60.0) * std::f64::consts::PI / 180.0;

/// Most stations that are suggested.
pub const MOST_STATIONS: usize = 100;

/// Legs that differ by less than this are bent as a pair, mm.
const PAIR_MM: f64 = 0.5;

/// Which bends are bent first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Order {
    /// All bends together, from the first station to the last.
    #[default]
    Together,
    /// One pair of bends after the other, from the edges inwards.
    EdgesFirst,
}

impl Order {
    /// All orders in the order of a list.
    pub const ALL: [Self; 2] = [Self::Together, Self::EdgesFirst];

    /// Name for people.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Together => "all bends together",
            Self::EdgesFirst => "from the edges inwards",
        }
    }
}

/// What a suggestion is made by.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Choice {
    /// How the angles grow.
    pub sequence: Sequence,
    /// Which bends are bent first.
    pub order: Order,
}

/// Stations that a leg of this height needs on a line of this pitch by the forming-angle method.
#[must_use]
pub fn stations_by_forming_angle(height: f64, pitch: f64) -> usize {
    let stations = (height / FORMING_ANGLE_RAD.tan() / pitch).ceil();
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped to 1..=MOST_STATIONS")]
    if stations.is_nan() { 1 } else { stations.clamp(1.0, MOST_STATIONS as f64) as usize }
}

/// Number of stations by the forming-angle method: by the height of the section if all bends are bent together, by the sum
/// over the legs if they are bent one after the other. The set is in mm.
#[must_use]
pub fn count_by_forming_angle(set: &RollSet, order: Order) -> usize {
    let pitch = set.line.station_pitch;
    match order {
        Order::Together => {
            let bounds = Strip::at(set, Stage::Finished).mean().bounds();
            stations_by_forming_angle(bounds.map_or(0.0, |b| b.max.r - b.min.r), pitch)
        }
        Order::EdgesFirst => {
            let of_group = |group: &Group| stations_by_forming_angle(group.height, pitch);
            groups(set).iter().map(of_group).sum::<usize>().clamp(1, MOST_STATIONS)
        }
    }
}

/// The least number of stations at which the mean strain of the edges stays below the yield strain everywhere; `None` if
/// even [`MOST_STATIONS`] are too few, or pitch or material are without figures. The set is in mm.
#[must_use]
pub fn count_by_edge_strain(set: &RollSet, choice: Choice) -> Option<usize> {
    let is_enough = |count: usize| worst_strain(set, choice, count).is_some_and(|strain| strain <= limit(&set.strip));
    if !is_enough(MOST_STATIONS) {
        return None;
    }
    let (mut too_few, mut enough) = (0, MOST_STATIONS);
    while enough - too_few > 1 {
        let middle = usize::midpoint(too_few, enough);
        if is_enough(middle) { enough = middle } else { too_few = middle }
    }
    Some(enough)
}

fn worst_strain(set: &RollSet, choice: Choice, count: usize) -> Option<f64> {
    let suggested = RollSet { stations: with_bends(&[], &set.line, angles(set, choice, count)), ..set.clone() };
    let states: Vec<BTreeMap<u32, BendState>> = std::iter::once(Stage::Flat)
        .chain((0..count).map(Stage::Station))
        .map(|stage| bend_states(&suggested, stage))
        .collect();
    let strains = states.windows(2).map(|pair| match pair {
        [from, to] => strain_between(&suggested, from, to).map(|s| s.mean),
        _ => None,
    });
    strains.reduce(|a, b| Some(a?.max(b?)))?
}

/// The angles of every station for this number of stations, of the bends that change there. The set is in mm.
#[must_use]
pub fn angles(set: &RollSet, choice: Choice, count: usize) -> Vec<Vec<BendAngle>> {
    let finished = angles_deg(set, Stage::Finished);
    let groups = match choice.order {
        Order::Together => vec![Group { bends: finished.keys().copied().collect(), leg: 0.0, height: 1.0 }],
        Order::EdgesFirst => groups(set),
    };
    let mut last: BTreeMap<u32, f64> = BTreeMap::new();
    (1..=count.min(MOST_STATIONS))
        .map(|station| {
            let mut changed = changed_at(&groups, &finished, choice.sequence, station as f64 / count as f64);
            changed.retain(|bend| last.insert(bend.element, bend.angle_deg) != Some(bend.angle_deg));
            changed
        })
        .collect()
}

/// The angles at a part of the way through all groups, of the groups that have begun.
fn changed_at(groups: &[Group], finished: &BTreeMap<u32, f64>, sequence: Sequence, part: f64) -> Vec<BendAngle> {
    let whole: f64 = groups.iter().map(|group| group.height).sum();
    let mut before = 0.0;
    let mut changed = Vec::new();
    for group in groups {
        let progress = ((part * whole - before) / group.height + ROUNDING).min(1.0);
        before += group.height;
        if progress > 2.0 * ROUNDING {
            let done = if progress > 1.0 - 2.0 * ROUNDING { 1.0 } else { progress };
            changed.extend(group.bends.iter().filter_map(|&element| {
                let angle = sequence.angle_rad(finished.get(&element)?.to_radians(), done).to_degrees();
                Some(BendAngle { element, angle_deg: tidy(angle) })
            }));
        }
    }
    changed
}

/// Parts of a way that differ by less are the same.
const ROUNDING: f64 = 1e-9;

/// Angles are suggested to a tenth of a degree, as people set them; the finished angle is kept as it is by its sequence.
fn tidy(angle_deg: f64) -> f64 {
    let tidied = (angle_deg * 10.0).round() / 10.0;
    if (tidied - angle_deg).abs() < ROUNDING || tidied == 0.0 { angle_deg } else { tidied }
}

/// Bends with like legs, bent as one.
struct Group {
    bends: Vec<u32>,
    /// Length of the shortest leg, mm.
    leg: f64,
    /// Height to which the highest leg rises, mm.
    height: f64,
}

/// The bends from the edges inwards.
fn groups(set: &RollSet) -> Vec<Group> {
    let finished = angles_deg(set, Stage::Finished);
    let mut legs = legs(&Strip::at(set, Stage::Finished));
    legs.sort_by(|a, b| a.2.total_cmp(&b.2));
    let mut groups: Vec<Group> = Vec::new();
    for (element, _, leg) in legs {
        let angle = finished.get(&element).map_or(0.0, |a| a.abs().to_radians());
        let height = (leg * angle.min(std::f64::consts::FRAC_PI_2).sin()).max(ROUNDING);
        match groups.last_mut().filter(|group| leg - group.leg < PAIR_MM) {
            Some(group) => {
                group.height = group.height.max(height);
                if !group.bends.contains(&element) {
                    group.bends.push(element);
                }
            }
            None => groups.push(Group { bends: vec![element], leg, height }),
        }
    }
    groups
}

/// Stations with these angles: the present ones as far as there are any, with all that their rolls are designed by, and
/// more like the last of them. Works in any unit.
#[must_use]
pub fn with_bends(present: &[Station], line: &FormingLine, angles: Vec<Vec<BendAngle>>) -> Vec<Station> {
    let mut id = present.iter().map(|station| station.id).max().unwrap_or(0);
    let like = present.last().cloned().unwrap_or_else(|| Station::new(0, line));
    let mut stations = Vec::with_capacity(angles.len());
    for (index, bends) in angles.into_iter().enumerate() {
        let station = present.get(index).cloned().unwrap_or_else(|| {
            id = id.saturating_add(1);
            Station { id, ..like.clone() }
        });
        stations.push(Station { bends, ..station });
    }
    stations
}

#[cfg(test)]
mod tests;
