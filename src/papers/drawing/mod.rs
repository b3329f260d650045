//! The dimensioned drawing of a finished part.
//!
//! One view along the axis; a part with a bore is cut below it. Diameters, radii, chamfers and threads stand in a row above the
//! view, positions (running dimensions from the clamped end, ISO 129-1) in a row below it; the figures of a bore stand below and
//! those of the outside above. Figures that would stand on one another are moved aside, with bent lines, and where even that is
//! too crowded a detail at a larger scale follows on the next sheet.

mod detail;
mod figure;
mod layout;
mod marks;
mod outline;
mod row;
pub(super) mod scale;
mod subject;
#[cfg(test)]
mod tests;
mod zones;

use super::frame::{self, Block, Field};
use super::number::number;
use super::page::{Page, Paper};
use crate::diagnostic::{Diagnostic, Place};
use crate::geometry::{Bounds, Point};
use crate::regen::Derived;
use detail::Detail;
use layout::{Layout, Unfit};
use scale::{SCALES, Scale};
use subject::Subject;

/// How a part is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct DrawingChoice {
    /// Sheet, landscape; without, A4 or A3 if the part has room there in its true size or larger, else the smallest on which
    /// it is drawn at 1:2 or larger, or else the smallest at all.
    pub paper: Option<Paper>,
    /// mm on paper for one mm of the part; without, the largest usual scale (ISO 5455) that fits.
    pub scale: Option<f64>,
}

/// The drawing of the finished part of `derived`: the main view, and behind it sheets with details if there are any.
///
/// # Errors
/// A diagnostic if there is no part to draw, it does not fit on the paper at the scale asked for (with the largest that
/// does), or it has more dimensions than the paper has room for.
pub fn drawing(derived: &Derived, choice: DrawingChoice) -> Result<Vec<Page>, Diagnostic> {
    drawn(&Subject::new(derived)?, choice)
}

fn drawn(subject: &Subject<'_>, choice: DrawingChoice) -> Result<Vec<Page>, Diagnostic> {
    let on_all = |least: f64| Paper::ALL.into_iter().map(move |paper| (paper, least));
    let by_itself = || [(Paper::A4, 1.0), (Paper::A3, 1.0)].into_iter().chain(on_all(0.5)).chain(on_all(0.0)).collect();
    let tries: Vec<(Paper, f64)> = choice.paper.map_or_else(by_itself, |paper| vec![(paper, 0.0)]);
    let mut refusal = nothing_fits(subject);
    for (paper, least) in tries {
        match sheets(subject, paper, choice.scale, least) {
            Ok(pages) => return Ok(pages),
            Err(refused) => refusal = refused,
        }
    }
    Err(refusal)
}

/// The sheets of one size; `least` is the smallest scale that is chosen by itself.
fn sheets(subject: &Subject<'_>, paper: Paper, scale: Option<f64>, least: f64) -> Result<Vec<Page>, Diagnostic> {
    let room = frame::room(paper);
    let (layout, scale) = fitted(subject, paper, room, scale, least)?;
    let details = details(subject, &layout, room, scale)?;
    let pairs: Vec<&[Detail]> = details.chunks(DETAILS_ON_A_SHEET).collect();
    let count = 1 + pairs.len();
    let sheet = |number: usize, scale: &str| {
        let mut page = frame::framed(paper, &subject.document.name);
        frame::title_block(&mut page, paper, &block(subject, scale, (number, count)));
        page
    };
    let mut main = Page { part: Some(layout.view()), ..sheet(1, &scale.name()) };
    layout.draw(&mut main, subject);
    let mut pages = vec![main];
    for (k, pair) in pairs.into_iter().enumerate() {
        let alike = pair.windows(2).all(|two| two[0].scale() == two[1].scale());
        let shown = pair.first().filter(|_| alike).map_or("see views".to_owned(), |detail| detail.scale().name());
        let mut page = sheet(k + 2, &shown);
        page.part = pair.first().map(Detail::view);
        for (i, detail) in pair.iter().enumerate() {
            detail.draw(&mut page, subject, &zones::letter(k * DETAILS_ON_A_SHEET + i));
        }
        pages.push(page);
    }
    Ok(pages)
}

/// Details that stand side by side on one sheet.
const DETAILS_ON_A_SHEET: usize = 2;

