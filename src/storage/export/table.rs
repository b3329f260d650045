//! The section table as text with separators.

use crate::part::{Section, SectionKind};
use crate::units::Unit;

/// Columns of the written section table, in order.
pub const COLUMNS: [&str; 11] = ["type", "z1", "d1", "z2", "d2", "radius", "pitch", "z3", "d3", "chords", "starts"];

/// The rows for a spreadsheet: column names, then a row a line, cells apart by tabs, numbers exact.
#[must_use]
pub fn tsv(sections: &[Section]) -> String {
    let rows = sections.iter().map(cells);
    let lines = [COLUMNS.map(str::to_owned)].into_iter().chain(rows).map(|cells| cells.join("\t") + "\n");
    lines.collect()
}

/// The section table as comma-separated values; the column names carry the unit of the lengths.
#[must_use]
pub fn csv(sections: &[Section], unit: Unit) -> String {
    let is_length = |column: &str| !matches!(column, "type" | "chords" | "starts");
    let named = |c: &str| if is_length(c) { format!("{c} ({})", unit.symbol()) } else { c.to_owned() };
    let header = COLUMNS.map(named);
    let lines = [header].into_iter().chain(sections.iter().map(cells)).map(|cells| cells.join(",") + "\n");
    lines.collect()
}

fn cells(section: &Section) -> [String; 11] {
    let (mut radius, mut thread, mut third) = (None, None, None);
    match section.kind {
        SectionKind::Line => {}
        SectionKind::Concave { radius: r } | SectionKind::Convex { radius: r } => radius = Some(r),
        SectionKind::Thread { pitch, starts } => thread = Some((pitch, starts)),
        SectionKind::ParabolaAlongZ { z3, d3, chords } | SectionKind::ParabolaAlongX { z3, d3, chords } => {
            third = Some((z3, d3, chords));
        }
    }
    let written = |value: Option<f64>| value.map(|v| v.to_string()).unwrap_or_default();
    [
        section.kind.name().to_owned(),
        section.z1.to_string(),
        section.d1.to_string(),
        section.z2.to_string(),
        section.d2.to_string(),
        written(radius),
        written(thread.map(|t| t.0)),
        written(third.map(|t| t.0)),
        written(third.map(|t| t.1)),
        third.map(|t| t.2.to_string()).unwrap_or_default(),
        thread.map(|t| t.1.to_string()).unwrap_or_default(),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn csv_names_the_unit_and_leaves_foreign_cells_empty() {
        let arc = Section { kind: SectionKind::Convex { radius: 2.5 }, ..Section::line(3, 0.0, 1.0, 2.0, 3.25) };
        let text = csv(&[arc], Unit::Inch);
        let expected = "type,z1 (in),d1 (in),z2 (in),d2 (in),radius (in),pitch (in),z3 (in),d3 (in),chords,starts\n\
                        convex,0,1,2,3.25,2.5,,,,,\n";
        assert_eq!(text, expected);
    }
}
