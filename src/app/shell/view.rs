//! Former and roller.

use super::{ShellViews, edit};
use crate::app::desk::Requests;
use crate::app::plots::{Palette, Phase, ShellEvent, ShellScene, shell_plot};
use crate::app::theme::{self, Colors};
use crate::app::widgets::{link, title_row, toggle};
use crate::diagnostic::Severity;
use crate::geometry::Point;
use crate::session::Session;
use crate::spinning::operator::Job;
use crate::spinning::reshape;
use egui::Ui;

/// Figures of a drag are rounded to this, mm and degrees.
const STEP: f64 = 0.1;

/// Shows the panel; true if it is dragged by its title.
pub(super) fn show(
    ui: &mut Ui,
    titled: bool,
    session: &mut Session,
    views: &mut ShellViews,
    requests: &mut Requests,
) -> bool {
    let unit = session.document().unit;
    let dragged = title_row(ui, titled.then_some("Former and roller"), unit.symbol(), |ui| {
        if link(ui, "fit").clicked() {
            views.plot.canvas.fit();
        }
        let mut path = !views.plot.without_path;
        toggle(ui, &mut path, "path");
        views.plot.without_path = !path;
        let mut full = !views.plot.half;
        toggle(ui, &mut full, "full section");
        views.plot.half = !full;
    });
    let Some(derived) = session.derived().cloned() else { return dragged };
    let Some(made) = &derived.shell else {
        nothing_to_draw(ui, session);
        return dragged;
    };
    let palette = Palette::of(ui.visuals());
    let scene =
        ShellScene { made, machine: derived.machine.as_deref(), unit, roller: roller(views, made), palette: &palette };
    for event in shell_plot(ui, &mut views.plot, &scene) {
        match event {
            ShellEvent::Pointer(z, diameter) => requests.pointer = requests.pointer.or(Some((z, diameter))),
            ShellEvent::Drag { grip, to, free, phase } => {
                if phase == Phase::Begin {
                    views.drag = Some(session.new_gesture());
                }
                let gesture = views.drag.filter(|_| phase != Phase::Single);
                let (mm, step) = (unit.in_mm(), if free { 0.0 } else { STEP });
                edit(session, "drag the former", gesture, |shell| {
                    *shell = reshape::dragged(&shell.scaled(mm), grip, to, step).scaled(1.0 / mm);
                });
                if phase == Phase::End {
                    views.drag = None;
                }
            }
        }
    }
    dragged
}

/// Why there is no shell, in the place where it would be.
pub(super) fn nothing_to_draw(ui: &mut Ui, session: &Session) {
    let colors = Colors::of(ui.visuals());
    ui.add_space(12.0);
    ui.label(theme::quiet("The figures give no shell yet.", colors));
    let errors = session.problems().iter().filter(|d| d.severity == Severity::Error);
    for said in errors.take(3) {
        ui.label(theme::quiet(&said.message, colors));
    }
}

/// Where the roller of the newest run of this shell stands; while none runs it is at its approach.
fn roller(views: &ShellViews, made: &crate::regen::ShellDerived) -> Option<Point> {
    let newest = views.live.newest().filter(|m| m.job == Job::Design && views.live.is_running())?;
    let start = made.path.last()?.contour.segments.first()?.start();
    let carriage = newest.run.carriage_mm();
    Some(Point::new(start.z - carriage, start.r + newest.run.retreat_mm()))
}
