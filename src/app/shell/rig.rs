//! The rig, live: wanted contour, commanded steps, actual path and its error.

use super::ShellViews;
use super::chart::{chart, limit, line, names};
use super::live::{Live, Made, Pace, Setting};
use crate::app::plots::Palette;
use crate::app::theme::{self, Colors};
use crate::app::widgets::{Typed, choice, field, title_row};
use crate::spinning::control::Moves;
use crate::spinning::published::{Arithmetic, MM_PER_PULSE, MM_PER_STEP};
use crate::spinning::rig::Fault;
use egui::{Ui, vec2};

/// What the charts keep of a run that is over, so that they are not made anew in every frame.
#[derive(Debug, Default)]
pub(super) struct Charts {
    made_for: Option<(usize, usize)>,
    lines: RunLines,
}

/// The lines of one run.
#[derive(Debug, Clone, Default)]
struct RunLines {
    wanted: Vec<[f64; 2]>,
    commanded: Vec<[f64; 2]>,
    actual: Vec<[f64; 2]>,
    error: Vec<[f64; 2]>,
}

/// Shows the panel; true if it is dragged by its title.
pub(super) fn show(ui: &mut Ui, titled: bool, views: &mut ShellViews) -> bool {
    let running = views.live.is_running();
    let remark = views.live.newest().map_or_else(String::new, status);
    let dragged = title_row(ui, titled.then_some("Rig"), &remark, |ui| {
        if !running {
            which_rig(ui, &mut views.live);
        }
    });
    ui.add_enabled_ui(!running, |ui| settings(ui, &mut views.live));
    let colors = Colors::of(ui.visuals());
    for remark in &views.live.port.remarks {
        ui.label(theme::quiet(remark, colors));
    }
    let Some(made) = views.live.newest() else {
        ui.add_space(12.0);
        ui.label(theme::quiet(nothing_yet(&views.live), colors));
        return dragged;
    };
    views.charts.follow(made);
    let palette = Palette::of(ui.visuals());
    names(
        ui,
        &[
            ("wanted", palette.construction),
            ("commanded", palette.unreachable),
            ("actual path, and its error", palette.accent),
            ("limit of the error", palette.wrong),
        ],
    );
    let size = vec2((ui.available_width() - 10.0) / 2.0, ui.available_height());
    let watch = made.run.plan().watch;
    ui.horizontal(|ui| {
        chart(ui, "path", ("carriage, mm", "roller back, mm"), size, |plot| {
            let RunLines { wanted, commanded, actual, .. } = views.charts.lines.clone();
            line(plot, "wanted", wanted, palette.construction, 1.2);
            line(plot, "commanded", commanded, palette.unreachable, 1.0);
            line(plot, "actual", actual, palette.accent, 1.6);
        });
        chart(ui, "error", ("carriage, mm", "too far back, mm"), size, |plot| {
            line(plot, "error", views.charts.lines.error.clone(), palette.accent, 1.4);
            if let Some(watch) = watch {
                limit(plot, "limit", watch.limit_mm, &palette);
                limit(plot, "limit", -watch.limit_mm, &palette);
            }
        });
    });
    dragged
}

fn status(made: &Made) -> String {
    format!(
        "{} · {:.1} s · carriage {:.2} mm · roller {:.2} mm back",
        made.run.phase(),
        made.run.time_s(),
        made.run.carriage_mm(),
        made.run.retreat_mm()
    )
}

fn nothing_yet(live: &Live) -> String {
    live.port.name().map_or_else(
        || "No run yet. The operator's panel leads to the first one.".to_owned(),
        |port| {
            let port = if port.is_empty() { "the port" } else { port };
            format!("No run yet. The line to the rig at {port} is opened when the machine is set up, by the operator's panel.")
        },
    )
}

