//! Rows and cells of the section table as a spreadsheet's text: one line a row, tabs between cells.

use super::cells;
use crate::diagnostic::{Column, SectionTable};
use crate::document::TurnedPart;
use crate::part::Section;
use crate::storage::import::tsv;
use crate::units::Unit;

/// All columns in the order of the text.
pub(crate) const COLUMNS: [Column; 11] = [
    Column::Kind,
    Column::Z1,
    Column::D1,
    Column::Z2,
    Column::D2,
    Column::Radius,
    Column::Pitch,
    Column::Z3,
    Column::D3,
    Column::Chords,
    Column::Starts,
];

/// Pastes `text` into a table at `row` and `column`. Lines that begin with a section type are whole rows from `row`
/// on; others fill cells to the right and downwards. Rows are added where the text is longer than the table.
///
/// # Errors
/// A sentence with line and cell of what does not fit; nothing is pasted then.
pub(crate) fn paste(
    part: &mut TurnedPart,
    table: SectionTable,
    row: usize,
    column: Column,
    text: &str,
    unit: Unit,
) -> Result<usize, String> {
    let lines: Vec<&str> = text.lines().filter(|line| !line.trim().is_empty()).collect();
    if lines.is_empty() {
        return Err("There is nothing on the clipboard to paste.".to_owned());
    }
    if lines.iter().any(|line| is_whole_row(line)) {
        return paste_rows(part, table, row, text, unit);
    }
    let mut edited = part.clone();
    for (offset, line) in lines.iter().enumerate() {
        let index = row + offset;
        if index >= edited.table(table).len() {
            let id = edited.unused_section_id();
            let (z, d) = edited.table(table).last().map_or((0.0, edited.bar_diameter), |s| (s.z2, s.d2));
            edited.table_mut(table).push(Section::line(id, z, d, z, d));
        }
        let Some(section) = edited.table_mut(table).get_mut(index) else { continue };
        paste_line(section, column, line, unit).map_err(|reason| format!("Line {}: {reason}", offset + 1))?;
    }
    *part = edited;
    Ok(lines.len())
}

fn is_whole_row(line: &str) -> bool {
    let mut cells = line.split('\t');
    let kind = cells.next().unwrap_or_default();
    cells.next().is_some() && cells::find_kind(kind).is_ok()
}

/// Whole rows in the places of those from `row` on; ids of rows that were there stay.
fn paste_rows(part: &mut TurnedPart, table: SectionTable, row: usize, text: &str, unit: Unit) -> Result<usize, String> {
    let (rows, complaints) = tsv("clipboard", text, unit, part.unused_section_id());
    if let Some(complaint) = complaints.first() {
        return Err(format!("{}: {}", complaint.at, complaint.message));
    }
    let count = rows.len();
    let sections = part.table_mut(table);
    for (index, pasted) in (row..).zip(rows) {
        match sections.get_mut(index) {
            Some(present) => *present = Section { id: present.id, ..pasted },
            None => sections.push(pasted),
        }
    }
    Ok(count)
}

fn paste_line(section: &mut Section, column: Column, line: &str, unit: Unit) -> Result<(), String> {
    let cells: Vec<&str> = line.split('\t').map(str::trim).collect();
    let columns = COLUMNS.iter().skip_while(|c| **c != column);
    for (cell, column) in cells.iter().zip(columns).filter(|(cell, _)| !cell.is_empty()) {
        cells::set(section, *column, cell, unit).map_err(|reason| format!("{column}: {reason}"))?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::Ends;
    use crate::part::SectionKind;

    fn part(sections: Vec<Section>) -> TurnedPart {
        TurnedPart {
            machine: "orac".into(),
            material: "aluminium".into(),
            bar_diameter: 26.0,
            length: 30.0,
            ends: Ends::One,
            part_off: false,
            automatic: false,
            form_tolerance: 0.1,
            sections,
            ..TurnedPart::default()
        }
    }

    #[test]
    fn rows_copied_and_pasted_are_the_same() {
        let mut rows = vec![Section::line(1, 0.0, 20.0, 10.0, 16.0), Section::line(2, 10.0, 16.0, 14.0, 12.0)];
        rows[1].kind = SectionKind::Concave { radius: 7.5 };
        let text = crate::storage::export::tsv(&rows);
        let mut pasted = part(Vec::new());
        assert_eq!(paste(&mut pasted, SectionTable::Outside, 0, Column::Kind, &text, Unit::Mm), Ok(2));
        assert_eq!(pasted.sections, rows);
    }

    #[test]
    fn figures_fill_cells_to_the_right_and_downwards() {
        let mut p = part(vec![Section::line(1, 0.0, 20.0, 10.0, 16.0)]);
        paste(&mut p, SectionTable::Outside, 0, Column::Z2, "11\t17\n12\t18\n", Unit::Mm).unwrap();
        assert_eq!((p.sections[0].z2, p.sections[0].d2), (11.0, 17.0));
        assert_eq!((p.sections[1].z1, p.sections[1].z2, p.sections[1].d2), (11.0, 12.0, 18.0));
    }

    #[test]
    fn a_bad_cell_names_its_place_and_pastes_nothing() {
        let mut p = part(vec![Section::line(1, 0.0, 20.0, 10.0, 16.0)]);
        let before = p.clone();
        let reason = paste(&mut p, SectionTable::Outside, 0, Column::Z1, "1\t2\n3\tx", Unit::Mm).unwrap_err();
        assert!(reason.starts_with("Line 2: ⌀ start:"), "{reason}");
        assert_eq!(p, before);
    }

    #[test]
    fn rows_go_into_the_table_that_is_shown() {
        let mut p = part(vec![Section::line(1, 0.0, 20.0, 30.0, 20.0)]);
        paste(&mut p, SectionTable::Bore, 0, Column::Kind, "line\t0\t8\t30\t8\n", Unit::Mm).unwrap();
        assert_eq!((p.sections.len(), &p.bore), (1, &vec![Section::line(2, 0.0, 8.0, 30.0, 8.0)]));
    }
}
