//! The flower, with the stage that stands out: picked, slid to or played.

use super::{RollsViews, set_mut};
use crate::app::desk::Requests;
use crate::app::plots::{FlowerEvent, FlowerPlotView, FlowerScene, Palette, Phase, flower_plot};
use crate::app::theme::Colors;
use crate::app::widgets::{title_row, toggle};
use crate::diagnostic::Place;
use crate::document::{Element, RollSet};
use crate::rollform::bends::{Stage, angles_deg, bend_states};
use crate::rollform::flower::Flower;
use crate::rollform::springback::{METHOD, released_bends};
use crate::rollform::strain::between;
use crate::rollform::strip::Strip;
use crate::session::{GestureId, Session};
use egui::{Slider, Ui};
use std::sync::Arc;

/// Room below the plot for the slider, points.
const SLIDER: f32 = 26.0;
/// More stages than this are picked with the slider only.
const MOST_BUTTONS: usize = 12;
/// Time from one stage to the next while the flower is played, s.
const STAGE_S: f64 = 0.9;

/// What the panel keeps.
#[derive(Debug, Default)]
pub(super) struct FlowerView {
    plot: FlowerPlotView,
    /// Stage that stands out, counted from flat; between two stages while it is played.
    position: f64,
    /// The station that was selected in the last frame.
    followed: Option<u32>,
    side_by_side: bool,
    springback: bool,
    playing: bool,
    gesture: Option<GestureId>,
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
        return title_row(ui, titled.then_some("Flower"), "", |_| {});
    };
    let (view, flower) = (&mut views.flower, &derived.flower);
    let last = flower.shapes.len().saturating_sub(1);
    view.follow(session, set);
    view.position = view.position.clamp(0.0, last as f64);
    let count = set.stations.len();
    let remark = if count == 1 { "1 station".to_owned() } else { format!("{count} stations") };
    let dragged = title_row(ui, titled.then_some("Flower"), &remark, |ui| {
        buttons(ui, view, flower, session, set);
    });
    if view.playing {
        play(ui, view, last);
    }
    let set_mm = set.scaled(document.unit.in_mm());
    let events = plot(ui, view, flower, &set_mm, session);
    ui.spacing_mut().slider_width = (ui.available_width() - 8.0).max(60.0);
    let slider = Slider::new(&mut view.position, 0.0..=last as f64).show_value(false);
    let slider = ui.add_enabled(last > 0, slider);
    slider.widget_info(|| egui::WidgetInfo::slider(true, view.position, "Stage of the flower"));
    if slider.changed() {
        view.playing = false;
        view.position = settled(view.position);
        tell_station(view, session, set);
    }
    for event in events {
        done(&event, session, view, set);
    }
    dragged
}

/// A position near a stage is at it.
fn settled(position: f64) -> f64 {
    /// Part of the way between two stages.
    const NEAR: f64 = 0.12;
    if (position - position.round()).abs() < NEAR { position.round() } else { position }
}

/// The stage at a position, if it is at one.
fn stage_at(flower: &Flower, position: f64) -> Option<Stage> {
    if position.fract() != 0.0 {
        return None;
    }
    flower.shapes.get(index(position)).map(|shape| shape.stage)
}

#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a position is not negative and small")]
const fn index(position: f64) -> usize {
    position.max(0.0) as usize
}

impl FlowerView {
    /// Goes to the station that was selected elsewhere.
    fn follow(&mut self, session: &Session, set: &RollSet) {
        let selected = session.selection.station.or_else(|| set.stations.first().map(|s| s.id));
        if selected == self.followed {
            return;
        }
        self.followed = selected;
        if let Some((number, _)) = selected.and_then(|id| set.station(id)) {
            self.position = number as f64;
            self.playing = false;
        }
    }
}

/// Selects the station that stands out.
fn tell_station(view: &mut FlowerView, session: &mut Session, set: &RollSet) {
    let station = index(view.position).checked_sub(1).filter(|_| view.position.fract() == 0.0);
    if let Some(station) = station.and_then(|index| set.stations.get(index)) {
        view.followed = Some(station.id);
        super::select_station(session, station.id);
    }
}

