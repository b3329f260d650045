//! ORACAP part files: `.CAD` (material, flags, sections), `.SIZ` (bar diameter and length), `.END` (ends machined).
//!
//! They are read as free-form lists: words apart by blanks or line ends; `!` begins a comment.

use super::{Imported, largest_diameter, largest_position};
use crate::diagnostic::{Diagnostic, Place};
use crate::document::{Document, Ends};
use crate::part::{Section, SectionKind};
use crate::storage::check::MOST_SECTIONS;
use crate::textfile::{file_place, line_place};
use crate::units::Unit;
use std::path::Path;

/// Largest magnitude of a length in a part file, in the file's unit; no lathe is that long.
const MOST_LENGTH: f64 = 100_000.0;

/// The texts of the files that describe one part.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct CadTexts {
    /// Material, flags and sections.
    pub cad: String,
    /// Bar diameter and length of the part, if there is such a file.
    pub siz: Option<String>,
    /// Number of ends machined, if there is such a file.
    pub end: Option<String>,
}

/// Reads an ORACAP part; `file` is the name of the `.CAD` file for messages, `name` becomes the document's name.
///
/// Sections of type 5 become parabolas with the axis square to the spindle, those of type 6 parallel to it: the published
/// type 5 row and its printed cuts need the radius as a quadratic of the position, though the text says it the other way
/// round.
///
/// # Errors
/// A diagnostic with line and column, the word found and what is needed there.
pub fn cad(
    file: &str,
    name: &str,
    texts: &CadTexts,
    machine: &str,
) -> Result<(Document, Vec<Diagnostic>), Vec<Diagnostic>> {
    let mut diagnostics = Vec::new();
    let (head, sections) = read_cad(&mut Words::new(file, &texts.cad), &mut diagnostics).map_err(|d| vec![d])?;
    let beside = |extension: &str| Path::new(file).with_extension(extension).display().to_string();
    let (bar_diameter, length) = if let Some(text) = &texts.siz {
        read_siz(&mut Words::new(&beside("SIZ"), text)).map_err(|d| vec![d])?
    } else {
        let (bar, length) = (largest_diameter(&sections), largest_position(&sections));
        diagnostics.push(no_siz(file, bar, length, head.unit));
        (bar, length)
    };
    let ends = if let Some(text) = &texts.end {
        read_end(&mut Words::new(&beside("END"), text)).map_err(|d| vec![d])?
    } else {
        let message = "There is no .END file with the number of ends machined; 1 is assumed.";
        diagnostics.push(Diagnostic::warning("cad-no-end", file_place(Path::new(file)), message));
        Ends::One
    };
    let document = Imported {
        name: name.to_owned(),
        unit: head.unit,
        machine: machine.to_owned(),
        material: head.material,
        bar_diameter,
        length,
        ends,
        part_off: head.part_off,
        automatic: head.automatic,
        sections,
        bore: Vec::new(),
    }
    .document(file)?;
    Ok((document, diagnostics))
}

fn no_siz(file: &str, bar: f64, length: f64, unit: Unit) -> Diagnostic {
    let unit = unit.symbol();
    let message = format!(
        "There is no .SIZ file with bar diameter and length; taken from the sections: {bar} {unit} and {length} {unit}."
    );
    Diagnostic::warning("cad-no-siz", file_place(Path::new(file)), message)
        .with_hint("Enter the true bar diameter and length.")
}

struct Head {
    material: String,
    sections: u32,
    part_off: bool,
    automatic: bool,
    unit: Unit,
}

fn read_cad(words: &mut Words<'_>, diagnostics: &mut Vec<Diagnostic>) -> Result<(Head, Vec<Section>), Diagnostic> {
    let head = read_head(words)?;
    let mut sections = Vec::new();
    for id in 1..=head.sections {
        sections.push(read_section(words, id, diagnostics)?);
    }
    if let Ok(word) = words.next("") {
        let message = format!(
            "After the {} sections the file goes on with `{}`; the rest is not read.",
            head.sections, word.text
        );
        diagnostics.push(Diagnostic::warning("cad-more-data", word.at, message));
    }
    Ok((head, sections))
}

