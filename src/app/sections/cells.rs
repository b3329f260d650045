//! What stands in a cell of the section table, and what a typed text does to it.

use crate::diagnostic::{Column, SectionTable};
use crate::part::{Section, SectionKind};
use crate::units::{Unit, parse_length};

/// Chords of a parabola that has just been made from another type.
const CHORDS: u32 = 20;

/// The section types with their names, in the order of the list.
pub(crate) const KINDS: [&str; 6] = ["line", "concave", "convex", "thread", "parabola z", "parabola x"];

/// Number of the type of `kind` in [`KINDS`].
#[must_use]
pub(crate) const fn kind_index(kind: &SectionKind) -> usize {
    match kind {
        SectionKind::Line => 0,
        SectionKind::Concave { .. } => 1,
        SectionKind::Convex { .. } => 2,
        SectionKind::Thread { .. } => 3,
        SectionKind::ParabolaAlongZ { .. } => 4,
        SectionKind::ParabolaAlongX { .. } => 5,
    }
}

/// Name of the type of `kind`.
#[must_use]
pub(crate) fn kind_name(kind: &SectionKind) -> &'static str {
    KINDS.get(kind_index(kind)).copied().unwrap_or_default()
}

/// What a row is called: `convex 3`, in a bore `bore convex 3`; `row` counts from 0.
#[must_use]
pub(crate) fn row_name(table: SectionTable, row: usize, section: &Section) -> String {
    let of = if table.is_outside() { "" } else { "bore " };
    format!("{of}{} {}", kind_name(&section.kind), row + 1)
}

/// The columns that the rows need: the first five and the radius always, the others where a row has them, starts where a
/// thread has several.
#[must_use]
pub(crate) fn columns(sections: &[Section]) -> Vec<Column> {
    let mut columns = vec![Column::Kind, Column::Z1, Column::D1, Column::Z2, Column::D2, Column::Radius];
    if sections.iter().any(|s| matches!(s.kind, SectionKind::Thread { .. })) {
        columns.push(Column::Pitch);
    }
    if sections.iter().any(|s| get(s, Column::Starts).is_some_and(|starts| starts > 1.0)) {
        columns.push(Column::Starts);
    }
    if sections.iter().any(|s| get(s, Column::Z3).is_some()) {
        columns.extend([Column::Z3, Column::D3, Column::Chords]);
    }
    columns
}

/// The figure in a cell; `None` where the type of the row has none.
#[must_use]
pub(crate) fn get(section: &Section, column: Column) -> Option<f64> {
    match (column, &section.kind) {
        (Column::Z1, _) => Some(section.z1),
        (Column::D1, _) => Some(section.d1),
        (Column::Z2, _) => Some(section.z2),
        (Column::D2, _) => Some(section.d2),
        (Column::Radius, SectionKind::Concave { radius } | SectionKind::Convex { radius }) => Some(*radius),
        (Column::Pitch, SectionKind::Thread { pitch, .. }) => Some(*pitch),
        (Column::Starts, SectionKind::Thread { starts, .. }) => Some(f64::from(*starts)),
        (Column::Z3, SectionKind::ParabolaAlongZ { z3, .. } | SectionKind::ParabolaAlongX { z3, .. }) => Some(*z3),
        (Column::D3, SectionKind::ParabolaAlongZ { d3, .. } | SectionKind::ParabolaAlongX { d3, .. }) => Some(*d3),
        (Column::Chords, SectionKind::ParabolaAlongZ { chords, .. } | SectionKind::ParabolaAlongX { chords, .. }) => {
            Some(f64::from(*chords))
        }
        _ => None,
    }
}

/// The text of a cell; empty where the type of the row has none.
#[must_use]
pub(crate) fn text(section: &Section, column: Column, unit: Unit) -> String {
    match column {
        Column::Kind => kind_name(&section.kind).to_owned(),
        Column::Chords | Column::Starts => get(section, column).map(|count| format!("{count:.0}")).unwrap_or_default(),
        _ => get(section, column).map(|v| super::super::plots::fixed(v, unit.decimals())).unwrap_or_default(),
    }
}

