//! The rules of a cross-section and its flower: one file a rule, with the reason, the measured value and the limit.

mod bend_angle;
mod beyond_finished;
mod closed_edges;
mod composite;
mod crossing;
mod duplicate_ids;
mod ends_are_lines;
mod first_inclination;
mod least_radius;
mod lengths;
mod line_figures;
mod no_elements;
mod opposite_bend;
mod other_side;
mod own_factor;
mod rates;
mod sharpening;
mod strip_material;
mod thickness;
mod unbending;
mod unfinished;
mod unknown_bend;

mod subject;

use super::flower::Flower;
use crate::diagnostic::Diagnostic;
use crate::document::RollSet;
use crate::units::Unit;
use subject::Subject;

/// One rule: everything it finds in a set.
type Rule = fn(&Subject<'_>) -> Vec<Diagnostic>;

/// The rules in the order of their messages.
const RULES: [Rule; 22] = [
    thickness::check,
    strip_material::check,
    line_figures::check,
    own_factor::check,
    no_elements::check,
    duplicate_ids::check,
    other_side::check,
    ends_are_lines::check,
    first_inclination::check,
    lengths::check,
    bend_angle::check,
    least_radius::check,
    crossing::check,
    closed_edges::check,
    unknown_bend::check,
    opposite_bend::check,
    beyond_finished::check,
    unbending::check,
    composite::check,
    sharpening::check,
    unfinished::check,
    rates::check,
];

/// What the rules have to say about the cross-section and the flower of a set in mm. Messages are in `unit`.
#[must_use]
pub fn check(set: &RollSet, flower: &Flower, unit: Unit) -> Vec<Diagnostic> {
    let subject = Subject::new(set, flower, unit);
    RULES.iter().flat_map(|rule| rule(&subject)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnostic::Severity;
    use crate::document::Origin;
    use crate::rollform::fixtures::{bend, line, published, set, station, vee};
    use std::time::{Duration, Instant};

    #[test]
    fn the_published_flower_is_only_unfinished() {
        let set = published();
        let found = check(&set, &Flower::of(&set), Unit::Mm);
        let codes: Vec<&str> = found.iter().map(|d| d.code.as_str()).collect();
        assert_eq!(codes, ["unfinished-flower"], "{found:?}");
        assert_eq!(found[0].severity, Severity::Info);
    }

    #[test]
    fn a_finished_vee_is_clean() {
        let set = vee(&[30.0, 60.0, 90.0]);
        assert_eq!(check(&set, &Flower::of(&set), Unit::Mm), []);
    }

    #[test]
    fn a_thousand_elements_are_looked_at_in_a_moment() {
        // A corrugated sheet: up, up and down, down.
        let elements = (0..1000_u32).map(|i| match i % 8 {
            1 | 7 => bend(i, 2.0, 45.0),
            3 | 5 => bend(i, 2.0, -45.0),
            _ => line(i, 10.0),
        });
        let elements: Vec<_> = elements.chain([line(1000, 10.0)]).collect();
        let bends: Vec<(u32, f64)> =
            (1..1000).step_by(2).map(|i| (i, if i % 8 == 1 || i % 8 == 7 { 45.0 } else { -45.0 })).collect();
        let set = set(1.0, Origin::LeftToRight, elements, vec![station(1, &bends)]);
        let begin = Instant::now();
        let found = check(&set, &Flower::of(&set), Unit::Mm);
        assert!(begin.elapsed() < Duration::from_secs(5), "{:?}", begin.elapsed());
        assert_eq!(found, []);
    }
}
