//! Formats, units, loops, subroutines, structure and machine limits.

use super::*;

const START: &str = "INC\nMM\nPDAT 15 20\n";

fn prove_lines(text: &str) -> ProofReport {
    prove_texts(&[&lines(text)])
}

fn ends(report: &ProofReport) -> Vec<Point> {
    report.moves.iter().map(|m| m.path.end()).collect()
}

fn same_points(a: &[Point], b: &[Point]) -> bool {
    a.len() == b.len() && a.iter().zip(b).all(|(p, q)| p.distance(*q) < 1e-9)
}

#[test]
fn times_add_up_by_kind() {
    let report = prove_lines(&format!(
        "{START}PTP 0 -20 1000 1 1000\nPTP -2 0 80 1 1000\nDWEL 1.5\nPTP 2 0 1000 2 1000\nPTP 0 20 1000 2 1000\nEND"
    ));
    assert_eq!(report.findings, []);
    let t = report.times;
    assert!((t.feed_s - 1.5).abs() < 1e-9, "{t:?}");
    assert!((t.dwell_s - 1.5).abs() < 1e-9);
    assert!((t.tool_change_s - 4.0).abs() < 1e-9);
    let rapid = (25.0 + 20.0 + 2.0 + 20.0) / 1000.0 * 60.0;
    assert!((t.rapid_s - rapid).abs() < 1e-9);
    assert!((t.total_s - (t.feed_s + t.rapid_s + t.dwell_s + t.tool_change_s)).abs() < 1e-9);
    assert!((report.blocks.iter().map(|b| b.time_s).sum::<f64>() - t.total_s).abs() < 1e-9);
}

#[test]
fn increments_positions_and_inches_give_the_same_moves() {
    let inc = prove_lines(
        "INC\nMM\nPDAT 12.7 25.4\nPTP 0 -25.4 1016 1 1000\nCIRC -2.54 -2.54 2.54 CW 254 1 1000\nPTP 2.54 27.94 1016 1 1000\nEND",
    );
    let abs = prove_lines(
        "ABS\nMM\nPDAT 12.7 25.4\nPTP 12.7 0 1016 1 1000\nCIRC 10.16 -2.54 2.54 CW 254 1 1000\nPTP 12.7 25.4 1016 1 1000\nEND",
    );
    let inch =
        prove_lines("ABS\nIN\nPDAT .5 1\nPTP .5 0 40 1 1000\nCIRC .4 -.1 .1 CW 10 1 1000\nPTP .5 1 40 1 1000\nEND");
    assert_eq!((kinds(&inc), kinds(&abs), kinds(&inch)), (vec![], vec![], vec![]));
    assert!(same_points(&ends(&inc), &ends(&abs)) && same_points(&ends(&inc), &ends(&inch)));
    assert!((inc.times.total_s - inch.times.total_s).abs() < 1e-6);
}

#[test]
fn arcs_take_the_short_way_with_their_sense() {
    let center = |sense: &str| {
        let report = prove_lines(&format!("{START}CIRC -5 -5 5 {sense} 80 1 1000\nPTP 5 5 1000 1 1000\nEND"));
        report
            .moves
            .iter()
            .find_map(|m| if let Segment::Arc { center, ccw, .. } = m.path { Some((center, ccw)) } else { None })
    };
    // From (20, 15) to (15, 10), seen with z to the right and x upwards.
    let (c, ccw) = center("CCW").unwrap();
    assert!(ccw && c.distance(Point::new(20.0, 10.0)) < 1e-9);
    let (c, ccw) = center("CW").unwrap();
    assert!(!ccw && c.distance(Point::new(15.0, 15.0)) < 1e-9);
}

