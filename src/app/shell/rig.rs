//! The rig, live: wanted contour, commanded steps, actual path and its error.

use super::ShellViews;
use super::chart::{chart, limit, line};
use super::live::{Made, Pace, Setting};
use crate::app::plots::Palette;
use crate::app::theme::{self, Colors};
use crate::app::widgets::{choice, title_row};
use crate::session::Session;
use crate::spinning::control::{Moves, Phase};
use crate::spinning::operator::Key;
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
pub(super) fn show(ui: &mut Ui, titled: bool, session: &Session, views: &mut ShellViews) -> bool {
    let remark = views.live.newest().map_or_else(|| "simulated".to_owned(), status);
    let dragged = title_row(ui, titled.then_some("Rig"), &remark, |ui| {
        if views.live.is_running() && super::operator::stop_button(ui) {
            views.live.press(Key::Emergency, session);
        }
    });
    let running = views.live.is_running();
    ui.add_enabled_ui(!running, |ui| settings(ui, &mut views.live.setting));
    let Some(made) = views.live.newest() else {
        let colors = Colors::of(ui.visuals());
        ui.add_space(12.0);
        ui.label(theme::quiet("No run yet. The operator's panel leads to the first one.", colors));
        return dragged;
    };
    views.charts.follow(made);
    let palette = Palette::of(ui.visuals());
    let size = vec2((ui.available_width() - 10.0) / 2.0, ui.available_height());
    let watch = made.run.controller().plan().watch;
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
    let phase = match made.run.controller().phase() {
        Phase::ToDatum => "to the datum",
        Phase::Advance => "roller advances",
        Phase::RunUp => "carriage to the tip",
        Phase::Follow => "follows the contour",
        Phase::Retract => "roller back",
        Phase::Settle => "leadscrew settles",
        Phase::Completed => "completed",
        Phase::Stopping(_) => "stopping",
        Phase::Stopped { .. } => "stopped",
    };
    format!(
        "{phase} · {:.1} s · carriage {:.2} mm · roller {:.2} mm back",
        made.run.time_s(),
        made.run.rig().carriage_mm(),
        made.run.retreat_mm()
    )
}

/// What is chosen for the next run, side by side.
fn settings(ui: &mut Ui, setting: &mut Setting) {
    let width = (ui.available_width() - 4.0 * ui.spacing().item_spacing.x) / 5.0;
    ui.horizontal(|ui| {
        let pace = [(Pace::Real, "real time"), (Pace::Tenfold, "10 times as fast"), (Pace::AtOnce, "at once")];
        pick(ui, "Pace", &mut setting.pace, &pace, width);
        let moves = [(Moves::Absolute, "absolute moves"), (Moves::Relative, "relative moves")];
        pick(ui, "Moves", &mut setting.moves, &moves, width);
        let bits = [(Arithmetic::Exact, "exact"), (Arithmetic::AsPublished, "16 bits")];
        pick(ui, "Arithmetic", &mut setting.arithmetic, &bits, width);
        let watched = [(false, "path watched"), (true, "not watched")];
        pick(ui, "Watch", &mut setting.unwatched, &watched, width);
        let names = Fault::all().map(|fault| (Some(fault), fault.to_string()));
        let mut faults = vec![(None, "no fault".to_owned())];
        faults.extend(names);
        if let Some(fault) = choice(ui, "Fault", &setting.fault, &faults, width) {
            setting.fault = fault;
        }
    });
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
        let plan = made.run.controller().plan();
        let at = |pulses: u32, steps: f64| [f64::from(pulses) * MM_PER_PULSE, steps * MM_PER_STEP];
        let wanted = std::iter::once([0.0, 0.0]).chain(plan.targets.iter().map(|t| at(t.pulses, f64::from(t.steps))));
        let commanded = made.run.actual().iter().map(|p| [p.carriage_mm, p.driven_mm]);
        let actual = made.run.actual().iter().map(|p| [p.carriage_mm, p.retreat_mm]);
        let error = made.run.actual().iter().map(|p| [p.carriage_mm, made.run.error_at(p)]);
        Self {
            wanted: wanted.collect(),
            commanded: commanded.collect(),
            actual: actual.collect(),
            error: error.collect(),
        }
    }
}
