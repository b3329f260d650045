//! Parts to generate programs for.

pub(crate) mod planned;

use turnwright::document::{Content, TurnedPart};
use turnwright::geometry::Point;
use turnwright::machine::{Catalog, Machine};
use turnwright::part::{Curve, Section, Setup, setups};
use turnwright::storage::{document_from_text, examples, examples_of};

/// A set-up and the part it belongs to, in mm.
pub(crate) type Part = (Setup, TurnedPart);

/// The shipped lathe.
pub(crate) fn orac() -> Machine {
    Catalog::shipped().machine("orac").unwrap().clone()
}

/// The chess queen of appendix B.
pub(crate) fn queen() -> Part {
    clamped(example("QUEEN"))
}

/// The master part of appendix D.
pub(crate) fn master() -> Part {
    clamped(example("MASTER"))
}

/// Every clamping of every shipped example for the ORAC, by name.
pub(crate) fn all_examples() -> Vec<(&'static str, Vec<Part>)> {
    let clampings = |name| {
        let part = example(name);
        setups(&part, &orac()).0.into_iter().map(|setup| (setup, part.clone())).collect()
    };
    let for_orac = |name: &&str| example(name).machine == "orac";
    examples_of(turnwright::document::Kind::TurnedPart)
        .map(|e| e.name)
        .filter(for_orac)
        .map(|name| (name, clampings(name)))
        .collect()
}

/// An example part in mm.
fn example(name: &str) -> TurnedPart {
    let example = examples().iter().find(|e| e.name == name).unwrap();
    let document = document_from_text(name, example.text).unwrap();
    let Content::TurnedPart(part) = document.content else { unreachable!("a turned part") };
    part.scaled(document.unit.in_mm())
}

fn clamped(part: TurnedPart) -> Part {
    let (mut setups, _) = setups(&part, &orac());
    (setups.remove(0), part)
}

/// A part of tapers: radius at both ends and width of each, mm; faces between them.
pub(crate) fn stepped(tapers: &[(f64, f64, f64)]) -> Part {
    let mut z = 0.0;
    let mut sections = Vec::new();
    for (id, &(r1, r2, width)) in (1..).zip(tapers) {
        sections.push(Section::line(id, z, 2.0 * r1, z + width, 2.0 * r2));
        z += width;
    }
    clamped(TurnedPart { length: z, sections, ..example("QUEEN") })
}

/// Corners of a part without curves.
pub(crate) fn corners(setup: &Setup) -> Vec<Point> {
    let ends = setup.profile.pieces.iter().filter_map(|p| match p.curve {
        Curve::Segment(segment) => Some([segment.start(), segment.end()]),
        Curve::Parabola(_) => None,
    });
    ends.flatten().collect()
}
