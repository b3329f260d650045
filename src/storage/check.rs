//! What every document on disk fulfils. Checked when a document is read and before it is written, so that whatever was
//! saved can be opened again. Whether the part can be made is a question for the part's own checks, not for this one.

use crate::diagnostic::{Column, Place, SectionTable};
use crate::document::{
    Content, Document, Ends, FORMAT_VERSION, FormerShape, Generator, ParabolaCut, Shell, TurnedPart,
};
use crate::part::{STARTS, Section, SectionKind};
use std::collections::BTreeMap;
use std::ops::RangeInclusive;

/// Most rows of a section table.
pub(super) const MOST_SECTIONS: usize = 10_000;
/// Chords of a parabola.
const CHORDS: RangeInclusive<u32> = 1..=1000;
/// Longest name, characters: with a suffix and an extension it must fit into a file name.
const LONGEST_NAME: usize = 64;

/// A value that no document may have.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Fault {
    /// Keys and list indices from the top of the file down to the value, joined by dots.
    pub(super) path: String,
    /// The place in the document.
    pub(super) at: Place,
    /// A sentence with the value and the limit.
    pub(super) message: String,
}

/// Every fault of `document`, in the order of the file.
pub(super) fn faults(document: &Document) -> Vec<Fault> {
    let mut faults = Vec::new();
    let mut add = |path: &str, message: String| {
        faults.push(Fault { path: path.to_owned(), at: Place::Document, message });
    };
    if document.turnwright != FORMAT_VERSION {
        add(
            "turnwright",
            format!("The version is {}; this program writes version {FORMAT_VERSION}.", document.turnwright),
        );
    }
    if let Some(message) = name_fault(&document.name) {
        add("name", message);
    }
    match &document.content {
        Content::TurnedPart(part) => part_faults(part, &mut faults),
        Content::RollSet(set) => super::roll_set_check::faults(set, &mut faults),
        Content::Shell(shell) => shell_faults(shell, &mut faults),
    }
    faults
}

/// Figures of a shell that are none, and tables that are too long; what else they cannot be is said by the rules of the
/// process.
fn shell_faults(shell: &Shell, faults: &mut Vec<Fault>) {
    if let FormerShape::Sections { sections } = &shell.former.shape
        && sections.len() > MOST_SECTIONS
    {
        let at = Place::Setting { path: "former.shape.sections".to_owned() };
        let message = format!("The table has {} rows; the limit is {MOST_SECTIONS}.", sections.len());
        faults.push(Fault { path: "content.shell.former.shape.sections".to_owned(), at, message });
    }
    for (path, value) in shell.figures().into_iter().filter(|(_, value)| !value.is_finite()) {
        let at = Place::Setting { path: path.clone() };
        let keys = path.replace('[', ".").replace(']', "");
        faults.push(Fault { path: format!("content.shell.{keys}"), at, message: not_finite(value) });
    }
}

/// Why a document cannot have this name: programs and exported files are named after it.
fn name_fault(name: &str) -> Option<String> {
    let characters = name.chars().count();
    if name.trim().is_empty() || name.starts_with('.') {
        return Some(format!(
            "The name is \"{name}\"; it must have a character other than a blank and not begin with a dot."
        ));
    }
    if characters > LONGEST_NAME {
        return Some(format!("The name has {characters} characters; the limit is {LONGEST_NAME}."));
    }
    let bad = name.chars().find(|c| c.is_control() || "/\\:*?\"<>|".contains(*c))?;
    Some(format!("The name \"{}\" contains {bad:?}, which no file name can contain.", name.escape_debug()))
}

