//! The log of runs, their comparison, and the published measurements beside them.

use super::ShellViews;
use super::chart::{chart, chart_from, line, points};
use super::live::Made;
use crate::app::plots::Palette;
use crate::app::theme::{self, Colors};
use crate::app::widgets::{title_row, toggle};
use crate::spinning::measurements::{Measurement, published};
use crate::spinning::operator::Job;
use egui::{Color32, RichText, ScrollArea, Ui, vec2};

/// Colours of runs side by side, of the Okabe-Ito set.
const COLORS: [Color32; 5] = [
    Color32::from_rgb(0x00, 0x72, 0xB2),
    Color32::from_rgb(0xE6, 0x9F, 0x00),
    Color32::from_rgb(0x00, 0x9E, 0x73),
    Color32::from_rgb(0xCC, 0x79, 0xA7),
    Color32::from_rgb(0x56, 0xB4, 0xE9),
];

/// What the comparison shows.
#[derive(Debug, Default)]
pub(super) struct Comparison {
    measured: bool,
}

/// Shows the panel; true if it is dragged by its title.
pub(super) fn show(ui: &mut Ui, titled: bool, views: &mut ShellViews) -> bool {
    let count = views.live.runs.len();
    let dragged = title_row(ui, titled.then_some("Runs"), &format!("{count}"), |ui| {
        toggle(ui, &mut views.comparison.measured, "published measurements");
    });
    let colors = Colors::of(ui.visuals());
    let room = ui.available_size();
    ui.horizontal_top(|ui| {
        ui.vertical(|ui| {
            ui.set_width(room.x * 0.42);
            if views.live.runs.is_empty() {
                ui.label(theme::quiet("No run yet.", colors));
            }
            ScrollArea::vertical().max_height(room.y - 4.0).show(ui, |ui| {
                for made in views.live.runs.iter_mut().rev() {
                    entry(ui, made, colors);
                }
            });
        });
        let size = vec2(ui.available_width(), room.y);
        if views.comparison.measured {
            measurements(ui, &views.live.runs, size);
        } else {
            errors(ui, &views.live.runs, size);
        }
    });
    dragged
}

fn color_of(made: &Made) -> Color32 {
    COLORS.get(made.number % COLORS.len()).copied().unwrap_or(Color32::GRAY)
}

/// Two lines: what it was, and what came of it.
fn entry(ui: &mut Ui, made: &mut Made, colors: &Colors) {
    let errors = made.run.errors();
    ui.horizontal(|ui| {
        let (rect, _) = ui.allocate_exact_size(vec2(10.0, 10.0), egui::Sense::hover());
        ui.painter().rect_filled(rect, 2.0, color_of(made));
        toggle(ui, &mut made.shown, &format!("{}  {}", made.number, made.name));
    });
    let color = if made.run.is_completed() || made.run.is_running() { colors.plot.quiet } else { colors.plot.wrong };
    ui.label(RichText::new(made.run.verdict()).color(color));
    let text = format!(
        "error largest {:.2}, mean {:.2}, at the end {:+.2} mm · angle {:.2}°",
        errors.largest_mm, errors.mean_mm, errors.final_mm, errors.angle_deg
    );
    ui.label(theme::quiet(text, colors));
    ui.add_space(4.0);
}

fn errors(ui: &mut Ui, runs: &[Made], size: egui::Vec2) {
    chart(ui, "errors", ("carriage, mm", "too far back, mm"), size, |plot| {
        for made in runs.iter().filter(|m| m.shown) {
            let error = made.run.actual().iter().map(|p| [p.carriage_mm, p.error_mm(made.run.plan())]);
            line(plot, &made.name, error.collect(), color_of(made), 1.3);
        }
    });
}

/// Set angle against measured angle, and against reduction with the sine law; own cones beside them.
fn measurements(ui: &mut Ui, runs: &[Made], size: egui::Vec2) {
    let palette = Palette::of(ui.visuals());
    let half = vec2((size.x - 10.0) / 2.0, size.y);
    let own: Vec<[f64; 2]> = runs
        .iter()
        .filter(|m| m.shown)
        .filter_map(|m| match m.job {
            Job::Cone(cone) => Some([f64::from(cone.angle_deg()), m.run.errors().angle_deg]),
            Job::Parabola(_) | Job::Design => None,
        })
        .collect();
    let of = |value: fn(&Measurement) -> Option<f64>| {
        published().iter().filter_map(|m| Some([m.set_deg, value(m)?])).collect::<Vec<_>>()
    };
    chart_from(ui, "angles", ("set angle, °", "measured angle, °"), 28.0, half, |plot| {
        line(plot, "as set", vec![[29.0, 29.0], [46.0, 46.0]], palette.construction, 1.0);
        points(plot, "published", of(|m| Some(m.measured_deg)), palette.unreachable, 2.0);
        points(plot, "own runs", own, palette.accent, 4.0);
    });
    let sine = (29..=46).map(|deg| [f64::from(deg), 100.0 * (1.0 - f64::from(deg).to_radians().sin())]).collect();
    chart(ui, "reductions", ("set angle, °", "reduction, %"), half, |plot| {
        line(plot, "sine law", sine, palette.construction, 1.0);
        points(plot, "published", of(|m| m.reduction.map(|r| 100.0 * r)), palette.unreachable, 2.0);
    });
}
