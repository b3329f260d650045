//! Mean and peak strain of the edges at every station, on a scale of powers of ten: they differ manifold.

use crate::app::rolls::flower::name_of;
use crate::app::rolls::select_station;
use crate::app::theme::{self, Colors};
use crate::document::RollSet;
use crate::rollform::bends::Stage;
use crate::rollform::flower::{Flower, Shape};
use crate::rollform::strain::{StationStrain, limit};
use crate::session::Session;
use egui::{
    Align2, Color32, FontId, Painter, Pos2, Rect, Role, Sense, Shape as Drawn, Stroke, Ui, WidgetInfo, pos2, vec2,
};
use std::fmt::Write;

/// Room left of the chart for the scale, points.
const SCALE: f32 = 52.0;
/// Room below for the names of the stations, points.
const NAMES: f32 = 20.0;
/// Room above for the values on the bars, points.
const ABOVE: f32 = 16.0;
/// Half the gap between the two bars of a station, points.
const GAP: f32 = 9.0;
/// Widest bar, points.
const WIDEST: f32 = 34.0;

/// Shows the chart.
pub(super) fn show(ui: &mut Ui, flower: &Flower, set: &RollSet, session: &mut Session) {
    let limit = limit(&set.strip);
    let strains: Vec<(&Shape, &StationStrain)> =
        flower.stations().filter_map(|shape| Some((shape, shape.strain.as_ref()?))).collect();
    let colors = Colors::of(ui.visuals());
    if strains.is_empty() {
        ui.label(theme::quiet("There is no station yet.", colors));
        return;
    }
    let (rect, _) = ui.allocate_exact_size(ui.available_size().max(vec2(120.0, 70.0)), Sense::hover());
    let scale = Scale::of(&strains, limit, rect);
    let step = scale.area.width() / strains.len() as f32;
    let column = |place: usize| {
        let left = scale.area.left() + step * place as f32;
        Rect::from_min_max(pos2(left, rect.top()), pos2(left + step, rect.bottom()))
    };
    let shown = strains.iter().position(|(shape, _)| {
        let Stage::Station(index) = shape.stage else { return false };
        session.selection.station.is_some() && set.stations.get(index).map(|s| s.id) == session.selection.station
    });
    if let Some(place) = shown {
        ui.painter().rect_filled(column(place).shrink2(vec2(2.0, 0.0)), 5.0, colors.selected);
    }
    scale.draw(ui.painter(), colors, limit);
    for (place, (shape, strain)) in strains.iter().enumerate() {
        let Stage::Station(index) = shape.stage else { continue };
        station(ui, &scale, column(place), index, strain, limit, set, session);
    }
}

/// Powers of ten up the chart.
struct Scale {
    area: Rect,
    /// Exponents at the bottom and at the top.
    low: f64,
    high: f64,
}

impl Scale {
    fn of(strains: &[(&Shape, &StationStrain)], limit: f64, rect: Rect) -> Self {
        let values = || {
            let all = strains.iter().flat_map(|(_, s)| [s.mean, s.peak]).chain([limit]);
            all.filter(|value| *value > 0.0).map(f64::log10)
        };
        let low = values().fold(-3.0, f64::min).floor();
        let high = values().fold(-2.5, f64::max).ceil();
        let area = Rect::from_min_max(rect.min + vec2(SCALE, ABOVE), rect.max - vec2(4.0, NAMES));
        Self { area, low, high }
    }

    #[allow(clippy::cast_possible_truncation, reason = "screen positions are f32 in egui")]
    fn y(&self, strain: f64) -> f32 {
        let part = ((strain.max(1e-30).log10() - self.low) / (self.high - self.low)).clamp(0.0, 1.0);
        self.area.bottom() - self.area.height() * part as f32
    }

    fn draw(&self, painter: &Painter, colors: &Colors, limit: f64) {
        let font = FontId::proportional(theme::SMALL);
        let mut exponent = self.low;
        while exponent <= self.high {
            let value = 10.0_f64.powf(exponent);
            let y = self.y(value);
            painter.hline(self.area.x_range(), y, Stroke::new(1.0, colors.plot.grid));
            let at = pos2(self.area.left() - 8.0, y);
            painter.text(at, Align2::RIGHT_CENTER, percent_of(exponent), font.clone(), colors.plot.quiet);
            exponent += 1.0;
        }
        let ends = [pos2(self.area.left(), self.y(limit)), pos2(self.area.right(), self.y(limit))];
        painter.extend(Drawn::dashed_line(&ends, Stroke::new(1.2, colors.plot.wrong), 5.0, 3.0));
    }
}

