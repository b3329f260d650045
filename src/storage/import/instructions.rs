//! Cutting instructions of a form-roll: the CU data of the published part programming dialogue, as JSON.
//!
//! `operations` is a list of objects with `ICYCLE` (1 rough, 2 groove, 3 finish, 4 pocket), `ISEL` and `IEEL` (first and
//! last element; a first one beyond the last cuts towards the clamped end), `TOL_mm`, `NTOOL`, `DCUT_mm`,
//! `SPEED_m_per_min`, `FEED_mm_per_rev` and `start_point` (null, or `ZP_mm`, `XP_mm` as a radius and `ANG_deg`). `NSTAGE`
//! and `ICON` give the program its number. Other fields are remarks. Source: Wong 1983, figure 8.32 and appendix 5 D.
//!
//! The printed dialogue of a roll may have been held with another state of its profile than the printed profile. A file
//! then gives the printed figure and beside it the one that belongs to the profile: `ISEL_on_Fig_6_17`,
//! `IEEL_on_Fig_6_17` (the printed right-hand numbers of 1470b-2T count one line more than its profile has) and
//! `ZP_that_gives_the_listing_mm`. Where such a figure is there, it is used, and a remark says so.

use crate::diagnostic::{Diagnostic, Place, Severity, has_errors};
use crate::document::{CutIn, Cycle, Document, Generator, Instruction};
use crate::storage::locate::offset_of;
use crate::textfile::{line_and_column, line_place};
use serde_json::{Map, Value};

/// Largest magnitude of a length, mm; no lathe is that long.
const MOST_MM: f64 = 100_000.0;

/// Highest turret station.
const MOST_STATION: u32 = 99;

/// Most operations of one roll.
const MOST_OPERATIONS: usize = 1000;

/// Gives a document the cutting instructions of a CU file, whose element numbers are the row numbers of its table; `file`
/// is the name for messages.
///
/// # Errors
/// A diagnostic for every field that cannot be used, with line, field, value and limit.
pub fn instructions(
    file: &str,
    text: &str,
    mut document: Document,
) -> Result<(Document, Vec<Diagnostic>), Vec<Diagnostic>> {
    let root: Value = serde_json::from_str(text).map_err(|error| {
        let at = line_place(file, error.line().max(1), Some(error.column().max(1)));
        let code = if error.is_eof() { "instructions-truncated" } else { "instructions-syntax" };
        vec![Diagnostic::error(code, at, format!("The file is not whole JSON: {error}."))]
    })?;
    let factor = 1.0 / document.unit.in_mm();
    let Some(part) = document.content.turned_part_mut() else {
        let message = "Cutting instructions belong to a turned part; the document is none.";
        return Err(vec![Diagnostic::error("instructions-without-part", Place::Document, message)]);
    };
    let ids: Vec<u32> = part.sections.iter().map(|s| s.id).collect();
    let mut reader = Reader { file, text, ids: &ids, diagnostics: Vec::new() };
    let made = reader.operations(&root);
    let number = reader.program_number(&root);
    let diagnostics = reader.diagnostics;
    if has_errors(&diagnostics) {
        return Err(diagnostics);
    }
    part.generator = Generator::Cycles { instructions: made.iter().map(|i| i.scaled(factor)).collect() };
    part.program.number = number.or(part.program.number);
    Ok((document, diagnostics))
}

/// Looks up fields and collects what is wrong with them.
struct Reader<'a> {
    file: &'a str,
    text: &'a str,
    /// Ids of the rows, in the order of the table.
    ids: &'a [u32],
    diagnostics: Vec<Diagnostic>,
}

/// An operation's object and its place in the file.
#[derive(Clone, Copy)]
struct Fields<'a> {
    object: &'a Map<String, Value>,
    /// Keys and indices down to it, joined by dots.
    path: &'a str,
}

