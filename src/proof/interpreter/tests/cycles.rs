use super::*;

const HEAD: &str = "O1\nG21 G99 T0101\nG97 S1000 M03\nG0 X104. Z2.\n";

fn path(body: &str) -> Vec<Spelled> {
    let moves = good("fanuc-0i", &format!("{HEAD}{body}\nM30")).spelled();
    moves[1..].to_vec()
}

#[test]
fn single_cuts_repeat_with_new_depths() {
    assert_eq!(
        path("G90 X90. Z-30. F.2\nX80."),
        [
            ('r', 2.0, 45.0),
            ('l', -30.0, 45.0),
            ('l', -30.0, 52.0),
            ('r', 2.0, 52.0),
            ('r', 2.0, 40.0),
            ('l', -30.0, 40.0),
            ('l', -30.0, 52.0),
            ('r', 2.0, 52.0)
        ]
    );
    assert_eq!(path("G94 X10. Z-3. F.2"), [('r', -3.0, 52.0), ('l', -3.0, 5.0), ('l', 2.0, 5.0), ('r', 2.0, 52.0)]);
    assert_eq!(
        path("G92 X90. Z-30. F2."),
        [('r', 2.0, 45.0), ('t', -30.0, 45.0), ('r', -30.0, 52.0), ('r', 2.0, 52.0)]
    );
}

#[test]
fn roughing_stops_at_the_contour_with_its_allowance() {
    let moves = path(
        "G71 U5. R1.\nG71 P100 Q130 U1. W.5 F.3\nN100 G0 X80.\nN110 G1 Z-20. F.1\nN120 X90.\nN130 X104. Z-30.\nG0 X120.",
    );
    let cuts: Vec<_> = moves.windows(2).filter(|w| w[1].0 == 'l' && w[0].0 == 'r').map(|w| (w[1].1, w[1].2)).collect();
    // Depths 47 and 42 end at the contour displaced by 0.5 in radius and along z; then the last cut along it at 40.5.
    assert_eq!(cuts[0].1, 47.0);
    assert!((cuts[0].0 - (-20.0 + 0.5 - (47.0 - 45.5) / 7.0 * 10.0)).abs() < 1e-3, "{cuts:?}");
    assert_eq!(cuts[1], (-19.5, 42.0));
    assert_eq!(moves.last(), Some(&('r', 2.0, 60.0)));
    let finish = path(
        "G71 U5. R1.\nG71 P100 Q130 U1. W.5 F.3\nN100 G0 X80.\nN110 G1 Z-20. F.1\nN120 X90.\nN130 X104. Z-30.\nG70 P100 Q130",
    );
    let tail = &finish[finish.len() - 5..];
    assert_eq!(tail, [('r', 2.0, 40.0), ('l', -20.0, 40.0), ('l', -20.0, 45.0), ('l', -30.0, 52.0), ('r', 2.0, 52.0)]);
}

#[test]
fn facing_runs_across_the_axis() {
    let moves = path("G72 W1. R.5\nG72 P10 Q20 U0. W0. F.2\nN10 G0 Z-3.\nN20 G1 X20.\nG0 X110.");
    let cuts: Vec<_> = moves.iter().filter(|m| m.0 == 'l').collect();
    assert!(cuts.iter().all(|c| c.2 == 10.0 || c.1 == -3.0), "{cuts:?}");
    assert_eq!(cuts.last().unwrap().1, -3.0);
}

#[test]
fn a_pattern_comes_nearer() {
    let moves = path("G73 U4. W1. R3\nG73 P10 Q20 U0. W0. F.2\nN10 G0 X80. Z0.\nN20 G1 Z-20.\nG0 X110.");
    let cuts: Vec<_> = moves.iter().filter(|m| m.0 == 'l').map(|m| (m.1, m.2)).collect();
    assert_eq!(cuts, [(-19.0, 44.0), (-19.5, 42.0), (-20.0, 40.0)]);
}

#[test]
fn pecks_go_deeper_and_step_aside() {
    let moves = path("G0 X0. Z2.\nG74 R1.\nG74 Z-8. Q4000 F.1");
    let depths: Vec<_> = moves.iter().filter(|m| m.0 == 'l').map(|m| m.1).collect();
    assert_eq!(depths, [-2.0, -6.0, -8.0]);
    let moves = path("G0 X104. Z-10.\nG75 R.5\nG75 X80. Z-16. P6000 Q3000 F.1");
    let cuts: Vec<_> = moves.iter().filter(|m| m.0 == 'l').map(|m| (m.1, m.2)).collect();
    assert_eq!(cuts, [(-10.0, 46.0), (-10.0, 40.0), (-13.0, 46.0), (-13.0, 40.0), (-16.0, 46.0), (-16.0, 40.0)]);
}

#[test]
fn a_thread_is_cut_in_equal_areas() {
    let moves = path("G0 X24. Z5.\nG76 P020060 Q50 R50\nG76 X17.4 Z-20. P1300 Q650 F2.");
    let passes: Vec<_> = moves.iter().filter(|m| m.0 == 't').map(|m| m.2).collect();
    assert_eq!(passes.first(), Some(&(8.7 + 1.3 - 0.65)));
    assert_eq!(passes[passes.len() - 2..], [8.7, 8.7]);
    assert!(passes.is_sorted_by(|a, b| a >= b));
    // The 6T's single line.
    let one = good(
        "mori-fanuc-6t",
        "O201\nG21\nG50X-455.000Z320.000\nT0202M41\nG97S200M03\nG0X-24.000Z5.000\nG76X-17.400Z-20.000K1.300D650F2.000A60\nM30",
    );
    let one: Vec<_> = one.spelled().iter().filter(|m| m.0 == 't').map(|m| m.2).collect();
    assert_eq!((one.first(), one.last()), (passes.first(), Some(&8.7)));
}
