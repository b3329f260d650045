//! What touches stock or jaws that must not.
//!
//! On a straight step everything that the tool covers enters it through an edge that faces forwards. Stock that the holder
//! meets is in contact unless the insert has been there before: in front of that part of the holder, or on an earlier step.
//! What the insert has just left standing is in contact wherever the holder goes over it.

use super::columns::Columns;
use super::cutter::{Cutter, Edge};
use super::grid::{self, GridPoint, Ring, TOUCH, Window, from_grid, hull, plus};
use super::overlap::Overlap;
use super::stock::Stock;
use super::sweep::{covered, met};
use crate::geometry::{Bounds, Point};
use std::borrow::Cow;

/// Stock overlapped by less than this area, mm², is not touched: 1 µm over a length of 1 mm.
pub(in crate::proof) const CONTACT_AREA_MM2: f64 = 0.001;

/// An overlap that must not be.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::proof) struct Contact {
    /// Area of the overlap, mm².
    pub area_mm2: f64,
    /// Its mean thickness: area over half the way around, mm.
    pub thickness_mm: f64,
    /// Middle of its largest piece.
    pub at: Point,
}

impl Contact {
    /// The contact of outlines that do not overlap, if there is enough of it to matter.
    pub(super) fn of(rings: &[Ring]) -> Option<Self> {
        let area_mm2 = grid::area_of(rings);
        let largest = rings.iter().max_by(|a, b| grid::area_mm2(a).total_cmp(&grid::area_mm2(b)))?;
        let bounds = Bounds::around(largest.iter().map(|&p| from_grid(p)))?;
        let at = Point::new(f64::midpoint(bounds.min.z, bounds.max.z), f64::midpoint(bounds.min.r, bounds.max.r));
        let thickness_mm = 2.0 * area_mm2 / rings.iter().map(|ring| grid::around_mm(ring)).sum::<f64>();
        (area_mm2 > CONTACT_AREA_MM2).then_some(Self { area_mm2, thickness_mm, at })
    }

    /// The contact of outlines that may overlap.
    pub(super) fn of_all(rings: &[Ring]) -> Option<Self> {
        if rings.len() < 2 { Self::of(rings) } else { Self::of(&Columns::of_rings(rings).rings()) }
    }
}

/// What was touched so far.
#[derive(Debug, Default)]
pub(super) struct Touched {
    /// Stock that went through an edge of the insert that cannot cut.
    pub flank: Vec<Ring>,
    /// Stock that the holder ran into.
    pub holder: Vec<Ring>,
}

impl Touched {
    /// Adds the stock that the holder stands in before the first step, but for what the insert takes there.
    pub(super) fn at_start(&mut self, stock: &Stock, cutter: &Cutter, start: GridPoint, overlap: &mut Overlap) {
        let window = cutter.holder_window.moved(&Window::around(&[start]));
        if stock.may_meet(&window) {
            let stood_in = stock.shared(&covered(&cutter.holder, &[start]), &window, overlap);
            overlap.left.clear();
            overlap.subtract(&stood_in, &covered(&cutter.insert, &[start]));
            self.holder.extend(overlap.left.rings());
        }
    }

    /// Adds what is in front of edges that must not meet stock on a straight step, before the insert cuts.
    pub(super) fn before(
        &mut self,
        stock: &Stock,
        cutter: &Cutter,
        edges: &NearEdges<'_>,
        step: [GridPoint; 2],
        overlap: &mut Overlap,
    ) {
        let along = direction(step);
        let near = |edge: &&Edge| faces(edge, along) && stock.may_meet(&Window::around(&swept_corners(**edge, step)));
        let flank = edges.back.iter().filter(near).copied();
        touch(&mut self.flank, stock, flank, step, overlap);
        let holder = edges.holder.iter().filter(near).flat_map(|edge| in_the_open(*edge, along, &cutter.insert));
        touch(&mut self.holder, stock, holder, step, overlap);
    }

    /// Adds what the holder goes over on its way, after the insert has cut.
    pub(super) fn after(&mut self, stock: &Stock, cutter: &Cutter, points: &[GridPoint], overlap: &mut Overlap) {
        if stock.may_meet(&cutter.holder_window.moved(&Window::around(points))) {
            self.holder.extend(met(stock, &cutter.holder, points, overlap));
        }
    }

    /// True if what may have been touched is enough to look more closely.
    pub(super) fn matters(&self) -> bool {
        [&self.flank, &self.holder].iter().any(|rings| grid::area_of(rings) > CONTACT_AREA_MM2)
    }
}

/// The edges of a tool that cannot cut and may come near stock on their way.
#[derive(Debug)]
pub(super) struct NearEdges<'c> {
    back: Cow<'c, [Edge]>,
    holder: Cow<'c, [Edge]>,
}

