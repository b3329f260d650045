//! The checks of a section table: every rule, each with the measured value and the limit.

use super::rules::{BORE_RULES, RULES};
use super::shape::{self, ShapeFault};
use super::{Curve, Section, SectionKind};
use crate::diagnostic::{Column, Diagnostic, Place, SectionTable};
use crate::document::{ParabolaCut, TurnedPart};
use crate::machine::Machine;
use crate::units::Unit;

/// What the rules have to say about `part`, whose lengths are in `unit`, on `machine`. Messages are in `unit`.
#[must_use]
pub fn check(part: &TurnedPart, unit: Unit, machine: &Machine) -> Vec<Diagnostic> {
    let outside = Table::new(part, unit, machine);
    let bore = Table::of_bore(part, unit, machine);
    let of_bore = BORE_RULES.iter().flat_map(|rule| rule(&bore));
    RULES.iter().flat_map(|rule| rule(&outside)).chain(of_bore).collect()
}

/// One rule: everything it finds in a table.
pub(super) type Rule = fn(&Table<'_>) -> Vec<Diagnostic>;

/// What the rules look at.
pub(super) struct Table<'a> {
    /// The part in mm.
    pub part: TurnedPart,
    /// The machine that is to make it.
    pub machine: &'a Machine,
    /// Which of the part's tables this is.
    pub side: SectionTable,
    /// All rows, in the order of the table.
    pub all_rows: Vec<Row>,
    unit: Unit,
}

/// One row of the table, in mm.
pub(super) struct Row {
    /// The table that holds it.
    pub side: SectionTable,
    /// Position in the table, from 1.
    pub number: usize,
    /// The row in mm.
    pub section: Section,
    /// Its exact curve, or why it has none.
    pub curve: Result<Curve, ShapeFault>,
}

impl<'a> Table<'a> {
    /// The table of the outside of a part whose lengths are in `unit`.
    pub(super) fn new(part: &TurnedPart, unit: Unit, machine: &'a Machine) -> Self {
        Self::of(SectionTable::Outside, part, unit, machine)
    }

    /// The table of the bore of a part whose lengths are in `unit`.
    pub(super) fn of_bore(part: &TurnedPart, unit: Unit, machine: &'a Machine) -> Self {
        Self::of(SectionTable::Bore, part, unit, machine)
    }

    fn of(side: SectionTable, part: &TurnedPart, unit: Unit, machine: &'a Machine) -> Self {
        let part = part.scaled(unit.in_mm());
        let curve = |section: &Section| match side {
            SectionTable::Outside => shape::curve(section),
            SectionTable::Bore => shape::curve(&section.seen_from_inside()),
        };
        let row = |(number, section): (usize, &Section)| Row {
            side,
            number,
            section: section.clone(),
            curve: curve(section),
        };
        Self { side, all_rows: (1..).zip(part.table(side)).map(row).collect(), part, machine, unit }
    }

    /// Radius of the hole in the stock, mm; 0 for solid bar.
    pub(super) fn hole_radius(&self) -> f64 {
        let diameter = self.part.stock_bore_diameter;
        if shape::is_usable(diameter) { (diameter / 2.0).max(0.0) } else { 0.0 }
    }

    /// The rows of the bore that take off more than the hole of the stock leaves to be taken.
    pub(super) fn bored_rows(&self) -> impl Iterator<Item = (&Row, &Curve)> {
        let hole = self.hole_radius();
        let bored = self.curves().filter(move |(_, curve)| curve.bounds().max.r > hole + shape::SAME_PLACE_MM);
        bored.filter(|_| self.side == SectionTable::Bore)
    }

    /// A length with its unit, in the unit of the document.
    pub(super) fn length(&self, mm: f64) -> String {
        format!("{:.*} {}", self.unit.decimals(), mm / self.unit.in_mm(), self.unit.symbol())
    }

    /// The rows whose figures can all be calculated with; only the rule about figures looks at the others.
    pub(super) fn rows(&self) -> impl Iterator<Item = &Row> {
        self.all_rows.iter().filter(|row| row.figures().iter().all(|&(_, value)| shape::is_usable(value)))
    }

