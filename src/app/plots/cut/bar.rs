//! The playback bar: first, back, play, forward, last, the slider over time, clock and speed.

use super::playback::{clock, next_block_s, previous_block_s, total_s};
use super::{CutEvent, CutView};
use crate::app::plots::palette::Palette;
use crate::proof::Move;
use egui::{Align2, Color32, FontId, Key, Painter, Pos2, Rect, Response, Sense, Shape, Stroke, Ui, Vec2};

/// Height of the bar, points.
pub(super) const HEIGHT: f32 = 34.0;
/// Width of a button, points.
const BUTTON: f32 = 28.0;
/// Width of the clock, points.
const CLOCK: f32 = 92.0;
/// Width of the speed selector, points.
const SPEED: f32 = 34.0;
/// Speeds to choose from, times the machine's.
const SPEEDS: [u32; 7] = [1, 2, 4, 8, 16, 32, 64];
/// One press of an arrow key on the slider moves by this share of the whole time.
const KEY_SHARE: f64 = 0.01;

/// Lays the bar out and does what it is asked.
pub(super) fn bar(ui: &mut Ui, view: &mut CutView, moves: &[Move], palette: &Palette, events: &mut Vec<CutEvent>) {
    let total = total_s(moves);
    let before = view.time_s;
    ui.horizontal(|ui| {
        ui.set_height(HEIGHT);
        ui.spacing_mut().item_spacing.x = 2.0;
        buttons(ui, view, moves, palette);
        ui.add_space(8.0);
        let width = (ui.available_width() - CLOCK - SPEED - 16.0).max(40.0);
        slider(ui, view, total, width, palette);
        ui.add_space(8.0);
        clock_text(ui, view.time_s, total, palette);
        speed(ui, view, palette);
    });
    if view.time_s != before {
        events.push(CutEvent::Scrub(view.time_s));
    }
}

/// What the bar's keys do while the plot has the focus: space, left and right, home and end.
pub(super) fn keys(ui: &Ui, view: &mut CutView, moves: &[Move], events: &mut Vec<CutEvent>) {
    let before = view.time_s;
    ui.input(|i| {
        for (key, step) in [
            (Key::ArrowRight, Step::Forward),
            (Key::ArrowLeft, Step::Back),
            (Key::Home, Step::First),
            (Key::End, Step::Last),
            (Key::Space, Step::Play),
        ] {
            if i.key_pressed(key) {
                view.step(moves, step);
            }
        }
    });
    if view.time_s != before {
        events.push(CutEvent::Scrub(view.time_s));
    }
}

/// What a button of the bar does.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Step {
    /// To the start.
    First,
    /// To the start of this block or the one before.
    Back,
    /// Starts or stops the time.
    Play,
    /// To the next block.
    Forward,
    /// To the end.
    Last,
}

impl CutView {
    pub(super) fn step(&mut self, moves: &[Move], step: Step) {
        let total = total_s(moves);
        match step {
            Step::First => self.time_s = 0.0,
            Step::Back => self.time_s = previous_block_s(moves, self.time_s),
            Step::Forward => self.time_s = next_block_s(moves, self.time_s),
            Step::Last => self.time_s = total,
            Step::Play => {
                // Played to the end, the next play starts over.
                if !self.playing && self.time_s >= total {
                    self.time_s = 0.0;
                }
                self.playing = !self.playing && total > 0.0;
                return;
            }
        }
        self.playing = false;
    }
}

fn buttons(ui: &mut Ui, view: &mut CutView, moves: &[Move], palette: &Palette) {
    let play = if view.playing { "Pause" } else { "Play" };
    let all = [
        (Step::First, "First block"),
        (Step::Back, "Block back"),
        (Step::Play, play),
        (Step::Forward, "Block forward"),
        (Step::Last, "Last block"),
    ];
    for (step, name) in all {
        let response = ui.allocate_response(Vec2::new(BUTTON, HEIGHT), Sense::click());
        response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Button, ui.is_enabled(), name));
        draw_button(ui, &response, step, view.playing, palette);
        if response.on_hover_text(name).clicked() {
            view.step(moves, step);
        }
    }
}

fn draw_button(ui: &Ui, response: &Response, step: Step, playing: bool, palette: &Palette) {
    let painter = ui.painter();
    let middle = response.rect.center();
    let lit = response.hovered() || response.has_focus();
    let color = if lit { palette.accent } else { palette.text };
    match step {
        Step::Play => {
            painter.circle_filled(middle, if lit { 13.5 } else { 12.5 }, palette.accent);
            if playing { pause(painter, middle, palette.ground) } else { wedge(painter, middle, 5.0, palette.ground) }
        }
        Step::Back => wedge(painter, middle, -4.5, color),
        Step::Forward => wedge(painter, middle, 4.5, color),
        Step::First => stopped_wedge(painter, middle, -4.5, color),
        Step::Last => stopped_wedge(painter, middle, 4.5, color),
    }
}

