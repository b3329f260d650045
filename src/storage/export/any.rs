//! Writing a document as any kind of file, by the extension.

use super::{cad, csv, dxf, svg, tsv};
use crate::diagnostic::{Diagnostic, Place};
use crate::document::{Document, TurnedPart};
use crate::machine::Catalog;
use crate::part::{self, PartContour, Profile, Section};
use crate::storage::{bore_beside, replace_file, save_document};
use crate::textfile::file_place;
use std::path::Path;

/// Largest distance of an exported arc from a parabola, mm: a hundredth of what shows on a drawing.
const PARABOLA_TOLERANCE_MM: f64 = 0.001;

/// Writes `document` as a document (`.turn`), an ORACAP part (`.cad` with `.SIZ` and `.END` beside it), a drawing of its
/// profile (`.dxf`, `.svg`) or its section table (`.csv`, `.tsv`; the table of a bore as `NAME.bore.csv` beside it).
///
/// Returns what there is to say about it, such as settings that the kind of file cannot hold.
///
/// # Errors
/// Diagnostics if the extension is none of these, no profile can be made, or a file cannot be written.
pub fn any(document: &Document, catalog: &Catalog, path: &Path) -> Result<Vec<Diagnostic>, Vec<Diagnostic>> {
    let extension = path.extension().map(|e| e.to_string_lossy().to_ascii_lowercase()).unwrap_or_default();
    let mut diagnostics = Vec::new();
    if extension == "turn" {
        return save_document(path, document).map(|()| diagnostics).map_err(|d| vec![d]);
    }
    let Some(part) = document.content.turned_part() else { return Err(vec![unknown(path, &extension)]) };
    let written = match extension.as_str() {
        "cad" => {
            let (texts, more) = cad(document, part);
            diagnostics.extend(more);
            write(path, &texts.cad)
                .and_then(|()| texts.siz.map_or(Ok(()), |text| write(&path.with_extension("SIZ"), &text)))
                .and_then(|()| texts.end.map_or(Ok(()), |text| write(&path.with_extension("END"), &text)))
        }
        "dxf" => {
            let (contour, bore) = contours(document, part, catalog, &mut diagnostics)?;
            dxf(&contour, bore.as_ref(), document.unit).and_then(|text| write(path, &text))
        }
        "svg" => {
            let (contour, bore) = contours(document, part, catalog, &mut diagnostics)?;
            write(path, &svg(&contour, bore.as_ref(), &document.name))
        }
        "csv" => tables(path, part, |rows| csv(rows, document.unit)),
        "tsv" => tables(path, part, tsv),
        _ => Err(unknown(path, &extension)),
    };
    written.map(|()| diagnostics).map_err(|d| vec![d])
}

fn write(path: &Path, text: &str) -> Result<(), Diagnostic> {
    replace_file(path, text.as_bytes())
}

/// Writes the section table and, with a bore, its table beside it.
fn tables(path: &Path, part: &TurnedPart, text: impl Fn(&[Section]) -> String) -> Result<(), Diagnostic> {
    write(path, &text(&part.sections))?;
    if part.bore.is_empty() { Ok(()) } else { write(&bore_beside(path), &text(&part.bore)) }
}

/// The whole finished outside and the bore as lines and arcs, in mm, as the part is clamped first.
fn contours(
    document: &Document,
    part: &TurnedPart,
    catalog: &Catalog,
    diagnostics: &mut Vec<Diagnostic>,
) -> Result<(PartContour, Option<PartContour>), Vec<Diagnostic>> {
    let Some(machine) = catalog.machine(&part.machine) else {
        let at = Place::Machine { id: part.machine.clone() };
        return Err(vec![Diagnostic::error(
            "unknown-machine",
            at,
            format!("There is no machine \"{}\".", part.machine),
        )]);
    };
    let (setups, found) = part::setups(&part.scaled(document.unit.in_mm()), machine);
    diagnostics.extend(found);
    let of = |profile: &Profile| part::contour(profile, PARABOLA_TOLERANCE_MM);
    let first = setups.first().map(|setup| (of(&setup.profile), setup.bore.as_ref().map(of)));
    first.ok_or_else(|| std::mem::take(diagnostics))
}

fn unknown(path: &Path, extension: &str) -> Diagnostic {
    let message = format!("A part cannot be written as \".{extension}\".");
    Diagnostic::error("unknown-file-kind", file_place(path), message)
        .with_hint("Use .turn, .cad, .dxf, .svg, .csv or .tsv.")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnostic::has_errors;
    use crate::document::Content;
    use crate::storage::{document_from_text, examples, examples_of, import};

    #[test]
    fn every_example_is_written_as_every_kind_and_read_back() {
        let folder = tempfile::tempdir().unwrap();
        let catalog = Catalog::shipped();
        for example in examples_of(crate::document::Kind::TurnedPart) {
            let document = document_from_text(example.name, example.text).unwrap();
            for extension in ["turn", "CAD", "dxf", "svg", "csv", "tsv"] {
                let path = folder.path().join(example.name).with_extension(extension);
                let diagnostics = any(&document, &catalog, &path).unwrap();
                assert!(!has_errors(&diagnostics), "{diagnostics:?}");
                if !matches!(extension, "svg" | "csv") {
                    let (again, diagnostics) = import::any(&path, "orac").unwrap();
                    assert!(!has_errors(&diagnostics), "{path:?} {diagnostics:?}");
                    assert_eq!(again.name, document.name);
                }
            }
        }
    }

    #[test]
    fn a_bore_is_written_beside_the_table_and_what_a_kind_cannot_hold_is_said() {
        let folder = tempfile::tempdir().unwrap();
        let catalog = Catalog::shipped();
        let mut document = document_from_text("", examples()[0].text).unwrap();
        let Content::TurnedPart(part) = &mut document.content else { unreachable!("a turned part") };
        part.bore = vec![Section::line(900, 10.0, 3.0, part.length, 3.0)];
        let bore = part.bore.clone();
        for extension in ["tsv", "csv", "dxf", "svg", "turn"] {
            let path = folder.path().join("a").with_extension(extension);
            assert_eq!(any(&document, &catalog, &path).unwrap(), []);
            if matches!(extension, "tsv" | "dxf" | "turn") {
                let (again, diagnostics) = import::any(&path, "orac").unwrap();
                assert!(!has_errors(&diagnostics), "{diagnostics:?}");
                let Content::TurnedPart(part) = again.content else { unreachable!("a turned part") };
                let ends = |rows: &[Section]| rows.iter().map(|s| [s.z1, s.d1, s.z2, s.d2]).collect::<Vec<_>>();
                assert_eq!(ends(&part.bore), ends(&bore));
            }
        }
        assert!(folder.path().join("a.bore.csv").exists());
        let said = any(&document, &catalog, &folder.path().join("a.CAD")).unwrap();
        assert!(said.iter().any(|d| d.code == "cad-no-bore" && d.message.contains("1 in number")));
    }

    #[test]
    fn unknown_kinds_and_machines_are_refused() {
        let folder = tempfile::tempdir().unwrap();
        let document = document_from_text("", examples()[0].text).unwrap();
        let fault = any(&document, &Catalog::shipped(), &folder.path().join("a.step")).unwrap_err();
        assert!(fault[0].message.contains(".step"));
        let fault = any(&document, &Catalog::default(), &folder.path().join("a.dxf")).unwrap_err();
        assert!(fault[0].message.contains("\"orac\""));
    }
}
