//! The head of the sheet: name, verdict, stock, holding, zero, time.

use super::writer::{LEFT_MM, RIGHT_MM, Writer, cell, grey};
use super::{Subject, minutes};
use crate::document::Holding;
use crate::geometry::Point;
use crate::papers::font::fitted;
use crate::papers::number::number;
use crate::papers::page::{Align, Ink};

/// Name of the clamping and what the proof says about its programs.
pub(super) fn head(subject: &Subject<'_>, to: &mut Writer) {
    title(&subject.item.name, subject.item.proof.passed, to);
}

/// A name and what the proof says.
pub(in crate::papers) fn title(name: &str, passed: bool, to: &mut Writer) {
    to.r -= 6.0;
    to.page.heading(Point::new(LEFT_MM, to.r), 5.0, fitted(name, 5.0, 110.0));
    let (ink, verdict) = if passed { (Ink::Green, "Proved") } else { (Ink::Red, "NOT PROVED: do not run") };
    to.page.ink_text(Point::new(RIGHT_MM, to.r), 3.5, Align::End, ink, verdict);
    to.r -= 3.0;
    to.rule();
}

/// What the operator has to know before the first cut.
pub(super) fn facts(subject: &Subject<'_>, to: &mut Writer) {
    let mut rows = vec![
        ("Machine", subject.machine.map_or_else(String::new, |m| m.name.clone())),
        ("Material", subject.part.material.clone()),
        ("Stock", stock(subject)),
        ("Holding", holding(subject)),
        ("Program zero", zero(subject)),
        ("Tool change", tool_change(subject)),
        ("Finished length", subject.length(subject.item.setup.length)),
        ("Time", time(subject)),
    ];
    rows.extend(cost(subject).map(|cost| ("Cost", cost)));
    for (name, value) in rows {
        to.wrapped_row(Some(grey(LEFT_MM, 32.0, name)), &cell(LEFT_MM + 34.0, RIGHT_MM - LEFT_MM - 34.0, value));
    }
}

fn stock(subject: &Subject<'_>) -> String {
    let (setup, part, unit) = (&subject.item.setup, subject.part, subject.unit);
    let outside = number(2.0 * setup.bar_radius, unit);
    let bar = match part.stock_bore_diameter * unit.in_mm() {
        hole if hole > 0.0 => format!("tube Ø {outside} / Ø {}", subject.length(hole)),
        _ => format!("bar Ø {} {}", outside, unit.symbol()),
    };
    let Some(bounds) = setup.stock.bounds() else { return bar };
    let length = match setup.holding {
        Holding::BetweenCentres => format!("{} long", subject.length(bounds.max.z - bounds.min.z)),
        Holding::Chuck => format!("{} out of the chuck", subject.length(bounds.max.z - setup.chuck_face_z)),
    };
    match bounds.max.z - setup.length {
        facing if facing > 5e-4 => format!("{bar}, {length}, {} to face off", subject.length(facing)),
        _ => format!("{bar}, {length}"),
    }
}

fn holding(subject: &Subject<'_>) -> String {
    let setup = &subject.item.setup;
    let holding = match setup.holding {
        Holding::Chuck => {
            let chuck = subject.machine.map(|m| m.chuck);
            match chuck.map(|c| if subject.part.automatic { c.automatic_grip_mm } else { c.grip_mm }) {
                Some(grip) if subject.part.automatic => {
                    format!("chuck, {} for grip and part handling", subject.length(grip))
                }
                Some(grip) => format!("chuck, {} gripped", subject.length(grip)),
                None => "chuck".to_owned(),
            }
        }
        Holding::BetweenCentres => "between centres".to_owned(),
    };
    let end = if setup.turned_round { "second end, turned round" } else { "free end first" };
    if setup.suffix.is_empty() { holding } else { format!("{holding}, {end}") }
}

fn zero(subject: &Subject<'_>) -> String {
    let (z, length) = (subject.item.path.program_zero_z, subject.item.setup.length);
    if (z - length).abs() < 5e-4 {
        "on the axis, at the finished free end".to_owned()
    } else if z.abs() < 5e-4 {
        "on the axis, at the finished clamped end".to_owned()
    } else {
        format!("on the axis, {} from the finished clamped end", subject.length(z))
    }
}

fn tool_change(subject: &Subject<'_>) -> String {
    common_change(subject).map_or_else(
        || "every tool at its own place, see below".to_owned(),
        |at| format!("at {}, from the program zero; programs start and end there", place(subject, at)),
    )
}

/// Where all tools are changed, if that is one place.
pub(super) fn common_change(subject: &Subject<'_>) -> Option<Point> {
    let path = &subject.item.path;
    let mut places = path.operations.iter().map(|o| o.change.unwrap_or(path.datum));
    let first = places.next().unwrap_or(path.datum);
    places.all(|place| place.distance(first) < 5e-4).then_some(first)
}

/// A place of the programmed point, in program coordinates.
pub(super) fn place(subject: &Subject<'_>, p: Point) -> String {
    let z = p.z - subject.item.path.program_zero_z;
    format!("Ø {} {u}, z {} {u}", number(2.0 * p.r, subject.unit), number(z, subject.unit), u = subject.unit.symbol())
}

fn time(subject: &Subject<'_>) -> String {
    let times = &subject.item.proof.times;
    let of = [
        ("cutting", times.feed_s),
        ("rapid", times.rapid_s),
        ("tool changes", times.tool_change_s),
        ("dwells", times.dwell_s),
    ];
    let parts: Vec<String> =
        of.iter().filter(|(_, s)| *s >= 0.5).map(|(name, s)| format!("{name} {}", minutes(*s))).collect();
    format!("{} ({})", minutes(times.total_s), parts.join(", "))
}

fn cost(subject: &Subject<'_>) -> Option<String> {
    let cost = subject.item.proof.cost.as_ref()?;
    let money = |value: f64| format!("{value:.2} {}", cost.currency);
    let blank = cost.blank.map_or("blank unknown".to_owned(), |blank| format!("blank {}", money(blank)));
    let setup = if cost.setup > 0.0 { format!("; setting up {} once", money(cost.setup)) } else { String::new() };
    Some(format!("{} each ({blank}, machining {}){setup}", money(cost.part), money(cost.machining)))
}
