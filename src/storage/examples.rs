//! Example documents that come with the program.

use crate::document::Kind;

/// A document that comes with the program.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Example {
    /// Name of the document.
    pub name: &'static str,
    /// What it describes.
    pub kind: Kind,
    /// One line for people.
    pub description: &'static str,
    /// The document as saved, to be read by [`super::document_from_text`].
    pub text: &'static str,
}

/// The examples in the order in which they are shown.
#[must_use]
pub const fn examples() -> &'static [Example] {
    &[
        Example {
            name: "QUEEN",
            kind: Kind::TurnedPart,
            description: "Chess queen: arcs, a neck and a crown from 26.2 mm aluminium",
            text: include_str!("../../assets/examples/queen.turn"),
        },
        Example {
            name: "MASTER",
            kind: Kind::TurnedPart,
            description: "Test piece with every kind of section: arcs, parabola, tapers, M12 thread, ball end",
            text: include_str!("../../assets/examples/master.turn"),
        },
        Example {
            name: "KNOB",
            kind: Kind::TurnedPart,
            description: "Ball handle knob: a ball on a neck that hollows out to a flange",
            text: include_str!("../../assets/examples/knob.turn"),
        },
        Example {
            name: "STUD",
            kind: Kind::TurnedPart,
            description: "Shouldered stud M12 × 1.75 in steel with run-out groove and chamfer",
            text: include_str!("../../assets/examples/stud.turn"),
        },
        Example {
            name: "SPIGOT",
            kind: Kind::TurnedPart,
            description: "Flanged spigot in inches, machined at both ends",
            text: include_str!("../../assets/examples/spigot.turn"),
        },
        Example {
            name: "1470b-2T",
            kind: Kind::TurnedPart,
            description: "Top form-roll of 1983, turned between centres by the published cycles with four tools",
            text: include_str!("../../assets/examples/roll-top.turn"),
        },
        Example {
            name: "1470b",
            kind: Kind::RollSet,
            description: "The published section of 1983: three stations, eight rolls, two of them edited",
            text: include_str!("../../assets/examples/1470b.turn"),
        },
        Example {
            name: "U-CHANNEL",
            kind: Kind::RollSet,
            description: "Channel 80 × 30 × 2 in seven stations, side rolls where the legs stand up",
            text: include_str!("../../assets/examples/u-channel.turn"),
        },
        Example {
            name: "HAT",
            kind: Kind::RollSet,
            description: "Hat profile of 1.5 mm in eight stations, side rolls outside the legs",
            text: include_str!("../../assets/examples/hat.turn"),
        },
        Example {
            name: "UNSYMMETRICAL",
            kind: Kind::RollSet,
            description: "Unequal section listed from its left edge, six stations, a roll on one side",
            text: include_str!("../../assets/examples/unsymmetrical.turn"),
        },
        Example {
            name: "LIPPED-C",
            kind: Kind::RollSet,
            description: "Lipped channel of 1.2 mm in eight stations; in the last ones the lips overhang",
            text: include_str!("../../assets/examples/lipped-c.turn"),
        },
        Example {
            name: "CONE",
            kind: Kind::Shell,
            description: "Flow-turned 30° cone of the tests of 1988, wall halved by the sine law",
            text: include_str!("../../assets/examples/cone.turn"),
        },
        Example {
            name: "PARABOLA",
            kind: Kind::Shell,
            description: "The parabola of 1988, spun in three passes with its wall kept",
            text: include_str!("../../assets/examples/parabola.turn"),
        },
        Example {
            name: "DISH",
            kind: Kind::Shell,
            description: "Reflector dish, a paraboloid of 60 mm focal length in 1.2 mm sheet",
            text: include_str!("../../assets/examples/dish.turn"),
        },
    ]
}

/// The examples of one kind.
pub fn examples_of(kind: Kind) -> impl Iterator<Item = &'static Example> {
    examples().iter().filter(move |example| example.kind == kind)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::Content;
    use crate::machine::Catalog;
    use crate::part::SectionKind;
    use crate::storage::{document_from_text, document_to_text};

    #[test]
    fn every_example_opens_and_is_written_as_it_would_be_saved() {
        for example in examples() {
            let document = document_from_text(example.name, example.text).unwrap();
            assert_eq!((document.name.as_str(), document.content.kind()), (example.name, example.kind));
            assert_eq!(document_to_text(&document).unwrap(), example.text, "{}", example.name);
        }
    }

    #[test]
    fn every_part_is_within_the_limits_of_its_machine_and_material_table() {
        let catalog = Catalog::shipped();
        for example in examples_of(Kind::TurnedPart) {
            let document = document_from_text(example.name, example.text).unwrap();
            let Content::TurnedPart(part) = &document.content else { unreachable!("a turned part") };
            let limits = catalog.machine(&part.machine).unwrap().limits;
            assert_eq!(catalog.material(&part.material, document.unit).unwrap().unit, document.unit);
            let part = part.scaled(document.unit.in_mm());
            assert!(part.bar_diameter <= limits.bar_diameter_mm);
            for s in &part.sections {
                let (dz, dr) = ((s.z2 - s.z1).abs(), (s.d2 - s.d1).abs() / 2.0);
                match s.kind {
                    SectionKind::Line => {
                        assert!(dz == 0.0 || dr == 0.0 || dz.max(dr) / dz.min(dr) < limits.taper_ratio, "{s:?}");
                    }
                    SectionKind::Concave { radius } | SectionKind::Convex { radius } => {
                        assert!(
                            radius >= limits.arc_radius_min_mm && dz <= radius + 1e-9 && dr <= radius + 1e-9,
                            "{s:?}"
                        );
                    }
                    _ => {}
                }
                assert!(s.z1 >= 0.0 && s.z2 <= part.length + 1e-9 && s.d1.max(s.d2) <= part.bar_diameter, "{s:?}");
            }
        }
    }
}
