//! The flower: the strip at every stage of the line, with what is to be said about each of them.

use super::bends::Stage;
use super::properties::{SectionProperties, properties};
use super::springback::{Springback, released_bends, springback};
use super::strain::{StationStrain, station_strain};
use super::strip::Strip;
use crate::document::RollSet;

/// The strip at all stages: flat, at every station, and finished.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Flower {
    /// The stages in their order.
    pub shapes: Vec<Shape>,
}

/// The strip at a stage.
#[derive(Debug, Clone, PartialEq)]
pub struct Shape {
    /// The stage.
    pub stage: Stage,
    /// The strip between the rolls.
    pub strip: Strip,
    /// The strip after the rolls, sprung back. A guide value.
    pub released: Strip,
    /// What every bend does when it leaves the stage. Guide values.
    pub springback: Vec<Springback>,
    /// Strain of the edges on the way here from the station before; `None` but at stations. Guide values.
    pub strain: Option<StationStrain>,
    /// Properties of the section; `None` without length or thickness.
    pub properties: Option<SectionProperties>,
}

impl Flower {
    /// The flower of a set in mm.
    #[must_use]
    pub fn of(set: &RollSet) -> Self {
        Self { shapes: stages(set).map(|stage| Shape::of(set, stage)).collect() }
    }

    /// The strip at a stage.
    #[must_use]
    pub fn at(&self, stage: Stage) -> Option<&Shape> {
        self.shapes.iter().find(|shape| shape.stage == stage)
    }

    /// The strip at the stations, in their order.
    pub fn stations(&self) -> impl Iterator<Item = &Shape> {
        self.shapes.iter().filter(|shape| matches!(shape.stage, Stage::Station(_)))
    }
}

impl Shape {
    /// The strip of a set in mm at a stage.
    #[must_use]
    pub fn of(set: &RollSet, stage: Stage) -> Self {
        let strip = Strip::at(set, stage);
        let strain = if let Stage::Station(index) = stage { station_strain(set, index) } else { None };
        Self {
            released: Strip::with_bends(set, &released_bends(set, stage)),
            springback: springback(set, stage),
            properties: properties(&strip.mean(), set.section.thickness),
            strain,
            strip,
            stage,
        }
    }
}

/// All stages of a set: flat, the stations, finished.
pub fn stages(set: &RollSet) -> impl Iterator<Item = Stage> + use<> {
    let stations = (0..set.stations.len()).map(Stage::Station);
    std::iter::once(Stage::Flat).chain(stations).chain([Stage::Finished])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rollform::fixtures::published;

    #[test]
    fn every_stage_has_its_shape_and_the_area_never_changes() {
        let flower = Flower::of(&published());
        assert_eq!(flower.shapes.len(), 5);
        let areas: Vec<f64> = flower.shapes.iter().map(|s| s.properties.unwrap().area).collect();
        assert!(areas.iter().all(|area| (area - 112.844 * 0.5).abs() < 0.0005), "{areas:?}");
        assert_eq!(flower.shapes.iter().filter(|s| s.strain.is_some()).count(), 3);
    }

    #[test]
    fn bending_makes_the_strip_stiffer_and_release_makes_it_wider() {
        let flower = Flower::of(&published());
        let stiffness: Vec<f64> = flower.shapes.iter().map(|s| s.properties.unwrap().ix).collect();
        assert!(stiffness[..4].is_sorted(), "{stiffness:?}");
        let width = |strip: &Strip| strip.mean().bounds().map(|b| b.max.z - b.min.z).unwrap();
        let station = flower.at(Stage::Station(1)).unwrap();
        assert!(width(&station.released) > width(&station.strip));
    }
}
