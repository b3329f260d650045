//! What a drawing shows.

use super::marks::{self, Line, Mark, Source};
use super::outline::{Outline, SAME_MM};
use crate::diagnostic::{Diagnostic, Place};
use crate::document::{Content, Document, TurnedPart};
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
        let Content::TurnedPart(part) = &document.content;
        let Some(bounds) = outside.bounds().filter(|b| b.max.r > SAME_MM && b.max.z - b.min.z > SAME_MM) else {
            let message = "There is no part to draw: no row of the section table makes an outline.";
            return Err(Diagnostic::error("nothing-to-draw", Place::Document, message));
        };
        let bore = bore.filter(|bore| !bore.segments.is_empty());
        Ok(Self { document, part, rows_mm: part.scaled(document.unit.in_mm()), outside, bore, bounds })
    }

    fn source(&self, inside: bool) -> Source<'_> {
        let rows_mm = if inside { &self.rows_mm.bore } else { &self.rows_mm.sections };
        Source { rows_mm, inside, unit: self.document.unit }
    }

    /// Diameters, radii, chamfers and threads of the outside.
    pub(super) fn outside_leaders(&self) -> Vec<Mark> {
        marks::leaders(&self.outside, self.source(false))
    }

    /// Positions of the outside.
    pub(super) fn outside_positions(&self) -> Vec<Mark> {
        marks::positions(&self.outside, self.document.unit)
    }

    /// Everything about the bore; positions count from the same end of the part as those of the outside.
    pub(super) fn bore_marks(&self) -> Vec<Mark> {
        let Some(bore) = &self.bore else { return Vec::new() };
        let mut all = marks::leaders(bore, self.source(true));
        let positions = marks::positions(bore, self.document.unit);
        if positions.first().is_some_and(|first| first.at.z > SAME_MM) {
            let corner = Point::new(0.0, self.outside.largest_radius(0.0, 2.0 * SAME_MM));
            all.push(Mark { at: corner, line: Line::Extension, text: "0".to_owned() });
        }
        all.extend(positions);
        all
    }

    /// Core lines of the threads with the ends of their threads at the crest: outside first, then those of the bore.
    pub(super) fn threads(&self) -> [Vec<ThreadLine>; 2] {
        let outside = threads(&self.outside, &self.rows_mm.sections);
        [outside, self.bore.as_ref().map(|bore| threads(bore, &self.rows_mm.bore)).unwrap_or_default()]
    }
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
