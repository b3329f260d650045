//! Strain of the strip's edges from station to station.
//!
//! Guide values, by two formulas that differ manifold: the mean strain of an edge that runs straight from station to
//! station, and the peak where it runs along the deformation length of a bend that is formed with the least work. They
//! rank flowers; they do not predict a strain. The limit beside them is the yield strain `Y/E`.

use super::bends::{BendState, Stage, bend_states};
use super::strip::{Side, Strip};
use crate::document::{RollSet, StripMaterial};
use crate::geometry::Point;
use std::collections::BTreeMap;

/// Parts into which the way of an edge between two stations is divided.
const STEPS: u32 = 8;

/// Strain of the edges on the way to a station.
#[derive(Debug, Clone, PartialEq)]
pub struct StationStrain {
    /// Way of the left and the right edge across the line, mm.
    pub edge_way: [f64; 2],
    /// Mean strain of the edge that is strained more.
    pub mean: f64,
    /// Largest peak strain of all bends.
    pub peak: f64,
    /// The bends that change, with their legs.
    pub bends: Vec<BendStrain>,
}

/// What the bending of one leg does to its edge.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BendStrain {
    /// Id of the element.
    pub element: u32,
    /// Its side of the origin.
    pub side: Side,
    /// Length of the leg, mm: from the middle of the bend to the nearer edge, along the strip.
    pub leg: f64,
    /// Change of the angle, radians, without sign.
    pub step_rad: f64,
    /// Length over which the leg is deformed, mm.
    pub deformation_length: f64,
    /// Peak strain of the leg's edge.
    pub peak: f64,
}

/// Strain at which the material yields, `Y/E`.
#[must_use]
pub fn limit(material: &StripMaterial) -> f64 {
    material.yield_strength_mpa / (material.youngs_modulus_gpa * 1000.0)
}

/// Mean strain of an edge that goes `way` across the line from one station to the next, both in mm.
#[must_use]
pub fn mean_strain(way: f64, pitch: f64) -> f64 {
    (way / pitch).hypot(1.0) - 1.0
}

/// Length over which a leg is deformed with the least work of bending and stretching, mm: `a·√(8·a·Δθ/(3·t))`.
#[must_use]
pub fn deformation_length(leg: f64, step_rad: f64, thickness: f64) -> f64 {
    leg * (8.0 * leg * step_rad / (3.0 * thickness)).sqrt()
}

/// Peak strain of a leg's edge: `3·t·Δθ/(4·a)`; where the deformation length exceeds the pitch, `2·a²·Δθ²/D²`.
#[must_use]
pub fn peak_strain(leg: f64, step_rad: f64, thickness: f64, pitch: f64) -> f64 {
    let length = deformation_length(leg, step_rad, thickness).min(pitch);
    if length > 0.0 { 2.0 * (leg * step_rad / length).powi(2) } else { 0.0 }
}

/// Strain on the way to a station, by its index; `None` if there is none, or no pitch to divide by. The set is in mm.
#[must_use]
pub fn station_strain(set: &RollSet, index: usize) -> Option<StationStrain> {
    set.stations.get(index)?;
    let before = index.checked_sub(1).map_or(Stage::Flat, Stage::Station);
    strain_between(set, &bend_states(set, before), &bend_states(set, Stage::Station(index)))
}

/// Strain on the way from bends to bends over one pitch.
pub(super) fn strain_between(set: &RollSet, from: &States, to: &States) -> Option<StationStrain> {
    let (pitch, thickness) = (set.line.station_pitch, set.section.thickness);
    if !(pitch > 0.0 && thickness > 0.0) {
        return None;
    }
    let edge_way = edge_way(set, from, to);
    let bends: Vec<BendStrain> = legs(&Strip::with_bends(set, to))
        .into_iter()
        .filter_map(|(element, side, leg)| {
            let step_rad = (to.get(&element)?.angle_rad - from.get(&element)?.angle_rad).abs();
            let deformation_length = deformation_length(leg, step_rad, thickness);
            let peak = peak_strain(leg, step_rad, thickness, pitch);
            (step_rad > 0.0).then_some(BendStrain { element, side, leg, step_rad, deformation_length, peak })
        })
        .collect();
    Some(StationStrain {
        edge_way,
        mean: mean_strain(edge_way[0].max(edge_way[1]), pitch),
        peak: bends.iter().map(|b| b.peak).fold(0.0, f64::max),
        bends,
    })
}

type States = BTreeMap<u32, BendState>;

/// Way of the left and the right edge across the line while the bends change evenly, mm.
fn edge_way(set: &RollSet, from: &States, to: &States) -> [f64; 2] {
    let mut last: Option<[Point; 2]> = None;
    let mut way = [0.0; 2];
    for step in 0..=STEPS {
        let states = between(from, to, f64::from(step) / f64::from(STEPS), set.section.thickness);
        let Some(edges) = edges(&Strip::with_bends(set, &states)) else { return way };
        if let Some(last) = last {
            for ((way, a), b) in way.iter_mut().zip(last).zip(edges) {
                *way += a.distance(b);
            }
        }
        last = Some(edges);
    }
    way
}

