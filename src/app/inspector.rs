//! What is selected, with every value of it; the part as a whole while nothing is.

use super::desk::Requests;
use super::operations::{self, OperationsView};
use super::plots::fixed;
use super::sections::cells;
use super::sections::tsv::COLUMNS;
use super::theme::{self, Colors};
use super::widgets::{choice, field, form_label, remark, title_row};
use crate::diagnostic::{Column, SectionTable};
use crate::part::{Section, SectionKind};
use crate::session::Session;
use crate::units::{Unit, trimmed};
use egui::{RichText, Ui};

/// Width of the labels, points.
const LABEL: f32 = 86.0;

/// Shows the panel; true if it is dragged by its title.
pub(crate) fn show(
    ui: &mut Ui,
    view: &mut OperationsView,
    session: &mut Session,
    requests: &mut Requests,
    titled: bool,
) -> bool {
    let selected = session.selection.section;
    let found = selected.and_then(|id| session.part().row(id));
    let found = found.map(|(table, row, section)| (table, row, section.clone()));
    let title = match (&found, session.selection.operation) {
        (Some((table, row, section)), _) => capital(&cells::row_name(*table, *row, section)),
        (None, Some(index)) => view.title(index),
        (None, None) => "Part".to_owned(),
    };
    let dragged = title_row(ui, titled.then_some(title.as_str()), "", |_| {});
    egui::ScrollArea::vertical().auto_shrink([false, false]).show(ui, |ui| {
        match (found, session.selection.operation) {
            (Some((table, row, section)), _) => of_section(ui, session, &section, table, row),
            (None, Some(index)) => operations::inspect(ui, view, session, requests, index),
            (None, None) => of_part(ui, session, requests),
        }
    });
    dragged
}

fn capital(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map(|first| first.to_uppercase().chain(letters).collect()).unwrap_or_default()
}

fn of_section(ui: &mut Ui, session: &mut Session, section: &Section, table: SectionTable, row: usize) {
    let unit = session.document().unit;
    kind(ui, session, section, row);
    for column in COLUMNS.into_iter().filter(|c| cells::get(section, *c).is_some()) {
        value(ui, session, section, &cells::row_name(table, row, section), column, unit);
    }
    if let Some((z, r)) = centre(section, table) {
        let text = format!("z {}  r {}", fixed(z, unit.decimals()), fixed(r, unit.decimals()));
        fact(ui, "Centre", &text);
    }
    for message in messages(session, section.id) {
        let colors = Colors::of(ui.visuals());
        ui.label(RichText::new(message).color(colors.plot.wrong));
    }
    ui.add_space(4.0);
    remark(ui, &about(session, section, unit));
}

fn kind(ui: &mut Ui, session: &mut Session, section: &Section, row: usize) {
    ui.horizontal(|ui| {
        form_label(ui, "Type", LABEL);
        let all: Vec<(usize, String)> = cells::KINDS.iter().map(|k| (*k).to_owned()).enumerate().collect();
        let width = ui.available_width();
        if let Some(kind) = choice(ui, "Type", &cells::kind_index(&section.kind), &all, width) {
            write(session, section, &format!("type of row {}", row + 1), |s| cells::set_kind(s, kind));
        }
    });
}

fn value(ui: &mut Ui, session: &mut Session, section: &Section, row_name: &str, column: Column, unit: Unit) {
    ui.horizontal(|ui| {
        let name = column.to_string();
        let label = if name.contains(' ') { name } else { capital(&name) };
        form_label(ui, &label, LABEL);
        let shown = cells::text(section, column, unit);
        let read = |text: &str| {
            let mut changed = section.clone();
            cells::set(&mut changed, column, text, unit).map(|()| changed)
        };
        let width = ui.available_width();
        let typed = ui.push_id(section.id, |ui| field(ui, &label, &shown, width, read)).inner;
        if let Some(typed) = typed {
            let label = format!("{column} of {row_name}");
            typed.put_into_part(session, &label, |part, changed| {
                if let Some(row) = part.row_mut(changed.id) {
                    *row = changed;
                }
            });
        }
    });
}

fn write(session: &mut Session, section: &Section, label: &str, change: impl FnOnce(&mut Section)) {
    let id = section.id;
    session.edit_part(label, None, |part| {
        if let Some(row) = part.row_mut(id) {
            change(row);
        }
    });
}

/// A value that follows and cannot be edited.
pub(crate) fn fact(ui: &mut Ui, label: &str, text: &str) {
    ui.horizontal(|ui| {
        form_label(ui, label, LABEL);
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
            ui.label(theme::quiet(text, Colors::of(ui.visuals())));
        });
    });
}

