//! All rolls of the set, with what is done about each, and what they weigh and cost.

use super::RollsViews;
use super::fields::{Field, Form};
use super::words;
use crate::app::desk::Requests;
use crate::app::theme::{self, Colors};
use crate::app::widgets::{clock, title_row};
use crate::document::{RollSet, RollWork};
use crate::machine::Catalog;
use crate::papers::{RollLine, roll_lines};
use crate::regen::{Derived, RollDerived, Sent};
use crate::rollform::Roll;
use crate::session::Session;
use egui::{Align2, Color32, FontId, Rect, ScrollArea, Sense, Ui, vec2};
use std::fmt::Write;
use std::sync::Arc;

/// Where names and states begin, points from the left.
const NAME: f32 = 24.0;
const STATE: f32 = 58.0;
/// Width of a column of figures, points.
const FIGURES: f32 = 46.0;
/// Room at the right border, points.
const BORDER: f32 = 8.0;
/// Least width with a column for the material, and where it begins.
const WITH_MATERIAL: f32 = 370.0;
const MATERIAL: f32 = 122.0;
/// Room for what rolls cost below the list, points.
const COSTS: f32 = 66.0;

/// What the panel keeps: the lines of the newest results.
#[derive(Debug, Default)]
pub(super) struct ListView {
    made: Option<(Arc<Derived>, Vec<RollLine>)>,
}

impl ListView {
    fn lines(&mut self, derived: &Arc<Derived>) -> &[RollLine] {
        if !self.made.as_ref().is_some_and(|(of, _)| Arc::ptr_eq(of, derived)) {
            self.made = Some((Arc::clone(derived), roll_lines(derived)));
        }
        self.made.as_ref().map_or(&[], |(_, lines)| lines.as_slice())
    }
}

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
    /// Its programs went to the lathe as they are now.
    Sent,
}

impl Status {
    fn of(roll: &Roll, made: Option<&RollDerived>, sent: Sent) -> Self {
        let current = made.filter(|made| made.current);
        match current {
            Some(_) if sent == Sent::Yes => Self::Sent,
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
            Self::Sent => "sent",
        }
    }

    const fn color(self, colors: &Colors) -> Color32 {
        match self {
            Self::Designed => colors.plot.construction,
            Self::Edited => colors.plot.unreachable,
            Self::Planned => colors.plot.accent,
            Self::Proved | Self::Sent => colors.good,
        }
    }
}

/// Shows the panel; true if it is dragged by its title.
pub(super) fn show(
    ui: &mut Ui,
    titled: bool,
    session: &mut Session,
    views: &mut RollsViews,
    requests: &mut Requests,
) -> bool {
    let document = Arc::clone(session.document());
    let derived = session.derived().map(Arc::clone);
    let made = derived.as_ref().and_then(|derived| derived.rolls.clone());
    let all = made.as_ref().map_or(0, |set| set.design.rolls().count());
    let dragged = title_row(ui, titled.then_some("Rolls"), &all.to_string(), |_| {});
    let (Some(derived), Some(made), Some(set)) = (derived, made.filter(|_| all > 0), document.content.roll_set())
    else {
        let colors = Colors::of(ui.visuals());
        ui.label(theme::quiet("There are no rolls yet: no station, or no strip that has an extent.", colors));
        return dragged;
    };
    let lines = views.list.lines(&derived);
    heading(ui);
    let shown = session.roll();
    let mut chosen = None;
    let height = (ui.available_height() - COSTS).max(2.0 * theme::ROW);
    ScrollArea::vertical().id_salt("rolls").max_height(height).auto_shrink([false, false]).show(ui, |ui| {
        for (roll, line) in made.design.rolls().zip(lines) {
            let row = Row { roll, line, made: made.of_roll(roll.roll), work: set.roll(roll.roll) };
            if row.show(ui, shown == Some(roll.roll)) {
                chosen = Some(roll.roll);
            }
        }
        total(ui, lines);
    });
    costs(ui, set, session, &requests.catalog);
    if let Some(roll) = chosen {
        session.select_roll(roll);
    }
    dragged
}

/// Right ends of the columns of figures: weight, cost, time.
fn ends(rect: Rect) -> [f32; 3] {
    let right = rect.right() - BORDER;
    [right - 2.0 * FIGURES, right - FIGURES, right]
}

