//! The Transfer panel.

use super::{TransferPanel, log, settings};
use crate::app::actions::Action;
use crate::app::desk::Requests;
use crate::app::theme::{self, Colors};
use crate::app::widgets::{Typed, choice, clock, field, form_label, link, title_row};
use crate::machine::Machine;
use crate::session::{Session, Verdict};
use crate::transfer::Outcome;
use egui::{Align, Layout, Rect, RichText, Sense, Ui, vec2};

/// Width of the labels, points.
const LABEL: f32 = 60.0;

/// Shows the panel; true if it is dragged by its title.
pub(crate) fn show(
    ui: &mut Ui,
    panel: &mut TransferPanel,
    session: &mut Session,
    requests: &mut Requests,
    titled: bool,
) -> bool {
    let machine = session.derived().and_then(|d| d.machine.clone());
    let brief = machine.as_ref().map(|m| settings::brief(panel.profile_for(m))).unwrap_or_default();
    let mut toggled = panel.show_settings;
    let dragged = title_row(ui, titled.then_some("Transfer"), &brief, |ui| {
        crate::app::widgets::toggle(ui, &mut toggled, "settings");
    });
    panel.show_settings = toggled;
    if let Some(machine) = machine.as_ref().filter(|_| panel.show_settings) {
        settings::show(ui, panel.profile_for(machine));
    }
    if let Some(machine) = &machine {
        port(ui, panel, machine);
    }
    ui.add_space(2.0);
    progress(ui, panel, session);
    second_step(ui, panel, session, requests);
    buttons(ui, panel, session);
    received(ui, panel, session, requests);
    log::show(ui, &panel.log);
    dragged
}

fn port(ui: &mut Ui, panel: &mut TransferPanel, machine: &Machine) {
    ui.horizontal(|ui| {
        form_label(ui, "Port", LABEL);
        let mut all: Vec<(String, String)> = panel.ports.iter().map(|p| (p.name.clone(), short(&p.label))).collect();
        let listed = all.iter().any(|(name, _)| *name == panel.port);
        let typed = if listed { String::new() } else { panel.port.clone() };
        all.push((typed, "another, by path…".to_owned()));
        let width = ui.available_width();
        if let Some(port) = choice(ui, "Port", &panel.port, &all, width) {
            panel.port = port;
            panel.list_ports(machine);
        }
    });
    if !panel.ports.iter().any(|p| p.name == panel.port) {
        ui.horizontal(|ui| {
            form_label(ui, "Path", LABEL);
            let width = ui.available_width();
            let present = panel.port.clone();
            let read = |text: &str| Ok(text.trim().to_owned());
            if let Some(Typed::Left(Some(path))) = field(ui, "Port path", &present, width, read) {
                panel.port = path;
            }
        });
    }
}

/// The label of a port without the remark in brackets, for which there is no room.
fn short(label: &str) -> String {
    label.split(" (").next().unwrap_or(label).to_owned()
}

fn progress(ui: &mut Ui, panel: &TransferPanel, session: &Session) {
    let colors = Colors::of(ui.visuals());
    let p = panel.progress();
    if panel.is_running() || panel.outcome.is_some() {
        let share = p.bytes_total.filter(|t| *t > 0).map_or(0.0, |total| p.bytes as f32 / total as f32).clamp(0.0, 1.0);
        let good = panel.outcome.as_ref().is_none_or(Outcome::is_good);
        bar(
            ui,
            share,
            if good {
                colors.plot.operation(Some(crate::turning::OperationKind::FinishRight))
            } else {
                colors.plot.wrong
            },
        );
        ui.horizontal(|ui| {
            ui.label(how_far(panel));
            let eta =
                p.eta.filter(|_| panel.is_running()).map(|eta| format!("{} left", clock(eta.as_secs_f64().ceil())));
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                ui.label(theme::quiet(eta.unwrap_or_default(), colors))
            });
        });
    }
    if let Some(outcome) = &panel.outcome {
        let color = if outcome.is_good() { colors.good } else { colors.plot.wrong };
        ui.label(RichText::new(outcome.to_string()).color(color));
    } else if let Some(reason) = panel.hindrance(session).filter(|_| !panel.is_running()) {
        ui.label(theme::quiet(reason, colors));
    } else if panel.is_running() {
        ui.label(theme::quiet(format!("{}…", panel.state), colors));
    } else if let Some(program) = session.program().filter(|_| !panel.asked_to_insist) {
        let text = match session.verdict() {
            Verdict::Proved { .. } => format!("{} is ready to be sent.", program.name),
            _ => format!("The proof of {} fails: sending it takes a second step.", program.name),
        };
        ui.label(theme::quiet(text, colors));
    }
}

