//! Small charts with the window's looks.

use crate::app::plots::Palette;
use crate::app::theme::{self, Colors};
use egui::{Color32, Sense, Stroke, Ui, vec2};
use egui_plot::{
    AxisHints, GridInput, GridMark, HLine, HoverPosition, Line, LineStyle, Plot, PlotPoints, PlotUi, Points,
};
use std::ops::RangeInclusive;

/// A chart with names of its axes, from zero upwards.
pub(super) fn chart(
    ui: &mut Ui,
    name: &str,
    axes: (&'static str, &'static str),
    size: egui::Vec2,
    content: impl FnOnce(&mut PlotUi<'_>),
) {
    chart_from(ui, name, axes, 0.0, size, content);
}

/// A chart in which `lowest` is shown at least.
pub(super) fn chart_from(
    ui: &mut Ui,
    name: &str,
    (x, y): (&'static str, &'static str),
    lowest: f64,
    size: egui::Vec2,
    content: impl FnOnce(&mut PlotUi<'_>),
) {
    let labels = egui::Rangef::new(24.0, 44.0);
    let plot = Plot::new(name.to_owned())
        .width(size.x)
        .height(size.y)
        .custom_x_axes(vec![AxisHints::new_x().label(x).label_spacing(labels).formatter(figure)])
        .custom_y_axes(vec![AxisHints::new_y().label(y).formatter(figure)])
        .x_grid_spacer(|input| round_steps(&input))
        .y_grid_spacer(|input| round_steps(&input))
        .include_y(lowest)
        .allow_scroll(false)
        .show_background(false)
        .label_formatter(|at| {
            let (HoverPosition::NearDataPoint { position, .. } | HoverPosition::Elsewhere { position }) = at;
            Some(format!("{:.3}, {:.3}", position.x, position.y))
        });
    // The chart draws its grid and figures in the colour of text: a quiet one leaves the lines that matter in front.
    let quiet = Palette::of(ui.visuals()).construction;
    ui.scope(|ui| {
        ui.visuals_mut().widgets.noninteractive.fg_stroke.color = quiet;
        plot.show(ui, content);
    });
}

/// The figure at a grid line, with as many decimals as its step has.
fn figure(mark: GridMark, _: &RangeInclusive<f64>) -> String {
    let decimals = (-mark.step_size.log10().floor()).clamp(0.0, 6.0);
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped to 0..=6")]
    let decimals = if decimals.is_finite() { decimals as usize } else { 0 };
    crate::app::plots::fixed(mark.value, decimals)
}

/// Grid lines at steps of 1, 2 or 5 times a power of ten, so far apart that each has room for its figure.
fn round_steps(input: &GridInput) -> Vec<GridMark> {
    /// Smallest steps of the plot in one of ours.
    const ROOM: f64 = 6.0;
    /// More lines than any chart has room for.
    const MOST: u32 = 200;
    let least = input.base_step_size * ROOM;
    let power = 10.0_f64.powf(least.log10().floor());
    let step = [1.0, 2.0, 5.0, 10.0].map(|k| k * power).into_iter().find(|step| *step >= least).unwrap_or(least);
    let (from, to) = input.bounds;
    if !(step.is_finite() && step > 0.0 && from.is_finite() && to.is_finite()) {
        return Vec::new();
    }
    let first = (from / step).ceil();
    let marks = (0..MOST).map(|k| (first + f64::from(k)) * step).take_while(|value| *value <= to);
    marks.map(|value| GridMark { value, step_size: step }).collect()
}

/// Names of lines in their colours, above their chart.
pub(super) fn names(ui: &mut Ui, lines: &[(&str, Color32)]) {
    ui.horizontal(|ui| {
        for (name, color) in lines {
            let (rect, _) = ui.allocate_exact_size(vec2(14.0, 14.0), Sense::hover());
            ui.painter().hline(rect.x_range(), rect.center().y, Stroke::new(2.0, *color));
            ui.label(theme::quiet(*name, Colors::of(ui.visuals())));
        }
    });
}

/// A line by points, thinned to what a chart can show.
pub(super) fn line(plot: &mut PlotUi<'_>, name: &str, points: Vec<[f64; 2]>, color: Color32, width: f32) {
    plot.line(Line::new(name.to_owned(), PlotPoints::new(thinned(points))).color(color).width(width));
}

/// A dashed line across the chart.
pub(super) fn limit(plot: &mut PlotUi<'_>, name: &str, y: f64, palette: &Palette) {
    plot.hline(HLine::new(name.to_owned(), y).color(palette.wrong).width(1.0).style(LineStyle::dashed_loose()));
}

/// Single points.
pub(super) fn points(plot: &mut PlotUi<'_>, name: &str, at: Vec<[f64; 2]>, color: Color32, radius: f32) {
    plot.points(Points::new(name.to_owned(), PlotPoints::new(at)).color(color).radius(radius));
}

fn thinned(points: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
    /// A chart is never wider, points.
    const MOST: usize = 3000;
    let stride = points.len() / MOST + 1;
    let last = points.last().copied();
    points.into_iter().step_by(stride).chain(last).collect()
}
