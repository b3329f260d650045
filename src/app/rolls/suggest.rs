//! A flower that is suggested: how many stations, which angles.

use super::set_mut;
use crate::app::theme::{self, Colors};
use crate::app::widgets::{Typed, choice, field, form_label, link, primary_button};
use crate::document::{Document, RollSet};
use crate::rollform::strain::limit;
use crate::rollform::suggest::{
    Choice, MOST_STATIONS, Order, Sequence, angles, count_by_edge_strain, count_by_forming_angle, with_bends,
};
use crate::session::Session;
use egui::Ui;

/// Width of the labels, points.
const LABEL: f32 = 66.0;
/// Width of the fields, points.
const FIELD: f32 = 190.0;

/// What the panel keeps.
#[derive(Debug, Default)]
pub(super) struct SuggestView {
    choice: Choice,
    /// Number of stations that was typed; by the forming-angle method otherwise.
    count: Option<usize>,
    /// Numbers by the two methods, and what they were made for.
    counts: Option<(RollSet, Choice, usize, Option<usize>)>,
}

/// The link that opens the choice.
pub(super) fn show(ui: &mut Ui, view: &mut SuggestView, session: &mut Session) {
    let response = link(ui, "suggest").on_hover_text("Suggest stations and angles");
    egui::Popup::menu(&response).close_behavior(egui::PopupCloseBehavior::CloseOnClickOutside).show(|ui| {
        ui.set_width(LABEL + FIELD + 12.0);
        if form(ui, view, session) {
            ui.close();
        }
    });
}

/// True if a flower was made.
fn form(ui: &mut Ui, view: &mut SuggestView, session: &mut Session) -> bool {
    let document = std::sync::Arc::clone(session.document());
    let Some(set) = document.content.roll_set() else { return false };
    let set_mm = set.scaled(document.unit.in_mm());
    let (by_angle, by_strain) = view.counts(&set_mm);
    ui.label(theme::strong("Suggest a flower"));
    row(ui, "Angles", |ui| {
        let all = Sequence::ALL.map(|s| (s, s.name().to_owned()));
        if let Some(sequence) = choice(ui, "Sequence of angles", &view.choice.sequence, &all, FIELD) {
            view.choice.sequence = sequence;
        }
    });
    row(ui, "Order", |ui| {
        let all = Order::ALL.map(|o| (o, o.name().to_owned()));
        if let Some(order) = choice(ui, "Order of bends", &view.choice.order, &all, FIELD) {
            view.choice.order = order;
        }
    });
    let count = view.count.unwrap_or(by_angle);
    row(ui, "Stations", |ui| {
        let typed = field(ui, "Number of stations", &count.to_string(), 60.0, read_count);
        if let Some(Typed::Value(count) | Typed::Left(Some(count))) = typed {
            view.count = Some(count);
        }
    });
    numbers(ui, view, by_angle, by_strain, limit(&set_mm.strip));
    let made = primary_button(ui, "Make this flower", true).clicked();
    if made {
        let (choice, count) = (view.choice, view.count.unwrap_or(by_angle));
        session.edit("suggest a flower", None, |document| apply(document, &set_mm, choice, count));
        view.count = None;
    }
    made
}

fn row(ui: &mut Ui, label: &str, add: impl FnOnce(&mut Ui)) {
    ui.horizontal(|ui| {
        form_label(ui, label, LABEL);
        add(ui);
    });
}

fn numbers(ui: &mut Ui, view: &mut SuggestView, by_angle: usize, by_strain: Option<usize>, limit: f64) {
    let colors = Colors::of(ui.visuals());
    ui.label(theme::quiet("Guide values:", colors));
    if link(ui, &format!("{by_angle} by forming angle 1°25′")).clicked() {
        view.count = Some(by_angle);
    }
    let percent = limit * 100.0;
    match by_strain {
        Some(count) => {
            if link(ui, &format!("{count} by mean edge strain ≤ {percent:.2} %")).clicked() {
                view.count = Some(count);
            }
        }
        None => {
            ui.label(theme::quiet(format!("More than {MOST_STATIONS} by mean edge strain ≤ {percent:.2} %"), colors));
        }
    }
}

/// Reads a number of stations.
fn read_count(text: &str) -> Result<usize, String> {
    let count = text.trim().parse::<usize>().ok().filter(|count| (1..=MOST_STATIONS).contains(count));
    count.ok_or_else(|| format!("“{}” is no number of stations from 1 to {MOST_STATIONS}.", text.trim()))
}

impl SuggestView {
    /// Numbers of stations by the two methods, made once for a set and a choice.
    fn counts(&mut self, set_mm: &RollSet) -> (usize, Option<usize>) {
        if let Some((set, choice, by_angle, by_strain)) = &self.counts
            && set == set_mm
            && *choice == self.choice
        {
            return (*by_angle, *by_strain);
        }
        let by_angle = count_by_forming_angle(set_mm, self.choice.order);
        let by_strain = count_by_edge_strain(set_mm, self.choice);
        self.counts = Some((set_mm.clone(), self.choice, by_angle, by_strain));
        (by_angle, by_strain)
    }
}

/// Gives the set stations with the suggested angles.
fn apply(document: &mut Document, set_mm: &RollSet, choice: Choice, count: usize) {
    let Some(set) = set_mut(document) else { return };
    set.stations = with_bends(&set.stations, &set.line, angles(set_mm, choice, count));
}
