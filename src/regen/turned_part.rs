//! A turned part: section table to set-ups, programs and proofs.

use super::cache::{PartCache, ProgramCache, SetupCache, Tools};
use super::{CONTOUR_TOLERANCE_MM, Derived, SetupDerived, add_new, file_stem};
use crate::cancel::{Cancel, Cancelled};
use crate::diagnostic::{Diagnostic, Place};
use crate::document::{Document, Generator, PlanEdits, ProgramChoices, ThreadChoices, TurnedPart};
use crate::machine::{self, Catalog, Machine, Material};
use crate::part::{self, PartContour, Setup, ThreadSpec};
use crate::post::{self, PostOutput};
use crate::proof::{self, BoreTarget, MayCut, ProgramText, ProofInput, ProofReport, Target, Work};
use crate::turning::{self, CutterPath};
use crate::units::Unit;
use std::collections::BTreeMap;
use std::sync::Arc;

/// Makes everything that follows from `part`, which is the content of `document`.
pub(super) fn regenerate(
    document: &Arc<Document>,
    part: &TurnedPart,
    catalog: &Catalog,
    cache: &mut PartCache,
    cancel: &Cancel,
) -> Result<Derived, Cancelled> {
    let part_mm = part.scaled(document.unit.in_mm());
    let Some(machine) = catalog.machine(&part.machine).cloned().map(Arc::new) else {
        let missing = no_such_machine(&part.machine, catalog);
        return Ok(Derived::only(document, vec![missing]));
    };
    let checks =
        cache.checks.get((without_overrides(part), document.unit, Arc::clone(&machine)), |(part, unit, machine)| {
            part::check(part, *unit, machine)
        });
    let setups = cache.setups.get((geometry_only(&part_mm), Arc::clone(&machine)), |(part, machine)| {
        let (setups, diagnostics) = part::setups(part, machine);
        (setups.into_iter().map(Arc::new).collect(), diagnostics)
    });
    let mut diagnostics = (*checks).clone();
    add_new(&mut diagnostics, &setups.1);
    let known_material = catalog.material(&part.material, document.unit);
    if known_material.is_none() {
        diagnostics.push(no_such_material(part, catalog));
    }
    // With an unknown material the first of the table stands in, so that the plots stay alive beside the message.
    let Some(material) = known_material.or(catalog.materials.first()).map(Material::in_mm) else {
        return Ok(Derived { machine: Some(machine), ..Derived::only(document, diagnostics) });
    };
    let context = Context {
        name: file_stem(&document.name),
        part: Arc::new(part.clone()),
        part_mm,
        machine: Arc::clone(&machine),
        tools: Arc::new(machine::outlines(&machine, catalog)),
        material,
        unit: document.unit,
        header: post::Header::new(document, part, &machine, catalog),
    };
    cache.of_setup.resize_with(setups.0.len(), SetupCache::default);
    let mut made = Vec::with_capacity(setups.0.len());
    for (setup, stages) in setups.0.iter().zip(&mut cache.of_setup) {
        cancel.check()?;
        made.push(regenerate_setup(&context, setup, stages, &mut diagnostics, cancel)?);
    }
    diagnostics.extend(stray_overrides(part.overrides.keys(), made.iter().flat_map(|setup| setup.programs.iter())));
    let material = Some(context.material);
    Ok(Derived { machine: Some(machine), material, setups: made, ..Derived::only(document, diagnostics) })
}

/// What all set-ups of one document share.
struct Context {
    name: String,
    part: Arc<TurnedPart>,
    part_mm: TurnedPart,
    machine: Arc<Machine>,
    tools: Arc<Tools>,
    material: Material,
    unit: Unit,
    header: post::Header,
}

fn regenerate_setup(
    context: &Context,
    setup: &Arc<Setup>,
    stages: &mut SetupCache,
    diagnostics: &mut Vec<Diagnostic>,
    cancel: &Cancel,
) -> Result<SetupDerived, Cancelled> {
    let name = format!("{}{}", context.name, setup.suffix);
    let contour = stages.contour.get(setup.profile.clone(), |p| part::contour(p, CONTOUR_TOLERANCE_MM));
    let bore = stages.bore.get(setup.bore.clone(), |p| p.as_ref().map(|p| part::contour(p, CONTOUR_TOLERANCE_MM)));
    let shape = Shape { contour: &contour, bore: bore.as_ref().as_ref() };
    let reach = &mut stages.unreachable;
    let program = &mut stages.program;
    // Side by side, for neither needs the other and a drag waits for both.
    let (unreachable, proved) = rayon::join(
        || {
            reach.get((Arc::clone(setup), Arc::clone(&context.tools)), |(setup, tools)| {
                turning::unreachable(setup, tools, &context.machine)
            })
        },
        || prove_setup(context, &name, setup, shape, program, cancel),
    );
    let Proved { path, said, post, programs, proof } = proved?;
    add_new(diagnostics, &said);
    add_new(diagnostics, &post.diagnostics);
    let (part, setup, tools) = (Arc::clone(&context.part), Arc::clone(setup), Arc::clone(&context.tools));
    Ok(SetupDerived { name, part, setup, contour, bore, unreachable, path, post, programs, proof, tools })
}

