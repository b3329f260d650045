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
pub(crate) use operator::stop_button;

/// What the panels keep.
#[derive(Debug, Default)]
pub(crate) struct ShellViews {
    plot: ShellPlot,
    drag: Option<GestureId>,
    live: Live,
    charts: rig::Charts,
    comparison: runs::Comparison,
}

impl ShellViews {
    /// Lets the rig's time pass and reads the operator's keys, whichever panels are shown. `shown` is the session of a shell
    /// that has the keyboard; the key of the emergency stop works without, too.
    pub(crate) fn tick(&mut self, ui: &Ui, shown: Option<&Session>) {
        let is_shell = |session: &&Session| shell(session).is_some();
        self.live.tick(ui, shown.filter(is_shell));
    }

    /// True while the rig runs, or the line to one is open.
    pub(crate) const fn is_live(&self) -> bool {
        self.live.is_live()
    }

    /// Draws the roller back and switches everything off.
    pub(crate) fn emergency_stop(&mut self) {
        self.live.emergency_stop();
    }

    /// What stays when another document is opened: the rig while it runs, for it must still be stopped.
    pub(crate) fn for_another_document(self) -> Self {
        if self.is_live() { Self { live: self.live, ..Self::default() } } else { Self::default() }
    }
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
    match pane {
        Pane::ShellData => data::show(ui, titled, session, requests),
        Pane::ShellView => view::show(ui, titled, session, views, requests),
        Pane::Wall => wall::show(ui, titled, session),
        Pane::Operator => operator::show(ui, titled, session, views),
        Pane::Rig => rig::show(ui, titled, views),
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
