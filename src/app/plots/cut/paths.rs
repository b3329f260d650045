//! Tool paths on the screen: made once for a view, coloured by operation, thinned, hit by the pointer.

use crate::app::plots::canvas::Screen;
use crate::app::plots::lines::{clipped, dashed, distance_to_polyline, faded, thinned};
use crate::app::plots::palette::Palette;
use crate::proof::{BlockRef, Motion, Move, ProofReport};
use crate::regen::{Operations, SetupDerived};
use egui::{Color32, Painter, Pos2, Rect, Shape, Stroke};
use std::sync::Arc;

/// Dash and gap of a rapid move, points.
const RAPID: &[f32] = &[3.0, 3.0];
/// Strength of paths that are still to come.
const TO_COME: f32 = 0.32;
/// Paths smaller than this are left out, points.
const DOT: f32 = 0.4;
/// Width of a path that is lit, points.
const LIT: f32 = 2.6;
/// The same where a whole operation is lit, so that its cuts can be told apart.
const LIT_MANY: f32 = 1.5;
/// Blocks up to which [`LIT`] is the width.
const FEW: usize = 12;
/// The pointer is on a path within this distance, points.
const NEAR: f32 = 6.0;

/// Paths of one proof on the screen of one view; made again only when either changes.
#[derive(Debug, Default)]
pub(super) struct Paths {
    made_for: Option<(Arc<ProofReport>, Screen)>,
    /// Runs of moves with the same block, in order.
    runs: Vec<Run>,
}

/// What of the paths is shown how.
pub(super) struct Shown<'a> {
    /// Index of the move at the slider.
    pub(super) now: Option<usize>,
    /// Blocks that belong to what the pointer is on, in order.
    pub(super) lit: &'a [BlockRef],
    /// Block that is selected.
    pub(super) selected: Option<BlockRef>,
    /// Colour of every operation.
    pub(super) colors: &'a [Color32],
}

/// The moves of one run through one block that look alike.
#[derive(Debug)]
struct Run {
    block: BlockRef,
    /// Index of the first move.
    first: usize,
    rapid: bool,
    /// Index in the path.
    operation: Option<usize>,
    /// On the screen, thinned.
    points: Vec<Pos2>,
    bounds: Rect,
}

impl Paths {
    /// Makes the paths for `screen` if they are not made already.
    pub(super) fn update(&mut self, derived: &SetupDerived, screen: Screen) {
        let known = self.made_for.as_ref();
        if known.is_some_and(|(proof, made)| Arc::ptr_eq(proof, &derived.proof) && *made == screen) {
            return;
        }
        self.runs = runs(derived, &screen);
        self.made_for = Some((Arc::clone(&derived.proof), screen));
    }

    /// Draws all paths: those done by move `now` strong, those to come weak, those lit and `selected` on top.
    pub(super) fn draw(&self, painter: &Painter, palette: &Palette, shown: &Shown<'_>) {
        let clip = painter.clip_rect();
        let seen = || self.runs.iter().filter(|run| clip.intersects(run.bounds));
        // Rapid moves lie under cutting moves: many go back along the line that was cut.
        for run in seen().filter(|run| run.rapid).chain(seen().filter(|run| !run.rapid)) {
            let done = shown.now.is_some_and(|now| run.first <= now);
            run.draw(painter, run.stroke(palette, shown.colors, done));
        }
        let width = if shown.lit.len() > FEW { LIT_MANY } else { LIT };
        for run in seen().filter(|run| shown.lit.binary_search(&run.block).is_ok()) {
            run.draw(painter, Stroke::new(if run.rapid { 0.8 } else { width }, palette.accent));
        }
        for run in seen().filter(|run| Some(run.block) == shown.selected) {
            painter.add(Shape::line(run.points.clone(), Stroke::new(5.0, faded(palette.accent, 0.25))));
            run.draw(painter, Stroke::new(2.2, palette.accent));
        }
    }

    /// The block whose path is nearest to `pos`, if one is near; cutting moves before rapid ones.
    pub(super) fn block_at(&self, pos: Pos2) -> Option<BlockRef> {
        let near = self.runs.iter().filter(|run| run.bounds.expand(NEAR).contains(pos)).filter_map(|run| {
            let distance = distance_to_polyline(pos, &run.points);
            (distance <= NEAR).then_some((run.rapid, distance, run.block))
        });
        near.min_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1))).map(|(_, _, block)| block)
    }
}

impl Run {
    fn stroke(&self, palette: &Palette, colors: &[Color32], done: bool) -> Stroke {
        let strength = if done { 1.0 } else { TO_COME };
        let own = self.operation.and_then(|index| colors.get(index));
        let color = own.copied().unwrap_or_else(|| palette.operation(None));
        match (self.rapid, done) {
            (true, _) => Stroke::new(0.8, faded(palette.quiet, strength * 0.9)),
            (false, true) => Stroke::new(1.4, color),
            (false, false) => Stroke::new(1.0, faded(color, strength)),
        }
    }

    fn draw(&self, painter: &Painter, stroke: Stroke) {
        if self.rapid {
            dashed(painter, &self.points, RAPID, stroke);
        } else if let [a, b] = self.points[..] {
            // Zoomed in, a long line costs only what is seen of it.
            let line = clipped(a, b, painter.clip_rect().expand(stroke.width));
            painter.extend(line.map(|line| Shape::line_segment(line, stroke)));
        } else {
            painter.add(Shape::line(self.points.clone(), stroke));
        }
    }
}

fn runs(derived: &SetupDerived, screen: &Screen) -> Vec<Run> {
    let moves = &derived.proof.moves;
    let alike = |a: &Move, b: &Move| {
        BlockRef::of(a) == BlockRef::of(b) && is_rapid(a) == is_rapid(b) && a.path.end() == b.path.start()
    };
    let mut first = 0;
    let mut runs = Vec::new();
    let operations = Operations::of(derived);
    for chunk in moves.chunk_by(alike) {
        runs.extend(run(&operations, screen, first, chunk));
        first += chunk.len();
    }
    runs
}

fn run(operations: &Operations<'_>, screen: &Screen, first: usize, chunk: &[Move]) -> Option<Run> {
    let m = chunk.first()?;
    let start = std::iter::once(m.path.start());
    let all = start.chain(chunk.iter().flat_map(|m| m.path.polyline_points(screen.tolerance())));
    let points = thinned(all.map(|p| screen.pos(p)));
    let bounds = Rect::from_points(&points).expand(1.0);
    let operation = operations.of_move(m);
    // Runs that are no more than a dot on the screen are not seen.
    let seen = bounds.width().max(bounds.height()) > 2.0 + DOT;
    seen.then(|| Run { block: BlockRef::of(m), first, rapid: is_rapid(m), operation, points, bounds })
}

fn is_rapid(m: &Move) -> bool {
    m.motion == Motion::Rapid
}
