//! The fields of an instruction for a published cycle.

use super::OperationsView;
use super::edit::CYCLES;
use super::pick::{Pick, change};
use crate::app::widgets::{Typed, choice, field, form_label, length_field, link};
use crate::document::{CutIn, Cycle, Generator, Instruction};
use crate::session::Session;
use crate::units::{Unit, parse_length};
use egui::Ui;

/// Width of the labels, points.
const LABEL: f32 = 86.0;
/// Angle of a cut-in line until another is typed, degrees: down at half a right angle towards the clamped end.
const FIRST_ANGLE_DEG: f64 = 45.0;

/// One instruction with what its fields need.
struct Form<'a> {
    index: usize,
    now: &'a Instruction,
    unit: Unit,
}

/// Shows the fields of the instruction `index`.
pub(super) fn show(ui: &mut Ui, view: &mut OperationsView, session: &mut Session, index: usize) {
    let Some(now) = session.part().generator.instructions().get(index).cloned() else { return };
    let form = Form { index, now: &now, unit: session.document().unit };
    ui.push_id(("instruction", index), |ui| {
        let cycles = CYCLES.map(|cycle| (cycle, cycle.name().to_owned()));
        form.choice(ui, session, "Cycle", &now.cycle, &cycles, |i, cycle| i.cycle = cycle);
        form.area(ui, view, session);
        form.choice(ui, session, "Tool", &now.tool, &stations(session, now.tool), |i, tool| i.tool = tool);
        form.length(ui, session, "Stock left", now.stock_left, |i, v| i.stock_left = v);
        if matches!(now.cycle, Cycle::Rough | Cycle::Pocket) {
            form.length(ui, session, "Depth", now.depth, |i, v| i.depth = v);
        }
        form.figure(ui, session, "Speed m/min", now.speed_m_per_min, |i, v| i.speed_m_per_min = v);
        form.length(ui, session, "Feed a turn", now.feed_per_rev, |i, v| i.feed_per_rev = v);
        form.cut_in(ui, session);
    });
}

/// The turret's stations with their tools.
fn stations(session: &Session, present: u32) -> Vec<(u32, String)> {
    let machine = session.derived().and_then(|d| d.machine.clone());
    let tools = machine.iter().flat_map(|m| m.tools.iter());
    let mut all: Vec<(u32, String)> = tools.map(|t| (t.station, format!("T{} · {}", t.station, t.tool))).collect();
    if !all.iter().any(|(station, _)| *station == present) {
        all.insert(0, (present, format!("T{present} · not in the turret")));
    }
    all
}

impl Form<'_> {
    fn label(&self, what: &str) -> String {
        let what = what.trim_end_matches(" m/min").trim_end_matches(" °").to_lowercase();
        format!("{what} of operation {}", self.index + 1)
    }

    fn choice<T: PartialEq + Clone>(
        &self,
        ui: &mut Ui,
        session: &mut Session,
        label: &str,
        present: &T,
        all: &[(T, String)],
        write: impl FnOnce(&mut Instruction, T),
    ) {
        ui.horizontal(|ui| {
            form_label(ui, label, LABEL);
            let width = ui.available_width();
            if let Some(chosen) = choice(ui, label, present, all, width) {
                change(session, self.index, &self.label(label), |i| write(i, chosen));
            }
        });
    }

    fn length(
        &self,
        ui: &mut Ui,
        session: &mut Session,
        label: &str,
        value: f64,
        write: impl FnOnce(&mut Instruction, f64),
    ) {
        ui.horizontal(|ui| {
            form_label(ui, label, LABEL);
            let width = ui.available_width();
            if let Some(typed) = length_field(ui, label, value, self.unit, width) {
                self.put(typed, session, label, write);
            }
        });
    }

    /// A figure that is no length of the document.
    fn figure(
        &self,
        ui: &mut Ui,
        session: &mut Session,
        label: &str,
        value: f64,
        write: impl FnOnce(&mut Instruction, f64),
    ) {
        ui.horizontal(|ui| {
            form_label(ui, label, LABEL);
            let width = ui.available_width();
            let shown = crate::turning::figures::short(value);
            if let Some(typed) = field(ui, label, &shown, width, |text| parse_length(text, Unit::Mm)) {
                self.put(typed, session, label, write);
            }
        });
    }

    fn put<T>(&self, typed: Typed<T>, session: &mut Session, label: &str, write: impl FnOnce(&mut Instruction, T)) {
        typed.put_into_part(session, &self.label(label), |part, value| {
            if let Generator::Cycles { instructions } = &mut part.generator
                && let Some(instruction) = instructions.get_mut(self.index)
            {
                write(instruction, value);
            }
        });
    }

    fn area(&self, ui: &mut Ui, view: &mut OperationsView, session: &mut Session) {
        let rows: Vec<u32> = session.part().sections.iter().map(|s| s.id).collect();
        self.row(ui, session, "From row", &rows, self.now.from, |i, id| i.from = id);
        self.row(ui, session, "To row", &rows, self.now.to, |i, id| i.to = id);
        ui.horizontal(|ui| {
            form_label(ui, "", LABEL);
            let picking = view.pick.is_some_and(|pick| pick.instruction == self.index);
            let text = if picking { "give up picking" } else { "pick on the profile" };
            if link(ui, text).on_hover_text("Click the first and the last element on the profile").clicked() {
                view.pick = (!picking).then_some(Pick { instruction: self.index, from: None });
            }
        });
    }

    fn row(
        &self,
        ui: &mut Ui,
        session: &mut Session,
        label: &str,
        rows: &[u32],
        present: u32,
        write: impl FnOnce(&mut Instruction, u32),
    ) {
        ui.horizontal(|ui| {
            form_label(ui, label, LABEL);
            let width = ui.available_width();
            let shown =
                rows.iter().position(|id| *id == present).map_or_else(|| "?".to_owned(), |i| (i + 1).to_string());
            let read = |text: &str| {
                let number: Option<usize> = text.trim().parse().ok();
                let id = number.and_then(|number| rows.get(number.checked_sub(1)?).copied());
                id.ok_or_else(|| format!("There is no row “{}”; the table has rows 1 to {}.", text.trim(), rows.len()))
            };
            if let Some(typed) = field(ui, label, &shown, width, read) {
                self.put(typed, session, label, write);
            }
        });
    }

    fn cut_in(&self, ui: &mut Ui, session: &mut Session) {
        let all = [(false, "none".to_owned()), (true, "along a line".to_owned())];
        let first = self.first_cut_in(session);
        self.choice(ui, session, "Cut-in", &self.now.cut_in.is_some(), &all, |i, with| {
            i.cut_in = with.then_some(first);
        });
        let Some(line) = self.now.cut_in else { return };
        self.length(ui, session, "Cut-in z", line.z, |i, z| i.cut_in = Some(CutIn { z, ..line }));
        self.length(ui, session, "Cut-in ⌀", line.diameter, |i, diameter| {
            i.cut_in = Some(CutIn { diameter, ..line });
        });
        self.figure(ui, session, "Cut-in angle °", line.angle_deg, |i, angle_deg| {
            i.cut_in = Some(CutIn { angle_deg, ..line });
        });
    }

    /// A line through the end of the area that is cut first.
    fn first_cut_in(&self, session: &Session) -> CutIn {
        let row = session.part().sections.iter().find(|s| s.id == self.now.from);
        let (z, diameter) = row.map_or((0.0, 0.0), |s| (s.z2, s.d2));
        CutIn { z, diameter, angle_deg: FIRST_ANGLE_DEG }
    }
}
