//! What no tool could reach.

use super::chain::{Chain, Run};
use super::piece::{Piece, SAME_MM};
use super::work::Work;
use crate::geometry::{Point, Segment};
use crate::part::PartContour;
use std::collections::BTreeMap;

/// Less than this is not spoken of, mm: what a drawing calls a sharp corner.
pub(super) const SPOKEN_OF_MM: f64 = 0.02;

/// Places looked at along what of a segment of the contour lies under one stretch of stock.
const PLACES: u32 = 16;

/// Material that stays on a row of the part.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Left {
    /// Id of the row.
    pub(super) section: u32,
    /// Largest way from the contour through the stock into the open, mm.
    pub(super) height: f64,
    /// Where it is largest.
    pub(super) at: Point,
}

/// The rows of `contour` on which stock is left, with the largest height of each, in order of ids.
pub(super) fn measure(work: &Work, contour: &PartContour) -> Vec<Left> {
    let mut rows: BTreeMap<u32, Left> = BTreeMap::new();
    for run in work.stock.between(work.from_z, f64::INFINITY).runs_over(&work.part, SPOKEN_OF_MM) {
        let stock = work.stock.between(run.z0, run.z1);
        for (section, at) in places_under(&run, contour) {
            let height = height_over(&stock, at).min(work.end_z() - at.z);
            let row = rows.entry(section).or_insert(Left { section, height, at });
            if height > row.height {
                *row = Left { section, height, at };
            }
        }
    }
    rows.into_values().filter(|left| left.height > SPOKEN_OF_MM).collect()
}

/// Places along the contour under a stretch, each with the id of its row, in order of z.
pub(super) fn places_under(run: &Run, contour: &PartContour) -> impl Iterator<Item = (u32, Point)> {
    let (segments, run) = (&contour.contour.segments, *run);
    let first = segments.partition_point(|s| s.end().z < run.z0 - SAME_MM);
    let here = segments.iter().zip(&contour.sections).skip(first);
    let here = here.take_while(move |(s, _)| s.start().z <= run.z1 + SAME_MM);
    here.flat_map(move |(segment, &section)| {
        let clamped = move |p: Point| Point::new(p.z.clamp(run.z0, run.z1), p.r);
        places(segment, &run).into_iter().map(move |p| (section, clamped(p)))
    })
}

/// Places along what of a segment lies within a stretch; a face stands at its end, up to rounding.
fn places(segment: &Segment, run: &Run) -> Vec<Point> {
    let share = |k: u32| f64::from(k) / f64::from(PLACES);
    let Some(piece) = Piece::of(segment) else {
        let inside = |p: &Point| p.z >= run.z0 - SAME_MM && p.z <= run.z1 + SAME_MM;
        return (0..=PLACES).map(|k| segment.point_at(share(k))).filter(inside).collect();
    };
    let (from, to) = (piece.z0.max(run.z0), piece.z1.min(run.z1));
    let at = |k: u32| from + (to - from).max(0.0) * share(k);
    (0..=PLACES).map(|k| Point::new(at(k), piece.at(at(k)))).collect()
}

/// Distance of a point under the stock's surface from it, mm; 0 in the open.
pub(super) fn height_over(stock: &Chain, p: Point) -> f64 {
    let Some(above) = stock.at(p.z).map(|r| r - p.r).filter(|above| *above > 0.0) else { return 0.0 };
    let near = stock.over(p.z - above, p.z + above);
    let along = near.iter().map(|piece| piece.towards_chuck().distance_to(p));
    let faces = near.windows(2).map(|w| Segment::line(w[0].right(), w[1].left()).distance_to(p));
    along.chain(faces).fold(above, f64::min)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_narrow_ridge_on_a_long_row_is_found() {
        let row = Segment::line(Point::new(0.0, 5.0), Point::new(40.0, 5.0));
        let contour = PartContour { contour: crate::geometry::Contour::new(vec![row]), sections: vec![7] };
        let part = Chain::level(0.0, 40.0, 5.0);
        let mut work = Work::of(part.clone(), part, &Chain::default(), (0.0, 40.0), 0.0);
        let ridge = Chain {
            pieces: vec![
                Piece::line(Point::new(21.3, 5.0), Point::new(21.35, 5.05)),
                Piece::line(Point::new(21.35, 5.05), Point::new(21.4, 5.0)),
            ],
        };
        work.stock = work.stock.chain().max(&ridge).into();
        let left = measure(&work, &contour);
        assert!(
            left.len() == 1 && left[0].section == 7 && (left[0].height - 0.05 / 2.0_f64.sqrt()).abs() < 0.002,
            "{left:?}"
        );
    }
}
