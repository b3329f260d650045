//! The finished section: group A of the published inputs.

use super::json::{Fields, MOST, Reader};
use crate::document::{
    Content, CrossSection, DevelopedWidth, Document, Element, ElementKind, FORMAT_VERSION, FormingLine, Opening,
    Origin, Rates, RollSet, Sharpening, StripMaterial,
};
use crate::units::Unit;

/// The lathe of the published rolls; the files name none.
const MACHINE: &str = "mori-fanuc-6t";
/// Rolls are turned from steel.
const MATERIAL: &str = "STEEL";
/// Deviation that the proof allows on a roll, mm.
const FORM_TOLERANCE_MM: f64 = 0.05;
/// Most elements of a list; the published limit of 50 is none here.
const MOST_ELEMENTS: usize = 10_000;

/// What the published inputs do not give: a line of a common size.
const LINE_MM: FormingLine = FormingLine {
    station_pitch: 300.0,
    shaft_diameter: 50.0,
    side_shaft_diameter: 30.0,
    gear_ratio: None,
    bottom_rpm: None,
    drawn_gap: 10.0,
};

/// A set with this section and no stations, in the unit that the file asks for.
pub(super) fn document(reader: &mut Reader<'_>, fields: &Fields<'_>, name: String) -> Option<Document> {
    let origin = reader.whole(fields, "ORIGIN", 1, 5).map(origin);
    let thickness = reader.length_mm(fields, "THICK", 0.0);
    let unit = if fields.has("OUNIT") { reader.whole(fields, "OUNIT", 1, 2)? } else { 2 };
    let (mut elements, first_angle_deg) = elements(reader, fields, "elements", 0, origin != Some(Origin::Symmetrical));
    let mut other_side = Vec::new();
    if origin.is_some_and(Origin::has_other_side) {
        let taken = u32::try_from(elements.len()).unwrap_or(u32::MAX);
        (other_side, _) = self::elements(reader, fields, "elements_of_other_side", taken, false);
    }
    elements.shrink_to_fit();
    let section = CrossSection {
        thickness: thickness?,
        origin: origin?,
        first_angle_deg,
        developed_width: DevelopedWidth::RolfomTable,
        elements,
        other_side,
    };
    let unit = if unit == 1 { Unit::Inch } else { Unit::Mm };
    let content = Content::RollSet(set(section).scaled(1.0 / unit.in_mm()));
    Some(Document { turnwright: FORMAT_VERSION, name, unit, content })
}

/// A set with this section, mm, and nothing else decided.
pub(super) fn set(section: CrossSection) -> RollSet {
    RollSet {
        machine: MACHINE.to_owned(),
        material: MATERIAL.to_owned(),
        strip: StripMaterial::default(),
        section,
        opening: Opening::MeanLine,
        sharpening: Sharpening::None,
        composites: Vec::new(),
        line: LINE_MM,
        stations: Vec::new(),
        form_tolerance: FORM_TOLERANCE_MM,
        die_clearance: None,
        rates: Rates::default(),
        rolls: Vec::new(),
    }
}

const fn origin(number: i64) -> Origin {
    match number {
        1 => Origin::LeftToRight,
        2 => Origin::RightToLeft,
        3 => Origin::CentreRightFirst,
        4 => Origin::CentreLeftFirst,
        _ => Origin::Symmetrical,
    }
}

/// The elements of a list with ids from their place in it after `taken` others, and the slope of the first one.
fn elements(
    reader: &mut Reader<'_>,
    fields: &Fields<'_>,
    key: &str,
    taken: u32,
    may_slope: bool,
) -> (Vec<Element>, f64) {
    let mut slope = 0.0;
    let mut elements = Vec::new();
    for (number, entry) in (1_u32..).zip(reader.list(fields, key, MOST_ELEMENTS)) {
        if reader.whole(&entry, "N", 1, i64::from(u32::MAX)).is_some_and(|n| n != i64::from(number)) {
            reader.refuse(&entry.path("N"), format!("The element is number {number} of its list; N must say so."));
        }
        let is_bend = reader.whole(&entry, "TYPE", 1, 2) == Some(2);
        let angle_deg = if entry.has("bend_angle_deg") {
            reader.number(&entry, "bend_angle_deg", -MOST, MOST).unwrap_or(0.0)
        } else {
            0.0
        };
        let kind = if is_bend {
            let radius = reader.length_mm(&entry, "inside_radius", 0.0);
            radius.map(|inside_radius| ElementKind::Bend { inside_radius, angle_deg })
        } else {
            if number == 1 && may_slope {
                slope = angle_deg;
            } else if angle_deg != 0.0 {
                reader.warn(
                    &entry.path("bend_angle_deg"),
                    format!(
                        "The line has a bend angle of {angle_deg}°; only a first line has a slope. It is left out."
                    ),
                );
            }
            reader.length_mm(&entry, "length", 0.0).map(|length| ElementKind::Line { length })
        };
        elements.extend(kind.map(|kind| Element { id: taken.saturating_add(number), kind }));
    }
    (elements, slope)
}