/// Centre of an arc as z and radius, in the document's unit.
fn centre(section: &Section, table: SectionTable) -> Option<(f64, f64)> {
    let section = if table.is_outside() { section.clone() } else { section.seen_from_inside() };
    let (radius, outside) = match section.kind {
        SectionKind::Concave { radius } => (radius, 1.0),
        SectionKind::Convex { radius } => (radius, -1.0),
        _ => return None,
    };
    let (dz, dr) = (section.z2 - section.z1, (section.d2 - section.d1) / 2.0);
    let chord = dz.hypot(dr);
    let height = (radius * radius - chord * chord / 4.0).sqrt();
    let (mz, mr) = (f64::midpoint(section.z1, section.z2), f64::midpoint(section.d1, section.d2) / 2.0);
    let (z, r) = (mz - outside * height * dr / chord, mr + outside * height * dz / chord);
    (z.is_finite() && r.is_finite()).then_some((z, r))
}

/// What the machine allows for this type of section.
fn about(session: &Session, section: &Section, unit: Unit) -> String {
    let Some(machine) = session.derived().and_then(|d| d.machine.clone()) else { return String::new() };
    let limits = machine.limits;
    let length = |mm: f64| format!("{} {}", trimmed(mm / unit.in_mm(), unit.decimals()), unit.symbol());
    match section.kind {
        SectionKind::Concave { .. } | SectionKind::Convex { .. } => format!(
            "Radius may be {} to {} on this lathe.",
            length(limits.arc_radius_min_mm),
            length(limits.arc_radius_max_mm)
        ),
        SectionKind::Thread { .. } => {
            format!("Pitch may be {} to {} on this lathe.", length(limits.pitch_min_mm), length(limits.pitch_max_mm))
        }
        SectionKind::Line => format!("A taper may be as slender as {} to 1 on this lathe.", limits.taper_ratio),
        SectionKind::ParabolaAlongZ { .. } => "Position is a quadratic of the radius.".to_owned(),
        SectionKind::ParabolaAlongX { .. } => "Radius is a quadratic of the position.".to_owned(),
    }
}

fn messages(session: &Session, id: u32) -> Vec<String> {
    session.problems_of_row(id).map(|d| d.message.clone()).collect()
}

fn of_part(ui: &mut Ui, session: &mut Session, requests: &Requests) {
    let name = session.document().name.clone();
    ui.horizontal(|ui| {
        form_label(ui, "Name", LABEL);
        let width = ui.available_width();
        if let Some(typed) = field(ui, "Name", &name, width, read_name) {
            typed.put_into(session, "name", |document, name| document.name = name);
        }
    });
    ui.horizontal(|ui| {
        form_label(ui, "Machine", LABEL);
        let all: Vec<(String, String)> =
            requests.catalog.machines.iter().map(|m| (m.id.clone(), m.name.clone())).collect();
        let width = ui.available_width();
        if let Some(machine) = choice(ui, "Machine", &session.part().machine.clone(), &all, width) {
            session.edit_part("machine", None, |part| part.machine = machine);
        }
    });
    let Some(setup) = session.setup() else { return };
    let proof = &setup.proof;
    let blocks = proof.blocks.len().to_string();
    let facts = [
        ("Programs", setup.programs.len().to_string()),
        (if session.is_in_pages() { "Pages" } else { "Blocks" }, blocks),
        ("Largest chip", format!("{} mm²", fixed(proof.largest_chip_mm2, 3))),
        ("Deepest gouge", format!("{} mm", fixed(proof.deepest_gouge_mm, 3))),
        ("Most left", format!("{} mm", fixed(proof.leftover.iter().map(|l| l.largest_mm).fold(0.0, f64::max), 3))),
    ];
    for (label, text) in facts {
        fact(ui, label, &text);
    }
    ui.add_space(4.0);
    remark(ui, "Click a row of the table or a line of the profile to see all its values here.");
}

fn read_name(text: &str) -> Result<String, String> {
    let name = text.trim();
    if name.is_empty() {
        Err("A part needs a name; its programs are named after it.".to_owned())
    } else {
        Ok(name.to_owned())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_centre_is_as_far_from_both_ends_as_the_radius_says() {
        let mut row = Section::line(6, 36.0, 17.5, 38.6, 10.2);
        for (kind, inside) in
            [(SectionKind::Convex { radius: 5.0 }, true), (SectionKind::Concave { radius: 5.0 }, false)]
        {
            row.kind = kind;
            let (z, r) = centre(&row, SectionTable::Outside).unwrap();
            assert!(((z - 36.0).hypot(r - 8.75) - 5.0).abs() < 1e-9);
            assert!(((z - 38.6).hypot(r - 5.1) - 5.0).abs() < 1e-9);
            assert_eq!(r < 7.0, inside);
        }
        row.kind = SectionKind::Convex { radius: 1.0 };
        assert_eq!(centre(&row, SectionTable::Outside), None);
    }
}