impl Reader<'_> {
    fn at(&self, path: &str) -> Place {
        let (line, column) = line_and_column(self.text, offset_of(self.text, path));
        line_place(self.file, line, Some(column))
    }

    fn refuse(&mut self, path: &str, message: impl Into<String>) {
        let at = self.at(path);
        self.diagnostics.push(Diagnostic::error("instructions-value", at, message));
    }

    fn remark(&mut self, path: &str, message: impl Into<String>) {
        let at = self.at(path);
        self.diagnostics.push(Diagnostic::new(Severity::Info, "instructions-correction", at, message));
    }

    fn operations(&mut self, root: &Value) -> Vec<Instruction> {
        let Some(operations) = root.get("operations").and_then(Value::as_array) else {
            self.refuse("", "The file has no list `operations`.");
            return Vec::new();
        };
        if operations.is_empty() || operations.len() > MOST_OPERATIONS {
            let message = format!("There are {} operations; it must be 1 to {MOST_OPERATIONS}.", operations.len());
            self.refuse("operations", message);
            return Vec::new();
        }
        let made = operations.iter().enumerate().map(|(index, operation)| {
            let path = format!("operations.{index}");
            let Some(object) = operation.as_object() else {
                self.refuse(&path, format!("Operation {} is no object with fields.", index + 1));
                return None;
            };
            self.operation(Fields { object, path: &path })
        });
        made.collect::<Vec<_>>().into_iter().flatten().collect()
    }

    /// One instruction in mm. All fields are looked at, so that all faults are reported.
    fn operation(&mut self, fields: Fields<'_>) -> Option<Instruction> {
        let cycle = self.cycle(fields);
        let (from, to) = (self.element(fields, "ISEL"), self.element(fields, "IEEL"));
        let stock_left = self.number(fields, "TOL_mm", 0.0, MOST_MM);
        let tool = self.whole(fields, "NTOOL", 1, MOST_STATION);
        let depth = self.number(fields, "DCUT_mm", 0.0, MOST_MM);
        let speed = self.number(fields, "SPEED_m_per_min", f64::MIN_POSITIVE, MOST_MM);
        let feed = self.number(fields, "FEED_mm_per_rev", f64::MIN_POSITIVE, MOST_MM);
        let cut_in = self.cut_in(fields);
        Some(Instruction {
            cycle: cycle?,
            from: from?,
            to: to?,
            stock_left: stock_left?,
            tool: tool?,
            depth: depth?,
            speed_m_per_min: speed?,
            feed_per_rev: feed?,
            cut_in: cut_in?,
        })
    }

    fn cycle(&mut self, fields: Fields<'_>) -> Option<Cycle> {
        match self.whole(fields, "ICYCLE", 1, 4)? {
            1 => Some(Cycle::Rough),
            2 => Some(Cycle::Groove),
            3 => Some(Cycle::Finish),
            _ => Some(Cycle::Pocket),
        }
    }

    /// The row of an element number, by the number that belongs to the profile where the file has one.
    fn element(&mut self, fields: Fields<'_>, name: &str) -> Option<u32> {
        let most = u32::try_from(self.ids.len()).unwrap_or(u32::MAX);
        let corrected = format!("{name}_on_Fig_6_17");
        let number = if fields.object.contains_key(&corrected) {
            let number = self.whole(fields, &corrected, 1, most)?;
            let printed = fields.object.get(name).map_or_else(|| "nothing".to_owned(), Value::to_string);
            let path = format!("{}.{corrected}", fields.path);
            self.remark(
                &path,
                format!("{name} is printed as {printed}; {number} is used, the number in this profile."),
            );
            number
        } else {
            self.whole(fields, name, 1, most)?
        };
        let index = usize::try_from(number).ok()?.checked_sub(1)?;
        self.ids.get(index).copied()
    }

    /// The cut-in line: outside none if a figure is wrong, inside none if there is no line.
    #[allow(clippy::option_option, reason = "a missing line is no fault, a wrong one is")]
    fn cut_in(&mut self, fields: Fields<'_>) -> Option<Option<CutIn>> {
        let object = match fields.object.get("start_point") {
            None | Some(Value::Null) => return Some(None),
            Some(Value::Object(object)) => object,
            Some(other) => {
                let path = format!("{}.start_point", fields.path);
                let other = other.to_string();
                self.refuse(&path, format!("`start_point` is {}; it must be null or an object.", shortened(&other)));
                return None;
            }
        };
        let path = format!("{}.start_point", fields.path);
        let point = Fields { object, path: &path };
        let (z, r) = (self.number(point, "ZP_mm", -MOST_MM, MOST_MM), self.number(point, "XP_mm", 0.0, MOST_MM));
        let angle_deg = self.number(point, "ANG_deg", -360.0, 360.0);
        let corrected = "ZP_that_gives_the_listing_mm";
        let z = if fields.object.contains_key(corrected) {
            let used = self.number(fields, corrected, -MOST_MM, MOST_MM)?;
            let path = format!("{}.{corrected}", fields.path);
            self.remark(&path, format!("ZP is printed as {} mm; {used} mm is used.", z?));
            Some(used)
        } else {
            z
        };
        Some(Some(CutIn { z: z?, diameter: 2.0 * r?, angle_deg: angle_deg? }))
    }

    /// The published program numbers: stage and roll, two digits each.
    fn program_number(&mut self, root: &Value) -> Option<u32> {
        let object = root.as_object()?;
        let fields = Fields { object, path: "" };
        if !(object.contains_key("NSTAGE") && object.contains_key("ICON")) {
            return None;
        }
        let (stage, roll) = (self.whole(fields, "NSTAGE", 1, 50), self.whole(fields, "ICON", 1, 4));
        Some(stage? * 100 + roll?)
    }

    fn number(&mut self, fields: Fields<'_>, name: &str, least: f64, most: f64) -> Option<f64> {
        let value = fields.object.get(name).and_then(Value::as_f64).filter(|v| (least..=most).contains(v));
        if value.is_none() {
            let limit = if least == f64::MIN_POSITIVE {
                format!("a number above 0 and up to {most}")
            } else {
                format!("a number from {least} to {most}")
            };
            self.refuse_field(fields, name, &limit);
        }
        value
    }

    fn whole(&mut self, fields: Fields<'_>, name: &str, least: u32, most: u32) -> Option<u32> {
        let value = fields.object.get(name).and_then(Value::as_u64).and_then(|v| u32::try_from(v).ok());
        let value = value.filter(|v| (least..=most).contains(v));
        if value.is_none() {
            self.refuse_field(fields, name, &format!("a whole number from {least} to {most}"));
        }
        value
    }

    fn refuse_field(&mut self, fields: Fields<'_>, name: &str, limit: &str) {
        let path = [fields.path, name].iter().filter(|p| !p.is_empty()).copied().collect::<Vec<_>>().join(".");
        let message = match fields.object.get(name) {
            None => format!("`{path}` is missing; it must be {limit}."),
            Some(value) => format!("`{path}` is {}; it must be {limit}.", shortened(&value.to_string())),
        };
        self.refuse(&path, message);
    }
}

