//! The section table of a former, in short: every row ends where the next begins.

use super::edit;
use super::form::{Counts, figure, pick};
use crate::app::sections::cells::{KINDS, kind_index, set_kind};
use crate::app::theme::{self, Colors};
use crate::app::widgets::link;
use crate::document::{FormerShape, Shell};
use crate::part::{Section, SectionKind};
use crate::session::Session;
use egui::Ui;

/// Types that a row of a former can have: it has no threads.
const TYPES: [usize; 5] = [0, 1, 2, 4, 5];

/// Shows the rows.
pub(super) fn show(ui: &mut Ui, session: &mut Session, sections: &[Section]) {
    for (index, section) in sections.iter().enumerate() {
        ui.label(theme::quiet(format!("Row {}", index + 1), Colors::of(ui.visuals())));
        let row = Row { index, section };
        row.kind(ui, session);
        row.ends(ui, session);
        row.curve(ui, session);
    }
    ui.horizontal(|ui| {
        if link(ui, "+ Row").clicked() {
            edit(session, "add a row", None, add);
        }
        if sections.len() > 1 && link(ui, "remove the last").clicked() {
            edit(session, "remove a row", None, |shell| {
                if let FormerShape::Sections { sections } = &mut shell.former.shape {
                    sections.pop();
                }
            });
        }
    });
}

/// One row of the table.
struct Row<'a> {
    index: usize,
    section: &'a Section,
}

impl Row<'_> {
    /// `z end of row 2`.
    fn name(&self, what: &str) -> String {
        format!("{what} of row {}", self.index + 1)
    }

    fn figure(
        &self,
        ui: &mut Ui,
        session: &mut Session,
        (what, key): (&str, &str),
        value: f64,
        write: fn(&mut Section, f64),
    ) {
        let path = format!("former.shape.sections[{}].{key}", self.index);
        let index = self.index;
        figure(ui, session, (&self.name(what), &path), value, Counts::Length, move |shell, v| {
            change(shell, index, |row| write(row, v));
            tie(shell, index);
        });
    }

    fn kind(&self, ui: &mut Ui, session: &mut Session) {
        let types = TYPES.map(|kind| (kind, KINDS.get(kind).copied().unwrap_or_default()));
        let index = self.index;
        pick(ui, session, &self.name("Type"), &kind_index(&self.section.kind), &types, |shell, kind| {
            change(shell, index, |row| set_kind(row, *kind));
        });
    }

    fn ends(&self, ui: &mut Ui, session: &mut Session) {
        if self.index == 0 {
            self.figure(ui, session, ("⌀ start", "d1"), self.section.d1, |row, v| row.d1 = v);
        }
        self.figure(ui, session, ("z end", "z2"), self.section.z2, |row, v| row.z2 = v);
        self.figure(ui, session, ("⌀ end", "d2"), self.section.d2, |row, v| row.d2 = v);
    }

    /// What the type of the row needs besides its ends.
    fn curve(&self, ui: &mut Ui, session: &mut Session) {
        match self.section.kind {
            SectionKind::Concave { radius } | SectionKind::Convex { radius } => {
                self.figure(ui, session, ("Radius", "radius"), radius, |row, v| {
                    if let SectionKind::Concave { radius } | SectionKind::Convex { radius } = &mut row.kind {
                        *radius = v;
                    }
                });
            }
            SectionKind::ParabolaAlongZ { z3, d3, .. } | SectionKind::ParabolaAlongX { z3, d3, .. } => {
                self.figure(ui, session, ("z of a third point", "z3"), z3, |row, v| set_third(row, |z, _| *z = v));
                self.figure(ui, session, ("⌀ of a third point", "d3"), d3, |row, v| set_third(row, |_, d| *d = v));
            }
            SectionKind::Line | SectionKind::Thread { .. } => {}
        }
    }
}

/// Changes the third point of a parabola.
fn set_third(row: &mut Section, write: impl FnOnce(&mut f64, &mut f64)) {
    if let SectionKind::ParabolaAlongZ { z3, d3, .. } | SectionKind::ParabolaAlongX { z3, d3, .. } = &mut row.kind {
        write(z3, d3);
    }
}

fn change(shell: &mut Shell, index: usize, write: impl FnOnce(&mut Section)) {
    if let FormerShape::Sections { sections } = &mut shell.former.shape
        && let Some(row) = sections.get_mut(index)
    {
        write(row);
    }
}

/// The next row begins where this one ends.
fn tie(shell: &mut Shell, index: usize) {
    if let FormerShape::Sections { sections } = &mut shell.former.shape
        && let Some((z, d)) = sections.get(index).map(|row| (row.z2, row.d2))
        && let Some(next) = sections.get_mut(index + 1)
    {
        (next.z1, next.d1) = (z, d);
    }
}

/// A row beyond the last, half as long and narrower.
fn add(shell: &mut Shell) {
    if let FormerShape::Sections { sections } = &mut shell.former.shape {
        let id = sections.iter().map(|s| s.id).max().unwrap_or(0).saturating_add(1);
        let next = sections.last().map(|last| {
            let long = (last.z2 - last.z1) / 2.0;
            Section::line(id, last.z2, last.d2, last.z2 + long, last.d2 * 0.8)
        });
        sections.extend(next);
    }
}
