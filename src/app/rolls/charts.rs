//! Edge strain, springback and properties of the section.

mod properties;
mod springback;
mod strain;

use super::RollsViews;
use crate::app::desk::Requests;
use crate::app::theme::{self, Colors};
use crate::app::widgets::title_row;
use crate::session::Session;
use egui::Ui;
use std::sync::Arc;

/// What is charted.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
enum Subject {
    #[default]
    Strain,
    Springback,
    Properties,
}

impl Subject {
    const ALL: [Self; 3] = [Self::Strain, Self::Springback, Self::Properties];

    const fn name(self) -> &'static str {
        match self {
            Self::Strain => "Edge strain",
            Self::Springback => "Springback",
            Self::Properties => "Section",
        }
    }
}

/// What the panel keeps.
#[derive(Debug, Default)]
pub(super) struct ChartsView {
    subject: Subject,
}

/// Shows the panel; true if it is dragged by its title.
pub(super) fn show(
    ui: &mut Ui,
    titled: bool,
    session: &mut Session,
    views: &mut RollsViews,
    _requests: &mut Requests,
) -> bool {
    let document = Arc::clone(session.document());
    let derived = session.derived().and_then(|d| d.rolls.clone());
    let (Some(set), Some(derived)) = (document.content.roll_set(), derived) else {
        return title_row(ui, titled.then_some("Charts"), "", |_| {});
    };
    let view = &mut views.charts;
    let remark = match view.subject {
        Subject::Strain => "guide values: light peak, dark mean · dashed: the material yields",
        Subject::Springback => "guide values: elastic, perfectly plastic strip",
        Subject::Properties => "mean line, open thin-walled section; axes through the centroid",
    };
    let dragged = title_row(ui, titled.then_some("Charts"), remark, |ui| subjects(ui, view));
    match view.subject {
        Subject::Strain => strain::show(ui, &derived.flower, set, session),
        Subject::Springback => springback::show(ui, &derived.flower, set, session),
        Subject::Properties => properties::show(ui, &derived.flower, set),
    }
    dragged
}

/// The words to choose by, from right to left.
fn subjects(ui: &mut Ui, view: &mut ChartsView) {
    let colors = Colors::of(ui.visuals());
    for subject in Subject::ALL.into_iter().rev() {
        let on = view.subject == subject;
        let color = if on { colors.plot.accent } else { colors.plot.quiet };
        let font = if on { theme::strong_font(theme::TEXT) } else { egui::FontId::proportional(theme::TEXT) };
        let text = egui::RichText::new(subject.name()).color(color).font(font);
        let response = ui.add(egui::Button::new(text).frame(false));
        response.widget_info(|| egui::WidgetInfo::selected(egui::Role::RadioButton, true, on, subject.name()));
        if response.clicked() {
            view.subject = subject;
        }
    }
}

/// A line of cells at fixed places, the first one left, the others right.
fn line(ui: &mut Ui, cells: &[String], widths: &[f32], strong: bool, quiet: bool) -> egui::Response {
    let colors = Colors::of(ui.visuals());
    let width: f32 = widths.iter().sum();
    let (rect, response) = ui.allocate_exact_size(egui::vec2(width, 22.0), egui::Sense::click());
    if response.hovered() && !quiet {
        ui.painter().rect_filled(rect, 3.0, colors.hovered);
    }
    let font = if strong { theme::strong_font(theme::TEXT) } else { egui::FontId::proportional(theme::TEXT) };
    let color = if quiet { colors.plot.quiet } else { colors.plot.text };
    let mut left = rect.left();
    for (index, (cell, width)) in cells.iter().zip(widths).enumerate() {
        let (align, x) = if index == 0 {
            (egui::Align2::LEFT_CENTER, left + 4.0)
        } else {
            (egui::Align2::RIGHT_CENTER, left + width - 6.0)
        };
        ui.painter().text(egui::pos2(x, rect.center().y), align, cell, font.clone(), color);
        left += width;
    }
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Row, true, cells.join(", ")));
    response
}