fn read_head(words: &mut Words<'_>) -> Result<Head, Diagnostic> {
    let material = words.next("the name of the material")?;
    if material.text.contains('=') {
        return Err(material.refused("the name of the material"));
    }
    let most = u32::try_from(MOST_SECTIONS).unwrap_or(u32::MAX);
    let sections = words.whole("the number of sections", 1, most)?;
    let mut flags = Flags::default();
    while !flags.is_complete() {
        let word = words.next("the flags PART=, AUTO= and INCH=, each T or F")?;
        flags.add(&word)?;
    }
    let unit = if flags.value("INCH") { Unit::Inch } else { Unit::Mm };
    Ok(Head {
        material: material.text.to_owned(),
        sections,
        part_off: flags.value("PART"),
        automatic: flags.value("AUTO"),
        unit,
    })
}

/// Flags as they come: blanks may stand anywhere in `PART= T`.
#[derive(Default)]
struct Flags(String);

impl Flags {
    const NAMES: [&'static str; 3] = ["PART", "AUTO", "INCH"];

    fn add(&mut self, word: &Word<'_>) -> Result<(), Diagnostic> {
        self.0.push_str(&word.text.to_ascii_uppercase());
        let rest = Self::NAMES.iter().fold(self.0.clone(), |rest, name| {
            rest.replacen(&format!("{name}=T"), "", 1).replacen(&format!("{name}=F"), "", 1)
        });
        let may_go_on = Self::NAMES.iter().any(|name| format!("{name}=").starts_with(&rest));
        if may_go_on { Ok(()) } else { Err(word.refused("the flags PART=, AUTO= and INCH=, each T or F")) }
    }

    fn is_complete(&self) -> bool {
        Self::NAMES.iter().all(|n| self.0.contains(&format!("{n}=T")) || self.0.contains(&format!("{n}=F")))
    }

    fn value(&self, name: &str) -> bool {
        self.0.contains(&format!("{name}=T"))
    }
}

fn read_section(words: &mut Words<'_>, id: u32, diagnostics: &mut Vec<Diagnostic>) -> Result<Section, Diagnostic> {
    let number = words.next("the number of a section")?;
    let found: u32 = number.whole("the number of a section", 0, u32::MAX)?;
    if found != id {
        let message = format!("The section's number is {found} where {id} was expected; the order of the file counts.");
        diagnostics.push(Diagnostic::warning("cad-section-number", number.at, message));
    }
    let kind = words.whole("the type of the section", 1, 6)?;
    let mut length = |what| words.length(what);
    let (z1, d1, z2, d2) = (
        length("position one")?,
        length("the diameter at position one")?,
        length("position two")?,
        length("the diameter at position two")?,
    );
    let kind = match kind {
        1 => SectionKind::Line,
        2 => SectionKind::Concave { radius: length("the radius")? },
        3 => SectionKind::Convex { radius: length("the radius")? },
        4 => SectionKind::Thread { pitch: length("the pitch")?, starts: 1 },
        _ => {
            let (z3, d3) = (length("position three")?, length("the diameter at position three")?);
            let chords = words.whole("the number of sub-sections", 1, 1000)?;
            if kind == 5 {
                SectionKind::ParabolaAlongX { z3, d3, chords }
            } else {
                SectionKind::ParabolaAlongZ { z3, d3, chords }
            }
        }
    };
    Ok(Section { id, z1, d1, z2, d2, kind })
}

fn read_siz(words: &mut Words<'_>) -> Result<(f64, f64), Diagnostic> {
    Ok((words.length("the diameter of the bar")?, words.length("the length of the part")?))
}

fn read_end(words: &mut Words<'_>) -> Result<Ends, Diagnostic> {
    let count = words.whole("the number of ends machined", 1, 2)?;
    Ok(if count == 2 { Ends::Two { split: None } } else { Ends::One })
}

/// The words of a file in order.
struct Words<'a> {
    file: &'a str,
    rest: std::vec::IntoIter<Word<'a>>,
    lines: usize,
}

/// A word and its place.
struct Word<'a> {
    text: &'a str,
    at: Place,
}

