//! The aperture of a die block: the outline of the finished strip with a clearance all round.

use super::bends::Stage;
use super::roll::around;
use super::strip::Strip;
use crate::document::RollSet;
use crate::geometry::Contour;

/// The closed outline of the finished section, `clearance` mm off both faces and both edges; arcs stay concentric, and where an
/// inside radius is smaller than the clearance the lines meet. Empty without a strip. The set is in mm.
#[must_use]
pub fn die_aperture(set: &RollSet, clearance: f64) -> Contour {
    around(&Strip::at(set, Stage::Finished), clearance)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rollform::fixtures::published;

    #[test]
    fn the_aperture_stands_off_the_section_all_round() {
        let set = published();
        let strip = Strip::at(&set, Stage::Finished).outline();
        let aperture = die_aperture(&set, 0.04);
        assert!(aperture.largest_gap() < 1e-9);
        let (first, last) = (aperture.segments[0], aperture.segments[aperture.segments.len() - 1]);
        assert!(last.end().distance(first.start()) < 1e-9);
        for p in aperture.polyline(0.01) {
            assert!(strip.distance_to(p) > 0.0399 && strip.distance_to(p) < 0.06, "{p:?}: {}", strip.distance_to(p));
        }
    }

    #[test]
    fn without_a_strip_there_is_none() {
        let mut set = published();
        set.section.elements.clear();
        assert!(die_aperture(&set, 0.1).segments.is_empty());
    }
}
