//! Panels of a flow-turned shell.

mod data;
mod operator;
mod rig;
mod runs;
mod view;
mod wall;

use super::desk::Requests;
use super::layout::Pane;
use crate::session::Session;
use egui::Ui;

/// What the panels keep.
#[derive(Debug, Default)]
pub(crate) struct ShellViews {}

/// Shows a panel of a shell; true if it is dragged by its title.
pub(crate) fn show(
    ui: &mut Ui,
    pane: Pane,
    titled: bool,
    session: &mut Session,
    views: &mut ShellViews,
    requests: &mut Requests,
) -> bool {
    match pane {
        Pane::ShellData => data::show(ui, titled, session, views, requests),
        Pane::ShellView => view::show(ui, titled, session, views, requests),
        Pane::Wall => wall::show(ui, titled, session, views, requests),
        Pane::Operator => operator::show(ui, titled, session, views, requests),
        Pane::Rig => rig::show(ui, titled, session, views, requests),
        Pane::Runs => runs::show(ui, titled, session, views, requests),
        _ => false,
    }
}
