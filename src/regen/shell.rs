//! A flow-turned shell: former, wall and roller path to programs and proofs.

use super::turned_part::{no_such_machine, stray_overrides};
use super::{Derived, Stage, file_stem};
use crate::cancel::{Cancel, Cancelled};
use crate::diagnostic::{Diagnostic, Place, Severity};
use crate::document::{Document, RigChoices, Roller, Shell};
use crate::machine::{self, Catalog, Machine, ToolOutline};
use crate::post::{self, PostOutput};
use crate::proof::ProgramText;
use crate::spinning::interpolation::{self, SetPoint};
use crate::spinning::path::{self, RollerPath};
use crate::spinning::proof::{self, ShellProof, ShellProofInput};
use crate::spinning::{self, ShellShape, program};
use crate::turning::CutterPath;
use crate::units::Unit;
use std::collections::BTreeMap;
use std::sync::Arc;

/// Everything that follows from a shell. Part space, z = 0 at the chuck's face, mm.
#[derive(Debug, Clone, PartialEq)]
pub struct ShellDerived {
    /// Name that files begin with.
    pub name: String,
    /// The design in mm.
    pub shell: Arc<Shell>,
    /// Former, wall and blank.
    pub shape: Arc<ShellShape>,
    /// Passes of the roller's nose centre.
    pub path: Arc<RollerPath>,
    /// Set points of the rig along the last pass.
    pub set_points: Arc<Vec<SetPoint>>,
    /// Programs as generated; none where the machine cannot be programmed.
    pub post: Arc<PostOutput>,
    /// The programs as they will be sent.
    pub programs: Arc<Vec<ProgramText>>,
    /// Proof of the programs.
    pub proof: Arc<ShellProof>,
}

type Tools = BTreeMap<u32, ToolOutline>;

/// What the rules look at; a design of impossible figures has no shape.
type ChecksInput = (Shell, Unit, Arc<Option<Arc<ShellShape>>>);

/// A machine with the outlines of its tools.
type Known = (Arc<Machine>, Arc<Tools>);

/// What programs are made from.
type PostInput = (String, Arc<CutterPath>, post::Header, Unit, Arc<Machine>);

/// The stages of a shell.
#[derive(Debug, Default)]
pub(super) struct ShellCache {
    machine: Stage<(Machine, Vec<machine::Tool>), Known>,
    shape: Stage<Shell, Option<Arc<ShellShape>>>,
    checks: Stage<ChecksInput, Vec<Diagnostic>>,
    path: Stage<(Shell, Arc<ShellShape>), RollerPath>,
    set_points: Stage<(Arc<RollerPath>, u32), Vec<SetPoint>>,
    post: Stage<PostInput, PostOutput>,
    proof: Stage<ShellProofInput, ShellProof>,
}