/// `Page 57 of 91 · 7.4 of 11.8 kB`.
fn how_far(panel: &TransferPanel) -> String {
    let p = panel.progress();
    let of = |total: Option<String>| total.map(|t| format!(" of {t}")).unwrap_or_default();
    let kilo = |bytes: usize| format!("{:.1}", bytes as f64 / 1000.0);
    format!(
        "Page {}{} · {}{} kB",
        p.block,
        of(p.blocks_total.map(|b| b.to_string())),
        kilo(p.bytes),
        of(p.bytes_total.map(kilo))
    )
}

fn bar(ui: &mut Ui, share: f32, color: egui::Color32) {
    let colors = Colors::of(ui.visuals());
    let (rect, response) = ui.allocate_exact_size(vec2(ui.available_width(), 8.0), Sense::hover());
    response.widget_info(|| {
        let mut info = egui::WidgetInfo::labeled(egui::Role::ProgressIndicator, true, "Progress of the transfer");
        info.value = Some(f64::from(share));
        info
    });
    ui.painter().rect_filled(rect, 4.0, colors.line);
    let done = Rect::from_min_size(rect.min, vec2(rect.width() * share, rect.height()));
    ui.painter().rect_filled(done, 4.0, color);
}

/// The second step before a program is sent whose proof fails.
fn second_step(ui: &mut Ui, panel: &mut TransferPanel, session: &Session, requests: &mut Requests) {
    let Verdict::Failed { errors } = session.verdict() else {
        panel.asked_to_insist = false;
        return;
    };
    if !panel.asked_to_insist {
        return;
    }
    let colors = Colors::of(ui.visuals());
    egui::Frame::new().fill(colors.wrong_ground).corner_radius(6).inner_margin(egui::Margin::same(9)).show(ui, |ui| {
        ui.set_width(ui.available_width());
        let what = if errors == 1 { "an error".to_owned() } else { format!("{errors} errors") };
        ui.label(format!(
            "The proof of this program found {what}. Sent all the same, it may spoil the part or the tool."
        ));
        ui.horizontal(|ui| {
            if ui.button("Do not send").clicked() {
                panel.asked_to_insist = false;
            }
            if ui.button(RichText::new("Send all the same").color(colors.plot.wrong)).clicked() {
                requests.actions.push(Action::SendAllTheSame);
            }
        });
    });
}

fn buttons(ui: &mut Ui, panel: &mut TransferPanel, session: &Session) {
    let idle =
        !panel.is_running() && !panel.port.trim().is_empty() && session.derived().is_some_and(|d| d.machine.is_some());
    let ctx = ui.ctx().clone();
    ui.horizontal(|ui| {
        let abort = ui.add_enabled(panel.is_running(), egui::Button::new(theme::strong("Abort")));
        if let Some(job) = panel.job.as_ref().filter(|_| abort.clicked()) {
            job.abort();
        }
        if ui.add_enabled(idle, egui::Button::new("Receive")).clicked() {
            let ctx = ctx.clone();
            panel.receive_program(session, move || ctx.request_repaint());
        }
        let why = "Send a program first; then what the control holds can be compared with it.";
        let compare = ui.add_enabled(idle && panel.sent.is_some(), egui::Button::new("Compare"));
        if compare.on_disabled_hover_text(why).clicked() {
            panel.compare(session, move || ctx.request_repaint());
        }
    });
}

/// What can be done with a program that came in.
fn received(ui: &mut Ui, panel: &TransferPanel, session: &mut Session, requests: &mut Requests) {
    let Some(Outcome::Received { text, .. }) = &panel.outcome else { return };
    let Some(name) = session.program().map(|p| p.name.clone()) else { return };
    ui.horizontal(|ui| {
        if link(ui, &format!("Use as {name}")).clicked() {
            let label = format!("received program as {name}");
            session.put_by_hand(&label, None, &name, Some(text.clone()));
        }
        if link(ui, "Save…").on_hover_text("Save it as it came into a file").clicked() {
            let (name, text) = (format!("{name}-received"), text.as_str().into());
            requests.actions.push(Action::AskSaveProgram { name, text });
        }
        if link(ui, "Copy").clicked() {
            ui.copy_text(text.clone());
        }
    });
}
