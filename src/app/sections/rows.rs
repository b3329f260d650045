//! Inserting, deleting and duplicating rows.

use crate::diagnostic::SectionTable;
use crate::document::TurnedPart;
use crate::part::Section;
use std::ops::RangeInclusive;

/// Inserts a straight row before row `index`, from the end of the row before to the start of the row after. The first row
/// of a bore is the hole of the stock, or half as wide as the bar.
pub(crate) fn insert(part: &mut TurnedPart, table: SectionTable, index: usize) -> u32 {
    let rows = part.table(table);
    let index = index.min(rows.len());
    let before = index.checked_sub(1).and_then(|i| rows.get(i));
    let widest = match table {
        SectionTable::Outside => part.bar_diameter,
        SectionTable::Bore if part.stock_bore_diameter > 0.0 => part.stock_bore_diameter,
        SectionTable::Bore => part.bar_diameter / 2.0,
    };
    let (z1, d1) = before.map_or((0.0, widest), |s| (s.z2, s.d2));
    let (z2, d2) = rows.get(index).map_or((part.length.max(z1), d1), |s| (s.z1, s.d1));
    let id = part.unused_section_id();
    part.table_mut(table).insert(index, Section::line(id, z1, d1, z2, d2));
    id
}

/// Deletes rows.
pub(crate) fn delete(sections: &mut Vec<Section>, rows: &RangeInclusive<usize>) {
    let mut index = 0;
    sections.retain(|_| {
        index += 1;
        !rows.contains(&(index - 1))
    });
}

/// Puts a copy of the rows after them, with ids of their own.
pub(crate) fn duplicate(part: &mut TurnedPart, table: SectionTable, rows: &RangeInclusive<usize>) {
    let copies: Vec<Section> =
        part.table(table).iter().skip(*rows.start()).take(rows.clone().count()).cloned().collect();
    for (offset, copy) in copies.into_iter().enumerate() {
        let id = part.unused_section_id();
        let at = (rows.end() + 1 + offset).min(part.table(table).len());
        part.table_mut(table).insert(at, Section { id, ..copy });
    }
}
