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

    /// Two fields in a row of a narrow panel, whose labels are as long as the fields.
    pub(super) fn two_even_columns(ui: &Ui) -> Self {
        let width = (ui.available_width() - 3.0 * BETWEEN) / 4.0;
        Self { label: width, field: width }
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

    /// A figure that may be absent: an empty field.
    pub(super) fn maybe_figure(
        self,
        ui: &mut Ui,
        session: &mut Session,
        of: Field<'_>,
        value: Option<f64>,
        write: impl FnOnce(&mut RollSet, Option<f64>),
    ) {
        self.label(ui, of.label);
        let shown = value.map_or_else(String::new, |v| words::plain(v, DECIMALS));
        let read = |text: &str| {
            if text.trim().is_empty() { Ok(None) } else { words::parse_figure(text).map(Some) }
        };
        put(session, of, field(ui, of.label, &shown, self.field, read), write);
    }

    /// A short text without blanks around it.
    pub(super) fn text(
        self,
        ui: &mut Ui,
        session: &mut Session,
        of: Field<'_>,
        value: &str,
        write: impl FnOnce(&mut RollSet, String),
    ) {
        /// Longest text, characters.
        const LONGEST: usize = 40;
        self.label(ui, of.label);
        let read = |text: &str| match text.trim() {
            text if text.chars().count() > LONGEST => Err(format!("The text is longer than {LONGEST} characters.")),
            text => Ok(text.to_owned()),
        };
        put(session, of, field(ui, of.label, value, self.field, read), write);
    }

    /// What follows from other fields, to be read only.
    pub(super) fn told(self, ui: &mut Ui, label: &str, text: &str) -> egui::Response {
        self.label(ui, label);
        let (rect, response) = ui.allocate_exact_size(egui::vec2(self.field, 26.0), egui::Sense::hover());
        response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Label, true, format!("{label} {text}")));
        let color = crate::app::theme::Colors::of(ui.visuals()).plot.text;
        let font = egui::FontId::proportional(crate::app::theme::TEXT);
        let at = rect.right_center() - egui::vec2(9.0, 0.0);
        ui.painter().text(at, egui::Align2::RIGHT_CENTER, text, font, color);
        response
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
fn put<T>(session: &mut Session, of: Field<'_>, typed: Option<Typed<T>>, write: impl FnOnce(&mut RollSet, T)) {
    let Some(typed) = typed else { return };
    typed.put_into(session, &of.label.to_lowercase(), |document, value| {
        if let Some(set) = super::set_mut(document) {
            write(set, value);
        }
    });
}
