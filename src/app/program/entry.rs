//! Entering an instruction as on the control's keypad: the kind, then one field after the other, the previous value
//! offered.

use crate::app::theme::{self, Colors};
use crate::app::widgets::{choice, link};
use crate::post::orac::write::Entry;
use crate::post::orac::{Instruction, Kind, compress, pages_text};
use crate::proof::ProgramText;
use crate::session::Session;
use egui::{Key, RichText, TextEdit, Ui};

/// An instruction that is being entered.
pub(super) struct EntryView {
    entry: Option<Entry>,
    after: usize,
    kind: Kind,
    text: String,
    refusal: Option<String>,
    take_focus: bool,
}

impl EntryView {
    /// Begins after the current block, or before the program's last one.
    pub(super) fn after(session: &Session, text: &str) -> Self {
        let (instructions, _) = compress(text, "");
        let after = session.selection.block.unwrap_or(instructions.len().saturating_sub(1)).min(instructions.len());
        let limits = session.derived().and_then(|d| d.machine.as_ref().map(|m| m.limits));
        let entry = limits.map(|limits| {
            let mut entry = Entry::new(limits);
            instructions.iter().take(after).for_each(|i| entry.remember(i));
            entry
        });
        Self { entry, after, kind: Kind::Ptp, text: String::new(), refusal: None, take_focus: true }
    }
}

/// Shows the entry; true when it is over.
pub(super) fn show(ui: &mut Ui, view: &mut EntryView, session: &mut Session, program: &ProgramText) -> bool {
    let mut over = false;
    let mut made = None;
    ui.horizontal(|ui| {
        let colors = Colors::of(ui.visuals());
        ui.label(theme::quiet(format!("After {}:", view.after), colors));
        let Some(entry) = &mut view.entry else {
            over = true;
            return;
        };
        match entry.prompt() {
            None => {
                let all: Vec<(Kind, String)> = Kind::ALL.iter().map(|k| (*k, k.heading().to_owned())).collect();
                if let Some(kind) = choice(ui, "Instruction", &view.kind, &all, 210.0) {
                    view.kind = kind;
                }
                if ui.button("Enter").clicked() {
                    made = entry.choose(view.kind);
                    view.take_focus = true;
                }
            }
            Some(prompt) => {
                ui.label(format!("{} {}", prompt.kind.word(), prompt.field.label()));
                let hint = prompt.previous.clone().unwrap_or_default();
                let response = ui.add(TextEdit::singleline(&mut view.text).hint_text(hint).desired_width(90.0));
                response.widget_info(|| {
                    let mut info = egui::WidgetInfo::text_edit(true, "", &view.text, "");
                    info.label = Some(format!("Value of {}", prompt.field.label()));
                    info
                });
                if std::mem::take(&mut view.take_focus) {
                    response.request_focus();
                }
                ui.label(theme::quiet(format!("{} to {}", prompt.lowest, prompt.highest), colors));
                if response.lost_focus() && ui.input(|i| i.key_pressed(Key::Enter)) {
                    match entry.answer(&view.text) {
                        Ok(instruction) => {
                            made = instruction;
                            view.text.clear();
                            view.refusal = None;
                        }
                        Err(refusal) => view.refusal = Some(refusal.to_string()),
                    }
                    view.take_focus = true;
                }
                if link(ui, "back").clicked() {
                    entry.back();
                    view.refusal = None;
                }
            }
        }
        if let Some(refusal) = &view.refusal {
            ui.label(RichText::new(refusal).color(colors.plot.wrong));
        }
        over |= link(ui, "done").clicked();
    });
    if let Some(instruction) = made {
        insert(session, program, view.after, instruction);
        view.after += 1;
        session.selection.block = Some(view.after);
    }
    over
}

fn insert(session: &mut Session, program: &ProgramText, after: usize, instruction: Instruction) {
    let present = session.text_by_hand(&program.name).unwrap_or(&program.text);
    let (mut instructions, _) = compress(present, &program.name);
    instructions.insert(after.min(instructions.len()), instruction);
    let (name, text) = (&program.name, pages_text(&instructions));
    let label = format!("insert {} into {name}", instruction.kind().word());
    session.put_by_hand(&label, None, name, Some(text));
}
