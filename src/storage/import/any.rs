//! Opening any file that holds a part.

use super::roll::is_roll;
use super::{
    CadTexts, Imported, MidLineThickness, cad, dxf, instructions, name_of, roll, roll_design, roll_flower,
    roll_section, roll_section_dxf, tsv,
};
use crate::diagnostic::Diagnostic;
use crate::document::Document;
use crate::part::Section;
use crate::storage::{bore_beside, open_document};
use crate::textfile::{self, file_place};
use crate::units::Unit;
use std::path::{Path, PathBuf};

/// Longest file that is imported, bytes.
const MOST_BYTES: u64 = 64 << 20;

/// Kinds of file that hold a part.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kind {
    Turn,
    Cad,
    Dxf,
    Table,
    Roll,
    RollSection,
}

/// Opens a document (`.turn`) or imports an ORACAP part (`.CAD`, with `.SIZ` and `.END` beside it), a profile (`.dxf`),
/// a section table (`.tsv`, in mm, with that of a bore as `NAME.bore.tsv` beside it), the profile of a form-roll (`.txt`,
/// in E layout) or the published input of a finished section (`.json`). The kind goes by the extension, or by the content where there is none that is known. A file
/// that names no machine gets `default_machine`, a form-roll the lathe of the published ones.
///
/// Returns the document and what there is to say about it.
///
/// # Errors
/// Diagnostics with file, line, value and limit if no document can be made of the file.
pub fn any(path: &Path, default_machine: &str) -> Result<(Document, Vec<Diagnostic>), Vec<Diagnostic>> {
    let kind = match kind_by_extension(path) {
        Some(kind) => kind,
        None => kind_by_content(path).map_err(|d| vec![d])?,
    };
    match kind {
        Kind::Turn => open_document(path).map(|document| (document, Vec::new())),
        Kind::Cad => any_cad(path, default_machine),
        Kind::Dxf => {
            let bytes = textfile::read_bytes(path, MOST_BYTES).map_err(|d| vec![d])?;
            dxf(&path.display().to_string(), &name_of(path), &bytes, default_machine)
        }
        Kind::Table => any_table(path, default_machine),
        Kind::Roll => {
            let text = textfile::read(path, MOST_BYTES).map_err(|d| vec![d])?;
            roll(&path.display().to_string(), &text)
        }
        Kind::RollSection => {
            let text = textfile::read(path, MOST_BYTES).map_err(|d| vec![d])?;
            roll_section(&path.display().to_string(), &text)
        }
    }
}

/// Makes a set of form-rolls of a drawing (`.dxf`) of its cross-section: a closed outline, or a mid-line with its `thickness`.
///
/// # Errors
/// Diagnostics with the values if the file cannot be read or shows no section.
pub fn section_drawing(
    path: &Path,
    thickness: MidLineThickness,
) -> Result<(Document, Vec<Diagnostic>), Vec<Diagnostic>> {
    let bytes = textfile::read_bytes(path, MOST_BYTES).map_err(|d| vec![d])?;
    roll_section_dxf(&path.display().to_string(), &bytes, thickness)
}

/// Gives a set of form-rolls the stations and angles of a published flower (`.json`).
///
/// # Errors
/// Diagnostics with file, line, field, value and limit if the file cannot be used.
pub fn with_flower(document: Document, path: &Path) -> Result<(Document, Vec<Diagnostic>), Vec<Diagnostic>> {
    let text = textfile::read(path, MOST_BYTES).map_err(|d| vec![d])?;
    roll_flower(&path.display().to_string(), &text, document)
}

/// Gives the stations of a set of form-rolls a published roll design (`.json`).
///
/// # Errors
/// Diagnostics with file, line, field, value and limit if the file cannot be used.
pub fn with_design(document: Document, path: &Path) -> Result<(Document, Vec<Diagnostic>), Vec<Diagnostic>> {
    let text = textfile::read(path, MOST_BYTES).map_err(|d| vec![d])?;
    roll_design(&path.display().to_string(), &text, document)
}

/// Gives a document the cutting instructions of a CU file (`.json`) for the published form-roll cycles.
///
/// # Errors
/// Diagnostics with file, line, field, value and limit if the file cannot be used.
pub fn with_instructions(document: Document, path: &Path) -> Result<(Document, Vec<Diagnostic>), Vec<Diagnostic>> {
    let text = textfile::read(path, MOST_BYTES).map_err(|d| vec![d])?;
    instructions(&path.display().to_string(), &text, document)
}

