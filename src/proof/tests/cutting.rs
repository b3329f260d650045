//! Stock removal and what must not touch: each finding with a program that has it and one that has not.

use super::*;
use FindingKind::{
    ChuckCollision, FlankCollision, Gouge, HolderCollision, OutsideLimits, RapidContact, TailstockCollision,
};

/// Turns the whole test part with the sharp right-hand tool.
const GOOD: &str = "PTP 12 1 1000 1 1000\nPTP 9 1 1000 1 1000\nPTP 9 -30 80 1 1000\nPTP 9.5 -29 1000 1 1000\nPTP 9.5 1 1000 1 1000\n\
    PTP 8 1 1000 1 1000\nPTP 8 -30 80 1 1000\nPTP 9.5 -29 1000 1 1000\nPTP 9.5 1 1000 1 1000\n\
    PTP 6 1 1000 1 1000\nPTP 6 -10 80 1 1000\nPTP 12 -10 1000 1 1000";

#[test]
fn a_good_program_leaves_the_part_and_nothing_to_say() {
    let report = prove_work(GOOD);
    assert_eq!(report.findings, []);
    assert!(report.passed && report.deepest_gouge_mm < 1e-4);
    let cut = area(&report.stock.first().unwrap()) - area(&report.stock.last().unwrap());
    assert!((cut - (2.0 * 30.0 + 2.0 * 10.0)).abs() < 1e-3, "{cut}");
    assert!((report.blocks.iter().map(|b| b.removed_mm2).sum::<f64>() - cut).abs() < 1e-3);
    assert_eq!(report.stock.len(), 1 + 3);
    assert_eq!(report.moves.last().unwrap().stock_after, 3);
    // 1 mm deep over 30 of 31 mm at 0.08 mm a turn.
    assert!((report.blocks[HEAD + 2].chip_mm2 - 30.0 / 31.0 * 0.08).abs() < 1e-5);
    assert!(report.leftover.iter().all(|l| l.largest_mm < 1e-4), "{:?}", report.leftover);
    assert_eq!(report.leftover.iter().map(|l| l.section).collect::<Vec<_>>(), [1, 2]);
}

#[test]
fn nothing_done_leaves_everything() {
    let report = prove_work("DWEL 1");
    assert!(report.passed);
    let left: Vec<f64> = report.leftover.iter().map(|l| l.largest_mm).collect();
    assert!((left[0] - 2.0).abs() < 1e-6 && (left[1] - 4.0).abs() < 0.2, "{left:?}");
    assert!((report.leftover[0].mean_mm - 2.0).abs() < 1e-6);
    assert_eq!(report.findings.iter().filter(|f| f.kind == FindingKind::Leftover).count(), 2);
}

#[test]
fn rapid_through_stock_is_found_and_touching_is_not() {
    let report = prove_work("PTP 9 1 1000 1 1000\nPTP 9 -5 1000 1 1000\nPTP 12 -5 80 1 1000");
    assert_eq!(faults(&report), [(RapidContact, HEAD + 2)]);
    let finding = &report.findings[0];
    assert!((finding.value - 5.0).abs() < 1e-3 && !report.passed, "{finding:?}");
    let along = prove_work("PTP 10 1 1000 1 1000\nPTP 10 -30 1000 1 1000\nPTP 12 -30 1000 1 1000");
    assert_eq!(faults(&along), []);
    // There and back over an oblique cut, in parts: only rounding is left to find.
    let back = prove_work(
        "PTP 8.1 .333 1000 1 1000\nPTP 8.777 -3.1 80 1 1000\nPTP 9.111 -8.339 80 1 1000\nPTP 8.777 -3.1 1000 1 1000\nPTP 8.1 .333 1000 1 1000",
    );
    assert_eq!(faults(&back), []);
}

#[test]
fn even_a_thin_trace_wiped_off_at_rapid_is_an_error() {
    let report = prove_work("PTP 9.98 1 1000 1 1000\nPTP 9.98 -3 1000 1 1000\nPTP 12 -3 1000 1 1000");
    assert_eq!((faults(&report), report.passed), (vec![(RapidContact, HEAD + 2)], false));
}

