//! The setup sheet of a shell, A4 upright: what the operator needs beside the spinning lathe or the rig.

use super::Subject;
use super::picture::picture;
use super::walls::walls;
use crate::diagnostic::Diagnostic;
use crate::document::Forming;
use crate::geometry::Point;
use crate::papers::page::Page;
use crate::papers::setup_sheet::tables::found;
use crate::papers::setup_sheet::writer::{LEFT_MM, LINE_MM, RIGHT_MM, Writer, cell, figure, grey};
use crate::papers::setup_sheet::{minutes, title};
use crate::proof::Motion;
use crate::regen::Derived;
use crate::spinning::program;
use crate::turning::Speed;
use std::f64::consts::PI;

/// The pages of a shell's setup sheet.
///
/// # Errors
/// A diagnostic if the figures of the document give no shell.
pub(in crate::papers) fn sheet(derived: &Derived) -> Result<Vec<Page>, Diagnostic> {
    let subject = Subject::of(derived)?;
    let mut writer = Writer::new(&subject.made.name);
    title(&subject.document.name, subject.made.proof.passed && !subject.made.programs.is_empty(), &mut writer);
    facts(&subject, &mut writer);
    picture(&subject, &mut writer);
    wall_table(&subject, &mut writer);
    programs(&subject, &mut writer);
    rig(&subject, &mut writer);
    let several = subject.made.programs.len() > 1;
    found(&subject.made.proof.findings, several, &mut writer);
    Ok(writer.done())
}

