//! Documents on disk: `.turn` files.

use super::check;
use super::locate::offset_of;
use crate::diagnostic::{Diagnostic, Place};
use crate::document::{Document, FORMAT_VERSION};
use crate::textfile::{self, file_place, line_and_column, line_place};
use serde::{Deserialize, Serialize};
use serde_json::ser::{Formatter, Serializer};
use std::io::{self, Write};
use std::path::Path;

/// Longest document that is read, bytes: far more than a full section table with edited programs.
const MOST_BYTES: u64 = 32 << 20;

/// Reads a document.
///
/// # Errors
/// Diagnostics with file, line, value and limit if the file cannot be read, is not a document, is of an unknown or newer
/// version, contains an unknown or lacks a needed field, or has a value that no document may have: a number that is not
/// finite, a tolerance that is not greater than 0, two rows with one id (they are not repaired: whoever wrote them may
/// refer to either), a name that cannot be a file name.
pub fn open_document(path: &Path) -> Result<Document, Vec<Diagnostic>> {
    let text = textfile::read(path, MOST_BYTES).map_err(|d| vec![d])?;
    document_from_text(&path.display().to_string(), &text)
}

/// Writes a document, so that there is the old file or the new one at every moment, never half of one.
///
/// # Errors
/// A diagnostic if the document has a value that [`open_document`] would refuse, or the file cannot be written; the old
/// file is then unchanged.
pub fn save_document(path: &Path, document: &Document) -> Result<(), Diagnostic> {
    super::replace_file(path, document_to_text(document)?.as_bytes())
}

/// Reads a document from the text of a file; `file` is its name for messages.
///
/// # Errors
/// As [`open_document`].
pub fn document_from_text(file: &str, text: &str) -> Result<Document, Vec<Diagnostic>> {
    check_version(file, text).map_err(|d| vec![d])?;
    let document: Document = serde_json::from_str(text).map_err(|e| vec![unreadable(file, text, &e)])?;
    let faults = check::faults(&document);
    if faults.is_empty() {
        return Ok(document);
    }
    Err(faults
        .into_iter()
        .map(|fault| {
            let (line, column) = line_and_column(text, offset_of(text, &fault.path));
            let at = line_place(file, line, Some(column));
            Diagnostic::error("document-value", at, format!("{}: {}", fault.path, fault.message)).with_related(fault.at)
        })
        .collect())
}

/// The text of a document as it is saved: one setting a line, one section a line, numbers exact.
///
/// # Errors
/// A diagnostic if the document has a value that [`open_document`] would refuse.
pub fn document_to_text(document: &Document) -> Result<String, Diagnostic> {
    if let Some(fault) = check::faults(document).into_iter().next() {
        let message = format!("The document cannot be saved. {}", fault.message);
        return Err(
            Diagnostic::error("document-value", fault.at, message).with_hint("Correct the value and save again.")
        );
    }
    let mut bytes = Vec::new();
    let written = document.serialize(&mut Serializer::with_formatter(&mut bytes, Layout::default()));
    let text = written.map_err(|e| e.to_string()).and_then(|()| String::from_utf8(bytes).map_err(|e| e.to_string()));
    match text {
        Ok(text) => Ok(text + "\n"),
        Err(e) => {
            Err(Diagnostic::error("document-value", Place::Document, format!("The document cannot be saved: {e}.")))
        }
    }
}

/// The one field that every version has.
#[derive(Deserialize)]
struct Version {
    turnwright: Option<serde_json::Value>,
}

/// Looks at the version before anything else, so that a newer file is called newer and not wrong.
fn check_version(file: &str, text: &str) -> Result<(), Diagnostic> {
    let version: Version = serde_json::from_str(text).map_err(|e| unreadable(file, text, &e))?;
    let Some(version) = version.turnwright else {
        let message = "The file has no field `turnwright` with the version of its format; it is not a document.";
        return Err(Diagnostic::error("not-a-document", file_place(Path::new(file)), message));
    };
    let (line, column) = line_and_column(text, offset_of(text, "turnwright"));
    let at = line_place(file, line, Some(column));
    match version.as_u64() {
        Some(v) if v == u64::from(FORMAT_VERSION) => Ok(()),
        Some(v) if v > u64::from(FORMAT_VERSION) => {
            let message =
                format!("The document is of version {v}; this program reads versions up to {FORMAT_VERSION}.");
            Err(Diagnostic::error("newer-version", at, message).with_hint("Open it with a newer Turnwright."))
        }
        _ => {
            let message = format!("The version is {version}; it must be a whole number from 1 to {FORMAT_VERSION}.");
            Err(Diagnostic::error("unknown-version", at, message))
        }
    }
}

