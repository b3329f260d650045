//! The parameter table of a shell.

use super::form::{Counts, figure, heading, pick, row, words};
use super::{rows, shell};
use crate::app::actions::Action;
use crate::app::desk::Requests;
use crate::app::theme::{self, Colors};
use crate::app::widgets::{link, title_row};
use crate::document::{Content, Document, FORMAT_VERSION, FormerShape, Forming, Shell};
use crate::session::Session;
use crate::spinning;
use crate::spinning::limits::{LONGEST_LUBRICANT, MOST_PASSES};
use crate::spinning::material::materials;
use crate::units::Unit;
use egui::{ScrollArea, Ui};

const DEGREES: Counts = Counts::Other("°", 2);

/// Shows the panel; true if it is dragged by its title.
pub(super) fn show(ui: &mut Ui, titled: bool, session: &mut Session, requests: &mut Requests) -> bool {
    let Some(shell) = shell(session).cloned() else { return title_row(ui, titled.then_some("Shell"), "", |_| {}) };
    let name = shell.former.shape.name();
    let dragged = title_row(ui, titled.then_some("Shell"), name, |ui| {
        if link(ui, "former as part").on_hover_text("Open the former as a turned part and machine it").clicked() {
            open_former(session, &shell, requests);
        }
    });
    ScrollArea::vertical().auto_shrink([false, false]).show(ui, |ui| {
        ui.spacing_mut().item_spacing.y = 3.0;
        former(ui, session, &shell);
        blank(ui, session, &shell);
        roller(ui, session, &shell);
        program(ui, session, &shell, requests);
        rig(ui, session, &shell);
        results(ui, session);
    });
    dragged
}

fn open_former(session: &Session, shell: &Shell, requests: &mut Requests) {
    let unit = session.document().unit;
    let former = shell.scaled(unit.in_mm()).former;
    let machine = requests.catalog.machine(&shell.machine).or_else(|| requests.catalog.machine("linuxcnc"));
    let made = machine.and_then(|machine| spinning::as_turned_part(&former, machine, "C45"));
    match made {
        Some(part) => {
            let document = Document {
                turnwright: FORMAT_VERSION,
                name: format!("{} FORMER", session.document().name),
                unit: Unit::Mm,
                content: Content::TurnedPart(part),
            };
            requests.actions.push(Action::OpenMade(Box::new(document)));
        }
        None => requests.complain("The former's figures give no contour yet; correct them first.".to_owned()),
    }
}

fn former(ui: &mut Ui, session: &mut Session, shell: &Shell) {
    heading(ui, "Former");
    pick(ui, session, "Contour", &shell.former.shape.name(), &SHAPES, |shell, name| {
        shell.former.shape = spinning::reshape::of_kind(name, &shell.former.shape);
    });
    match &shell.former.shape {
        FormerShape::Cone { half_angle_deg, tip_diameter, length } => {
            shape_figure(ui, session, ("Half angle", "half_angle_deg"), *half_angle_deg, DEGREES);
            shape_figure(ui, session, ("Tip ⌀", "tip_diameter"), *tip_diameter, Counts::Length);
            shape_figure(ui, session, ("Length", "length"), *length, Counts::Length);
        }
        FormerShape::Parabola { constant, tip_diameter, length } => {
            shape_figure(ui, session, ("Constant 4a", "constant"), *constant, Counts::Length);
            shape_figure(ui, session, ("Tip ⌀", "tip_diameter"), *tip_diameter, Counts::Length);
            shape_figure(ui, session, ("Length", "length"), *length, Counts::Length);
        }
        FormerShape::Dish { focal_length, tip_diameter, rim_diameter } => {
            shape_figure(ui, session, ("Focal length", "focal_length"), *focal_length, Counts::Length);
            shape_figure(ui, session, ("Tip ⌀", "tip_diameter"), *tip_diameter, Counts::Length);
            shape_figure(ui, session, ("Rim ⌀", "rim_diameter"), *rim_diameter, Counts::Length);
        }
        FormerShape::Ellipse { semi_axis, diameter, tip_diameter, length } => {
            shape_figure(ui, session, ("Semi-axis along z", "semi_axis"), *semi_axis, Counts::Length);
            shape_figure(ui, session, ("Largest ⌀", "diameter"), *diameter, Counts::Length);
            shape_figure(ui, session, ("Tip ⌀", "tip_diameter"), *tip_diameter, Counts::Length);
            shape_figure(ui, session, ("Length", "length"), *length, Counts::Length);
        }
        FormerShape::Sections { sections } => rows::show(ui, session, sections),
    }
    figure(ui, session, ("Base length", "former.base_length"), shell.former.base_length, Counts::Length, |s, v| {
        s.former.base_length = v;
    });
}

