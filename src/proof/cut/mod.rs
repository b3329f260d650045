//! Cuts the stock with the swept insert and finds what touches that must not.

mod cutter;
pub(super) mod grid;
mod region;
mod sweep;

use crate::geometry::{Bounds, Point, Segment};
use crate::machine::{Chuck, ToolOutline};
use cutter::Cutter;
use grid::{GridPoint, Ring, from_grid, hull, to_grid};
use region::area_of;
pub(super) use region::{CHORD_TOLERANCE_MM, Region};
use std::collections::BTreeMap;
use sweep::swept;

/// Stock overlapped by less than this area, mm², is not touched: 1 µm over a length of 1 mm.
pub(super) const CONTACT_AREA_MM2: f64 = 0.001;
/// Where holder or back of the insert come near stock that the edge is still cutting, the move is looked at in steps of
/// this length, mm.
const STEP_MM: f64 = 0.5;
/// Steps of one move at most; longer moves have longer steps.
const MOST_STEPS: usize = 64;
/// Grooves of one thread at most; the longest travel at the finest pitch has 1000.
const MOST_GROOVES: u32 = 5_000;

/// The stock, the tools and the jaws.
pub(super) struct Cutting {
    stock: Region,
    cutters: BTreeMap<u32, Cutter>,
    jaws: Region,
}

/// An overlap that must not be.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Contact {
    /// Area of the overlap, mm².
    pub area_mm2: f64,
    /// Its mean thickness: area over half the way around, mm.
    pub thickness_mm: f64,
    /// Middle of its largest piece.
    pub at: Point,
}

/// What one move did.
#[derive(Debug, Default)]
pub(super) struct Cut {
    /// Stock that the insert took away.
    pub taken: Vec<Ring>,
    /// Its area, mm².
    pub taken_mm2: f64,
    /// Stock that went through an edge that cannot cut.
    pub flank: Option<Contact>,
    /// Stock that the holder ran into.
    pub holder: Option<Contact>,
    /// Jaws that insert or holder ran into.
    pub chuck: Option<Contact>,
}

impl Cut {
    /// Where stock was taken, if enough was taken to matter.
    pub(super) fn contact(&self) -> Option<Contact> {
        contact(&self.taken)
    }
}

impl Cutting {
    /// Stock and tools before the first move.
    pub(super) fn new(stock: Region, tools: &BTreeMap<u32, ToolOutline>, chuck: &Chuck, chuck_face_z: f64) -> Self {
        let corner = |z, r| Point::new(z, r);
        let left = chuck_face_z - chuck.depth_mm;
        let jaws = [
            corner(left, 0.0),
            corner(chuck_face_z, 0.0),
            corner(chuck_face_z, chuck.radius_mm),
            corner(left, chuck.radius_mm),
        ];
        Self {
            stock,
            cutters: tools.iter().map(|(&station, outline)| (station, Cutter::new(outline))).collect(),
            jaws: Region::of_contour(&crate::geometry::Contour::polygon(&jaws)),
        }
    }

    /// The stock as it is.
    pub(super) fn stock(&self) -> &Region {
        &self.stock
    }

    /// Moves a tool along a path and cuts.
    pub(super) fn travel(&mut self, path: &Segment, tool: u32) -> Cut {
        let points: Vec<GridPoint> =
            std::iter::once(path.start()).chain(path.polyline_points(CHORD_TOLERANCE_MM)).map(to_grid).collect();
        let Some(cutter) = self.cutters.get(&tool) else { return Cut::default() };
        let chuck = collide(&mut self.jaws, cutter.insert.iter().chain(&cutter.holder), &points);
        let (mut flank, mut holder) = (None, None);
        if near(&cutter.holder, &points, &self.stock) || back_is_near(cutter, &points, &self.stock) {
            (flank, holder) = in_steps(self.stock.copied(), cutter, path, points.len());
        }
        let taken = take(&mut self.stock, cutter, &points);
        Cut { taken_mm2: area_of(&taken), taken, flank, holder, chuck }
    }

    /// Cuts the grooves of a thread from `near` to `far`: the insert at every pitch and at the far end. The passes before the
    /// last lie inside its grooves.
    pub(super) fn thread(&mut self, near: Point, far: Point, pitch: f64, tool: u32) -> (Cut, u32) {
        let Some(cutter) = self.cutters.get(&tool) else { return (Cut::default(), 1) };
        let path = [to_grid(near), to_grid(far)];
        let chuck = collide(&mut self.jaws, cutter.insert.iter().chain(&cutter.holder), &path);
        let length = near.distance(far);
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped to 0..=MOST_GROOVES")]
        let grooves = (length / pitch).clamp(0.0, f64::from(MOST_GROOVES)) as u32;
        let at = |k: u32| near + (far - near) * (f64::from(k) * pitch / length.max(pitch)).min(1.0);
        let places = (0..=grooves).map(at).chain([far]).map(to_grid);
        let rings: Vec<Ring> = places.flat_map(|p| cutter.insert.iter().map(move |piece| swept(piece, &[p]))).collect();
        let taken = self.stock.cut_away(&rings).unwrap_or_default();
        let holder = collide(&mut self.stock, cutter.holder.iter(), &path);
        let cut = Cut { taken_mm2: area_of(&taken), taken, flank: None, holder, chuck };
        (cut, grooves + 1)
    }
}