fn heading(ui: &mut Ui) {
    let colors = Colors::of(ui.visuals());
    let (rect, _) = ui.allocate_exact_size(vec2(ui.available_width(), 18.0), Sense::hover());
    let font = FontId::proportional(theme::SMALL);
    let text = |x: f32, align, text: &str| {
        ui.painter().text(egui::pos2(x, rect.center().y), align, text, font.clone(), colors.plot.quiet);
    };
    text(rect.left() + NAME, Align2::LEFT_CENTER, "roll");
    text(rect.left() + STATE, Align2::LEFT_CENTER, "state");
    if rect.width() >= WITH_MATERIAL {
        text(rect.left() + MATERIAL, Align2::LEFT_CENTER, "material");
    }
    for (x, name) in ends(rect).into_iter().zip(["kg", "cost", "time"]) {
        text(x, Align2::RIGHT_CENTER, name);
    }
}

/// One roll.
struct Row<'a> {
    roll: &'a Roll,
    line: &'a RollLine,
    made: Option<&'a RollDerived>,
    work: Option<&'a RollWork>,
}

impl Row<'_> {
    /// Shows it; true if it was clicked.
    fn show(&self, ui: &mut Ui, selected: bool) -> bool {
        let colors = Colors::of(ui.visuals());
        let sent = self.made.map_or(Sent::No, |made| made.sent(self.work));
        let status = Status::of(self.roll, self.made, sent);
        let (rect, response) = ui.allocate_exact_size(vec2(ui.available_width(), theme::ROW), Sense::click());
        response.widget_info(|| {
            let text = format!("Roll {}: {}", self.roll.name, status.word());
            egui::WidgetInfo::selected(egui::Role::Row, true, selected, text)
        });
        let painter = ui.painter_at(rect);
        if selected || response.hovered() {
            painter.rect_filled(rect, 4.0, if selected { colors.selected } else { colors.hovered });
        }
        let dot = Rect::from_center_size(rect.left_center() + vec2(11.0, 0.0), vec2(9.0, 9.0));
        painter.rect_filled(dot, if status == Status::Sent { 4.5 } else { 2.5 }, status.color(colors));
        let font = FontId::proportional(theme::TEXT);
        let text = |x: f32, align, text: String, font: &FontId, color| {
            painter.text(egui::pos2(x, rect.center().y), align, text, font.clone(), color);
        };
        let short = self.roll.name.rsplit('-').next().unwrap_or(&self.roll.name).to_owned();
        let name_font = if selected { theme::strong_font(theme::TEXT) } else { font.clone() };
        text(rect.left() + NAME, Align2::LEFT_CENTER, short, &name_font, colors.plot.text);
        let word = if sent == Sent::Before { format!("{} *", status.word()) } else { status.word().to_owned() };
        text(rect.left() + STATE, Align2::LEFT_CENTER, word, &font, colors.plot.quiet);
        if rect.width() >= WITH_MATERIAL {
            text(rect.left() + MATERIAL, Align2::LEFT_CENTER, self.line.material.clone(), &font, colors.plot.quiet);
        }
        let figures = [told(self.line.roll_kg), told(self.line.cost()), time(self.line.time_s)];
        for (x, figure) in ends(rect).into_iter().zip(figures) {
            text(x, Align2::RIGHT_CENTER, figure, &font, colors.plot.text);
        }
        response.on_hover_text(self.detail(sent)).clicked()
    }

    fn detail(&self, sent: Sent) -> String {
        let line = self.line;
        let mut text = format!("{} of {}", line.name, line.material);
        if let Some(kg) = line.blank_kg {
            _ = write!(text, "\nblank {kg:.2} kg");
        }
        for (what, cost) in [("blank", line.blank_cost), ("machining", line.machining_cost)] {
            _ = write!(text, "\n{what} costs {} {}", told(cost), line.currency);
        }
        match sent {
            Sent::No => {}
            Sent::Yes => text += "\nWent to the lathe as it is now.",
            Sent::Before => text += "\n* Went to the lathe, and has changed since.",
        }
        text
    }
}

fn told(value: Option<f64>) -> String {
    value.map_or_else(|| "–".to_owned(), |value| format!("{value:.2}"))
}

fn time(seconds: Option<f64>) -> String {
    seconds.filter(|s| *s > 0.0).map_or_else(|| "–".to_owned(), clock)
}

