//! Parts and set-ups made by hand for tests.

use crate::document::{Ends, Generator, TurnedPart};
use crate::part::Section;
use std::collections::BTreeMap;

/// A part in mm with the given rows, on a 26.2 mm bar.
pub(super) fn part(sections: Vec<Section>) -> TurnedPart {
    TurnedPart {
        machine: "orac".into(),
        material: "aluminium".into(),
        bar_diameter: 26.2,
        length: sections.iter().map(|s| s.z2).fold(0.0, f64::max),
        ends: Ends::One,
        part_off: false,
        automatic: false,
        generator: Generator::default(),
        form_tolerance: 0.02,
        sections,
        overrides: BTreeMap::new(),
    }
}
