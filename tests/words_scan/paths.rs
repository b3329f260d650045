//! Paths made by hand for tests, and the moves that a program of them must have.

use super::read::Step;
use turnwright::geometry::{Point, Segment, Vector};
use turnwright::turning::{Cut, CutMove, CutterPath, Feed, Operation, OperationKind, Speed};

pub(crate) const CUT: Cut =
    Cut { feed: Feed::PerRev(0.2), speed: Speed::Surface { m_per_min: 180.0, max_rpm: 2500.0 } };

pub(crate) fn operation(kind: OperationKind, tool: u32, change: Point, moves: Vec<CutMove>) -> Operation {
    Operation { kind, name: kind.name().to_owned(), tool, change: Some(change), moves, recipes: Vec::new() }
}

/// Something of everything: lines, arcs of a quarter, of half a turn and flat ones, dwell, threads of two starts, repeats.
pub(crate) fn all_sorts() -> CutterPath {
    let p = Point::new;
    let change = p(150.0, 100.0);
    let line = |z, r| CutMove::Line { to: p(z, r), cut: CUT };
    let arc = |z, r, cz, cr, ccw| CutMove::Arc { to: p(z, r), center: p(cz, cr), ccw, cut: CUT };
    let rough = vec![
        CutMove::Rapid { to: p(62.0, 31.0) },
        line(61.0, 25.0),
        line(50.0, 25.0),
        arc(45.0, 30.0, 45.0, 25.0, true),
        line(30.0, 30.0),
        arc(20.0, 30.0, 25.0, 30.0, false),
        arc(10.0, 30.25, 15.0, 30.125, true),
        arc(8.0, 30.25, 9.0, 300.0, false),
        line(7.123_456_7, 31.987_654_3),
        CutMove::Rapid { to: change },
    ];
    let groove = vec![
        CutMove::Rapid { to: p(40.0, 33.0) },
        CutMove::Repeat {
            count: 3,
            step: Vector::new(-1.5, 0.0),
            body: vec![line(40.0, 28.0), CutMove::Dwell { seconds: 0.75 }, CutMove::Rapid { to: p(40.0, 33.0) }],
        },
        CutMove::Rapid { to: change },
    ];
    let pass = |r: f64, start_deg| {
        [
            CutMove::Rapid { to: p(65.0, r) },
            CutMove::ThreadPass { to: p(51.0, r), lead: 3.0, start_deg, rpm: 500.0 },
            CutMove::Rapid { to: p(51.0, 32.0) },
            CutMove::Rapid { to: p(65.0, 32.0) },
        ]
    };
    let mut thread = vec![CutMove::Rapid { to: p(65.0, 32.0) }];
    thread.extend([pass(24.5, 0.0), pass(24.5, 180.0), pass(24.2, 0.0), pass(24.2, 180.0)].into_iter().flatten());
    thread.push(CutMove::Rapid { to: change });
    CutterPath {
        datum: change,
        program_zero_z: 60.0,
        operations: vec![
            operation(OperationKind::RoughRight, 1, change, rough),
            operation(OperationKind::Groove, 3, change, groove),
            operation(OperationKind::Thread, 7, change, thread),
        ],
    }
}

/// A move that a program must make, in program space.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Wanted {
    Rapid(Point),
    Along(Segment),
    Thread { to: Point, lead: f64 },
    Dwell(f64),
}

/// What the moves of an operation come to. `shifts` is true for controls without a word for the start angle.
pub(crate) fn wanted(path: &CutterPath, operation: &Operation, shifts: bool) -> Vec<Wanted> {
    let zero = Vector::new(-path.program_zero_z, 0.0);
    let change = operation.change.unwrap_or(path.datum) + zero;
    let mut list = List { at: change, shifts, all: Vec::new() };
    list.moves(&operation.moves, zero);
    list.rapid(change);
    list.all
}

struct List {
    at: Point,
    shifts: bool,
    all: Vec<Wanted>,
}

impl List {
    fn rapid(&mut self, to: Point) {
        if to.distance(self.at) > 1e-9 {
            self.all.push(Wanted::Rapid(to));
        }
        self.at = to;
    }

    fn moves(&mut self, moves: &[CutMove], by: Vector) {
        for m in moves {
            match *m {
                CutMove::Rapid { to } => self.rapid(to + by),
                CutMove::Line { to, .. } => {
                    if (to + by).distance(self.at) > 1e-9 {
                        self.all.push(Wanted::Along(Segment::line(self.at, to + by)));
                    }
                    self.at = to + by;
                }
                CutMove::Arc { to, center, ccw, .. } => {
                    let arc = Segment::Arc { start: self.at, end: to + by, center: center + by, ccw };
                    self.all.push(Wanted::Along(arc));
                    self.at = to + by;
                }
                CutMove::ThreadPass { to, lead, start_deg, .. } => {
                    if self.shifts && start_deg > 0.0 {
                        self.rapid(self.at + Vector::new(lead * start_deg / 360.0, 0.0));
                    }
                    self.all.push(Wanted::Thread { to: to + by, lead });
                    self.at = to + by;
                }
                CutMove::Dwell { seconds } => self.all.push(Wanted::Dwell(seconds)),
                CutMove::Repeat { count, step, ref body } => {
                    (0..count).for_each(|k| self.moves(body, by + step * f64::from(k)));
                }
                CutMove::Thread { .. } => panic!("no test has one"),
            }
        }
    }
}

/// Compares the moves of a program with those that it must make; an arc may be several.
pub(crate) fn compare(steps: &[Step], wanted: &[Wanted], start: Point, tolerance: f64) -> Result<(), String> {
    let mut steps = steps.iter();
    let mut at = start;
    for want in wanted {
        let mut next = || steps.next().ok_or_else(|| format!("the program ends before {want:?}"));
        let near = |a: Point, b: Point| a.distance(b) <= tolerance;
        match *want {
            Wanted::Rapid(to) => match *next()? {
                Step::Rapid { to: is } if near(is, to) => at = is,
                other => return Err(format!("{other:?} instead of {want:?}")),
            },
            Wanted::Dwell(seconds) => match *next()? {
                Step::Dwell { seconds: is } if (is - seconds).abs() < 1e-3 => {}
                other => return Err(format!("{other:?} instead of {want:?}")),
            },
            Wanted::Thread { to, lead } => match *next()? {
                Step::Thread { to: is, lead: l } if near(is, to) && (l - lead).abs() < 5e-4 => at = is,
                other => return Err(format!("{other:?} instead of {want:?}")),
            },
            Wanted::Along(segment) => loop {
                let step = *next()?;
                let piece = match step {
                    Step::Line { to, .. } => Segment::line(at, to),
                    Step::Arc { to, center, ccw, .. } => Segment::Arc { start: at, end: to, center, ccw },
                    other => return Err(format!("{other:?} instead of {want:?}")),
                };
                for k in 0..=8 {
                    let p = piece.point_at(f64::from(k) / 8.0);
                    let off = segment.distance_to(p);
                    if off > tolerance {
                        return Err(format!("{piece:?} leaves {segment:?} by {off:.5} mm at {p:?}"));
                    }
                }
                at = piece.end();
                if near(at, segment.end()) {
                    break;
                }
            },
        }
    }
    match steps.next() {
        Some(extra) => Err(format!("{extra:?} is not wanted")),
        None => Ok(()),
    }
}
