//! What every bend does when it leaves the station that is shown, and how far it would have to be overbent.

use super::line;
use crate::app::rolls::flower::name_of;
use crate::app::rolls::shown_station;
use crate::app::theme::{self, Colors};
use crate::document::RollSet;
use crate::rollform::bends::Stage;
use crate::rollform::flower::Flower;
use crate::session::Session;
use egui::Ui;

/// Widths of the columns, points.
const WIDTHS: [f32; 5] = [130.0, 90.0, 110.0, 90.0, 110.0];

/// Shows the table.
pub(super) fn show(ui: &mut Ui, flower: &Flower, set: &RollSet, session: &mut Session) {
    let stage = shown_station(session, set).map_or(Stage::Finished, |(number, _)| Stage::Station(number - 1));
    let colors = Colors::of(ui.visuals());
    let found = flower.at(stage).map(|shape| shape.springback.as_slice()).unwrap_or_default();
    if found.is_empty() {
        ui.label(theme::quiet("No bend is bent at this station.", colors));
        return;
    }
    let head = ["bend", "in the rolls", "after release", "opens by", "overbend to"].map(str::to_owned);
    line(ui, &head, &WIDTHS, false, true);
    egui::ScrollArea::vertical().id_salt("springback").auto_shrink([false, false]).show(ui, |ui| {
        for bend in found {
            let degrees = |rad: f64| format!("{:.2}°", rad.to_degrees());
            let cells = [
                name_of(set, bend.element),
                degrees(bend.angle_rad),
                degrees(bend.released_rad),
                degrees((bend.angle_rad - bend.released_rad).abs()),
                bend.overbent_rad.map_or_else(|| "–".to_owned(), degrees),
            ];
            let selected = session.selection.element == Some(bend.element);
            if line(ui, &cells, &WIDTHS, selected, false).clicked() {
                session.selection.element = Some(bend.element);
            }
        }
    });
}
