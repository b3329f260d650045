//! Drive diameters: with which diameters the rolls of a station drive the strip, and how fast their surfaces run.
//!
//! A roll has many diameters, and the strip runs as fast as the surface that grips it best: the widest and most level part of
//! the drive surface. The diameter there, in its middle, is the drive diameter (in practice also pitch diameter). Surface
//! speed `v = π · D · n`; two geared rolls run alike if their drive diameters are inversely as the speeds of their shafts.

use super::Roll;
use super::roll::DriveZone;
use super::roll::drive::drive_zone;
use super::strip::Strip;
use crate::document::{ElementName, RollKind, RollSet, Station};
use crate::geometry::{Point, Segment};
use std::f64::consts::PI;

/// Points of a contour closer than this are one, mm.
const SAME_MM: f64 = 1e-9;

/// Drive diameters of a station, mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DriveDiameters {
    /// Where the rolls grip the strip best.
    pub zone: DriveZone,
    /// Diameter of the bottom roll there; absent if it does not reach there.
    pub bottom: Option<f64>,
    /// Diameter of the top roll there.
    pub top: Option<f64>,
    /// Speed of the top shaft divided by that of the bottom shaft, if they are geared.
    pub gear_ratio: Option<f64>,
}

impl DriveDiameters {
    /// Those of a station with these rolls, edits and rolls used again included. The set is in mm.
    #[must_use]
    pub fn of(set: &RollSet, station: &Station, strip: &Strip, rolls: &[Roll]) -> Option<Self> {
        let zone = drive_zone(strip, station, set.section.origin)?;
        let diameter = |kind| {
            let roll = rolls.iter().find(|roll| roll.roll.kind == kind)?;
            Some(2.0 * radius_at(roll, zone.middle())?)
        };
        let gear_ratio = station.gear_ratio.or(set.line.gear_ratio);
        Some(Self { zone, bottom: diameter(RollKind::Bottom), top: diameter(RollKind::Top), gear_ratio })
    }

    /// The gear ratio with which both surfaces run alike: bottom by top diameter.
    #[must_use]
    pub fn fitting_ratio(&self) -> Option<f64> {
        Some(self.bottom? / self.top.filter(|top| *top > 0.0)?)
    }

    /// By how much the top roll's surface runs faster than the bottom roll's, as a part of the latter's speed; less than 0
    /// if it runs slower. `None` if they are not geared.
    #[must_use]
    pub fn top_runs_faster_by(&self) -> Option<f64> {
        Some(self.gear_ratio? / self.fitting_ratio()? - 1.0)
    }

    /// Surface speeds of bottom and top roll, m/min, at this speed of the bottom shaft; that of a top roll that is not geared
    /// is not known.
    #[must_use]
    pub fn surface_speeds(&self, bottom_rpm: f64) -> (Option<f64>, Option<f64>) {
        let top = self.top.zip(self.gear_ratio);
        (
            self.bottom.map(|d| surface_speed_m_per_min(d, bottom_rpm)),
            top.map(|(d, ratio)| surface_speed_m_per_min(d, bottom_rpm * ratio)),
        )
    }
}

/// `v = π · D · n`, m/min, of a diameter in mm at a speed in rev/min.
#[must_use]
pub fn surface_speed_m_per_min(diameter_mm: f64, rpm: f64) -> f64 {
    PI * diameter_mm * rpm / 1000.0
}

/// Radius of a roll at a place across the line; the largest where it has a face there.
fn radius_at(roll: &Roll, z: f64) -> Option<f64> {
    let surface = || roll.elements.iter().filter(|e| !e.names.iter().any(|n| matches!(n, ElementName::Flank { .. })));
    let largest = surface().map(|e| e.segment.bounds().max.r).fold(0.0, f64::max);
    let at = roll.frame.point_to_roll(Point::new(z, 0.0)).z;
    let upright = Segment::line(Point::new(at, 0.0), Point::new(at, largest + 1.0));
    let meets = surface().flat_map(|e| upright.intersection(&e.segment, SAME_MM).points());
    meets.map(|p| p.r).max_by(f64::total_cmp)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::RollRef;
    use crate::rollform::design;
    use crate::rollform::fixtures::published_rolls;

    fn at(set: &RollSet, station: usize) -> DriveDiameters {
        design("x", set).stations[station].drive.unwrap()
    }

    #[test]
    fn published_rolls_drive_with_the_diameters_of_their_base() {
        let set = published_rolls();
        // Pass heights 71.755, 74.295, 76.200; what is left of the distance of the axes is the top roll's.
        let bottoms = [143.51, 148.59, 152.4];
        let tops = [2.0 * 55.888, 2.0 * 55.888, 2.0 * 55.566];
        for (station, (bottom, top)) in bottoms.into_iter().zip(tops).enumerate() {
            let drive = at(&set, station);
            assert!((drive.bottom.unwrap() - bottom).abs() < 1e-9, "{drive:?}");
            assert!((drive.top.unwrap() - top).abs() < 1e-9, "{drive:?}");
            assert!(drive.zone.middle().abs() < 1e-9 && drive.zone.to > 40.0);
        }
    }

    #[test]
    fn surfaces_run_alike_at_the_fitting_ratio() {
        let mut set = published_rolls();
        assert_eq!(at(&set, 0).top_runs_faster_by(), None);
        set.line.gear_ratio = at(&set, 0).fitting_ratio();
        assert!(at(&set, 0).top_runs_faster_by().unwrap().abs() < 1e-12);
        let (bottom, top) = at(&set, 0).surface_speeds(50.0);
        assert!((bottom.unwrap() - PI * 143.51 * 0.05).abs() < 1e-9 && (top.unwrap() - bottom.unwrap()).abs() < 1e-9);
        // The next station has the same top roll on a larger bottom roll.
        assert!((at(&set, 1).top_runs_faster_by().unwrap() - (143.51 / 148.59 - 1.0)).abs() < 1e-9);
        set.stations[1].gear_ratio = at(&set, 1).fitting_ratio();
        assert!(at(&set, 1).top_runs_faster_by().unwrap().abs() < 1e-12);
    }

    #[test]
    fn an_edited_roll_drives_with_the_diameter_it_has_then() {
        use crate::document::{EditAction, NewElement, PieceKind, RollEdit, RollPoint, Side};
        let mut set = published_rolls();
        let roll = RollRef { station: 1, kind: RollKind::Bottom };
        let element = ElementName::Strip { element: 1, side: Side::Right, kind: PieceKind::Line };
        let point = RollPoint { z: 70.0, diameter: 143.0 };
        let shape = NewElement::LineAngle { point, angle_deg: 0.0 };
        set.roll_mut(roll).edits = vec![RollEdit { id: 1, action: EditAction::Replace { element, shape } }];
        let drive = at(&set, 0);
        assert!((drive.bottom.unwrap() - 143.0).abs() < 1e-6, "{drive:?}");
    }
}
