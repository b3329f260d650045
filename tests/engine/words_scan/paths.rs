//! Paths made by hand for tests, and the moves that a program of them must have.

use super::read::Step;
use turnwright::geometry::{Point, Segment, Vector};
use turnwright::turning::{
    Cut, CutMove, CutterPath, Feed, FinishRecipe, Operation, OperationKind, Recipe, RecipeKind, RoughRecipe, Side,
    Speed, ThreadRecipe,
};

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

    /// Pass by pass in, along, out and back, the last one at the base.
    fn whole_thread(&mut self, to_z: f64, outside: f64, base: f64, lead: f64, depth: f64) {
        let from = self.at;
        let passes = ((outside - base) / depth - 1e-6).ceil();
        let mut pass = 1.0;
        while pass <= passes {
            let r = (outside - pass * depth).max(base);
            self.rapid(Point::new(from.z, r));
            self.all.push(Wanted::Thread { to: Point::new(to_z, r), lead });
            self.at = Point::new(to_z, r);
            self.rapid(Point::new(to_z, from.r));
            self.rapid(from);
            pass += 1.0;
        }
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
                CutMove::Thread { to_z, outside_radius, base_radius, pitch, depth_per_cut, .. } => {
                    self.whole_thread(to_z + by.x, outside_radius + by.y, base_radius + by.y, pitch, depth_per_cut);
                }
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

/// A chamfer, a cylinder and a shoulder, cut towards the chuck by a nose of 0.8 mm, with the contour as a recipe.
pub(crate) fn finish_with_recipe() -> CutterPath {
    let (p, nose) = (Point::new, 0.8);
    let line = |z, r| CutMove::Line { to: p(z, r), cut: CUT };
    // The nose's centre is (nose, nose) from the programmed point; a slope of 45 degrees moves it by nose / √2 on either axis.
    let slope = nose - nose / 2_f64.sqrt();
    let (change, approach) = (p(150.0, 100.0), p(64.0, 14.0));
    let corner_center = p(58.0 - nose, 20.0 - nose);
    let moves = vec![
        CutMove::Rapid { to: approach },
        line(60.0 - slope, 18.0 - slope),
        line(58.0 - slope, 20.0 - slope),
        CutMove::Arc { to: p(58.0 - nose, 20.0), center: corner_center, ccw: true, cut: CUT },
        line(40.0, 20.0),
        line(40.0, 26.0 - nose),
        CutMove::Rapid { to: p(45.0, 40.0) },
        CutMove::Rapid { to: change },
    ];
    let contour = vec![line(60.0, 18.0), line(58.0, 20.0), line(40.0, 20.0), line(40.0, 26.0)];
    let finish = FinishRecipe { contour, side: Side::Right, nose_radius: nose, orientation: 3 };
    let mut operation = operation(OperationKind::FinishRight, 5, change, moves);
    operation.recipes = vec![Recipe { moves: 1..6, kind: RecipeKind::Finish(finish) }];
    CutterPath { datum: change, program_zero_z: 60.0, operations: vec![operation] }
}

/// A thread of 2 mm lead over 30 mm, as two passes and as a recipe, from a drive line.
pub(crate) fn thread_with_recipe(crest: f64, root: f64, drive: f64) -> CutterPath {
    let p = Point::new;
    let (change, start) = (p(150.0, 100.0), p(65.0, drive));
    let mut moves = vec![CutMove::Rapid { to: p(65.0, drive) }];
    for r in [f64::midpoint(crest, root), root] {
        moves.push(CutMove::Rapid { to: p(65.0, r) });
        moves.push(CutMove::ThreadPass { to: p(30.0, r), lead: 2.0, start_deg: 0.0, rpm: 400.0 });
        moves.push(CutMove::Rapid { to: p(30.0, drive) });
        moves.push(CutMove::Rapid { to: start });
    }
    moves.push(CutMove::Rapid { to: change });
    let thread = ThreadRecipe {
        to_z: 30.0,
        crest_radius: crest,
        root_radius: root,
        lead: 2.0,
        first_depth: 0.3,
        least_depth: 0.05,
        finish_depth: 0.02,
        spring_passes: 1,
        flank_deg: 0.0,
        run_out: 0.0,
        rpm: 400.0,
    };
    let mut operation = operation(OperationKind::Thread, 7, change, moves);
    operation.recipes = vec![Recipe { moves: 1..9, kind: RecipeKind::Thread(thread) }];
    CutterPath { datum: change, program_zero_z: 60.0, operations: vec![operation] }
}

/// The same thread with a run-out behind it, which the recipe alone has.
pub(crate) fn thread_running_out(crest: f64, root: f64, drive: f64, length: f64) -> CutterPath {
    let mut path = thread_with_recipe(crest, root, drive);
    for recipe in path.operations.iter_mut().flat_map(|operation| &mut operation.recipes) {
        if let RecipeKind::Thread(thread) = &mut recipe.kind {
            thread.run_out = length;
        }
    }
    path
}

/// Roughing and finishing of the same steps with one contour, as recipes; the moves stand for both.
pub(crate) fn rough_and_finish_with_recipes() -> CutterPath {
    let p = Point::new;
    let line = |z, r| CutMove::Line { to: p(z, r), cut: CUT };
    let (change, start) = (p(150.0, 100.0), p(62.0, 32.0));
    let contour = vec![line(62.0, 20.0), line(40.0, 20.0), line(40.0, 25.0), line(20.0, 28.0), line(20.0, 31.0)];
    let whole = |kind, tool, recipe| {
        let mut moves = vec![CutMove::Rapid { to: start }];
        moves.extend(contour.clone());
        moves.extend([CutMove::Rapid { to: start }, CutMove::Rapid { to: change }]);
        let mut operation = operation(kind, tool, change, moves);
        operation.recipes = vec![Recipe { moves: 1..6, kind: recipe }];
        operation
    };
    let rough = RoughRecipe {
        start,
        contour: contour.clone(),
        depth: 2.0,
        retract: 0.5,
        allowance_radius: 0.2,
        allowance_z: 0.1,
        cut: CUT,
    };
    let finish = FinishRecipe { contour: contour.clone(), side: Side::Right, nose_radius: 0.4, orientation: 3 };
    let operations = vec![
        whole(OperationKind::RoughRight, 1, RecipeKind::Rough(rough)),
        whole(OperationKind::FinishRight, 5, RecipeKind::Finish(finish)),
    ];
    CutterPath { datum: change, program_zero_z: 60.0, operations }
}
