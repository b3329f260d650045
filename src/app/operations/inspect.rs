//! The selected operation in the inspector.

use super::{OperationsView, instruction, planned};
use crate::app::actions::Action;
use crate::app::data::Kind;
use crate::app::desk::Requests;
use crate::app::inspector::fact;
use crate::app::theme::{self, Colors};
use crate::app::widgets::{clock, link, remark};
use crate::document::Generator;
use crate::session::Session;
use crate::turning::figures::Figures;
use egui::Ui;

/// Shows everything about the operation `index`: what can be changed as fields, what follows as facts.
pub(crate) fn show(
    ui: &mut Ui,
    view: &mut OperationsView,
    session: &mut Session,
    requests: &mut Requests,
    index: usize,
) {
    if matches!(session.part().generator, Generator::Cycles { .. }) {
        instruction::show(ui, view, session, index);
        ui.add_space(4.0);
    }
    if planned::is_planned(session) {
        planned::show(ui, session, index);
        ui.add_space(4.0);
    }
    facts(ui, view, session, index);
    tool(ui, session, requests, index);
    if matches!(session.part().generator, Generator::Oracap { .. }) {
        ui.add_space(4.0);
        remark(ui, "The published generator chooses everything here by itself, from part and material.");
    }
}

fn facts(ui: &mut Ui, view: &OperationsView, session: &Session, index: usize) {
    let unit = session.document().unit;
    let machine = session.derived().and_then(|d| d.machine.as_deref());
    let by_hand = matches!(session.part().generator, Generator::Cycles { .. });
    if let Some(operation) = session.setup().and_then(|s| s.path.operations.get(index)).filter(|_| !by_hand) {
        for (name, text) in Figures::of(operation, machine).texts(unit) {
            fact(ui, name, &text);
        }
    }
    if let Some(time) = view.lines.all.iter().find(|line| line.index == index).and_then(|line| line.time) {
        fact(ui, "Cutting", &clock(time.cutting_s));
        fact(ui, "Air, changes", &clock(time.other_s));
    }
    let blocks = session.lit().blocks.len();
    if session.selection.operation == Some(index) && blocks > 0 {
        fact(ui, "Blocks", &blocks.to_string());
    }
}

/// The tool's name, and the way to its data.
fn tool(ui: &mut Ui, session: &Session, requests: &mut Requests, index: usize) {
    let instructed = session.part().generator.instructions().get(index).map(|i| i.tool);
    let made = session.setup().and_then(|s| s.path.operations.get(index)).map(|o| o.tool);
    let machine = session.derived().and_then(|d| d.machine.clone());
    let in_turret = instructed.or(made).and_then(|station| machine.as_ref()?.turret_tool(station).cloned());
    let Some(in_turret) = in_turret else { return };
    let name = requests.catalog.tool(&in_turret.tool).map_or(in_turret.tool.clone(), |t| t.name.clone());
    fact(ui, "Tool", &format!("T{} · {}", in_turret.station, in_turret.tool));
    ui.label(theme::quiet(name, Colors::of(ui.visuals())));
    if link(ui, "edit this tool…").clicked() {
        requests.actions.push(Action::EditData(Kind::Tools, Some(in_turret.tool)));
    }
}
