//! What is checked of the rolls of a station: one file a rule.

mod drive_falls;
mod drive_ratio;
mod extensions;
mod no_strip;
mod openings;
mod overlap;
mod references;
mod thin;
mod tolerance;

use crate::diagnostic::{Diagnostic, Place};
use crate::document::{RollSet, Station};
use crate::rollform::StationDesign;

/// A station with everything that the rules look at, mm.
struct Checked<'a> {
    set: &'a RollSet,
    station: &'a Station,
    design: &'a StationDesign,
}

impl Checked<'_> {
    /// The station as a place.
    fn at(&self) -> Place {
        Place::Station { id: self.station.id, number: self.design.number }
    }
}

/// Everything that is to be said about a station and its rolls.
pub(in crate::rollform) fn check(set: &RollSet, station: &Station, design: &StationDesign) -> Vec<Diagnostic> {
    let checked = Checked { set, station, design };
    let rules: [fn(&Checked<'_>) -> Vec<Diagnostic>; 8] = [
        no_strip::check,
        openings::check,
        tolerance::check,
        extensions::check,
        references::check,
        thin::check,
        overlap::check,
        drive_ratio::check,
    ];
    if station.without_rolls { Vec::new() } else { rules.iter().flat_map(|rule| rule(&checked)).collect() }
}

/// Everything that is to be said about stations that follow one another.
pub(in crate::rollform) fn check_line(set: &RollSet, stations: &[StationDesign]) -> Vec<Diagnostic> {
    drive_falls::check(stations).into_iter().chain(drive_ratio::check_line(set, stations)).collect()
}

#[cfg(test)]
mod tests {
    use crate::document::{DriveSurface, Pinch, RollSet};
    use crate::rollform::design;
    use crate::rollform::fixtures::published_rolls;

    /// The published set with one thing broken, and the codes that are then reported.
    fn codes(break_it: impl FnOnce(&mut RollSet)) -> Vec<String> {
        let mut set = published_rolls();
        break_it(&mut set);
        design("x", &set).diagnostics.into_iter().map(|d| d.code).collect()
    }

    #[test]
    fn the_published_set_is_clean() {
        assert_eq!(codes(|_| {}), Vec::<String>::new());
    }

    #[test]
    fn every_rule_fires_when_its_thing_is_broken() {
        assert_eq!(codes(|s| s.section.elements.clear()), ["roll-no-strip"; 3]);
        assert_eq!(
            codes(|s| s.stations[1].pinch = Pinch::Gaps { drive: 0.5, clearance: 0.4 }),
            ["roll-clearance-below-drive"]
        );
        assert_eq!(codes(|s| s.stations[1].pinch = Pinch::Clearance { added: -0.1 }), ["roll-clearance-negative"]);
        // The strip is 0.5 mm thick.
        let squeezed = |drive| codes(|s| s.stations[1].pinch = Pinch::Gaps { drive, clearance: 0.61 });
        assert_eq!((squeezed(0.49), squeezed(0.5)), (vec!["roll-opening-below-strip".to_owned()], Vec::new()));
        assert_eq!(codes(|s| s.stations[1].tolerance_left = -0.1), ["roll-tolerance"]);
        assert_eq!(codes(|s| s.stations[1].extension_right[0].lengths[2] = -1.0), ["roll-extension"]);
        assert_eq!(
            codes(|s| s.stations[1].drive_right = Some(DriveSurface { first: 1, last: 99 })),
            ["roll-element-unknown"]
        );
        assert_eq!(codes(|s| s.line.shaft_diameter = 150.0), ["roll-thin"; 6]);
        assert_eq!(
            codes(|s| s.stations[2].side_right.as_mut().unwrap().axis_distance = 40.0).first().unwrap(),
            "roll-thin"
        );
        assert_eq!(codes(|s| s.line.gear_ratio = Some(1.1)), ["roll-drive-ratio"; 3]);
        // A ratio of 1 beside which nothing is said is not taken at its word; with a speed it is.
        assert_eq!(codes(|s| s.line.gear_ratio = Some(1.0)), ["roll-drive-ratio-assumed"]);
        let driven = codes(|s| (s.line.gear_ratio, s.line.bottom_rpm) = (Some(1.0), Some(50.0)));
        assert_eq!(driven, ["roll-drive-ratio"; 3]);
        assert_eq!(codes(|s| s.stations[1].gear_ratio = Some(1.0)), ["roll-drive-ratio"]);
        assert_eq!(codes(|s| s.stations[1].gear_ratio = Some(1.33)), Vec::<String>::new());
        assert_eq!(codes(|s| s.stations[1].gear_ratio = Some(0.0)), ["gear-ratio"]);
        assert_eq!(codes(|s| s.stations[1].pass_height = 71.0), ["roll-drive-falls"]);
        assert!(codes(|s| s.section.thickness = 0.0).contains(&"roll-no-strip".to_owned()));
    }

    #[test]
    fn rolls_that_stand_in_one_another_are_found() {
        let found = codes(|s| {
            if let Some(side) = &mut s.stations[2].side_right {
                side.extensions[1].lengths = [0.0, 0.0, -20.0, 7.0];
            }
        });
        assert!(found.contains(&"roll-overlap".to_owned()), "{found:?}");
    }
}
