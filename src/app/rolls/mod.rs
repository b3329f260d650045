//! Panels of a set of form-rolls.

mod angles;
mod charts;
mod composites;
mod editor;
mod elements;
mod fields;
mod flower;
mod list;
mod section;
mod solid;
mod station;
mod station_data;
mod strip_data;
mod suggest;
mod words;

use super::desk::Requests;
use super::layout::Pane;
use super::plots::StationView;
use crate::document::{Content, Document, RollKind, RollRef, RollSet, Station};
use crate::session::Session;
use egui::Ui;

/// Strength of a plot of an older document.
const STALE: f32 = 0.5;

/// What the panels keep.
#[derive(Debug, Default)]
pub(crate) struct RollsViews {
    elements: elements::ElementsView,
    angles: angles::AnglesView,
    station: StationView,
    suggest: suggest::SuggestView,
    flower: flower::FlowerView,
    charts: charts::ChartsView,
    editor: editor::EditorView,
    list: list::ListView,
    section: section::SectionView,
    solid: solid::RoundView,
}

impl RollsViews {
    /// Puts the cursor on an element of the section.
    pub(crate) fn go_to_element(&mut self, session: &mut Session, id: u32) {
        session.selection.element = Some(id);
        if let Some(set) = session.document().content.roll_set() {
            self.elements.go_to(set, id);
        }
    }
}

/// The set of form-rolls in a document, to be changed.
fn set_mut(document: &mut Document) -> Option<&mut RollSet> {
    if let Content::RollSet(set) = &mut document.content { Some(set) } else { None }
}

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
        Pane::CrossSection => section::show(ui, titled, session, views, requests),
        Pane::Charts => charts::show(ui, titled, session, views, requests),
        Pane::Station => station::show(ui, titled, session, views, requests),
        Pane::Solid => solid::show(ui, titled, session, views),
        Pane::StationData => station_data::show(ui, titled, session, views, requests),
        Pane::RollEditor => editor::show(ui, titled, session, views, requests),
        Pane::RollList => list::show(ui, titled, session, views, requests),
        _ => false,
    }
}

/// The station that is shown and its number; the first one if none was chosen yet.
fn shown_station<'a>(session: &Session, set: &'a RollSet) -> Option<(usize, &'a Station)> {
    let chosen = session.selection.station.and_then(|id| set.station(id));
    chosen.or_else(|| set.stations.first().map(|station| (1, station)))
}

/// Shows a station, and the roll of the same place as before.
pub(crate) fn select_station(session: &mut Session, id: u32) {
    session.selection.station = Some(id);
    let kind = session.roll().map_or(RollKind::Top, |roll| roll.kind);
    session.select_roll(RollRef { station: id, kind });
}
