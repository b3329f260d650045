//! Parts and set-ups made by hand for tests.

use crate::document::{Ends, Holding, TurnedPart};
use crate::geometry::{Contour, Point, Segment, Vector};
use crate::machine::Directions;
use crate::part::{PartContour, Profile, Section, SectionKind, Setup, ThreadSpec};
use crate::proof::{BlockReport, Motion, Move, ProgramText, ProofReport, StockHistory};
use crate::regen::SetupDerived;
use std::sync::Arc;

/// A part in mm with the given rows, on a 26.2 mm bar.
pub(super) fn part(sections: Vec<Section>) -> TurnedPart {
    TurnedPart {
        machine: "orac".into(),
        material: "aluminium".into(),
        bar_diameter: 26.2,
        length: sections.iter().map(|s| s.z2).fold(0.0, f64::max),
        ends: Ends::One,
        part_off: false,
        automatic: false,
        form_tolerance: 0.02,
        sections,
        ..TurnedPart::default()
    }
}

/// A section of the given kind.
pub(super) fn section(id: u32, z1: f64, d1: f64, z2: f64, d2: f64, kind: SectionKind) -> Section {
    Section { id, z1, d1, z2, d2, kind }
}

/// A pawn-like part with a line, a face, both kinds of arc and a thread.
pub(super) fn pawn() -> TurnedPart {
    let rows = vec![
        section(1, 0.0, 24.0, 4.0, 24.0, SectionKind::Line),
        section(2, 4.0, 22.0, 16.0, 12.0, SectionKind::Concave { radius: 14.0 }),
        section(3, 16.0, 16.0, 28.0, 16.0, SectionKind::Convex { radius: 9.0 }),
        section(4, 28.0, 12.0, 40.0, 10.2, SectionKind::Thread { pitch: 1.75, starts: 1 }),
    ];
    part(rows)
}

/// What follows from a part, made by hand without machine, program or proof.
pub(super) fn derived(part: &TurnedPart) -> SetupDerived {
    let mut contour = PartContour::default();
    for row in &part.sections {
        let (start, end) = (Point::new(row.z1, row.d1 / 2.0), Point::new(row.z2, far_radius(row)));
        let face = contour.contour.segments.last().map(Segment::end).filter(|last| last.distance(start) > 1e-9);
        contour.contour.segments.extend(face.map(|last| Segment::line(last, start)));
        contour.contour.segments.push(surface(row, start, end));
        contour.sections.resize(contour.contour.segments.len(), row.id);
    }
    let (bar, length) = (part.bar_diameter / 2.0, part.length);
    let corners = [(-30.0, 0.0), (length, 0.0), (length, bar), (-30.0, bar)].map(|(z, r)| Point::new(z, r));
    let threads = part.sections.iter().filter_map(thread).collect();
    let setup = Setup {
        suffix: String::new(),
        profile: Profile::default(),
        threads,
        machined_from_z: 0.0,
        bore: None,
        bore_threads: Vec::new(),
        bored_from_z: length,
        length,
        bar_radius: bar,
        stock: Contour::polygon(&corners),
        holding: Holding::Chuck,
        directions: Directions::Both,
        chuck_face_z: -10.0,
        mandrel: None,
        tailstock: None,
        part_off_width: None,
        turned_round: false,
    };
    SetupDerived {
        name: "SAMPLE".into(),
        part: Arc::default(),
        setup: Arc::new(setup),
        contour: Arc::new(contour),
        bore: Arc::default(),
        unreachable: Arc::default(),
        path: Arc::default(),
        post: Arc::default(),
        programs: Arc::default(),
        proof: Arc::default(),
        tools: Arc::default(),
    }
}

fn far_radius(row: &Section) -> f64 {
    if matches!(row.kind, SectionKind::Thread { .. }) { row.d1 / 2.0 } else { row.d2 / 2.0 }
}

fn surface(row: &Section, start: Point, end: Point) -> Segment {
    let (radius, convex) = match row.kind {
        SectionKind::Convex { radius } => (radius, true),
        SectionKind::Concave { radius } => (radius, false),
        _ => return Segment::line(start, end),
    };
    let chord = end - start;
    let across = Vector::new(-chord.y, chord.x) / chord.norm();
    let height = (radius * radius - chord.norm_squared() / 4.0).max(0.0).sqrt();
    let middle = start + chord / 2.0;
    let center = if convex { middle - across * height } else { middle + across * height };
    Segment::Arc { start, end, center, ccw: !convex }
}

fn thread(row: &Section) -> Option<ThreadSpec> {
    let SectionKind::Thread { pitch, starts } = row.kind else { return None };
    let (crest_radius, base_radius) = (row.d1 / 2.0, row.d2 / 2.0);
    Some(ThreadSpec { section: row.id, z1: row.z1, z2: row.z2, crest_radius, base_radius, pitch, starts })
}

/// The same with a program of four blocks: down, along, up and back.
pub(super) fn with_program(mut derived: SetupDerived) -> SetupDerived {
    let corners = [(60.0, 15.0), (60.0, 12.2), (0.0, 12.2), (0.0, 15.0), (60.0, 15.0)].map(|(z, r)| Point::new(z, r));
    let mut proof = ProofReport { stock: StockHistory::uncut(&derived.setup.stock), ..ProofReport::default() };
    for (block, ends) in (1..).zip(corners.windows(2)) {
        let starts_s = proof.times.total_s;
        proof.times.total_s += 2.0;
        proof.moves.push(Move {
            program: 0,
            block,
            path: Segment::line(ends[0], ends[1]),
            motion: if block == 4 { Motion::Rapid } else { Motion::Feed },
            tool: 1,
            feed_mm_per_min: 80.0,
            rpm: 1200.0,
            starts_s,
            lasts_s: 2.0,
            stock_after: 0,
        });
        let program = "SAMPLE1".to_owned();
        proof.blocks.push(BlockReport {
            program,
            block,
            runs: 1,
            time_s: 2.0,
            removed_mm2: 0.0,
            chip_mm2: 0.02,
            printed: None,
        });
    }
    derived.programs = Arc::new(vec![ProgramText { name: "SAMPLE1".into(), text: String::new(), edited: false }]);
    derived.proof = Arc::new(proof);
    derived
}
