//! Fields that write into a set of form-rolls.

use super::words;
use crate::app::widgets::{Typed, choice, field, form_label, length_field};
use crate::document::RollSet;
use crate::session::Session;
use crate::units::Unit;
use egui::Ui;

/// Space between a label and its field, points.
const BETWEEN: f32 = 8.0;
/// Decimals of a figure without unit.
const DECIMALS: usize = 4;

/// What stands before a field, and what a change of it is called.
#[derive(Clone, Copy)]
pub(super) struct Field<'a> {
    label: &'a str,
}

impl<'a> Field<'a> {
    /// A field with this label.
    pub(super) const fn of(label: &'a str) -> Self {
        Self { label }
    }
}

/// Widths of labels and fields.
#[derive(Clone, Copy)]
pub(super) struct Form {
    label: f32,
    field: f32,
}

impl Form {
    /// Two fields in a row.
    pub(super) fn two_columns(ui: &Ui) -> Self {
        let width = (ui.available_width() - 3.0 * BETWEEN) / 4.0;
        Self { label: width - 14.0, field: width + 14.0 }
    }

    /// One field in a row.
    pub(super) fn one_column(ui: &Ui) -> Self {
        let width = ui.available_width() - BETWEEN;
        Self { label: width * 0.44, field: width * 0.56 }
    }

    /// A row of fields.
    pub(super) fn row(ui: &mut Ui, content: impl FnOnce(&mut Ui)) {
        ui.horizontal(|ui| {
            ui.spacing_mut().item_spacing.x = BETWEEN;
            content(ui);
        });
    }

    fn label(self, ui: &mut Ui, label: &str) {
        if self.label > 0.0 {
            form_label(ui, label, self.label);
        }
    }

    /// A length.
    pub(super) fn length(
        self,
        ui: &mut Ui,
        session: &mut Session,
        of: Field<'_>,
        value: f64,
        unit: Unit,
        write: impl FnOnce(&mut RollSet, f64),
    ) {
        self.label(ui, of.label);
        put(session, of, length_field(ui, of.label, value, unit, self.field), write);
    }

    /// An angle, degrees.
    pub(super) fn angle(
        self,
        ui: &mut Ui,
        session: &mut Session,
        of: Field<'_>,
        deg: f64,
        write: impl FnOnce(&mut RollSet, f64),
    ) {
        self.label(ui, of.label);
        let shown = format!("{}°", words::angle(deg));
        put(session, of, field(ui, of.label, &shown, self.field, words::parse_angle), write);
    }

    /// A figure without unit, or whose unit is in the label.
    pub(super) fn figure(
        self,
        ui: &mut Ui,
        session: &mut Session,
        of: Field<'_>,
        value: f64,
        write: impl FnOnce(&mut RollSet, f64),
    ) {
        self.label(ui, of.label);
        let shown = words::plain(value, DECIMALS);
        put(session, of, field(ui, of.label, &shown, self.field, words::parse_figure), write);
    }

    /// One of several.
    pub(super) fn choice<T: PartialEq + Clone>(
        self,
        ui: &mut Ui,
        session: &mut Session,
        of: Field<'_>,
        present: &T,
        all: &[(T, String)],
        write: impl FnOnce(&mut RollSet, T),
    ) {
        self.label(ui, of.label);
        if let Some(chosen) = choice(ui, of.label, present, all, self.field) {
            session.edit(&of.label.to_lowercase(), None, |document| {
                if let Some(set) = super::set_mut(document) {
                    write(set, chosen);
                }
            });
        }
    }
}

/// Puts what is typed into the set.
fn put(session: &mut Session, of: Field<'_>, typed: Option<Typed<f64>>, write: impl FnOnce(&mut RollSet, f64)) {
    let Some(typed) = typed else { return };
    typed.put_into(session, &of.label.to_lowercase(), |document, value| {
        if let Some(set) = super::set_mut(document) {
            write(set, value);
        }
    });
}
