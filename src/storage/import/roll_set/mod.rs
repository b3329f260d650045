//! Sets of form-rolls from the published inputs as JSON: the finished section, the flower, the roll design.
//!
//! The fields have the published names (Wong 1983, appendix 5 A to C), lengths with `_mm` or `_in` after them. What else is
//! in the files are remarks. A section with two lists of elements has the second one in `elements_of_other_side`.

mod design;
mod dxf;
mod flower;
mod json;
mod section;

pub use dxf::{MidLineThickness, roll_section_dxf};

use crate::diagnostic::{Diagnostic, Place};
use crate::document::{Content, Document, RollSet};
use crate::storage::check;
use json::Reader;
use std::path::Path;

/// Reads a finished section (group A); `file` is its name for messages. The set has no stations yet.
///
/// # Errors
/// A diagnostic for every field that cannot be used, with line, field, value and limit.
pub fn roll_section(file: &str, text: &str) -> Result<(Document, Vec<Diagnostic>), Vec<Diagnostic>> {
    let mut reader = Reader::new(file, text);
    let value = reader.parse()?;
    let made = reader.root(&value).and_then(|fields| {
        let name = fields.get("section_no").and_then(|v| v.as_str()).map(Path::new).map(super::name_of);
        section::document(&mut reader, &fields, name.unwrap_or_else(|| super::name_of(Path::new(file))))
    });
    checked(file, reader.outcome(made)?)
}

/// Gives a set the stations and angles of a flower (group B); `file` is its name for messages.
///
/// # Errors
/// As [`roll_section`], and if the document is no set of form-rolls.
pub fn roll_flower(file: &str, text: &str, document: Document) -> Result<(Document, Vec<Diagnostic>), Vec<Diagnostic>> {
    let mut reader = Reader::new(file, text);
    let value = reader.parse()?;
    let changed = changed(document, |set| {
        let fields = reader.root(&value)?;
        flower::apply(&mut reader, &fields, set)
    })?;
    checked(file, reader.outcome(changed)?)
}

/// Gives the stations of a set what their rolls are designed by (group C); `file` is its name for messages.
///
/// # Errors
/// As [`roll_flower`], and if the set has no stations yet.
pub fn roll_design(file: &str, text: &str, document: Document) -> Result<(Document, Vec<Diagnostic>), Vec<Diagnostic>> {
    let mut reader = Reader::new(file, text);
    let value = reader.parse()?;
    let changed = changed(document, |set| {
        let fields = reader.root(&value)?;
        design::apply(&mut reader, &fields, set)
    })?;
    checked(file, reader.outcome(changed)?)
}

/// The document with its set changed in mm; `None` if the change could not be made.
fn changed(
    mut document: Document,
    change: impl FnOnce(&mut RollSet) -> Option<()>,
) -> Result<Option<Document>, Vec<Diagnostic>> {
    let Content::RollSet(set) = &mut document.content else {
        let message = "This file belongs to a set of form-rolls; the document is none.";
        return Err(vec![Diagnostic::error("input-without-set", Place::Document, message)]);
    };
    let unit = document.unit.in_mm();
    let mut in_mm = set.scaled(unit);
    let made = change(&mut in_mm);
    *set = in_mm.scaled(1.0 / unit);
    Ok(made.map(|()| document))
}

