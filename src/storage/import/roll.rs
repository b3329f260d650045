//! Profiles of form-rolls: the E layout of the published roll design programs.
//!
//! One element a line: number, type (1 line, 2 arc), z and radius of start and end, then for a line A, B, C of
//! A·z + B·r + C = 0, for an arc the centre's z and radius and the arc's radius, and at last its sense (0 line, 1
//! counter-clockwise, −1 clockwise, with z to the right and the radius upwards). A line of zeros ends the list. Units mm.
//! Source: Wong 1983, table 6.1 and figure 6.17.
//!
//! The figures are rounded to 0.001 mm and give some things twice. What is used: an element starts where the one before
//! it ends (their figures differ by up to 0.002 mm); lines by their ends, for A is rounded so coarsely that it moves a
//! line by up to 0.02 mm; arcs by their ends and the radius, to three decimals, that puts the centre nearest to the
//! published one; walls square to the spindle, though their ends differ by 0.001 mm.

mod corners;
mod element;

use super::{Imported, largest_diameter, largest_position, name_of};
use crate::diagnostic::{Diagnostic, has_errors};
use crate::document::{Document, Ends, Generator, Holding};
use crate::part::{Section, SectionKind, row_curve};
use crate::textfile::{file_place, line_place};
use crate::turning::cycles::{BLANK_ALLOWANCE_MM, standard_blank_mm};
use crate::units::Unit;
use element::{Element, Shape};
use std::path::Path;

/// The lathe of the published rolls; the files name none.
const MACHINE: &str = "mori-fanuc-6t";

/// Rolls are turned from steel.
const MATERIAL: &str = "STEEL";

/// Deviation that the proof allows on a roll, mm. The published programs leave up to 0.03 mm at small corners.
const FORM_TOLERANCE_MM: f64 = 0.05;

/// Ends of neighbouring elements may differ by so much, mm: twice the last figure.
const SAME_PLACE_MM: f64 = 0.0025;

/// Figures are computed to this many decimals where they do not stand in the file.
const COMPUTED_DECIMALS: i32 = 6;

/// Radii that are fitted to a centre have the decimals of the file's figures.
const RADIUS_DECIMALS: i32 = 3;

/// Reads a roll profile; `file` is its name for messages. The rows get the numbers of their elements as ids, the bar is
/// the next standard blank, and the generator is that of the published cycles, without instructions.
///
/// # Errors
/// A diagnostic for every line that cannot be used, with the line, the value and its limit.
pub fn roll(file: &str, text: &str) -> Result<(Document, Vec<Diagnostic>), Vec<Diagnostic>> {
    let elements = element::read(file, text)?;
    let (sections, mut diagnostics) = sections(file, &elements);
    if has_errors(&diagnostics) {
        return Err(diagnostics);
    }
    let largest = widest(&sections);
    let blank = standard_blank_mm(largest).unwrap_or_else(|| {
        diagnostics.push(no_blank(file, largest));
        largest + BLANK_ALLOWANCE_MM
    });
    let mut document = Imported {
        name: roll_name(file),
        unit: Unit::Mm,
        machine: MACHINE.to_owned(),
        material: MATERIAL.to_owned(),
        bar_diameter: blank,
        length: largest_position(&sections),
        ends: Ends::One,
        part_off: false,
        automatic: false,
        sections,
        bore: Vec::new(),
    }
    .document(file)?;
    if let Some(part) = document.content.turned_part_mut() {
        part.form_tolerance = FORM_TOLERANCE_MM;
        part.holding = Holding::BetweenCentres;
        part.generator = Generator::Cycles { instructions: Vec::new() };
    }
    Ok((document, diagnostics))
}

/// True if a text begins with a line of numbers as roll profiles do.
pub(super) fn is_roll(text: &str) -> bool {
    text.lines().find(|line| !line.trim().is_empty()).is_some_and(|line| {
        let words: Vec<&str> = line.split_whitespace().collect();
        words.len() == element::COLUMNS && words.iter().all(|word| word.parse::<f64>().is_ok())
    })
}

/// The name of a roll from that of its file: `1470b-2T` of `E1470b-2T.txt`.
fn roll_name(file: &str) -> String {
    let name = name_of(Path::new(file));
    let bare = name.strip_prefix(['E', 'e']).filter(|rest| rest.starts_with(|c: char| c.is_ascii_digit()));
    bare.map_or_else(|| name.clone(), str::to_owned)
}

/// Largest diameter of any row, tops of arcs included, mm.
fn widest(sections: &[Section]) -> f64 {
    let tops = sections.iter().filter_map(row_curve).map(|curve| 2.0 * curve.bounds().max.r);
    tops.fold(largest_diameter(sections), f64::max)
}

fn no_blank(file: &str, largest: f64) -> Diagnostic {
    let message = format!(
        "The roll's largest diameter is {largest:.3} mm; no standard blank is {BLANK_ALLOWANCE_MM} mm larger. A bar of \
         {:.3} mm is taken.",
        largest + BLANK_ALLOWANCE_MM
    );
    Diagnostic::warning("roll-blank", file_place(Path::new(file)), message)
        .with_hint("Enter the diameter of the blank.")
}

