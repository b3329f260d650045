//! What the station that is shown is designed by.

mod side_roll;

use super::RollsViews;
use super::fields::{Field, Form};
use super::words;
use crate::app::desk::Requests;
use crate::app::plots::fixed;
use crate::app::theme::{self, Colors};
use crate::app::widgets::{link, title_row};
use crate::document::{
    DriveSurface, Element, ExtensionContour, ExtensionKind, Origin, Pinch, RollSet, SideRoll, Station,
};
use crate::rollform::drive::DriveDiameters;
use crate::session::Session;
use crate::units::Unit;
use egui::{ScrollArea, Ui};

/// Parts of a spigot that is added, mm: a shoulder that two rolls of usual size run on.
const SPIGOT_MM: [f64; 4] = [8.0, 13.0, 8.0, 13.0];

/// Shows the panel; true if it is dragged by its title.
pub(super) fn show(
    ui: &mut Ui,
    titled: bool,
    session: &mut Session,
    _views: &mut RollsViews,
    _requests: &mut Requests,
) -> bool {
    let document = std::sync::Arc::clone(session.document());
    let Some(set) = document.content.roll_set() else { return false };
    let found = super::shown_station(session, set);
    let title = found.map_or_else(|| "Station".to_owned(), |(number, _)| format!("Station {number}"));
    let dragged = title_row(ui, titled.then_some(&title), "", |ui| steps(ui, session, set, found));
    ScrollArea::vertical().id_salt("station-data").auto_shrink([false, false]).show(ui, |ui| {
        if let Some((_, station)) = found {
            let rolls = session.derived().and_then(|d| d.rolls.clone());
            let design = rolls.as_ref().and_then(|r| r.design.stations.iter().find(|s| s.station == station.id));
            let drive = design.and_then(|design| design.drive);
            Fields { unit: document.unit, set, station, drive, form: Form::one_column(ui) }.show(ui, session);
        } else {
            let colors = Colors::of(ui.visuals());
            ui.label(theme::quiet(
                "There is no station yet. Add one in the bend angles, or let a flower be suggested.",
                colors,
            ));
        }
    });
    dragged
}

/// To the station before or after.
fn steps(ui: &mut Ui, session: &mut Session, set: &RollSet, found: Option<(usize, &Station)>) {
    let Some((number, _)) = found else { return };
    let mut go = |ui: &mut Ui, text: &str, hint: &str, to: Option<usize>| {
        let station = to.and_then(|index| set.stations.get(index));
        if let Some(station) = station.filter(|_| link(ui, text).on_hover_text(hint).clicked()) {
            super::select_station(session, station.id);
        }
    };
    go(ui, "▶", "Next station", Some(number));
    go(ui, "◀", "Station before", number.checked_sub(2));
}

/// The fields of a station.
struct Fields<'a> {
    unit: Unit,
    set: &'a RollSet,
    station: &'a Station,
    /// Drive diameters of its rolls as they were designed last.
    drive: Option<DriveDiameters>,
    form: Form,
}

/// Left or right.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Side {
    Left,
    Right,
}

impl Side {
    const fn extension(self, station: &Station) -> &Vec<ExtensionContour> {
        match self {
            Self::Left => &station.extension_left,
            Self::Right => &station.extension_right,
        }
    }

    const fn extension_mut(self, station: &mut Station) -> &mut Vec<ExtensionContour> {
        match self {
            Self::Left => &mut station.extension_left,
            Self::Right => &mut station.extension_right,
        }
    }

    const fn roll(self, station: &Station) -> Option<&SideRoll> {
        match self {
            Self::Left => station.side_left.as_ref(),
            Self::Right => station.side_right.as_ref(),
        }
    }

    const fn roll_mut(self, station: &mut Station) -> &mut Option<SideRoll> {
        match self {
            Self::Left => &mut station.side_left,
            Self::Right => &mut station.side_right,
        }
    }
}

