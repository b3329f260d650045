//! Rolls and strip of the station that is shown, the strip through the line, or the roll that is shown, in the round.

use super::RollsViews;
use crate::app::plots::{
    LineSolidView, LineSubject, Palette, SolidScene, SolidView, line_shortening, line_solid, solid_view,
};
use crate::app::theme::{self, Colors};
use crate::app::widgets::{title_row, toggle};
use crate::document::{Document, RollRef};
use crate::rollform::loft::{LoftSection, loft};
use crate::rollform::part::bore_diameter;
use crate::session::Session;
use egui::Ui;
use std::sync::Arc;

/// What is shown.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
enum Shown {
    #[default]
    Station,
    Line,
    Roll,
}

const ALL: [(Shown, &str); 3] = [(Shown::Roll, "roll"), (Shown::Line, "line"), (Shown::Station, "station")];

/// What was to be seen in the last frame.
#[derive(Debug)]
struct Subject {
    shown: Shown,
    document: Arc<Document>,
    station: usize,
    roll: Option<RollRef>,
    designed: bool,
}

impl PartialEq for Subject {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.document, &other.document)
            && (self.shown, self.station, self.roll, self.designed)
                == (other.shown, other.station, other.roll, other.designed)
    }
}

/// What the panel keeps.
#[derive(Debug, Default)]
pub(super) struct RoundView {
    shown: Shown,
    plot: LineSolidView,
    roll: SolidView,
    /// The strip through the line of this document.
    made: Option<(Arc<Document>, Vec<LoftSection>)>,
    /// Counts the subjects.
    version: u64,
    last: Option<Subject>,
}

/// Shows the panel; true if it is dragged by its title.
pub(super) fn show(ui: &mut Ui, titled: bool, session: &Session, views: &mut RollsViews) -> bool {
    let view = &mut views.solid;
    let shortening = view.made.as_ref().filter(|_| view.shown == Shown::Line).map(|(_, all)| line_shortening(all));
    let remark = shortening.filter(|by| *by < 1.0).map(|by| format!("its length drawn 1 : {:.1}", 1.0 / by));
    let dragged = title_row(ui, titled.then_some("3D"), &remark.unwrap_or_default(), |ui| {
        for (which, name) in ALL {
            let mut on = view.shown == which;
            if toggle(ui, &mut on, name).clicked() {
                view.shown = which;
            }
        }
    });
    let palette = Palette::of(ui.visuals());
    let drawn = match view.shown {
        Shown::Station => station(ui, view, session, &palette),
        Shown::Line => line(ui, view, session, &palette),
        Shown::Roll => roll(ui, view, session, &palette),
    };
    if drawn.is_none() {
        let colors = Colors::of(ui.visuals());
        ui.label(theme::quiet("There is nothing to show here yet; see the problems.", colors));
    }
    dragged
}

impl RoundView {
    /// Another number whenever something else is to be seen.
    fn version_of(&mut self, session: &Session, number: usize, designed: bool) -> u64 {
        let document = Arc::clone(session.document());
        let now = Subject { shown: self.shown, document, station: number, roll: session.roll(), designed };
        if self.last.as_ref() != Some(&now) {
            self.version += 1;
            self.last = Some(now);
        }
        self.version
    }
}

fn station(ui: &mut Ui, view: &mut RoundView, session: &Session, palette: &Palette) -> Option<()> {
    let set = session.document().content.roll_set()?;
    let number = super::shown_station(session, set).map_or(1, |(number, _)| number);
    let rolls = session.derived()?.rolls.clone()?;
    let design = rolls.design.stations.iter().find(|s| s.number == number)?;
    let set_mm = set.scaled(session.document().unit.in_mm());
    let version = view.version_of(session, number, session.is_designed());
    let bore_mm = |kind| bore_diameter(&set_mm, kind);
    let subject = LineSubject::Station { design, roll: session.roll(), bore_mm: &bore_mm };
    line_solid(ui, &mut view.plot, subject, version, palette);
    Some(())
}

fn line(ui: &mut Ui, view: &mut RoundView, session: &Session, palette: &Palette) -> Option<()> {
    let document = session.document();
    let set = document.content.roll_set()?;
    if !view.made.as_ref().is_some_and(|(of, _)| Arc::ptr_eq(of, document)) {
        view.made = Some((Arc::clone(document), loft(&set.scaled(document.unit.in_mm()))));
    }
    let version = view.version_of(session, 0, true);
    let (_, sections) = view.made.as_ref().filter(|(_, sections)| !sections.is_empty())?;
    line_solid(ui, &mut view.plot, LineSubject::Line { sections }, version, palette);
    Some(())
}

fn roll(ui: &mut Ui, view: &mut RoundView, session: &Session, palette: &Palette) -> Option<()> {
    let derived = session.setup()?;
    solid_view(ui, &mut view.roll, &SolidScene { derived, stock_at_s: None, palette });
    Some(())
}
