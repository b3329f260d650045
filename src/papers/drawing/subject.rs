//! What a drawing shows.

use super::figure;
use super::marks::{self, Line, Mark, Source};
use super::outline::{Outline, SAME_MM};
use crate::diagnostic::{Diagnostic, Place};
use crate::document::{Document, TurnedPart};
use crate::geometry::{Bounds, Point, Segment};
use crate::part::{PieceRole, Section};
use crate::regen::Derived;

/// The finished part of a document.
pub(super) struct Subject<'a> {
    pub(super) document: &'a Document,
    /// The part in the document's unit.
    pub(super) part: &'a TurnedPart,
    rows_mm: TurnedPart,
    pub(super) outside: Outline,
    /// The bore, if there is one.
    pub(super) bore: Option<Outline>,
    /// Around the outside, mm.
    pub(super) bounds: Bounds,
    /// Diameters, radii, chamfers and threads of the outside, the largest diameter excepted: it is told beside the view.
    pub(super) outside_leaders: Vec<Mark>,
    /// Positions of the outside.
    pub(super) outside_positions: Vec<Mark>,
    /// Everything about the bore.
    pub(super) bore_marks: Vec<Mark>,
}

impl<'a> Subject<'a> {
    /// The part of `derived` in the space of its first clamping, whose positions are those of the document.
    ///
    /// # Errors
    /// A diagnostic if no row of the section table makes an outline.
    pub(super) fn new(derived: &'a Derived) -> Result<Self, Diagnostic> {
        let first = derived.setups.iter().find(|s| !s.setup.turned_round);
        let outside = first.map(|s| Outline::new(&s.setup.profile, &s.contour)).unwrap_or_default();
        let bore = first.and_then(|s| Some(Outline::new(s.setup.bore.as_ref()?, s.bore.as_ref().as_ref()?)));
        Self::with(&derived.document, outside, bore)
    }

    /// The part with these outlines.
    pub(super) fn with(document: &'a Document, outside: Outline, bore: Option<Outline>) -> Result<Self, Diagnostic> {
        let part = document.content.turned_part();
        let Some((part, bounds)) =
            part.zip(outside.bounds().filter(|b| b.max.r > SAME_MM && b.max.z - b.min.z > SAME_MM))
        else {
            let message = "There is no part to draw: no row of the section table makes an outline.";
            return Err(Diagnostic::error("nothing-to-draw", Place::Document, message));
        };
        let bore = bore.filter(|bore| !bore.segments.is_empty());
        let (rows_mm, unit) = (part.scaled(document.unit.in_mm()), document.unit);
        let mut outside_leaders = marks::leaders(&outside, Source { rows_mm: &rows_mm.sections, inside: false, unit });
        let largest = figure::diameter(bounds.max.r, unit);
        if let Some(told) = outside_leaders.iter().position(|mark| mark.text == largest) {
            outside_leaders.remove(told);
        }
        let outside_positions = marks::positions(&outside, unit);
        let source = Source { rows_mm: &rows_mm.bore, inside: true, unit };
        let bore_marks = bore.as_ref().map(|bore| bore_marks(bore, &outside, source)).unwrap_or_default();
        Ok(Self { document, part, rows_mm, outside, bore, bounds, outside_leaders, outside_positions, bore_marks })
    }

    /// Core lines of the threads with the ends of their threads at the crest: outside first, then those of the bore.
    pub(super) fn threads(&self) -> [Vec<ThreadLine>; 2] {
        let outside = threads(&self.outside, &self.rows_mm.sections);
        [outside, self.bore.as_ref().map(|bore| threads(bore, &self.rows_mm.bore)).unwrap_or_default()]
    }
}

/// Everything about the bore; positions count from the same end of the part as those of the outside.
fn bore_marks(bore: &Outline, outside: &Outline, source: Source<'_>) -> Vec<Mark> {
    let mut all = marks::leaders(bore, source);
    let positions = marks::positions(bore, source.unit);
    if positions.first().is_some_and(|first| first.at.z > SAME_MM) {
        let corner = Point::new(0.0, outside.largest_radius(0.0, 2.0 * SAME_MM));
        all.push(Mark { at: corner, line: Line::Extension, text: "0".to_owned() });
    }
    all.extend(positions);
    all
}

/// The line of a thread's root.
pub(super) struct ThreadLine {
    /// The line, mm of the part, above the axis.
    pub(super) root: Segment,
    /// Where the thread ends on its cylinder.
    pub(super) ends: [Point; 2],
}

fn threads(outline: &Outline, rows_mm: &[Section]) -> Vec<ThreadLine> {
    let of_threads = outline.pieces.iter().filter(|piece| piece.role == PieceRole::Thread);
    let lines = of_threads.filter_map(|piece| {
        let row = rows_mm.iter().find(|row| row.id == piece.section)?;
        let (start, end) = (piece.start(), piece.end());
        let at_root = |p: Point| Point::new(p.z, row.d2 / 2.0);
        Some(ThreadLine { root: Segment::line(at_root(start), at_root(end)), ends: [start, end] })
    });
    lines.collect()
}