/// The main view at the scale asked for, or at the largest usual one that fits.
fn fitted(
    subject: &Subject<'_>,
    paper: Paper,
    room: Bounds,
    asked: Option<f64>,
    least: f64,
) -> Result<(Layout, Scale), Diagnostic> {
    let at = |scale: Scale| Layout::new(subject, room, scale.factor).map(|layout| (layout, scale));
    let usual = || SCALES.into_iter().filter(|scale| scale.factor >= least).find_map(|scale| at(scale).ok());
    let Some(factor) = asked else {
        let smallest = Scale { factor: least.max(f64::MIN_POSITIVE) };
        return usual().ok_or_else(|| match at(smallest) {
            Err(Unfit::Figures(count)) => too_many(count, paper),
            _ => nothing_fits(subject),
        });
    };
    if !(factor.is_finite() && factor > 0.0) {
        let message = format!("{factor} is no scale; it is mm on paper for one mm of the part, such as 2 for 2:1.");
        return Err(Diagnostic::error("drawing-scale", Place::Document, message));
    }
    at(Scale { factor }).map_err(|unfit| match unfit {
        Unfit::Size => too_large(subject, Scale { factor }, usual().map(|found| found.1), paper),
        Unfit::Figures(count) => too_many(count, paper),
    })
}

fn details(subject: &Subject<'_>, layout: &Layout, room: Bounds, scale: Scale) -> Result<Vec<Detail>, Diagnostic> {
    let middle = f64::midpoint(room.min.z, room.max.z);
    let left = Bounds { max: Point::new(middle, room.max.r), ..room };
    let right = Bounds { min: Point::new(middle, room.min.r), ..room };
    let alone = layout.zones.len() == 1;
    let rooms = if alone { vec![room] } else { vec![left, right] };
    let places = layout.zones.iter().zip(rooms.into_iter().cycle());
    places
        .map(|(zone, room)| Detail::new(subject, *zone, room, scale.factor).ok_or_else(|| nothing_fits(subject)))
        .collect()
}

fn size(subject: &Subject<'_>) -> String {
    let (Bounds { min, max }, unit) = (subject.bounds, subject.document.unit);
    let (length, width) = (number(max.z - min.z, unit), number(2.0 * max.r, unit));
    format!("A part {length} {u} long and {width} {u} in diameter", u = unit.symbol())
}

fn too_large(subject: &Subject<'_>, asked: Scale, largest: Option<Scale>, paper: Paper) -> Diagnostic {
    let limit =
        largest.map_or("no usual scale does".to_owned(), |scale| format!("{} is the largest that does", scale.name()));
    let message =
        format!("{} does not fit on {} at {} with its dimensions; {limit}.", size(subject), paper.name(), asked.name());
    Diagnostic::error("drawing-scale", Place::Document, message).with_hint("Choose a larger paper or a smaller scale.")
}

fn too_many(count: usize, paper: Paper) -> Diagnostic {
    let room = frame::room(paper);
    let most = ((room.max.z - room.min.z) / row::GAP_MM).floor();
    let message = format!(
        "The part has {count} dimensions in one row; {} has room for {most:.0}, {} mm each.",
        paper.name(),
        row::GAP_MM
    );
    Diagnostic::error("drawing-crowded", Place::Document, message).with_hint("Choose a larger paper.")
}

fn nothing_fits(subject: &Subject<'_>) -> Diagnostic {
    let message = format!("{} does not fit with its dimensions on this paper at any usual scale.", size(subject));
    Diagnostic::error("drawing-scale", Place::Document, message).with_hint("Choose a larger paper.")
}

fn block(subject: &Subject<'_>, scale: &str, sheet: (usize, usize)) -> Block {
    let (unit, part) = (subject.document.unit, subject.part);
    let length = |value: f64| number(value * unit.in_mm(), unit);
    let stock = match part.stock_bore_diameter {
        hole if hole > 0.0 => format!("tube Ø {} / Ø {}", length(part.bar_diameter), length(hole)),
        _ => format!("bar Ø {}", length(part.bar_diameter)),
    };
    Block {
        name: subject.document.name.clone(),
        upper: vec![
            Field::new("Material", part.material.clone()),
            Field::new("Stock", stock),
            Field::new("Form tolerance", format!("± {}", length(part.form_tolerance))),
            Field::new("Dimensions in", unit.symbol().to_owned()),
        ],
        scale: scale.to_owned(),
        sheet,
    }
}
