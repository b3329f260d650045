//! The section table of a former, in short: every row ends where the next begins.

use super::edit;
use super::form::{Counts, figure};
use crate::app::theme::{self, Colors};
use crate::app::widgets::link;
use crate::document::{FormerShape, Shell};
use crate::part::Section;
use crate::session::Session;
use egui::Ui;

/// Shows the rows.
pub(super) fn show(ui: &mut Ui, session: &mut Session, sections: &[Section]) {
    let colors = Colors::of(ui.visuals());
    for (index, section) in sections.iter().enumerate() {
        let number = index + 1;
        ui.label(theme::quiet(format!("Row {number}: {}", section.kind.name()), colors));
        let path = format!("former.shape.sections[{index}]");
        let path = path.as_str();
        let name = |what: &str| format!("{what} of row {number}");
        if index == 0 {
            figure(ui, session, (&name("⌀ start"), path), section.d1, Counts::Length, move |shell, v| {
                change(shell, index, |row| row.d1 = v);
            });
        }
        figure(ui, session, (&name("z end"), path), section.z2, Counts::Length, move |shell, v| {
            change(shell, index, |row| row.z2 = v);
            change(shell, index + 1, |row| row.z1 = v);
        });
        figure(ui, session, (&name("⌀ end"), path), section.d2, Counts::Length, move |shell, v| {
            change(shell, index, |row| row.d2 = v);
            change(shell, index + 1, |row| row.d1 = v);
        });
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

fn change(shell: &mut Shell, index: usize, write: impl FnOnce(&mut Section)) {
    if let FormerShape::Sections { sections } = &mut shell.former.shape
        && let Some(row) = sections.get_mut(index)
    {
        write(row);
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