/// The row of stages and what can be done with them, from right to left.
fn buttons(ui: &mut Ui, view: &mut FlowerView, flower: &Flower, session: &mut Session, set: &RollSet) {
    let colors = Colors::of(ui.visuals());
    if flower.shapes.len() <= MOST_BUTTONS {
        ui.spacing_mut().item_spacing.x = 0.0;
        for (place, shape) in flower.shapes.iter().enumerate().rev() {
            let on = (view.position - place as f64).abs() < 1e-9;
            let name = match shape.stage {
                Stage::Flat => "flat".to_owned(),
                Stage::Finished => "final".to_owned(),
                Stage::Station(index) => (index + 1).to_string(),
            };
            let color = if on { colors.on_accent } else { colors.plot.text };
            let fill = if on { colors.plot.accent } else { colors.panel };
            let button = egui::Button::new(egui::RichText::new(&name).color(color)).fill(fill).corner_radius(4);
            let response = ui.add(button.stroke(egui::Stroke::new(1.0, colors.field_line)));
            response.widget_info(|| egui::WidgetInfo::selected(egui::Role::Button, true, on, format!("Stage {name}")));
            if response.clicked() {
                (view.position, view.playing) = (place as f64, false);
                tell_station(view, session, set);
            }
        }
        ui.spacing_mut().item_spacing.x = 8.0;
        ui.add_space(8.0);
    }
    let separate = toggle(ui, &mut view.side_by_side, "side by side");
    if separate.on_hover_text("Every stage with an origin of its own; otherwise all have one in common").clicked() {
        view.plot.canvas.fit();
    }
    let hint = format!("The strip after the rolls, sprung back: a guide value ({METHOD})");
    toggle(ui, &mut view.springback, "springback").on_hover_text(hint);
    if toggle(ui, &mut view.playing, "play").clicked() && view.playing {
        view.side_by_side = false;
        if index(view.position) + 1 >= flower.shapes.len() {
            view.position = 0.0;
        }
    }
}

fn play(ui: &Ui, view: &mut FlowerView, last: usize) {
    view.position += f64::from(ui.input(|i| i.stable_dt)).min(0.1) / STAGE_S;
    if view.position >= last as f64 {
        (view.position, view.playing) = (last as f64, false);
    }
    ui.ctx().request_repaint();
}

fn plot(ui: &mut Ui, view: &mut FlowerView, flower: &Flower, set_mm: &RollSet, session: &Session) -> Vec<FlowerEvent> {
    let palette = Palette::of(ui.visuals());
    let stage = stage_at(flower, view.position);
    let shown = match stage {
        Some(stage) => Strip::at(set_mm, stage),
        None => on_the_way(set_mm, flower, view.position),
    };
    let released = stage.filter(|_| view.springback).map(|s| Strip::with_bends(set_mm, &released_bends(set_mm, s)));
    let angles = stage.map(|stage| angles_deg(set_mm, stage)).unwrap_or_default();
    let scene = FlowerScene {
        flower,
        shown: &shown,
        stage,
        released: released.as_ref(),
        selected: session.selection.element,
        name_of: &|id| name_of(set_mm, id),
        angle_of: &|id| angles.get(&id).copied(),
        side_by_side: view.side_by_side,
        palette: &palette,
    };
    flower_plot(ui, &mut view.plot, &scene, SLIDER)
}

/// The strip between two stages.
fn on_the_way(set_mm: &RollSet, flower: &Flower, position: f64) -> Strip {
    let at = |place: usize| flower.shapes.get(place).map_or(Stage::Finished, |shape| shape.stage);
    let place = index(position);
    let (from, to) = (bend_states(set_mm, at(place)), bend_states(set_mm, at(place + 1)));
    Strip::with_bends(set_mm, &between(&from, &to, position.fract(), set_mm.section.thickness))
}

/// What an element is called.
pub(super) fn name_of(set: &RollSet, id: u32) -> String {
    let find = |list: &[Element]| list.iter().position(|e| e.id == id).map(|index| index + 1);
    let place = |number, other_side| Place::Element { id, number, other_side }.to_string();
    let first = find(&set.section.elements).map(|number| place(number, false));
    first.or_else(|| find(&set.section.other_side).map(|number| place(number, true))).unwrap_or_default()
}

fn done(event: &FlowerEvent, session: &mut Session, view: &mut FlowerView, set: &RollSet) {
    match *event {
        FlowerEvent::Select(element) => session.selection.element = Some(element),
        FlowerEvent::Pick(stage) => {
            view.position = match stage {
                Stage::Flat => 0.0,
                Stage::Station(index) => index as f64 + 1.0,
                Stage::Finished => set.stations.len() as f64 + 1.0,
            };
            tell_station(view, session, set);
        }
        FlowerEvent::Bend { element, angle_deg, phase } => {
            if phase == Phase::Begin || view.gesture.is_none() {
                view.gesture = Some(session.new_gesture());
            }
            session.selection.element = Some(element);
            let station = index(view.position).checked_sub(1);
            let label = format!("angle of {}", name_of(set, element));
            session.edit(&label, view.gesture, |document| {
                let station = station.and_then(|index| set_mut(document)?.stations.get_mut(index));
                if let Some(station) = station {
                    super::angles::set_angle(station, element, Some(angle_deg));
                }
            });
            if matches!(phase, Phase::End | Phase::Single) {
                view.gesture = None;
            }
        }
    }
}
