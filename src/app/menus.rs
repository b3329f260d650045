//! The line at the head of the window: menus, name of the document, verdict of the proof, Send.

use super::actions::Action;
use super::data::Kind;
use super::desk::Requests;
use super::layout::{Layout, Pane};
use super::shortcuts;
use super::theme::{self, Colors};
use super::widgets::{chip, clock, primary_button};
use crate::diagnostic::Diagnostic;
use crate::document::{Content, Kind as DocumentKind};
use crate::papers::{DrawingChoice, Paper, PaperKind};
use crate::rollform::RollDesign;
use crate::rollform::die::die_aperture;
use crate::session::{SaveState, Session, Verdict};
use crate::storage::export::{die_dxf, e_layout, roll_dxf};
use crate::units::trimmed;
use egui::{Align, Button, KeyboardShortcut, RichText, Ui};

/// Shows the line. `hindrance` is why nothing can be sent; while a rig is live its emergency stop stands here, whatever else
/// is shown.
pub(crate) fn show(
    ui: &mut Ui,
    session: Option<&Session>,
    layout: &Layout,
    (hindrance, rig_is_live): (Option<&str>, bool),
    requests: &mut Requests,
) {
    let colors = Colors::of(ui.visuals());
    egui::MenuBar::new().ui(ui, |ui| {
        ui.set_min_height(28.0);
        ui.label(theme::strong("Turnwright").size(theme::TEXT + 0.5));
        ui.add_space(8.0);
        file(ui, session, requests);
        edit(ui, session, requests);
        view(ui, layout, requests);
        machine(ui, session, hindrance, requests);
        help(ui, requests);
        if rig_is_live {
            ui.add_space(8.0);
            if super::shell::stop_button(ui) {
                requests.actions.push(Action::StopRig);
            }
        }
        if let Some(session) = session {
            name(ui, session, colors);
            ui.with_layout(egui::Layout::right_to_left(Align::Center), |ui| {
                send(ui, session, hindrance, requests);
                ui.add_space(6.0);
                what(ui, session, colors);
                ui.add_space(6.0);
                verdict(ui, session, colors, requests);
            });
        }
    });
}

fn item(ui: &mut Ui, text: &str, keys: Option<&KeyboardShortcut>, enabled: bool) -> bool {
    let mut button = Button::new(text);
    if let Some(keys) = keys {
        button = button.shortcut_text(ui.ctx().format_shortcut(keys));
    }
    ui.add_enabled(enabled, button).clicked()
}

fn file(ui: &mut Ui, session: Option<&Session>, requests: &mut Requests) {
    ui.menu_button("File", |ui| {
        if item(ui, "New part", Some(&shortcuts::NEW), true) {
            requests.actions.push(Action::New(DocumentKind::TurnedPart));
        }
        for (kind, text) in [(DocumentKind::RollSet, "New roll set"), (DocumentKind::Shell, "New shell")] {
            if item(ui, text, None, true) {
                requests.actions.push(Action::New(kind));
            }
        }
        if item(ui, "Open or import…", Some(&shortcuts::OPEN), true) {
            requests.actions.push(Action::AskOpen);
        }
        if item(ui, "Open program…", None, session.and_then(Session::program).is_some()) {
            requests.actions.push(Action::AskOpenProgram);
        }
        if item(ui, "Import cross-section…", None, true) {
            requests.actions.push(Action::AskOpenSection);
        }
        ui.separator();
        if item(ui, "Save", Some(&shortcuts::SAVE), session.is_some()) {
            requests.actions.push(Action::Save);
        }
        if item(ui, "Save as…", Some(&shortcuts::SAVE_AS), session.is_some()) {
            requests.actions.push(Action::SaveAs);
        }
        let of_set = session.and_then(|session| session.derived()?.rolls.clone());
        match (session, of_set) {
            (Some(session), Some(of_set)) => export_of_set(ui, session, &of_set.design, requests),
            _ => {
                if item(ui, "Export…", Some(&shortcuts::EXPORT), session.is_some()) {
                    requests.actions.push(Action::AskExport);
                }
            }
        }
        save_program(ui, session, requests);
        save_papers(ui, session, requests);
        ui.separator();
        if item(ui, "Start page", None, session.is_some()) {
            requests.actions.push(Action::Close);
        }
        if item(ui, "Quit", Some(&shortcuts::QUIT), true) {
            requests.actions.push(Action::Quit);
        }
    });
}

