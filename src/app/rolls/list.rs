//! All rolls of the set, with what is done about each.

use super::RollsViews;
use crate::app::desk::Requests;
use crate::app::theme::{self, Colors};
use crate::app::widgets::{clock, title_row};
use crate::regen::RollDerived;
use crate::rollform::Roll;
use crate::session::Session;
use egui::{Align2, Color32, FontId, Rect, ScrollArea, Sense, Ui, vec2};

/// What is done about a roll.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Status {
    /// It has a contour, and nothing is made of it yet.
    Designed,
    /// Its contour was corrected by hand, and nothing is made of it yet.
    Edited,
    /// It has programs that are not proved.
    Planned,
    /// Its programs are proved.
    Proved,
}

impl Status {
    fn of(roll: &Roll, made: Option<&RollDerived>) -> Self {
        let current = made.filter(|made| made.current);
        match current {
            Some(made) if made.is_proved() => Self::Proved,
            Some(made) if made.derived.setups.iter().any(|s| !s.programs.is_empty()) => Self::Planned,
            _ if roll.elements != roll.designed => Self::Edited,
            _ => Self::Designed,
        }
    }

    const fn word(self) -> &'static str {
        match self {
            Self::Designed => "designed",
            Self::Edited => "edited",
            Self::Planned => "planned",
            Self::Proved => "proved",
        }
    }

    const fn color(self, colors: &Colors) -> Color32 {
        match self {
            Self::Designed => colors.plot.construction,
            Self::Edited => colors.plot.unreachable,
            Self::Planned => colors.plot.accent,
            Self::Proved => colors.good,
        }
    }
}

/// Shows the panel; true if it is dragged by its title.
pub(super) fn show(
    ui: &mut Ui,
    titled: bool,
    session: &mut Session,
    _views: &mut RollsViews,
    _requests: &mut Requests,
) -> bool {
    let derived = session.derived().and_then(|derived| derived.rolls.clone());
    let all = derived.as_ref().map_or(0, |set| set.design.rolls().count());
    let dragged = title_row(ui, titled.then_some("Rolls"), &all.to_string(), |_| {});
    let Some(set) = derived.filter(|_| all > 0) else {
        let colors = Colors::of(ui.visuals());
        ui.label(theme::quiet("There are no rolls yet: no station, or no strip that has an extent.", colors));
        return dragged;
    };
    let shown = session.roll();
    let mut chosen = None;
    ScrollArea::vertical().id_salt("rolls").auto_shrink([false, false]).show(ui, |ui| {
        for roll in set.design.rolls() {
            if row(ui, roll, set.of_roll(roll.roll), shown == Some(roll.roll)) {
                chosen = Some(roll.roll);
            }
        }
        let time: f64 = set.rolls.iter().map(time_s).sum();
        let colors = Colors::of(ui.visuals());
        ui.add_space(6.0);
        ui.label(theme::quiet(format!("machining of the set {}", clock(time)), colors));
    });
    if let Some(roll) = chosen {
        session.select_roll(roll);
    }
    dragged
}

/// Machining time of a roll, s.
fn time_s(roll: &RollDerived) -> f64 {
    roll.derived.setups.iter().map(|s| s.proof.times.total_s).sum()
}

/// One roll; true if it was clicked.
fn row(ui: &mut Ui, roll: &Roll, made: Option<&RollDerived>, selected: bool) -> bool {
    let colors = Colors::of(ui.visuals());
    let status = Status::of(roll, made);
    let (rect, response) = ui.allocate_exact_size(vec2(ui.available_width(), theme::ROW), Sense::click());
    response.widget_info(|| {
        let text = format!("Roll {}: {}", roll.name, status.word());
        egui::WidgetInfo::selected(egui::Role::Row, true, selected, text)
    });
    let painter = ui.painter_at(rect);
    if selected || response.hovered() {
        painter.rect_filled(rect, 4.0, if selected { colors.selected } else { colors.hovered });
    }
    let dot = Rect::from_center_size(rect.left_center() + vec2(11.0, 0.0), vec2(9.0, 9.0));
    painter.rect_filled(dot, 2.5, status.color(colors));
    let font = FontId::proportional(theme::TEXT);
    let short = roll.name.rsplit('-').next().unwrap_or(&roll.name);
    let name_font = if selected { theme::strong_font(theme::TEXT) } else { font.clone() };
    painter.text(rect.left_center() + vec2(24.0, 0.0), Align2::LEFT_CENTER, short, name_font, colors.plot.text);
    painter.text(
        rect.left_center() + vec2(58.0, 0.0),
        Align2::LEFT_CENTER,
        status.word(),
        font.clone(),
        colors.plot.quiet,
    );
    let time = made.filter(|made| made.current).map(time_s).filter(|time| *time > 0.0);
    let time = time.map_or_else(|| "–".to_owned(), clock);
    painter.text(rect.right_center() - vec2(8.0, 0.0), Align2::RIGHT_CENTER, time, font, colors.plot.text);
    response.on_hover_text(&roll.name).clicked()
}
