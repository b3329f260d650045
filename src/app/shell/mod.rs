//! Panels of a flow-turned shell.

mod chart;
mod data;
mod form;
mod live;
mod operator;
mod port;
mod ran;
mod rig;
mod rows;
mod runs;
mod view;
mod wall;

use super::desk::Requests;
use super::layout::Pane;
use super::plots::ShellPlot;
use crate::document::{Content, Shell};
use crate::session::{GestureId, Session};
use egui::Ui;
use live::Live;

/// What the panels keep.
#[derive(Debug, Default)]
pub(crate) struct ShellViews {
    plot: ShellPlot,
    drag: Option<GestureId>,
    live: Live,
    charts: rig::Charts,
    comparison: runs::Comparison,
}

/// Shows a panel of a shell; true if it is dragged by its title.
pub(crate) fn show(
    ui: &mut Ui,
    pane: Pane,
    titled: bool,
    session: &mut Session,
    views: &mut ShellViews,
    requests: &mut Requests,
) -> bool {
    views.live.tick(ui, session);
    match pane {
        Pane::ShellData => data::show(ui, titled, session, requests),
        Pane::ShellView => view::show(ui, titled, session, views, requests),
        Pane::Wall => wall::show(ui, titled, session),
        Pane::Operator => operator::show(ui, titled, session, views),
        Pane::Rig => rig::show(ui, titled, session, views),
        Pane::Runs => runs::show(ui, titled, views),
        _ => false,
    }
}

/// The shell in the document.
fn shell(session: &Session) -> Option<&Shell> {
    match &session.document().content {
        Content::Shell(shell) => Some(shell),
        Content::TurnedPart(_) | Content::RollSet(_) => None,
    }
}

/// Changes the shell.
fn edit(session: &mut Session, label: &str, gesture: Option<GestureId>, change: impl FnOnce(&mut Shell)) {
    session.edit(label, gesture, |document| {
        if let Content::Shell(shell) = &mut document.content {
            change(shell);
        }
    });
}
