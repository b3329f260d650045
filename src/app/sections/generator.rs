//! Which generator makes the program, and the choices that belong to it.

use super::stock::Grid;
use crate::app::widgets::{choice, form_label, length_field, remark};
use crate::document::{Generator, ParabolaCut};
use crate::session::Session;
use crate::units::Unit;
use egui::Ui;

/// Distance that arcs may keep from a parabola until another is chosen, mm.
const ARC_TOLERANCE_MM: f64 = 0.01;

/// The generators by name.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum By {
    Oracap,
    Cycles,
    Planned,
}

impl By {
    const fn of(generator: &Generator) -> Self {
        match generator {
            Generator::Oracap { .. } => Self::Oracap,
            Generator::Cycles { .. } => Self::Cycles,
            Generator::Planned { .. } => Self::Planned,
        }
    }

    /// The generator with its usual choices.
    fn usual(self) -> Generator {
        match self {
            Self::Oracap => Generator::default(),
            Self::Cycles => Generator::Cycles { instructions: Vec::new() },
            Self::Planned => Generator::Planned { separate_programs: false },
        }
    }
}

/// The choice of the generator.
pub(super) fn by(grid: Grid, ui: &mut Ui, session: &mut Session, generator: &Generator) {
    form_label(ui, "Made by", grid.label);
    let all = [(By::Oracap, "ORACAP"), (By::Cycles, "cycles"), (By::Planned, "planner")];
    let all = all.map(|(by, name)| (by, name.to_owned()));
    if let Some(by) = choice(ui, "Made by", &By::of(generator), &all, grid.field) {
        session.edit_part("generator", None, |part| part.generator = by.usual());
    }
}

/// What can be chosen of the generator that is set.
pub(super) fn choices(grid: Grid, ui: &mut Ui, session: &mut Session, generator: &Generator, unit: Unit) {
    match *generator {
        Generator::Oracap { parabolas, optimize } => oracap(grid, ui, session, parabolas, optimize, unit),
        Generator::Cycles { ref instructions } => {
            let count = instructions.len();
            let are = if count == 1 { "instruction says" } else { "instructions say" };
            remark(
                ui,
                &format!(
                    "{count} {are} which sections are cut, with which tool and how. They are edited in Operations."
                ),
            );
        }
        Generator::Planned { separate_programs } => planned(grid, ui, session, separate_programs),
    }
}

fn oracap(grid: Grid, ui: &mut Ui, session: &mut Session, parabolas: ParabolaCut, optimize: bool, unit: Unit) {
    let set = |session: &mut Session, label: &str, parabolas, optimize| {
        session.edit_part(label, None, |p| p.generator = Generator::Oracap { parabolas, optimize });
    };
    Grid::row(ui, |ui| {
        if let Some(optimize) = yes_no(grid, ui, "Optimize", optimize) {
            set(session, "optimize", parabolas, optimize);
        }
        form_label(ui, "Parabolas", grid.label);
        let arcs = matches!(parabolas, ParabolaCut::Arcs { .. });
        let all = [(false, "chords".to_owned()), (true, "arcs".to_owned())];
        if let Some(arcs) = choice(ui, "Parabolas", &arcs, &all, grid.field) {
            let tolerance = ARC_TOLERANCE_MM / unit.in_mm();
            let cut = if arcs { ParabolaCut::Arcs { tolerance } } else { ParabolaCut::Chords };
            set(session, "parabolas", cut, optimize);
        }
    });
    if let ParabolaCut::Arcs { tolerance } = parabolas {
        Grid::row(ui, |ui| {
            form_label(ui, "Arcs within", grid.label);
            if let Some(typed) = length_field(ui, "Arcs within", tolerance, unit, grid.field) {
                typed.put_into_part(session, "arc tolerance", |part, tolerance| {
                    part.generator = Generator::Oracap { parabolas: ParabolaCut::Arcs { tolerance }, optimize };
                });
            }
        });
    }
}

fn planned(grid: Grid, ui: &mut Ui, session: &mut Session, separate_programs: bool) {
    Grid::row(ui, |ui| {
        if let Some(separate_programs) = yes_no(grid, ui, "By stage", separate_programs) {
            let generator = Generator::Planned { separate_programs };
            session.edit_part("a program for every stage", None, |part| part.generator = generator);
        }
        let canned = session.part().program.canned_cycles;
        if let Some(canned) = yes_no(grid, ui, "G71 cycles", canned) {
            session.edit_part("canned cycles", None, |part| part.program.canned_cycles = canned);
        }
    });
    Grid::row(ui, |ui| {
        let compensated = session.part().program.compensated_by_control;
        if let Some(compensated) = yes_no(grid, ui, "G41/G42", compensated) {
            session.edit_part("compensation", None, |part| part.program.compensated_by_control = compensated);
        }
    });
}

fn yes_no(grid: Grid, ui: &mut Ui, label: &str, value: bool) -> Option<bool> {
    form_label(ui, label, grid.label);
    let all = [(false, "no".to_owned()), (true, "yes".to_owned())];
    choice(ui, label, &value, &all, grid.field)
}