fn wedge(painter: &Painter, middle: Pos2, size: f32, color: Color32) {
    let tall = size.abs() * 1.1;
    let corners = [(-size * 0.7, -tall), (size * 1.1, 0.0), (-size * 0.7, tall)].map(|(x, y)| middle + Vec2::new(x, y));
    painter.add(Shape::convex_polygon(corners.to_vec(), color, Stroke::NONE));
}

fn stopped_wedge(painter: &Painter, middle: Pos2, size: f32, color: Color32) {
    wedge(painter, middle - Vec2::new(size * 0.4, 0.0), size, color);
    let x = middle.x + size * 1.1;
    painter.vline(x, middle.y - size.abs() * 1.2..=middle.y + size.abs() * 1.2, Stroke::new(1.6, color));
}

fn pause(painter: &Painter, middle: Pos2, color: Color32) {
    for x in [-2.8, 2.8] {
        let rect = Rect::from_center_size(middle + Vec2::new(x, 0.0), Vec2::new(2.6, 10.0));
        painter.rect_filled(rect, 0.5, color);
    }
}

fn slider(ui: &mut Ui, view: &mut CutView, total: f64, width: f32, palette: &Palette) {
    let response = ui.allocate_response(Vec2::new(width, HEIGHT), Sense::click_and_drag());
    let words = format!("Time {} of {}", clock(view.time_s), clock(total));
    response.widget_info(|| egui::WidgetInfo::slider(ui.is_enabled(), view.time_s, &words));
    let track = response.rect.shrink2(Vec2::new(6.0, 0.0));
    if let Some(pos) = response.interact_pointer_pos().filter(|_| response.is_pointer_button_down_on()) {
        let share = f64::from((pos.x - track.left()) / track.width().max(1.0));
        view.time_s = share.clamp(0.0, 1.0) * total;
        view.playing = false;
    }
    if response.has_focus() {
        slider_keys(ui, view, total, response.id);
    }
    draw_slider(ui.painter(), &response, track, share_of(view.time_s, total), palette);
}

fn slider_keys(ui: &Ui, view: &mut CutView, total: f64, id: egui::Id) {
    let filter = egui::EventFilter { horizontal_arrows: true, ..egui::EventFilter::default() };
    ui.memory_mut(|m| m.set_focus_lock_filter(id, filter));
    let presses = |key| ui.input(|i| u32::try_from(i.num_presses(key)).unwrap_or(0));
    let by = f64::from(presses(Key::ArrowRight)) - f64::from(presses(Key::ArrowLeft));
    view.time_s = (view.time_s + by * KEY_SHARE * total).clamp(0.0, total);
}

#[allow(clippy::cast_possible_truncation, reason = "a share of a width on the screen")]
fn share_of(time_s: f64, total: f64) -> f32 {
    if total > 0.0 { (time_s / total).clamp(0.0, 1.0) as f32 } else { 0.0 }
}

fn draw_slider(painter: &Painter, response: &Response, track: Rect, share: f32, palette: &Palette) {
    let knob = Pos2::new(track.left() + track.width() * share, track.center().y);
    let line = |from: f32, to: f32| Rect::from_x_y_ranges(from..=to, knob.y - 2.0..=knob.y + 2.0);
    painter.rect_filled(line(track.left(), track.right()), 2.0, palette.steel);
    painter.rect_filled(line(track.left(), knob.x), 2.0, palette.accent);
    let radius = if response.hovered() || response.has_focus() { 7.0 } else { 6.0 };
    painter.circle(knob, radius, palette.ground, Stroke::new(2.0, palette.accent));
}

fn clock_text(ui: &mut Ui, time_s: f64, total: f64, palette: &Palette) {
    let (_, rect) = ui.allocate_space(Vec2::new(CLOCK, HEIGHT));
    let text = format!("{} / {}", clock(time_s), clock(total));
    ui.painter().text(rect.right_center(), Align2::RIGHT_CENTER, text, FontId::proportional(12.5), palette.text);
}

fn speed(ui: &mut Ui, view: &mut CutView, palette: &Palette) {
    let text = egui::RichText::new(format!("×{}", view.speed)).color(palette.quiet);
    let button = egui::Button::new(text).frame(false).min_size(Vec2::new(SPEED, HEIGHT));
    let response = ui.add(button).on_hover_text("Speed of playback, times the machine's");
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Button, true, format!("Speed ×{}", view.speed)));
    egui::Popup::menu(&response).show(|ui| {
        for choice in SPEEDS {
            if ui.selectable_label(view.speed == choice, format!("×{choice}")).clicked() {
                view.speed = choice;
            }
        }
    });
}
