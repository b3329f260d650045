use super::*;
use crate::app::plots::sample;
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;

struct State {
    part: TurnedPart,
    view: ProfileView,
    selected: Option<u32>,
    events: Vec<ProfileEvent>,
}

/// A window that does what the events ask for.
fn harness() -> Harness<'static, State> {
    let state = State { part: sample::pawn(), view: ProfileView::default(), selected: Some(3), events: Vec::new() };
    let show = |ui: &mut Ui, state: &mut State| {
        let derived = sample::derived(&state.part);
        let scene = ProfileScene {
            derived: &derived,
            part: &state.part.clone(),
            unit: Unit::Mm,
            machine: None,
            selected: state.selected,
            lit: &[],
            palette: &Palette::LIGHT,
        };
        for event in profile_plot(ui, &mut state.view, &scene) {
            match &event {
                ProfileEvent::DragNode { node, .. } => node.apply(&mut state.part),
                ProfileEvent::SelectSection(id) => state.selected = Some(*id),
                _ => {}
            }
            if !matches!(event, ProfileEvent::Pointer(_)) {
                state.events.push(event);
            }
        }
    };
    Harness::builder()
        .with_context_setup(crate::app::install_theme)
        .with_size(Vec2::new(900.0, 500.0))
        .with_max_steps(20)
        .build_ui_state(show, state)
}

#[test]
fn dragging_a_node_moves_its_end_in_one_gesture() {
    let mut harness = harness();
    harness.run();
    let from = harness.get_by_label("Node z 16.000  ⌀ 16.000, convex 3").rect().center();
    harness.drag_at(from);
    harness.run();
    for step in 1..=4_u8 {
        harness.hover_at(from - Vec2::new(0.0, 10.0 * f32::from(step)));
        harness.run();
    }
    harness.drop_at(from - Vec2::new(0.0, 40.0));
    harness.run();
    let state = harness.state();
    assert!(state.part.sections[2].d1 > 20.0, "{}", state.part.sections[2].d1);
    assert_eq!(state.part.sections[2].z1, 16.0, "z did not move");
    assert_eq!(state.part.sections[1].d2, 12.0, "the other side of the face kept its diameter");
    let phases: Vec<Phase> = state
        .events
        .iter()
        .filter_map(|e| if let ProfileEvent::DragNode { phase, .. } = e { Some(*phase) } else { None })
        .collect();
    assert_eq!((phases.first(), phases.last()), (Some(&Phase::Begin), Some(&Phase::End)));
    assert!(phases[1..phases.len() - 1].iter().all(|p| *p == Phase::Move));
    assert!(!state.view.is_dragging());
}

#[test]
fn arrow_keys_nudge_the_focused_node() {
    let mut harness = harness();
    harness.run();
    harness.get_by_label("Node z 16.000  ⌀ 16.000, convex 3").focus();
    harness.run();
    harness.key_press(egui::Key::ArrowUp);
    harness.run();
    let d1 = harness.state().part.sections[2].d1;
    assert!(d1 > 16.0 && d1 < 17.0, "{d1}");
    assert!(matches!(harness.state().events.last(), Some(ProfileEvent::DragNode { phase: Phase::Single, .. })));
}

#[test]
fn a_dimension_is_clicked_and_typed() {
    let mut harness = harness();
    harness.run();
    harness.get_by_label("Radius of convex 3, 9.000 mm").click();
    harness.run();
    harness.get_by_label("Radius of convex 3").type_text("3/8\"");
    harness.run();
    harness.key_press(egui::Key::Enter);
    harness.run();
    let expected =
        ProfileEvent::EditDimension { dimension: Dimension::Radius { section: 3 }, text: "3/8\"".to_owned() };
    assert!(harness.state().events.contains(&expected), "{:?}", harness.state().events);
}

#[test]
fn a_click_on_the_body_selects_its_section() {
    let mut harness = harness();
    harness.run();
    let near = harness.get_by_label("Node z 40.000  ⌀ 12.000, thread 4").rect().center();
    let pos = near + Vec2::new(-60.0, 30.0);
    harness.drag_at(pos);
    harness.run();
    harness.drop_at(pos);
    harness.run();
    assert_eq!(harness.state().selected, Some(4));
}