const SHAPES: [(&str, &str); 5] = [
    ("cone", "cone"),
    ("parabola", "parabola of 1988"),
    ("dish", "dish (paraboloid)"),
    ("ellipse", "hemisphere, ellipse"),
    ("sections", "section table"),
];

fn shape_figure(ui: &mut Ui, session: &mut Session, (label, key): (&str, &str), value: f64, counts: Counts) {
    let path = format!("former.shape.{key}");
    figure(ui, session, (label, &path), value, counts, |shell, value| shell.former.shape.set(key, value));
}

fn blank(ui: &mut Ui, session: &mut Session, shell: &Shell) {
    heading(ui, "Blank");
    let blank = &shell.blank;
    figure(ui, session, ("Thickness", "blank.thickness"), blank.thickness, Counts::Length, |s, v| {
        s.blank.thickness = v;
    });
    let unit = session.document().unit;
    let shown = blank.diameter.map_or_else(|| "by volume".to_owned(), |d| crate::app::plots::fixed(d, unit.decimals()));
    let read = |text: &str| match text.trim() {
        "" | "by volume" => Ok(None),
        text => crate::units::parse_length(text, unit).map(Some),
    };
    row(ui, session, ("Diameter", "blank.diameter"), &shown, unit.symbol(), read, |s, v| s.blank.diameter = v);
    let follower = ("Follower ⌀", "blank.follower_diameter");
    figure(ui, session, follower, blank.follower_diameter, Counts::Length, |s, v| s.blank.follower_diameter = v);
    let follower = ("Follower length", "blank.follower_length");
    figure(ui, session, follower, blank.follower_length, Counts::Length, |s, v| s.blank.follower_length = v);
    let names: Vec<(&str, &str)> = materials().iter().map(|m| (m.name, m.name)).collect();
    pick(ui, session, "Material", &shell.material.as_str(), &names, |shell, name| {
        (*name).clone_into(&mut shell.material);
    });
    words(ui, session, "Lubricant", &shell.lubricant, LONGEST_LUBRICANT, |s, v| s.lubricant = v);
    let forming = [(Forming::Shear, "flow-turning"), (Forming::Spinning, "spinning")];
    pick(ui, session, "Process", &shell.forming, &forming, |shell, forming| shell.forming = *forming);
    let passes = shell.passes.to_string();
    let read = |text: &str| match text.trim().parse::<u32>() {
        Ok(passes) if (1..=MOST_PASSES).contains(&passes) => Ok(passes),
        _ => Err(format!("Enter 1 to {MOST_PASSES} passes.")),
    };
    row(ui, session, ("Passes", "passes"), &passes, "", read, |s, v| s.passes = v);
}