fn part_faults(part: &TurnedPart, faults: &mut Vec<Fault>) {
    let mut add = |key: &str, at: Place, message: String| {
        faults.push(Fault { path: format!("content.turned_part.{key}"), at, message });
    };
    let split = if let Ends::Two { split } = part.ends { split } else { None };
    let tolerance =
        if let ParabolaCut::Arcs { tolerance } = part.generator.parabolas() { Some(tolerance) } else { None };
    for (key, at, value) in [
        ("bar_diameter", Place::Stock, part.bar_diameter),
        ("stock_bore_diameter", Place::Stock, part.stock_bore_diameter),
        ("facing_allowance", Place::Stock, part.facing_allowance),
        ("length", Place::Document, part.length),
        ("form_tolerance", Place::Document, part.form_tolerance),
        ("ends.split", Place::Document, split.unwrap_or(0.0)),
    ] {
        if !value.is_finite() {
            add(key, at, not_finite(value));
        }
    }
    for (key, value) in [("form_tolerance", Some(part.form_tolerance)), ("generator.parabolas.tolerance", tolerance)] {
        if let Some(value) = value.filter(|v| !(v.is_finite() && *v > 0.0)) {
            add(key, Place::Document, format!("The tolerance is {value}; it must be a number greater than 0."));
        }
    }
    if let Generator::Cycles { instructions } = &part.generator {
        for (index, instruction) in instructions.iter().enumerate() {
            for (key, value) in instruction.figures() {
                if !value.is_finite() {
                    add(&format!("generator.instructions.{index}.{key}"), Place::Document, not_finite(value));
                }
            }
        }
    }
    let mut rows_by_id = BTreeMap::new();
    for (key, table, rows) in
        [("sections", SectionTable::Outside, &part.sections), ("bore", SectionTable::Bore, &part.bore)]
    {
        if rows.len() > MOST_SECTIONS {
            let path = format!("content.turned_part.{key}");
            let message = format!("The table has {} rows; the limit is {MOST_SECTIONS}.", rows.len());
            faults.push(Fault { path, at: Place::Document, message });
        }
        section_faults(key, table, rows, &mut rows_by_id, faults);
    }
}

/// Faults of the rows of one table. Ids are unique over both tables; `rows_by_id` knows the rows before.
fn section_faults(
    list: &str,
    table: SectionTable,
    sections: &[Section],
    rows_by_id: &mut BTreeMap<u32, String>,
    faults: &mut Vec<Fault>,
) {
    for (i, section) in sections.iter().enumerate() {
        let row = i + 1;
        let mut add = |key: &str, column: Option<Column>, message: String| {
            let at = Place::Section { id: section.id, table, row, column };
            faults.push(Fault { path: format!("content.turned_part.{list}.{i}.{key}"), at, message });
        };
        let name = format!("{table} {row}");
        if let Some(first) = rows_by_id.insert(section.id, name.clone()) {
            let message =
                format!("There are {first} and {name} with the same id, {}; every row has its own.", section.id);
            add("id", None, message);
        }
        for (key, column, value) in lengths(section) {
            if !value.is_finite() {
                add(key, Some(column), not_finite(value));
            }
        }
        if let SectionKind::Thread { starts, .. } = section.kind
            && !STARTS.contains(&starts)
        {
            let (least, most) = (STARTS.start(), STARTS.end());
            add(
                "starts",
                Some(Column::Starts),
                format!("The thread has {starts} starts; it must have {least} to {most}."),
            );
        }
        if let Some(chords) = chords(section).filter(|c| !CHORDS.contains(c)) {
            let (least, most) = (CHORDS.start(), CHORDS.end());
            add(
                "chords",
                Some(Column::Chords),
                format!("The parabola has {chords} chords; it must have {least} to {most}."),
            );
        }
    }
}

fn not_finite(value: f64) -> String {
    format!("The value is {value}; it must be a finite number.")
}

/// Every length of a row with its key in the file and its column.
fn lengths(section: &Section) -> Vec<(&'static str, Column, f64)> {
    let mut lengths = vec![
        ("z1", Column::Z1, section.z1),
        ("d1", Column::D1, section.d1),
        ("z2", Column::Z2, section.z2),
        ("d2", Column::D2, section.d2),
    ];
    match section.kind {
        SectionKind::Line => {}
        SectionKind::Concave { radius } | SectionKind::Convex { radius } => {
            lengths.push(("radius", Column::Radius, radius));
        }
        SectionKind::Thread { pitch, .. } => lengths.push(("pitch", Column::Pitch, pitch)),
        SectionKind::ParabolaAlongZ { z3, d3, .. } | SectionKind::ParabolaAlongX { z3, d3, .. } => {
            lengths.extend([("z3", Column::Z3, z3), ("d3", Column::D3, d3)]);
        }
    }
    lengths
}

const fn chords(section: &Section) -> Option<u32> {
    match section.kind {
        SectionKind::ParabolaAlongZ { chords, .. } | SectionKind::ParabolaAlongX { chords, .. } => Some(chords),
        _ => None,
    }
}
