//! Bad input of every kind of file: always a diagnostic with place and value, never a panic, nothing lost.

use std::fs;
use std::path::{Path, PathBuf};
use turnwright::diagnostic::{Diagnostic, Place};
use turnwright::document::{Content, Document, Kind};
use turnwright::machine::Catalog;
use turnwright::storage::{document_from_text, document_to_text, examples, examples_of, export, import, recovery};

/// A folder with one file of every kind that holds a part, and the paths of these files.
struct Files {
    _folder: tempfile::TempDir,
    paths: Vec<PathBuf>,
}

fn files() -> Files {
    let folder = tempfile::tempdir().unwrap();
    let mut paths = Vec::new();
    for example in examples() {
        let document = document_from_text(example.name, example.text).unwrap();
        let kinds: &[&str] = if example.kind == Kind::TurnedPart { &["turn", "CAD", "dxf", "tsv"] } else { &["turn"] };
        for extension in kinds {
            let path = folder.path().join(example.name).with_extension(extension);
            export::any(&document, &Catalog::shipped(), &path).unwrap();
            paths.push(path);
        }
    }
    Files { _folder: folder, paths }
}

fn is_kind(path: &Path, extension: &str) -> bool {
    path.extension().is_some_and(|e| e == extension)
}

type Outcome = Result<(Document, Vec<Diagnostic>), Vec<Diagnostic>>;

/// A refusal names a place in a file and says something; whatever is accepted can be saved.
fn assert_honest(outcome: &Outcome, what: &str) {
    match outcome {
        Ok((document, _)) => assert!(document_to_text(document).is_ok(), "{what} was opened but cannot be saved"),
        Err(diagnostics) => {
            assert!(!diagnostics.is_empty(), "{what} was refused without a word");
            for d in diagnostics {
                assert!(matches!(d.at, Place::Line { .. } | Place::File { .. }), "{what}: no place: {d}");
                assert!(d.message.len() > 20, "{what}: {d}");
            }
        }
    }
}

fn open_with(path: &Path, bytes: &[u8]) -> Outcome {
    fs::write(path, bytes).unwrap();
    import::any(path, "orac")
}

/// Repeatable numbers for changes at random places (Knuth's 64-bit linear congruence).
struct Random(u64);

impl Random {
    fn below(&mut self, limit: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        usize::try_from(self.0 >> 33).unwrap() % limit
    }
}

#[test]
fn every_beginning_of_every_document_is_refused() {
    for example in examples() {
        for end in 0..example.text.trim_end().len() {
            let Some(text) = example.text.get(..end) else { continue };
            let diagnostics = document_from_text("cut.turn", text).unwrap_err();
            let at_end = matches!(diagnostics[0].at, Place::Line { line, .. } if line + 1 >= text.lines().count());
            assert!(at_end || text.is_empty(), "{} cut at {end}: {}", example.name, diagnostics[0]);
        }
    }
}

#[test]
fn every_beginning_of_a_cad_siz_or_end_file_is_refused_or_read() {
    for example in examples_of(Kind::TurnedPart) {
        let document = document_from_text(example.name, example.text).unwrap();
        let Content::TurnedPart(part) = &document.content else { unreachable!("a turned part") };
        let (texts, _) = export::cad(&document, part);
        for end in 0..texts.cad.len() {
            let cut = import::CadTexts { cad: texts.cad[..end].to_owned(), ..texts.clone() };
            let outcome = import::cad("cut.CAD", "cut", &cut, "orac");
            assert_honest(&outcome, &format!("{}.CAD cut at {end}", example.name));
            // Only a cut within the last row's last number or comment can leave a whole part.
            let rows_before_last = texts.cad.rfind("sect,type").unwrap();
            assert!(end > rows_before_last || outcome.is_err(), "{} rows from {end} bytes", part.sections.len());
        }
        let siz = texts.siz.clone().unwrap();
        for end in 0..siz.len() {
            let cut = import::CadTexts { siz: Some(siz[..end].to_owned()), ..texts.clone() };
            assert_honest(&import::cad("cut.CAD", "cut", &cut, "orac"), &format!("{}.SIZ cut at {end}", example.name));
        }
        let none = import::CadTexts { end: Some(String::new()), ..texts };
        assert!(import::cad("cut.CAD", "cut", &none, "orac").is_err());
    }
}