impl<'c> NearEdges<'c> {
    /// The edges near to stock along a path. What the path takes away brings none nearer.
    pub(super) fn of(cutter: &'c Cutter, stock: &Stock, path: &[GridPoint]) -> Self {
        let way = Window::around(path);
        let near = |edges: &'c [Edge], window: &Window| -> Cow<'c, [Edge]> {
            if edges.is_empty() || !stock.may_meet(&window.moved(&way)) {
                return Cow::Borrowed(&[]);
            }
            if path.len() <= 2 {
                // Each is looked at more closely once only.
                return Cow::Borrowed(edges);
            }
            edges.iter().filter(|edge| stock.may_meet(&Window::around(*edge).moved(&way))).copied().collect()
        };
        Self {
            back: near(&cutter.back, &cutter.back_window),
            holder: near(&cutter.holder_edges, &cutter.holder_window),
        }
    }

    /// True if none comes near.
    pub(super) fn is_empty(&self) -> bool {
        self.back.is_empty() && self.holder.is_empty()
    }
}

/// Adds the stock that edges cover on a straight step.
fn touch(
    rings: &mut Vec<Ring>,
    stock: &Stock,
    edges: impl Iterator<Item = Edge>,
    step: [GridPoint; 2],
    overlap: &mut Overlap,
) {
    for edge in edges {
        let corners = swept_corners(edge, step);
        let window = Window::around(&corners);
        rings.extend(stock.shared(&Columns::of_convex(&hull(corners.to_vec())), &window, overlap).rings());
    }
}

/// The corners of what an edge covers on a straight step.
fn swept_corners([a, b]: Edge, [from, to]: [GridPoint; 2]) -> [GridPoint; 4] {
    [plus(a, from), plus(b, from), plus(b, to), plus(a, to)]
}

fn direction([from, to]: [GridPoint; 2]) -> (f64, f64) {
    (f64::from(to.x) - f64::from(from.x), f64::from(to.y) - f64::from(from.y))
}

/// True if an edge of a counter-clockwise outline looks along a direction.
fn faces(edge: &Edge, along: (f64, f64)) -> bool {
    let (x, y) = direction(*edge);
    along.0 * y - along.1 * x > 0.0
}

/// The parts of an edge from which nothing of the convex pieces is seen when looking along a direction.
fn in_the_open(edge: Edge, along: (f64, f64), pieces: &[Ring]) -> Vec<Edge> {
    let mut open = vec![(0.0, 1.0)];
    for (from, to) in pieces.iter().filter_map(|piece| shaded(edge, along, piece)) {
        let parts = open.iter().flat_map(|&(a, b): &(f64, f64)| [(a, b.min(from)), (a.max(to), b)]);
        open = parts.filter(|(a, b)| a < b).collect();
    }
    let (x, y) = direction(edge);
    #[allow(clippy::cast_possible_truncation, reason = "between two points of the grid")]
    let at = |t: f64| GridPoint::new(edge[0].x + (x * t).round() as i32, edge[0].y + (y * t).round() as i32);
    open.into_iter().map(|(a, b)| [at(a), at(b)]).collect()
}

/// The part of an edge from which a convex piece is seen when looking along a direction, as fractions of its length.
fn shaded(edge: Edge, along: (f64, f64), piece: &[GridPoint]) -> Option<(f64, f64)> {
    let mut part = (0.0_f64, 1.0_f64);
    // Keeps what lies deeper than a touch to the left of a line through a point.
    let mut keep = |p: GridPoint, (x, y): (f64, f64)| {
        let depth = |q: GridPoint| x * (f64::from(q.y) - f64::from(p.y)) - y * (f64::from(q.x) - f64::from(p.x));
        let needed = TOUCH * (x * x + y * y).sqrt();
        let (a, b) = (depth(edge[0]) - needed, depth(edge[1]) - needed);
        if a <= 0.0 && b <= 0.0 {
            part = (1.0, 0.0);
        } else if a <= 0.0 {
            part.0 = part.0.max(a / (a - b));
        } else if b <= 0.0 {
            part.1 = part.1.min(a / (a - b));
        }
    };
    // Between the two lines along the direction that hold the piece, and behind its edges that look that way.
    let across = |p: &GridPoint| along.0 * f64::from(p.y) - along.1 * f64::from(p.x);
    let right = piece.iter().min_by(|a, b| across(a).total_cmp(&across(b)))?;
    let left = piece.iter().max_by(|a, b| across(a).total_cmp(&across(b)))?;
    keep(*right, along);
    keep(*left, (-along.0, -along.1));
    for (a, b) in grid::edges(piece).filter(|&(a, b)| faces(&[a, b], along)) {
        keep(a, direction([a, b]));
    }
    (part.0 < part.1).then_some(part)
}
