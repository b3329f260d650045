//! The headless commands as a user runs them: files in, files out, exit codes.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

fn turnwright(args: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_turnwright")).args(args).output().expect("the program starts")
}

fn example(name: &str) -> String {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/examples").join(name).display().to_string()
}

fn code(output: &Output) -> i32 {
    output.status.code().expect("the program ends by itself")
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

fn built(name: &str) -> (tempfile::TempDir, PathBuf) {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let out = folder.path().join("out");
    let output = turnwright(&["build", &example(name), "--out", &out.display().to_string()]);
    assert_eq!(code(&output), 0, "{}{}", text(&output.stdout), text(&output.stderr));
    (folder, out)
}

fn json(path: &Path) -> serde_json::Value {
    serde_json::from_str(&std::fs::read_to_string(path).expect("the file is there")).expect("the file is JSON")
}

#[test]
fn every_example_builds_and_is_proved() {
    for entry in std::fs::read_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/examples")).expect("examples") {
        let path = entry.expect("an example").path();
        if path.extension().is_some_and(|e| e == "turn") {
            let name = path.file_name().expect("a file").to_string_lossy().into_owned();
            let (_keep, out) = built(&name);
            assert_eq!(json(&out.join("report.json"))["good"], true, "{name}");
        }
    }
}

/// Every roll of the published set has its files under the published names, and the set has its own.
#[test]
fn a_roll_set_builds_every_file_under_its_published_name() {
    let (_keep, out) = built("1470b.turn");
    let rolls = ["1T", "1B", "2T", "2B", "3T", "3B", "3L", "3R"].map(|roll| format!("1470b-{roll}"));
    let of_roll = |roll: &String| {
        let own = ["contour.json", "setup.json", "proof.json", "dxf", "pdf"].map(|ending| format!("{roll}.{ending}"));
        own.into_iter().chain([format!("E{roll}.txt"), format!("NC{roll}.nc")])
    };
    let of_set = ["1470b.parts.csv", "1470b.parts.pdf", "1470b.die.dxf", "report.json"].map(str::to_owned);
    let mut wanted: Vec<String> = rolls.iter().flat_map(of_roll).chain(of_set).collect();
    wanted.sort();
    let mut found: Vec<String> = std::fs::read_dir(&out)
        .expect("the folder")
        .map(|entry| entry.expect("a file").file_name().to_string_lossy().into_owned())
        .collect();
    found.sort();
    assert_eq!(found, wanted);
    for roll in &rolls {
        assert_eq!(json(&out.join(format!("{roll}.proof.json")))["passed"], true, "{roll}");
        let program = std::fs::read_to_string(out.join(format!("NC{roll}.nc"))).expect("a program");
        assert!(program.lines().count() > 20 && program.contains("M30"), "{roll}");
    }
}

#[test]
fn one_roll_of_a_set_is_drawn_in_every_kind_of_file() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let draw = |ending: &str, roll: &str| {
        let file = folder.path().join(format!("roll.{ending}"));
        turnwright(&["draw", &example("1470b.turn"), &file.display().to_string(), "--roll", roll])
    };
    for ending in ["pdf", "svg", "dxf", "plt"] {
        let output = draw(ending, "2T");
        assert_eq!(code(&output), 0, "{}", text(&output.stderr));
        let written = text(&output.stdout);
        // The view and its details; only a PDF has both pages in one file.
        assert_eq!(written.lines().count(), if ending == "pdf" { 1 } else { 2 }, "{written}");
        assert!(written.lines().all(|file| Path::new(file).is_file()), "{written}");
    }
    let refused = draw("pdf", "9T");
    assert_eq!(code(&refused), 2);
    assert!(text(&refused.stderr).contains("1470b-2T"), "{}", text(&refused.stderr));
}

#[test]
fn build_writes_contour_setup_programs_and_proof() {
    let (_keep, out) = built("queen.turn");
    let contour = json(&out.join("QUEEN.contour.json"));
    let segments = contour["segments"].as_array().expect("segments");
    let near = |value: &serde_json::Value, wanted: f64| value.as_f64().is_some_and(|v| (v - wanted).abs() < 1e-9);
    assert!(segments.iter().any(|s| s["type"] == "arc" && near(&s["radius"], 30.0)));
    let setup = json(&out.join("QUEEN.setup.json"));
    assert_eq!(setup["stock"]["bar_diameter"], 26.2);
    assert_eq!(setup["tools"].as_array().map(Vec::len), Some(2), "right-hand and left-hand tool");
    assert_eq!(json(&out.join("QUEEN.proof.json"))["passed"], true);
    for file in ["QUEEN1.anc", "QUEEN1.bnc", "QUEEN1.cnc", "QUEEN2.cnc", "QUEEN5.bnc"] {
        assert!(out.join(file).is_file(), "{file}");
    }
}