fn kind_by_extension(path: &Path) -> Option<Kind> {
    match path.extension()?.to_str()?.to_ascii_lowercase().as_str() {
        "turn" => Some(Kind::Turn),
        "cad" => Some(Kind::Cad),
        "dxf" => Some(Kind::Dxf),
        "tsv" => Some(Kind::Table),
        "txt" => Some(Kind::Roll),
        "json" => Some(Kind::RollSection),
        _ => None,
    }
}

fn kind_by_content(path: &Path) -> Result<Kind, Diagnostic> {
    let bytes = textfile::read_bytes(path, MOST_BYTES)?;
    let text = String::from_utf8_lossy(&bytes);
    let has = |word: &str| text.contains(word);
    match text.trim_start().chars().next() {
        Some('{') => Ok(Kind::Turn),
        _ if has("SECTION") && has("ENTITIES") => Ok(Kind::Dxf),
        _ if has("PART=") && has("INCH=") => Ok(Kind::Cad),
        _ if has("z1\td1") => Ok(Kind::Table),
        _ if is_roll(&text) => Ok(Kind::Roll),
        _ => {
            let shown: String = text.chars().take(20).collect();
            let message =
                format!("This is no kind of file that holds a part ({} bytes, beginning with {shown:?}).", bytes.len());
            Err(Diagnostic::error("unknown-file-kind", file_place(path), message)
                .with_hint("Open a .turn document, an ORACAP .CAD file, a .dxf profile, a .tsv section table or the .txt profile of a roll."))
        }
    }
}

fn any_cad(path: &Path, machine: &str) -> Result<(Document, Vec<Diagnostic>), Vec<Diagnostic>> {
    let text = textfile::read(path, MOST_BYTES).map_err(|d| vec![d])?;
    let mut diagnostics = Vec::new();
    let mut beside = |extension: &str| {
        let file = sibling(path, extension)?;
        textfile::read(&file, MOST_BYTES).map_err(|d| diagnostics.push(d)).ok()
    };
    let (siz, end) = (beside("SIZ"), beside("END"));
    let texts = CadTexts { cad: text, siz, end };
    let (document, more) = cad(&path.display().to_string(), &name_of(path), &texts, machine)?;
    diagnostics.extend(more);
    Ok((document, diagnostics))
}

/// The file beside `path` with this extension in upper, lower or capitalised letters.
fn sibling(path: &Path, extension: &str) -> Option<PathBuf> {
    let lower = extension.to_ascii_lowercase();
    let capital = extension.chars().take(1).chain(lower.chars().skip(1)).collect();
    [extension.to_owned(), lower, capital].iter().map(|e| path.with_extension(e)).find(|p| p.exists())
}

/// The rows of the bore's table beside `path`, if there is one; `rows` ids are taken already.
fn bore_table(path: &Path, rows: usize) -> Result<(Vec<Section>, Vec<Diagnostic>), Diagnostic> {
    let beside = bore_beside(path);
    if !beside.exists() {
        return Ok((Vec::new(), Vec::new()));
    }
    let text = textfile::read(&beside, MOST_BYTES)?;
    let first_id = u32::try_from(rows).unwrap_or(u32::MAX).saturating_add(1);
    Ok(tsv(&beside.display().to_string(), &text, Unit::Mm, first_id))
}

fn any_table(path: &Path, machine: &str) -> Result<(Document, Vec<Diagnostic>), Vec<Diagnostic>> {
    let text = textfile::read(path, MOST_BYTES).map_err(|d| vec![d])?;
    let file = path.display().to_string();
    let (sections, mut diagnostics) = tsv(&file, &text, Unit::Mm, 1);
    if sections.is_empty() {
        let none =
            Diagnostic::error("no-sections", file_place(path), "The file has 0 rows that can be read; 1 is needed.");
        return Err(diagnostics.into_iter().chain([none]).collect());
    }
    let (bore, more) = bore_table(path, sections.len()).map_err(|d| vec![d])?;
    diagnostics.extend(more);
    let document = Imported::of_rows(name_of(path), Unit::Mm, machine, [sections, bore]).document(&file)?;
    Ok((document, diagnostics))
}
