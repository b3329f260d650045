//! The bend angles of every element at every station, as a matrix.

use super::{RollsViews, words};
use crate::app::desk::Requests;
use crate::app::sheet::{self, Cell, Change, Heading, Sheet, SheetView, Takes};
use crate::app::widgets::{link, title_row};
use crate::diagnostic::{Place, Severity};
use crate::document::{BendAngle, Document, Element, ElementKind, RollSet, Station};
use crate::rollform::bends::{Stage, angles_deg};
use crate::session::Session;
use egui::Ui;
use std::collections::BTreeMap;

/// Table of the angles.
#[derive(Debug, Default)]
pub(super) struct AnglesView {
    sheet: SheetView,
}

/// Shows the panel; true if it is dragged by its title.
pub(super) fn show(
    ui: &mut Ui,
    titled: bool,
    session: &mut Session,
    views: &mut RollsViews,
    requests: &mut Requests,
) -> bool {
    let document = std::sync::Arc::clone(session.document());
    let Some(set) = document.content.roll_set() else { return false };
    let mut add = false;
    let dragged = title_row(ui, titled.then_some("Bend angles"), "cumulative, °", |ui| {
        add = link(ui, "+ Station").on_hover_text("Add a station with all bends at their finished angles").clicked();
        super::suggest::show(ui, &mut views.suggest, session);
    });
    if add {
        session.edit("add a station", None, add_station);
    }
    let angles = Angles::new(set, session);
    let height = ui.available_height();
    sheet::show(ui, &angles, &mut views.angles.sheet, session, requests, height);
    dragged
}

/// The first message about every angle: at a station, with the bend beside it.
fn wrong(session: &Session) -> BTreeMap<(u32, u32), String> {
    let mut found = BTreeMap::new();
    for problem in session.problems().iter().filter(|p| p.severity >= Severity::Warning) {
        if let (Place::Station { id, .. }, [Place::Element { id: bend, .. }]) =
            (&problem.at, problem.related.as_slice())
        {
            found.entry((*id, *bend)).or_insert_with(|| problem.message.clone());
        }
    }
    found
}

/// Bends by station.
struct Angles<'a> {
    set: &'a RollSet,
    bends: Vec<Element>,
    /// Angles at every station, carried over.
    at_stations: Vec<BTreeMap<u32, f64>>,
    headings: Vec<Heading>,
    /// What is wrong with angles, by station and bend.
    wrong: BTreeMap<(u32, u32), String>,
}

impl<'a> Angles<'a> {
    fn new(set: &'a RollSet, session: &Session) -> Self {
        let station = session.selection.station;
        let bends = set.section.all().filter(|e| matches!(e.kind, ElementKind::Bend { .. })).copied().collect();
        let of_station = |(number, s): (usize, &Station)| Heading {
            current: station == Some(s.id),
            ..Heading::figures(format!("stn {number}"), 52.0)
        };
        let stations = (1..).zip(&set.stations).map(of_station);
        Self {
            set,
            bends,
            at_stations: (0..set.stations.len()).map(|index| angles_deg(set, Stage::Station(index))).collect(),
            wrong: wrong(session),
            headings: stations.chain(std::iter::once(Heading::figures("final", 52.0))).collect(),
        }
    }

    /// True if the angle was entered at this station, not carried over.
    fn is_entered(&self, station: usize, element: u32) -> bool {
        self.set.stations.get(station).is_some_and(|s| s.bends.iter().any(|bend| bend.element == element))
    }
}

impl Sheet for Angles<'_> {
    fn name(&self) -> &'static str {
        "Bend"
    }

    fn headings(&self) -> &[Heading] {
        &self.headings
    }

    fn rows(&self) -> usize {
        self.bends.len()
    }

    fn number(&self, row: usize) -> String {
        let section = &self.set.section;
        let Some(bend) = self.bends.get(row) else { return String::new() };
        let in_list = |list: &[Element]| list.iter().position(|e| e.id == bend.id).map(|index| index + 1);
        let other = || in_list(&section.other_side).map(|n| format!("{n}'"));
        in_list(&section.elements).map(|n| n.to_string()).or_else(other).unwrap_or_default()
    }

    fn cell(&self, row: usize, column: usize) -> Cell {
        let Some(bend) = self.bends.get(row) else { return Cell::default() };
        if let Some(angles) = self.at_stations.get(column) {
            Cell {
                text: words::angle(angles.get(&bend.id).copied().unwrap_or_default()),
                takes: Takes::Text,
                strong: self.is_entered(column, bend.id),
                wrong: self.set.stations.get(column).and_then(|s| self.wrong.get(&(s.id, bend.id)).cloned()),
            }
        } else {
            let ElementKind::Bend { angle_deg, .. } = bend.kind else { return Cell::default() };
            Cell { text: words::angle(angle_deg), takes: Takes::Text, ..Cell::default() }
        }
    }

    fn write(&self, document: &mut Document, row: usize, column: usize, text: &str) -> Result<(), String> {
        let (Some(bend), Some(set)) = (self.bends.get(row), super::set_mut(document)) else { return Ok(()) };
        let carried = text.trim().is_empty() || text.trim() == "–";
        if let Some(station) = set.stations.get_mut(column) {
            let angle = if carried { None } else { Some(words::parse_angle(text)?) };
            set_angle(station, bend.id, angle);
            return Ok(());
        }
        let angle = words::parse_angle(text)?;
        let element = set.section.elements.iter_mut().chain(&mut set.section.other_side).find(|e| e.id == bend.id);
        if let Some(ElementKind::Bend { angle_deg, .. }) = element.map(|e| &mut e.kind) {
            *angle_deg = angle;
        }
        Ok(())
    }

    /// Rows are bends of the section; they come and go in its table.
    fn change(&self, _document: &mut Document, _change: &Change) -> bool {
        false
    }

    fn selected(&self, session: &Session) -> Option<usize> {
        let id = session.selection.element?;
        self.bends.iter().position(|bend| bend.id == id)
    }

    fn select(&self, session: &mut Session, row: usize, column: usize) {
        session.selection.element = self.bends.get(row).map(|bend| bend.id);
        if let Some(station) = self.set.stations.get(column) {
            super::select_station(session, station.id);
        }
    }
}

/// Enters the angle of a bend at a station; without one it is carried over from the station before.
pub(super) fn set_angle(station: &mut Station, element: u32, angle_deg: Option<f64>) {
    station.bends.retain(|bend| bend.element != element || angle_deg.is_some());
    let Some(angle_deg) = angle_deg else { return };
    match station.bends.iter_mut().find(|bend| bend.element == element) {
        Some(bend) => bend.angle_deg = angle_deg,
        None => station.bends.push(BendAngle { element, angle_deg }),
    }
}

/// Adds a station like the last one, with every bend at its finished angle.
fn add_station(document: &mut Document) {
    let Some(set) = super::set_mut(document) else { return };
    let id = set.stations.iter().map(|s| s.id).max().map_or(1, |id| id.saturating_add(1));
    let finished = set.section.all().filter_map(|element| match element.kind {
        ElementKind::Bend { angle_deg, .. } => Some(BendAngle { element: element.id, angle_deg }),
        ElementKind::Line { .. } => None,
    });
    let bends = finished.collect();
    let station = match set.stations.last() {
        Some(last) => Station { id, bends, ..last.clone() },
        None => Station { bends, ..Station::new(id, &set.line) },
    };
    set.stations.push(station);
}
