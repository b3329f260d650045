//! Example parts that come with the program.

/// A document that comes with the program.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Example {
    /// Name of the part.
    pub name: &'static str,
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
            description: "Chess queen: arcs, a neck and a crown from 26.2 mm aluminium",
            text: include_str!("../../assets/examples/queen.turn"),
        },
        Example {
            name: "MASTER",
            description: "Test piece with every kind of section: arcs, parabola, tapers, M12 thread, ball end",
            text: include_str!("../../assets/examples/master.turn"),
        },
        Example {
            name: "KNOB",
            description: "Ball handle knob: a ball on a neck that hollows out to a flange",
            text: include_str!("../../assets/examples/knob.turn"),
        },
        Example {
            name: "STUD",
            description: "Shouldered stud M12 × 1.75 in steel with run-out groove and chamfer",
            text: include_str!("../../assets/examples/stud.turn"),
        },
        Example {
            name: "SPIGOT",
            description: "Flanged spigot in inches, machined at both ends",
            text: include_str!("../../assets/examples/spigot.turn"),
        },
        Example {
            name: "1470b-2T",
            description: "Top form-roll of 1983, turned between centres by the published cycles with four tools",
            text: include_str!("../../assets/examples/roll-top.turn"),
        },
    ]
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
            assert_eq!(document.name, example.name);
            assert_eq!(document_to_text(&document).unwrap(), example.text, "{}", example.name);
        }
    }

    #[test]
    fn every_example_is_within_the_limits_of_its_machine_and_material_table() {
        let catalog = Catalog::shipped();
        for example in examples() {
            let document = document_from_text(example.name, example.text).unwrap();
            let Content::TurnedPart(part) = &document.content;
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
