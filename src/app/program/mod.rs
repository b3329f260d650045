//! The programs as they will be sent: instruction by instruction, or character by character.

mod by_hand;
mod entry;
mod lines;

use super::actions::Action;
use super::desk::Requests;
use super::theme::{self, Colors};
use super::widgets::{link, title_row, toggle};
use crate::machine::Dialect;
use crate::proof::{BlockRef, ProgramText};
use crate::session::{GestureId, Hovered, Session};
use egui::{RichText, Ui};
use entry::EntryView;
use lines::{Lines, Shown};

/// How the text is shown.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
enum Mode {
    /// One line an instruction.
    #[default]
    Instructions,
    /// Every character, control characters visible.
    Text,
    /// Every character, to be edited.
    Edit,
}

/// What the panel keeps from frame to frame.
#[derive(Default)]
pub(crate) struct ProgramView {
    mode: Mode,
    search: String,
    lines: Lines,
    shown_block: Option<usize>,
    gesture: Option<GestureId>,
    entry: Option<EntryView>,
}

/// Shows the panel; true if it is dragged by its title.
pub(crate) fn show(
    ui: &mut Ui,
    view: &mut ProgramView,
    session: &mut Session,
    requests: &mut Requests,
    titled: bool,
) -> bool {
    let program = session.program().cloned();
    if let Some(program) = &program {
        let machine = session.derived().and_then(|d| d.machine.as_ref());
        view.lines.follow(program, machine.map_or(Dialect::Orac, |m| m.dialect));
    }
    let dragged = title_row(ui, titled.then_some("Program"), "", |ui| {
        if let Some(program) = &program {
            tools(ui, view, session, program);
        }
    });
    let Some(program) = program else {
        let colors = Colors::of(ui.visuals());
        ui.label(theme::quiet("There is no program yet.", colors));
        return dragged;
    };
    // A text made by hand is part of the document; a generated one must be the present one before it is edited.
    let outdated = session.outdated().filter(|_| session.text_by_hand(&program.name).is_none());
    if view.mode == Mode::Edit {
        match outdated {
            Some(reason) => _ = ui.label(theme::quiet(reason, Colors::of(ui.visuals()))),
            None => by_hand::show(ui, &mut view.gesture, session, &program),
        }
        return dragged;
    }
    if let Some(entry) = &mut view.entry
        && ui.add_enabled_ui(outdated.is_none(), |ui| entry::show(ui, entry, session, &program)).inner
    {
        view.entry = None;
    }
    let reveal = (view.shown_block != session.selection.block).then_some(session.selection.block).flatten();
    view.shown_block = session.selection.block;
    let exact = view.mode == Mode::Text || !view.lines.are_all_readable();
    let program = session.selection.program;
    let lit: Vec<usize> = session.lit().blocks.iter().filter(|b| b.program == program).map(|b| b.block).collect();
    let shown = Shown { exact, current: session.selection.block, lit: &lit, search: &view.search };
    let pointed = view.lines.show(ui, &shown, reveal);
    let hovered = pointed.hovered.map(|block| Hovered::Block(BlockRef { program, block }));
    requests.hovered = requests.hovered.or(hovered);
    if let Some(block) = pointed.clicked {
        session.selection.block = Some(block);
        view.shown_block = Some(block);
        requests.actions.push(Action::ShowBlock);
    }
    dragged
}

fn tools(ui: &mut Ui, view: &mut ProgramView, session: &mut Session, program: &ProgramText) {
    let search = egui::TextEdit::singleline(&mut view.search).hint_text("search").desired_width(110.0);
    let response = ui.add(search);
    response.widget_info(|| {
        let mut info = egui::WidgetInfo::text_edit(true, "", &view.search, "search");
        info.label = Some("Search in the program".to_owned());
        info
    });
    if response.changed() || (response.lost_focus() && ui.input(|i| i.key_pressed(egui::Key::Enter))) {
        let after = if response.changed() { 0 } else { session.selection.block.unwrap_or(0) };
        if let Some(block) = view.lines.find(&view.search, after) {
            session.selection.block = Some(block);
        }
    }
    let mut edit = view.mode == Mode::Edit;
    if toggle(ui, &mut edit, "edit").on_hover_text("Edit the text by hand").clicked() {
        view.mode = if edit { Mode::Edit } else { Mode::Text };
        view.gesture = None;
    }
    if view.mode != Mode::Edit {
        let mut exact = view.mode == Mode::Text;
        if !view.lines.is_of_words()
            && toggle(ui, &mut exact, "characters").on_hover_text("Show every character as it is sent").clicked()
        {
            view.mode = if exact { Mode::Text } else { Mode::Instructions };
        }
        if view.lines.are_all_readable()
            && link(ui, "+ Insert").on_hover_text("Enter an instruction after the current one").clicked()
        {
            view.entry = Some(EntryView::after(session, &program.text));
        }
    }
    if program.edited {
        if link(ui, "revert").on_hover_text("Go back to the program as generated").clicked() {
            session.put_by_hand(&format!("revert {}", program.name), None, &program.name, None);
        }
        let colors = Colors::of(ui.visuals());
        ui.label(RichText::new("edited by hand").color(colors.plot.unreachable));
    }
    let blocks = view.lines.blocks();
    let limit = session.derived().and_then(|d| d.machine.as_ref().map(|m| m.limits.blocks_per_program));
    let of = limit.map(|l| format!(" of {l}")).unwrap_or_default();
    let colors = Colors::of(ui.visuals());
    let what = if view.lines.is_of_words() { "blocks" } else { "pages" };
    ui.label(theme::quiet(format!("{blocks} {what}{of}"), colors));
    names(ui, session, &program.name);
}

/// The programs of the clamping side by side.
fn names(ui: &mut Ui, session: &mut Session, present: &str) {
    let names: Vec<String> = session.programs().iter().map(|p| p.name.clone()).collect();
    for (index, name) in names.iter().enumerate().rev() {
        let mut on = name == present;
        if toggle(ui, &mut on, name).clicked() {
            session.selection.program = index;
            session.selection.block = None;
        }
    }
}
