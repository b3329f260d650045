use super::*;
use crate::document::Origin;
use crate::rollform::fixtures::{bend, line, published, set};
use crate::rollform::strain::station_strain;

/// A lipped C of 1.5 mm: half web 40, flange 40, lip 10.
fn lipped() -> RollSet {
    let elements = vec![line(1, 40.0), bend(2, 2.0, 90.0), line(3, 40.0), bend(4, 2.0, 90.0), line(5, 10.0)];
    set(1.5, Origin::Symmetrical, elements, Vec::new())
}

fn suggested(set: &RollSet, choice: Choice, count: usize) -> RollSet {
    RollSet { stations: with_bends(&set.stations, &set.line, angles(set, choice, count)), ..set.clone() }
}

#[test]
fn forming_angle_of_the_checked_case() {
    assert!((50.0 / FORMING_ANGLE_RAD.tan() - 2021.8).abs() < 0.05);
    assert_eq!(stations_by_forming_angle(50.0, 300.0), 7);
    assert_eq!(stations_by_forming_angle(0.0, 300.0), 1);
    assert_eq!(stations_by_forming_angle(50.0, 0.0), MOST_STATIONS);
}

#[test]
fn every_suggestion_ends_with_the_finished_section() {
    for set in [lipped(), published()] {
        for sequence in Sequence::ALL {
            for order in Order::ALL {
                for count in [1, 3, 8, 25] {
                    let suggested = suggested(&set, Choice { sequence, order }, count);
                    assert_eq!(suggested.stations.len(), count);
                    let last = angles_deg(&suggested, Stage::Station(count - 1));
                    for (element, angle) in angles_deg(&set, Stage::Finished) {
                        assert!((last[&element] - angle).abs() < 1e-9, "{sequence:?} {order:?} {count} {element}");
                    }
                }
            }
        }
    }
}

#[test]
fn edges_first_bends_the_lips_before_the_flanges() {
    let choice = Choice { order: Order::EdgesFirst, ..Choice::default() };
    let suggested = suggested(&lipped(), choice, 10);
    let lips_done = (0..10).find(|&i| angles_deg(&suggested, Stage::Station(i))[&4] == 90.0).unwrap();
    assert!(angles_deg(&suggested, Stage::Station(lips_done))[&2] < 45.0);
    assert!(count_by_forming_angle(&lipped(), Order::EdgesFirst) >= count_by_forming_angle(&lipped(), Order::Together));
}

#[test]
fn edge_strain_gives_the_least_number_that_is_enough() {
    let set = lipped();
    let choice = Choice { sequence: Sequence::EvenAngles, order: Order::Together };
    let count = count_by_edge_strain(&set, choice).unwrap();
    let worst = |count: usize| {
        let suggested = suggested(&set, choice, count);
        (0..count).map(|i| station_strain(&suggested, i).unwrap().mean).fold(0.0, f64::max)
    };
    assert!(worst(count) <= limit(&set.strip));
    assert!(worst(count - 1) > limit(&set.strip));
}

#[test]
fn impossible_figures_give_no_number() {
    let mut set = lipped();
    set.line.station_pitch = 0.0;
    assert_eq!(count_by_edge_strain(&set, Choice::default()), None);
    let mut set = lipped();
    set.strip.yield_strength_mpa = 0.0;
    assert_eq!(count_by_edge_strain(&set, Choice::default()), None);
}

#[test]
fn stations_that_are_there_keep_what_their_rolls_are_designed_by() {
    let mut set = published();
    set.stations[2].pass_height = 76.2;
    let suggested = suggested(&set, Choice::default(), 5);
    let ids: Vec<u32> = suggested.stations.iter().map(|s| s.id).collect();
    assert_eq!(ids, [1, 2, 3, 4, 5]);
    assert_eq!(suggested.stations[4].pass_height, 76.2);
}
