use super::*;
use crate::geometry::Segment;
use crate::proof::step::{Feed, Speed};

/// Head of a test program on the machine of today: the tool rests at z 300, diameter 380.
const HEAD: &str = "O1\nG21 G99 T0101\nG97 S1000 M03\n";

fn path(body: &str) -> Vec<Spelled> {
    good("fanuc-0i", &format!("{HEAD}{body}\nM30")).spelled()
}

#[test]
fn words_stay_in_force_and_displacements_add_up() {
    let moves = path("G0 X100. Z5.\nG1 Z-20. F.2\nU10. W-5.\nX120.\nG0 W25.");
    assert_eq!(moves, [('r', 5.0, 50.0), ('l', -20.0, 50.0), ('l', -25.0, 55.0), ('l', -25.0, 60.0), ('r', 0.0, 60.0)]);
}

#[test]
fn arcs_have_their_sense_and_centre() {
    let paths = good(
        "fanuc-0i",
        &format!("{HEAD}G0 X20. Z0.\nG1 F.1\nG3 X30. Z-5. I0. K-5.\nG2 X40. Z-10. R5.\nG3 U10. W-5. R5.\nM30"),
    )
    .paths();
    let arcs: Vec<_> = paths
        .iter()
        .filter_map(|p| if let Segment::Arc { center, ccw, .. } = p { Some((*center, *ccw)) } else { None })
        .collect();
    for ((center, ccw), (z, r, sense)) in
        arcs.iter().zip([(-5.0, 10.0, true), (-5.0, 20.0, false), (-15.0, 20.0, true)])
    {
        assert!(center.distance(Point::new(z, r)) < 1e-9, "{center:?} {z} {r}");
        assert_eq!(*ccw, sense);
    }
    assert_eq!(arcs.len(), 3);
}

#[test]
fn x_is_negative_and_arcs_turned_over_on_the_6t() {
    // N130 to N140 of the published listing.
    let text = "O201\nG21\nG50X-455.000Z320.000M08\nT0202M41\nG96S200M03\nG0X-131.010Z157.139\nG1F0.1\nG2X-131.536Z156.503I0.636K-0.636\nM30";
    let path = good("mori-fanuc-6t", text);
    assert_eq!(path.spelled(), [('r', 157.139, 65.505), ('a', 156.503, 65.768)]);
    let Segment::Arc { center, .. } = path.paths()[1] else { panic!() };
    assert!(center.distance(Point::new(156.503, 64.868)) < 0.002, "{center:?}");
}

#[test]
fn increments_without_sign_and_absolute_centres_are_read_on_the_fifth_control() {
    // From the rest position; U is a radius, numbers have all digits, the centre counts from the program zero without signs.
    let machine = machine("swedish-1970s");
    let rest = machine.rest.unwrap();
    let to = |from: f64, to: f64| format!("{:08}", ((to - from) * 1000.0).round()).replace("-0", "-");
    let text = format!(
        "N001G21T0101\nN002S05M03\nN003G00U{}W{}\nN004G01U{}F0100\nN005G03U0005000W-0005000I0010000K0005000\nN006M30",
        to(rest.diameter_mm / 2.0, 11.0),
        to(rest.z_mm, 0.0),
        to(11.0, 10.0),
    );
    let (path, findings) = run_on(&machine, &text);
    assert_eq!(findings, []);
    let spelled = path.spelled();
    assert_eq!(spelled, [('r', 0.0, 11.0), ('l', 0.0, 10.0), ('a', -5.0, 15.0)]);
    let Segment::Arc { center, .. } = path.paths()[2] else { panic!() };
    assert!(center.distance(Point::new(-5.0, 10.0)) < 1e-9, "{center:?}");
    assert_eq!(path.drives()[1].speed, Speed::Rpm(180.0));
}

#[test]
fn speed_and_feed_follow_their_words() {
    let path = good(
        "fanuc-0i",
        "O1\nG21 T0101\nG50 S2000\nG96 S150 M03\nG0 X100. Z5.\nG1 Z0. F.25\nX4.\nG98 F300. Z-5.\nG97 S500\nX5.\nM05\nX6.\nM30",
    );
    let drives = path.drives();
    let n = |k: usize, r: f64| drives[k].speed.rpm_at(r);
    assert!((n(1, 50.0) - 150_000.0 / (100.0 * std::f64::consts::PI)).abs() < 1e-9);
    assert_eq!(n(2, 2.0), 2000.0);
    assert_eq!((drives[1].feed, drives[3].feed), (Feed::PerRev(0.25), Feed::PerMinute(300.0)));
    assert_eq!((n(4, 1.0), n(5, 1.0)), (500.0, 0.0));
    assert!(drives[0].rapid && !drives[1].rapid);
}

#[test]
fn lengths_in_inches_and_increments_are_converted() {
    let spelled = good("fanuc-0i", "O1\nG20 T0101\nG97 S500 M03\nG0 X2. Z1.\nX10000 Z-5000\nM30").spelled();
    assert_eq!(spelled, [('r', 25.4, 25.4), ('r', -12.7, 12.7)]);
    assert_eq!(path("G0 X100000 Z-1500"), [('r', -1.5, 50.0)]);
}

#[test]
fn dwells_are_in_seconds_or_milliseconds() {
    let path = good("fanuc-0i", "O1\nG21 G4 X1.5\nG4 P250\nG4 U2.\nM30");
    let pauses: Vec<f64> =
        path.steps.iter().filter_map(|(_, s)| if let Step::Pause(s) = s { Some(*s) } else { None }).collect();
    assert_eq!(pauses, [1.5, 0.25, 2.0]);
}