#[test]
fn a_gouge_is_measured_and_a_slight_one_is_a_note() {
    let deep = GOOD.replace("PTP 8 -30 80", "PTP 8 -12.5 80 1 1000\nPTP 7.7 -12.5 80 1 1000\nPTP 7.7 -30 80");
    let report = prove_work(&deep);
    let gouges: Vec<_> = report.findings.iter().filter(|f| f.kind == Gouge).collect();
    assert!(!report.passed && gouges[0].block == HEAD + 8, "{gouges:?}");
    assert!((gouges[0].value - 0.3).abs() < 1e-4 && (report.deepest_gouge_mm - 0.3).abs() < 1e-4);
    let slight =
        prove_work(&GOOD.replace("PTP 8 1 1000 1 1000\nPTP 8 -30 80", "PTP 7.98 1 1000 1 1000\nPTP 7.98 -30 80"));
    assert_eq!(kinds(&slight), [(Gouge, HEAD + 7)]);
    assert!(slight.passed && (slight.findings[0].value - 0.02).abs() < 1e-4);
    let allowed = Work { may_cut: vec![MayCut { z1: 0.0, z2: 20.0, radius: 7.7 }], ..work() };
    let report = prove_input(&with_work(&[&absolute(&deep)], allowed));
    assert_eq!(faults(&report), []);
}

#[test]
fn the_published_trick_one_changed_z_is_found_with_its_depth() {
    let report = prove_work(&GOOD.replace("PTP 6 -10 80", "PTP 6 -11.5 80"));
    let gouge = report.findings.iter().find(|f| f.kind == Gouge).unwrap();
    assert_eq!(gouge.block, HEAD + 11);
    assert!((gouge.value - 1.5).abs() < 1e-3 && !report.passed, "{gouge:?}");
}

#[test]
fn stock_through_an_edge_that_cannot_cut_is_a_flank_collision() {
    // The right-hand tool backs out of a groove of its own into the stock behind it, higher than its trailing edge reaches.
    let thick = Work { stock: polygon(&[(-40.0, 0.0), (LENGTH, 0.0), (LENGTH, 19.0), (-40.0, 19.0)]), ..work() };
    let mut thick_input = with_work(
        &[&lines(
            "ABS\nMM\nPDAT 22 20\nPTP 22 -20 1000 1 1000\nPTP 12 -20 80 1 1000\nPTP 12 -15 80 1 1000\nPTP 22 20 1000 1 1000\nEND",
        )],
        thick,
    );
    let report = prove_input(&thick_input);
    assert!(faults(&report).contains(&(FlankCollision, 6)), "{:?}", report.findings);
    // A shallow cut with the trailing edge is none.
    thick_input.programs = std::sync::Arc::new(vec![ProgramText {
        name: "A".into(),
        text: lines(
            "ABS\nMM\nPDAT 22 20\nPTP 22 -20 1000 1 1000\nPTP 18.5 -20 80 1 1000\nPTP 18.5 -15 80 1 1000\nPTP 22 -15 80 1 1000\nPTP 22 20 1000 1 1000\nEND",
        ),
        edited: false,
    }]);
    assert_eq!(faults(&prove_input(&thick_input)), []);
}

#[test]
fn the_holder_must_clear_the_stock() {
    let report =
        prove_work("PTP 12 -15 1000 4 1000\nPTP -1 -15 30 4 1000\nPTP 12 -15 1000 4 1000\nPTP 12 20 1000 4 1000");
    assert!(!faults(&report).iter().any(|(kind, _)| *kind == HolderCollision), "{:?}", report.findings);
    let thick = Work { stock: polygon(&[(-40.0, 0.0), (LENGTH, 0.0), (LENGTH, 23.0), (-40.0, 23.0)]), ..work() };
    let text = lines(
        "ABS\nMM\nPDAT 25 20\nPTP 25 -15 1000 4 1000\nPTP 2.5 -15 30 4 1000\nPTP 25 -15 1000 4 1000\nPTP 25 20 1000 4 1000\nEND",
    );
    let report = prove_input(&with_work(&[&text], thick));
    assert!(faults(&report).contains(&(HolderCollision, 5)), "{:?}", report.findings);
}

#[test]
fn the_holder_that_runs_ahead_of_the_edge_is_found() {
    // The left-hand tool moves towards the chuck: its holder is in front of its edge.
    let thick = Work { stock: polygon(&[(-40.0, 0.0), (LENGTH, 0.0), (LENGTH, 19.0), (-40.0, 19.0)]), ..work() };
    let text = lines(
        "ABS\nMM\nPDAT 22 20\nPTP 10 13 1000 2 1000\nPTP 10 -5 80 2 1000\nPTP 22 -5 80 2 1000\nPTP 22 20 1000 2 1000\nEND",
    );
    let report = prove_input(&with_work(&[&text], thick));
    assert!(faults(&report).contains(&(HolderCollision, 5)), "{:?}", report.findings);
}

