//! Which blocks cut which section: the way from the finished form back to the program, and forth.
//!
//! A block cuts a section where its nose comes nearest to it of all cutting moves, and within a given distance. So what
//! counts is who left the surface, not who roughed above it, and it holds for programs edited by hand as well.

use super::input::ProofInput;
use super::report::{BlockRef, Finding, FindingKind, Motion, Move, ProgramText, ProofReport, Target};
use crate::diagnostic::Severity;
use crate::geometry::{Bounds, Point, Segment};
use crate::machine::ToolOutline;
use std::collections::{BTreeMap, BTreeSet};

/// Distance between the points of the contour that are looked at, mm: half the smallest nose of the shipped tools.
const STEP_MM: f64 = 0.1;
/// Points looked at on one segment at most.
const MOST_STEPS: u32 = 2_000;
/// Blocks whose distances differ by less than this, mm, are as near as one another: two roundings of the control.
const AS_NEAR_MM: f64 = 0.002;
/// Lines of an insert's edge that rise less than this, mm, lie level at the nose.
const LEVEL_MM: f64 = 0.001;

/// The blocks that cut each section of one clamping.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct CutBy {
    pairs: BTreeSet<(u32, BlockRef)>,
}

impl CutBy {
    /// Finds the blocks that come within the form tolerance of each machined section, and those that gouge it. `report`
    /// is the proof of `input`; without work there are no sections.
    #[must_use]
    pub fn new(input: &ProofInput, report: &ProofReport) -> Self {
        let Some(work) = &input.work else { return Self::default() };
        let target = &work.target;
        let passes = passes(&report.moves, &input.tools);
        let mut lengths: BTreeMap<u32, f64> = BTreeMap::new();
        let mut nearest: BTreeMap<(u32, BlockRef), f64> = BTreeMap::new();
        for (segment, &section) in target.contour.segments.iter().zip(&target.sections) {
            for (p, length) in steps(segment).filter(|(p, _)| p.z > target.machined_from_z) {
                *lengths.entry(section).or_default() += length;
                for block in nearest_blocks(&passes, p, work.form_tolerance_mm) {
                    *nearest.entry((section, block)).or_default() += length;
                }
            }
        }
        let shortest = shortest_cuts(&passes);
        let is_cut = |(section, block): &(u32, BlockRef), along: f64| {
            let half = lengths.get(section).copied().unwrap_or_default() / 2.0;
            along + AS_NEAR_MM >= half.min(shortest.get(block).copied().unwrap_or_default())
        };
        let mut pairs: BTreeSet<_> =
            nearest.into_iter().filter(|(pair, along)| is_cut(pair, *along)).map(|(pair, _)| pair).collect();
        pairs.extend(report.findings.iter().filter_map(|finding| gouged(finding, target, &input.programs)));
        Self { pairs }
    }

    /// The blocks that cut a section, by row id, in the order of the programs.
    pub fn blocks_of(&self, section: u32) -> impl Iterator<Item = BlockRef> + '_ {
        self.pairs.iter().filter(move |(id, _)| *id == section).map(|(_, block)| *block)
    }

    /// The row ids of the sections that any of these blocks cuts; `blocks` in the order of the programs.
    #[must_use]
    pub fn sections_of_any(&self, blocks: &[BlockRef]) -> Vec<u32> {
        let mut rows: Vec<u32> =
            self.pairs.iter().filter(|(_, block)| blocks.binary_search(block).is_ok()).map(|(id, _)| *id).collect();
        rows.dedup();
        rows
    }

    /// The row ids of the sections that a block cuts.
    pub fn sections_of(&self, block: BlockRef) -> impl Iterator<Item = u32> + '_ {
        self.pairs.iter().filter(move |(_, b)| *b == block).map(|(id, _)| *id)
    }
}

/// The way of one nose of the tool in one cutting move.
struct Pass {
    block: BlockRef,
    /// Path of the nose's centre; of a thread, of the programmed point.
    path: Segment,
    bounds: Bounds,
    nose_radius: f64,
    is_thread: bool,
}

impl Pass {
    /// Distance of the nose from a point of the contour, mm; 0 where it takes the point away. Where it starts it takes
    /// nothing: the move before brought it there.
    fn distance_to(&self, p: Point, tolerance: f64) -> f64 {
        if !self.is_thread {
            let nearest = self.path.nearest_point(p);
            let at_start = nearest.distance(self.path.start()) < AS_NEAR_MM;
            return if at_start { f64::INFINITY } else { (nearest.distance(p) - self.nose_radius).max(0.0) };
        }
        // A thread cuts into the contour everywhere between its ends.
        let within = self.bounds.min.z <= p.z && p.z <= self.bounds.max.z && self.bounds.min.r <= p.r + tolerance;
        if within { 0.0 } else { f64::INFINITY }
    }

