//! The finished cross-section beside the table of its elements.

use super::{RollsViews, words};
use crate::app::desk::Requests;
use crate::app::plots::{CanvasView, Palette, SectionEvent, SectionScene, fixed, section_plot};
use crate::app::theme::{self, Colors};
use crate::app::widgets::{link, title_row};
use crate::document::{Element, ElementKind, RollSet};
use crate::rollform::bends::Stage;
use crate::session::Session;
use crate::units::Unit;
use egui::Ui;

/// What the panel keeps.
#[derive(Debug, Default)]
pub(super) struct SectionView {
    canvas: CanvasView,
}

/// Shows the panel; true if it is dragged by its title.
pub(super) fn show(
    ui: &mut Ui,
    titled: bool,
    session: &mut Session,
    views: &mut RollsViews,
    requests: &mut Requests,
) -> bool {
    let document = std::sync::Arc::clone(session.document());
    let Some(set) = document.content.roll_set() else { return false };
    let unit = document.unit;
    let flower = session.derived().and_then(|d| d.rolls.as_ref()).map(|rolls| std::sync::Arc::clone(&rolls.flower));
    let finished = flower.as_ref().and_then(|flower| flower.at(Stage::Finished)).filter(|s| !s.strip.pieces.is_empty());
    let length = |mm: f64| fixed(mm / unit.in_mm(), unit.decimals());
    let size = finished.and_then(|shape| shape.strip.outline().bounds());
    let remark =
        size.map(|b| format!("{} × {} {}", length(b.max.z - b.min.z), length(b.max.r - b.min.r), unit.symbol()));
    let view = &mut views.section;
    let dragged = title_row(ui, titled.then_some("Cross-section"), &remark.unwrap_or_default(), |ui| {
        if link(ui, "fit").clicked() {
            view.canvas.fit();
        }
    });
    let Some(finished) = finished else {
        let colors = Colors::of(ui.visuals());
        ui.label(theme::quiet("There is no element yet. Add one in the table of elements.", colors));
        return dragged;
    };
    ui.set_opacity(if session.is_designed() { 1.0 } else { super::STALE });
    let palette = Palette::of(ui.visuals());
    let scene = SectionScene {
        strip: &finished.strip,
        selected: session.selection.element,
        number_of: &|id| words::number(set, id),
        told: &|id| told(set, id, unit),
        palette: &palette,
    };
    for event in section_plot(ui, &mut view.canvas, &scene) {
        match event {
            SectionEvent::Select(id) => views.elements.select(session, set, id),
            SectionEvent::Pointer(p) => {
                requests
                    .place
                    .get_or_insert_with(|| format!("across {}  height {} {}", length(p.z), length(p.r), unit.symbol()));
            }
        }
    }
    dragged
}

/// An element with its figures.
fn told(set: &RollSet, id: u32, unit: Unit) -> Vec<String> {
    let mut lines = vec![super::flower::name_of(set, id)];
    let length = |value: f64| format!("{} {}", fixed(value, unit.decimals()), unit.symbol());
    match set.section.all().find(|e| e.id == id) {
        Some(Element { kind: ElementKind::Line { length: l }, .. }) => lines.push(length(*l)),
        Some(Element { kind: ElementKind::Bend { inside_radius, angle_deg }, .. }) => {
            lines.push(format!("inside r {}, {}°", length(*inside_radius), words::angle(*angle_deg)));
        }
        None => {}
    }
    lines
}