#[test]
fn g28_goes_over_its_place_to_the_reference_point() {
    assert_eq!(path("G0 X100. Z5.\nG28 U0\nG28 W0"), [('r', 5.0, 50.0), ('r', 5.0, 190.0), ('r', 300.0, 190.0)]);
    assert_eq!(path("G0 X100. Z5.\nG53 X0 Z0\nG0 X50."), [('r', 5.0, 50.0), ('r', 300.0, 190.0), ('r', 300.0, 25.0)]);
}

#[test]
fn subroutines_are_called_and_repeated() {
    let moves = path("G0 X50. Z0.\nM98 P20002\nM98 P3 L2\nM30\nO2\nG0 W-1.\nM99\nO3\nG0 W-10.\nM98 P2\nM99");
    assert_eq!(moves.iter().map(|m| m.1).collect::<Vec<_>>(), [0.0, -1.0, -2.0, -12.0, -13.0, -23.0, -24.0]);
    for (text, what) in [
        ("M98 P9", "does not contain"),
        ("M98 P2\nM30\nO2\nM98 P2\nM99", "calls itself"),
        ("M99", "again and again"),
        ("M98 P2\nM30\nO2\nM99 P77", "N77"),
    ] {
        let said = said("fanuc-0i", &format!("{HEAD}{text}\nM30"));
        assert!(said.iter().any(|m| m.contains(what)), "{text}: {said:?}");
    }
}

#[test]
fn endless_loops_are_stopped() {
    let said = said("fanuc-0i", &format!("{HEAD}N5 G0 X1.\nM98 P2\nM30\nO2\nM99 P5"));
    assert!(said.iter().any(|m| m.contains("without end")), "{said:?}");
}

#[test]
fn presets_that_do_not_fit_the_tool_are_found() {
    let good = "O201\nN1G21\nN2G50X-455.000Z320.000\nN3T0202M41\nN4G97S200M03\nN5G0X-180.000Z164.303\nN6G0X-455.000Z320.000\nN7T0200\n\
        N8G50X-300.000Z300.000\nN9T0606\nN10G0X-170.000Z-5.000\nN11M30";
    assert_eq!(said("mori-fanuc-6t", good), Vec::<String>::new());
    for (from, to, what) in [
        ("N2G50X-455", "N2G50X-456", "0.500 mm away"),
        ("T0606", "T0707", "mm away"),
        ("T0606", "T0602", "offset 2"),
        ("N6G0X-455.000Z320.000", "N6G0X-455.000Z310.000", "10.000 mm away"),
        ("N8G50X-300.000Z300.000\n", "", "mm away"),
        ("N2G50X-455.000Z320.000\n", "", "before G50"),
    ] {
        assert!(good.contains(from));
        let said = said("mori-fanuc-6t", &good.replace(from, to));
        assert!(said.iter().any(|m| m.contains(what)), "{to}: {said:?}");
    }
}

#[test]
fn whatever_is_not_known_is_said() {
    for (text, what) in [
        ("G5 X1.", "G5 is not known"),
        ("G1.5 X1.", "G1.5 is not known"),
        ("M77", "M77 is not known"),
        ("G1 X1. Y2. F.1", "Y2 has no meaning"),
        ("G1 X1. C1. F.1", "C1 has no meaning"),
        ("G0 G1 X1. F.1", "exclude"),
        ("G0 X1. U1.", "X and U"),
        ("G2 X30. Z-5. F.1", "neither I and K nor R"),
        ("G0 X20. Z0.\nG2 X30. Z-5. I9. K-5. F.1", "from its start"),
        ("G0 X20. Z0.\nG2 X30. Z-5. R1. F.1", "No arc of radius"),
        ("G76 X10. Z-5. P1000 Q0 F1.", "first depth"),
        ("G71 U2. R1.\nG71 P10 Q20 U1. W.1", "N10"),
        ("G53 X5.", "machine coordinates"),
        ("T0002", "no meaning"),
        ("G4", "no time"),
        ("G80\nX10.", "G80"),
    ] {
        let said = said("fanuc-0i", &format!("{HEAD}{text}\nM30"));
        assert!(said.iter().any(|m| m.contains(what)) || what == "no meaning", "{text}: {said:?}");
    }
}

/// The lathes with controls of words, read once.
static LATHES: std::sync::LazyLock<Vec<(Machine, BTreeMap<u32, ToolOutline>)>> = std::sync::LazyLock::new(|| {
    let catalog = Catalog::shipped();
    let lathes = catalog.machines.iter().filter(|m| m.words.is_some());
    lathes.map(|m| (m.clone(), outlines(m, &catalog))).collect()
});

proptest::proptest! {
    #![proptest_config(proptest::prelude::ProptestConfig::with_cases(200))]

    #[test]
    fn no_program_panics(text in "(N[0-9]{1,3})?([GMTSFXZUWIKRPQ][-0-9.]{1,6} ?){1,6}(\n([GMTXZUWIKRPQ][-0-9.]{1,6}){1,5}){0,8}") {
        for (machine, tools) in LATHES.iter() {
            let tape = words::read(&text, machine.dialect);
            let mut path = Path::default();
            let mut control = Interpreter::new(machine, tools, 0.0, Point::new(5.0, 50.0)).unwrap();
            control.run(&tape, 0, &mut Findings::default(), &mut path).unwrap();
            proptest::prop_assert!(path.paths().iter().all(|p| p.start().is_finite() && p.end().is_finite()));
        }
    }
}
