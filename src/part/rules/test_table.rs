//! Small tables that the tests of the rules break in one place each.

pub(super) use crate::document::TurnedPart;
pub(super) use crate::part::{Section, SectionKind};

use crate::diagnostic::{Column, Diagnostic, Place};
use crate::machine::Machine;
use crate::part::check::Table;
use crate::part::fixtures;
use crate::units::Unit;
use std::sync::LazyLock;

static ORAC: LazyLock<Machine> = LazyLock::new(fixtures::orac);

/// A part of 100 mm with the given rows, on a bar of 26.2 mm.
pub(super) fn part(rows: Vec<Section>) -> TurnedPart {
    fixtures::part(100.0, rows)
}

/// The table of a part in mm on the ORAC.
pub(super) fn table(part: &TurnedPart) -> Table<'static> {
    Table::new(part, Unit::Mm, &ORAC)
}

/// A part of 100 mm with the given bore in a plain outside of 26.2 mm.
pub(super) fn bored(bore: Vec<Section>) -> TurnedPart {
    TurnedPart { bore, ..part(vec![Section::line(1001, 0.0, 26.2, 100.0, 26.2)]) }
}

/// The table of the bore of a part in mm on the ORAC.
pub(super) fn bore_table(part: &TurnedPart) -> Table<'static> {
    Table::of_bore(part, Unit::Mm, &ORAC)
}

/// Row and column of every diagnostic that has them.
pub(super) fn places(found: &[Diagnostic]) -> Vec<(usize, Column)> {
    let place = |d: &Diagnostic| match d.at {
        Place::Section { row, column: Some(column), .. } => Some((row, column)),
        _ => None,
    };
    found.iter().filter_map(place).collect()
}

/// A bulging arc from position 0.
pub(super) fn convex(radius: f64, z2: f64, d1: f64, d2: f64) -> Section {
    Section { kind: SectionKind::Convex { radius }, ..Section::line(1, 0.0, d1, z2, d2) }
}

/// A thread 10 mm long.
pub(super) fn thread(outside: f64, base: f64, pitch: f64) -> Section {
    Section { kind: SectionKind::Thread { pitch, starts: 1 }, ..Section::line(1, 0.0, outside, 10.0, base) }
}

/// A parabola from diameter 10 to 5 over 10 mm, radius as a function of position.
pub(super) fn along_x(z3: f64, d3: f64) -> Section {
    let kind = SectionKind::ParabolaAlongX { z3, d3, chords: 10 };
    Section { kind, ..Section::line(1, 0.0, 10.0, 10.0, 5.0) }
}

/// A parabola from diameter 10 to 5 over 10 mm, position as a function of radius.
pub(super) fn along_z(z3: f64, d3: f64) -> Section {
    let kind = SectionKind::ParabolaAlongZ { z3, d3, chords: 10 };
    Section { kind, ..Section::line(1, 0.0, 10.0, 10.0, 5.0) }
}