/// Contours of a set: the roll that is shown, and the aperture of the die block.
fn export_of_set(ui: &mut Ui, session: &Session, design: &RollDesign, requests: &mut Requests) {
    let unit = session.document().unit;
    let ready = session.is_designed();
    let mut file = |ui: &mut Ui, text: &str, name: String, made: &dyn Fn() -> Result<String, Diagnostic>| {
        if item(ui, text, None, ready)
            && let Ok(text) = made()
        {
            requests.actions.push(Action::AskSaveText { name, text: text.into() });
        }
    };
    ui.menu_button("Export", |ui| {
        if let Some(roll) = session.roll().and_then(|roll| design.roll(roll)) {
            let layout = || Ok(e_layout(&roll.elements));
            file(ui, &format!("{} in the published layout…", roll.name), format!("E{}.txt", roll.name), &layout);
            let drawing = || roll_dxf(&roll.elements, roll.part.stock_bore_diameter, unit);
            file(ui, &format!("{} as DXF…", roll.name), format!("{}.dxf", roll.name), &drawing);
        }
        if let Some(set) = session.document().content.roll_set() {
            let set = set.scaled(unit.in_mm());
            let aperture = || die_dxf(&die_aperture(&set, set.die_clearance_mm()), unit);
            file(ui, "Aperture of the die block as DXF…", format!("{}.die.dxf", session.document().name), &aperture);
        }
    });
}

/// Only a program of the document as it is now is saved.
fn save_program(ui: &mut Ui, session: Option<&Session>, requests: &mut Requests) {
    let program = session.and_then(Session::program);
    let outdated = session.and_then(Session::outdated);
    let name = program.map_or_else(|| "program".to_owned(), |p| p.name.clone());
    let ready = program.is_some() && outdated.is_none();
    let response = ui.add_enabled(ready, Button::new(format!("Save {name}…")));
    let response = response.on_disabled_hover_text(outdated.unwrap_or("There is no program to save yet."));
    if let Some(program) = program.filter(|_| response.clicked()) {
        let (name, text) = (program.name.clone(), program.text.as_str().into());
        requests.actions.push(Action::AskSaveProgram { name, text });
    }
}

/// Only papers of the document as it is now are saved.
fn save_papers(ui: &mut Ui, session: Option<&Session>, requests: &mut Requests) {
    let outdated = session.and_then(Session::outdated);
    let ready = session.is_some() && outdated.is_none();
    ui.add_enabled_ui(ready, |ui| {
        save_on_paper(ui, "Save drawing", PaperKind::Drawing, requests);
    });
    let response = ui.add_enabled(ready, Button::new("Save setup sheet…"));
    let response = response.on_disabled_hover_text(outdated.unwrap_or("There is no part yet."));
    if response.clicked() {
        requests.actions.push(Action::AskSavePapers(PaperKind::SetupSheet));
    }
    save_strip_papers(ui, session.filter(|_| ready), requests);
}

/// Papers that only a set of form-rolls has.
fn save_strip_papers(ui: &mut Ui, session: Option<&Session>, requests: &mut Requests) {
    if session.is_none_or(|s| s.document().content.roll_set().is_none()) {
        return;
    }
    save_on_paper(ui, "Save section drawing", PaperKind::Section, requests);
    save_on_paper(ui, "Save templates", PaperKind::Templates, requests);
    save_on_paper(ui, "Save drawings of the stations", PaperKind::Stations, requests);
    if item(ui, "Save parts list…", None, true) {
        requests.actions.push(Action::AskSavePapers(PaperKind::PartsList));
    }
}

/// Papers of a size of one's own, or of the smallest that fits.
fn save_on_paper(ui: &mut Ui, text: &str, kind: fn(DrawingChoice) -> PaperKind, requests: &mut Requests) {
    ui.menu_button(text, |ui| {
        let sizes = Paper::ALL.into_iter().map(|size| (format!("{}…", size.name()), Some(size)));
        for (text, paper) in std::iter::once(("Smallest paper that fits…".to_owned(), None)).chain(sizes) {
            if item(ui, &text, None, true) {
                requests.actions.push(Action::AskSavePapers(kind(DrawingChoice { paper, scale: None })));
            }
        }
    });
}

fn edit(ui: &mut Ui, session: Option<&Session>, requests: &mut Requests) {
    ui.menu_button("Edit", |ui| {
        let undo = session.and_then(|s| s.history().undo_label());
        let redo = session.and_then(|s| s.history().redo_label());
        let text = |verb: &str, label: Option<&str>| label.map_or_else(|| verb.to_owned(), |l| format!("{verb} {l}"));
        if item(ui, &text("Undo", undo), Some(&shortcuts::UNDO), undo.is_some()) {
            requests.actions.push(Action::Undo);
        }
        if item(ui, &text("Redo", redo), Some(&shortcuts::REDO), redo.is_some()) {
            requests.actions.push(Action::Redo);
        }
    });
}

fn view(ui: &mut Ui, layout: &Layout, requests: &mut Requests) {
    ui.menu_button("View", |ui| {
        for &pane in layout.panes() {
            let mut shown = layout.is_shown(pane);
            if ui.checkbox(&mut shown, pane.title()).clicked() {
                requests.actions.push(Action::TogglePane(pane));
            }
        }
        if ui.button("Reset panels").clicked() {
            requests.actions.push(Action::ResetLayout);
        }
        ui.separator();
        for (theme, text) in [
            (egui::ThemePreference::Light, "Light"),
            (egui::ThemePreference::Dark, "Dark"),
            (egui::ThemePreference::System, "As the system"),
        ] {
            if ui.radio(ui.ctx().options(|o| o.theme_preference) == theme, text).clicked() {
                requests.actions.push(Action::Theme(theme));
            }
        }
        ui.separator();
        for (step, text) in [(1, "Zoom in"), (-1, "Zoom out"), (0, "Normal size")] {
            if ui.button(text).clicked() {
                requests.actions.push(Action::Zoom(step));
            }
        }
    });
}

