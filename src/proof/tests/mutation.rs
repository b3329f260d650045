//! Broken programs: nothing panics, and nothing broken passes in silence.

use super::*;
use proptest::prelude::*;

/// A program that uses every kind of page.
fn pages() -> String {
    let list = [
        "INCREMENTAL-FORMAT.G91",
        "MM-UNITS",
        "PROGRAM-DATUM|X   12.000|Z   20.000",
        "POINT-TO-POINT.G00,G01|X   -2.500|Z  -19.000|FEEDRATE 1000|TOOL-NO 1|SPINDLE-SPEED 1094",
        "START-DO-LOOP|COUNT 2",
        "CALL-SUBROUTINE|NUMBER 1",
        "END-DO-LOOP",
        "SUBROUTINE-START|NUMBER 1",
        "POINT-TO-POINT.G00,G01|X    0.000|Z  -10.000|FEEDRATE   80|TOOL-NO 1|SPINDLE-SPEED 1094",
        "POINT-TO-POINT.G00,G01|X    0.000|Z   10.000|FEEDRATE 1000|TOOL-NO 1|SPINDLE-SPEED 1094",
        "END-SUBROUTINE",
        "CIRCULAR.G03|X    2.500|Z   -2.500|RADIUS    2.500|FEEDRATE   80|TOOL-NO 1|SPINDLE-SPEED 1094",
        "DWELL.G04|TIME 1.5",
        "POINT-TO-POINT.G00,G01|X    0.000|Z   21.500|FEEDRATE 1000|TOOL-NO 1|SPINDLE-SPEED 1094",
        "AUXILIARY-INPUT|CHANNEL 1",
        "AUXILIARY-OUTPUT|CHANNEL 1|STATE 0",
        "END-PROGRAM..M02",
    ];
    let page = |(i, body): (usize, &&str)| format!("\u{2}PAGE {:02} {}\r\n", i + 1, body.replace('|', "\r\n"));
    list.iter().enumerate().map(page).collect()
}

fn compare_pages(was: &str, is: &str) -> Vec<Change> {
    compare(was, is, crate::machine::Dialect::Orac)
}

fn prove_page_text(text: &str) -> ProofReport {
    prove_input(&with_work(&[text], work()))
}

#[test]
fn the_whole_program_is_good() {
    let report = prove_page_text(&pages());
    assert_eq!(faults(&report), [], "{:?}", report.findings);
}

#[test]
fn no_truncated_program_passes() {
    let text = pages();
    let whole = text.trim_end().len();
    for end in (0..whole).filter(|&end| text.is_char_boundary(end)) {
        let report = prove_page_text(&text[..end]);
        assert!(!report.passed, "cut off at byte {end}: {:?}", &text[..end]);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn no_changed_byte_goes_unnoticed(at in 0.0..1.0_f64, byte in 0_u8..128) {
        let good = pages();
        let mut bytes = good.clone().into_bytes();
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "an index from a fraction")]
        let index = (at * bytes.len() as f64) as usize;
        bytes[index] = byte;
        let text = String::from_utf8(bytes).unwrap();
        let report = prove_page_text(&text);
        let same_path = report.moves == prove_page_text(&good).moves;
        prop_assert!(!report.passed || same_path || !compare_pages(&good, &text).is_empty());
        if compare_pages(&good, &text).is_empty() {
            prop_assert!(report.passed && same_path);
        }
    }

    #[test]
    fn no_garbage_panics(text in "[ -~\r\n\u{2}\u{4}äß∞]{0,200}", list in "([ 0-9]{0,3} ?(PTP|CIRC|THRD|DO|EDO|CALL|SUB|ESUB|PDAT|DWEL|INC|IN)[-+ .0-9CW]{0,40}\n){0,12}") {
        let _ = prove_page_text(&text);
        let paged = prove_page_text(&format!("PAGE 1 {text}\n{text}"));
        prop_assert!(!paged.passed);
        let _ = prove_page_text(&list);
        let _ = compare_pages(&text, &list);
    }

    #[test]
    fn huge_numbers_are_survived(x in -99_999.999..99_999.999_f64, z in -99_999.999..99_999.999_f64, radius in 0.0..99_999.999_f64) {
        let report = prove_work(&format!("CIRC {x:.3} {z:.3} {radius:.3} CW 80 1 1000\nPTP {x:.3} {z:.3} 80 1 1000\nTHRD {z:.3} 12 10 1 .1 3 400"));
        prop_assert!(report.times.total_s.is_finite() && report.largest_chip_mm2.is_finite());
    }
}