fn edges(strip: &Strip) -> Option<[Point; 2]> {
    Some([strip.pieces.first()?.mean.start(), strip.pieces.last()?.mean.end()])
}

/// The bends at a part of the way between two stages.
#[must_use]
pub fn between(from: &States, to: &States, part: f64, thickness: f64) -> States {
    let state = |to: &BendState| {
        // A flat bend begins with the parts that it is going to have, and the other way round.
        let from = from.get(&to.element).map_or(*to, |from| if from.angle_rad == 0.0 { flattened(to) } else { *from });
        let to = if to.angle_rad == 0.0 { flattened(&from) } else { *to };
        let mix = |a: f64, b: f64| a + (b - a) * part;
        let mixed = BendState {
            leading: mix(from.leading, to.leading),
            arc: mix(from.arc, to.arc),
            trailing: mix(from.trailing, to.trailing),
            ..to
        };
        mixed.at_angle(mix(from.angle_rad, to.angle_rad), thickness)
    };
    to.iter().map(|(&id, to)| (id, state(to))).collect()
}

/// The bend with the same parts, but not bent.
const fn flattened(bend: &BendState) -> BendState {
    BendState { angle_rad: 0.0, inside_radius: f64::INFINITY, ..*bend }
}

/// Element, side and leg of every bend that is bent, from left to right.
pub(super) fn legs(strip: &Strip) -> Vec<(u32, Side, f64)> {
    let whole = strip.mean_length();
    let mut along = 0.0;
    let mut found = Vec::new();
    for piece in &strip.pieces {
        let length = piece.mean.length();
        if piece.is_bent() {
            let from_left = along + length / 2.0;
            found.push((piece.element, piece.side, from_left.min(whole - from_left)));
        }
        along += length;
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::Origin;
    use crate::rollform::fixtures::{bend, line, published, set, station};

    #[test]
    fn figures_of_the_checked_cases() {
        let step = 15.0_f64.to_radians();
        assert!((deformation_length(50.0, step, 2.0) - 208.9).abs() < 0.05);
        assert!((mean_strain(50.0 * step, 300.0) - 0.000_95).abs() < 0.000_005);
        assert!((peak_strain(50.0, step, 2.0, 300.0) - 0.007_85).abs() < 0.000_005);
        // 3·t·Δθ/(4·a), the same figure in its shorter form.
        assert!((peak_strain(50.0, step, 2.0, 300.0) - 3.0 * 2.0 * step / 200.0).abs() < 1e-12);
    }

    #[test]
    fn a_short_pitch_strains_more() {
        let step = 15.0_f64.to_radians();
        assert!((peak_strain(50.0, step, 2.0, 100.0) - 2.0 * (50.0 * step / 100.0_f64).powi(2)).abs() < 1e-12);
    }

    /// A channel with sharp bends: its legs turn about fixed points.
    fn channel(angles: &[f64]) -> RollSet {
        let elements = vec![line(1, 50.0), bend(2, 0.0, 90.0), line(3, 50.0)];
        let stations = (1..).zip(angles).map(|(id, &a)| station(id, &[(2, a)])).collect();
        set(0.002, Origin::Symmetrical, elements, stations)
    }

    #[test]
    fn edge_of_a_sharp_channel_goes_along_an_arc() {
        let found = station_strain(&channel(&[15.0, 45.0]), 1).unwrap();
        let arc = 50.0 * 30.0_f64.to_radians();
        for way in found.edge_way {
            // Eight chords for an arc of 30 degrees.
            assert!((way / arc - 1.0).abs() < 0.0005, "{way} {arc}");
        }
        assert!((found.mean - mean_strain(arc, 300.0)).abs() < 0.00001);
        assert_eq!(found.bends.iter().map(|b| b.side).collect::<Vec<_>>(), [Side::Left, Side::Right]);
    }

    #[test]
    fn a_station_that_bends_nothing_strains_nothing() {
        let found = station_strain(&channel(&[45.0, 45.0]), 1).unwrap();
        assert_eq!((found.edge_way, found.mean, found.peak), ([0.0; 2], 0.0, 0.0));
        assert!(found.bends.is_empty());
        assert!(station_strain(&channel(&[45.0]), 1).is_none());
    }

    #[test]
    fn published_stations_have_strains_on_both_sides_alike() {
        for index in 0..3 {
            let found = station_strain(&published(), index).unwrap();
            assert!((found.edge_way[0] - found.edge_way[1]).abs() < 1e-9);
            assert!(found.mean > 0.0 && found.peak > found.mean);
        }
    }

    #[test]
    fn without_a_pitch_there_is_no_strain() {
        let mut set = published();
        set.line.station_pitch = 0.0;
        assert!(station_strain(&set, 0).is_none());
    }
}