/// Takes away what the insert covers on its way.
fn take(stock: &mut Region, cutter: &Cutter, points: &[GridPoint]) -> Vec<Ring> {
    let rings: Vec<Ring> =
        cutter.insert.iter().map(|piece| swept(piece, points)).filter(|ring| stock.may_meet(ring)).collect();
    if rings.is_empty() { Vec::new() } else { stock.cut_away(&rings).unwrap_or_default() }
}

/// True if a piece overlaps the stock somewhere on its way, before anything is cut.
fn near(pieces: &[Ring], points: &[GridPoint], stock: &Region) -> bool {
    let meets = |piece: &Ring, path: &[GridPoint]| stock.may_meet(&swept(piece, path));
    pieces.iter().any(|piece| meets(piece, points) && points.windows(2).any(|step| meets(piece, step)))
}

/// True if stock may lie in front of an edge that cannot cut.
fn back_is_near(cutter: &Cutter, points: &[GridPoint], stock: &Region) -> bool {
    points.windows(2).any(|step| back_sweeps(cutter, step).any(|ring| stock.may_meet(&ring)))
}

/// What the edges that cannot cut and face forwards cover in one straight step.
///
/// The insert is convex and the step straight, so every point it covers enters through exactly one edge that faces forwards.
fn back_sweeps<'a>(cutter: &'a Cutter, step: &'a [GridPoint]) -> impl Iterator<Item = Ring> + 'a {
    let (from, to) = (step[0], step[step.len() - 1]);
    let forwards = move |edge: &&[GridPoint; 2]| {
        let along = (i64::from(edge[1].x) - i64::from(edge[0].x), i64::from(edge[1].y) - i64::from(edge[0].y));
        let travel = (i64::from(to.x) - i64::from(from.x), i64::from(to.y) - i64::from(from.y));
        travel.0 * along.1 - travel.1 * along.0 > 0
    };
    let covered =
        move |edge: &[GridPoint; 2]| hull([from, to].iter().flat_map(|&p| edge.map(|e| grid::plus(e, p))).collect());
    cutter.back.iter().filter(forwards).map(covered)
}

/// Follows a move in small steps, cutting as it goes, and returns what the back of the insert and the holder run into.
fn in_steps(mut stock: Region, cutter: &Cutter, path: &Segment, chords: usize) -> (Option<Contact>, Option<Contact>) {
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped to 1..=MOST_STEPS")]
    let steps = ((path.length() / STEP_MM).clamp(1.0, MOST_STEPS as f64) as usize).max(chords.saturating_sub(1));
    let at = |k: usize| to_grid(path.point_at(k as f64 / steps as f64));
    let (mut flank, mut holder) = (None, None);
    for k in 0..steps {
        let step = [at(k), at(k + 1)];
        let back: Vec<Ring> = back_sweeps(cutter, &step).filter(|ring| stock.may_meet(ring)).collect();
        if !back.is_empty() {
            flank = larger(flank, contact(&stock.shared(&back)));
        }
        take(&mut stock, cutter, &step);
        holder = larger(holder, collide(&mut stock, cutter.holder.iter(), &step));
    }
    (flank, holder)
}

/// What pieces on their way share with a region.
fn collide<'a>(region: &mut Region, pieces: impl Iterator<Item = &'a Ring>, points: &[GridPoint]) -> Option<Contact> {
    let rings: Vec<Ring> = pieces.map(|piece| swept(piece, points)).filter(|ring| region.may_meet(ring)).collect();
    if rings.is_empty() { None } else { contact(&region.shared(&rings)) }
}

/// The contact of overlapping rings, if there is enough of it to matter.
fn contact(rings: &[Ring]) -> Option<Contact> {
    let area_mm2 = area_of(rings);
    let largest = rings.iter().max_by(|a, b| grid::area_mm2(a).total_cmp(&grid::area_mm2(b)))?;
    let bounds = Bounds::around(largest.iter().map(|&p| from_grid(p)))?;
    let at = Point::new(f64::midpoint(bounds.min.z, bounds.max.z), f64::midpoint(bounds.min.r, bounds.max.r));
    let thickness_mm = 2.0 * area_mm2 / rings.iter().map(|ring| grid::around_mm(ring)).sum::<f64>();
    (area_mm2 > CONTACT_AREA_MM2).then_some(Contact { area_mm2, thickness_mm, at })
}

fn larger(a: Option<Contact>, b: Option<Contact>) -> Option<Contact> {
    match (a, b) {
        (Some(a), Some(b)) => Some(if b.area_mm2 > a.area_mm2 { b } else { a }),
        (a, b) => a.or(b),
    }
}