#[test]
fn loops_and_subroutines_unroll() {
    let looped = prove_lines(&format!("{START}DO 2\nDO 3\nPTP -1 0 80 1 1000\nEDO\nPTP 3 0 1000 1 1000\nEDO\nEND"));
    let unrolled = prove_lines(&format!(
        "{START}{0}{0}END",
        "PTP -1 0 80 1 1000\nPTP -1 0 80 1 1000\nPTP -1 0 80 1 1000\nPTP 3 0 1000 1 1000\n"
    ));
    assert_eq!((kinds(&looped), kinds(&unrolled)), (vec![], vec![]));
    assert!(same_points(&ends(&looped), &ends(&unrolled)));
    assert_eq!(looped.blocks[5].runs, 6);

    // Called before and after its text; reached in sequence it is passed over; one subroutine calls another.
    let called = prove_lines(&format!(
        "{START}CALL 1\nSUB 1\nPTP -1 0 80 1 1000\nCALL 2\nESUB\nSUB 2\nPTP 1 0 1000 1 1000\nESUB\nDO 2\nCALL 1\nEDO\nEND"
    ));
    assert_eq!(kinds(&called), vec![]);
    assert_eq!(called.moves.len(), 1 + 6);
    let behind = prove_lines(&format!("{START}CALL 1\nEND\nSUB 1\nPTP 0 0 80 1 1000\nESUB"));
    assert_eq!(kinds(&behind), vec![]);
}

#[test]
fn endless_and_impossible_control_flow_is_reported() {
    use FindingKind::{Control, Structure};
    let cases = [
        ("DO 99999\nDO 99999\nEDO\nEDO\nEND", Control, 6),
        ("CALL 1\nEND\nSUB 1\nCALL 1\nESUB", Control, 7),
        ("CALL 7\nEND", Control, 4),
        ("DO 0\nEDO\nEND", Control, 4),
        ("DO 2\nEND", Structure, 4),
        ("EDO\nEND", Structure, 4),
        ("END\nSUB 1", Structure, 5),
        ("ESUB\nEND", Structure, 4),
        ("DO 2\nSUB 1\nEDO\nESUB\nEND", Structure, 4),
        ("SUB 1\nESUB\nSUB 1\nESUB\nEND", Structure, 6),
        ("END\nMM", Structure, 4),
    ];
    for (text, kind, block) in cases {
        let report = prove_lines(&format!("{START}{text}"));
        assert!(!report.passed, "{text}");
        assert!(kinds(&report).contains(&(kind, block)), "{text}: {:?}", report.findings);
    }
    let deep: Vec<String> = (1..=20).map(|n| format!("SUB {n}\nCALL {}\nESUB\n", n + 1)).collect();
    let deep = deep.concat();
    let report = prove_lines(&format!("{START}CALL 1\nEND\n{deep}SUB 21\nESUB"));
    assert!(report.findings.iter().any(|f| f.kind == Control && f.message.contains("deep")));
}

#[test]
fn structure_of_pages_is_checked() {
    let page = |n: usize, body: &str| format!("PAGE {n:02} {body}\n");
    let (mm, end) = ("MM-UNITS", "END-PROGRAM..M02");
    let good = prove_texts(&[&(page(1, mm) + &page(2, end))]);
    assert_eq!(good.findings, []);
    for (text, block) in [
        (page(1, mm), 1),
        (page(1, mm) + &page(3, end), 2),
        (page(1, mm) + &page(1, mm) + &page(2, end), 2),
        (String::new(), 1),
        ((1..=99).map(|n| page(n, mm)).collect::<Vec<_>>().concat() + &page(100, end), 100),
    ] {
        let report = prove_texts(&[&text]);
        assert!(kinds(&report).contains(&(FindingKind::Structure, block)), "{:?}", report.findings);
        assert!(!report.passed);
    }
}

