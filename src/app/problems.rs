//! Every message about the document and its programs; a click goes to its place.

use super::actions::Action;
use super::desk::Requests;
use super::theme::{self, Colors};
use super::widgets::toggle;
use crate::diagnostic::{Diagnostic, Severity};
use crate::session::{Session, Verdict};
use egui::{Align2, FontId, Sense, Stroke, Ui, vec2};

/// Which messages are shown.
#[derive(Debug)]
pub(crate) struct ProblemsView {
    errors: bool,
    warnings: bool,
    remarks: bool,
    /// At most so many.
    most: usize,
}

impl Default for ProblemsView {
    fn default() -> Self {
        Self { errors: true, warnings: true, remarks: true, most: AT_ONCE }
    }
}

/// So many messages are listed at first and with every wish for more. Each of them is laid out in every frame.
const AT_ONCE: usize = 200;

/// Width of the column with the places, points.
const PLACE: f32 = 132.0;

/// Shows the panel; true if it is dragged by its title.
pub(crate) fn show(
    ui: &mut Ui,
    view: &mut ProblemsView,
    session: &Session,
    requests: &mut Requests,
    titled: bool,
) -> bool {
    let problems = session.problems();
    let count = |severity| session.problem_count(severity);
    let dragged = super::widgets::title_row(ui, titled.then_some("Problems"), "", |ui| {
        let text = |n: usize, word: &str| format!("{n} {word}{}", if n == 1 { "" } else { "s" });
        toggle(ui, &mut view.remarks, &text(count(Severity::Info), "remark"));
        toggle(ui, &mut view.warnings, &text(count(Severity::Warning), "warning"));
        toggle(ui, &mut view.errors, &text(count(Severity::Error), "error"));
    });
    if problems.is_empty() {
        clean(ui, session);
        return dragged;
    }
    let shown = |d: &&Diagnostic| match d.severity {
        Severity::Error => view.errors,
        Severity::Warning => view.warnings,
        Severity::Info => view.remarks,
    };
    egui::ScrollArea::vertical().auto_shrink([false, false]).show(ui, |ui| {
        ui.spacing_mut().item_spacing.y = 0.0;
        let mut wanted = problems.iter().filter(shown);
        for problem in wanted.by_ref().take(view.most) {
            row(ui, problem, requests);
        }
        more(ui, &mut view.most, wanted.count());
    });
    dragged
}

/// Says how many messages are not listed, and lists more of them on a click.
fn more(ui: &mut Ui, most: &mut usize, left: usize) {
    if left > 0 {
        ui.add_space(6.0);
        let text = format!("Show {} more of the {left} that are not listed", left.min(AT_ONCE));
        if ui.button(text).clicked() {
            *most += AT_ONCE;
        }
    }
}

fn clean(ui: &mut Ui, session: &Session) {
    let colors = Colors::of(ui.visuals());
    let text = match session.verdict() {
        Verdict::Pending => "The proof is running.",
        Verdict::NoProgram => "There is nothing to complain about, and no program to prove yet.",
        Verdict::Proved { .. } | Verdict::Failed { .. } => {
            "No problems. Every section is sound, and the proof of the program found nothing wrong."
        }
    };
    ui.label(theme::quiet(text, colors));
}

fn row(ui: &mut Ui, problem: &Diagnostic, requests: &mut Requests) {
    let colors = Colors::of(ui.visuals());
    let color = match problem.severity {
        Severity::Error => colors.plot.wrong,
        Severity::Warning => colors.plot.unreachable,
        Severity::Info => colors.plot.quiet,
    };
    let width = ui.available_width();
    let font = FontId::proportional(theme::TEXT);
    let hint = problem.hint.as_ref().map(|hint| format!(" {hint}")).unwrap_or_default();
    let text_width = width - PLACE - 18.0;
    let text = format!("{}{hint}", problem.message);
    let message = ui.painter().layout(text, font.clone(), colors.plot.text, text_width);
    let (rect, response) = ui.allocate_exact_size(vec2(width, message.size().y + 9.0), Sense::click());
    response.widget_info(|| {
        egui::WidgetInfo::labeled(egui::Role::Button, true, format!("{}: {}", problem.at, problem.message))
    });
    if response.hovered() || response.has_focus() {
        ui.painter().rect_filled(rect, 4.0, colors.hovered);
    }
    let line = rect.top() + 4.5 + FontId::proportional(theme::TEXT).size * 0.62;
    ui.painter().circle_filled(egui::pos2(rect.left() + 9.0, line), 4.0, color);
    let place = ui.painter_at(egui::Rect::from_x_y_ranges(rect.left() + 22.0..=rect.left() + PLACE, rect.y_range()));
    place.text(
        egui::pos2(rect.left() + 22.0, line),
        Align2::LEFT_CENTER,
        problem.at.to_string(),
        font,
        colors.plot.quiet,
    );
    ui.painter().galley(egui::pos2(rect.left() + PLACE + 12.0, rect.top() + 4.5), message, colors.plot.text);
    ui.painter().hline(rect.x_range(), rect.bottom(), Stroke::new(1.0, colors.line.gamma_multiply(0.6)));
    if response.on_hover_cursor(egui::CursorIcon::PointingHand).clicked() {
        requests.actions.push(Action::GoTo(problem.at.clone()));
    }
}