    /// The tolerances of the part with what they are for, mm.
    pub(super) fn tolerances(&self) -> Vec<(&'static str, f64)> {
        let mut tolerances = vec![("form", self.part.form_tolerance)];
        if let ParabolaCut::Arcs { tolerance } = self.part.generator.parabolas() {
            tolerances.push(("arc", tolerance));
        }
        tolerances
    }

    /// The rows without a curve, with the reason.
    pub(super) fn faults(&self) -> impl Iterator<Item = (&Row, ShapeFault)> {
        self.rows().filter_map(|row| Some((row, row.curve.err()?)))
    }

    /// The rows with a curve.
    pub(super) fn curves(&self) -> impl Iterator<Item = (&Row, &Curve)> {
        self.rows().filter_map(|row| Some((row, row.curve.as_ref().ok()?)))
    }

    /// The rows whose positions can be calculated with, each with its range, in order of position.
    pub(super) fn ranges(&self) -> Vec<(&Row, f64, f64)> {
        let ranges = self.all_rows.iter().map(|row| (row, row.section.z1, row.section.z2));
        let usable = ranges.filter(|&(_, z1, z2)| shape::is_usable(z1) && shape::is_usable(z2));
        let mut ranges: Vec<(&Row, f64, f64)> = usable.map(|(row, z1, z2)| (row, z1.min(z2), z1.max(z2))).collect();
        ranges.sort_by(|a, b| a.1.total_cmp(&b.1));
        ranges
    }
}

impl Row {
    /// The place of a column of this row.
    pub(super) const fn at(&self, column: Column) -> Place {
        Place::Section { id: self.section.id, table: self.side, row: self.number, column: Some(column) }
    }

    /// Every length of the row with its column, mm.
    pub(super) fn figures(&self) -> Vec<(Column, f64)> {
        let Section { z1, d1, z2, d2, ref kind, .. } = self.section;
        let mut figures = vec![(Column::Z1, z1), (Column::D1, d1), (Column::Z2, z2), (Column::D2, d2)];
        match *kind {
            SectionKind::Line => {}
            SectionKind::Concave { radius } | SectionKind::Convex { radius } => figures.push((Column::Radius, radius)),
            SectionKind::Thread { pitch, .. } => figures.push((Column::Pitch, pitch)),
            SectionKind::ParabolaAlongZ { z3, d3, .. } | SectionKind::ParabolaAlongX { z3, d3, .. } => {
                figures.extend([(Column::Z3, z3), (Column::D3, d3)]);
            }
        }
        figures
    }

    /// The column that shapes the curve between its ends.
    pub(super) const fn shaping_column(&self) -> Column {
        match self.section.kind {
            SectionKind::Line => Column::D2,
            SectionKind::Concave { .. } | SectionKind::Convex { .. } => Column::Radius,
            SectionKind::Thread { .. } => Column::D1,
            SectionKind::ParabolaAlongZ { .. } | SectionKind::ParabolaAlongX { .. } => Column::D3,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnostic::Severity;
    use crate::document::Content;
    use crate::part::fixtures;

    #[test]
    fn published_parts_have_no_errors() {
        let machine = fixtures::orac();
        let codes = |part| check(&part, Unit::Mm, &machine).into_iter().map(|d| d.code).collect::<Vec<_>>();
        assert_eq!(codes(fixtures::queen()), Vec::<String>::new());
        assert_eq!(codes(fixtures::master()), ["overlap"]);
    }

    #[test]
    fn shipped_examples_have_no_errors() {
        for document in fixtures::examples() {
            let Content::TurnedPart(part) = document.content else { unreachable!("a turned part") };
            let found = check(&part, document.unit, &fixtures::orac());
            assert!(found.iter().all(|d| d.severity != Severity::Error), "{}: {found:?}", document.name);
        }
    }

    #[test]
    fn messages_are_in_the_unit_of_the_document() {
        let part = fixtures::part(10.0, vec![Section::line(1, 0.0, 2.0, 10.0, 1.0)]);
        let found = check(&part, Unit::Inch, &fixtures::orac());
        let bar = found.iter().find(|d| d.code == "bar-limit").unwrap();
        assert_eq!(bar.severity, Severity::Error);
        assert!(bar.message.contains("26.2000 in") && bar.message.contains("1.5748 in"), "{}", bar.message);
    }
}
