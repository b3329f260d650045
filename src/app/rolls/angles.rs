//! The bend angles of every element at every station, as a matrix.

use super::composites::Composites;
use super::{RollsViews, words};
use crate::app::desk::Requests;
use crate::app::sheet::{self, Cell, Change, Heading, Sheet, SheetView, Takes};
use crate::app::widgets::{link, title_row, toggle};
use crate::diagnostic::{Place, Severity};
use crate::document::{BendAngle, Document, Element, ElementKind, RollSet, Sharpening, Station};
use crate::rollform::bends::{Stage, angles_deg};
use crate::session::Session;
use egui::Ui;
use std::collections::BTreeMap;

/// Table of the angles.
#[derive(Debug, Default)]
pub(super) struct AnglesView {
    sheet: SheetView,
    composites: SheetView,
    /// Show the composite bends in place of the angles.
    parts: bool,
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
    let view = &mut views.angles;
    let remark = if view.parts { "formed in parts" } else { "cumulative, °" };
    let dragged = title_row(ui, titled.then_some("Bend angles"), remark, |ui| {
        if view.parts {
            add = link(ui, "+ Bend")
                .on_hover_text("Form a bend from a straight piece, an arc and a straight piece")
                .clicked();
        } else {
            add =
                link(ui, "+ Station").on_hover_text("Add a station with all bends at their finished angles").clicked();
            super::suggest::show(ui, &mut views.suggest, session);
        }
        toggle(ui, &mut view.parts, "parts").on_hover_text("Bends that are formed as line, arc and line by percentage");
    });
    if view.parts {
        composites(ui, view, set, add, session, requests);
        return dragged;
    }
    if add {
        session.edit("add a station", None, add_station);
    }
    let angles = Angles::new(set, session);
    let height = ui.available_height();
    sheet::show(ui, &angles, &mut views.angles.sheet, session, requests, height);
    dragged
}

/// The table of composite bends.
fn composites(
    ui: &mut Ui,
    view: &mut AnglesView,
    set: &RollSet,
    add: bool,
    session: &mut Session,
    requests: &mut Requests,
) {
    let table = Composites::new(set, session);
    if add {
        let end = table.rows();
        session.edit("add a composite bend", None, |document| _ = table.change(document, &Change::Insert(end)));
        view.composites.go_to(end, 1);
    }
    if set.composites.is_empty() {
        return crate::app::widgets::remark(ui, &super::composites::nothing_yet(set));
    }
    let height = ui.available_height();
    sheet::show(ui, &table, &mut view.composites, session, requests, height);
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

/// Width of a column, points: six stations and the finished section fit beside one another.
const COLUMN: f32 = 46.0;

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
            ..Heading::figures(format!("stn {number}"), COLUMN)
        };
        let stations = (1..).zip(&set.stations).map(of_station);
        Self {
            set,
            bends,
            at_stations: (0..set.stations.len()).map(|index| angles_deg(set, Stage::Station(index))).collect(),
            wrong: wrong(session),
            headings: stations.chain(std::iter::once(Heading::figures("final", COLUMN))).collect(),
        }
    }

    /// Whether radii are sharpened at a station.
    fn sharpened(&self, column: usize) -> Cell {
        let Some(station) = self.set.stations.get(column) else { return Cell::default() };
        let sharp = is_sharp(self.set, column, station.id);
        let text = SHARP[usize::from(sharp)].to_owned();
        Cell { text, takes: Takes::Words(&SHARP), strong: sharp, wrong: None }
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

    /// The bends, and below them whether their radii are sharpened.
    fn rows(&self) -> usize {
        self.bends.len() + 1
    }

    fn number(&self, row: usize) -> String {
        self.bends.get(row).map_or_else(|| "r".to_owned(), |bend| words::number(self.set, bend.id))
    }

    fn key(&self, row: usize) -> u32 {
        self.bends.get(row).map_or(u32::MAX, |bend| bend.id)
    }

    fn cell(&self, row: usize, column: usize) -> Cell {
        let Some(bend) = self.bends.get(row) else { return self.sharpened(column) };
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
        let Some(set) = super::set_mut(document) else { return Ok(()) };
        let Some(bend) = self.bends.get(row) else { return sharpen(set, column, text) };
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

/// Radii open with the angle, or have their finished size at once.
const SHARP: [&str; 2] = ["open", "sharp"];

fn is_sharp(set: &RollSet, index: usize, id: u32) -> bool {
    match &set.sharpening {
        Sharpening::None => false,
        Sharpening::AllButLast => index + 1 < set.stations.len(),
        Sharpening::Stations(ids) => ids.contains(&id),
    }
}

/// Sharpens the radii at a station, or no longer; what holds at the others stays.
fn sharpen(set: &mut RollSet, column: usize, text: &str) -> Result<(), String> {
    let sharp = match text.trim().to_lowercase().as_str() {
        "sharp" => true,
        "open" | "" | "–" => false,
        other => return Err(format!("“{other}” says nothing of radii. Type sharp or open.")),
    };
    let Some(id) = set.stations.get(column).map(|station| station.id) else { return Ok(()) };
    if is_sharp(set, column, id) == sharp {
        return Ok(());
    }
    let others = set
        .stations
        .iter()
        .enumerate()
        .filter(|(index, s)| if *index == column { sharp } else { is_sharp(set, *index, s.id) });
    let ids: Vec<u32> = others.map(|(_, s)| s.id).collect();
    set.sharpening = if ids.is_empty() { Sharpening::None } else { Sharpening::Stations(ids) };
    Ok(())
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rollform::fixtures::vee;

    #[test]
    fn radii_are_sharpened_station_by_station() {
        let mut set = vee(&[30.0, 60.0, 90.0]);
        sharpen(&mut set, 1, "sharp").unwrap();
        assert_eq!(set.sharpening, Sharpening::Stations(vec![2]));
        set.sharpening = Sharpening::AllButLast;
        sharpen(&mut set, 0, "open").unwrap();
        assert_eq!(set.sharpening, Sharpening::Stations(vec![2]));
        sharpen(&mut set, 1, "open").unwrap();
        assert_eq!(set.sharpening, Sharpening::None);
        assert!(sharpen(&mut set, 1, "blunt").is_err());
    }
}