const ROLL: &str = include_str!("../cases/1470b/E1470b-2T.txt");
const INSTRUCTIONS: &str = include_str!("../cases/1470b/CU1470b-2T.json");

#[test]
fn every_beginning_of_a_roll_profile_or_its_instructions_is_refused() {
    for end in 0..ROLL.trim_end().len() {
        let outcome = import::roll("cut.txt", &ROLL[..end]);
        assert_honest(&outcome, &format!("profile cut at {end}"));
        assert!(outcome.is_err(), "profile cut at {end}");
    }
    let (document, _) = import::roll("roll.txt", ROLL).unwrap();
    for end in (0..INSTRUCTIONS.trim_end().len()).filter(|&end| INSTRUCTIONS.is_char_boundary(end)) {
        let outcome = import::instructions("cut.json", &INSTRUCTIONS[..end], document.clone());
        assert_honest(&outcome, &format!("instructions cut at {end}"));
        assert!(outcome.is_err(), "instructions cut at {end}");
    }
}

#[test]
fn random_changes_of_a_roll_profile_or_its_instructions_are_refused_or_harmless() {
    let (document, _) = import::roll("roll.txt", ROLL).unwrap();
    let mut random = Random(7);
    for round in 0..1500 {
        let mut changed = |text: &str| {
            let mut bytes = text.as_bytes().to_vec();
            for _ in 0..=random.below(3) {
                let at = random.below(bytes.len());
                match random.below(3) {
                    0 => bytes[at] = b"-.e9 0\"{}[],:"[random.below(13)],
                    1 => drop(bytes.remove(at)),
                    _ => bytes.insert(at, u8::try_from(32 + random.below(95)).unwrap()),
                }
            }
            String::from_utf8_lossy(&bytes).into_owned()
        };
        let (profile, instructions) = (changed(ROLL), changed(INSTRUCTIONS));
        assert_honest(&import::roll("bad.txt", &profile), &format!("profile of round {round}"));
        let outcome = import::instructions("bad.json", &instructions, document.clone());
        assert_honest(&outcome, &format!("instructions of round {round}"));
    }
}

#[test]
fn a_drawing_cut_anywhere_is_refused() {
    let files = files();
    for path in files.paths.iter().filter(|p| is_kind(p, "dxf")) {
        let bytes = fs::read(path).unwrap();
        let mark = bytes.windows(3).rposition(|w| w == b"EOF").unwrap();
        for end in (0..mark + 2).step_by(211) {
            let outcome = open_with(path, &bytes[..end]);
            assert_eq!(outcome.unwrap_err()[0].code, "dxf-truncated", "{end}");
        }
    }
}

#[test]
fn random_changes_of_bytes_never_panic_and_are_refused_or_harmless() {
    let files = files();
    let mut random = Random(42);
    for path in &files.paths {
        let bytes = fs::read(path).unwrap();
        // Drawings are long and slow to read.
        let rounds = if is_kind(path, "dxf") { 30 } else { 150 };
        for round in 0..rounds {
            let mut changed = bytes.clone();
            for _ in 0..=random.below(4) {
                let at = random.below(changed.len());
                match random.below(4) {
                    0 => changed[at] = u8::try_from(random.below(256)).unwrap(),
                    1 => drop(changed.remove(at)),
                    2 => changed.insert(at, u8::try_from(32 + random.below(95)).unwrap()),
                    _ => changed[at] = b"-.e9\0\"{}[],:"[random.below(12)],
                }
            }
            assert_honest(&open_with(path, &changed), &format!("{} changed in round {round}", path.display()));
        }
    }
}

