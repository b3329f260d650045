//! Rows of the parameter table: label, field, unit.

use super::edit;
use crate::app::theme::{self, Colors};
use crate::app::widgets::{Typed, choice, field, form_label};
use crate::document::{Content, Shell};
use crate::session::Session;
use crate::units::{Unit, parse_length};
use egui::Ui;

/// Width of a field, points.
const FIELD: f32 = 96.0;
/// Width of the unit behind it, points.
const UNIT: f32 = 46.0;
/// Width of a choice, points: that of a field with its unit.
const CHOICE: f32 = FIELD + UNIT + 6.0;

/// What a figure counts.
#[derive(Clone, Copy)]
pub(super) enum Counts {
    /// A length in the document's unit.
    Length,
    /// Anything else, with its unit and decimals.
    Other(&'static str, usize),
}

/// A heading.
pub(super) fn heading(ui: &mut Ui, text: &str) {
    ui.add_space(6.0);
    ui.label(theme::strong(text));
}

/// One figure; `path` is its path in the file, by which messages find it.
pub(super) fn figure(
    ui: &mut Ui,
    session: &mut Session,
    (label, path): (&str, &str),
    value: f64,
    counts: Counts,
    write: impl FnOnce(&mut Shell, f64),
) {
    let unit = session.document().unit;
    let (unit_text, decimals) = match counts {
        Counts::Length => (unit.symbol(), unit.decimals()),
        Counts::Other(text, decimals) => (text, decimals),
    };
    let shown = crate::app::plots::fixed(value, decimals);
    row(ui, session, (label, path), &shown, unit_text, |text| read(text, counts, unit), write);
}

/// A row whose text is read by `read`.
pub(super) fn row<T>(
    ui: &mut Ui,
    session: &mut Session,
    (label, path): (&str, &str),
    shown: &str,
    unit: &str,
    read: impl Fn(&str) -> Result<T, String>,
    write: impl FnOnce(&mut Shell, T),
) {
    let said = problem(session, path);
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 6.0;
        form_label(ui, label, (ui.available_width() - FIELD - UNIT - 12.0).max(60.0));
        let typed = field(ui, label, shown, FIELD, read);
        let colors = Colors::of(ui.visuals());
        let (rect, response) = ui.allocate_exact_size(egui::vec2(UNIT, 26.0), egui::Sense::hover());
        let color = if said.is_some() { colors.plot.wrong } else { colors.plot.quiet };
        let font = egui::FontId::proportional(theme::TEXT);
        let text = if said.is_some() { format!("{unit}  !") } else { unit.to_owned() };
        ui.painter().text(rect.left_center(), egui::Align2::LEFT_CENTER, text, font, color);
        if let Some(said) = said {
            response.on_hover_text(said);
        }
        put(typed, session, label, write);
    });
}

/// A field for words below its label, as wide as the panel, for at most `longest` characters.
pub(super) fn words(
    ui: &mut Ui,
    session: &mut Session,
    label: &str,
    shown: &str,
    longest: usize,
    write: impl FnOnce(&mut Shell, String),
) {
    let read = |text: &str| {
        let count = text.trim().chars().count();
        if text.chars().any(char::is_control) {
            Err("Enter letters and figures of one line.".to_owned())
        } else if count > longest {
            Err(format!("The text has {count} characters; the limit is {longest}."))
        } else {
            Ok(text.trim().to_owned())
        }
    };
    form_label(ui, label, ui.available_width());
    let typed = field(ui, label, shown, ui.available_width(), read);
    put(typed, session, label, write);
}

/// A choice in the place of a field.
pub(super) fn pick<T: PartialEq + Clone>(
    ui: &mut Ui,
    session: &mut Session,
    label: &str,
    present: &T,
    all: &[(T, &str)],
    write: impl FnOnce(&mut Shell, &T),
) {
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 6.0;
        form_label(ui, label, (ui.available_width() - CHOICE - 6.0).max(60.0));
        let all: Vec<(T, String)> = all.iter().map(|(value, text)| (value.clone(), (*text).to_owned())).collect();
        if let Some(chosen) = choice(ui, label, present, &all, CHOICE) {
            edit(session, &label.to_lowercase(), None, |shell| write(shell, &chosen));
        }
    });
}

/// The worst message about a figure.
fn problem(session: &Session, path: &str) -> Option<String> {
    use crate::diagnostic::{Place, Severity};
    // What is said of a whole list is said of every row of it, what is said of a row of every figure in it.
    let of_row = |p: &str, rest: &str| p.ends_with(']') && rest.starts_with('.');
    let about =
        |p: &str| path.strip_prefix(p).is_some_and(|rest| rest.is_empty() || rest.starts_with('[') || of_row(p, rest));
    let about = |at: &Place| matches!(at, Place::Setting { path: p } if about(p));
    session.problems().iter().find(|d| about(&d.at) && d.severity != Severity::Info).map(|d| d.message.clone())
}

/// Puts what is typed into the shell.
pub(super) fn put<T>(typed: Option<Typed<T>>, session: &mut Session, label: &str, write: impl FnOnce(&mut Shell, T)) {
    if let Some(typed) = typed {
        typed.put_into(session, &label.to_lowercase(), |document, value| {
            if let Content::Shell(shell) = &mut document.content {
                write(shell, value);
            }
        });
    }
}

fn read(text: &str, counts: Counts, unit: Unit) -> Result<f64, String> {
    match counts {
        Counts::Length => parse_length(text, unit),
        Counts::Other(..) => {
            let value: f64 = text.trim().replace(',', ".").parse().map_err(|_| format!("\"{text}\" is no figure."))?;
            if value.is_finite() { Ok(value) } else { Err(format!("\"{text}\" is no figure.")) }
        }
    }
}