impl<'a> Words<'a> {
    fn new(file: &'a str, text: &'a str) -> Self {
        let mut words = Vec::new();
        for (number, line) in (1..).zip(text.lines()) {
            let data = line.split('!').next().unwrap_or_default();
            for word in data.split_whitespace() {
                let before = word.as_ptr() as usize - line.as_ptr() as usize;
                let column = 1 + line.get(..before).map_or(0, |b| b.chars().count());
                words.push(Word { text: word, at: line_place(file, number, Some(column)) });
            }
        }
        Self { file, rest: words.into_iter(), lines: text.lines().count().max(1) }
    }

    fn next(&mut self, needed: &str) -> Result<Word<'a>, Diagnostic> {
        self.rest.next().ok_or_else(|| {
            let message = format!("The file ends where {needed} is needed.");
            Diagnostic::error("cad-truncated", line_place(self.file, self.lines, None), message)
        })
    }

    fn length(&mut self, needed: &str) -> Result<f64, Diagnostic> {
        let word = self.next(needed)?;
        let value = word.number().ok_or_else(|| word.refused(needed))?;
        if value.abs() <= MOST_LENGTH {
            return Ok(value);
        }
        Err(word.refused(&format!("{needed}, at most {MOST_LENGTH},")))
    }

    fn whole(&mut self, needed: &str, least: u32, most: u32) -> Result<u32, Diagnostic> {
        self.next(needed)?.whole(needed, least, most)
    }
}

