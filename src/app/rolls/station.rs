//! The rolls and the strip of the station that is shown.

use super::RollsViews;
use crate::app::desk::Requests;
use crate::app::plots::{Palette, StationEvent, StationScene, fixed, station_plot};
use crate::app::theme::{self, Colors};
use crate::app::widgets::{link, title_row, toggle};
use crate::rollform::{Roll, StationDesign};
use crate::session::Session;
use egui::Ui;

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
    let number = super::shown_station(session, set).map_or(1, |(number, _)| number);
    let design = session.derived().and_then(|d| d.rolls.as_ref()).map(|rolls| std::sync::Arc::clone(&rolls.design));
    let station = design.as_ref().and_then(|design| design.stations.iter().find(|s| s.number == number));
    let remark = station.map(|station| told(station, document.unit)).unwrap_or_default();
    let view = &mut views.station;
    let dragged = title_row(ui, titled.then_some("Station"), &remark, |ui| {
        if link(ui, "fit").clicked() {
            view.canvas.fit();
        }
        if toggle(ui, &mut view.whole, "whole rolls").clicked() {
            view.canvas.fit();
        }
        toggle(ui, &mut view.clearance, "clearance")
            .on_hover_text("Blue: touches the strip · amber: clear of it · red: inside it");
    });
    let Some(station) = station else {
        let colors = Colors::of(ui.visuals());
        ui.label(theme::quiet("There is no strip to show at this station yet; see the problems.", colors));
        return dragged;
    };
    ui.set_opacity(if session.is_designed() { 1.0 } else { super::STALE });
    let palette = Palette::of(ui.visuals());
    let scene = StationScene {
        station,
        drawn_gap_mm: set.line.drawn_gap * document.unit.in_mm(),
        unit: document.unit,
        roll: session.roll(),
        element: session.selection.element,
        palette: &palette,
    };
    for event in station_plot(ui, view, &scene) {
        match event {
            StationEvent::SelectElement(element) => session.selection.element = Some(element),
            StationEvent::SelectRoll(roll) => session.select_roll(roll),
            StationEvent::Pointer(p) => {
                let length = |mm: f64| fixed(mm / document.unit.in_mm(), document.unit.decimals());
                requests.place.get_or_insert_with(|| {
                    format!("across {}  height {} {}", length(p.z), length(p.r), document.unit.symbol())
                });
            }
        }
    }
    dragged
}

/// The station in a few words.
fn told(station: &StationDesign, unit: crate::units::Unit) -> String {
    let length = |mm: f64| fixed(mm / unit.in_mm(), unit.decimals());
    let bounds = station.rolls.first().map(Roll::contour).and_then(|contour| contour.bounds());
    let width = bounds.map_or_else(String::new, |b| format!(" · roll width {}", length(b.max.z - b.min.z)));
    let openings = station.openings;
    format!(
        "{} · gap {} driving, {} clear{width} {}",
        station.number,
        length(openings.drive),
        length(openings.clearance),
        unit.symbol()
    )
}
