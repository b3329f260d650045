//! Where figures stand so close that a detail at a larger scale has to show them.

use super::marks::Mark;

/// Figures whose places are closer than this on paper crowd each other, mm.
const CROWDED_MM: f64 = 1.8;
/// Figures from which on a crowd is worth a detail.
const LEAST_FIGURES: usize = 10;
/// Longest detail as a share of the part's length.
const LONGEST: f64 = 0.4;
/// How far a detail reaches beyond its outermost figures, as a share of its length.
const BEYOND: f64 = 0.12;

/// A stretch of the part that a detail shows.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Zone {
    /// First position, mm.
    pub(super) from: f64,
    /// Last position, mm.
    pub(super) to: f64,
}

impl Zone {
    /// True if a mark belongs to the detail.
    pub(super) fn holds(&self, mark: &Mark) -> bool {
        (self.from..=self.to).contains(&mark.at.z)
    }
}

/// The crowds among `marks` where one mm of the part is `scale` mm on paper, in order of position.
pub(super) fn zones<'a>(marks: impl Iterator<Item = &'a Mark>, scale: f64, length: f64) -> Vec<Zone> {
    let mut places: Vec<f64> = marks.map(|m| m.at.z).collect();
    places.sort_by(f64::total_cmp);
    let crowds = places.chunk_by(|a, b| (b - a) * scale < CROWDED_MM).filter(|crowd| crowd.len() >= LEAST_FIGURES);
    let zones = crowds.filter_map(|crowd| {
        let (from, to) = (*crowd.first()?, *crowd.last()?);
        let beyond = (to - from) * BEYOND;
        Some(Zone { from: from - beyond, to: to + beyond })
    });
    zones.filter(|zone| zone.to > zone.from && zone.to - zone.from <= LONGEST * length).collect()
}

/// `A`, `B`, `C` ... of the first, second, third detail.
pub(super) fn letter(index: usize) -> String {
    let letters = 'A'..='Z';
    letters.clone().nth(index % letters.count()).map_or_else(String::new, String::from)
}

#[cfg(test)]
mod tests {
    use super::super::marks::Line;
    use super::*;
    use crate::geometry::Point;

    #[test]
    fn only_a_crowd_becomes_a_detail_and_none_at_a_scale_that_has_room() {
        let mark = |z: f64| Mark { at: Point::new(z, 10.0), line: Line::Extension, text: String::new() };
        let spread = [0.0, 10.0, 90.0, 100.0];
        let crowd = (0..12).map(|k| 30.0 + 0.5 * f64::from(k));
        let marks: Vec<Mark> = spread.into_iter().chain(crowd).map(mark).collect();
        let found = zones(marks.iter(), 1.0, 100.0);
        assert_eq!(found.len(), 1);
        assert!(marks[4..].iter().all(|m| found[0].holds(m)) && !marks[..4].iter().any(|m| found[0].holds(m)));
        assert_eq!(zones(marks.iter(), 5.0, 100.0), []);
        assert_eq!((letter(0), letter(1)), ("A".to_owned(), "B".to_owned()));
    }
}
