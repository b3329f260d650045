//! Programs with changed bytes: the published listing of the roll and our own programs for every control. Nothing panics, and
//! a word that the control does not know is reported with its block.

use proptest::prelude::*;
use proptest::sample::Index;
use std::sync::{Arc, LazyLock};
use turnwright::cancel::Cancel;
use turnwright::document::{Content, Generator};
use turnwright::machine::{Catalog, outlines};
use turnwright::proof::{FindingKind, ProgramText, ProofInput, ProofReport, prove};
use turnwright::regen::{Cache, regenerate};
use turnwright::storage::{document_from_text, examples};

/// One good program with its machine.
struct Subject {
    input: ProofInput,
    text: String,
}

impl Subject {
    fn new(catalog: &Catalog, machine: &str, text: String) -> Self {
        let machine = catalog.machine(machine).unwrap().clone();
        let tools = Arc::new(outlines(&machine, catalog));
        let input = ProofInput { machine: Arc::new(machine), tools, programs: Arc::new(Vec::new()), work: None };
        Self { input, text }
    }

    fn prove(&self, text: String) -> ProofReport {
        let program = ProgramText { name: "CHANGED".to_owned(), text, edited: true };
        prove(&ProofInput { programs: Arc::new(vec![program]), ..self.input.clone() }, &Cancel::default()).unwrap()
    }
}

/// The programs of a shipped example as planned for a machine, or as they come if there is none.
fn posted(catalog: &Catalog, example: &str, planned_for: Option<&str>) -> Vec<String> {
    let example = examples().iter().find(|e| e.name == example).unwrap();
    let mut document = document_from_text(example.name, example.text).unwrap();
    let Content::TurnedPart(part) = &mut document.content else { unreachable!("a turned part") };
    if let Some(machine) = planned_for {
        machine.clone_into(&mut part.machine);
        part.generator = Generator::Planned { separate_programs: false };
    }
    let derived = regenerate(&Arc::new(document), catalog, &mut Cache::default(), &Cancel::default()).unwrap();
    derived.setups[0].programs.iter().map(|p| p.text.clone()).collect()
}

/// The listing first, then our programs of words, then our pages.
static SUBJECTS: LazyLock<Vec<Subject>> = LazyLock::new(|| {
    let catalog = Catalog::shipped();
    let listing = include_str!("../cases/1470b/NC1470b-2T.nc").to_owned();
    let mut subjects = vec![Subject::new(&catalog, "mori-fanuc-6t", listing)];
    let mut add = |machine: &str, texts: Vec<String>| {
        subjects.extend(texts.into_iter().map(|text| Subject::new(&catalog, machine, text)));
    };
    add("mori-fanuc-6t", posted(&catalog, "1470b-2T", None));
    for machine in ["fanuc-0i", "linuxcnc", "swedish-1970s"] {
        add(machine, posted(&catalog, "QUEEN", Some(machine)));
    }
    add("orac", posted(&catalog, "QUEEN", None));
    subjects
});

/// Letters that no lathe control here knows.
const UNKNOWN: [char; 3] = ['B', 'C', 'Y'];

/// The letters of words by byte, without those of comments.
fn letters(text: &str) -> Vec<usize> {
    let mut inside = false;
    let letter = |(at, c): (usize, char)| {
        inside = c == '(' || inside && c != ')';
        (!inside && c.is_ascii_alphabetic()).then_some(at)
    };
    text.char_indices().filter_map(letter).collect()
}

/// The line of a place, from 1.
fn line_of(text: &str, at: usize) -> usize {
    text[..at].matches('\n').count() + 1
}

fn changed(text: &str, changes: &[(Index, u8, u8)]) -> String {
    let mut bytes = text.as_bytes().to_vec();
    for (place, how, byte) in changes {
        let at = place.index(bytes.len());
        match how % 3 {
            0 => bytes[at] = *byte,
            1 => drop(bytes.remove(at)),
            _ => bytes.insert(at, *byte),
        }
    }
    String::from_utf8_lossy(&bytes).into_owned()
}

/// Findings that say that something could not be read.
fn unreadable(report: &ProofReport) -> Vec<(usize, String)> {
    let unreadable = report.findings.iter().filter(|f| f.kind == FindingKind::Unreadable);
    unreadable.map(|f| (f.block, f.message.clone())).collect()
}

#[test]
fn the_programs_are_read_to_the_last_word() {
    for subject in SUBJECTS.iter() {
        assert_eq!(unreadable(&subject.prove(subject.text.clone())), [], "{}", subject.input.machine.id);
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 256, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn no_changed_byte_panics(
        which in any::<Index>(),
        changes in prop::collection::vec((any::<Index>(), any::<u8>(), any::<u8>()), 1..6),
    ) {
        let subject = which.get(&SUBJECTS);
        let text = changed(&subject.text, &changes);
        let lines = text.split(['\n', '\r', ';']).count();
        let report = subject.prove(text);
        prop_assert!(report.times.total_s.is_finite() && report.times.total_s >= 0.0);
        prop_assert!(report.findings.iter().all(|f| (1..=lines).contains(&f.block) && f.message.len() > 20));
    }

    #[test]
    fn a_letter_that_the_control_does_not_know_is_reported_with_its_block(
        which in any::<Index>(),
        place in any::<Index>(),
        letter in prop::sample::select(UNKNOWN.to_vec()),
    ) {
        let words: Vec<&Subject> = SUBJECTS.iter().filter(|s| s.input.machine.words.is_some()).collect();
        let subject = which.get(&words);
        let at = *place.get(&letters(&subject.text));
        let mut text = subject.text.clone();
        text.replace_range(at..=at, &letter.to_string());
        let (block, said) = (line_of(&text, at), unreadable(&subject.prove(text)));
        prop_assert!(said.iter().any(|(b, m)| *b == block && m.contains(letter)), "{block}: {said:?}");
    }

    #[test]
    fn a_code_that_the_control_does_not_know_is_reported_with_its_block(
        which in any::<Index>(),
        place in any::<Index>(),
        code in prop::sample::select(vec!["G87", "G5.3", "M77"]),
    ) {
        let words: Vec<&Subject> = SUBJECTS.iter().filter(|s| s.input.machine.words.is_some()).collect();
        let subject = which.get(&words);
        let at = *place.get(&letters(&subject.text));
        let mut lines: Vec<String> = subject.text.split('\n').map(str::to_owned).collect();
        let block = line_of(&subject.text, at);
        let line = lines[block - 1].trim_end().to_owned();
        lines[block - 1] = format!("{line}{code}");
        let said = unreadable(&subject.prove(lines.join("\n")));
        prop_assert!(said.iter().any(|(b, m)| *b == block && m.contains(code)), "{block}: {said:?}");
    }
}
