//! The state of every bend at a stage of the line: its angle, its radius, and what of its length is still straight.
//!
//! The mean length of a bend, `L = (r + t/2)·|θ|` of the finished bend, is the same at every stage: metal is neither made
//! nor lost. While a bend opens towards the flat strip, its arc may have all of `L` (the rule of the published rolls) or
//! only a part, the rest being straight before and after it.

use crate::document::{Composite, CrossSection, ElementKind, Opening, RollSet, Sharpening};
use std::collections::BTreeMap;

/// A moment in the life of the strip.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Stage {
    /// Before the first station.
    Flat,
    /// At a station, by its index in the list of stations.
    Station(usize),
    /// With all bends of the cross-section, whether the last station reaches them or not.
    Finished,
}

/// A bend at a stage. Lengths on the mean line, mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BendState {
    /// Id of the element.
    pub element: u32,
    /// Angle, radians, positive upwards on the way from the origin; 0 if the bend is flat yet.
    pub angle_rad: f64,
    /// Inside radius, mm; infinite while the bend is flat.
    pub inside_radius: f64,
    /// Straight before the arc; all of the bend while it is flat.
    pub leading: f64,
    /// Length of the arc.
    pub arc: f64,
    /// Straight after the arc.
    pub trailing: f64,
}

impl BendState {
    /// Length of the bend on the mean line, mm; the same at every stage.
    #[must_use]
    pub fn mean_length(&self) -> f64 {
        self.leading + self.arc + self.trailing
    }

    /// The same bend at another angle, bent or released as a whole: its arc keeps its mean length, so that its radius
    /// follows. `thickness` in mm.
    #[must_use]
    pub fn at_angle(&self, angle_rad: f64, thickness: f64) -> Self {
        if angle_rad == 0.0 {
            return Self { angle_rad, inside_radius: f64::INFINITY, ..*self };
        }
        let inside_radius = (self.arc / angle_rad.abs() - thickness / 2.0).max(0.0);
        Self { angle_rad, inside_radius, ..*self }
    }
}

/// Mean length of a finished bend, `(r + t/2)·|θ|`, mm: what the strip has for it at every stage.
#[must_use]
pub fn mean_length(inside_radius: f64, angle_deg: f64, thickness: f64) -> f64 {
    (inside_radius + thickness / 2.0) * angle_deg.abs().to_radians()
}

/// The cumulative angle of every bend at a stage, degrees, by element: what the stations say, carried over from the
/// station before where they say nothing.
#[must_use]
pub fn angles_deg(set: &RollSet, stage: Stage) -> BTreeMap<u32, f64> {
    let finished =
        |section: &CrossSection| section.all().filter_map(|e| Some((e.id, finished_angle(&e.kind)?))).collect();
    let mut angles: BTreeMap<u32, f64> = finished(&set.section);
    let until = match stage {
        Stage::Finished => return angles,
        Stage::Flat => 0,
        Stage::Station(index) => index.saturating_add(1),
    };
    for angle in angles.values_mut() {
        *angle = 0.0;
    }
    for bend in set.stations.iter().take(until).flat_map(|station| &station.bends) {
        if let Some(angle) = angles.get_mut(&bend.element) {
            *angle = bend.angle_deg;
        }
    }
    angles
}

const fn finished_angle(kind: &ElementKind) -> Option<f64> {
    match *kind {
        ElementKind::Line { .. } => None,
        ElementKind::Bend { angle_deg, .. } => Some(angle_deg),
    }
}

/// The state of one bend at a stage; `None` if the section has no bend with this id.
#[must_use]
pub fn bend_state(set: &RollSet, stage: Stage, element: u32) -> Option<BendState> {
    bend_states(set, stage).remove(&element)
}

/// The state of every bend at a stage, by element. The set is in mm.
#[must_use]
pub fn bend_states(set: &RollSet, stage: Stage) -> BTreeMap<u32, BendState> {
    let angles = angles_deg(set, stage);
    let bends = set.section.all().filter_map(|element| {
        let ElementKind::Bend { inside_radius, angle_deg } = element.kind else { return None };
        let bend = Bend { element: element.id, radius: inside_radius, angle_deg, thickness: set.section.thickness };
        Some((element.id, bend.at(set, stage, angles.get(&element.id).copied()?)))
    });
    bends.collect()
}