#[test]
fn prove_accepts_what_build_wrote() {
    let (_keep, out) = built("master.turn");
    for program in ["MASTER1.cnc", "MASTER2.cnc"] {
        let path = out.join(program).display().to_string();
        let output = turnwright(&["prove", &path, "--machine", "orac", "--part", &example("master.turn"), "--json"]);
        assert_eq!(code(&output), 0, "{program}: {}", text(&output.stdout));
        let report: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
        assert_eq!(report["passed"], true);
        assert_eq!(report["differences"].as_array().map(Vec::len), Some(0));
    }
}

/// The published demonstration: one z of an assembled MASTER program is changed, and the proof says which block and by how much.
#[test]
fn one_changed_z_is_found_with_its_block_and_amount() {
    let (_keep, out) = built("master.turn");
    let path = out.join("MASTER1.cnc");
    let good = std::fs::read_to_string(&path).expect("the program");
    let page = good.find("Z  -43.000").expect("the first stroke over the whole length");
    let block = good[..page].matches("PAGE ").count();
    std::fs::write(&path, good.replacen("Z  -43.000", "Z  -33.000", 1)).expect("written");
    let path = path.display().to_string();
    let output = turnwright(&["prove", &path, "--machine", "orac", "--part", &example("master.turn"), "--json"]);
    assert_eq!(code(&output), 1, "{}", text(&output.stdout));
    let report: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
    let difference = &report["differences"][0];
    assert_eq!(difference["block"], block);
    assert!((difference["difference"].as_f64().expect("a number") - 10.0).abs() < 1e-9, "{difference}");
}

#[test]
fn unusable_input_ends_with_two_and_names_the_place() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let broken = folder.path().join("broken.turn");
    std::fs::write(&broken, "{\n  \"turnwright\": 1,\n  \"name\": 7\n}\n").expect("written");
    let out = folder.path().join("out").display().to_string();
    let output = turnwright(&["build", &broken.display().to_string(), "--out", &out]);
    assert_eq!(code(&output), 2);
    assert!(text(&output.stderr).contains("broken.turn:3"), "{}", text(&output.stderr));
    assert_eq!(code(&turnwright(&["build", "no-such-file.turn", "--out", &out])), 2);
    assert_eq!(code(&turnwright(&["prove", &example("queen.turn"), "--machine", "no-such-machine"])), 2);
    assert_eq!(code(&turnwright(&["frobnicate"])), 2);
}

#[test]
fn every_command_has_help() {
    let commands = ["build", "prove", "send", "receive", "lathe", "convert", "machines", "tools", "materials"];
    for command in commands {
        let output = turnwright(&[command, "--help"]);
        assert_eq!(code(&output), 0);
        assert!(text(&output.stdout).contains("Usage:"), "{command}");
    }
}

#[test]
fn lists_are_readable_by_people_and_programs() {
    for list in ["machines", "tools", "materials"] {
        assert!(!text(&turnwright(&[list]).stdout).trim().is_empty());
        let all: serde_json::Value = serde_json::from_slice(&turnwright(&[list, "--json"]).stdout).expect("JSON");
        assert!(!all.as_array().expect("a list").is_empty());
    }
}

#[test]
fn papers_are_made_in_every_kind_of_file() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let out = |name: &str| folder.path().join(name).display().to_string();
    for (name, head) in [("queen.pdf", "%PDF"), ("queen.svg", "<?xml"), ("queen.dxf", "  0"), ("queen.plt", "IN;")] {
        let output = turnwright(&["draw", &example("queen.turn"), &out(name), "--paper", "a2"]);
        assert_eq!(code(&output), 0, "{}", text(&output.stderr));
        assert_eq!(text(&output.stdout).trim(), out(name));
        assert!(std::fs::read(out(name)).expect("the drawing").starts_with(head.as_bytes()), "{name}");
    }
    let output = turnwright(&["sheet", &example("spigot.turn"), &out("sheet.svg")]);
    assert_eq!(code(&output), 0, "{}", text(&output.stderr));
    assert!(Path::new(&out("sheet-1.svg")).is_file() && Path::new(&out("sheet-2.svg")).is_file(), "one file a page");
}

#[test]
fn papers_that_cannot_be_made_end_with_two_and_a_reason() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let out = |name: &str| folder.path().join(name).display().to_string();
    let refused = |args: &[&str], reason: &str| {
        let output = turnwright(args);
        assert_eq!(code(&output), 2, "{}", text(&output.stderr));
        assert!(text(&output.stderr).contains(reason), "{}", text(&output.stderr));
    };
    let queen = example("queen.turn");
    refused(&["draw", &queen, &out("none/queen.pdf")], "cannot be saved");
    refused(&["sheet", &queen, &out("queen.doc")], "cannot be written as \".doc\"");
    refused(&["draw", &queen, &out("queen.pdf"), "--paper", "B4"], "use A0 to A4");
    refused(&["draw", &queen, &out("queen.pdf"), "--paper", "A4", "--scale", "10"], "2:1 is the largest");
    assert_eq!(std::fs::read_dir(folder.path()).expect("the folder").count(), 0, "nothing was written");
}