#[test]
fn the_chuck_must_stay_clear() {
    let report = prove_work("PTP 12 -41 1000 1 1000\nPTP 12 1 1000 1 1000");
    assert!(faults(&report).contains(&(ChuckCollision, HEAD + 1)), "{:?}", report.findings);
    let clear = prove_work("PTP 12 -40 1000 1 1000\nPTP 12 1 1000 1 1000");
    assert_eq!(faults(&clear), []);
}

#[test]
fn cutting_with_the_spindle_at_rest_is_an_error() {
    let report = prove_work("PTP 9 1 1000 1 0\nPTP 9 -5 80 1 0\nPTP 12 -5 1000 1 0");
    assert_eq!(faults(&report), [(OutsideLimits, HEAD + 2)]);
}

#[test]
fn a_tool_that_turns_into_the_stock_is_found() {
    let report = prove_work("PTP 9 1 1000 1 1000\nPTP 9 -5 80 1 1000\nPTP 12 -5 1000 2 1000");
    assert!(faults(&report).contains(&(RapidContact, HEAD + 3)), "{:?}", report.findings);
    // The next move at cutting feed does not hide it.
    let report = prove_work("PTP 9 1 1000 1 1000\nPTP 9 -5 80 1 1000\nPTP 12 -5 80 2 1000");
    assert!(faults(&report).contains(&(RapidContact, HEAD + 3)), "{:?}", report.findings);
}

#[test]
fn a_thread_cuts_its_grooves_down_to_the_base() {
    let body = format!("{GOOD}\nPTP 12 3 1000 3 1000\nTHRD -6 12 10.5 1.5 .25 3 400\nPTP 12 20 1000 3 1000");
    let may = Work { may_cut: vec![MayCut { z1: 23.0, z2: 30.0, radius: 5.25 }], ..work() };
    let report = prove_input(&with_work(&[&absolute(&body)], may));
    assert_eq!(faults(&report), []);
    let before = report.stock.get(report.stock.len() - 2).unwrap();
    let cut = area(&before) - area(&report.stock.last().unwrap());
    // Grooves of 60° at z 1.5 apart, 0.75 deep: 0.75² tan 30° each, 4 whole ones inside and one half at the end face.
    let groove = 0.75_f64.powi(2) * 30.0_f64.to_radians().tan();
    assert!((cut - 4.5 * groove).abs() < 0.01, "{cut} {}", 4.5 * groove);
    assert!(
        (report.stock.last().unwrap().rings[0]
            .iter()
            .filter(|p| p.z > 23.0 && p.r > 1.0)
            .map(|p| p.r)
            .fold(9.0, f64::min)
            - 5.25)
            .abs()
            < 1e-4
    );
    let forbidden = prove_input(&with_work(&[&absolute(&body)], work()));
    assert!(faults(&forbidden).iter().any(|(kind, _)| *kind == Gouge));
}

#[test]
fn an_arc_cut_leaves_the_arc() {
    // A quarter of radius 6 turned on the end with an arc move of the sharp tool.
    let p = Point::new;
    let contour = Contour::new(vec![
        Segment::line(p(0.0, 10.0), p(24.0, 10.0)),
        Segment::line(p(24.0, 10.0), p(24.0, 6.0)),
        Segment::Arc { start: p(24.0, 6.0), end: p(30.0, 0.0), center: p(24.0, 0.0), ccw: false },
    ]);
    let target = Target {
        contour,
        sections: vec![1, 1, 2],
        names: std::collections::BTreeMap::new(),
        machined_from_z: 0.0,
        bore: None,
    };
    let body = "PTP 0 1 1000 1 1000\nPTP 0 0 80 1 1000\nCIRC 6 -6 6 CCW 80 1 1000\nPTP 12 -6 80 1 1000";
    let report = prove_input(&with_work(&[&absolute(body)], Work { target, ..work() }));
    let left = &report.leftover[1];
    // The trailing edge lies 38.7° above the axis, so the arc is cut exactly only where it is steeper.
    assert!(report.deepest_gouge_mm < 0.001, "{:?}", report.findings);
    assert!(left.largest_mm < 0.001, "{left:?}");
}