/// The choice between the simulated rig and those at ports.
fn which_rig(ui: &mut Ui, live: &mut Live) {
    /// Width of the choice, points.
    const WIDTH: f32 = 190.0;
    let chosen = live.port.name().map(str::to_owned);
    if let Some(rig) = choice(ui, "Which rig", &chosen, &live.port.choices(), WIDTH) {
        live.choose_rig(rig);
    }
}

/// What is chosen for the next run, side by side. A rig at a port has its own pace and its own faults.
fn settings(ui: &mut Ui, live: &mut Live) {
    let width = (ui.available_width() - 4.0 * ui.spacing().item_spacing.x) / 5.0;
    let on_line = live.port.name().is_some();
    ui.horizontal(|ui| {
        if on_line {
            port_path(ui, live, 2.0 * width + ui.spacing().item_spacing.x);
        } else {
            let setting = &mut live.setting;
            let pace = [(Pace::Real, "real time"), (Pace::Tenfold, "10 times as fast"), (Pace::AtOnce, "at once")];
            pick(ui, "Pace", &mut setting.pace, &pace, width);
            let moves = [(Moves::Absolute, "absolute moves"), (Moves::Relative, "relative moves")];
            pick(ui, "Moves", &mut setting.moves, &moves, width);
        }
        let setting = &mut live.setting;
        let bits = [(Arithmetic::Exact, "exact"), (Arithmetic::AsPublished, "16 bits")];
        pick(ui, "Arithmetic", &mut setting.arithmetic, &bits, width);
        let watched = [(false, "path watched"), (true, "not watched")];
        pick(ui, "Watch", &mut setting.unwatched, &watched, width);
        if !on_line {
            fault(ui, setting, width);
        }
    });
}

fn fault(ui: &mut Ui, setting: &mut Setting, width: f32) {
    let names = Fault::all().map(|fault| (Some(fault), fault.to_string()));
    let mut faults = vec![(None, "no fault".to_owned())];
    faults.extend(names);
    if let Some(fault) = choice(ui, "Fault", &setting.fault, &faults, width) {
        setting.fault = fault;
    }
}

/// The port by its path, in the place of what only the simulated rig has.
fn port_path(ui: &mut Ui, live: &mut Live, width: f32) {
    let present = live.port.name().unwrap_or_default().to_owned();
    let read = |text: &str| Ok(text.trim().to_owned());
    if let Some(Typed::Left(Some(path))) = field(ui, "Path of the rig's port", &present, width, read) {
        live.choose_rig(Some(path));
    }
}

fn pick<T: PartialEq + Copy>(ui: &mut Ui, name: &str, present: &mut T, all: &[(T, &str)], width: f32) {
    let all: Vec<(T, String)> = all.iter().map(|(value, text)| (*value, (*text).to_owned())).collect();
    if let Some(chosen) = choice(ui, name, present, &all, width) {
        *present = chosen;
    }
}

impl Charts {
    fn follow(&mut self, made: &Made) {
        let key = (made.number, made.run.actual().len());
        if self.made_for != Some(key) {
            self.lines = RunLines::of(made);
            self.made_for = Some(key);
        }
    }
}

impl RunLines {
    fn of(made: &Made) -> Self {
        let plan = made.run.plan();
        let at = |pulses: u32, steps: f64| [f64::from(pulses) * MM_PER_PULSE, steps * MM_PER_STEP];
        let wanted = std::iter::once([0.0, 0.0]).chain(plan.targets.iter().map(|t| at(t.pulses, f64::from(t.steps))));
        let commanded = made.run.actual().iter().map(|p| [p.carriage_mm, p.driven_mm]);
        let actual = made.run.actual().iter().map(|p| [p.carriage_mm, p.retreat_mm]);
        let error = made.run.actual().iter().map(|p| [p.carriage_mm, p.error_mm(plan)]);
        Self {
            wanted: wanted.collect(),
            commanded: commanded.collect(),
            actual: actual.collect(),
            error: error.collect(),
        }
    }
}