/// The sums below the rolls; a plus sign where not all is known.
fn total(ui: &mut Ui, lines: &[RollLine]) {
    let sum = |of: fn(&RollLine) -> Option<f64>| {
        let known: Vec<f64> = lines.iter().filter_map(of).collect();
        let more = if known.len() < lines.len() { "+" } else { "" };
        (!known.is_empty()).then(|| (known.iter().sum::<f64>(), more))
    };
    let figure = |of| sum(of).map_or_else(|| "–".to_owned(), |(value, more)| format!("{value:.2}{more}"));
    let colors = Colors::of(ui.visuals());
    let (rect, response) = ui.allocate_exact_size(vec2(ui.available_width(), theme::ROW), Sense::hover());
    let texts = [
        figure(|l| l.roll_kg),
        figure(RollLine::cost),
        sum(|l| l.time_s).map_or_else(|| "–".to_owned(), |(s, more)| clock(s) + more),
    ];
    response.widget_info(|| {
        let [kg, cost, time] = &texts;
        egui::WidgetInfo::labeled(egui::Role::Label, true, format!("Whole set: {kg} kg, cost {cost}, time {time}"))
    });
    let font = theme::strong_font(theme::TEXT);
    ui.painter().hline(rect.x_range(), rect.top(), egui::Stroke::new(1.0, colors.plot.grid));
    let at = rect.left_center() + vec2(NAME, 0.0);
    ui.painter().text(at, Align2::LEFT_CENTER, "whole set", font.clone(), colors.plot.text);
    for (x, text) in ends(rect).into_iter().zip(texts) {
        ui.painter().text(egui::pos2(x, rect.center().y), Align2::RIGHT_CENTER, text, font.clone(), colors.plot.text);
    }
}

/// What an hour and a kilogram cost; empty fields take what machine and material say.
fn costs(ui: &mut Ui, set: &RollSet, session: &mut Session, catalog: &Catalog) {
    ui.add_space(6.0);
    let form = Form::two_even_columns(ui);
    let rates = &set.rates;
    Form::row(ui, |ui| {
        form.maybe_figure(ui, session, Field::of("Per hour"), rates.machine_per_hour, |s, v| {
            s.rates.machine_per_hour = v;
        });
        form.maybe_figure(ui, session, Field::of("Per kg"), rates.price_per_kg, |s, v| s.rates.price_per_kg = v);
    });
    Form::row(ui, |ui| {
        form.text(ui, session, Field::of("Currency"), rates.currency.as_deref().unwrap_or_default(), |s, text| {
            s.rates.currency = Some(text).filter(|text| !text.is_empty());
        });
        let present = set.material.to_lowercase();
        let names = words::material_names(catalog, session.document().unit, Some(present.clone()));
        let all: Vec<(String, String)> = names.into_iter().map(|name| (name.clone(), name)).collect();
        form.choice(ui, session, Field::of("Material"), &present, &all, |s, name| s.material = name);
    });
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cancel::Cancel;
    use crate::document::{Content, Kind};
    use crate::regen::{Cache, regenerate};
    use crate::storage::{document_from_text, examples_of};

    #[test]
    fn a_roll_is_designed_edited_planned_proved_and_sent() {
        let example = examples_of(Kind::RollSet).find(|e| e.name == "1470b").unwrap();
        let mut document = document_from_text(example.name, example.text).unwrap();
        let Content::RollSet(set) = &mut document.content else { unreachable!("a set") };
        // The second station, whose rolls are edited.
        set.stations.drain(2..);
        set.stations[0].without_rolls = true;
        let document = Arc::new(document);
        let derived = regenerate(&document, &Catalog::shipped(), &mut Cache::default(), &Cancel::default())
            .unwrap()
            .rolls
            .unwrap();
        let roll = derived.design.rolls().next().unwrap();
        let made = derived.of_roll(roll.roll).unwrap();
        let plain = Roll { elements: roll.designed.clone(), ..roll.clone() };
        assert_eq!(Status::of(&plain, None, Sent::No), Status::Designed);
        assert_eq!(Status::of(roll, None, Sent::No), Status::Edited);
        let before = RollDerived { current: false, ..made.clone() };
        assert_eq!(Status::of(roll, Some(&before), Sent::Yes), Status::Edited, "what was made before is of no use");
        let unsound = RollDerived { sound: false, ..made.clone() };
        assert_eq!(Status::of(roll, Some(&unsound), Sent::No), Status::Planned);
        assert_eq!(Status::of(roll, Some(made), Sent::No), Status::Proved);
        assert_eq!(Status::of(roll, Some(made), Sent::Before), Status::Proved);
        assert_eq!(Status::of(roll, Some(made), Sent::Yes), Status::Sent);
        let words = [Status::Designed, Status::Edited, Status::Planned, Status::Proved, Status::Sent].map(Status::word);
        assert_eq!(words, ["designed", "edited", "planned", "proved", "sent"]);
    }
}