fn rows(to: &mut Writer, rows: Vec<(&'static str, String)>) {
    for (name, value) in rows.into_iter().filter(|(_, value)| !value.is_empty()) {
        to.wrapped_row(Some(grey(LEFT_MM, 32.0, name)), &cell(LEFT_MM + 34.0, RIGHT_MM - LEFT_MM - 34.0, value));
    }
}

fn facts(subject: &Subject<'_>, to: &mut Writer) {
    let shell = subject.shell();
    let length = |mm: f64| subject.length(mm);
    let (tip, base) = (subject.made.shape.tip(), subject.made.shape.base());
    let by = if shell.blank.diameter.is_some() { "given" } else { "by constant volume" };
    let former = format!(
        "{}; tip Ø {}, base Ø {}, {} long, cylinder of {} behind it",
        subject.contour(),
        length(2.0 * tip.r),
        length(2.0 * base.r),
        length(tip.z - base.z),
        length(base.z)
    );
    let roller = format!(
        "Ø {}, nose R {}, {} wide, swivelled by {}°, flanks {}°; station {}",
        length(shell.roller.diameter),
        length(shell.roller.nose_radius),
        length(shell.roller.width),
        shell.roller.swivel_deg,
        shell.roller.flank_deg,
        shell.roller.station
    );
    let process = match shell.forming {
        Forming::Shear => "flow-turning, wall by the sine law",
        Forming::Spinning => "spinning, the wall keeps its thickness",
    };
    let passes = if shell.passes == 1 { "one pass".to_owned() } else { format!("{} passes", shell.passes) };
    rows(
        to,
        vec![
            ("Machine", subject.machine.map_or_else(String::new, |m| m.name.clone())),
            ("Material", shell.material.clone()),
            (
                "Blank",
                format!(
                    "disc Ø {} × {}, {by}",
                    length(2.0 * subject.made.shape.blank_radius),
                    length(shell.blank.thickness)
                ),
            ),
            ("Former", former),
            (
                "Follower",
                format!("Ø {}, {} long", length(shell.blank.follower_diameter), length(shell.blank.follower_length)),
            ),
            ("Roller", roller),
            ("Lubricant", shell.lubricant.clone()),
            ("Process", format!("{process}, {passes}")),
            ("Spindle", spindle(subject)),
            ("Feed", format!("{}/rev", length(shell.speeds.feed_per_rev))),
            (
                "Program zero",
                "on the axis, at the face of the former's tip; programmed is the nose's centre".to_owned(),
            ),
            (
                "Roller begins at",
                subject.made.path.passes.first().map_or_else(String::new, |p| place(subject, p.approach)),
            ),
            ("Time", time(subject)),
        ],
    );
}

/// The spindle as the program turns it: a cutting speed with what it gives at tip and base, or one speed all along with what
/// that gives at the base.
fn spindle(subject: &Subject<'_>) -> String {
    let Some(machine) = subject.machine else { return String::new() };
    let (tip, base) = (subject.made.shape.tip().r, subject.made.shape.base().r);
    let cut = program::cut(subject.shell(), &subject.made.shape, machine);
    match cut.speed {
        Speed::Surface { m_per_min, max_rpm } => format!(
            "{m_per_min} m/min, {:.0} 1/min at the tip to {:.0} 1/min at the base, {max_rpm:.0} 1/min at most",
            cut.rpm_at(tip),
            cut.rpm_at(base)
        ),
        Speed::Rpm(rpm) => {
            let rpm = machine.nearest_rpm(rpm);
            format!("{rpm:.0} 1/min all along, {:.0} m/min at the base", rpm * 2.0 * PI * base / 1000.0)
        }
    }
}

/// A place of the nose's centre in program coordinates.
fn place(subject: &Subject<'_>, p: Point) -> String {
    format!("Ø {}, z {}", subject.length(2.0 * p.r), subject.length(p.z - subject.made.shape.tip().z))
}

fn time(subject: &Subject<'_>) -> String {
    let times = &subject.made.proof.times;
    format!("{} (forming {}, rapid {})", minutes(times.total_s), minutes(times.feed_s), minutes(times.rapid_s))
}

fn wall_table(subject: &Subject<'_>, to: &mut Writer) {
    to.heading("Wall along the shell", 2.0 * LINE_MM);
    let columns = [12.0, 30.0, 30.0, 30.0, 30.0, 30.0];
    let mut row = |texts: [&str; 6], is_head: bool| {
        let mut left = LEFT_MM;
        let mut cells = Vec::new();
        for (text, width) in texts.into_iter().zip(columns) {
            let cell = figure(left, width, text.to_owned());
            cells.push(if is_head {
                crate::papers::setup_sheet::writer::Cell { ink: crate::papers::page::Ink::Grey, ..cell }
            } else {
                cell
            });
            left += width;
        }
        to.row(&cells);
    };
    row(["no.", "from the tip", "inside Ø", "angle", "wall", "reduction"], true);
    for wall in walls(subject) {
        let [from, diameter, angle, thickness, reduction] = &wall.cells;
        row([&wall.number.to_string(), from, diameter, angle, thickness, reduction], false);
    }
}

fn programs(subject: &Subject<'_>, to: &mut Writer) {
    to.heading("Programs", 2.0 * LINE_MM);
    let made = subject.made;
    if made.programs.is_empty() {
        to.row(&[grey(LEFT_MM, 120.0, "None: what is said about the shell has to be put right first.")]);
    }
    for (k, (program, text)) in made.post.programs.iter().zip(made.programs.iter()).enumerate() {
        let moves = made.proof.moves.iter().filter(|m| m.program == k);
        let (total, forming) = moves.fold((0.0, 0.0), |(total, forming), m| {
            (total + m.lasts_s, forming + if m.motion == Motion::Feed { m.lasts_s } else { 0.0 })
        });
        to.row(&[
            cell(LEFT_MM, 60.0, format!("{}.{}", program.name, program.extension)),
            grey(LEFT_MM + 62.0, 35.0, if text.edited { "edited by hand" } else { "" }),
            figure(LEFT_MM + 95.0, 25.0, format!("{} blocks", program.blocks.len())),
            figure(LEFT_MM + 122.0, 24.0, minutes(total)),
            figure(LEFT_MM + 146.0, 29.0, format!("forming {}", minutes(forming))),
        ]);
    }
}

fn rig(subject: &Subject<'_>, to: &mut Writer) {
    to.heading("On the hydraulic rig", 2.0 * LINE_MM);
    let rig = &subject.shell().rig;
    rows(
        to,
        vec![
            ("Spindle and feed", format!("{} 1/min, {}/rev", rig.rpm, subject.length(rig.feed_per_rev))),
            (
                "Set points",
                format!(
                    "{}, every {} encoder pulses; {name}.csv, {name}.h",
                    subject.made.set_points.len(),
                    rig.increment_pulses,
                    name = subject.made.name
                ),
            ),
            ("Stops", format!("{} off the path", subject.length(rig.path_limit))),
        ],
    );
}