impl Word<'_> {
    /// A finite number as Fortran writes it, `D` exponents included.
    fn number(&self) -> Option<f64> {
        self.text.replace(['D', 'd'], "E").parse().ok().filter(|v: &f64| v.is_finite())
    }

    /// A whole number, which may be written as `10.000`.
    fn whole(&self, needed: &str, least: u32, most: u32) -> Result<u32, Diagnostic> {
        let value = self.number().filter(|v| v.fract() == 0.0 && (f64::from(least)..=f64::from(most)).contains(v));
        #[allow(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "a whole number within least..=most"
        )]
        value
            .map(|v| v as u32)
            .ok_or_else(|| self.refused(&format!("{needed}, a whole number from {least} to {most},")))
    }

    fn refused(&self, needed: &str) -> Diagnostic {
        Diagnostic::error("cad-word", self.at.clone(), format!("`{}` stands where {needed} is needed.", self.text))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::Content;
    use crate::storage::{document_from_text, examples_of, export};

    /// The published layout with its stray blanks and broken lines.
    const MASTER: &str = "AL6061T6\n  2 PART= T AUT O= F\n IN CH= F  ! matl,nsect,flags\n\
        1 5 ! sect,type\n 5.000 16.000 14.000 10.000 8.000\n 17.000 10.000 ! p1,d1,p2,d2,p3,d3,nsub\n\
        2 4\n 28.000 12.000 40.000 10.000 1.75D0 ! p1,od,p2,bd,pit\n";

    fn read(cad_text: &str) -> Result<(Document, Vec<Diagnostic>), Vec<Diagnostic>> {
        let texts = CadTexts { cad: cad_text.to_owned(), siz: Some("26.2 40".into()), end: Some("1".into()) };
        cad("MASTER.CAD", "MASTER", &texts, "orac")
    }

    #[test]
    fn the_published_layout_is_read_free_form() {
        let (document, diagnostics) = read(MASTER).unwrap();
        assert_eq!(diagnostics, []);
        let Content::TurnedPart(part) = document.content else { unreachable!("a turned part") };
        assert_eq!((part.material.as_str(), part.part_off, part.automatic), ("AL6061T6", true, false));
        assert_eq!((part.bar_diameter, part.length, part.ends, document.unit), (26.2, 40.0, Ends::One, Unit::Mm));
        let parabola = SectionKind::ParabolaAlongX { z3: 8.0, d3: 17.0, chords: 10 };
        assert_eq!(part.sections[0], Section { kind: parabola, ..Section::line(1, 5.0, 16.0, 14.0, 10.0) });
        assert_eq!(part.sections[1].kind, SectionKind::Thread { pitch: 1.75, starts: 1 });
    }

    #[test]
    fn every_example_goes_out_and_comes_back() {
        for example in examples_of(crate::document::Kind::TurnedPart) {
            let document = document_from_text(example.name, example.text).unwrap();
            let Content::TurnedPart(part) = &document.content else { unreachable!("a turned part") };
            if part.machine != "orac" {
                continue; // The format holds neither machine nor generator.
            }
            let (texts, _) = export::cad(&document, part);
            let (again, diagnostics) = cad("x.CAD", example.name, &texts, "orac").unwrap();
            assert_eq!(diagnostics, []);
            let rewritten = export::cad(&again, again.content.turned_part().unwrap());
            let mut before = part.clone();
            let after = again.content.turned_part().unwrap();
            if let Ends::Two { split } = &mut before.ends {
                *split = None;
            }
            assert_eq!((after, again.unit), (&before, document.unit));
            assert_eq!(rewritten.0, texts);
        }
    }

    #[test]
    fn missing_siz_and_end_files_are_reported_and_replaced() {
        let texts = CadTexts { cad: MASTER.replace("IN CH= F", "INCH=T"), ..CadTexts::default() };
        let (document, diagnostics) = cad("m.CAD", "m", &texts, "orac").unwrap();
        assert_eq!(diagnostics.iter().map(|d| d.code.as_str()).collect::<Vec<_>>(), ["cad-no-siz", "cad-no-end"]);
        assert!(diagnostics[0].message.contains("16 in and 40 in"), "{}", diagnostics[0]);
        let Content::TurnedPart(part) = document.content else { unreachable!("a turned part") };
        assert_eq!((part.bar_diameter, part.length, document.unit), (16.0, 40.0, Unit::Inch));
    }

    #[test]
    fn wrong_words_are_refused_with_line_column_and_need() {
        let refused = |from: &str, to: &str, line: usize, column: usize, words: &[&str]| {
            assert!(MASTER.contains(from), "{from}");
            let fault = read(&MASTER.replacen(from, to, 1)).unwrap_err().remove(0);
            assert_eq!(fault.at, line_place("MASTER.CAD", line, Some(column)), "{fault}");
            for word in words {
                assert!(fault.message.contains(word), "{fault}");
            }
        };
        refused("  2 PART", "  x PART", 2, 3, &["`x`", "number of sections"]);
        refused("  2 PART", "  0 PART", 2, 3, &["`0`", "1 to 10000"]);
        refused("PART= T", "PART= Q", 2, 11, &["`Q`", "T or F"]);
        refused("1 5 !", "1 7 !", 4, 3, &["`7`", "1 to 6"]);
        refused("16.000 14", "NaN 14", 5, 8, &["`NaN`", "diameter at position one"]);
        refused("16.000 14", "1e999 14", 5, 8, &["`1e999`"]);
        refused("16.000 14", "1e9 14", 5, 8, &["`1e9`", "100000"]);
        refused("17.000 10.000", "17.000 10.5", 6, 9, &["`10.5`", "whole number from 1 to 1000"]);
    }

    #[test]
    fn more_data_and_wrong_numbers_are_warnings() {
        let (_, diagnostics) = read(&(MASTER.replace("2 4\n", "9 4\n") + "3 1\n")).unwrap();
        let codes: Vec<_> = diagnostics.iter().map(|d| d.code.as_str()).collect();
        assert_eq!(codes, ["cad-section-number", "cad-more-data"]);
    }

    #[test]
    fn end_and_siz_files_are_checked() {
        let with = |siz: &str, end: &str| {
            let texts = CadTexts { cad: MASTER.to_owned(), siz: Some(siz.into()), end: Some(end.into()) };
            cad("m.CAD", "m", &texts, "orac")
        };
        let Content::TurnedPart(part) = with("26.2 40", "2").unwrap().0.content else { unreachable!("a turned part") };
        assert_eq!(part.ends, Ends::Two { split: None });
        assert!(with("26.2 40", "3").unwrap_err()[0].to_string().contains("m.END:1:1: error: `3`"));
        assert!(with("26.2", "1").unwrap_err()[0].to_string().contains("the length of the part"));
    }
}
