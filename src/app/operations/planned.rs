//! Changes of what the planner chose: order, what is left out, and the fields of one operation.

use super::edit::ListEdit;
use crate::app::theme::{self, Colors};
use crate::app::widgets::{choice, field, form_label, link};
use crate::document::{Generator, Infeed, OperationEdit, OperationKind, OperationRef};
use crate::machine::{Machine, ToolKind};
use crate::session::Session;
use crate::turning::figures::short;
use crate::turning::{Cut, CutMove, Feed, Operation, Speed};
use crate::units::{Unit, parse_length};
use egui::Ui;

/// Width of the labels, points.
const LABEL: f32 = 86.0;

/// What a field shows that leaves its figure to the planner.
const PLANNERS: &str = "planner's";

/// True if the planner makes the operations.
pub(super) fn is_planned(session: &Session) -> bool {
    matches!(session.part().generator, Generator::Planned { .. })
}

/// The operation of the path with this index, as the planner knows it.
fn named(session: &Session, operation: &Operation) -> Option<OperationRef> {
    let clamping = &session.setup()?.setup.suffix;
    Some(session.part().plan.made_with(clamping, operation.kind, operation.tool))
}

/// The operation with this index of the path.
fn made(session: &Session, index: usize) -> Option<OperationRef> {
    named(session, session.setup()?.path.operations.get(index)?)
}

/// The operations of the clamping that do something, each once, in the order of cutting.
fn all_made(session: &Session) -> Vec<OperationRef> {
    let operations = session.setup().map(|s| s.path.operations.as_slice()).unwrap_or_default();
    let mut all: Vec<OperationRef> = Vec::new();
    for operation in operations.iter().filter(|o| !o.moves.is_empty()) {
        all.extend(named(session, operation).filter(|name| !all.contains(name)));
    }
    all
}

fn title(operation: &OperationRef) -> String {
    format!("{}, tool {}", operation.kind.name(), operation.tool)
}

/// Leaves an operation out or moves it; other edits of a list are not the planner's.
pub(super) fn apply(edit: ListEdit, session: &mut Session) {
    match edit {
        ListEdit::Delete(index) => leave_out(session, index),
        ListEdit::Up(index) => shift(session, index, -1),
        ListEdit::Down(index) => shift(session, index, 1),
        ListEdit::Add(_) | ListEdit::Duplicate(_) => {}
    }
}

fn leave_out(session: &mut Session, index: usize) {
    if let Some(operation) = made(session, index) {
        session.edit_part(&format!("leave out {}", title(&operation)), None, |part| {
            part.plan.change(&operation, |edit| edit.skip = true);
        });
        session.selection.operation = None;
    }
}

/// Puts an operation before or behind its neighbour.
fn shift(session: &mut Session, index: usize, by: isize) {
    let Some(operation) = made(session, index) else { return };
    let mut order = all_made(session);
    let Some(from) = order.iter().position(|o| *o == operation) else { return };
    let Some(to) = from.checked_add_signed(by).filter(|to| *to < order.len()) else { return };
    order.swap(from, to);
    session.edit_part(&format!("move {}", title(&operation)), None, |part| {
        let of_others = part.plan.order.iter().filter(|o| o.clamping != operation.clamping).cloned();
        part.plan.order = of_others.chain(order).collect();
    });
    session.selection.operation = index.checked_add_signed(by);
}

/// The links over the list: what can be done with the selected operation.
pub(super) fn links(ui: &mut Ui, session: &mut Session, selected: Option<usize>) -> Option<ListEdit> {
    let mut wish = None;
    if let Some(index) = selected {
        if link(ui, "leave out").on_hover_text("Plan without it (Ctrl+Delete)").clicked() {
            wish = Some(ListEdit::Delete(index));
        }
        if link(ui, "↓").on_hover_text("Make it later (Alt+↓)").clicked() {
            wish = Some(ListEdit::Down(index));
        }
        if link(ui, "↑").on_hover_text("Make it earlier (Alt+↑)").clicked() {
            wish = Some(ListEdit::Up(index));
        }
    }
    let ordered = !session.part().plan.order.is_empty();
    if ordered && link(ui, "planner's order").on_hover_text("Forget the changed order").clicked() {
        session.edit_part("take the planner's order", None, |part| part.plan.order.clear());
    }
    wish
}

