//! Bar, ends and how the program is made.

use super::generator;
use crate::app::desk::Requests;
use crate::app::theme;
use crate::app::widgets::{choice, form_label, length_field};
use crate::document::{Ends, Holding, TurnedPart};
use crate::machine::Catalog;
use crate::session::Session;
use crate::units::Unit;
use egui::Ui;

/// Space between a label and its field in the two columns, points.
const BETWEEN: f32 = 8.0;

/// Shows what the part is cut from and how.
pub(crate) fn show(ui: &mut Ui, session: &mut Session, requests: &Requests) {
    ui.label(theme::strong("Stock"));
    let part = session.part().clone();
    let unit = session.document().unit;
    let width = (ui.available_width() - 3.0 * BETWEEN) / 4.0;
    let grid = Grid { label: width - 8.0, field: width + 8.0 };
    Grid::row(ui, |ui| {
        grid.length(ui, session, "Bar ⌀", "bar diameter", part.bar_diameter, unit, |p, v| p.bar_diameter = v);
        grid.length(ui, session, "Length", "part length", part.length, unit, |p, v| p.length = v);
    });
    Grid::row(ui, |ui| {
        let (hole, facing) = (part.stock_bore_diameter, part.facing_allowance);
        grid.length(ui, session, "Hole ⌀", "hole in the stock", hole, unit, |p, v| p.stock_bore_diameter = v);
        grid.length(ui, session, "Facing", "facing allowance", facing, unit, |p, v| p.facing_allowance = v);
    });
    Grid::row(ui, |ui| {
        grid.ends(ui, session, part.ends);
        match part.ends {
            Ends::Two { split } => grid.split(ui, session, split, unit),
            Ends::One => grid.yes_no(ui, session, "Part off", part.part_off, |p, yes| p.part_off = yes),
        }
    });
    Grid::row(ui, |ui| {
        grid.material(ui, session, &requests.catalog, &part);
        grid.unit(ui, session, unit);
    });
    Grid::row(ui, |ui| {
        grid.length(ui, session, "Tolerance", "form tolerance", part.form_tolerance, unit, |p, v| p.form_tolerance = v);
        grid.yes_no(ui, session, "Automatic", part.automatic, |p, yes| p.automatic = yes);
    });
    Grid::row(ui, |ui| {
        grid.holding(ui, session, part.holding);
        generator::by(grid, ui, session, &part.generator);
    });
    generator::choices(grid, ui, session, &part.generator, unit);
}

/// Widths of the columns.
#[derive(Clone, Copy)]
pub(super) struct Grid {
    /// Of a label.
    pub(super) label: f32,
    /// Of a field.
    pub(super) field: f32,
}

impl Grid {
    pub(super) fn row(ui: &mut Ui, content: impl FnOnce(&mut Ui)) {
        ui.horizontal(|ui| {
            ui.spacing_mut().item_spacing.x = BETWEEN;
            content(ui);
        });
    }

    #[allow(clippy::too_many_arguments, reason = "a field is its label, its value and what it writes to")]
    fn length(
        self,
        ui: &mut Ui,
        session: &mut Session,
        label: &str,
        name: &str,
        value: f64,
        unit: Unit,
        write: impl FnOnce(&mut TurnedPart, f64),
    ) {
        form_label(ui, label, self.label);
        if let Some(typed) = length_field(ui, label, value, unit, self.field) {
            typed.put_into_part(session, name, write);
        }
    }

    fn yes_no(
        self,
        ui: &mut Ui,
        session: &mut Session,
        label: &str,
        value: bool,
        write: impl FnOnce(&mut TurnedPart, bool),
    ) {
        form_label(ui, label, self.label);
        let all = [(false, "no".to_owned()), (true, "yes".to_owned())];
        if let Some(value) = choice(ui, label, &value, &all, self.field) {
            session.edit_part(&label.to_lowercase(), None, |part| write(part, value));
        }
    }

    fn ends(self, ui: &mut Ui, session: &mut Session, ends: Ends) {
        form_label(ui, "Ends", self.label);
        let two = matches!(ends, Ends::Two { .. });
        let all = [(false, "one".to_owned()), (true, "two".to_owned())];
        if let Some(two) = choice(ui, "Ends", &two, &all, self.field) {
            let ends = if two { Ends::Two { split: None } } else { Ends::One };
            session.edit_part("ends", None, |part| part.ends = ends);
        }
    }

    fn split(self, ui: &mut Ui, session: &mut Session, split: Option<f64>, unit: Unit) {
        form_label(ui, "Split at", self.label);
        let shown = split.map_or_else(|| "found".to_owned(), |s| crate::app::plots::fixed(s, unit.decimals()));
        let read = |text: &str| match text.trim() {
            "" | "found" => Ok(None),
            text => crate::units::parse_length(text, unit).map(Some),
        };
        if let Some(typed) = crate::app::widgets::field(ui, "Split at", &shown, self.field, read) {
            typed.put_into_part(session, "split", |part, split| part.ends = Ends::Two { split });
        }
    }

    fn material(self, ui: &mut Ui, session: &mut Session, catalog: &Catalog, part: &TurnedPart) {
        form_label(ui, "Material", self.label);
        let unit = session.document().unit;
        let mut names: Vec<String> =
            catalog.materials.iter().filter(|m| m.unit == unit).map(|m| m.name.to_lowercase()).collect();
        let present = part.material.to_lowercase();
        if !names.contains(&present) {
            names.insert(0, present.clone());
        }
        let all: Vec<(String, String)> = names.into_iter().map(|n| (n.clone(), n)).collect();
        if let Some(name) = choice(ui, "Material", &present, &all, self.field) {
            session.edit_part("material", None, |part| part.material = name);
        }
    }

    fn unit(self, ui: &mut Ui, session: &mut Session, unit: Unit) {
        form_label(ui, "Unit", self.label);
        let all = [(Unit::Mm, "mm".to_owned()), (Unit::Inch, "inch".to_owned())];
        if let Some(new) = choice(ui, "Unit", &unit, &all, self.field) {
            session.edit("unit", None, |document| {
                document.content = document.content.scaled(unit.in_mm() / new.in_mm());
                document.unit = new;
            });
        }
    }

    fn holding(self, ui: &mut Ui, session: &mut Session, holding: Holding) {
        form_label(ui, "Held", self.label);
        let all = [(Holding::Chuck, "in chuck".to_owned()), (Holding::BetweenCentres, "in centres".to_owned())];
        if let Some(holding) = choice(ui, "Held", &holding, &all, self.field) {
            session.edit_part("holding", None, |part| part.holding = holding);
        }
    }
}