/// A finished bend.
struct Bend {
    element: u32,
    radius: f64,
    angle_deg: f64,
    thickness: f64,
}

/// Parts of a bend's length: leading line, arc, trailing line. They sum to 1.
type Parts = [f64; 3];

impl Bend {
    fn at(&self, set: &RollSet, stage: Stage, angle_deg: f64) -> BendState {
        let (length, angle_rad) = (mean_length(self.radius, self.angle_deg, self.thickness), angle_deg.to_radians());
        let state = |inside_radius, leading, arc, trailing| BendState {
            element: self.element,
            angle_rad,
            inside_radius,
            leading,
            arc,
            trailing,
        };
        if angle_rad == 0.0 {
            return state(f64::INFINITY, length, 0.0, 0.0);
        }
        let parts = parts_at(set, stage, self.element).filter(|_| angle_deg.abs() < self.angle_deg.abs());
        if angle_deg.abs() == self.angle_deg.abs() && parts.is_none() {
            return state(self.radius, 0.0, length, 0.0);
        }
        let radius = self.radius_at(set, stage, angle_rad.abs(), parts).max(0.0);
        let arc = ((radius + self.thickness / 2.0) * angle_rad.abs()).min(length);
        let [before, _, after] = parts.unwrap_or_default();
        let leading_part = if before + after > 0.0 { before / (before + after) } else { 0.5 };
        let straight = length - arc;
        state(radius, straight * leading_part, arc, straight * (1.0 - leading_part))
    }

    /// Inside radius at an angle, mm.
    fn radius_at(&self, set: &RollSet, stage: Stage, angle_rad: f64, parts: Option<Parts>) -> f64 {
        let opened = parts.map_or(1.0, |[_, arc, _]| arc) * self.angle_deg.abs().to_radians() / angle_rad;
        match set.opening {
            _ if is_sharpened(set, stage) => self.radius,
            Opening::ConstantRadius => self.radius,
            Opening::MeanLine => (self.radius + self.thickness / 2.0) * opened - self.thickness / 2.0,
            Opening::InsideRadius => self.radius * opened,
        }
    }
}

/// True if bends get their finished radius at this stage at once.
fn is_sharpened(set: &RollSet, stage: Stage) -> bool {
    let Stage::Station(index) = stage else { return false };
    match &set.sharpening {
        Sharpening::None => false,
        Sharpening::AllButLast => index.saturating_add(1) < set.stations.len(),
        Sharpening::Stations(ids) => set.stations.get(index).is_some_and(|station| ids.contains(&station.id)),
    }
}

/// The parts of a bend that is formed as a composite at this stage; of several compositions for it the last one counts.
fn parts_at(set: &RollSet, stage: Stage, element: u32) -> Option<Parts> {
    let Stage::Station(index) = stage else { return None };
    let composite = set.composites.iter().rev().find(|c| c.element == element && is_active(set, c, index))?;
    let sum: f64 = composite.percent.iter().sum();
    (sum > 0.0).then(|| composite.percent.map(|p| p / sum))
}

