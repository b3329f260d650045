//! Station.

use super::RollsViews;
use crate::app::desk::Requests;
use crate::app::widgets::title_row;
use crate::session::Session;
use egui::Ui;

/// Shows the panel; true if it is dragged by its title.
pub(super) fn show(
    ui: &mut Ui,
    titled: bool,
    _session: &mut Session,
    _views: &mut RollsViews,
    _requests: &mut Requests,
) -> bool {
    title_row(ui, titled.then_some("Station"), "", |_| {})
}
