//! ORACAP part files.

use crate::diagnostic::{Diagnostic, Place};
use crate::document::{Document, Ends, Holding, TurnedPart};
use crate::part::{Section, SectionKind};
use crate::storage::import::CadTexts;
use crate::units::Unit;
use std::fmt::Write;

/// The `.CAD`, `.SIZ` and `.END` texts of a document with this part in their published layout, and what they cannot hold.
#[must_use]
pub fn cad(document: &Document, part: &TurnedPart) -> (CadTexts, Vec<Diagnostic>) {
    let flag = |on: bool| if on { 'T' } else { 'F' };
    let material: String = part.material.split_whitespace().collect::<Vec<_>>().join("_");
    let mut text = String::new();
    let head = format!(
        "{material:<8} {:>2} PART= {} AUTO= {} INCH= {}",
        part.sections.len(),
        flag(part.part_off),
        flag(part.automatic),
        flag(document.unit == Unit::Inch)
    );
    line(&mut text, &head, "matl,nsect,flags");
    for (number, section) in (1..).zip(&part.sections) {
        add_section(&mut text, number, section);
    }
    let mut diagnostics = Vec::new();
    if let Ends::Two { split: Some(split) } = part.ends {
        let message =
            format!("An ORACAP part file holds no split point; {split} {} is left out.", document.unit.symbol());
        diagnostics.push(Diagnostic::warning("cad-no-split", Place::Document, message));
    }
    let mut lost = |code: &str, at: Place, what: String| {
        let message = format!("An ORACAP part file holds {what} left out.");
        diagnostics.push(Diagnostic::warning(code, at, message));
    };
    let unit = document.unit.symbol();
    if !part.bore.is_empty() {
        lost("cad-no-bore", Place::Document, format!("no bore; its sections, {} in number, are", part.bore.len()));
    }
    if part.stock_bore_diameter > 0.0 {
        let hole = part.stock_bore_diameter;
        lost("cad-no-bore", Place::Stock, format!("solid bar only; the hole of {hole} {unit} in the stock is"));
    }
    if part.facing_allowance > 0.0 {
        let allowance = part.facing_allowance;
        lost("cad-no-facing", Place::Stock, format!("no facing allowance; {allowance} {unit} are"));
    }
    if part.holding != Holding::Chuck {
        lost("cad-no-holding", Place::Stock, "work in the chuck only; that it is held between centres is".to_owned());
    }
    for (row, starts) in several_starts(&part.sections) {
        let what = format!("threads of 1 start only; of those in section {row}, {starts} in number, the others are");
        lost("cad-no-starts", Place::Document, what);
    }
    if !part.overrides.is_empty() {
        let message =
            format!("An ORACAP part file holds no programs; {} edited by hand are left out.", part.overrides.len());
        diagnostics.push(Diagnostic::warning("cad-no-programs", Place::Document, message));
    }
    let ends = if part.ends == Ends::One { 1 } else { 2 };
    let siz = format!("{}{}\n", number(part.bar_diameter), number(part.length));
    (CadTexts { cad: text, siz: Some(siz), end: Some(format!("{ends}\n")) }, diagnostics)
}

/// Row and starts of every thread with more than one start.
fn several_starts(sections: &[Section]) -> impl Iterator<Item = (usize, u32)> {
    (1..).zip(sections).filter_map(|(row, section)| match section.kind {
        SectionKind::Thread { starts, .. } if starts > 1 => Some((row, starts)),
        _ => None,
    })
}

fn add_section(text: &mut String, position: usize, section: &Section) {
    let (kind, more, names) = match section.kind {
        SectionKind::Line => (1, String::new(), "p1,d1,p2,d2"),
        SectionKind::Concave { radius } => (2, number(radius), "p1,d1,p2,d2,rad"),
        SectionKind::Convex { radius } => (3, number(radius), "p1,d1,p2,d2,rad"),
        SectionKind::Thread { pitch, .. } => (4, number(pitch), "p1,od,p2,bd,pit"),
        SectionKind::ParabolaAlongX { z3, d3, chords } => {
            (5, format!("{}{} {chords:>4}", number(z3), number(d3)), "p1,d1,p2,d2,p3,d3,nsub")
        }
        SectionKind::ParabolaAlongZ { z3, d3, chords } => {
            (6, format!("{}{} {chords:>4}", number(z3), number(d3)), "p1,d1,p2,d2,p3,d3,nsub")
        }
    };
    line(text, &format!("{position:>3} {kind}"), "sect,type");
    let ends: String = [section.z1, section.d1, section.z2, section.d2].map(number).concat();
    line(text, &format!("{ends}{more}"), names);
}

fn line(text: &mut String, data: &str, comment: &str) {
    // Writing to a String cannot fail.
    let _ = writeln!(text, "{data:<48} ! {comment}");
}

/// A number in its column: three decimals as published, more only where it has more.
fn number(value: f64) -> String {
    let short = format!("{value:.3}");
    let exact = if short.parse() == Ok(value) { short } else { value.to_string() };
    format!(" {exact:>8}")
}
