use super::*;

/// Presses keys; a space stands for the space bar, `\n` for RETURN, `<` for DEL.
fn press(sequence: &mut Sequence, keys: &str) -> Vec<Command> {
    let key = |c| match c {
        ' ' => Key::Space,
        '\n' => Key::Return,
        '<' => Key::Delete,
        c => Key::Char(c),
    };
    keys.chars().filter_map(|c| sequence.take(Event::Key(key(c)))).collect()
}

/// A sequence that asks for the shape.
fn set_up() -> Sequence {
    let mut sequence = Sequence::new(false);
    assert_eq!(press(&mut sequence, " "), []);
    assert_eq!(press(&mut sequence, "     "), [Command::StartPump, Command::SeekDatum]);
    assert_eq!(press(&mut sequence, "A"), [Command::Bell], "the roller is on its way");
    sequence.take(Event::AtDatum);
    assert_eq!(sequence.screen().title, "Shape");
    sequence
}

fn cone(length: u32, increment: u32, angle: u32, start: RollerStart) -> Job {
    Job::Cone(ConeParameters::new(length, increment, angle).unwrap().starting(start))
}

#[test]
fn a_cone_is_entered_run_and_repeated_with_the_same_values() {
    let mut sequence = set_up();
    assert_eq!(press(&mut sequence, "A50\n16\n30\nNN"), []);
    let job = cone(50, 16, 30, RollerStart::AtTip);
    assert_eq!(press(&mut sequence, " "), [Command::Run(job)]);
    assert!(sequence.is_running());
    sequence.take(Event::Completed);
    assert_eq!(press(&mut sequence, "Y"), [Command::Run(job)]);
    sequence.take(Event::Completed);
    assert_eq!(press(&mut sequence, "N"), []);
    assert_eq!(sequence.screen().title, "Shape");
}

#[test]
fn adjustments_and_the_test_position_move_the_start() {
    for (keys, start) in [
        ("A40\n8\n45\nY", RollerStart::Test),
        ("A40\n8\n45\nNY12\nF", RollerStart::Adjusted(-12)),
        ("A40\n8\n45\nNY80\nR", RollerStart::Adjusted(80)),
    ] {
        let mut sequence = set_up();
        assert_eq!(press(&mut sequence, keys), []);
        assert_eq!(press(&mut sequence, " "), [Command::Run(cone(40, 8, 45, start))]);
    }
}

#[test]
fn the_parabola_asks_for_its_length_only() {
    let mut sequence = set_up();
    press(&mut sequence, "B");
    assert!(sequence.screen().notes[0].contains("68.45"));
    assert_eq!(press(&mut sequence, "74\nNN"), []);
    let job = Job::Parabola(ParabolaParameters::new(74).unwrap());
    assert_eq!(press(&mut sequence, " "), [Command::Run(job)]);
}

#[test]
fn every_wrong_entry_rings_and_says_what_is_expected() {
    let bell = [Command::Bell];
    let mut sequence = Sequence::new(false);
    assert_eq!(press(&mut sequence, "x"), bell);
    let mut sequence = set_up();
    let mut wrong = |keys: &str, said: &str| {
        assert_eq!(press(&mut sequence, keys), bell, "{keys:?}");
        let screen = sequence.screen();
        assert!(screen.wrong.as_ref().is_some_and(|w| w.contains(said)), "{keys:?}: {screen:?}");
    };
    wrong("C", "A or B");
    wrong("A29\n", "29; enter 30 to 74");
    wrong("75\n", "75; enter 30 to 74");
    wrong("\n", "0; enter 30 to 74");
    wrong("123", "two digits");
    wrong("x", "digits");
    wrong("<<<", "digits");
    wrong("50\n7\n", "7; enter 8 to 16");
    wrong("17\n", "17; enter 8 to 16");
    wrong("8\n46\n", "46; enter 30 to 45");
    wrong("30\nQ", "Y or N");
    wrong("N?", "Y or N");
    wrong("Y81\n", "81; enter 1 to 80");
    wrong("0\n", "0; enter 1 to 80");
    wrong("5\nX", "F to subtract");
    wrong("FZ", "space bar");
}

#[test]
fn delete_takes_one_digit_away() {
    let mut sequence = set_up();
    press(&mut sequence, "A57<");
    assert_eq!(sequence.screen().field.as_deref(), Some("5"));
    assert_eq!(press(&mut sequence, "0\n"), []);
    assert!(sequence.screen().notes.contains(&"form length 50 mm".to_owned()));
}

#[test]
fn emergency_stop_works_everywhere_and_leads_back_to_the_set_up() {
    for keys in ["", " ", "      ", "A", "A5", "A50\n16\n30\nN", "A50\n16\n30\nNN "] {
        let mut sequence = if keys.starts_with('A') { set_up() } else { Sequence::new(false) };
        press(&mut sequence, keys);
        assert_eq!(sequence.take(Event::Key(Key::Emergency)), Some(Command::EmergencyStop), "{keys:?}");
        assert_eq!(sequence.screen().title, "Stopped");
        assert_eq!(press(&mut sequence, "A "), [Command::Bell]);
        assert_eq!(sequence.screen().title, "Machine set-up");
    }
}

#[test]
fn a_run_stopped_by_the_controller_tells_why() {
    let mut sequence = Sequence { has_design: true, ..set_up() };
    assert_eq!(press(&mut sequence, "C "), [Command::Run(Job::Design)]);
    sequence.take(Event::Stopped("The roller is 2.1 mm off.".to_owned()));
    assert_eq!(sequence.screen().prompt, "The roller is 2.1 mm off.");
}

#[test]
fn every_screen_but_a_running_one_has_a_next_action() {
    let mut sequence = set_up();
    for key in "A50\n16\n30\nNY5\nR".chars() {
        assert!(!sequence.screen().choices.is_empty(), "{:?}", sequence.screen());
        press(&mut sequence, &key.to_string());
    }
}
