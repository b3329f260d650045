//! Filled regions as meshes, and their triangulation.

use super::canvas::Screen;
use crate::geometry::{Point, Vector};
use egui::{Color32, Mesh, Painter};
use i_triangle::float::triangulatable::Triangulatable;

/// A region cut into triangles, in part space.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct Triangles {
    points: Vec<Point>,
    indices: Vec<u32>,
}

impl Triangles {
    /// The region inside `rings`: outer ones counter-clockwise, holes clockwise.
    pub(super) fn of(rings: &[Vec<Point>]) -> Self {
        let sound = |ring: &&Vec<Point>| ring.len() > 2 && ring.iter().all(|p| p.is_finite());
        let shape: Vec<Vec<[f64; 2]>> =
            rings.iter().filter(sound).map(|ring| ring.iter().map(|p| [p.z, p.r]).collect()).collect();
        if shape.is_empty() {
            return Self::default();
        }
        let found = shape.triangulate().to_triangulation::<u32>();
        Self { points: found.points.iter().map(|&[z, r]| Point::new(z, r)).collect(), indices: found.indices }
    }

    /// The region between the spindle axis and a line along which z never decreases.
    pub(super) fn under(line: &[Point]) -> Self {
        Self::between(line, &[])
    }

    /// The region between two lines along both of which z never decreases; where there is no lower one, down to the axis.
    pub(super) fn between(upper: &[Point], lower: &[Point]) -> Self {
        let (Some(first), Some(last)) = (upper.first(), upper.last()) else { return Self::default() };
        let inside = lower.iter().map(|p| p.z).filter(|&z| z > first.z && z < last.z);
        let mut stops: Vec<f64> = upper.iter().map(|p| p.z).chain(inside).collect();
        stops.sort_by(f64::total_cmp);
        stops.dedup();
        let (mut above, mut below) = (Along::new(upper), Along::new(lower));
        let mut points = Vec::with_capacity(4 * stops.len());
        for (&z1, &z2) in stops.iter().zip(stops.iter().skip(1)) {
            let (top, bottom) = (above.between(z1, z2), below.between(z1, z2));
            let place = |[r1, r2]: [f64; 2]| [Point::new(z1, r1), Point::new(z2, r2)];
            let ([a, b], [c, d]) = (place(bottom.unwrap_or_default()), place(top.unwrap_or_default()));
            points.extend([a, c, b, d]);
        }
        let strips = u32::try_from(points.len() / 4).unwrap_or(0);
        let indices = (0..strips).flat_map(|k| [0, 1, 2, 2, 1, 3].map(|corner| 4 * k + corner)).collect();
        Self { points, indices }
    }

    /// Fills the region.
    pub(super) fn fill(&self, painter: &Painter, screen: &Screen, color: Color32) {
        self.fill_with(painter, color, |p| screen.pos(p));
    }

    /// Fills the region moved by `by`, mm.
    pub(super) fn fill_moved(&self, painter: &Painter, screen: &Screen, by: Vector, color: Color32) {
        self.fill_with(painter, color, |p| screen.pos(p + by));
    }

    /// Fills the region mirrored at the spindle axis.
    pub(super) fn fill_mirrored(&self, painter: &Painter, screen: &Screen, color: Color32) {
        self.fill_with(painter, color, |p| screen.pos(mirrored(p)));
    }

    fn fill_with(&self, painter: &Painter, color: Color32, place: impl Fn(Point) -> egui::Pos2) {
        if self.indices.is_empty() {
            return;
        }
        let mut mesh = Mesh::default();
        for &p in &self.points {
            mesh.colored_vertex(place(p), color);
        }
        mesh.indices.clone_from(&self.indices);
        painter.add(mesh);
    }

    /// Area, mm².
    #[cfg(test)]
    fn area(&self) -> f64 {
        let corner = |k: usize| self.points[self.indices[k] as usize];
        (0..self.indices.len() / 3)
            .map(|t| {
                let (a, b, c) = (corner(3 * t), corner(3 * t + 1), corner(3 * t + 2));
                ((b - a).perp(&(c - a)) / 2.0).abs()
            })
            .sum()
    }
}

