//! A row of figures beside a view, with the lines that lead to them.

use super::marks::{Line, Mark};
use super::outline::SAME_MM;
use crate::geometry::{Point, Segment, Vector};
use crate::papers::arrow;
use crate::papers::font;
use crate::papers::labels::spread_within;
use crate::papers::page::{Align, Page, Pen};
use crate::papers::view::View;

/// Height of the capitals of dimensions, mm.
pub(super) const TEXT_MM: f64 = 2.5;
/// Distance from one figure to the next, mm.
pub(super) const GAP_MM: f64 = 4.0;
/// Distance of a figure's line from the view before it may bend, mm.
const CLEAR_MM: f64 = 3.0;
/// Distance of the running dimension line from the view, mm.
const RUNNING_MM: f64 = 6.0;
/// From the running dimension line to where the extension lines may bend, mm.
const BEHIND_RUNNING_MM: f64 = 2.5;
/// Least and greatest height of the slanting parts of the lines, mm.
const SLANT_MM: (f64, f64) = (4.0, 16.0);
/// Height of the slanting parts as a share of the widest shift.
const STEEPNESS: f64 = 0.3;
/// Straight end of a line before its figure, and the air between them, mm.
const STUB_MM: f64 = 1.5;
/// Air between a line and its figure, mm.
const AIR_MM: f64 = 0.8;
/// How far a leader leaves to the side where it must keep off a face, mm: the first that keeps clear of other lines.
const LEAN_MM: [f64; 4] = [1.6, 2.4, 0.9, 3.2];
/// Lines that are this far apart keep clear of each other, mm.
const CLEAR_LINES_MM: f64 = 0.8;
/// Distance to the next line from which on a leader has an arrow head, mm.
const ARROW_ROOM_MM: f64 = 1.4;
/// Distance between extension lines from which on the running dimension has arrow heads, mm.
const RUNNING_ARROW_ROOM_MM: f64 = 4.5;
/// Half of the oblique stroke where there is no room for an arrow head, mm.
const STROKE_MM: f64 = 0.9;
/// Radius of the sign of a running dimension's origin, mm.
const ORIGIN_MM: f64 = 1.0;
/// The running dimension line begins this far before its first place where the origin is not in the row, mm.
const BEFORE_MM: f64 = 6.0;
/// Gap between an outline and its extension line, mm.
const EXTENSION_GAP_MM: f64 = 0.8;

/// Where a row stands.
#[derive(Debug, Clone, Copy)]
pub(super) struct Place {
    /// 1 above the view, −1 below it.
    pub(super) side: f64,
    /// Which half of the part its lines begin at: 1 the upper, −1 the lower.
    pub(super) half: f64,
    /// Height on the page of the edge of the view.
    pub(super) edge_r: f64,
}

/// Figures with their places along the row.
pub(super) struct Row {
    /// Marks with where their lines leave the view and where the figures stand, along the page, mm.
    marks: Vec<(Mark, f64, f64)>,
    slant: f64,
    running: bool,
}

impl Row {
    /// Places for all marks within `from..=to` along the page, mm; `None` if there is no room for so many.
    pub(super) fn new(marks: Vec<Mark>, view: &View, (from, to): (f64, f64)) -> Option<Self> {
        if marks.len() as f64 * GAP_MM > to - from + GAP_MM {
            return None;
        }
        let straight: Vec<f64> = marks.iter().filter(|m| m.line.lean() == 0.0).map(|m| view.place(m.at).z).collect();
        let leave = |mark: &Mark| view.place(mark.at).z + free_lean(mark.line.lean(), view.place(mark.at).z, &straight);
        let mut marks: Vec<(Mark, f64)> = marks.into_iter().map(|m| (leave(&m), m)).map(|(x, m)| (m, x)).collect();
        marks.sort_by(|a, b| a.1.total_cmp(&b.1));
        let wanted: Vec<f64> = marks.iter().map(|m| m.1).collect();
        let places = spread_within(&wanted, GAP_MM, from, to)?;
        let widest = wanted.iter().zip(&places).map(|(w, p)| (w - p).abs()).fold(0.0, f64::max);
        let slant = if widest < 1e-6 { 0.0 } else { (widest * STEEPNESS).clamp(SLANT_MM.0, SLANT_MM.1) };
        let running = marks.iter().any(|m| m.0.line == Line::Extension);
        let marks = marks.into_iter().zip(places).map(|((mark, x), place)| (mark, x, place)).collect();
        Some(Self { marks, slant, running })
    }

    /// Room from the edge of the view to the end of the longest figure, mm.
    pub(super) fn height_mm(&self) -> f64 {
        let longest = self.marks.iter().map(|m| font::width_mm(&m.0.text, TEXT_MM, false)).fold(0.0, f64::max);
        if self.marks.is_empty() { 0.0 } else { self.text_h() + longest }
    }

    fn bend_h(&self) -> f64 {
        if self.running { RUNNING_MM + BEHIND_RUNNING_MM } else { CLEAR_MM }
    }

    fn text_h(&self) -> f64 {
        self.bend_h() + self.slant + STUB_MM + AIR_MM
    }

