//! Another program draws the setup sheet's PDF: `pdftoppm` of poppler. Where it is not installed, the test says so.
//!
//! `UPDATE_SCREENSHOTS=1 cargo test --test engine papers::` writes `screenshots/setup-sheet.png` with it.

use super::sheet;
use std::path::Path;
use std::process::{Command, Stdio};
use turnwright::papers::save;

/// Dots to the inch: the smallest text is read without effort.
const RESOLUTION: &str = "120";

#[test]
fn the_setup_sheet_of_the_roll_is_drawn_by_another_program() {
    if Command::new("pdftoppm").arg("-v").stderr(Stdio::null()).status().is_err() {
        println!("pdftoppm is not installed; nobody drew the setup sheet.");
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("sheet.pdf");
    save(&file, &sheet("1470b-2T")[..1]).unwrap();
    let draw = |kind: &[&str], out: &Path| {
        let output =
            Command::new("pdftoppm").args(["-r", RESOLUTION, "-singlefile"]).args(kind).arg(&file).arg(out).output();
        let output = output.unwrap();
        assert!(output.status.success() && output.stderr.is_empty(), "{}", String::from_utf8_lossy(&output.stderr));
    };
    draw(&["-gray"], &folder.path().join("sheet"));
    let picture = std::fs::read(folder.path().join("sheet.pgm")).unwrap();
    assert!(picture.starts_with(b"P5\n992 1403\n255\n") || picture.starts_with(b"P5\n993 1404\n255\n"), "A4");
    let dark = picture.iter().filter(|shade| **shade < 96).count() as f64 / picture.len() as f64;
    assert!((0.01..0.2).contains(&dark), "lines and texts, {dark:.3} of the page");
    if std::env::var_os("UPDATE_SCREENSHOTS").is_some_and(|v| v == "1") {
        draw(&["-png"], &Path::new(env!("CARGO_MANIFEST_DIR")).join("screenshots/setup-sheet"));
    }
}