#[test]
fn machine_limits_are_checked() {
    use FindingKind::{OutsideLimits, OverTravel};
    let cases = [
        ("PTP 0 -10 1300 1 1000", OutsideLimits, "1200"),
        ("PTP 0 -10 0 1 1000", OutsideLimits, "would not move"),
        ("PTP 0 -10 20 1 1000", OutsideLimits, "lowest"),
        ("PTP 0 -10 80 1 2001", OutsideLimits, "2000 rev/min"),
        ("PTP 0 -10 80 9 1000", OutsideLimits, "turret"),
        ("PTP -.5 -10 80 1 1000", OutsideLimits, "20.0 to 1"),
        ("CIRC -1 -1 1.5 CW 80 1 1000", OutsideLimits, "2 to 3000"),
        ("CIRC -5 -5 3 CW 80 1 1000", OutsideLimits, "joins"),
        ("CIRC 0 0 3 CW 80 1 1000", OutsideLimits, "joins"),
        ("PTP 0 -351 80 1 1000", OverTravel, "350"),
        ("PTP 96 0 80 1 1000", OverTravel, "95"),
        ("PTP -16.1 0 80 1 1000", OverTravel, "past the axis"),
        ("THRD -10 12 10 4 .1 3 100", OutsideLimits, "3.50"),
        ("THRD -10 12 10 1.75 .1 3 1000", OutsideLimits, "1750"),
        ("THRD -10 12 10 1.75 .1 3 0", OutsideLimits, "at rest"),
        ("THRD -10 12 10 1.75 0 3 100", OutsideLimits, "above 0"),
        ("THRD -10 12 13 1.75 .1 3 100", OutsideLimits, "below its outside"),
    ];
    for (text, kind, word) in cases {
        let report = prove_lines(&format!("{START}{text}\nEND"));
        let found = report.findings.iter().find(|f| f.kind == kind && f.block == 4);
        assert!(found.is_some_and(|f| f.message.contains(word)), "{text}: {:?}", report.findings);
    }
    for text in
        ["PTP -.51 -10 80 1 1000", "PTP -15.9 0 80 1 2000", "CIRC -2 -2 2 CW 1200 1 0", "PTP 0 -350 1200 1 1000"]
    {
        let report = prove_lines(&format!("{START}{text}\nEND"));
        assert!(
            kinds(&report).iter().all(|(kind, _)| *kind == FindingKind::NotClosed),
            "{text}: {:?}",
            report.findings
        );
    }
}

#[test]
fn a_program_that_misses_its_datum_says_by_how_much() {
    let open = format!("{START}PTP -5 -12.25 1000 1 1000\nPTP 5 12 1000 1 1000\nEND");
    let report = prove_lines(&open);
    assert_eq!(kinds(&report), [(FindingKind::NotClosed, 6)]);
    assert!(report.passed && report.findings[0].message.contains("-0.250 mm in z"));
    let next = lines("INC\nMM\nPTP 0 1 80 1 1000\nPTP 0 -1 80 1 1000\nEND");
    let report = prove_texts(&[&lines(&open), &next]);
    assert!(!report.passed);
    assert!(kinds(&report).contains(&(FindingKind::NotClosed, 6)));
}

#[test]
fn moving_without_datum_format_or_units_is_reported() {
    let report = prove_lines("PTP 0 -1 80 1 1000\nEND");
    assert!(!report.passed);
    assert_eq!(report.findings.iter().filter(|f| f.kind == FindingKind::Structure).count(), 3);
}

#[test]
fn a_thread_takes_the_time_of_its_passes() {
    let report = prove_lines(&format!("{START}THRD -10 12 10 1.75 .25 3 400\nEND"));
    assert_eq!(report.findings, []);
    assert_eq!(report.moves.iter().filter(|m| m.motion == Motion::Thread).count(), 4);
    assert!((report.times.feed_s - 4.0 * 10.0 / 700.0 * 60.0).abs() < 1e-9);
    assert!(report.moves.last().unwrap().path.end().distance(Point::new(20.0, 15.0)) < 1e-9);
}

#[test]
fn cancelling_stops() {
    let cancel = crate::cancel::Cancel::default();
    cancel.cancel();
    assert!(prove(&input_of(&["1 MM"]), &cancel).is_err());
}

#[test]
fn the_file_of_a_proof_says_its_verdict_first() {
    let input = input_of(&[&lines(&format!("{START}CIRC -5 -5 5 CW 80 1 1000\nPTP 5 5 1000 1 1000\nEND"))]);
    let report = prove_input(&input);
    let text = proof_json(&input, &report);
    assert!(text.starts_with("{\n  \"verdict\": \"passed\""), "{text}");
    let file: serde_json::Value = serde_json::from_str(&text).unwrap();
    assert_eq!(file["blocks"].as_array().map(Vec::len), Some(6));
    let path: serde_json::Value = serde_json::from_str(&path_json(&input, &report)).unwrap();
    assert_eq!(path.as_array().map(Vec::len), Some(report.moves.len()));
    assert_eq!((&path[1]["to"]["x"], &path[1]["to"]["z"]), (&10.0.into(), &15.0.into()));
    assert_eq!((&path[1]["center"]["x"], &path[1]["ccw"]), (&15.0.into(), &false.into()));
    let failed = prove_texts(&["1 JMP"]);
    assert!(proof_json(&input, &failed).starts_with("{\n  \"verdict\": \"failed\""));
}
