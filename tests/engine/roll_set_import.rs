//! The published inputs of section 1470b become a set of form-rolls, by the library and by the command.

use std::path::{Path, PathBuf};
use std::process::Command;
use turnwright::document::{Content, DevelopedWidth, Document, Origin, RollSet};
use turnwright::rollform::bends::{Stage, angles_deg};
use turnwright::rollform::developed::developed;
use turnwright::storage::{document_from_text, document_to_text, import, open_document};
use turnwright::units::Unit;

fn case(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/cases/1470b").join(name)
}

fn read() -> Document {
    let (section, said) = import::any(&case("1470b-section.json"), "orac").unwrap();
    assert_eq!(said, []);
    let (document, said) = import::with_flower(section, &case("1470b-flower.json")).unwrap();
    assert_eq!(said, []);
    document
}

fn set(document: &Document) -> &RollSet {
    match &document.content {
        Content::RollSet(set) => set,
        _ => panic!("no set of form-rolls"),
    }
}

#[test]
fn section_and_flower_are_read_as_printed() {
    let document = read();
    assert_eq!((document.name.as_str(), document.unit), ("1470b", Unit::Mm));
    let set = set(&document);
    assert_eq!((set.section.thickness, set.section.origin), (0.5, Origin::Symmetrical));
    assert_eq!((set.section.elements.len(), set.stations.len()), (21, 3));
    let at = |station, element| angles_deg(set, Stage::Station(station))[&element];
    assert_eq!([at(0, 20), at(1, 20), at(2, 20), at(2, 10)], [0.0, -50.0, -75.0, -45.0]);
}

#[test]
fn strip_size_of_every_method() {
    let document = read();
    // By hand: lines 45.6568 mm a side, bends of 143° with 1.5 mm, 113° with 2.5 mm and 180° with 0.06 mm.
    for (method, wanted) in [
        (DevelopedWidth::RolfomTable, 111.9504),
        (DevelopedWidth::MeanLine, 112.8440),
        (DevelopedWidth::Din6935, 111.4314),
        (DevelopedWidth::Asm, 112.3204),
        (DevelopedWidth::AsmLessFormable, 112.3204),
        (DevelopedWidth::Angel, 112.4163),
        (DevelopedWidth::Own { k: 0.5 }, 112.8440),
    ] {
        let width = developed(&set(&document).section, method).width;
        assert!((width - wanted).abs() < 0.00005, "{method:?}: {width}");
    }
}

#[test]
fn saved_set_is_opened_as_it_was() {
    let document = read();
    let text = document_to_text(&document).unwrap();
    assert_eq!(document_from_text("1470b.turn", &text).unwrap(), document);
    let strange = text.replacen("\"length\": 40.6499", "\"length\": 40.6499, \"width\": 1", 1);
    let refused = document_from_text("1470b.turn", &strange).unwrap_err();
    assert!(refused[0].message.contains("unknown field `width`"), "{refused:?}");
}

#[test]
fn command_makes_a_document_of_the_inputs() {
    let folder = tempfile::tempdir().unwrap();
    let output = folder.path().join("1470b.turn");
    let status = Command::new(env!("CARGO_BIN_EXE_turnwright"))
        .arg("convert")
        .arg(case("1470b-section.json"))
        .arg("--flower")
        .arg(case("1470b-flower.json"))
        .arg(&output)
        .status()
        .unwrap();
    assert!(status.success());
    assert_eq!(open_document(&output).unwrap(), read());
}
