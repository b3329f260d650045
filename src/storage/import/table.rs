//! Section rows from a spreadsheet: cells apart by tabs, one row a line.

use crate::diagnostic::Diagnostic;
use crate::part::{STARTS, Section, SectionKind};
use crate::storage::export::COLUMNS;
use crate::textfile::line_place;
use crate::units::{Unit, parse_length};

/// Reads rows as [`crate::storage::export::tsv`] writes them: type, z1, d1, z2, d2, radius, pitch, z3, d3, chords, starts. A row of
/// column names at the top and empty lines are passed over; cells behind the ones a type needs may be missing. Lengths may
/// be expressions and carry a unit. `file` is the name for messages (`clipboard` for a paste); the rows get the ids from
/// `first_id` on.
///
/// A row with a cell that cannot be read is left out, with a diagnostic for every such cell (line = row, column = cell);
/// the other rows are returned.
#[must_use]
pub fn tsv(file: &str, text: &str, unit: Unit, first_id: u32) -> (Vec<Section>, Vec<Diagnostic>) {
    let mut sections = Vec::new();
    let mut diagnostics = Vec::new();
    let rows = (1..).zip(text.lines()).filter(|(_, line)| !line.trim().is_empty());
    for (number, line) in rows {
        let cells: Vec<String> = line.split('\t').map(unquoted).collect();
        if cells.first().map(String::as_str) == COLUMNS.first().copied() {
            continue;
        }
        let mut row = Row { file, number, cells, unit, diagnostics: &mut diagnostics };
        let id = u32::try_from(sections.len()).ok().and_then(|n| first_id.checked_add(n));
        if let Some(section) = id.and_then(|id| row.section(id)) {
            sections.push(section);
        }
    }
    (sections, diagnostics)
}

/// A cell without the quotes that a spreadsheet puts around one with quotes inside, such as `"3/8"""`.
fn unquoted(cell: &str) -> String {
    let cell = cell.trim();
    let inside = cell.strip_prefix('"').and_then(|c| c.strip_suffix('"'));
    inside.map_or_else(|| cell.to_owned(), |inside| inside.replace("\"\"", "\""))
}

struct Row<'a> {
    file: &'a str,
    number: usize,
    cells: Vec<String>,
    unit: Unit,
    diagnostics: &'a mut Vec<Diagnostic>,
}

