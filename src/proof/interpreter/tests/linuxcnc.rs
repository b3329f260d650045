use super::*;
use crate::proof::step::{Feed, Speed};

const HEAD: &str = "G21 G18 G7 G90 G95 G54\nT1 M6 G43\nG97 S1000 M3\n";

fn path(body: &str) -> Vec<Spelled> {
    good("linuxcnc", &format!("{HEAD}{body}\nM2")).spelled()
}

#[test]
fn g90_and_g91_are_distance_modes() {
    let moves = path("G0 X100 Z5\nG91 G1 X10 Z-5 F0.2\nG90 X100\nG8 G1 X45\nG7");
    assert_eq!(moves, [('r', 5.0, 50.0), ('l', 0.0, 55.0), ('l', 0.0, 50.0), ('l', 0.0, 45.0)]);
}

#[test]
fn feed_words_and_speed_limit() {
    let path = good("linuxcnc", &format!("{HEAD}G96 D2500 S200\nG1 X50 Z0 F0.2\nG94 G1 X40 F120\nM2"));
    let drives = path.drives();
    assert_eq!((drives[0].feed, drives[1].feed), (Feed::PerRev(0.2), Feed::PerMinute(120.0)));
    assert_eq!(drives[0].speed.rpm_at(1.0), 2500.0);
    assert!(matches!(drives[1].speed, Speed::Surface { .. }));
}

#[test]
fn o_words_are_called() {
    let moves = path("G0 X50 Z0\no100 sub\nG91 G0 Z-1\no100 endsub\no100 call\no100 call");
    assert_eq!(moves.iter().map(|m| m.1).collect::<Vec<_>>(), [0.0, -1.0, -2.0]);
}

#[test]
fn the_thread_cycle_cuts_as_the_manual_says() {
    // Drive line at radius 12, crest 2 below it, 0.5 deep in cuts of 0.2 without degression, one spring pass.
    let moves = path("G0 X24 Z5\nG76 P1.5 Z-20 I-4 J0.4 K1 H1");
    let passes: Vec<_> = moves.iter().filter(|m| m.0 == 't').map(|m| m.2).collect();
    assert_eq!(passes, [9.8, 9.6, 9.5, 9.5]);
    assert_eq!(moves.last(), Some(&('r', 5.0, 12.0)));
}

#[test]
fn a_pass_needs_its_lead() {
    assert_eq!(path("G0 X20 Z5\nG33 Z-10 K1.5"), [('r', 5.0, 10.0), ('t', -10.0, 10.0)]);
    let said = said("linuxcnc", &format!("{HEAD}G0 X20 Z5\nG33 Z-10\nM2"));
    assert!(said.iter().any(|m| m.contains("lead")), "{said:?}");
}

#[test]
fn coordinates_set_by_g92_shift_the_path() {
    let (path, findings) = run_on(&machine("linuxcnc"), &format!("{HEAD}G0 X20 Z5\nG92 Z0\nG0 Z-5\nG92.1\nG0 Z0\nM2"));
    assert_eq!(path.spelled().iter().map(|m| m.1).collect::<Vec<_>>(), [5.0, 0.0, 0.0_f64][..2].to_vec());
    assert!(findings.iter().any(|f| f.message.contains("mm away")), "{findings:?}");
}

#[test]
fn what_is_missing_is_said() {
    for (text, what) in [
        ("G21 G7 T1 M6\nG97 S1000 M3 G95\nG1 X10 Z0 F.1\nM2", "without its offset"),
        ("G21 T1 M6 G43\nG97 S1000 M3 G95\nG1 X10 Z0 F.1\nM2", "G7 or G8"),
        ("G7 T1 M6 G43\nG97 S1000 M3 G95\nG1 X10 Z0 F.1\nM2", "G20 or G21"),
        ("G21 G7 M6\nM2", "no T word"),
        ("G21 G7\nG0 U5\nM2", "U5 has no meaning"),
        ("G21 G7\no5 call\nM2", "does not contain"),
    ] {
        let said = said("linuxcnc", text);
        assert!(said.iter().any(|m| m.contains(what)), "{text}: {said:?}");
    }
}

#[test]
fn a_nose_of_the_block_s_own_diameter_runs_beside_the_contour() {
    // A cylinder of radius 10, turned and bored: the nose's centre ends square to the ends, the point is 0.8 beside it.
    for words in ["G42.1 D1.6 L2", "G41.1 D1.6 L3"] {
        let moves = path(&format!("G0 X20 Z5\n{words} G1 X20 Z2 F0.2\nZ-10\nG40 G0 Z5"));
        assert_eq!(moves[1..3], [('l', 1.2, 10.0), ('l', -10.8, 10.0)], "{words}");
    }
    let said = said("linuxcnc", &format!("{HEAD}G0 X20 Z5\nG42.1 D1.6 L12 G1 X20 Z2 F0.2\nG40 M2"));
    assert!(said.iter().any(|m| m.contains("orientation")), "{said:?}");
}