fn is_active(set: &RollSet, composite: &Composite, index: usize) -> bool {
    let Some(fixed) = composite.fixed else { return true };
    let index_of = |id: u32| set.stations.iter().position(|station| station.id == id);
    index_of(fixed.first).is_some_and(|first| first <= index) && index_of(fixed.last).is_some_and(|last| index <= last)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::FixedComposite;
    use crate::rollform::fixtures::{published, vee};

    fn state(set: &RollSet, station: usize, element: u32) -> BendState {
        bend_state(set, Stage::Station(station), element).unwrap()
    }

    #[test]
    fn angles_are_carried_over() {
        let set = published();
        let at = |station, element| angles_deg(&set, Stage::Station(station))[&element];
        assert_eq!([at(0, 10), at(1, 10), at(2, 10)], [-45.0; 3]);
        assert_eq!([at(0, 8), at(1, 8), at(2, 8)], [0.0, -25.0, -25.0]);
        assert_eq!([at(0, 20), at(1, 20), at(2, 20)], [0.0, -50.0, -75.0]);
        assert_eq!(angles_deg(&set, Stage::Finished)[&20], -180.0);
        assert!(angles_deg(&set, Stage::Flat).values().all(|&angle| angle == 0.0));
    }

    #[test]
    fn part_bent_hem_has_the_radius_that_its_printed_rolls_have() {
        // Printed for element 20 at -50 degrees: 1.366 - 0.500 on the top roll, 0.756 + 0.110 on the bottom roll.
        assert!((state(&published(), 1, 20).inside_radius - 0.866).abs() < 0.0005);
    }

    #[test]
    fn inside_radius_of_the_published_text_is_another_one() {
        let set = RollSet { opening: Opening::InsideRadius, ..published() };
        assert!((state(&set, 1, 20).inside_radius - 0.216).abs() < 1e-12);
    }

    #[test]
    fn no_way_of_opening_makes_or_loses_metal() {
        let composites = vec![Composite { element: 2, percent: [25.0, 50.0, 25.0], fixed: None }];
        for opening in [Opening::MeanLine, Opening::InsideRadius, Opening::ConstantRadius] {
            for sharpening in [Sharpening::None, Sharpening::AllButLast, Sharpening::Stations(vec![2])] {
                for composites in [Vec::new(), composites.clone()] {
                    let set = RollSet {
                        opening,
                        sharpening: sharpening.clone(),
                        composites,
                        ..vee(&[0.0, 30.0, 60.0, 90.0])
                    };
                    let length = mean_length(2.0, 90.0, 1.0);
                    for station in 0..4 {
                        assert!((state(&set, station, 2).mean_length() - length).abs() < 1e-12);
                    }
                    assert_eq!(state(&set, 3, 2).inside_radius, 2.0);
                }
            }
        }
    }

    #[test]
    fn constant_radius_leaves_the_rest_straight_on_both_sides() {
        let set = RollSet { opening: Opening::ConstantRadius, ..vee(&[30.0, 90.0]) };
        let bend = state(&set, 0, 2);
        assert_eq!(bend.inside_radius, 2.0);
        assert!((bend.arc * 3.0 - bend.mean_length()).abs() < 1e-12);
        assert!((bend.leading - bend.trailing).abs() < 1e-12);
    }

    #[test]
    fn sharpening_holds_at_the_stations_it_names() {
        let radii = |sharpening: Sharpening| {
            let set = RollSet { sharpening, ..vee(&[30.0, 60.0, 60.0]) };
            [0, 1, 2].map(|station| state(&set, station, 2).inside_radius)
        };
        let [first, open, _] = radii(Sharpening::None);
        assert!(first > open && open > 2.0);
        assert_eq!(radii(Sharpening::Stations(vec![2])), [first, 2.0, open]);
        assert_eq!(radii(Sharpening::AllButLast), [2.0, 2.0, open]);
    }

    #[test]
    fn composite_parts_hold_between_their_stations() {
        let fixed = Some(FixedComposite { first: 2, last: 3 });
        let composites = vec![Composite { element: 2, percent: [20.0, 50.0, 30.0], fixed }];
        let set = RollSet { composites, ..vee(&[30.0, 45.0, 60.0, 75.0]) };
        for (station, arc) in [(0, 1.0), (1, 0.5), (2, 0.5), (3, 1.0)] {
            let bend = state(&set, station, 2);
            assert!((bend.arc / bend.mean_length() - arc).abs() < 1e-12, "station {station}");
        }
        let bend = state(&set, 1, 2);
        assert!((bend.leading / bend.trailing - 2.0 / 3.0).abs() < 1e-12);
        assert!((bend.inside_radius - (0.5 * bend.mean_length() / 45.0_f64.to_radians() - 0.5)).abs() < 1e-12);
    }

    #[test]
    fn release_opens_the_radius_with_the_arc_kept() {
        let bend = state(&vee(&[90.0]), 0, 2);
        let released = bend.at_angle(80.0_f64.to_radians(), 1.0);
        assert!((released.inside_radius - (2.5 * 90.0 / 80.0 - 0.5)).abs() < 1e-12);
        assert_eq!(released.mean_length(), bend.mean_length());
    }
}