/// The rows of the section table, one for each element, and what is to be said about them.
fn sections(file: &str, elements: &[Element]) -> (Vec<Section>, Vec<Diagnostic>) {
    let mut diagnostics = Vec::new();
    let nodes = corners::nodes(file, elements, &mut diagnostics);
    let ends = nodes.iter().zip(nodes.iter().skip(1));
    let rows = elements.iter().zip(ends).map(|(element, (&start, &end))| {
        let (z1, z2) = (rounded(start.z, COMPUTED_DECIMALS), rounded(end.z, COMPUTED_DECIMALS));
        let (d1, d2) = (rounded(2.0 * start.r, COMPUTED_DECIMALS), rounded(2.0 * end.r, COMPUTED_DECIMALS));
        let kind = match element.shape {
            Shape::Line => SectionKind::Line,
            Shape::Arc { center, ccw, .. } => {
                let radius = corners::fitted_radius(start, end, center);
                // A quarter turn or less may not become impossible by rounding.
                let radius = rounded(radius, RADIUS_DECIMALS).max(start.distance(end) / 2.0);
                if ccw { SectionKind::Concave { radius } } else { SectionKind::Convex { radius } }
            }
        };
        Section { id: element.number, z1, d1, z2, d2, kind }
    });
    let rows: Vec<Section> = rows.collect();
    for (element, row) in elements.iter().zip(&rows) {
        if row_curve(row).is_none() {
            let message = format!(
                "Element {} from z {:.3} mm, radius {:.3} mm to z {:.3} mm, radius {:.3} mm cannot be a row of the section \
                 table: z may not fall, and an arc may not run past its vertical tangent.",
                element.number,
                row.z1,
                row.d1 / 2.0,
                row.z2,
                row.d2 / 2.0
            );
            diagnostics.push(Diagnostic::error("roll-element", line_place(file, element.line, None), message));
        }
    }
    (rows, diagnostics)
}

fn rounded(value: f64, decimals: i32) -> f64 {
    let scale = 10_f64.powi(decimals);
    (value * scale).round() / scale
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::Content;

    const TOP: &str = include_str!("../../../tests/cases/1470b/E1470b-2T.txt");
    const BOTTOM: &str = include_str!("../../../tests/cases/1470b/E1470b-2B.txt");

    fn rows(text: &str) -> Vec<Section> {
        let (document, _) = roll("E1470b-2T.txt", text).unwrap();
        let Content::TurnedPart(part) = document.content else { unreachable!("a turned part") };
        part.sections
    }

    #[test]
    fn rows_are_the_elements_and_every_row_begins_where_the_one_before_ends() {
        for (text, count) in [(TOP, 38), (BOTTOM, 36)] {
            let rows = rows(text);
            assert_eq!(rows.iter().map(|r| r.id).collect::<Vec<_>>(), (1..=count).collect::<Vec<_>>());
            assert!(rows.windows(2).all(|w| (w[0].z2, w[0].d2) == (w[1].z1, w[1].d1)));
            assert!(rows.iter().all(|r| r.z2 >= r.z1));
        }
    }

    #[test]
    fn the_document_is_ready_for_the_published_lathe() {
        let (document, diagnostics) = roll("folder/E1470b-2T.txt", TOP).unwrap();
        assert_eq!(document.name, "1470b-2T");
        let Content::TurnedPart(part) = document.content else { unreachable!("a turned part") };
        assert_eq!((part.machine.as_str(), part.bar_diameter, part.length), ("mori-fanuc-6t", 160.0, 159.303));
        assert_eq!(part.holding, Holding::BetweenCentres);
        // Two corners so flat that their place follows from the crossing, and nothing else to say.
        assert_eq!(diagnostics.iter().map(|d| d.code.as_str()).collect::<Vec<_>>(), ["roll-corner"; 2]);
        assert_eq!(roll("E.txt", BOTTOM).unwrap().1, []);
    }

    #[test]
    fn recomputed_centres_are_the_published_ones() {
        for text in [TOP, BOTTOM] {
            let elements = element::read("E", text).unwrap();
            for (element, row) in elements.iter().zip(rows(text)) {
                let Shape::Arc { center, .. } = element.shape else { continue };
                let Some(crate::part::Curve::Segment(crate::geometry::Segment::Arc { center: made, .. })) =
                    row_curve(&row)
                else {
                    panic!("an arc")
                };
                // Ends, centre and radius are each rounded to 0.001 mm; short arcs turn that into up to three of them.
                assert!(made.distance(center) < 0.003, "element {}: {}", element.number, made.distance(center));
            }
        }
    }

    #[test]
    fn walls_are_square_to_the_spindle() {
        let rows = rows(TOP);
        assert_eq!((rows[34].z1, rows[34].z2, rows[34].d2), (146.303, 146.303, 131.336));
        assert_eq!(rows[3].kind, SectionKind::Line);
    }

    #[test]
    fn a_roll_above_the_largest_blank_asks() {
        let text = "1 1 0 0 0 101 1 0 0 0\n2 1 0 101 50 101 0 1 -101 0\n0 0 0 0 0 0 0 0 0 0\n";
        let (document, diagnostics) = roll("big.txt", text).unwrap();
        let Content::TurnedPart(part) = document.content else { unreachable!("a turned part") };
        assert_eq!((part.bar_diameter, diagnostics[0].code.as_str()), (212.0, "roll-blank"));
    }
}