/// What becomes of one clamping between its geometry and its proof.
struct Proved {
    path: Arc<CutterPath>,
    /// What the generator has to say.
    said: Vec<Diagnostic>,
    post: Arc<PostOutput>,
    programs: Arc<Vec<ProgramText>>,
    proof: Arc<ProofReport>,
}

fn prove_setup(
    context: &Context,
    name: &str,
    setup: &Arc<Setup>,
    shape: Shape<'_>,
    stages: &mut ProgramCache,
    cancel: &Cancel,
) -> Result<Proved, Cancelled> {
    let Context { part_mm, machine, tools, material, .. } = context;
    let path_input =
        (Arc::clone(setup), without_proof_settings(part_mm), Arc::clone(machine), Arc::clone(tools), material.clone());
    let generated = stages.path.get(path_input, |(setup, part_mm, machine, tools, material_mm)| {
        let (path, diagnostics) = turning::generate(&turning::Task { setup, part_mm, machine, tools, material_mm });
        (Arc::new(path), diagnostics)
    });
    let (path, said) = (Arc::clone(&generated.0), generated.1.clone());
    cancel.check()?;
    let options = post_options(part_mm, context.unit);
    let post_input = (name.to_owned(), Arc::clone(&path), options, context.header.clone(), Arc::clone(machine));
    let post = stages
        .post
        .get(post_input, |(name, path, options, header, machine)| post::post(name, path, options, header, machine));
    let programs = Arc::new(with_overrides(&post, part_mm));
    let input = ProofInput {
        machine: Arc::clone(machine),
        tools: Arc::clone(tools),
        programs: Arc::clone(&programs),
        work: Some(work_of(part_mm, setup, shape, &path, Some(material.clone()))),
    };
    let proof = stages.proof.try_get(input, |input| proof::prove(input, cancel))?;
    Ok(Proved { path, said, post, programs, proof })
}

/// What a part whose lengths are shown in `unit` asks of the post.
#[must_use]
pub const fn post_options(part: &TurnedPart, unit: Unit) -> post::Options {
    post::Options {
        optimize: matches!(part.generator, Generator::Oracap { optimize: true, .. }),
        automatic: part.automatic,
        separate_programs: matches!(part.generator, Generator::Planned { separate_programs: true }),
        unit,
        program_number: part.program.number,
        canned_cycles: part.program.canned_cycles,
        compensated_by_control: part.program.compensated_by_control,
    }
}

/// The part without the texts edited by hand, which neither checks nor generator look at.
fn without_overrides(part: &TurnedPart) -> TurnedPart {
    TurnedPart { overrides: BTreeMap::new(), ..part.clone() }
}

/// The part without what only the proof looks at, so that an edit of it reruns the proof alone.
fn without_proof_settings(part: &TurnedPart) -> TurnedPart {
    TurnedPart { form_tolerance: 0.0, program: ProgramChoices::default(), ..without_overrides(part) }
}

/// The part without what only generator, post and proof look at, so that an edit of it leaves the geometry alone.
fn geometry_only(part: &TurnedPart) -> TurnedPart {
    TurnedPart {
        material: String::new(),
        generator: Generator::default(),
        plan: PlanEdits::default(),
        threading: ThreadChoices::default(),
        program: ProgramChoices::default(),
        ..without_proof_settings(part)
    }
}

fn with_overrides(post: &PostOutput, part: &TurnedPart) -> Vec<ProgramText> {
    let text_of = |program: &crate::post::Program| match part.overrides.get(&program.name) {
        Some(text) => ProgramText { name: program.name.clone(), text: text.clone(), edited: true },
        None => ProgramText { name: program.name.clone(), text: program.text.clone(), edited: false },
    };
    post.programs.iter().map(text_of).collect()
}