#[test]
fn mandrel_and_tailstock_must_stay_clear() {
    let mandrel = Some(polygon(&[(-10.0, 0.0), (-2.0, 0.0), (-2.0, 14.0), (-10.0, 14.0)]));
    let tailstock = Some(polygon(&[(LENGTH, 0.0), (LENGTH + 10.0, 0.0), (LENGTH + 10.0, 5.0), (LENGTH, 1.0)]));
    let between = Work { mandrel, tailstock, ..work() };
    let prove_between = |body: &str| prove_input(&with_work(&[&absolute(body)], between.clone()));
    let message = |report: &ProofReport| {
        report
            .findings
            .iter()
            .find(|f| matches!(f.kind, ChuckCollision | TailstockCollision))
            .map(|f| f.message.clone())
    };
    let at_mandrel = prove_between("PTP 12 -35 80 1 1000\nPTP 12 20 1000 1 1000");
    assert!(message(&at_mandrel).is_some_and(|m| m.contains("mandrel")), "{:?}", at_mandrel.findings);
    let at_tailstock = prove_between("PTP 4 20 1000 1 1000\nPTP 4 5 1000 1 1000\nPTP 12 5 1000 1 1000");
    assert!(message(&at_tailstock).is_some_and(|m| m.contains("tailstock")), "{:?}", at_tailstock.findings);
    assert_eq!(faults(&prove_between(GOOD)), []);
}

/// A boring bar that cuts with its upper left corner, far from its shank.
fn boring_bar() -> crate::machine::ToolOutline {
    crate::machine::ToolOutline {
        insert: polygon(&[(0.0, 0.0), (0.0, -1.0), (2.0, -1.0), (1.0, 0.0)]),
        holder: polygon(&[(1.0, -3.0), (40.0, -3.0), (40.0, -0.5), (1.0, -0.5)]),
        kind: crate::machine::ToolKind::Boring,
        cutting: vec![true, false, true, true],
        ..Default::default()
    }
}

#[test]
fn a_bore_is_cut_gouged_and_measured() {
    let p = Point::new;
    // A tube with a hole of radius 4 that is to become 5 over the first 12 mm.
    let bore = Contour::new(vec![
        Segment::line(p(0.0, 4.0), p(18.0, 4.0)),
        Segment::line(p(18.0, 4.0), p(18.0, 5.0)),
        Segment::line(p(18.0, 5.0), p(LENGTH, 5.0)),
    ]);
    let target = Target {
        bore: Some(BoreTarget { contour: bore, sections: vec![0, 9, 9], machined_from_z: 0.0, may_cut: Vec::new() }),
        ..work().target
    };
    let tube = Work { stock: polygon(&[(-40.0, 4.0), (LENGTH, 4.0), (LENGTH, 10.0), (-40.0, 10.0)]), target, ..work() };
    let prove_bore = |body: &str| {
        let mut input = with_work(&[&absolute(body)], tube.clone());
        input.tools = std::sync::Arc::new(std::collections::BTreeMap::from([(1, boring_bar())]));
        prove_input(&input)
    };
    let left = |report: &ProofReport| report.leftover.iter().find(|l| l.section == 9).map(|l| l.largest_mm);
    let good = prove_bore("PTP 5 20 1000 1 1000\nPTP 5 -12 80 1 1000\nPTP 3.5 -12 80 1 1000\nPTP 3.5 20 1000 1 1000");
    assert_eq!(faults(&good), []);
    assert!(left(&good).is_some_and(|mm| mm < 1e-4), "{:?}", good.leftover);
    let shy =
        prove_bore("PTP 4.8 20 1000 1 1000\nPTP 4.8 -12 80 1 1000\nPTP 3.5 -12 80 1 1000\nPTP 3.5 20 1000 1 1000");
    assert!(left(&shy).is_some_and(|mm| (mm - 0.2).abs() < 0.01), "{:?}", shy.leftover);
    let deep =
        prove_bore("PTP 5.3 20 1000 1 1000\nPTP 5.3 -12 80 1 1000\nPTP 3.5 -12 80 1 1000\nPTP 3.5 20 1000 1 1000");
    assert!(
        faults(&deep).contains(&(Gouge, HEAD + 2)) && (deep.deepest_gouge_mm - 0.3).abs() < 1e-3,
        "{:?}",
        deep.findings
    );
    let rapid = prove_bore(
        "PTP 3.5 20 1000 1 1000\nPTP 3.5 -12 1000 1 1000\nPTP 4.5 -12 1000 1 1000\nPTP 3.5 -12 1000 1 1000\nPTP 3.5 20 1000 1 1000",
    );
    assert_eq!(faults(&rapid), [(RapidContact, HEAD + 3)]);
}