/// A power of ten in percent, without needless zeros.
fn percent_of(exponent: f64) -> String {
    format!("{} %", crate::app::rolls::words::plain(10.0_f64.powf(exponent + 2.0), 6))
}

/// A strain in percent with two figures that matter.
fn percent(strain: f64) -> String {
    let value = strain * 100.0;
    match value {
        v if v >= 10.0 => format!("{v:.0} %"),
        v if v >= 1.0 => format!("{v:.1} %"),
        v if v >= 0.1 => format!("{v:.2} %"),
        v if v >= 0.0005 => format!("{v:.3} %"),
        v if v > 0.0 => "< 0.001 %".to_owned(),
        _ => "0".to_owned(),
    }
}

#[allow(clippy::too_many_arguments, reason = "a bar is its place, its value and what a click does")]
fn station(
    ui: &mut Ui,
    scale: &Scale,
    column: Rect,
    index: usize,
    strain: &StationStrain,
    limit: f64,
    set: &RollSet,
    session: &mut Session,
) {
    let colors = Colors::of(ui.visuals());
    let id = set.stations.get(index).map(|s| s.id);
    let response = ui.interact(column, ui.scope_id().with(("strain", index)), Sense::click());
    let said = format!("Station {}: mean {}, peak {}", index + 1, percent(strain.mean), percent(strain.peak));
    response.widget_info(|| WidgetInfo::labeled(Role::Button, true, said.clone()));
    let painter = ui.painter_at(column);
    let ground = if id.is_some() && session.selection.station == id { colors.selected } else { colors.panel };
    let width = (column.width() * 0.3).min(WIDEST);
    let middle = column.center().x;
    for (value, from, color) in [
        (strain.peak, middle - width - GAP, colors.plot.accent.gamma_multiply(0.4)),
        (strain.mean, middle + GAP, colors.plot.accent),
    ] {
        let top = scale.y(value);
        if value > 0.0 {
            let bar = Rect::from_min_max(pos2(from, top), pos2(from + width, scale.area.bottom()));
            painter.rect_filled(bar, 0.0, color);
        }
        let ink = if value > limit { colors.plot.wrong } else { colors.plot.quiet };
        let room = column.width() / 2.0;
        value_on(&painter, pos2(from + width / 2.0, top - 2.0), &percent(value), room, (ink, ground));
    }
    let name = format!("station {}", index + 1);
    let at = pos2(middle, column.bottom() - NAMES / 2.0);
    painter.text(at, Align2::CENTER_CENTER, name, FontId::proportional(theme::SMALL), colors.plot.quiet);
    if let Some(id) = id.filter(|_| response.clicked()) {
        select_station(session, id);
    }
    response.on_hover_text(detail(strain, limit, set));
}

/// A value above its bar, readable over the lines of the scale; where there is no room for its unit, the scale tells it.
fn value_on(painter: &Painter, at: Pos2, text: &str, room: f32, (ink, ground): (Color32, Color32)) {
    let laid = |text: &str| painter.layout_no_wrap(text.to_owned(), FontId::proportional(theme::SMALL), ink);
    let mut galley = laid(text);
    if galley.size().x > room {
        galley = laid(text.trim_end_matches(" %"));
    }
    let rect = Align2::CENTER_BOTTOM.anchor_size(at, galley.size());
    painter.rect_filled(rect.expand2(vec2(2.0, -1.0)), 2.0, ground);
    painter.galley(rect.min, galley, ink);
}

/// What is behind the two bars of a station.
fn detail(strain: &StationStrain, limit: f64, set: &RollSet) -> String {
    let [left, right] = strain.edge_way;
    let mut text = format!(
        "Way of the left edge {left:.2} mm, of the right edge {right:.2} mm\nMean {} (straight from station to station)\nPeak {} (along the deformation length)\nYield strain {}",
        percent(strain.mean),
        percent(strain.peak),
        percent(limit)
    );
    for bend in &strain.bends {
        let (leg, step, length) = (bend.leg, bend.step_rad.to_degrees(), bend.deformation_length);
        let (side, name, peak) = (bend.side.name(), name_of(set, bend.element), percent(bend.peak));
        _ = write!(
            text,
            "\n{side}, {name}: leg {leg:.2} mm, {step:.1}°, deformation length {length:.0} mm, peak {peak}"
        );
    }
    text
}