    /// Draws lines and figures.
    pub(super) fn draw(&self, page: &mut Page, view: &View, place: Place) {
        let at = |x: f64, h: f64| Point::new(x, place.edge_r + place.side * h);
        let (bend, text_h) = (self.bend_h(), self.text_h());
        for (k, (mark, x, text_x)) in self.marks.iter().enumerate() {
            let tip = view.place(Point::new(mark.at.z, place.half * mark.at.r));
            let outward = Vector::new(0.0, place.side);
            let mut points = match mark.line {
                Line::Extension => vec![tip + outward * EXTENSION_GAP_MM],
                Line::Leader(_) if (x - tip.z).abs() > 1e-9 => {
                    vec![tip, Point::new(*x, tip.r + place.side * LEAN_MM[0])]
                }
                Line::Leader(_) => vec![tip],
            };
            points.extend([at(*x, bend), at(*text_x, bend + self.slant), at(*text_x, text_h - AIR_MM)]);
            points.dedup_by(|a, b| a.distance(*b) < 1e-6);
            page.path(points.windows(2).map(|w| Segment::line(w[0], w[1])).collect(), Pen::THIN);
            if mark.line != Line::Extension && self.has_air(k) {
                let from = points.get(1).copied().unwrap_or(tip);
                arrow::head(page, tip, tip - from);
            }
            let align = if place.side > 0.0 { Align::Start } else { Align::End };
            let base_line = at(*text_x + TEXT_MM / 2.0, text_h);
            page.upright_text(base_line, TEXT_MM, align, mark.text.clone());
        }
        if self.running {
            self.draw_running(page, |x| at(x, RUNNING_MM));
        }
    }

    /// True if no other line of the row is so close that arrow heads would run into each other.
    fn has_air(&self, k: usize) -> bool {
        let x = |k: Option<usize>| k.and_then(|k| self.marks.get(k)).map(|m| m.1);
        let close = |other: Option<f64>| {
            other.zip(x(Some(k))).is_some_and(|(other, here)| (1e-6..ARROW_ROOM_MM).contains(&(other - here).abs()))
        };
        !close(x(k.checked_sub(1))) && !close(x(Some(k + 1)))
    }

    /// The line of the running dimensions (ISO 129-1) with its origin, if it is in the row, and an arrow head or a stroke at
    /// every other place.
    fn draw_running(&self, page: &mut Page, at: impl Fn(f64) -> Point) {
        let extensions = self.marks.iter().filter(|m| m.0.line == Line::Extension);
        let origin = extensions.clone().any(|m| m.0.at.z.abs() < SAME_MM);
        let places: Vec<f64> = extensions.map(|m| m.1).collect();
        let (Some(first), Some(last)) = (places.first().copied(), places.last().copied()) else { return };
        let from = if origin { first + ORIGIN_MM } else { first - BEFORE_MM };
        page.line(at(from), at(last), Pen::THIN);
        if origin {
            let (left, right) = (at(first - ORIGIN_MM), at(first + ORIGIN_MM));
            let half = |start, end| Segment::Arc { start, end, center: at(first), ccw: true };
            page.path(vec![half(right, left), half(left, right)], Pen::THIN);
        } else {
            arrow::head(page, at(first), Vector::new(1.0, 0.0));
        }
        for pair in places.windows(2) {
            let (tip, room) = (at(pair[1]), pair[1] - pair[0]);
            if room >= RUNNING_ARROW_ROOM_MM {
                arrow::head(page, tip, Vector::new(1.0, 0.0));
            } else {
                let oblique = Vector::new(STROKE_MM, STROKE_MM);
                page.line(tip - oblique, tip + oblique, Pen::THIN);
            }
        }
    }
}

/// How far to the side `lean` a leader from `x` leaves so that it runs into none of the `others`, mm along the page.
fn free_lean(lean: f64, x: f64, others: &[f64]) -> f64 {
    let free = |shift: &&f64| others.iter().all(|other| (x + lean * **shift - other).abs() >= CLEAR_LINES_MM);
    lean * LEAN_MM.iter().find(free).unwrap_or(&LEAN_MM[0])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::papers::page::Item;

    const VIEW: View = View { origin: Point::new(0.0, 100.0), scale: 1.0 };

    fn mark(z: f64, line: Line, text: &str) -> Mark {
        Mark { at: Point::new(z, 20.0), line, text: text.to_owned() }
    }

    #[test]
    fn figures_keep_their_distance_and_their_lines_do_not_cross() {
        let marks = (0..12).map(|k| mark(50.0 + 0.3 * f64::from(k), Line::Leader(0.0), "Ø 40")).collect();
        let row = Row::new(marks, &VIEW, (4.0, 200.0)).unwrap();
        let mut page = Page::new(210.0, 297.0, "");
        row.draw(&mut page, &VIEW, Place { side: 1.0, half: 1.0, edge_r: 120.0 });
        let texts: Vec<f64> =
            page.items.iter().filter_map(|i| if let Item::Text { at, .. } = i { Some(at.z) } else { None }).collect();
        assert_eq!(texts.len(), 12);
        assert!(texts.windows(2).all(|w| w[1] - w[0] >= GAP_MM - 1e-9), "{texts:?}");
        let highest =
            page.items.iter().filter_map(|i| if let Item::Path { path, .. } = i { path.bounds() } else { None });
        assert!(highest.map(|b| b.max.r).fold(0.0, f64::max) < 120.0 + row.height_mm(), "lines end below the figures");
    }

    #[test]
    fn a_row_that_is_too_short_for_its_figures_is_refused() {
        let marks = |count: u32| (0..count).map(|k| mark(f64::from(k), Line::Extension, "1")).collect();
        assert!(Row::new(marks(10), &VIEW, (0.0, 40.0)).is_some());
        assert!(Row::new(marks(12), &VIEW, (0.0, 40.0)).is_none());
    }

    #[test]
    fn a_leader_that_keeps_off_a_face_keeps_off_other_leaders_too() {
        assert_eq!(free_lean(1.0, 10.0, &[]), 1.6);
        assert_eq!(free_lean(1.0, 10.0, &[11.5]), 2.4);
        assert_eq!(free_lean(-1.0, 10.0, &[8.4, 7.7]), -3.2);
        assert_eq!(free_lean(0.0, 10.0, &[10.0]), 0.0);
    }
}