fn name(ui: &mut Ui, session: &Session, colors: &Colors) {
    ui.add_space(4.0);
    ui.label(name_of(session));
    if session.save_state() != SaveState::Saved && session.has_unsaved_work() {
        let (rect, response) = ui.allocate_exact_size(egui::vec2(8.0, 8.0), egui::Sense::hover());
        ui.painter().circle_filled(rect.center(), 3.5, colors.plot.wrong);
        response.on_hover_text("Not saved");
    }
}

/// Name of the document's file, or of the part.
pub(crate) fn name_of(session: &Session) -> String {
    let file = session.path().and_then(|p| p.file_name()).map(|n| n.to_string_lossy().into_owned());
    file.unwrap_or_else(|| session.document().name.clone())
}

fn machine(ui: &mut Ui, session: Option<&Session>, hindrance: Option<&str>, requests: &mut Requests) {
    ui.menu_button("Machine", |ui| {
        let ready = session.is_some() && hindrance.is_none();
        if item(ui, "Send the program", Some(&shortcuts::SEND), ready) {
            requests.actions.push(Action::Send);
        }
        if item(ui, "Transfer panel", None, session.is_some()) {
            requests.actions.push(Action::ShowPane(Pane::Transfer));
        }
        ui.separator();
        for (kind, text) in [(Kind::Tools, "Tools…"), (Kind::Machines, "Machines…"), (Kind::Materials, "Materials…")]
        {
            if item(ui, text, None, true) {
                let key = session.filter(|_| kind == Kind::Machines).map(|s| s.part().machine.clone());
                requests.actions.push(Action::EditData(kind, key));
            }
        }
    });
}

fn help(ui: &mut Ui, requests: &mut Requests) {
    ui.menu_button("Help", |ui| {
        if item(ui, "Keyboard", Some(&shortcuts::HELP), true) {
            requests.actions.push(Action::Shortcuts);
        }
        ui.separator();
        ui.label(format!("Turnwright {}", env!("CARGO_PKG_VERSION")));
    });
}

fn send(ui: &mut Ui, session: &Session, hindrance: Option<&str>, requests: &mut Requests) {
    let machine = session.derived().and_then(|d| d.machine.as_ref().map(|m| m.id.to_uppercase()));
    let text = format!("Send to {}", machine.unwrap_or_else(|| "the lathe".to_owned()));
    let button = primary_button(ui, &text, hindrance.is_none());
    let button = match hindrance {
        Some(reason) => button.on_disabled_hover_text(reason),
        None => button,
    };
    if button.clicked() {
        requests.actions.push(Action::Send);
    }
}

/// Machine, bar and material in a few words.
fn what(ui: &mut Ui, session: &Session, colors: &Colors) {
    let part = session.part();
    let unit = session.document().unit;
    let (machine, size, material) = match &session.document().content {
        Content::Shell(shell) => (&shell.machine, shell.blank.thickness, &shell.material),
        // No roll is shown yet: the strip says more than a blank of no diameter.
        Content::RollSet(set) if part.sections.is_empty() => (&set.machine, set.section.thickness, &set.strip.name),
        _ => (&part.machine, part.bar_diameter, &part.material),
    };
    let size = trimmed(size, unit.decimals());
    let text = format!("{} · {size} {} {}", machine.to_uppercase(), unit.symbol(), material.to_lowercase());
    ui.label(theme::quiet(text, colors));
}

fn verdict(ui: &mut Ui, session: &Session, colors: &Colors, requests: &mut Requests) {
    let rolls = session.rolls_proved().map(|(proved, all)| format!("{proved} of {all} rolls"));
    let (text, color, ground) = match session.verdict() {
        Verdict::Pending => ("Proving…".to_owned(), colors.plot.quiet, colors.inset),
        Verdict::NoProgram => ("No program".to_owned(), colors.plot.quiet, colors.inset),
        Verdict::Proved { time_s, blocks } => {
            let what = if session.is_in_pages() { "pages" } else { "blocks" };
            (format!("✔ Proved · {} · {blocks} {what}", clock(time_s)), colors.good, colors.good_ground)
        }
        Verdict::Failed { errors: 1 } => ("✗ 1 error".to_owned(), colors.plot.wrong, colors.wrong_ground),
        Verdict::Failed { errors } => (format!("✗ {errors} errors"), colors.plot.wrong, colors.wrong_ground),
    };
    let text = rolls.map_or_else(|| text.clone(), |rolls| format!("{text} · {rolls}"));
    if chip(ui, RichText::new(text).color(color), ground).on_hover_text("Show what the proof says").clicked() {
        requests.actions.push(Action::ShowPane(Pane::Problems));
    }
}
