//! `turnwright build` on shell documents that are broken: it ends by itself, and says what is wrong with value and limit.

use std::path::Path;
use std::process::{Command, Output};

/// Builds the cone with one text of its file replaced.
fn build(from: &str, to: &str) -> (Output, tempfile::TempDir) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/examples/cone.turn");
    let text = std::fs::read_to_string(path).expect("the example");
    assert!(text.contains(from), "{from}");
    let folder = tempfile::tempdir().expect("a temporary folder");
    let file = folder.path().join("broken.turn");
    std::fs::write(&file, text.replace(from, to)).expect("written");
    let out = folder.path().join("out");
    let command =
        Command::new(env!("CARGO_BIN_EXE_turnwright")).arg("build").arg(&file).arg("--out").arg(&out).output();
    (command.expect("the program starts"), folder)
}

#[test]
fn broken_shells_end_with_a_message_of_place_value_and_limit() {
    let cone = r#"{"type": "cone", "half_angle_deg": 30.0, "tip_diameter": 40.0, "length": 50.0}"#;
    let rows = |rows: &str| format!(r#"{{"type": "sections", "sections": [{rows}]}}"#);
    let line = r#"{"id": 1, "type": "line", "z1": 0.0, "d1": 90.0, "z2": 30.0, "d2": 60.0}"#;
    let apart = rows(&format!("{line}, {}", line.replace("\"id\": 1", "\"id\": 2")));
    let arc = rows(&line.replace("\"line\"", "\"convex\", \"radius\": 5.0"));
    let cases: [(&str, &str, &[&str]); 20] = [
        ("30.0, \"tip", "0.0, \"tip", &["half_angle_deg", "0°", "between 0° and 90°"]),
        ("30.0, \"tip", "-30.0, \"tip", &["half_angle_deg", "-30°"]),
        ("30.0, \"tip", "7.9, \"tip", &["7.9°", "12°"]),
        ("30.0, \"tip", "89.9999999, \"tip", &["100000 mm"]),
        ("30.0, \"tip", "1e300, \"tip", &["half_angle_deg", "1e300", "100000"]),
        ("30.0, \"tip", "1e999, \"tip", &["broken.turn:11:"]),
        ("30.0, \"tip", "NaN, \"tip", &["broken.turn:11:"]),
        ("30.0, \"tip", "\"steep\", \"tip", &["broken.turn:11:"]),
        ("\"length\": 50.0", "\"length\": -50.0", &["length", "-50.000 mm", "more than 0"]),
        ("\"thickness\": 1.6", "\"thickness\": 0.0", &["thickness", "0.000 mm", "more than 0"]),
        ("\"thickness\": 1.6", "\"thickness\": 1.6, \"diameter\": 0.0", &["blank.diameter", "0.000 mm"]),
        ("\"nose_radius\": 9.0", "\"nose_radius\": -9.0", &["nose_radius", "-9.000 mm", "more than 0"]),
        ("\"gap_tolerance\": 0.02", "\"gap_tolerance\": 0.0", &["gap_tolerance", "0.000 mm", "more than 0"]),
        ("\"passes\": 1", "\"passes\": 4000000000", &["passes", "4000000000", "1 to 8"]),
        ("\"passes\": 1", "\"passes\": -1", &["broken.turn:"]),
        ("\"passes\"", "\"pases\"", &["pases"]),
        ("\"rpm\": 95.0", "\"rpm\": 1e5", &["rig.rpm", "100000", "750"]),
        (cone, &rows(""), &["sections", "0 rows", "at least 1"]),
        (cone, &apart, &["sections[1]", "30.000 mm"]),
        (cone, &arc, &["sections[0]", "5.000 mm", "at least 16.771 mm"]),
    ];
    for (from, to, wanted) in cases {
        let (output, _keep) = build(from, to);
        let said = [&output.stdout, &output.stderr].map(|bytes| String::from_utf8_lossy(bytes).into_owned()).concat();
        let code = output.status.code();
        assert!(matches!(code, Some(1 | 2)), "{to}: ends with {code:?}: {said}");
        assert!(!said.contains("panicked"), "{to}: {said}");
        for wanted in wanted {
            assert!(said.contains(wanted), "{to}: no {wanted} in {said}");
        }
    }
}