fn unreadable(file: &str, text: &str, error: &serde_json::Error) -> Diagnostic {
    let (line, column) = place_of(text, error);
    let full = error.to_string();
    let reason = full.rsplit_once(" at line ").map_or(full.as_str(), |(reason, _)| reason);
    let at = line_place(file, line, Some(column));
    if error.is_eof() {
        let message = format!("The file ends too early, in line {line} ({reason}); the rest is missing.");
        return Diagnostic::error("document-truncated", at, message);
    }
    let message =
        format!("The document cannot be understood here: {reason}. The line reads `{}`.", excerpt(text, line));
    Diagnostic::error("document-unreadable", at, message)
}

/// Line and column of an error. One about a whole value is reported after the blanks behind it, even in a later line;
/// it belongs to the line where the value ends.
fn place_of(text: &str, error: &serde_json::Error) -> (usize, usize) {
    let (line, column) = (error.line().max(1), error.column().max(1));
    let lines: Vec<&str> = text.lines().take(line).collect();
    let is_blank = |l: &&str| l.trim().is_empty();
    if error.is_data() && lines.last().is_some_and(|l| is_blank(&l.get(..column).unwrap_or(l))) {
        let earlier = lines.iter().take(line - 1).rposition(|l| !is_blank(l)).unwrap_or_default();
        return (earlier + 1, lines.get(earlier).map_or(1, |l| l.trim_end().chars().count()));
    }
    (line, column)
}

/// The text of a line, shortened to what fits into a message.
fn excerpt(text: &str, line: usize) -> String {
    /// Characters of a line that a message shows.
    const MOST: usize = 120;
    let line = text.lines().nth(line - 1).unwrap_or_default().trim();
    let short: String = line.chars().take(MOST).collect();
    if short.len() < line.len() { short + " …" } else { short }
}

/// Indents objects and lists down to the rows of tables, each of which keeps to one line.
#[derive(Default)]
struct Layout {
    /// For every bracket that is open, whether its values have lines of their own.
    open: Vec<bool>,
    has_value: bool,
}

impl Layout {
    /// Document, content, part and what the part is made of have a line for each value.
    const OBJECTS: usize = 4;
    /// So have lists one deeper, such as the instructions of a generator.
    const LISTS: usize = 5;

    fn begin<W: ?Sized + Write>(&mut self, writer: &mut W, bracket: &[u8], deepest: usize) -> io::Result<()> {
        self.open.push(self.open.len() < deepest);
        self.has_value = false;
        writer.write_all(bracket)
    }

    fn end<W: ?Sized + Write>(&mut self, writer: &mut W, bracket: &[u8]) -> io::Result<()> {
        if self.open.pop() == Some(true) && self.has_value {
            self.new_line(writer)?;
        }
        self.has_value = true;
        writer.write_all(bracket)
    }

    fn value<W: ?Sized + Write>(&self, writer: &mut W, first: bool) -> io::Result<()> {
        if self.open.last() == Some(&true) {
            writer.write_all(if first { b"" } else { b"," })?;
            return self.new_line(writer);
        }
        writer.write_all(if first { b"" } else { b", " })
    }

    fn new_line<W: ?Sized + Write>(&self, writer: &mut W) -> io::Result<()> {
        writer.write_all(b"\n")?;
        self.open.iter().try_for_each(|_| writer.write_all(b"  "))
    }
}

impl Formatter for Layout {
    fn begin_array<W: ?Sized + Write>(&mut self, writer: &mut W) -> io::Result<()> {
        self.begin(writer, b"[", Self::LISTS)
    }

    fn end_array<W: ?Sized + Write>(&mut self, writer: &mut W) -> io::Result<()> {
        self.end(writer, b"]")
    }