/// The operations of the clamping that are left out, with the way back.
pub(super) fn left_out(ui: &mut Ui, session: &mut Session) {
    let Some(clamping) = session.setup().map(|s| s.setup.suffix.clone()) else { return };
    let of_clamping = |edit: &&OperationEdit| edit.skip && edit.operation.clamping == clamping;
    let skipped: Vec<OperationRef> =
        session.part().plan.operations.iter().filter(of_clamping).map(|edit| edit.operation.clone()).collect();
    for operation in skipped {
        ui.horizontal(|ui| {
            ui.label(theme::quiet(format!("left out: {}", title(&operation)), Colors::of(ui.visuals())));
            if link(ui, "take it again").clicked() {
                session.edit_part(&format!("take {} again", title(&operation)), None, |part| {
                    part.plan.change(&operation, |edit| edit.skip = false);
                });
            }
        });
    }
}

/// One planned operation with what its fields need.
struct Form {
    operation: OperationRef,
    edit: OperationEdit,
    unit: Unit,
}

/// Shows the fields of the planned operation with this index.
pub(super) fn show(ui: &mut Ui, session: &mut Session, index: usize) {
    let Some(operation) = made(session, index) else { return };
    let known = session.part().plan.of(&operation.clamping, operation.kind, operation.tool).cloned();
    let edit = known.unwrap_or_else(|| OperationEdit::of(operation.clone()));
    let form = Form { operation, edit, unit: session.document().unit };
    ui.push_id(("planned", index), |ui| {
        form.tool(ui, session);
        form.figure(ui, session, "Speed m/min", Unit::Mm, form.edit.speed_m_per_min, |e, v| e.speed_m_per_min = v);
        let kind = form.operation.kind;
        if matches!(kind, OperationKind::Thread | OperationKind::ThreadBore) {
            threads(ui, session);
        } else {
            form.figure(ui, session, "Feed", form.unit, form.edit.feed, |e, v| e.feed = v);
        }
        if has_depth(kind) {
            form.figure(ui, session, "Depth", form.unit, form.edit.depth, |e, v| e.depth = v);
        }
        form.links(ui, session, index);
    });
}

/// The choices about all threads of the part.
fn threads(ui: &mut Ui, session: &mut Session) {
    let present = session.part().threading;
    let all = [(Infeed::Radial, "radial"), (Infeed::Flank, "flank"), (Infeed::Alternating, "alternating")];
    let all = all.map(|(infeed, name)| (infeed, name.to_owned()));
    ui.horizontal(|ui| {
        form_label(ui, "Infeed", LABEL);
        let width = ui.available_width();
        if let Some(infeed) = choice(ui, "Infeed", &present.infeed, &all, width) {
            session.edit_part("infeed of threads", None, |part| part.threading.infeed = infeed);
        }
    });
    ui.horizontal(|ui| {
        form_label(ui, "Run-out", LABEL);
        let width = ui.available_width();
        let read = |text: &str| parse_length(text, Unit::Mm);
        if let Some(typed) = field(ui, "Run-out", &short(present.run_out), width, read) {
            typed.put_into_part(session, "run-out of threads", |part, pitches| part.threading.run_out = pitches);
        }
    })
    .response
    .on_hover_text("Pitches over which a thread runs out where no groove lets the tool out");
}

/// True if the planner cuts such an operation in several depths.
const fn has_depth(kind: OperationKind) -> bool {
    !matches!(kind, OperationKind::Groove | OperationKind::PartOff | OperationKind::Drill | OperationKind::FinishBore)
        && !matches!(kind, OperationKind::FinishRight | OperationKind::FinishLeft)
}

impl Form {
    fn change(&self, session: &mut Session, what: &str, change: impl FnOnce(&mut OperationEdit)) {
        session.edit_part(&format!("{what} of {}", title(&self.operation)), None, |part| {
            part.plan.change(&self.operation, change);
        });
    }

    fn tool(&self, ui: &mut Ui, session: &mut Session) {
        let planners = (None, format!("T{} · {PLANNERS}", self.operation.tool));
        let others = stations(session, &self.operation).into_iter().map(|(k, name)| (Some(k), name));
        let all: Vec<(Option<u32>, String)> = std::iter::once(planners).chain(others).collect();
        ui.horizontal(|ui| {
            form_label(ui, "Tool", LABEL);
            let width = ui.available_width();
            if let Some(chosen) = choice(ui, "Tool", &self.edit.tool, &all, width) {
                self.change(session, "tool", |edit| edit.tool = chosen);
            }
        });
    }