/// What the programs of a clamping were proved with; `None` if the document's machine does not exist.
#[must_use]
pub fn proof_input(derived: &Derived, item: &SetupDerived) -> Option<ProofInput> {
    let part = &item.part;
    let form_tolerance_mm = part.form_tolerance * derived.document.unit.in_mm();
    let shape = Shape { contour: &item.contour, bore: item.bore.as_ref().as_ref() };
    Some(ProofInput {
        machine: Arc::clone(derived.machine.as_ref()?),
        tools: Arc::clone(&item.tools),
        programs: Arc::clone(&item.programs),
        work: Some(Work {
            form_tolerance_mm,
            ..work_of(part, &item.setup, shape, &item.path, derived.material.clone())
        }),
    })
}

/// What the finished part looks like.
#[derive(Clone, Copy)]
struct Shape<'a> {
    contour: &'a PartContour,
    bore: Option<&'a PartContour>,
}

fn work_of(part: &TurnedPart, setup: &Setup, shape: Shape<'_>, path: &CutterPath, material: Option<Material>) -> Work {
    let bore = shape.bore.map(|bore| BoreTarget {
        contour: bore.contour.clone(),
        sections: bore.sections.clone(),
        machined_from_z: setup.bored_from_z,
        may_cut: threads(&setup.bore_threads).collect(),
    });
    Work {
        stock: setup.stock.clone(),
        target: Target {
            contour: shape.contour.contour.clone(),
            sections: shape.contour.sections.clone(),
            names: section_names(part),
            machined_from_z: setup.machined_from_z,
            bore,
        },
        program_zero_z: path.program_zero_z,
        chuck_face_z: setup.chuck_face_z,
        mandrel: setup.mandrel.clone(),
        tailstock: setup.tailstock.clone(),
        material,
        form_tolerance_mm: part.form_tolerance,
        may_cut: may_cut(setup),
    }
}

/// What a row is called in a message: its type and its number in the table, `line 3`, `bore line 2`.
fn section_names(part: &TurnedPart) -> BTreeMap<u32, String> {
    let outside = (1..).zip(&part.sections).map(|(row, s)| (s.id, format!("{} {row}", s.kind.name())));
    let bore = (1..).zip(&part.bore).map(|(row, s)| (s.id, format!("bore {} {row}", s.kind.name())));
    outside.chain(bore).collect()
}

/// Threads go below the contour by design, with their run-in and run-out, and so does the parting-off.
fn may_cut(setup: &Setup) -> Vec<MayCut> {
    let groove = setup.part_off_width.map(|width| MayCut { z1: -width, z2: 0.0, radius: 0.0 });
    threads(&setup.threads).chain(groove).collect()
}

/// Where threads go beyond the contour.
fn threads(threads: &[ThreadSpec]) -> impl Iterator<Item = MayCut> {
    /// A threading point reaches this many pitches beyond the end of its thread, and comes in from further out.
    const RUN_OUT_PITCHES: f64 = 1.0;
    const RUN_IN_PITCHES: f64 = 3.0;
    threads.iter().map(|t| MayCut {
        z1: t.z1 - RUN_OUT_PITCHES * t.lead(),
        z2: t.z2 + RUN_IN_PITCHES * t.lead(),
        radius: t.base_radius,
    })
}

/// There is no machine of this name.
pub(super) fn no_such_machine(id: &str, catalog: &Catalog) -> Diagnostic {
    let known: Vec<&str> = catalog.machines.iter().map(|m| m.id.as_str()).collect();
    let at = Place::Machine { id: id.to_owned() };
    Diagnostic::error("unknown-machine", at, format!("There is no machine \"{id}\"."))
        .with_hint(format!("Choose one of {}.", known.join(", ")))
}

fn no_such_material(part: &TurnedPart, catalog: &Catalog) -> Diagnostic {
    let known: Vec<&str> = catalog.materials.iter().map(|m| m.name.as_str()).collect();
    let message = format!("There is no material \"{}\" in the material table.", part.material);
    Diagnostic::error("unknown-material", Place::Stock, message)
        .with_hint(format!("Choose one of {}.", known.join(", ")))
}

/// Texts edited by hand whose program is not there any more.
pub(super) fn stray_overrides<'a>(
    names: impl Iterator<Item = &'a String>,
    programs: impl IntoIterator<Item = &'a ProgramText>,
) -> Vec<Diagnostic> {
    let there: Vec<&str> = programs.into_iter().map(|program| program.name.as_str()).collect();
    let stray = names.filter(|name| !there.contains(&name.as_str()));
    stray
        .map(|name| {
            Diagnostic::warning(
                "override-without-program",
                Place::Document,
                format!("The text edited by hand for \"{name}\" belongs to no program of this part any more."),
            )
            .with_hint("Revert it, or rename the part back.")
        })
        .collect()
}