    /// A distance that [`Self::distance_to`] is never below, mm.
    fn least_distance_to(&self, p: Point) -> f64 {
        let Bounds { min, max } = self.bounds;
        let along = (min.z - p.z).max(p.z - max.z);
        let across = if self.is_thread { 0.0 } else { (min.r - p.r).max(p.r - max.r) };
        along.max(across) - self.nose_radius
    }
}

fn passes(moves: &[Move], tools: &BTreeMap<u32, ToolOutline>) -> Vec<Pass> {
    let noses: BTreeMap<u32, Vec<(Point, f64)>> = tools.iter().map(|(&station, t)| (station, noses(t))).collect();
    let sharp = vec![(Point::default(), 0.0)];
    let cutting = moves.iter().filter(|m| matches!(m.motion, Motion::Feed | Motion::Thread) && m.path.length() > 0.0);
    let of_move = |m: &Move| {
        let is_thread = m.motion == Motion::Thread;
        let noses = noses.get(&m.tool).filter(|_| !is_thread).unwrap_or(&sharp).clone();
        let (block, path) = (BlockRef::of(m), m.path);
        noses.into_iter().map(move |(center, nose_radius)| {
            let path = path.translated(center - Point::default());
            Pass { block, path, bounds: path.bounds(), nose_radius, is_thread }
        })
    };
    cutting.flat_map(of_move).collect()
}

/// Centres and radii of the arcs at the lowest point of an insert: one nose, or the two corners of a blade.
fn noses(tool: &ToolOutline) -> Vec<(Point, f64)> {
    let lowest = tool.insert.bounds().map_or(0.0, |b| b.min.r);
    let arcs = tool.insert.segments.iter().filter(|s| s.bounds().min.r <= lowest + LEVEL_MM);
    let found: Vec<_> = arcs
        .filter_map(|s| match *s {
            Segment::Arc { start, center, .. } => Some((center, start.distance(center))),
            Segment::Line { .. } => None,
        })
        .collect();
    if found.is_empty() { vec![(Point::default(), 0.0)] } else { found }
}

/// Middles of equal parts of a segment, with the length that each stands for.
fn steps(segment: &Segment) -> impl Iterator<Item = (Point, f64)> {
    let length = segment.length();
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped to 1..=MOST_STEPS")]
    let count = (length / STEP_MM).ceil().clamp(1.0, f64::from(MOST_STEPS)) as u32;
    let segment = *segment;
    (0..count).map(move |k| (segment.point_at((f64::from(k) + 0.5) / f64::from(count)), length / f64::from(count)))
}

/// The blocks that come nearest to `p`, if that is within `tolerance`.
fn nearest_blocks(passes: &[Pass], p: Point, tolerance: f64) -> BTreeSet<BlockRef> {
    let mut nearest = tolerance;
    let mut found: Vec<(f64, BlockRef)> = Vec::new();
    for pass in passes {
        if pass.least_distance_to(p) > nearest + AS_NEAR_MM {
            continue;
        }
        let distance = pass.distance_to(p, tolerance);
        if distance <= nearest + AS_NEAR_MM {
            nearest = nearest.min(distance);
            found.push((distance, pass.block));
        }
    }
    found.into_iter().filter(|(d, _)| *d <= nearest + AS_NEAR_MM).map(|(_, block)| block).collect()
}

/// How far along a section each block must be the nearest to cut it, mm: further than its nose reaches around a corner,
/// or half of its longest move, but never at one point only.
fn shortest_cuts(passes: &[Pass]) -> BTreeMap<BlockRef, f64> {
    let mut longest: BTreeMap<BlockRef, (f64, f64)> = BTreeMap::new();
    for pass in passes {
        let known = longest.entry(pass.block).or_default();
        *known = (known.0.max(pass.path.length()), known.1.max(pass.nose_radius));
    }
    let shortest = |(length, nose): (f64, f64)| (length / 2.0).min(2.0 * nose + STEP_MM).max(1.5 * STEP_MM);
    longest.into_iter().map(|(block, of_block)| (block, shortest(of_block))).collect()
}