    fn begin_array_value<W: ?Sized + Write>(&mut self, writer: &mut W, first: bool) -> io::Result<()> {
        self.value(writer, first)
    }

    fn end_array_value<W: ?Sized + Write>(&mut self, _: &mut W) -> io::Result<()> {
        self.has_value = true;
        Ok(())
    }

    fn begin_object<W: ?Sized + Write>(&mut self, writer: &mut W) -> io::Result<()> {
        self.begin(writer, b"{", Self::OBJECTS)
    }

    fn end_object<W: ?Sized + Write>(&mut self, writer: &mut W) -> io::Result<()> {
        self.end(writer, b"}")
    }

    fn begin_object_key<W: ?Sized + Write>(&mut self, writer: &mut W, first: bool) -> io::Result<()> {
        self.value(writer, first)
    }

    fn begin_object_value<W: ?Sized + Write>(&mut self, writer: &mut W) -> io::Result<()> {
        writer.write_all(b": ")
    }

    fn end_object_value<W: ?Sized + Write>(&mut self, _: &mut W) -> io::Result<()> {
        self.has_value = true;
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::{Content, Ends, Generator, Holding, ParabolaCut};
    use crate::part::{Section, SectionKind};
    use crate::storage::examples;

    fn queen_text() -> &'static str {
        examples().iter().find(|e| e.name == "QUEEN").unwrap().text
    }

    fn queen() -> Document {
        document_from_text("queen.turn", queen_text()).unwrap()
    }

    #[test]
    fn every_older_version_still_opens() {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/cases/versions");
        for version in 1..=FORMAT_VERSION {
            let document = open_document(&folder.join(format!("v{version}.turn"))).unwrap();
            let Content::TurnedPart(part) = &document.content else { unreachable!("a turned part") };
            assert_eq!((document.turnwright, part.sections.len()), (FORMAT_VERSION, 6));
            assert_eq!(part.ends, Ends::Two { split: Some(30.5) });
            let generator = Generator::Oracap { parabolas: ParabolaCut::Arcs { tolerance: 0.01 }, optimize: false };
            assert_eq!(part.generator, generator);
            assert_eq!(part.overrides["OLD1"], "INC\nMM\n");
        }
    }

    #[test]
    fn a_bore_is_saved_one_section_a_line_and_its_rows_have_ids_of_their_own() {
        let mut document = queen();
        let Content::TurnedPart(part) = &mut document.content else { unreachable!("a turned part") };
        part.bore = vec![Section::line(501, 0.0, 3.0, 20.0, 3.0), Section::line(502, 20.0, 4.0, 56.0, 4.0)];
        part.bore[1].kind = SectionKind::Thread { pitch: 0.5, starts: 2 };
        (part.facing_allowance, part.stock_bore_diameter, part.holding) = (1.5, 2.0, Holding::BetweenCentres);
        let text = document_to_text(&document).unwrap();
        let rows: Vec<&str> = text.lines().filter(|line| line.contains("\"id\": 50")).collect();
        assert_eq!(rows.len(), 2);
        assert!(rows[1].contains("\"starts\": 2") && !rows[0].contains("starts"), "{text}");
        assert_eq!(document_from_text("bored.turn", &text).unwrap(), document);
        let twice = text.replace("\"id\": 502", "\"id\": 3");
        let fault = document_from_text("bored.turn", &twice).unwrap_err().remove(0);
        assert!(fault.message.contains("section 3 and bore section 2 with the same id, 3"), "{}", fault.message);
        let many = text.replace("\"starts\": 2", "\"starts\": 25");
        assert!(document_from_text("bored.turn", &many).unwrap_err()[0].message.contains("25 starts"));
    }

