//! Papers about the strip of a set of form-rolls: the drawing of its finished section, the templates of its stations, and the
//! stations with their rolls.

mod section;
mod station;
mod template;
#[cfg(test)]
mod tests;

use super::drawing::DrawingChoice;
use super::drawing::scale::{SCALES, Scale};
use super::frame::{self, Block, Field};
use super::number::number;
use super::page::{Align, Ink, Page, Paper, Pen};
use super::view::View;
use crate::diagnostic::{Diagnostic, Place};
use crate::document::{DevelopedWidth, Document, RollSet};
use crate::geometry::{Bounds, Point};
use crate::regen::{Derived, RollSetDerived};
use crate::rollform::developed::developed;
use crate::rollform::strip::Strip;
use crate::units::Unit;

pub(super) use section::section_drawing;
pub(super) use station::stations;
pub(super) use template::templates;

/// Room that dimensions need on every side of a view, mm.
const ASIDE_MM: f64 = 22.0;

/// A set with all that papers say about it.
struct Subject<'a> {
    document: &'a Document,
    /// In the unit of the document.
    set: &'a RollSet,
    derived: &'a RollSetDerived,
}

impl<'a> Subject<'a> {
    /// # Errors
    /// A diagnostic if the document is no set of form-rolls.
    fn of(derived: &'a Derived) -> Result<Self, Diagnostic> {
        let set = derived.document.content.roll_set().zip(derived.rolls.as_ref());
        let Some((set, of_set)) = set else {
            let message = "There is no strip to draw: the document is no set of form-rolls.";
            return Err(Diagnostic::error("nothing-to-draw", Place::Document, message));
        };
        Ok(Self { document: &derived.document, set, derived: of_set })
    }

    const fn unit(&self) -> Unit {
        self.document.unit
    }

    /// A length in mm as a drafter writes it.
    fn length(&self, mm: f64) -> String {
        number(mm, self.unit())
    }

    /// What the title block says.
    fn block(&self, name: String, scale: &str, sheet: (usize, usize)) -> Block {
        let in_mm = self.unit().in_mm();
        let section = &self.set.section;
        let width = developed(section, section.developed_width).width * in_mm;
        Block {
            name,
            upper: vec![
                Field::new("Material", self.set.strip.name.clone()),
                Field::new("Thickness", self.length(section.thickness * in_mm)),
                Field::new("Strip width", format!("{} ({})", self.length(width), method(section.developed_width))),
                Field::new("Dimensions in", self.unit().symbol().to_owned()),
            ],
            scale: scale.to_owned(),
            sheet,
        }
    }

    /// A page with frame and title block.
    fn page(&self, name: String, scale: &str, paper: Paper, sheet: (usize, usize)) -> Page {
        let mut page = frame::framed(paper, &name);
        frame::title_block(&mut page, paper, &self.block(name, scale, sheet));
        page
    }
}

/// What a method of the developed width is called in a title block.
const fn method(method: DevelopedWidth) -> &'static str {
    match method {
        DevelopedWidth::MeanLine => "r + t/2",
        DevelopedWidth::RolfomTable => "ROLFOM table",
        DevelopedWidth::Din6935 => "DIN 6935",
        DevelopedWidth::Asm | DevelopedWidth::AsmLessFormable => "ASM",
        DevelopedWidth::Angel => "Angel",
        DevelopedWidth::Own { .. } => "own k",
    }
}

/// Where a strip lies on its paper.
struct Placed {
    paper: Paper,
    scale: Scale,
    view: View,
    bounds: Bounds,
}

/// The strip in the middle of the free room of a paper: at the scale asked for, or the largest usual one up to `most` at
/// which it fits. Without a paper, the smallest on which it is at least at 1:1, or else the largest of all.
///
/// # Errors
/// A diagnostic with the largest scale that fits if the one asked for does not.
fn placed(strip: &Strip, choice: DrawingChoice, most: f64) -> Result<Placed, Diagnostic> {
    placed_within(strip.outline().bounds(), choice, most)
}

/// The same for anything that has these bounds.
fn placed_within(bounds: Option<Bounds>, choice: DrawingChoice, most: f64) -> Result<Placed, Diagnostic> {
    let Some(bounds) = bounds else {
        let message = "There is no strip to draw: the cross-section has 0 elements.";
        return Err(Diagnostic::error("nothing-to-draw", Place::Document, message));
    };
    let fits = |paper: Paper| permissible(bounds, paper).min(most);
    let by_itself = || Paper::ALL.into_iter().find(|p| fits(*p) >= choice.scale.unwrap_or(1.0)).unwrap_or(Paper::A0);
    let paper = choice.paper.unwrap_or_else(by_itself);
    let limit = fits(paper);
    let factor = match choice.scale {
        Some(asked) if asked > 0.0 && asked <= limit => asked,
        Some(asked) => return Err(too_large(asked, limit, paper)),
        None => SCALES.into_iter().map(|s| s.factor).find(|f| *f <= limit).unwrap_or(limit),
    };
    let room = frame::room(paper);
    let middle = |min: Point, max: Point| Point::new(f64::midpoint(min.z, max.z), f64::midpoint(min.r, max.r));
    let (on_paper, of_strip) = (middle(room.min, room.max), middle(bounds.min, bounds.max));
    let origin = Point::new(on_paper.z - of_strip.z * factor, on_paper.r - of_strip.r * factor);
    Ok(Placed { paper, scale: Scale { factor }, view: View { origin, scale: factor }, bounds })
}

/// The largest scale at which something of this size has room on a paper, dimensions included.
fn permissible(bounds: Bounds, paper: Paper) -> f64 {
    let room = frame::room(paper);
    let (width, height) = (bounds.max.z - bounds.min.z, bounds.max.r - bounds.min.r);
    let wide = (room.max.z - room.min.z - 2.0 * ASIDE_MM) / width.max(1e-9);
    let high = (room.max.r - room.min.r - 2.0 * ASIDE_MM) / height.max(1e-9);
    wide.min(high)
}

fn too_large(asked: f64, limit: f64, paper: Paper) -> Diagnostic {
    let message =
        format!("The scale {asked} does not fit on {}; it must be more than 0 and at most {limit:.2}.", paper.name());
    Diagnostic::error("drawing-scale", Place::Document, message).with_hint("Choose a larger paper or a smaller scale.")
}

/// The strip itself, filled.
fn draw_strip(page: &mut Page, view: &View, strip: &Strip) {
    page.area(view.segments(&strip.outline().segments), Ink::Pale, Some(Pen::EDGE));
}

/// The upright axis through the origin of a section.
fn axis(page: &mut Page, placed: &Placed) {
    let at = |r: f64| placed.view.place(Point::new(0.0, r));
    let beyond = nalgebra::Vector2::new(0.0, 5.0);
    page.line(at(placed.bounds.min.r) - beyond, at(placed.bounds.max.r) + beyond, Pen::CENTRE);
}

/// A remark in the upper left corner.
fn remark(page: &mut Page, paper: Paper, text: &str) {
    let room = frame::room(paper);
    page.text(Point::new(room.min.z + 4.0, room.max.r - 7.0), 3.5, Align::Start, text);
}
