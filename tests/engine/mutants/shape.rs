//! The shape that a path leaves, found in another way than the proof's: a height for every column of the work, lowered by the
//! lower border of the insert along every move. Only the order of the moves is the proof's.

use turnwright::geometry::{Contour, Point, Segment};
use turnwright::machine::ToolOutline;
use turnwright::proof::{Motion, Move, ProofInput};

/// Width of a column, mm.
const COLUMN_MM: f64 = 0.02;
/// Chords of arcs stay within this of them, mm.
const CHORD_MM: f64 = 0.001;

/// The heights at the end, and the deepest that a rapid move went into the stock.
pub(crate) struct Shape {
    from: f64,
    heights: Vec<f64>,
    pub(crate) rapid_contact_mm: f64,
}

/// Lower border of an insert: corners from left to right.
fn lower_border(insert: &Contour) -> Vec<Point> {
    let mut points = insert.polyline(CHORD_MM / 2.0);
    points.sort_by(|a, b| a.z.total_cmp(&b.z).then(a.r.total_cmp(&b.r)));
    let mut hull: Vec<Point> = Vec::new();
    for p in points {
        while let [.., a, b] = hull.as_slice()
            && (b.z - a.z) * (p.r - a.r) - (b.r - a.r) * (p.z - a.z) <= 0.0
        {
            hull.pop();
        }
        hull.push(p);
    }
    hull
}

fn border_at(border: &[Point], z: f64) -> f64 {
    let (Some(first), Some(last)) = (border.first(), border.last()) else { return f64::INFINITY };
    if z < first.z || z > last.z {
        return f64::INFINITY;
    }
    let k = border.partition_point(|p| p.z < z).clamp(1, border.len() - 1);
    let (a, b) = (border[k - 1], border[k]);
    if b.z > a.z { a.r + (b.r - a.r) * (z - a.z) / (b.z - a.z) } else { a.r.min(b.r) }
}

impl Shape {
    /// Cuts the stock of an input along moves.
    pub(crate) fn of(input: &ProofInput, moves: &[Move]) -> Self {
        let bounds = input.work.as_ref().unwrap().stock.bounds().unwrap();
        let count = ((bounds.max.z - bounds.min.z) / COLUMN_MM).floor() as usize;
        let mut shape = Self { from: bounds.min.z, heights: vec![bounds.max.r; count], rapid_contact_mm: 0.0 };
        for m in moves {
            let Some(tool) = input.tools.get(&m.tool) else { continue };
            shape.cut(m, tool);
        }
        shape
    }

    fn cut(&mut self, m: &Move, tool: &ToolOutline) {
        let border = lower_border(&tool.insert);
        let points: Vec<Point> = match m.path {
            Segment::Line { start, end } => vec![start, end],
            Segment::Arc { start, .. } => std::iter::once(start).chain(m.path.polyline_points(CHORD_MM)).collect(),
        };
        let rapid = matches!(m.motion, Motion::Rapid | Motion::Pause);
        for ends in points.windows(2) {
            let touched = self.cut_along(ends[0], ends[1], &border);
            if rapid {
                self.rapid_contact_mm = self.rapid_contact_mm.max(touched);
            }
        }
    }

    /// Lowers the columns along a straight way and returns the deepest cut.
    fn cut_along(&mut self, a: Point, b: Point, border: &[Point]) -> f64 {
        let (left, right) = (border[0].z, border[border.len() - 1].z);
        let first = ((a.z.min(b.z) + left - self.from) / COLUMN_MM).floor().max(0.0) as usize;
        let last =
            ((a.z.max(b.z) + right - self.from) / COLUMN_MM).ceil().clamp(0.0, self.heights.len() as f64) as usize;
        let lowest = a.r.min(b.r) + border.iter().map(|p| p.r).fold(f64::INFINITY, f64::min);
        let mut deepest: f64 = 0.0;
        let mut before = first.checked_sub(1).and_then(|k| self.heights.get(k)).copied().unwrap_or_default();
        for column in first..last {
            if self.heights[column] <= lowest {
                before = self.heights[column];
                continue;
            }
            let z = self.from + (column as f64 + 0.5) * COLUMN_MM;
            let height = lowest_along(a, b, border, z);
            // Beside a wall a column may be half in the stock: what lies deeper than its neighbours counts.
            let right = self.heights.get(column + 1).copied().unwrap_or_default();
            deepest = deepest.max(self.heights[column].min(right).min(before) - height);
            before = self.heights[column];
            self.heights[column] = before.min(height);
        }
        deepest
    }

    /// Largest difference in radius to another shape, each column compared with the range of its neighbours, so that a wall
    /// that moves by less than a column does not count.
    pub(crate) fn difference(&self, other: &Self) -> f64 {
        let range = |shape: &Self, k: usize| {
            let near = &shape.heights[k.saturating_sub(1)..(k + 2).min(shape.heights.len())];
            near.iter().fold((f64::INFINITY, 0.0_f64), |(low, high), h| (low.min(*h), high.max(*h)))
        };
        let apart = |k: usize| {
            let beyond = |h: f64, (low, high): (f64, f64)| (h - high).max(low - h).max(0.0);
            beyond(self.heights[k], range(other, k)).max(beyond(other.heights[k], range(self, k)))
        };
        (0..self.heights.len()).map(apart).fold(0.0, f64::max)
    }
}

/// Lowest place of the border over a column while it moves from `a` to `b`. The border is convex, so that place falls and then
/// rises along the way.
fn lowest_along(a: Point, b: Point, border: &[Point], z: f64) -> f64 {
    let (left, right) = (border[0].z, border[border.len() - 1].z);
    let dz = b.z - a.z;
    // The part of the way on which the border is over the column.
    let (mut low, mut high) = (0.0_f64, 1.0_f64);
    if dz.abs() > 1e-9 {
        let (t1, t2) = ((z - right - a.z) / dz, (z - left - a.z) / dz);
        low = low.max(t1.min(t2));
        high = high.min(t1.max(t2));
    }
    if low > high {
        return f64::INFINITY;
    }
    let height = |t: f64| a.r + (b.r - a.r) * t + border_at(border, (z - a.z - dz * t).clamp(left, right));
    if dz.abs() <= 1e-9 {
        let inside = (left..=right).contains(&(z - a.z));
        return if inside { height(0.0).min(height(1.0)) } else { f64::INFINITY };
    }
    for _ in 0..40 {
        let (t1, t2) = (low + (high - low) / 3.0, high - (high - low) / 3.0);
        if height(t1) <= height(t2) { high = t2 } else { low = t1 }
    }
    height(f64::midpoint(low, high)).min(height(low)).min(height(high))
}