    #[test]
    fn a_saved_document_has_one_section_a_line_and_opens_equal() {
        let mut document = queen();
        let Content::TurnedPart(part) = &mut document.content else { unreachable!("a turned part") };
        part.bar_diameter = 0.1 + 0.2;
        part.length = f64::MIN_POSITIVE;
        part.sections[3].z1 = 1.0 / 3.0;
        part.overrides.insert("QUEEN1".to_owned(), "\u{2}PAGE 01\r\n".to_owned());
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("queen.turn");
        save_document(&path, &document).unwrap();
        assert_eq!(open_document(&path).unwrap(), document);
        let text = std::fs::read_to_string(&path).unwrap();
        assert_eq!(text.lines().filter(|l| l.contains("\"id\":")).count(), 12);
        assert!(text.starts_with("{\n  \"turnwright\": 1,\n  \"name\": \"QUEEN\",\n"), "{text}");
    }

    #[test]
    fn a_document_that_could_not_be_opened_again_is_not_saved() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("queen.turn");
        save_document(&path, &queen()).unwrap();
        let breaks: [fn(&mut Document); 7] = [
            |d| d.name = "../queen".to_owned(),
            |d| d.name = " ".to_owned(),
            |d| d.turnwright = 2,
            |d| d.content.turned_part_mut().unwrap().form_tolerance = 0.0,
            |d| d.content.turned_part_mut().unwrap().sections[2].d1 = f64::NAN,
            |d| {
                let rows = &mut d.content.turned_part_mut().unwrap().sections;
                rows[2].id = rows[1].id;
            },
            |d| {
                d.content.turned_part_mut().unwrap().sections[2].kind =
                    SectionKind::ParabolaAlongX { z3: 0.0, d3: 0.0, chords: 0 };
            },
        ];
        for break_it in breaks {
            let mut document = queen();
            break_it(&mut document);
            assert_eq!(save_document(&path, &document).unwrap_err().code, "document-value");
            assert_eq!(open_document(&path).unwrap(), queen());
        }
    }

    /// Replaces one piece of QUEEN and expects one diagnostic with a code, in the line of the new piece, with a text.
    fn assert_refused(from: &str, to: &str, code: &str, contains: &str) {
        assert!(queen_text().contains(from), "{from}");
        let text = queen_text().replacen(from, to, 1);
        let diagnostics = document_from_text("bad.turn", &text).unwrap_err();
        let [diagnostic] = diagnostics.as_slice() else { panic!("{diagnostics:?}") };
        assert_eq!(diagnostic.code, code, "{diagnostic}");
        assert!(diagnostic.message.contains(contains), "{diagnostic}");
        let line = 1 + text.lines().position(|l| l.contains(to)).unwrap();
        assert!(matches!(&diagnostic.at, Place::Line { line: l, .. } if *l == line), "{diagnostic}");
    }

    #[test]
    fn wrong_values_are_refused_with_line_value_and_limit() {
        assert_refused("\"turnwright\": 1", "\"turnwright\": 2", "newer-version", "version 2; this program reads");
        assert_refused("\"turnwright\": 1", "\"turnwright\": \"x\"", "unknown-version", "\"x\"");
        assert_refused("\"turnwright\": 1", "\"turnwright\": -1", "unknown-version", "-1");
        assert_refused("\"length\": 56.0", "\"length\": NaN", "document-unreadable", "NaN");
        assert_refused("\"length\": 56.0", "\"length\": 1e999", "document-unreadable", "1e999");
        assert_refused("\"length\": 56.0", "\"length\": \"56\"", "document-unreadable", "string \"56\", expected f64");
        assert_refused("\"length\": 56.0", "\"lenght\": 56.0", "document-unreadable", "unknown field `lenght`");
        assert_refused("\"part_off\": false", "\"part_off\": 0", "document-unreadable", "expected a boolean");
        assert_refused(
            "\"count\": \"one\"",
            "\"count\": \"one\", \"x\": 1",
            "document-unreadable",
            "unknown field `x`",
        );
        assert_refused("\"form_tolerance\": 0.25", "\"form_tolerance\": 0", "document-value", "tolerance is 0;");
        assert_refused("\"id\": 5,", "\"id\": 4,  ", "document-value", "section 4 and section 5 with the same id, 4");
        assert_refused("\"id\": 5,", "\"id\": -5,", "document-unreadable", "-5");
        assert_refused("\"name\": \"QUEEN\"", "\"name\": \"a/b\"", "document-value", "'/'");
        assert_refused("\"radius\": 30.0", "\"radius\": null", "document-unreadable", "has no `radius`");
    }
}
