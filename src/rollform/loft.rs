//! The strip through the whole line as a body: its cross-sections one behind the other.
//!
//! From the flat strip one station distance before the first station, through every station, to half a distance behind the last
//! one. Between two stations the bend angles go smoothly from those of one to those of the other: a picture, no
//! prediction of how the strip deforms.

use super::bends::{Stage, bend_states};
use super::strain::between;
use super::strip::{Piece, Strip};
use crate::document::RollSet;
use crate::geometry::Point;

/// Parts of the way between two stations, at most.
const STEPS: usize = 8;
/// Parts of a bend.
const PARTS: u32 = 8;
/// Cross-sections and points across at most: more cannot be seen.
const MOST_SECTIONS: usize = 400;
const MOST_POINTS: usize = 400;

/// The strip at a place along the line.
#[derive(Debug, Clone, PartialEq)]
pub struct LoftSection {
    /// Distance along the line from the first station, downstream, mm.
    pub along: f64,
    /// Index of the station, if there is one here.
    pub station: Option<usize>,
    /// Points of the bottom face from left to right.
    pub bottom: Vec<Point>,
    /// Points of the top face, one above each of the bottom face.
    pub top: Vec<Point>,
}

/// The cross-sections of a set in mm, upstream first, all with as many points. None without a strip or stations.
#[must_use]
pub fn loft(set: &RollSet) -> Vec<LoftSection> {
    let stations = set.stations.len();
    let pitch = set.line.station_pitch;
    let usable = pitch.is_finite() && pitch > 0.0 && set.section.thickness > 0.0;
    if stations == 0 || !usable {
        return Vec::new();
    }
    let steps = (MOST_SECTIONS / stations).clamp(1, STEPS);
    let stages: Vec<_> = std::iter::once(Stage::Flat)
        .chain((0..stations).step_by(stations.div_ceil(MOST_SECTIONS)).map(Stage::Station))
        .map(|stage| (stage, bend_states(set, stage)))
        .collect();
    let mut sections = Vec::new();
    for (from, to) in stages.iter().zip(stages.iter().skip(1)) {
        for step in 0..steps {
            let part = step as f64 / steps as f64;
            let strip = Strip::with_bends(set, &between(&from.1, &to.1, smooth(part), set.section.thickness));
            let along = place(from.0) + (place(to.0) - place(from.0)) * part;
            let station = if let (0, Stage::Station(index)) = (step, from.0) { Some(index) } else { None };
            sections.push(section(&strip, along * pitch, station));
        }
    }
    if let Some((stage, bends)) = stages.last() {
        let (strip, station) = (Strip::with_bends(set, bends), stations - 1);
        sections.push(section(&strip, place(*stage) * pitch, Some(station)));
        sections.push(section(&strip, (place(*stage) + 0.5) * pitch, None));
    }
    alike(sections)
}

/// Place of a stage in station distances from the first station.
fn place(stage: Stage) -> f64 {
    if let Stage::Station(index) = stage { index as f64 } else { -1.0 }
}

/// From 0 to 1 with level ends.
fn smooth(part: f64) -> f64 {
    part * part * (3.0 - 2.0 * part)
}

fn section(strip: &Strip, along: f64, station: Option<usize>) -> LoftSection {
    let (mut bottom, mut top) = (Vec::new(), Vec::new());
    for element in strip.pieces.chunk_by(|a, b| (a.element, a.side) == (b.element, b.side)) {
        let parts =
            if element.iter().any(Piece::is_bent) || element.iter().any(|p| p.kind != super::strip::PieceKind::Line) {
                PARTS
            } else {
                1
            };
        let from = u32::from(!bottom.is_empty());
        for step in from..=parts {
            let (low, high) = faces(element, f64::from(step) / f64::from(parts));
            bottom.push(low);
            top.push(high);
        }
    }
    LoftSection { along, station, bottom, top }
}

/// The points of both faces at a part of the length of these pieces.
fn faces(pieces: &[Piece], part: f64) -> (Point, Point) {
    let mut left = part * pieces.iter().map(|p| p.mean.length()).sum::<f64>();
    for (index, piece) in pieces.iter().enumerate() {
        let length = piece.mean.length();
        if left <= length || index + 1 == pieces.len() {
            let t = if length > 0.0 { (left / length).clamp(0.0, 1.0) } else { 0.0 };
            return (piece.bottom.point_at(t), piece.top.point_at(t));
        }
        left -= length;
    }
    Default::default()
}

/// The sections that have as many points as the first one, with at most so many of them.
fn alike(sections: Vec<LoftSection>) -> Vec<LoftSection> {
    let count = sections.first().map_or(0, |s| s.bottom.len());
    let finite = |s: &LoftSection| s.bottom.iter().chain(&s.top).all(|p| p.is_finite());
    let stride = count.div_ceil(MOST_POINTS).max(1);
    let thinned = |points: Vec<Point>| {
        let last = points.len().saturating_sub(1);
        points.into_iter().enumerate().filter(|(k, _)| k % stride == 0 || *k == last).map(|(_, p)| p).collect()
    };
    let kept = sections.into_iter().filter(|s| s.bottom.len() == count && count > 1 && finite(s));
    kept.map(|s| LoftSection { bottom: thinned(s.bottom), top: thinned(s.top), ..s }).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rollform::fixtures::{line, published, vee};

    #[test]
    fn stations_stand_where_they_are_with_their_own_strip() {
        let set = published();
        let sections = loft(&set);
        assert_eq!(sections.len(), 3 * STEPS + 2);
        assert!(sections.windows(2).all(|w| w[0].along < w[1].along));
        for (index, place) in [0.0, 300.0, 600.0].into_iter().enumerate() {
            let at = sections.iter().find(|s| s.station == Some(index)).unwrap();
            let strip = Strip::at(&set, Stage::Station(index));
            assert!((at.along - place).abs() < 1e-9);
            assert!(at.bottom[0].distance(strip.pieces[0].bottom.start()) < 1e-9);
            let ends = (at.top.last().unwrap(), strip.pieces.last().unwrap().top.end());
            assert!(ends.0.distance(ends.1) < 1e-9);
        }
    }

    #[test]
    fn faces_are_the_thickness_apart_and_the_flat_strip_is_flat() {
        let sections = loft(&vee(&[30.0, 60.0, 90.0]));
        for s in &sections {
            assert!(s.bottom.iter().zip(&s.top).all(|(a, b)| (a.distance(*b) - 1.0).abs() < 1e-9));
        }
        let heights: Vec<f64> = sections[0].bottom.iter().map(|p| p.r).collect();
        assert!(heights.iter().all(|r| (r - heights[0]).abs() < 1e-9), "{heights:?}");
        assert_eq!(sections[0].along, -300.0);
    }

    #[test]
    fn nothing_to_loft_is_nothing_and_much_is_thinned() {
        assert!(loft(&vee(&[])).is_empty());
        let mut set = vee(&[90.0]);
        set.line.station_pitch = f64::NAN;
        assert!(loft(&set).is_empty());
        let mut set = vee(&[90.0; 900]);
        set.section.elements.extend((10..2010).map(|id| line(id, 1.0)));
        let sections = loft(&set);
        assert!(
            sections.len() <= MOST_SECTIONS + 2 && sections[0].bottom.len() <= MOST_POINTS + 2,
            "{}",
            sections.len()
        );
    }
}