impl Row<'_> {
    /// The section, if every cell that its type needs can be read. All of them are looked at, so that all are reported.
    fn section(&mut self, id: u32) -> Option<Section> {
        let ends = [self.length(1), self.length(2), self.length(3), self.length(4)];
        let kind = self.kind();
        let [z1, d1, z2, d2] = ends;
        Some(Section { id, z1: z1?, d1: d1?, z2: z2?, d2: d2?, kind: kind? })
    }

    fn kind(&mut self) -> Option<SectionKind> {
        let cell = self.cell(0).to_lowercase();
        let is = |kind: &SectionKind| kind.name() == cell;
        let (radius, pitch, starts, z3, d3, chords) = (0.0, 0.0, 1, 0.0, 0.0, 0);
        let kinds = [
            SectionKind::Line,
            SectionKind::Concave { radius },
            SectionKind::Convex { radius },
            SectionKind::Thread { pitch, starts },
            SectionKind::ParabolaAlongZ { z3, d3, chords },
            SectionKind::ParabolaAlongX { z3, d3, chords },
        ];
        let names: Vec<&str> = kinds.iter().map(SectionKind::name).collect();
        let Some(kind) = kinds.iter().find(|k| is(k)) else {
            self.refuse(0, &format!("it must be one of {}", names.join(", ")));
            return None;
        };
        Some(match kind {
            SectionKind::Line => SectionKind::Line,
            SectionKind::Concave { .. } => SectionKind::Concave { radius: self.length(5)? },
            SectionKind::Convex { .. } => SectionKind::Convex { radius: self.length(5)? },
            SectionKind::Thread { .. } => {
                let starts = self.starts();
                SectionKind::Thread { pitch: self.length(6)?, starts: starts? }
            }
            SectionKind::ParabolaAlongZ { .. } => {
                let (z3, d3, chords) = self.parabola()?;
                SectionKind::ParabolaAlongZ { z3, d3, chords }
            }
            SectionKind::ParabolaAlongX { .. } => {
                let (z3, d3, chords) = self.parabola()?;
                SectionKind::ParabolaAlongX { z3, d3, chords }
            }
        })
    }

    /// Starts of a thread; 1 where the cell is empty or missing.
    fn starts(&mut self) -> Option<u32> {
        let cell = self.cell(10);
        let starts = if cell.is_empty() { Some(1) } else { cell.parse().ok().filter(|s| STARTS.contains(s)) };
        if starts.is_none() {
            self.refuse(10, &format!("it must be a whole number from {} to {}", STARTS.start(), STARTS.end()));
        }
        starts
    }

    fn parabola(&mut self) -> Option<(f64, f64, u32)> {
        let (z3, d3) = (self.length(7), self.length(8));
        let chords = self.cell(9).parse().ok().filter(|c| (1..=1000).contains(c));
        if chords.is_none() {
            self.refuse(9, "it must be a whole number from 1 to 1000");
        }
        Some((z3?, d3?, chords?))
    }

    /// The text of a cell; empty if the row is too short.
    fn cell(&self, index: usize) -> &str {
        self.cells.get(index).map_or("", String::as_str)
    }

    fn length(&mut self, index: usize) -> Option<f64> {
        let cell = self.cell(index);
        // A plain number may have an exponent, which an expression may not.
        let plain = cell.parse::<f64>().ok().filter(|v| v.is_finite());
        match plain.map_or_else(|| parse_length(cell, self.unit), Ok) {
            Ok(length) => Some(length),
            Err(reason) => {
                self.refuse(index, &format!("it must be a length. {}", reason.trim_end_matches('.')));
                None
            }
        }
    }

    fn refuse(&mut self, index: usize, limit: &str) {
        let cell = self.cell(index);
        let column = COLUMNS.get(index).copied().unwrap_or_default();
        let message = format!("Row {}, column {} ({column}): the cell is \"{cell}\"; {limit}.", self.number, index + 1);
        self.diagnostics.push(
            Diagnostic::error("table-cell", line_place(self.file, self.number, Some(index + 1)), message)
                .with_hint("The row is left out."),
        );
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnostic::Place;
    use crate::document::Content;
    use crate::storage::{document_from_text, examples_of, export};

    #[test]
    fn a_copied_table_is_pasted_as_it_was() {
        for example in examples_of(crate::document::Kind::TurnedPart) {
            let document = document_from_text(example.name, example.text).unwrap();
            let Content::TurnedPart(part) = document.content else { unreachable!("a turned part") };
            let (sections, diagnostics) = tsv("clipboard", &export::tsv(&part.sections), document.unit, 1);
            assert_eq!(diagnostics, []);
            assert_eq!(sections, part.sections);
        }
    }

    #[test]
    fn expressions_units_and_decimal_commas_are_read() {
        let (sections, diagnostics) =
            tsv("clipboard", "Line\t0\t1in\t25,5\t3/8\"\r\n\r\nline\t1e1\t5\t20\t\"1/2\"\"\"", Unit::Mm, 7);
        assert_eq!(diagnostics, []);
        assert_eq!(sections, [Section::line(7, 0.0, 25.4, 25.5, 9.525), Section::line(8, 10.0, 5.0, 20.0, 12.7)]);
    }

    #[test]
    fn every_bad_cell_is_reported_and_the_other_rows_survive() {
        let text = "line\t0\t10\t5\t10\nline\tx\t10\t1e999\t10\nsphere\t0\t1\t2\t3\nconvex\t0\t1\t2\t3\tNaN\nline\t5\t9\n\
                    parabola along x\t1\t2\t3\t4\t\t\t5\t6\t-1\nline\t5\t10\t8\t10";
        let (sections, diagnostics) = tsv("clipboard", text, Unit::Mm, 1);
        assert_eq!(sections, [Section::line(1, 0.0, 10.0, 5.0, 10.0), Section::line(2, 5.0, 10.0, 8.0, 10.0)]);
        let cells: Vec<_> = diagnostics
            .iter()
            .map(|d| match d.at {
                Place::Line { line, column: Some(column), .. } => (line, column),
                _ => panic!("{d}"),
            })
            .collect();
        assert_eq!(cells, [(2, 2), (2, 4), (3, 1), (4, 6), (5, 4), (5, 5), (6, 10)]);
        assert!(diagnostics[1].message.contains("\"1e999\""), "{}", diagnostics[1]);
        assert!(diagnostics[3].message.contains("\"NaN\""), "{}", diagnostics[3]);
    }
}
