//! What a new document of each kind begins with: little, but all of it makes sense.

use crate::document::{
    BendAngle, Content, CrossSection, DevelopedWidth, Document, Element, ElementKind, Ends, FORMAT_VERSION,
    FormingLine, Kind, Opening, Origin, Pinch, Rates, RollSet, Sharpening, Shell, Station, StripMaterial, TurnedPart,
};
use crate::part::Section;
use crate::units::Unit;

/// Cumulative angles of a new channel at its stations, degrees.
const CHANNEL_DEG: [f64; 6] = [15.0, 32.0, 48.0, 64.0, 78.0, 90.0];

/// A new document, in mm.
pub(super) fn document(kind: Kind, machine: &str) -> Document {
    let (name, content) = match kind {
        Kind::TurnedPart => ("PART", Content::TurnedPart(cylinders(machine))),
        Kind::RollSet => ("ROLLS", Content::RollSet(channel())),
        Kind::Shell => ("SHELL", Content::Shell(Shell::default())),
    };
    Document { turnwright: FORMAT_VERSION, name: name.to_owned(), unit: Unit::Mm, content }
}

/// Two cylinders.
fn cylinders(machine: &str) -> TurnedPart {
    TurnedPart {
        machine: machine.to_owned(),
        material: "ALUMINUM".to_owned(),
        bar_diameter: 25.0,
        length: 40.0,
        ends: Ends::One,
        form_tolerance: 0.25,
        sections: vec![Section::line(1, 0.0, 22.0, 25.0, 22.0), Section::line(2, 25.0, 16.0, 40.0, 16.0)],
        ..TurnedPart::default()
    }
}

/// A channel of 60 by 20 by 1 mm in six stations.
fn channel() -> RollSet {
    let bend = Element { id: 2, kind: ElementKind::Bend { inside_radius: 2.0, angle_deg: 90.0 } };
    let line = |id, length| Element { id, kind: ElementKind::Line { length } };
    let shafts = FormingLine {
        station_pitch: 300.0,
        shaft_diameter: 40.0,
        side_shaft_diameter: 30.0,
        gear_ratio: None,
        bottom_rpm: None,
        drawn_gap: 0.0,
    };
    RollSet {
        machine: "mori-fanuc-6t".to_owned(),
        material: "STEEL".to_owned(),
        strip: StripMaterial::default(),
        section: CrossSection {
            thickness: 1.0,
            origin: Origin::Symmetrical,
            first_angle_deg: 0.0,
            developed_width: DevelopedWidth::default(),
            elements: vec![line(1, 27.0), bend, line(3, 17.0)],
            other_side: Vec::new(),
        },
        opening: Opening::default(),
        sharpening: Sharpening::default(),
        composites: Vec::new(),
        line: shafts,
        stations: (1..).zip(CHANNEL_DEG).map(|(id, angle_deg)| station(id, angle_deg, &shafts)).collect(),
        form_tolerance: 0.05,
        die_clearance: None,
        rates: Rates::default(),
        rolls: Vec::new(),
    }
}

/// A station of the channel: the bottom roll grows by 0.5 mm from one to the next, so that the strip is kept taut.
fn station(id: u32, angle_deg: f64, line: &FormingLine) -> Station {
    let grown = 0.5 * f64::from(id - 1);
    Station {
        id,
        bends: vec![BendAngle { element: 2, angle_deg }],
        pass_height: 55.0 + grown,
        centre_distance: 126.0 + grown,
        tolerance_left: 0.2,
        tolerance_right: 0.2,
        pinch: Pinch::Clearance { added: 0.0 },
        ..Station::new(id, line)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cancel::Cancel;
    use crate::diagnostic::has_errors;
    use crate::machine::Catalog;
    use crate::regen::{Cache, regenerate};
    use crate::storage::{document_from_text, document_to_text};
    use std::sync::Arc;

    #[test]
    fn a_new_document_of_every_kind_is_without_errors_and_can_be_saved() {
        for kind in [Kind::TurnedPart, Kind::RollSet, Kind::Shell] {
            let new = document(kind, "orac");
            assert_eq!(document_from_text("new", &document_to_text(&new).unwrap()).unwrap(), new);
            let (catalog, mut cache) = (Catalog::shipped(), Cache::default());
            let derived = regenerate(&Arc::new(new), &catalog, &mut cache, &Cancel::default()).unwrap();
            assert!(!has_errors(&derived.diagnostics), "{kind:?}: {:?}", derived.diagnostics);
        }
    }
}
