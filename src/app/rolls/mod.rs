//! Panels of a set of form-rolls.

mod angles;
mod charts;
mod editor;
mod elements;
mod flower;
mod list;
mod station;
mod station_data;

use super::desk::Requests;
use super::layout::Pane;
use crate::session::Session;
use egui::Ui;

/// What the panels keep.
#[derive(Debug, Default)]
pub(crate) struct RollsViews {}

/// Shows a panel of a set of form-rolls; true if it is dragged by its title.
pub(crate) fn show(
    ui: &mut Ui,
    pane: Pane,
    titled: bool,
    session: &mut Session,
    views: &mut RollsViews,
    requests: &mut Requests,
) -> bool {
    match pane {
        Pane::Elements => elements::show(ui, titled, session, views, requests),
        Pane::Angles => angles::show(ui, titled, session, views, requests),
        Pane::Flower => flower::show(ui, titled, session, views, requests),
        Pane::Charts => charts::show(ui, titled, session, views, requests),
        Pane::Station => station::show(ui, titled, session, views, requests),
        Pane::StationData => station_data::show(ui, titled, session, views, requests),
        Pane::RollEditor => editor::show(ui, titled, session, views, requests),
        Pane::RollList => list::show(ui, titled, session, views, requests),
        _ => false,
    }
}