/// Writes a typed text into a cell.
///
/// # Errors
/// A sentence that says why the text does not fit; the row is as it was.
pub(crate) fn set(section: &mut Section, column: Column, text: &str, unit: Unit) -> Result<(), String> {
    match column {
        Column::Kind => {
            let kind = find_kind(text)?;
            set_kind(section, kind);
            return Ok(());
        }
        Column::Chords | Column::Starts => return set_count(section, column, text),
        _ => {}
    }
    let value = parse_length(text, unit)?;
    let name = kind_name(&section.kind);
    let cell = match (column, &mut section.kind) {
        (Column::Z1, _) => &mut section.z1,
        (Column::D1, _) => &mut section.d1,
        (Column::Z2, _) => &mut section.z2,
        (Column::D2, _) => &mut section.d2,
        (Column::Radius, SectionKind::Concave { radius } | SectionKind::Convex { radius }) => radius,
        (Column::Pitch, SectionKind::Thread { pitch, .. }) => pitch,
        (Column::Z3, SectionKind::ParabolaAlongZ { z3, .. } | SectionKind::ParabolaAlongX { z3, .. }) => z3,
        (Column::D3, SectionKind::ParabolaAlongZ { d3, .. } | SectionKind::ParabolaAlongX { d3, .. }) => d3,
        _ => return Err(format!("A {name} has no {column}.")),
    };
    *cell = value;
    Ok(())
}

fn set_count(section: &mut Section, column: Column, text: &str) -> Result<(), String> {
    let count =
        text.trim().parse::<u32>().map_err(|_| format!("“{}” is not a whole number of {column}.", text.trim()))?;
    match (column, &mut section.kind) {
        (Column::Starts, SectionKind::Thread { starts, .. }) => *starts = count,
        (Column::Chords, SectionKind::ParabolaAlongZ { chords, .. } | SectionKind::ParabolaAlongX { chords, .. }) => {
            *chords = count;
        }
        (_, kind) => return Err(format!("A {} has no {column}.", kind_name(kind))),
    }
    Ok(())
}

/// The type whose name begins with `text`.
///
/// # Errors
/// A sentence with the names.
pub(crate) fn find_kind(text: &str) -> Result<usize, String> {
    let wanted = text.trim().to_lowercase().replace('_', " ").replace("parabola along", "parabola");
    let found = KINDS.iter().position(|name| !wanted.is_empty() && name.starts_with(&wanted));
    found.ok_or_else(|| format!("“{}” is not a section type. There are: {}.", text.trim(), KINDS.join(", ")))
}

/// Changes the type of a row; what the new type needs and the old one did not have gets a value that fits the ends.
pub(crate) fn set_kind(section: &mut Section, kind: usize) {
    let span = (section.z2 - section.z1).hypot((section.d2 - section.d1) / 2.0);
    let radius = get(section, Column::Radius).unwrap_or(span.max(1.0));
    let z3 = get(section, Column::Z3).unwrap_or(f64::midpoint(section.z1, section.z2));
    let d3 = get(section, Column::D3).unwrap_or(f64::midpoint(section.d1, section.d2) * 0.9);
    let chords = match section.kind {
        SectionKind::ParabolaAlongZ { chords, .. } | SectionKind::ParabolaAlongX { chords, .. } => chords,
        _ => CHORDS,
    };
    let starts = if let SectionKind::Thread { starts, .. } = section.kind { starts } else { 1 };
    section.kind = match kind {
        1 => SectionKind::Concave { radius },
        2 => SectionKind::Convex { radius },
        3 => SectionKind::Thread { pitch: get(section, Column::Pitch).unwrap_or(1.0), starts },
        4 => SectionKind::ParabolaAlongZ { z3, d3, chords },
        5 => SectionKind::ParabolaAlongX { z3, d3, chords },
        _ => SectionKind::Line,
    };
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cell_takes_an_expression_and_says_it_back() {
        let mut row = Section::line(1, 0.0, 20.0, 10.0, 20.0);
        set(&mut row, Column::D1, "1in", Unit::Mm).unwrap();
        assert_eq!(text(&row, Column::D1, Unit::Mm), "25.400");
        assert!(set(&mut row, Column::D1, "abc", Unit::Mm).is_err());
        assert!(set(&mut row, Column::Radius, "5", Unit::Mm).unwrap_err().contains("line"));
        assert_eq!(row.d1, 25.4);
    }

    #[test]
    fn a_type_is_found_by_its_beginning_and_keeps_what_it_can() {
        let mut row = Section::line(1, 0.0, 20.0, 10.0, 16.0);
        set(&mut row, Column::Kind, "conv", Unit::Mm).unwrap();
        set(&mut row, Column::Radius, "30", Unit::Mm).unwrap();
        set(&mut row, Column::Kind, "concave", Unit::Mm).unwrap();
        assert_eq!(row.kind, SectionKind::Concave { radius: 30.0 });
        assert!(find_kind("").is_err());
        assert!(find_kind("spiral").is_err());
    }
}
