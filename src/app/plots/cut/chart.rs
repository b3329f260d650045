//! A small chart of the chip cross-section over time, under the cut plot.

use super::CutScene;
use super::playback::clock;
use crate::proof::{Motion, ProofReport};
use egui::{Align2, FontId, Response, Role, Sense, Shape, Stroke, Ui};
use egui_plot::{HoverPosition, Line, Plot, PlotPoints, VLine};
use std::collections::HashMap;
use std::sync::Arc;

/// Height of the line that opens and closes the chart, points.
const HEADING: f32 = 20.0;
/// Height of the chart, points.
const CHART: f32 = 64.0;
/// At most this many points are drawn; a chart is never wider.
const MOST_POINTS: usize = 4000;

/// The curve of one proof, made when first shown.
#[derive(Debug, Default)]
pub(super) struct Chart {
    made_for: Option<Arc<ProofReport>>,
    curve: Vec<[f64; 2]>,
}

impl Chart {
    /// Height that heading and chart take.
    pub(super) const fn height(open: bool) -> f32 {
        if open { HEADING + CHART } else { HEADING }
    }

    /// Shows the heading, and the chart if `open`.
    pub(super) fn show(&mut self, ui: &mut Ui, open: &mut bool, scene: &CutScene<'_>, time_s: f64) {
        let largest = scene.derived.proof.largest_chip_mm2;
        let text = format!("Chip cross-section, at most {largest:.3} mm²");
        *open ^= heading(ui, *open, &text, scene).clicked();
        if *open {
            self.update(&scene.derived.proof);
            self.plot(ui, scene, time_s);
        }
    }

    fn update(&mut self, proof: &Arc<ProofReport>) {
        if !self.made_for.as_ref().is_some_and(|made| Arc::ptr_eq(made, proof)) {
            self.curve = steps(proof);
            self.made_for = Some(Arc::clone(proof));
        }
    }

    fn plot(&self, ui: &mut Ui, scene: &CutScene<'_>, time_s: f64) {
        let palette = scene.palette;
        let line = Line::new("chip cross-section, mm²", PlotPoints::new(self.curve.clone()))
            .color(palette.accent)
            .width(1.2)
            .fill(0.0)
            .fill_alpha(0.12)
            // A band would draw steps as slopes.
            .allow_band(false);
        let now = VLine::new("now", time_s).color(palette.quiet).width(1.0);
        Plot::new("chip cross-section")
            .height(CHART)
            .allow_zoom(false)
            .allow_drag(false)
            .allow_scroll(false)
            .allow_boxed_zoom(false)
            .show_grid([false, true])
            .include_y(0.0)
            .show_axes(false)
            .label_formatter(|at| {
                let (HoverPosition::NearDataPoint { position, .. } | HoverPosition::Elsewhere { position }) = at;
                Some(format!("{}  {:.3} mm²", clock(position.x), position.y))
            })
            .show_background(false)
            .show(ui, |plot| {
                plot.line(line);
                plot.vline(now);
            });
    }
}

/// The line that opens and closes the chart.
fn heading(ui: &mut Ui, open: bool, text: &str, scene: &CutScene<'_>) -> Response {
    let quiet = scene.palette.quiet;
    let response = ui.allocate_response(egui::vec2(ui.available_width(), HEADING), Sense::click());
    response.widget_info(|| egui::WidgetInfo::selected(Role::Button, ui.is_enabled(), open, text));
    let color = if response.hovered() || response.has_focus() { scene.palette.accent } else { quiet };
    let middle = response.rect.left_center();
    let [tip, back, side] = if open {
        [egui::vec2(8.0, 3.0), egui::vec2(4.0, -2.0), egui::vec2(12.0, -2.0)]
    } else {
        [egui::vec2(11.0, 0.0), egui::vec2(6.0, -4.0), egui::vec2(6.0, 4.0)]
    };
    let corners = [tip, back, side].map(|by| middle + by).to_vec();
    ui.painter().add(Shape::convex_polygon(corners, color, Stroke::NONE));
    let font = FontId::proportional(11.0);
    ui.painter().text(middle + egui::vec2(20.0, 0.0), Align2::LEFT_CENTER, text, font, color);
    response
}

/// The chip of every move over its time, as steps.
fn steps(proof: &ProofReport) -> Vec<[f64; 2]> {
    let chips: HashMap<(&str, usize), f64> =
        proof.blocks.iter().map(|b| ((b.program.as_str(), b.block), b.chip_mm2)).collect();
    let names = program_names(proof);
    let stride = proof.moves.len() / (MOST_POINTS / 2) + 1;
    proof
        .moves
        .chunks(stride)
        .filter_map(|moves| {
            let (first, last) = (moves.first()?, moves.last()?);
            let chip = |m: &crate::proof::Move| match m.motion {
                Motion::Feed | Motion::Thread => {
                    names.get(m.program).and_then(|name| chips.get(&(*name, m.block))).copied().unwrap_or(0.0)
                }
                Motion::Rapid | Motion::Pause => 0.0,
            };
            let largest = moves.iter().map(chip).fold(0.0, f64::max);
            Some([[first.starts_s, largest], [last.starts_s + last.lasts_s, largest]])
        })
        .flatten()
        .collect()
}

/// Names of the programs in the order in which their blocks are reported.
fn program_names(proof: &ProofReport) -> Vec<&str> {
    let mut names: Vec<&str> = proof.blocks.iter().map(|b| b.program.as_str()).collect();
    names.dedup();
    names
}