/// A walk along a line whose z never decreases.
struct Along<'a> {
    rest: &'a [Point],
}

impl<'a> Along<'a> {
    const fn new(line: &'a [Point]) -> Self {
        Self { rest: line }
    }

    /// Radii at two positions that no point of the line lies between; `None` beyond its ends. Positions must not go back.
    fn between(&mut self, z1: f64, z2: f64) -> Option<[f64; 2]> {
        let middle = f64::midpoint(z1, z2);
        while let [_, next, ..] = self.rest
            && next.z < middle
        {
            self.rest = self.rest.get(1..).unwrap_or_default();
        }
        let [a, b, ..] = self.rest else { return None };
        let at = |z: f64| a.r + (b.r - a.r) * ((z - a.z) / (b.z - a.z));
        (a.z < middle && b.z > a.z).then(|| [at(z1), at(z2)])
    }
}

/// The point mirrored at the spindle axis.
pub(super) const fn mirrored(p: Point) -> Point {
    Point::new(p.z, -p.r)
}

/// The ring without its edge along the spindle axis; the whole of it, closed, if it has none.
pub(super) fn from_axis_to_axis(ring: &[Point]) -> Vec<Point> {
    /// Points this near to the axis lie on it, mm.
    const ON_AXIS: f64 = 1e-6;
    let on_axis = |k: usize| ring.get(k % ring.len()).is_some_and(|p| p.r.abs() < ON_AXIS);
    let along_axis = (0..ring.len()).find(|&k| on_axis(k) && on_axis(k + 1));
    let start = along_axis.map_or(0, |k| k + 1);
    let closing = usize::from(along_axis.is_none() && !ring.is_empty());
    ring.iter().cycle().skip(start).take(ring.len() + closing).copied().collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ring(points: &[(f64, f64)]) -> Vec<Point> {
        points.iter().map(|&(z, r)| Point::new(z, r)).collect()
    }

    #[test]
    fn a_region_with_a_hole_keeps_its_area() {
        let outer = ring(&[(0.0, 0.0), (10.0, 0.0), (10.0, 10.0), (0.0, 10.0)]);
        let hole = ring(&[(2.0, 2.0), (2.0, 4.0), (4.0, 4.0), (4.0, 2.0)]);
        assert!((Triangles::of(&[outer, hole]).area() - 96.0).abs() < 1e-3);
    }

    #[test]
    fn a_concave_line_is_filled_down_to_the_axis() {
        let line = ring(&[(0.0, 5.0), (4.0, 1.0), (4.0, 3.0), (10.0, 3.0)]);
        assert!((Triangles::under(&line).area() - (12.0 + 18.0)).abs() < 1e-9);
    }

    #[test]
    fn the_hole_of_a_part_is_left_free() {
        let outside = ring(&[(0.0, 5.0), (4.0, 5.0), (4.0, 8.0), (10.0, 8.0)]);
        let bore = ring(&[(6.0, 0.0), (6.0, 2.0), (8.0, 2.0), (8.0, 4.0), (10.0, 4.0)]);
        assert!((Triangles::between(&outside, &bore).area() - (20.0 + 48.0 - 4.0 - 8.0)).abs() < 1e-9);
    }

    #[test]
    fn a_ring_is_opened_at_the_axis() {
        let opened = from_axis_to_axis(&ring(&[(10.0, 5.0), (0.0, 5.0), (0.0, 0.0), (10.0, 0.0)]));
        assert_eq!(opened, ring(&[(10.0, 0.0), (10.0, 5.0), (0.0, 5.0), (0.0, 0.0)]));
    }

    #[test]
    fn rings_that_are_no_region_are_left_out() {
        assert_eq!(Triangles::of(&[ring(&[(0.0, 0.0), (1.0, 1.0)])]), Triangles::default());
        assert_eq!(Triangles::of(&[ring(&[(0.0, 0.0), (f64::NAN, 1.0), (3.0, 3.0)])]), Triangles::default());
    }
}
