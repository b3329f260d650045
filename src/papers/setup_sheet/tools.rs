//! The tools of a clamping with their pictures.

use super::facts::{common_change, place};
use super::writer::{LEFT_MM, RIGHT_MM, TEXT_MM, Writer};
use super::{Subject, minutes};
use crate::geometry::Point;
use crate::machine::{Tool, ToolShape};
use crate::papers::font::fitted;
use crate::papers::number::number;
use crate::papers::page::{Align, Ink};
use crate::papers::tool_picture;
use crate::regen::Operations;

/// Side of a tool's picture, mm.
const TOOL_MM: f64 = 16.0;
/// From one tool to the next, mm.
const PITCH_MM: f64 = TOOL_MM + 1.5;

/// Every tool that an operation calls, by station.
pub(super) fn tools(subject: &Subject<'_>, to: &mut Writer) {
    let operations = &subject.item.path.operations;
    let mut stations: Vec<u32> = operations.iter().filter(|o| !o.moves.is_empty()).map(|o| o.tool).collect();
    stations.sort_unstable();
    stations.dedup();
    to.heading("Tools", PITCH_MM);
    let (times, _) = Operations::of(subject.item).times();
    for station in stations {
        to.need(PITCH_MM);
        to.r -= PITCH_MM;
        if let Some(outline) = subject.item.tools.get(&station) {
            tool_picture::draw(&mut to.page, outline, Point::new(LEFT_MM, to.r), TOOL_MM);
        }
        let text_z = LEFT_MM + TOOL_MM + 5.0;
        let at = |z: f64, below: f64| Point::new(z, to.r + TOOL_MM - below);
        let seconds: f64 =
            operations.iter().zip(&times).filter(|(o, _)| o.tool == station).map(|(_, t)| t.total_s()).sum();
        let name = format!("{station}   {}", tool(subject, station).map_or("not in the turret", |tool| &tool.name));
        let (name_at, time_at) = (at(text_z, 4.0), at(RIGHT_MM, 4.0));
        let (data_at, uses_at) = (at(text_z, 9.3), at(text_z, 14.0));
        let width = RIGHT_MM - text_z;
        to.page.heading(name_at, 2.6, fitted(&name, 2.6, width - 25.0));
        to.page.text(time_at, TEXT_MM, Align::End, minutes(seconds));
        to.page.text(data_at, TEXT_MM, Align::Start, fitted(&data(subject, station), TEXT_MM, width));
        to.page.ink_text(uses_at, TEXT_MM, Align::Start, Ink::Grey, fitted(&uses(subject, station), TEXT_MM, width));
    }
}

fn tool<'a>(subject: &'a Subject<'_>, station: u32) -> Option<&'a Tool> {
    subject.catalog.tool(&subject.machine?.turret_tool(station)?.tool)
}

/// Codes, nose radius, offset and place of change.
fn data(subject: &Subject<'_>, station: u32) -> String {
    let mut data = Vec::new();
    if let Some(ToolShape::Iso { insert, holder }) = tool(subject, station).map(|tool| &tool.shape) {
        data.push(format!("{insert} in {holder}"));
    }
    if let Some(outline) = subject.item.tools.get(&station) {
        if outline.nose_radius > 0.0 {
            let radius = number(outline.nose_radius, subject.unit);
            data.push(format!("nose radius {radius} {}", subject.unit.symbol()));
        }
        data.push(format!("tip {}", outline.orientation));
    }
    if let Some(turret) = subject.machine.and_then(|m| m.turret_tool(station)) {
        data.push(format!("offset {}", turret.offset_number()));
    }
    let change = subject.item.path.operations.iter().filter(|o| o.tool == station).find_map(|o| o.change);
    let change = change.filter(|_| common_change(subject).is_none());
    data.extend(change.map(|p| format!("changed at {}", place(subject, p))));
    data.join(", ")
}

/// The operations of a tool, each name once.
fn uses(subject: &Subject<'_>, station: u32) -> String {
    let mut names: Vec<&str> = Vec::new();
    for operation in subject.item.path.operations.iter().filter(|o| o.tool == station) {
        if !names.contains(&operation.name.as_str()) {
            names.push(&operation.name);
        }
    }
    names.join(", ")
}
