//! The wall at places along the shell.

use super::Subject;
use crate::geometry::{Point, Vector};
use crate::papers::number::fixed;
use crate::spinning::Station;

/// Places that are listed, ends included.
const PLACES: u32 = 9;

/// One place that is listed.
pub(super) struct Wall {
    /// Number on the drawing.
    pub(super) number: u32,
    /// Inside of the shell, mm.
    pub(super) inside: Point,
    /// Outside of the shell, mm.
    pub(super) outside: Point,
    /// From the finished tip's inside along the axis, inside diameter, angle to the axis, wall, reduction.
    pub(super) cells: [String; 5],
}

/// Places from tip to base, equally far apart along the wall.
pub(super) fn walls(subject: &Subject<'_>) -> Vec<Wall> {
    let stations = &subject.made.shape.stations;
    let length = stations.last().map_or(0.0, |s| s.along);
    let tip = subject.made.shape.tip().z;
    (0..PLACES)
        .filter_map(|k| Some((k + 1, at(stations, length * f64::from(k) / f64::from(PLACES - 1))?)))
        .map(|(number, place)| {
            let outward = Vector::new(place.half_angle.sin(), place.half_angle.cos());
            let cells = [
                fixed(tip - place.at.z, subject.unit()),
                fixed(2.0 * place.at.r, subject.unit()),
                format!("{:.2}°", place.half_angle.to_degrees()),
                fixed(place.wall, subject.unit()),
                format!("{:.1} %", 100.0 * place.reduction),
            ];
            Wall { number, inside: place.at, outside: place.at + outward * place.wall, cells }
        })
        .collect()
}

/// The place so far along the wall, between two stations in proportion.
fn at(stations: &[Station], along: f64) -> Option<Station> {
    let next = stations.partition_point(|s| s.along < along);
    let b = stations.get(next).or(stations.last())?;
    let a = next.checked_sub(1).and_then(|i| stations.get(i)).unwrap_or(b);
    let share = if b.along > a.along { ((along - a.along) / (b.along - a.along)).clamp(0.0, 1.0) } else { 1.0 };
    let between = |x: f64, y: f64| x + (y - x) * share;
    Some(Station {
        at: a.at + (b.at - a.at) * share,
        along,
        half_angle: between(a.half_angle, b.half_angle),
        wall: between(a.wall, b.wall),
        reduction: between(a.reduction, b.reduction),
    })
}