fn roller(ui: &mut Ui, session: &mut Session, shell: &Shell) {
    heading(ui, "Roller");
    let r = &shell.roller;
    figure(ui, session, ("Nose radius", "roller.nose_radius"), r.nose_radius, Counts::Length, |s, v| {
        s.roller.nose_radius = v;
    });
    figure(ui, session, ("Roller ⌀", "roller.diameter"), r.diameter, Counts::Length, |s, v| s.roller.diameter = v);
    figure(ui, session, ("Width", "roller.width"), r.width, Counts::Length, |s, v| s.roller.width = v);
    figure(ui, session, ("Swivel", "roller.swivel_deg"), r.swivel_deg, DEGREES, |s, v| s.roller.swivel_deg = v);
    figure(ui, session, ("Flank angle", "roller.flank_deg"), r.flank_deg, DEGREES, |s, v| s.roller.flank_deg = v);
    let read = |text: &str| text.trim().parse::<u32>().map_err(|_| format!("\"{text}\" is no whole figure."));
    let station = r.station.to_string();
    row(ui, session, ("Turret station", "roller.station"), &station, "", read, |s, v| s.roller.station = v);
}

fn program(ui: &mut Ui, session: &mut Session, shell: &Shell, requests: &Requests) {
    heading(ui, "Speeds and machine");
    let machines = requests.catalog.machines.iter().filter(|m| m.words.is_some());
    let machines: Vec<(&str, &str)> = machines.map(|m| (m.id.as_str(), m.name.as_str())).collect();
    pick(ui, session, "Machine", &shell.machine.as_str(), &machines, |shell, id| (*id).clone_into(&mut shell.machine));
    let s = &shell.speeds;
    let speed = ("Surface speed", "speeds.surface_m_per_min");
    figure(ui, session, speed, s.surface_m_per_min, Counts::Other("m/min", 0), |s, v| s.speeds.surface_m_per_min = v);
    figure(ui, session, ("Highest speed", "speeds.max_rpm"), s.max_rpm, Counts::Other("1/min", 0), |s, v| {
        s.speeds.max_rpm = v;
    });
    let feed = ("Feed per turn", "speeds.feed_per_rev");
    figure(ui, session, feed, s.feed_per_rev, Counts::Length, |s, v| s.speeds.feed_per_rev = v);
    figure(ui, session, ("Gap tolerance", "gap_tolerance"), shell.gap_tolerance, Counts::Length, |s, v| {
        s.gap_tolerance = v;
    });
}

fn rig(ui: &mut Ui, session: &mut Session, shell: &Shell) {
    heading(ui, "On the rig");
    let rig = &shell.rig;
    figure(ui, session, ("Spindle", "rig.rpm"), rig.rpm, Counts::Other("1/min", 0), |s, v| s.rig.rpm = v);
    figure(ui, session, ("Carriage feed", "rig.feed_per_rev"), rig.feed_per_rev, Counts::Length, |s, v| {
        s.rig.feed_per_rev = v;
    });
    let read = |text: &str| text.trim().parse::<u32>().map_err(|_| format!("\"{text}\" is no whole figure."));
    let shown = rig.increment_pulses.to_string();
    row(ui, session, ("Increment", "rig.increment_pulses"), &shown, "pulses", read, |s, v| s.rig.increment_pulses = v);
    figure(ui, session, ("Stop off path by", "rig.path_limit"), rig.path_limit, Counts::Length, |s, v| {
        s.rig.path_limit = v;
    });
}

/// What follows: blank, thinnest wall, set points.
fn results(ui: &mut Ui, session: &Session) {
    let Some(made) = session.derived().and_then(|d| d.shell.as_ref()) else { return };
    let colors = Colors::of(ui.visuals());
    let unit = session.document().unit;
    let length =
        |mm: f64| format!("{} {}", crate::app::plots::fixed(mm / unit.in_mm(), unit.decimals()), unit.symbol());
    heading(ui, "Result");
    let thinnest = made.shape.thinnest();
    for (name, value) in [
        ("Blank ⌀ by volume", length(2.0 * made.shape.volume_radius)),
        ("Thinnest wall", thinnest.map_or_else(String::new, |s| length(s.wall))),
        ("Largest reduction", thinnest.map_or_else(String::new, |s| format!("{:.1} %", 100.0 * s.reduction))),
        ("Set points", made.set_points.len().to_string()),
    ] {
        ui.horizontal(|ui| {
            ui.label(theme::quiet(name, colors));
            ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| ui.label(value));
        });
    }
}