fn shortened(value: &str) -> String {
    value.chars().take(30).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::Content;
    use crate::storage::import::roll;

    const TOP: &str = include_str!("../../../tests/cases/1470b/CU1470b-2T.json");
    const BOTTOM: &str = include_str!("../../../tests/cases/1470b/CU1470b-2B.json");

    fn document() -> Document {
        roll("E1470b-2T.txt", include_str!("../../../tests/cases/1470b/E1470b-2T.txt")).unwrap().0
    }

    fn read(text: &str) -> Result<(Vec<Instruction>, Vec<Diagnostic>), Vec<Diagnostic>> {
        let (document, diagnostics) = instructions("CU.json", text, document())?;
        let Content::TurnedPart(part) = document.content else { unreachable!("a turned part") };
        let Generator::Cycles { instructions } = part.generator else { panic!("cycles") };
        Ok((instructions, diagnostics))
    }

    #[test]
    fn the_published_instructions_are_read_with_the_numbers_of_the_profile() {
        let (made, diagnostics) = read(TOP).unwrap();
        let areas: Vec<(u32, u32)> = made.iter().map(|i| (i.from, i.to)).collect();
        assert_eq!(areas, [(37, 2), (2, 37), (20, 7), (20, 32), (37, 33), (20, 6), (2, 6), (20, 33)]);
        assert_eq!(made[2].cut_in, Some(CutIn { z: 80.0, diameter: 112.0, angle_deg: 25.0 }));
        assert_eq!((made[0].tool, made[0].depth, made[0].feed_per_rev), (2, 2.5, 0.1));
        assert!(diagnostics.iter().all(|d| d.code == "instructions-correction"));
        assert_eq!(diagnostics.len(), 6);
        let (document, _) = instructions("CU.json", TOP, document()).unwrap();
        let Content::TurnedPart(part) = document.content else { unreachable!("a turned part") };
        assert_eq!(part.program.number, Some(201));
    }

    #[test]
    fn a_printed_figure_gives_way_to_the_one_beside_it() {
        let (made, diagnostics) = read(BOTTOM).unwrap();
        assert_eq!(made[7].cut_in.map(|c| c.z), Some(137.5));
        assert!(diagnostics[0].message.contains("139 mm"), "{}", diagnostics[0]);
        assert!(matches!(diagnostics[0].at, Place::Line { line, .. } if line > 100), "{}", diagnostics[0]);
    }

    #[test]
    fn every_wrong_field_is_named_with_its_line_value_and_limit() {
        let operation = r#"{"ICYCLE":1,"ISEL":37,"IEEL":2,"TOL_mm":0.1,"NTOOL":2,"DCUT_mm":2.5,"SPEED_m_per_min":200,
            "FEED_mm_per_rev":0.1,"start_point":{"ZP_mm":1,"XP_mm":2,"ANG_deg":3}}"#;
        let with = |old: &str, new: &str| {
            let text = format!("{{\"operations\":[\n{}]}}", operation.replace(old, new));
            assert!(text.contains(new), "{old}");
            read(&text)
        };
        assert!(with("37", "37").is_ok());
        for (old, new, word) in [
            ("\"ICYCLE\":1", "\"ICYCLE\":5", "5; it must be a whole number from 1 to 4"),
            ("\"ISEL\":37", "\"ISEL\":39", "39; it must be a whole number from 1 to 38"),
            ("\"ISEL\":37", "\"ISEL\":3.5", "3.5"),
            ("\"TOL_mm\":0.1", "\"TOL_mm\":-0.1", "-0.1; it must be a number from 0"),
            ("\"NTOOL\":2", "\"NTOOL\":0", "0; it must be a whole number from 1"),
            ("\"DCUT_mm\":2.5", "\"DCUT_mm\":null", "null"),
            ("\"SPEED_m_per_min\":200", "\"SPEED_m_per_min\":0", "above 0"),
            ("\"FEED_mm_per_rev\":0.1", "\"FEED\":0.1", "`operations.0.FEED_mm_per_rev` is missing"),
            ("\"ANG_deg\":3", "\"ANG_deg\":\"x\"", "\"x\""),
            ("{\"ZP_mm\":1,\"XP_mm\":2,\"ANG_deg\":3}", "7", "`start_point` is 7"),
        ] {
            let found = with(old, new).unwrap_err();
            assert_eq!(found.len(), 1, "{new}: {found:?}");
            assert!(found[0].message.contains(word), "{}", found[0]);
            assert!(matches!(found[0].at, Place::Line { line: 2 | 3, .. }), "{}", found[0]);
        }
    }

    #[test]
    fn what_is_no_list_of_operations_is_refused() {
        let code = |text: &str| read(text).unwrap_err().remove(0).code;
        assert_eq!(code("{"), "instructions-truncated");
        assert_eq!(code("{x"), "instructions-syntax");
        for text in ["[]", "{}", "{\"operations\":[]}", "{\"operations\":[7]}", "{\"operations\":{}}"] {
            assert_eq!(code(text), "instructions-value", "{text}");
        }
    }
}