impl Fields<'_> {
    fn show(&self, ui: &mut Ui, session: &mut Session) {
        let s = self.station;
        self.length(ui, session, "Pass height", s.pass_height, |s, v| s.pass_height = v);
        self.length(ui, session, "Centres", s.centre_distance, |s, v| s.centre_distance = v);
        self.pinch(ui, session);
        self.drive(ui, session);
        self.speeds(ui, session);
        self.length(ui, session, "Tolerance L", s.tolerance_left, |s, v| s.tolerance_left = v);
        self.length(ui, session, "Tolerance R", s.tolerance_right, |s, v| s.tolerance_right = v);
        for (side, label) in [(Side::Left, "Left edge"), (Side::Right, "Right edge")] {
            self.extension(ui, session, side, label);
        }
        for (side, label) in [(Side::Left, "Left roll"), (Side::Right, "Right roll")] {
            self.side_roll(ui, session, side, label);
        }
        let all = [(false, "yes".to_owned()), (true, "none".to_owned())];
        self.choice(ui, session, "Rolls", &s.without_rolls, &all, |s, without| s.without_rolls = without);
        ui.add_space(8.0);
        self.line(ui, session);
    }

    /// What all stations share.
    fn line(&self, ui: &mut Ui, session: &mut Session) {
        ui.label(theme::strong("Line"));
        let (line, unit) = (&self.set.line, self.unit);
        let form = self.form;
        Form::row(ui, |ui| {
            form.length(ui, session, Field::of("Station pitch"), line.station_pitch, unit, |s, v| {
                s.line.station_pitch = v;
            });
        });
        Form::row(ui, |ui| {
            form.length(ui, session, Field::of("Shaft ⌀"), line.shaft_diameter, unit, |s, v| {
                s.line.shaft_diameter = v;
            });
        });
        Form::row(ui, |ui| {
            let value = line.side_shaft_diameter;
            form.length(ui, session, Field::of("Side axle ⌀"), value, unit, |s, v| s.line.side_shaft_diameter = v);
        });
        Form::row(ui, |ui| {
            form.length(ui, session, Field::of("Drawn gap"), line.drawn_gap, unit, |s, v| s.line.drawn_gap = v);
        });
        Form::row(ui, |ui| {
            let value = self.set.die_clearance.unwrap_or(RollSet::DIE_CLEARANCE_MM / unit.in_mm());
            form.length(ui, session, Field::of("Die clearance"), value, unit, |s, v| s.die_clearance = Some(v));
        });
        Form::row(ui, |ui| {
            form.maybe_figure(ui, session, Field::of("Gear ratio"), line.gear_ratio, |s, v| s.line.gear_ratio = v);
        });
        Form::row(ui, |ui| {
            form.maybe_figure(ui, session, Field::of("Bottom rpm"), line.bottom_rpm, |s, v| s.line.bottom_rpm = v);
        });
    }

    fn length(
        &self,
        ui: &mut Ui,
        session: &mut Session,
        label: &str,
        value: f64,
        write: impl FnOnce(&mut Station, f64),
    ) {
        let id = self.station.id;
        Form::row(ui, |ui| {
            ui.push_id(id, |ui| {
                let of = Field::of(label);
                let write = |set: &mut RollSet, value| in_station(set, id, |s| write(s, value));
                self.form.length(ui, session, of, value, self.unit, write);
            });
        });
    }

    fn choice<T: PartialEq + Clone>(
        &self,
        ui: &mut Ui,
        session: &mut Session,
        label: &str,
        present: &T,
        all: &[(T, String)],
        write: impl FnOnce(&mut Station, T),
    ) {
        let id = self.station.id;
        Form::row(ui, |ui| {
            self.form.choice(ui, session, Field::of(label), present, all, |set, chosen| {
                in_station(set, id, |s| write(s, chosen));
            });
        });
    }

    fn pinch(&self, ui: &mut Ui, session: &mut Session) {
        let (thickness, present) = (self.set.section.thickness, self.station.pinch);
        let (drive, clearance, added) = match present {
            Pinch::None => (thickness, thickness, 0.0),
            Pinch::Gaps { drive, clearance } => (drive, clearance, 0.0),
            Pinch::Clearance { added } => (thickness, thickness, added),
        };
        let all = [
            (Pinch::None, "thickness".to_owned()),
            (Pinch::Gaps { drive, clearance }, "own gaps".to_owned()),
            (Pinch::Clearance { added }, "8 % and more".to_owned()),
        ];
        self.choice(ui, session, "Opening", &present, &all, |s, pinch| s.pinch = pinch);
        match present {
            Pinch::None => {}
            Pinch::Gaps { drive, clearance } => {
                self.length(ui, session, "Drive gap", drive, |s, v| s.pinch = Pinch::Gaps { drive: v, clearance });
                self.length(ui, session, "Clear gap", clearance, |s, v| s.pinch = Pinch::Gaps { drive, clearance: v });
            }
            Pinch::Clearance { added } => {
                self.length(ui, session, "Added gap", added, |s, v| s.pinch = Pinch::Clearance { added: v });
            }
        }
    }

    /// The drive surface ends at an element on either side; it begins at the first one. A symmetrical section is asked for the right
    /// side alone, and a section that begins at an edge has one list.
    fn drive(&self, ui: &mut Ui, session: &mut Session) {
        let section = &self.set.section;
        let (right, left) = match section.origin {
            Origin::CentreRightFirst => (&section.elements, Some(&section.other_side)),
            Origin::CentreLeftFirst => (&section.other_side, Some(&section.elements)),
            Origin::RightToLeft => return self.drive_to(ui, session, "Drive", &section.elements, Side::Left),
            Origin::LeftToRight | Origin::Symmetrical => (&section.elements, None),
        };
        if let Some(left) = left {
            self.drive_to(ui, session, "Drive L", left, Side::Left);
            self.drive_to(ui, session, "Drive R", right, Side::Right);
        } else {
            self.drive_to(ui, session, "Drive", right, Side::Right);
        }
    }

    fn drive_to(&self, ui: &mut Ui, session: &mut Session, label: &str, elements: &[Element], side: Side) {
        let Some(first) = elements.first().map(|e| e.id) else { return };
        let mut all: Vec<(Option<u32>, String)> = vec![(None, "longest line".to_owned())];
        all.extend(elements.iter().map(|e| (Some(e.id), format!("1 to {}", words::number(self.set, e.id)))));
        let surface = if side == Side::Left { self.station.drive_left } else { self.station.drive_right };
        self.choice(ui, session, label, &surface.map(|drive| drive.last), &all, |s, last| {
            let chosen = last.map(|last| DriveSurface { first, last });
            *(if side == Side::Left { &mut s.drive_left } else { &mut s.drive_right }) = chosen;
        });
    }

    /// Drive diameters, the gear ratio, and how fast the surfaces run.
    fn speeds(&self, ui: &mut Ui, session: &mut Session) {
        let (id, own) = (self.station.id, self.station.gear_ratio);
        let Some(drive) = self.drive else { return };
        let length = |mm: Option<f64>| told(mm.map(|mm| mm / self.unit.in_mm()), self.unit.decimals());
        let pair = |bottom: String, top: String| format!("{bottom} · {top}");
        Form::row(ui, |ui| {
            let text = pair(length(drive.bottom), length(drive.top));
            self.form.told(ui, "Drive ⌀ B · T", &text).on_hover_text(
                "Diameters of bottom and top roll in the middle of the widest, most level part of the drive surface",
            );
        });
        if let Some(rpm) = self.set.line.bottom_rpm {
            Form::row(ui, |ui| {
                let (bottom, top) = drive.surface_speeds(rpm);
                let text = pair(told(bottom, 2), told(top, 2));
                self.form.told(ui, "m/min B · T", &text).on_hover_text("Surface speeds of bottom and top roll there");
            });
        }
        Form::row(ui, |ui| {
            ui.push_id(id, |ui| {
                self.form.maybe_figure(ui, session, Field::of("Own gear ratio"), own, |set, ratio| {
                    in_station(set, id, |s| s.gear_ratio = ratio);
                });
            });
        });
        if let Some(fitting) = drive.fitting_ratio() {
            Form::row(ui, |ui| {
                let slip =
                    drive.top_runs_faster_by().map_or_else(String::new, |by| format!("top {:+.1} % · ", by * 100.0));
                self.form.told(ui, "Fitting ratio", &format!("{slip}{fitting:.3}")).on_hover_text(
                    "How much faster the top roll's surface runs than the bottom roll's, and the gear ratio at which both run \
                     alike",
                );
            });
        }
    }

    /// What an empty choice of one side is called: of a symmetrical section the left side is as the right one.
    fn unless_as_right(&self, side: Side, word: &str) -> String {
        let symmetrical = self.set.section.origin == Origin::Symmetrical;
        if symmetrical && side == Side::Left { "as right".to_owned() } else { word.to_owned() }
    }

    fn extension(&self, ui: &mut Ui, session: &mut Session, side: Side, label: &str) {
        let present = side.extension(self.station).first().map(|e| e.kind);
        let all = [
            (None, self.unless_as_right(side, "plain")),
            (Some(ExtensionKind::SpigotA), "spigot A".to_owned()),
            (Some(ExtensionKind::SpigotB), "spigot B".to_owned()),
            (Some(ExtensionKind::SideRoll), "side roll".to_owned()),
        ];
        let in_mm = self.unit.in_mm();
        self.choice(ui, session, label, &present, &all, |station, kind| {
            let list = side.extension_mut(station);
            match (kind, list.first_mut()) {
                (None, _) => list.clear(),
                (Some(kind), Some(first)) => first.kind = kind,
                (Some(kind), None) => list.push(ExtensionContour { kind, lengths: SPIGOT_MM.map(|l| l / in_mm) }),
            }
        });
        let Some(extension) = side.extension(self.station).first() else { return };
        for (index, length) in extension.lengths.into_iter().enumerate() {
            self.length(ui, session, &format!("{label} part {}", index + 1), length, |station, value| {
                let part = side.extension_mut(station).first_mut().and_then(|e| e.lengths.get_mut(index));
                if let Some(part) = part {
                    *part = value;
                }
            });
        }
    }
}

/// A figure, or a dash where there is none.
fn told(value: Option<f64>, decimals: usize) -> String {
    value.map_or_else(|| "–".to_owned(), |value| fixed(value, decimals))
}

fn in_station(set: &mut RollSet, id: u32, change: impl FnOnce(&mut Station)) {
    if let Some(station) = set.stations.iter_mut().find(|s| s.id == id) {
        change(station);
    }
}
