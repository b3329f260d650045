//! Templates: the strip of every station, as large as the paper allows, at most ten times its size.

use super::{Placed, Subject, axis, draw_strip, placed, remark};
use crate::diagnostic::{Diagnostic, Place};
use crate::document::Origin;
use crate::papers::arrow;
use crate::papers::drawing::DrawingChoice;
use crate::papers::page::{Page, Pen};
use crate::regen::Derived;
use crate::rollform::bends::Stage;

/// Largest scale of a template: ten to one, as wire templates were made to.
const MOST: f64 = 10.0;

/// One page a station.
///
/// # Errors
/// A diagnostic if there is no station, or the scale asked for does not fit, with the largest that does.
pub(in crate::papers) fn templates(derived: &Derived, choice: DrawingChoice) -> Result<Vec<Page>, Diagnostic> {
    let subject = Subject::of(derived)?;
    let shapes: Vec<_> = subject.derived.flower.stations().collect();
    if shapes.is_empty() {
        let message = "There is no template to draw: the line has 0 stations.";
        return Err(Diagnostic::error("nothing-to-draw", Place::Document, message));
    }
    let count = shapes.len();
    let page = |(number, shape): (usize, &&crate::rollform::flower::Shape)| {
        let Stage::Station(index) = shape.stage else { return Ok(None) };
        let placed = placed(&shape.strip, choice, MOST)?;
        let name = format!("{} station {}", subject.document.name, index + 1);
        let mut page = subject.page(name, &placed.scale.name(), placed.paper, (number, count));
        draw_strip(&mut page, &placed.view, &shape.strip);
        // The bends' ends, where a wire is bent.
        for piece in shape.strip.pieces.iter().filter(|piece| piece.is_bent()) {
            for (bottom, top) in [(piece.bottom.start(), piece.top.start()), (piece.bottom.end(), piece.top.end())] {
                page.line(placed.view.place(bottom), placed.view.place(top), Pen::THIN);
            }
        }
        if subject.set.section.origin != Origin::LeftToRight && subject.set.section.origin != Origin::RightToLeft {
            axis(&mut page, &placed);
        }
        size_line(&mut page, &placed);
        remark(&mut page, placed.paper, &format!("Template of station {}", index + 1));
        page.part = Some(placed.view);
        Ok(Some(page))
    };
    (1..).zip(&shapes).map(page).filter_map(Result::transpose).collect()
}

/// A line of 10 mm of the strip, to check the print by.
fn size_line(page: &mut Page, placed: &Placed) {
    let room = crate::papers::frame::room(placed.paper);
    let from = crate::geometry::Point::new(room.min.z + 4.0, room.min.r + 5.0);
    let along = nalgebra::Vector2::new(10.0 * placed.scale.factor, 0.0);
    page.line(from, from + along, Pen::THIN);
    arrow::head(page, from, -along);
    arrow::head(page, from + along, along);
    page.text(from + along / 2.0 + nalgebra::Vector2::new(0.0, 1.5), 2.5, crate::papers::page::Align::Middle, "10 mm");
}
