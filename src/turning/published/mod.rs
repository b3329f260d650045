//! The published generator for the ORAC: the tool taken as a point, roughing by intervals, two finishing passes.
//!
//! Source: Moore, "Computer aided programming of a CNC lathe", 1985, text 4.5.2 and the listings of its two parts. The
//! listings of roughing towards the chuck are printed and are reproduced; of the other operations only the numbers of
//! instructions are printed:
//!
//! | file | operation | queen printed | queen here | master printed | master here |
//! |---|---|---|---|---|---|
//! | 1 | roughing towards the chuck | 124 | 124 | 111 | 111 |
//! | 2 | finishing towards the chuck | 25 | 25 | 28 | 28 |
//! | 3 | not used by either part | 0 | 0 | 0 | 0 |
//! | 4 | roughing from the chuck / thread | 36 | 31 | 5 | 5 |
//! | 5 | finishing from the chuck / parting off | 18 | 14 | 7 | 7 |
//!
//! The queen's instruction 113 of file 1 starts 0.8 mm further left than the surface asks for, which no rule explains.
//! What that stroke leaves is a second area for the left-hand tool: the 5 and 4 instructions that files 4 and 5 have more.

mod envelope;
mod finish_right;
mod left;
mod part_off;
mod plan;
mod profile_lines;
mod rough_right;
mod span;
mod surface;
mod thread;

use super::{CutMove, CutterPath, Operation, OperationKind};
use crate::diagnostic::{Diagnostic, Place};
use crate::document::TurnedPart;
use crate::geometry::Point;
use crate::machine::{Machine, Material, OracData};
use crate::part::Setup;
use plan::Plan;
use surface::Surface;

/// Turret stations of the published generator (Moore 1985, text 2.3): a program calls its tools by these numbers.
mod station {
    pub(super) const RIGHT_HAND: u32 = 1;
    pub(super) const LEFT_HAND: u32 = 2;
    pub(super) const THREADING: u32 = 3;
    pub(super) const PARTING: u32 = 4;
}

/// The cutter path of one set-up. `part_mm` and `material_mm` are in mm and mm/min.
///
/// Roughing and finishing with the right-hand tool come first and are always there; left-hand roughing and finishing,
/// threads and parting off follow where the part has them. Every operation begins and ends at the datum.
#[must_use]
pub fn generate(
    setup: &Setup,
    part_mm: &TurnedPart,
    machine: &Machine,
    material_mm: &Material,
) -> (CutterPath, Vec<Diagnostic>) {
    let datum = Point::new(
        setup.length + machine.datum.axial_clearance_mm,
        setup.bar_radius + machine.datum.radial_clearance_mm,
    );
    let mut path = CutterPath { datum, program_zero_z: setup.length, operations: Vec::new() };
    let Some(figures) = material_mm.orac else { return (path, vec![no_figures(material_mm)]) };
    let mut diagnostics = check_material(&material_mm.name, &figures);
    let segments = profile_lines::segments(setup, part_mm, machine);
    let known = datum.is_finite() && segments.iter().all(|s| s.start().is_finite() && s.end().is_finite());
    if !diagnostics.is_empty() || segments.is_empty() || !known {
        return (path, diagnostics);
    }
    let surface = Surface::new(&segments).clipped(setup.machined_from_z, setup.length);
    let plan = Plan::new(surface, datum, setup.bar_radius, machine, &figures);
    path.operations = operations(&plan, setup);
    diagnostics.extend(check_stations(&path, machine));
    diagnostics.extend(check_part_off_feed(setup, machine, &material_mm.name, &figures));
    (path, diagnostics)
}

fn operations(plan: &Plan, setup: &Setup) -> Vec<Operation> {
    use OperationKind::{FinishLeft, FinishRight, PartOff, RoughLeft, RoughRight, Thread};
    let operation = |kind: OperationKind, tool, moves: Vec<CutMove>| Operation {
        kind,
        name: kind.name().to_owned(),
        tool,
        change: None,
        moves,
        recipes: Vec::new(),
    };
    let part_off = setup.part_off_width.map(|width| part_off::part_off(plan, setup.machined_from_z, width));
    let mut all = vec![
        operation(RoughRight, station::RIGHT_HAND, rough_right::rough_right(plan)),
        operation(FinishRight, station::RIGHT_HAND, finish_right::finish_right(plan)),
        operation(RoughLeft, station::LEFT_HAND, left::rough_left(plan)),
        operation(FinishLeft, station::LEFT_HAND, left::finish_left(plan)),
        operation(Thread, station::THREADING, thread::cut_threads(plan, &setup.threads)),
        operation(PartOff, station::PARTING, part_off.unwrap_or_default()),
    ];
    all.retain(|o| !o.moves.is_empty());
    all
}

fn no_figures(material: &Material) -> Diagnostic {
    let message = format!("The published generator has no feeds and depths for {}.", material.name);
    Diagnostic::error("material-figure", Place::Document, message)
        .with_hint("Choose a material of its table, or add a row `orac` to this material.")
}