/// The section that a finding says is cut too deep, and the block that does it.
fn gouged(finding: &Finding, target: &Target, programs: &[ProgramText]) -> Option<(u32, BlockRef)> {
    if finding.kind != FindingKind::Gouge || finding.severity != Severity::Error {
        return None;
    }
    let program = programs.iter().position(|p| p.name == finding.program)?;
    let (segment, _) = target.contour.nearest_point(finding.at?)?;
    Some((*target.sections.get(segment)?, BlockRef { program, block: finding.block }))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Contour;
    use crate::machine::{self, Catalog};
    use crate::proof::Work;
    use std::sync::Arc;

    /// Along z a cylinder of radius 8 to 10, a face and a cylinder of radius 5 to 20, one section each.
    fn stepped(form_tolerance_mm: f64) -> ProofInput {
        let catalog = Catalog::shipped();
        let machine = catalog.machine("orac").unwrap();
        let corners = [(0.0, 8.0), (10.0, 8.0), (10.0, 5.0), (20.0, 5.0)].map(|(z, r)| Point::new(z, r));
        let contour = Contour::new(corners.windows(2).map(|w| Segment::line(w[0], w[1])).collect());
        let work = Work {
            stock: Contour::default(),
            target: Target {
                contour,
                sections: vec![1, 2, 3],
                names: BTreeMap::new(),
                machined_from_z: 0.0,
                bore: None,
            },
            program_zero_z: 20.0,
            chuck_face_z: -10.0,
            mandrel: None,
            tailstock: None,
            material: None,
            form_tolerance_mm,
            may_cut: Vec::new(),
        };
        ProofInput {
            machine: Arc::new(machine.clone()),
            tools: Arc::new(machine::outlines(machine, &catalog)),
            programs: Arc::new(vec![ProgramText { name: "QUEEN1".to_owned(), text: String::new(), edited: true }]),
            work: Some(work),
        }
    }

    /// Block, kind of motion, and from where to where.
    type Cut = (usize, Motion, [(f64, f64); 2]);

    fn report(moves: &[Cut]) -> ProofReport {
        let of = |&(block, motion, ends): &Cut| {
            let [from, to] = ends.map(|(z, r)| Point::new(z, r));
            let path = Segment::line(from, to);
            let (feed_mm_per_min, rpm) = (80.0, 1000.0);
            Move {
                program: 0,
                block,
                path,
                motion,
                tool: 1,
                feed_mm_per_min,
                rpm,
                starts_s: 0.0,
                lasts_s: 1.0,
                stock_after: 0,
            }
        };
        ProofReport { moves: moves.iter().map(of).collect(), ..ProofReport::default() }
    }

    fn blocks(cut_by: &CutBy, section: u32) -> Vec<usize> {
        cut_by.blocks_of(section).map(|b| b.block).collect()
    }

    #[test]
    fn the_block_along_a_section_cuts_it_and_its_neighbours_do_not() {
        let report = report(&[
            (1, Motion::Feed, [(21.0, 6.0), (10.5, 6.0)]),
            (2, Motion::Rapid, [(21.0, 5.0), (21.0, 5.0)]),
            (3, Motion::Feed, [(21.0, 5.0), (10.0, 5.0)]),
            (4, Motion::Feed, [(10.0, 5.0), (10.0, 8.0)]),
            (5, Motion::Feed, [(10.0, 8.0), (0.0, 8.0)]),
            (6, Motion::Rapid, [(0.0, 8.0), (21.0, 8.0)]),
        ]);
        let cut_by = CutBy::new(&stepped(0.1), &report);
        assert_eq!([1, 2, 3].map(|section| blocks(&cut_by, section)), [vec![5], vec![4], vec![3]]);
        let face: Vec<u32> = cut_by.sections_of(BlockRef { program: 0, block: 4 }).collect();
        assert_eq!(face, [2]);
    }

    #[test]
    fn what_stays_above_the_tolerance_cuts_nothing() {
        let report = report(&[(1, Motion::Feed, [(21.0, 5.2), (0.0, 5.2)])]);
        let within = |tolerance| CutBy::new(&stepped(tolerance), &report);
        assert!(blocks(&within(0.1), 3).is_empty());
        assert_eq!(blocks(&within(0.25), 3), [1]);
    }

    #[test]
    fn a_thread_cuts_the_section_that_it_goes_below() {
        let report =
            report(&[(1, Motion::Feed, [(21.0, 5.0), (10.0, 5.0)]), (2, Motion::Thread, [(21.0, 4.2), (11.0, 4.2)])]);
        let cut_by = CutBy::new(&stepped(0.05), &report);
        assert_eq!(blocks(&cut_by, 3), [1, 2]);
        assert!(blocks(&cut_by, 1).is_empty());
    }

    #[test]
    fn a_gouge_belongs_to_the_section_that_it_spoils() {
        let finding = Finding {
            severity: Severity::Error,
            kind: FindingKind::Gouge,
            program: "QUEEN1".to_owned(),
            block: 7,
            at: Some(Point::new(5.0, 6.0)),
            value: 2.0,
            limit: 0.1,
            message: String::new(),
        };
        let report = ProofReport { findings: vec![finding], ..ProofReport::default() };
        let cut_by = CutBy::new(&stepped(0.1), &report);
        assert_eq!(blocks(&cut_by, 1), [7]);
    }
}