/// The document, if it fulfils what every document fulfils.
fn checked(
    file: &str,
    (document, diagnostics): (Document, Vec<Diagnostic>),
) -> Result<(Document, Vec<Diagnostic>), Vec<Diagnostic>> {
    let at = crate::textfile::file_place(Path::new(file));
    let faults = check::faults(&document);
    if faults.is_empty() {
        return Ok((document, diagnostics));
    }
    let error = |f: check::Fault| Diagnostic::error("document-value", at.clone(), f.message).with_related(f.at);
    Err(faults.into_iter().map(error).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::{Composite, ElementKind, FixedComposite, Sharpening};
    use crate::rollform::fixtures;
    use crate::units::Unit;

    const SECTION: &str = r#"{"section_no": "vee", "IUNIT": 2, "OUNIT": 2, "THICK_mm": 1.0, "ORIGIN": 1, "elements": [
        {"N": 1, "TYPE": 1, "length_mm": 30, "bend_angle_deg": -45},
        {"N": 2, "TYPE": 2, "inside_radius_mm": 2, "bend_angle_deg": 90},
        {"N": 3, "TYPE": 1, "length_mm": 50}]}"#;

    fn set(document: Document) -> RollSet {
        let Content::RollSet(set) = document.content else { panic!("no set") };
        set
    }

    fn section(text: &str) -> Result<RollSet, Vec<Diagnostic>> {
        roll_section("vee.json", text).map(|(document, _)| set(document))
    }

    fn flower(text: &str) -> Result<RollSet, Vec<Diagnostic>> {
        let document = roll_section("vee.json", SECTION).unwrap().0;
        roll_flower("flower.json", text, document).map(|(document, _)| set(document))
    }

    #[test]
    fn section_is_read_with_its_slope() {
        let set = section(SECTION).unwrap();
        assert_eq!(set.section.elements, fixtures::vee(&[]).section.elements);
        assert_eq!(set.section.first_angle_deg, -45.0);
    }

    #[test]
    fn inches_are_kept_as_the_unit_of_the_document() {
        let text = SECTION.replace("\"OUNIT\": 2", "\"OUNIT\": 1").replace("\"length_mm\": 30", "\"length_in\": 2");
        let document = roll_section("vee.json", &text).unwrap().0;
        assert_eq!(document.unit, Unit::Inch);
        let ElementKind::Line { length } = set(document).section.elements[0].kind else { panic!("no line") };
        assert!((length - 2.0).abs() < 1e-12);
    }

    #[test]
    fn second_list_gets_ids_of_its_own() {
        let text = SECTION.replace("\"ORIGIN\": 1", "\"ORIGIN\": 3").replace(
            "\"elements\"",
            "\"elements_of_other_side\": [{\"N\": 1, \"TYPE\": 1, \"length_mm\": 12}], \"elements\"",
        );
        assert_eq!(section(&text).unwrap().section.other_side, [fixtures::line(4, 12.0)]);
        let missing = section(&SECTION.replace("\"ORIGIN\": 1", "\"ORIGIN\": 3")).unwrap_err();
        assert!(missing[0].message.contains("elements_of_other_side"), "{missing:?}");
    }

    #[test]
    fn every_fault_of_a_section_is_reported_at_its_line() {
        let text = SECTION
            .replace("\"ORIGIN\": 1", "\"ORIGIN\": 6")
            .replace("\"inside_radius_mm\": 2", "\"inside_radius_mm\": -2")
            .replace("\"N\": 3", "\"N\": 5");
        let found = section(&text).unwrap_err();
        let at: Vec<String> = found.iter().map(|d| d.at.to_string()).collect();
        assert_eq!(found.len(), 3, "{found:?}");
        assert!(
            at[0].starts_with("vee.json:1:") && at[1].starts_with("vee.json:3:") && at[2].starts_with("vee.json:4:")
        );
        assert!(section("[]").is_err() && section("{").is_err());
    }

    #[test]
    fn flower_gives_stations_their_bends() {
        let set = flower(
            r#"{"NSTAGE": 3, "JBEND": 0, "JSHARP": -1, "bends": [
            {"pass": 1, "element_right": 2, "cumulative_angle_deg": 30},
            {"pass": 3, "element_right": 2, "cumulative_angle_deg": 90}]}"#,
        )
        .unwrap();
        let bends: Vec<usize> = set.stations.iter().map(|s| s.bends.len()).collect();
        assert_eq!(bends, [1, 0, 1]);
        assert_eq!(set.stations[2].bends[0].angle_deg, 90.0);
        assert_eq!(set.sharpening, Sharpening::AllButLast);
    }

    #[test]
    fn percentages_hold_until_the_next_ones() {
        let text = r#"{"NSTAGE": 3, "JBEND": 1, "JSHARP": 1, "ISQSH": [2], "bends": [
            {"pass": 1, "element_right": 2, "cumulative_angle_deg": 30, "IPCR": [20, 60, 20]},
            {"pass": 3, "element_right": 2, "cumulative_angle_deg": 90, "IPCR": [10, 80, 10]}]}"#;
        let set = flower(text).unwrap();
        let fixed = |first, last| Some(FixedComposite { first, last });
        assert_eq!(
            set.composites,
            [
                Composite { element: 2, percent: [20.0, 60.0, 20.0], fixed: fixed(1, 2) },
                Composite { element: 2, percent: [10.0, 80.0, 10.0], fixed: fixed(3, 3) }
            ]
        );
        assert_eq!(set.sharpening, Sharpening::Stations(vec![2]));
        let ranged = flower(&text.replace("\"bends\"", "\"ISQCP\": [{\"IECR\": [2, 1, 2]}], \"bends\"")).unwrap();
        assert!(ranged.composites.iter().all(|c| c.fixed == fixed(1, 2)));
    }

    #[test]
    fn impossible_flowers_are_refused() {
        for text in [
            r#"{"NSTAGE": 0, "bends": []}"#,
            r#"{"NSTAGE": 2, "bends": [{"pass": 3, "element_right": 2, "cumulative_angle_deg": 30}]}"#,
            r#"{"NSTAGE": 2, "bends": [{"pass": 1, "element_right": 4, "cumulative_angle_deg": 30}]}"#,
            r#"{"NSTAGE": 2, "bends": [{"pass": 1, "element_right": 2}]}"#,
            r#"{"NSTAGE": 2, "JSHARP": 1, "ISQSH": [5], "bends": []}"#,
        ] {
            assert_eq!(flower(text).unwrap_err().len(), 1, "{text}");
        }
    }
}