#[test]
fn numbers_that_are_none_are_refused_with_value_and_place() {
    let files = files();
    for path in &files.paths {
        let text = fs::read_to_string(path).unwrap();
        for bad in ["NaN", "1e999", "-inf", "1..5", "0x10", "1-", "ten"] {
            let changed = with_bad_diameter(path, &text, bad);
            let outcome = open_with(path, changed.as_bytes());
            assert_honest(&outcome, bad);
            let diagnostics = match outcome {
                // A bad cell costs its row, a bad entity itself; the rest survives and the message is there.
                Ok((_, diagnostics)) | Err(diagnostics) => diagnostics,
            };
            let shown: Vec<String> = diagnostics.iter().map(|d| d.message.clone()).collect();
            let value = bad.trim_start_matches('-');
            let found = shown.iter().any(|m| m.to_lowercase().contains(&value.to_lowercase()) || m.contains("inf"));
            assert!(found, "{} with {bad}: {shown:?}", path.display());
        }
    }
}

/// The text of a file with one diameter or coordinate replaced by `bad`.
fn with_bad_diameter(path: &Path, text: &str, bad: &str) -> String {
    if is_kind(path, "turn") {
        // A diameter of a part, the thickness of a strip or of a blank.
        let at = ["\"d1\": ", "\"thickness\": "].iter().find_map(|key| Some(text.find(key)? + key.len())).unwrap();
        let end = at + text[at..].find([',', '}', '\n']).unwrap();
        return format!("{}{bad}{}", &text[..at], &text[end..]);
    }
    if is_kind(path, "dxf") {
        let at = text.find("AcDbLine\r\n 10\r\n").unwrap() + 15;
        let end = at + text[at..].find('\r').unwrap();
        return format!("{}{bad}{}", &text[..at], &text[end..]);
    }
    let (line, cell) = if is_kind(path, "tsv") { (1, 2) } else { (2, 1) };
    let lines = text.lines().enumerate().map(|(i, l)| {
        let mut cells: Vec<&str> =
            if is_kind(path, "tsv") { l.split('\t').collect() } else { l.split_whitespace().collect() };
        if i == line {
            cells[cell] = bad;
        }
        cells.join("\t") + "\n"
    });
    lines.collect()
}

#[test]
fn empty_missing_foreign_and_oversized_files_and_folders_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let refused = |path: &Path, code: &str| {
        let outcome = import::any(path, "orac");
        assert_honest(&outcome, code);
        assert_eq!(outcome.unwrap_err().pop().unwrap().code, code, "{}", path.display());
    };
    for (extension, code) in [
        ("turn", "document-truncated"),
        ("cad", "cad-truncated"),
        ("dxf", "dxf-truncated"),
        ("tsv", "no-sections"),
        ("txt", "roll-truncated"),
        ("xyz", "unknown-file-kind"),
    ] {
        let path = folder.path().join("empty").with_extension(extension);
        fs::write(&path, "").unwrap();
        refused(&path, code);
        let path = folder.path().join("folder").with_extension(extension);
        fs::create_dir(&path).unwrap();
        refused(&path, "not-a-file");
        refused(&folder.path().join("missing").with_extension(extension), "file-unreadable");
    }
    for extension in ["turn", "cad", "tsv", "txt"] {
        let path = folder.path().join("bytes").with_extension(extension);
        fs::write(&path, b"{\n\xff\xfe").unwrap();
        refused(&path, "not-utf8");
    }
    let path = folder.path().join("long.turn");
    fs::File::create(&path).unwrap().set_len(1 << 30).unwrap();
    refused(&path, "file-too-long");
}

#[test]
fn a_recovery_folder_of_rubbish_yields_diagnostics_and_keeps_its_files() {
    let folder = tempfile::tempdir().unwrap();
    let rubbish: [(&str, &[u8]); 4] = [
        ("a.recovery", b""),
        ("b.recovery", b"{}\n{}"),
        ("c.recovery", b"\xff"),
        ("d.recovery", examples()[0].text.as_bytes()),
    ];
    for (name, bytes) in rubbish {
        fs::write(folder.path().join(name), bytes).unwrap();
    }
    fs::create_dir(folder.path().join("e.recovery")).unwrap();
    let (found, diagnostics) = recovery::left_over(folder.path());
    assert_eq!((found.len(), diagnostics.len()), (0, 5), "{diagnostics:?}");
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 5);
}