/// Figures that must be above zero before anything can be cut.
fn check_material(name_of_material: &str, material: &OracData) -> Vec<Diagnostic> {
    let figures = [
        ("feed of travel", material.feed_travel, "mm/min"),
        ("feed of cutting", material.feed_cut, "mm/min"),
        ("feed of parting off", material.feed_part_off, "mm/min"),
        ("depth of roughing", material.depth_rough, "mm"),
        ("depth of finishing", material.depth_finish, "mm"),
        ("depth of threading", material.depth_thread, "mm"),
    ];
    let wrong = figures.into_iter().filter(|(_, value, _)| !(value.is_finite() && *value > 0.0));
    wrong
        .map(|(name, value, unit)| {
            let message = format!("The {name} of {name_of_material} is {value} {unit}; it must be more than 0 {unit}.");
            Diagnostic::error("material-figure", Place::Document, message)
                .with_hint("Correct the row in the material table.")
        })
        .collect()
}

fn check_stations(path: &CutterPath, machine: &Machine) -> Vec<Diagnostic> {
    let mut stations: Vec<u32> = path.operations.iter().map(|o| o.tool).collect();
    stations.dedup();
    let missing = stations.into_iter().filter(|&s| machine.tools.iter().all(|t| t.station != s));
    missing
        .map(|station| {
            let message =
                format!("The program calls turret station {station}, and {} has no tool there.", machine.name);
            Diagnostic::error("tool-missing", Place::Tool { station }, message)
                .with_hint("Add the tool to the machine file.")
        })
        .collect()
}

fn check_part_off_feed(setup: &Setup, machine: &Machine, material: &str, figures: &OracData) -> Option<Diagnostic> {
    let (feed, lowest) = (figures.feed_part_off, machine.limits.feed_min_mm_per_min);
    (setup.part_off_width.is_some() && feed < lowest).then(|| {
        let message = format!(
            "Parting off {material} needs a feed of {feed} mm/min; the lowest feed of {} is {lowest} mm/min.",
            machine.name
        );
        Diagnostic::warning("part-off-feed", Place::Tool { station: station::PARTING }, message)
            .with_hint("Part off by hand, or switch parting off out in the part's settings.")
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::{Content, Generator, ParabolaCut};
    use crate::machine::Catalog;
    use crate::part::setups;
    use crate::storage::{document_from_text, examples};
    use crate::units::Unit;

    fn example(name: &str) -> TurnedPart {
        let example = examples().iter().find(|e| e.name == name).unwrap();
        let Content::TurnedPart(part) = document_from_text(name, example.text).unwrap().content else {
            unreachable!("a turned part")
        };
        part
    }

    fn orac() -> Machine {
        Catalog::shipped().machine("orac").unwrap().clone()
    }

    fn material() -> Material {
        Catalog::shipped().material("aluminum", Unit::Mm).unwrap().in_mm()
    }

    fn surface(part: &TurnedPart) -> Surface {
        let setup = setups(part, &orac()).0.remove(0);
        Surface::new(&profile_lines::segments(&setup, part, &orac())).clipped(setup.machined_from_z, setup.length)
    }

    #[test]
    fn the_queen_has_one_area_for_the_left_hand_tool_and_some_slivers() {
        let shadows = envelope::Envelope::of(&surface(&example("QUEEN"))).shadows;
        let worth: Vec<&envelope::Shadow> = shadows.iter().filter(|s| s.is_worth_cutting()).collect();
        let [area] = worth[..] else { panic!("{} areas", worth.len()) };
        assert!((area.z1 - 36.0).abs() < 1e-9 && (area.height - 3.0).abs() < 1e-9);
        let slivers = shadows.iter().filter(|s| !s.is_worth_cutting()).map(|s| s.height);
        assert!(slivers.fold(0.0, f64::max) < 0.036);
    }

    fn kinds(path: &CutterPath) -> Vec<OperationKind> {
        path.operations.iter().map(|o| o.kind).collect()
    }

    fn made(part: &TurnedPart) -> CutterPath {
        generate(&setups(part, &orac()).0.remove(0), part, &orac(), &material()).0
    }

    #[test]
    fn operations_are_those_that_the_part_needs() {
        use OperationKind::{FinishLeft, FinishRight, PartOff, RoughLeft, RoughRight, Thread};
        assert_eq!(kinds(&made(&example("QUEEN"))), [RoughRight, FinishRight, RoughLeft, FinishLeft]);
        assert_eq!(kinds(&made(&example("MASTER"))), [RoughRight, FinishRight, Thread, PartOff]);
    }

    #[test]
    fn parabolas_may_be_cut_as_arcs() {
        let chords = example("MASTER");
        let parabolas = ParabolaCut::Arcs { tolerance: 0.005 };
        let arcs = TurnedPart { generator: Generator::Oracap { parabolas, optimize: true }, ..chords.clone() };
        let count = |part: &TurnedPart| surface(part).segments().len();
        assert_eq!(count(&chords), 17);
        assert!(count(&arcs) < 17, "{} segments", count(&arcs));
        assert_eq!(kinds(&made(&arcs)), kinds(&made(&chords)));
    }

    #[test]
    fn without_a_profile_nothing_is_cut() {
        let part = example("QUEEN");
        let mut setup = setups(&part, &orac()).0.remove(0);
        setup.profile.pieces.clear();
        assert_eq!(generate(&setup, &part, &orac(), &material()).0.operations, []);
    }

    #[test]
    fn a_missing_tool_is_named() {
        let part = example("QUEEN");
        let mut machine = orac();
        machine.tools.retain(|t| t.station != 2);
        let (_, diagnostics) = generate(&setups(&part, &machine).0.remove(0), &part, &machine, &material());
        let messages: Vec<&str> = diagnostics.iter().map(|d| d.message.as_str()).collect();
        assert_eq!(messages, ["The program calls turret station 2, and Denford ORAC has no tool there."]);
    }
}
