//! The two published parts.

use turnwright::document::{Ends, Generator, TurnedPart};
use turnwright::geometry::{Contour, Point, Segment};
use turnwright::part::{
    Curve, Parabola, ParabolaAxis, Piece, PieceRole, Profile, Section, SectionKind, Setup, ThreadSpec,
};

/// A set-up and the part it belongs to.
pub(crate) type Part = (Setup, TurnedPart);

fn arc(z1: f64, d1: f64, z2: f64, d2: f64, radius: f64, convex: bool) -> Segment {
    let (a, b) = (Point::new(z1, d1 / 2.0), Point::new(z2, d2 / 2.0));
    let chord = b - a;
    let h = (radius * radius - chord.norm_squared() / 4.0).sqrt();
    let up = turnwright::geometry::Vector::new(-chord.y, chord.x) / chord.norm();
    let center = a + chord / 2.0 + up * if convex { -h } else { h };
    Segment::Arc { start: a, end: b, center, ccw: !convex }
}

fn piece(s: &Section) -> Curve {
    let (a, b) = (Point::new(s.z1, s.d1 / 2.0), Point::new(s.z2, s.d2 / 2.0));
    Curve::Segment(match s.kind {
        SectionKind::Concave { radius } => arc(s.z1, s.d1, s.z2, s.d2, radius, false),
        SectionKind::Convex { radius } => arc(s.z1, s.d1, s.z2, s.d2, radius, true),
        SectionKind::Thread { .. } => Segment::line(a, Point::new(s.z2, a.r)),
        SectionKind::ParabolaAlongX { z3, d3, chords } => {
            let (p, q) = ((b.r - a.r) / (b.z - a.z), (d3 / 2.0 - a.r) / (z3 - a.z));
            let k = (p - q) / (b.z - z3);
            let m = p - k * (a.z + b.z);
            let c = a.r - (k * a.z + m) * a.z;
            return Curve::Parabola(Parabola {
                start: a,
                end: b,
                axis: ParabolaAxis::AlongX,
                coefficients: [k, m, c],
                chords,
            });
        }
        _ => Segment::line(a, b),
    })
}

fn setup(part: &TurnedPart, sections: &[Section], threads: Vec<ThreadSpec>) -> Setup {
    let pieces = sections.iter().map(|s| Piece { curve: piece(s), section: s.id, role: PieceRole::Surface }).collect();
    Setup {
        suffix: String::new(),
        profile: Profile { pieces },
        threads,
        machined_from_z: if part.part_off { -3.0 } else { 0.0 },
        length: part.length,
        bar_radius: part.bar_diameter / 2.0,
        stock: Contour::default(),
        chuck_face_z: -10.0,
        part_off_width: part.part_off.then_some(3.0),
        turned_round: false,
    }
}

fn part(length: f64, part_off: bool, sections: Vec<Section>) -> TurnedPart {
    TurnedPart {
        machine: "orac".into(),
        material: "aluminum".into(),
        bar_diameter: 26.2,
        length,
        ends: Ends::One,
        part_off,
        automatic: false,
        generator: Generator::default(),
        form_tolerance: 0.1,
        sections,
        overrides: std::collections::BTreeMap::default(),
    }
}

fn row(id: u32, z1: f64, d1: f64, z2: f64, d2: f64, kind: SectionKind) -> Section {
    Section { id, z1, d1, z2, d2, kind }
}

/// The chess queen of appendix B.
pub(crate) fn queen() -> Part {
    let convex = |radius| SectionKind::Convex { radius };
    let concave = |radius| SectionKind::Concave { radius };
    let line = SectionKind::Line;
    let sections = vec![
        row(1, 0.0, 25.4, 2.0, 25.4, line.clone()),
        row(2, 2.0, 24.0, 4.0, 25.0, convex(2.0)),
        row(3, 4.0, 25.0, 14.0, 16.2, concave(10.0)),
        row(4, 14.0, 16.2, 34.0, 7.5, concave(30.0)),
        row(5, 34.0, 7.5, 36.0, 13.5, convex(5.0)),
        row(6, 36.0, 17.5, 38.6, 10.2, convex(5.0)),
        row(7, 38.6, 10.2, 41.0, 10.2, line.clone()),
        row(8, 41.0, 10.2, 41.8, 11.5, convex(2.0)),
        row(9, 41.8, 11.5, 42.7, 10.2, convex(2.0)),
        row(10, 42.7, 10.2, 50.4, 16.2, concave(10.0)),
        row(11, 50.4, 16.2, 53.5, 12.9, line),
        row(12, 53.5, 4.0, 56.0, 1.0, convex(4.0)),
    ];
    let part = part(56.0, false, sections.clone());
    (setup(&part, &sections, vec![]), part)
}

/// The master part of appendix D. The thread ends on the profile where the ball begins: the smaller radius is cut.
pub(crate) fn master() -> Part {
    let sections = vec![
        row(1, 0.0, 25.0, 5.0, 16.0, SectionKind::Concave { radius: 7.0 }),
        row(2, 5.0, 16.0, 14.0, 10.0, SectionKind::ParabolaAlongX { z3: 8.0, d3: 17.0, chords: 10 }),
        row(3, 14.0, 10.0, 21.0, 16.0, SectionKind::Line),
        row(4, 21.0, 16.0, 25.0, 12.0, SectionKind::Line),
        row(5, 25.0, 12.0, 28.0, 12.0, SectionKind::Line),
        row(6, 28.0, 12.0, 40.0, 10.0, SectionKind::Thread { pitch: 1.75 }),
        row(7, 34.0, 12.0, 40.0, 0.0, SectionKind::Convex { radius: 6.0 }),
    ];
    let part = part(40.0, true, sections.clone());
    let mut shown = sections;
    shown[5].z2 = 34.0;
    let thread = ThreadSpec { section: 6, z1: 28.0, z2: 40.0, outside_radius: 6.0, base_radius: 5.0, pitch: 1.75 };
    (setup(&part, &shown, vec![thread]), part)
}
