//! The operator's guided panel: one question in large type, one obvious next action, emergency stop always there.

use super::ShellViews;
use crate::app::theme::{self, Colors};
use crate::app::widgets::title_row;
use crate::session::Session;
use crate::spinning::operator::Key;
use egui::{Button, RichText, Stroke, Ui, vec2};

/// Size of the prompt, points.
const PROMPT: f32 = 21.0;
/// Size of a figure that is typed, points.
const FIGURE: f32 = 34.0;
/// Height of the buttons, points.
const BUTTON: f32 = 44.0;
/// Size of the text on them, points.
const LARGE: f32 = 16.0;

/// Shows the panel; true if it is dragged by its title.
pub(super) fn show(ui: &mut Ui, titled: bool, session: &Session, views: &mut ShellViews) -> bool {
    let screen = views.live.sequence.screen();
    let dragged = title_row(ui, titled.then_some("Operator"), screen.title, |_| {});
    let colors = Colors::of(ui.visuals());
    ui.add_space(8.0);
    ui.label(RichText::new(&screen.prompt).font(theme::strong_font(PROMPT)));
    if let Some(field) = &screen.field {
        let shown = if field.is_empty() { "–".to_owned() } else { field.clone() };
        ui.label(RichText::new(shown).font(theme::strong_font(FIGURE)).color(colors.plot.accent));
        keypad(ui, session, views);
    }
    if let Some(wrong) = &screen.wrong {
        ui.label(RichText::new(wrong).font(theme::strong_font(14.0)).color(colors.plot.wrong));
    }
    if views.live.is_running() {
        progress(ui, views);
    }
    ui.add_space(6.0);
    let mut pressed = None;
    for (index, choice) in screen.choices.iter().enumerate() {
        let clicked = if index == 0 { wide_primary(ui, choice.label) } else { wide(ui, choice.label) };
        if clicked {
            pressed = Some(choice.key);
        }
    }
    ui.add_space(8.0);
    for note in &screen.notes {
        ui.label(theme::quiet(note, colors));
    }
    ui.with_layout(egui::Layout::bottom_up(egui::Align::Min), |ui| {
        ui.add_space(4.0);
        ui.label(theme::quiet("Escape does the same while the rig runs.", colors));
        if wide_stop(ui) {
            pressed = Some(Key::Emergency);
        }
    });
    if let Some(key) = pressed {
        views.live.press(key, session);
    }
    dragged
}

/// Digits for a hand at a touch screen.
fn keypad(ui: &mut Ui, session: &Session, views: &mut ShellViews) {
    let mut pressed = None;
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing = vec2(4.0, 4.0);
        for digit in '0'..='9' {
            if ui.add(Button::new(digit.to_string()).min_size(vec2(30.0, 30.0))).clicked() {
                pressed = Some(Key::Char(digit));
            }
        }
        if ui.add(Button::new("⌫").min_size(vec2(30.0, 30.0))).on_hover_text("Delete one digit").clicked() {
            pressed = Some(Key::Delete);
        }
    });
    if let Some(key) = pressed {
        views.live.press(key, session);
    }
}

fn progress(ui: &mut Ui, views: &ShellViews) {
    let Some(made) = views.live.newest() else { return };
    let plan = made.run.plan();
    let last = plan.targets.last().map_or(1.0, |t| f64::from(t.pulses));
    let here = made.run.carriage_mm().max(0.0) / crate::spinning::published::MM_PER_PULSE;
    #[allow(clippy::cast_possible_truncation, reason = "a share of 0 to 1")]
    let share = (here / last.max(1.0)).clamp(0.0, 1.0) as f32;
    ui.add(egui::ProgressBar::new(share).desired_height(10.0));
}

fn wide_primary(ui: &mut Ui, text: &str) -> bool {
    let colors = Colors::of(ui.visuals());
    let width = ui.available_width();
    let text = RichText::new(text).font(theme::strong_font(LARGE)).color(colors.on_accent);
    let button = Button::new(text).fill(colors.plot.accent).stroke(Stroke::NONE);
    ui.add_sized(vec2(width, BUTTON), button).clicked()
}

fn wide(ui: &mut Ui, text: &str) -> bool {
    let width = ui.available_width();
    ui.add_sized(vec2(width, BUTTON), Button::new(RichText::new(text).size(LARGE))).clicked()
}

fn wide_stop(ui: &mut Ui) -> bool {
    let width = ui.available_width();
    stop(ui, vec2(width, 46.0), 17.0)
}

/// The emergency stop in the head of the window.
pub(crate) fn stop_button(ui: &mut Ui) -> bool {
    stop(ui, vec2(130.0, 28.0), theme::TEXT + 0.5)
}

fn stop(ui: &mut Ui, size: egui::Vec2, font: f32) -> bool {
    let colors = Colors::of(ui.visuals());
    let text = RichText::new("Emergency stop").font(theme::strong_font(font)).color(colors.on_accent);
    ui.add_sized(size, Button::new(text).fill(colors.plot.wrong).stroke(Stroke::NONE)).clicked()
}
