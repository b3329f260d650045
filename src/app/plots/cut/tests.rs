use super::*;
use crate::app::plots::sample;
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;

struct State {
    derived: SetupDerived,
    view: CutView,
    events: Vec<CutEvent>,
}

fn harness() -> Harness<'static, State> {
    let derived = sample::with_program(sample::derived(&sample::pawn()));
    let state = State { derived, view: CutView::default(), events: Vec::new() };
    let show = |ui: &mut Ui, state: &mut State| {
        let scene = CutScene {
            derived: &state.derived,
            unit: Unit::Mm,
            machine: None,
            form_tolerance_mm: 0.02,
            selected: None,
            lit_blocks: &[],
            lit_sections: &[],
            palette: &Palette::LIGHT,
        };
        let events = cut_plot(ui, &mut state.view, &scene);
        state.events.extend(events.into_iter().filter(|e| !matches!(e, CutEvent::Pointer(_))));
    };
    Harness::builder()
        .with_context_setup(crate::app::install_theme)
        .with_size(Vec2::new(900.0, 500.0))
        .with_max_steps(20)
        .build_ui_state(show, state)
}

#[test]
fn the_bar_steps_by_block_and_says_where_it_is() {
    let mut harness = harness();
    harness.run();
    harness.get_by_label("Block forward").click();
    harness.run();
    let state = harness.state();
    assert_eq!(state.view.block(&state.derived), Some(BlockRef { program: 0, block: 2 }));
    assert_eq!(state.view.status(&state.derived), "block 2 of 4 · tool 1");
    assert_eq!(state.events.last(), Some(&CutEvent::Scrub(state.view.time_s)));
    harness.get_by_label("Last block").click();
    harness.run();
    let state = harness.state();
    assert_eq!(state.view.time_s, total_s(&state.derived.proof.moves));
}

#[test]
fn keys_step_while_the_plot_has_the_focus() {
    let mut harness = harness();
    harness.run();
    harness.get_by_label("Cut of SAMPLE").focus();
    harness.run();
    harness.key_press(egui::Key::ArrowRight);
    harness.run();
    harness.key_press(egui::Key::ArrowRight);
    harness.run();
    let state = harness.state();
    assert_eq!(state.view.block(&state.derived).map(|b| b.block), Some(3));
}

#[test]
fn a_click_on_a_path_selects_its_block() {
    let mut harness = harness();
    harness.run();
    let moves = harness.state().derived.proof.moves.clone();
    let rect = harness.get_by_label("Cut of SAMPLE").rect();
    let screen = canvas::Screen::fitted(rect, shown_bounds(&harness.state().derived.setup));
    let pos = screen.pos(moves[1].path.point_at(0.5));
    harness.drag_at(pos);
    harness.run();
    harness.drop_at(pos);
    harness.run();
    let selected = CutEvent::SelectBlock(BlockRef::of(&moves[1]));
    assert!(harness.state().events.contains(&selected), "{:?}", harness.state().events);
}

#[test]
fn going_to_a_block_puts_the_slider_to_its_start() {
    let derived = sample::with_program(sample::derived(&sample::pawn()));
    let mut view = CutView { playing: true, ..CutView::default() };
    view.go_to(&derived, BlockRef { program: 0, block: 3 });
    assert_eq!((view.time_s, view.playing), (derived.proof.moves[2].starts_s, false));
    view.go_to(&derived, BlockRef { program: 0, block: 99 });
    assert_eq!(view.time_s, derived.proof.moves[2].starts_s);
}