/// Makes everything that follows from `shell`, which is the content of `document`.
pub(super) fn regenerate(
    document: &Arc<Document>,
    shell: &Shell,
    catalog: &Catalog,
    cache: &mut ShellCache,
    cancel: &Cancel,
) -> Result<Derived, Cancelled> {
    cancel.check()?;
    let shell_mm = shell.scaled(document.unit.in_mm());
    let shape = cache.shape.get(geometry_only(&shell_mm), |shell| spinning::shape(shell).map(Arc::new));
    let generated = Shell { overrides: BTreeMap::new(), ..shell_mm.clone() };
    let checks = cache.checks.get((generated, document.unit, Arc::clone(&shape)), |(shell, unit, shape)| {
        spinning::check(shell, shape.as_ref().as_deref(), *unit)
    });
    let mut diagnostics = (*checks).clone();
    let Some(machine) = catalog.machine(&shell.machine) else {
        diagnostics.push(no_such_machine(&shell.machine, catalog));
        return Ok(Derived::only(document, diagnostics));
    };
    let known = cache.machine.get((machine.clone(), catalog.tools.clone()), |(machine, _)| {
        (Arc::new(machine.clone()), Arc::new(machine::outlines(machine, catalog)))
    });
    let (machine, tools) = (Arc::clone(&known.0), Arc::clone(&known.1));
    let derived = |shell: Option<Arc<ShellDerived>>, diagnostics| Derived {
        machine: Some(Arc::clone(&machine)),
        shell,
        ..Derived::only(document, diagnostics)
    };
    let Some(shape) = shape.as_ref() else { return Ok(derived(None, diagnostics)) };
    // A program for figures that are none would only be proved wrong; the drawing stays alive beside the messages.
    let usable = !checks.iter().any(|d| d.severity == Severity::Error);
    let path = cache.path.get((without_rig(&shell_mm), Arc::clone(shape)), |(shell, shape)| path::path(shell, shape));
    let set_points = set_points(&path, &shell_mm, cache);
    let name = file_stem(&document.name);
    let cutter = Arc::new(program::cutter_path(&shell_mm, shape, &path, &machine));
    let header = program::header(&document.name, &shell_mm, shape);
    let program_zero_z = cutter.program_zero_z;
    let post = if usable && !path.passes.is_empty() {
        cache.post.get((name.clone(), cutter, header, document.unit, Arc::clone(&machine)), post_of)
    } else {
        Arc::default()
    };
    diagnostics.extend(post.diagnostics.iter().cloned());
    let programs = Arc::new(with_overrides(&post, &shell_mm));
    diagnostics.extend(stray_overrides(shell_mm.overrides.keys(), programs.iter()));
    let proof = if programs.is_empty() {
        Arc::default()
    } else {
        let input = ShellProofInput {
            machine: Arc::clone(&machine),
            tools,
            programs: Arc::clone(&programs),
            program_zero_z,
            shell: without_rig(&shell_mm),
            shape: Arc::clone(shape),
        };
        cache.proof.try_get(input, |input| proof::prove(input, cancel))?
    };
    let made = ShellDerived {
        name,
        shell: Arc::new(shell_mm),
        shape: Arc::clone(shape),
        path: Arc::clone(&path),
        set_points,
        post,
        programs,
        proof,
    };
    diagnostics.extend(findings(&made));
    Ok(derived(Some(Arc::new(made)), diagnostics))
}

/// The design without what the shape does not depend on.
fn geometry_only(shell: &Shell) -> Shell {
    let nose_radius = shell.roller.nose_radius;
    let shape_only = Shell::default();
    Shell {
        former: shell.former.clone(),
        forming: shell.forming,
        blank: shell.blank.clone(),
        roller: Roller { nose_radius, ..shape_only.roller.clone() },
        ..shape_only
    }
}

/// The design without what program and proof do not depend on.
fn without_rig(shell: &Shell) -> Shell {
    Shell { rig: RigChoices::default(), overrides: BTreeMap::new(), ..shell.clone() }
}

/// The programs as they will be sent: as generated, or as edited by hand.
fn with_overrides(post: &PostOutput, shell: &Shell) -> Vec<ProgramText> {
    let text_of = |program: &post::Program| {
        let by_hand = shell.overrides.get(&program.name);
        let text = by_hand.unwrap_or(&program.text).clone();
        ProgramText { name: program.name.clone(), text, edited: by_hand.is_some() }
    };
    post.programs.iter().map(text_of).collect()
}

fn set_points(path: &Arc<RollerPath>, shell: &Shell, cache: &mut ShellCache) -> Arc<Vec<SetPoint>> {
    let input = (Arc::clone(path), shell.rig.increment_pulses);
    cache.set_points.get(input, |(path, increment)| {
        path.last().map(|pass| interpolation::set_points(&pass.contour, *increment)).unwrap_or_default()
    })
}

fn post_of((name, path, header, unit, machine): &PostInput) -> PostOutput {
    if machine.words.is_none() {
        let at = Place::Machine { id: machine.id.clone() };
        let message = format!("{} has no words for arcs and feeds per turn; no program was made.", machine.name);
        let said = Diagnostic::error("shell-machine", at, message)
            .with_hint("Choose a machine with a Fanuc control or LinuxCNC, or run the shell on the rig.");
        return PostOutput { diagnostics: vec![said], ..PostOutput::default() };
    }
    let options = post::Options { unit: *unit, ..post::Options::default() };
    post::post(name, path, &options, header, machine)
}

/// What the proof found, as messages that lead to the block.
fn findings(made: &ShellDerived) -> impl Iterator<Item = Diagnostic> + '_ {
    made.proof.findings.iter().filter(|f| f.severity != Severity::Info).map(|f| {
        let at = Place::Block { program: f.program.clone(), block: f.block };
        Diagnostic::new(f.severity, "shell-proof", at, f.message.clone())
    })
}