    /// A figure; an empty field leaves it to the planner.
    fn figure(
        &self,
        ui: &mut Ui,
        session: &mut Session,
        label: &str,
        unit: Unit,
        value: Option<f64>,
        write: impl FnOnce(&mut OperationEdit, Option<f64>),
    ) {
        let read = |text: &str| {
            let text = text.trim();
            if text.is_empty() || text == PLANNERS { Ok(None) } else { parse_length(text, unit).map(Some) }
        };
        ui.horizontal(|ui| {
            form_label(ui, label, LABEL);
            let width = ui.available_width();
            let shown = value.map_or_else(|| PLANNERS.to_owned(), short);
            if let Some(typed) = field(ui, label, &shown, width, read) {
                let what = label.trim_end_matches(" m/min").to_lowercase();
                typed.put_into_part(session, &format!("{what} of {}", title(&self.operation)), |part, value| {
                    part.plan.change(&self.operation, |edit| write(edit, value));
                });
            }
        });
    }

    fn links(&self, ui: &mut Ui, session: &mut Session, index: usize) {
        ui.horizontal(|ui| {
            let text = if self.edit.locked { "unlock" } else { "lock" };
            let hint = "Keep its tool, speed and feed whatever else the planner would choose";
            if link(ui, text).on_hover_text(hint).clicked() {
                let present = session.setup().and_then(|s| s.path.operations.get(index)).map(present);
                let mm = self.unit.in_mm();
                self.change(session, text, |edit| {
                    edit.locked = !edit.locked;
                    if let Some((feed, speed)) = present.filter(|_| edit.locked) {
                        edit.feed = edit.feed.or(feed.map(|feed| feed / mm));
                        edit.speed_m_per_min = edit.speed_m_per_min.or(speed);
                    }
                });
            }
            if !self.edit.is_empty()
                && link(ui, "planner's choices").on_hover_text("Forget all changes of it").clicked()
            {
                self.change(session, "planner's choices", |edit| *edit = OperationEdit::of(edit.operation.clone()));
            }
        });
    }
}

/// Largest feed of an operation's cuts, mm, and their cutting speed where it is constant, m/min.
fn present(operation: &Operation) -> (Option<f64>, Option<f64>) {
    let cuts = operation.moves.iter().filter_map(|m| match m {
        CutMove::Line { cut, .. } | CutMove::Arc { cut, .. } => Some(cut),
        _ => None,
    });
    let feed = |cut: &Cut| match cut.feed {
        Feed::PerMinute(feed) | Feed::PerRev(feed) => feed,
    };
    let speed = |cut: &Cut| match cut.speed {
        Speed::Surface { m_per_min, .. } => Some(m_per_min),
        Speed::Rpm(_) => None,
    };
    (cuts.clone().map(feed).reduce(f64::max), cuts.filter_map(speed).reduce(f64::max))
}

/// The other stations whose tools are of the kind that the operation needs.
fn stations(session: &Session, operation: &OperationRef) -> Vec<(u32, String)> {
    let (Some(machine), Some(setup)) = (session.derived().and_then(|d| d.machine.clone()), session.setup()) else {
        return Vec::new();
    };
    let name = |station: u32, machine: &Machine| machine.turret_tool(station).map(|t| t.tool.clone());
    let other = setup.tools.iter().filter(|(station, _)| **station != operation.tool);
    let of_kind = other
        .filter(|(_, outline)| does(outline.kind, operation.kind, setup.tools.get(&operation.tool).map(|t| t.kind)));
    of_kind.filter_map(|(&k, _)| Some((k, format!("T{k} · {}", name(k, &machine)?)))).collect()
}

/// True if a tool of `kind` can do an operation; `own`: the kind of the planner's tool.
fn does(kind: ToolKind, operation: OperationKind, own: Option<ToolKind>) -> bool {
    let wanted = match operation {
        OperationKind::Face => ToolKind::Turning,
        OperationKind::PartOff => ToolKind::Grooving,
        _ => return own == Some(kind),
    };
    kind == wanted
}
