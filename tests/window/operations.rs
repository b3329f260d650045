//! The operations panel and the editors of data: what a person does, and what becomes of document and files.

use crate::common::Window;
use egui::{Key, Modifiers};
use egui_kittest::kittest::Queryable;
use turnwright::app::data::Kind;
use turnwright::app::{Action, Surroundings};
use turnwright::document::{Cycle, Generator, Instruction};
use turnwright::machine::{Catalog, ToolShape};
use turnwright::regen::Operations;

fn click_part(window: &mut Window, part_of_name: &str) {
    window.harness.get_by_label_contains(part_of_name).click();
    window.harness.run_steps(3);
}

fn instructions(window: &mut Window) -> Vec<Instruction> {
    window.session().part().generator.instructions().to_vec()
}

/// The queen with two instructions for the form-roll cycles.
fn instructed() -> Window {
    let mut window = Window::open();
    window.open_example("QUEEN");
    let ids: Vec<u32> = window.session().part().sections.iter().map(|s| s.id).collect();
    let rough = Instruction {
        cycle: Cycle::Rough,
        from: ids[11],
        to: ids[0],
        stock_left: 0.5,
        tool: 1,
        depth: 1.0,
        speed_m_per_min: 120.0,
        feed_per_rev: 0.2,
        cut_in: None,
    };
    let finish = Instruction { cycle: Cycle::Finish, stock_left: 0.0, depth: 0.0, feed_per_rev: 0.1, ..rough.clone() };
    window.session().edit_part("instruct", None, |part| {
        part.generator = Generator::Cycles { instructions: vec![rough, finish] };
    });
    window.until_current();
    window
}

#[test]
fn an_operation_lights_its_paths_blocks_and_rows() {
    let mut window = Window::open();
    window.open_example("QUEEN");
    let setup = window.session().setup().unwrap().clone();
    let operations = Operations::of(&setup);
    let index = setup.path.operations.iter().position(|o| o.name.contains("Finish") && !o.moves.is_empty()).unwrap();
    let blocks = operations.blocks(index);
    assert!(!blocks.is_empty());
    let name = setup.path.operations[index].name.clone();
    window.harness.get_by_label_contains(&format!(": {name}, tool")).hover();
    window.harness.run_steps(3);
    assert_eq!(window.session().lit().blocks, blocks, "hovered");
    assert!(!window.session().lit().sections.is_empty());
    window.harness.remove_cursor();
    window.harness.run_steps(3);
    assert!(window.session().lit().blocks.is_empty());
    click_part(&mut window, &format!(": {name}, tool"));
    window.harness.remove_cursor();
    window.harness.run_steps(3);
    assert_eq!(window.session().selection.operation, Some(index));
    assert_eq!(window.session().selection.block, Some(blocks[0].block));
    assert_eq!(window.session().lit().blocks, blocks, "a selected one stays lit");
    window.press(Modifiers::NONE, Key::ArrowUp);
    assert!(window.session().selection.operation.is_some_and(|other| other < index));
    window.click("Row 3");
    assert_eq!(window.session().selection.operation, None, "a row takes its place");
}

#[test]
fn all_time_belongs_to_an_operation_or_to_start_and_end() {
    let mut window = Window::open();
    window.open_example("MASTER");
    let setup = window.session().setup().unwrap().clone();
    let (times, rest) = Operations::of(&setup).times();
    let sum: f64 = times.iter().map(turnwright::regen::OperationTime::total_s).sum();
    assert!((sum + rest.total_s() - setup.proof.times.total_s).abs() < 1e-6);
}

#[test]
fn instructions_are_edited_one_step_at_a_time() {
    let mut window = instructed();
    click_part(&mut window, "Operation 2: Finish");
    window.click("duplicate");
    assert_eq!(instructions(&mut window).len(), 3);
    assert_eq!(window.session().selection.operation, Some(2));
    window.click("↑");
    window.click("↑");
    let cycles: Vec<Cycle> = instructions(&mut window).iter().map(|i| i.cycle).collect();
    assert_eq!(cycles, [Cycle::Finish, Cycle::Rough, Cycle::Finish]);
    window.press(Modifiers::ALT, Key::ArrowDown);
    let cycles: Vec<Cycle> = instructions(&mut window).iter().map(|i| i.cycle).collect();
    assert_eq!(cycles, [Cycle::Rough, Cycle::Finish, Cycle::Finish]);
    window.press(Modifiers::COMMAND, Key::Delete);
    assert_eq!(instructions(&mut window).len(), 2);
    // The first move changed two equal neighbours: no step.
    for _ in 0..4 {
        window.session().undo();
    }
    assert_eq!(window.session().history().undo_label(), Some("instruct"), "every edit was one step");
    assert_eq!(instructions(&mut window).len(), 2);
}

#[test]
fn figures_of_an_instruction_take_effect_while_they_are_typed() {
    let mut window = instructed();
    click_part(&mut window, "Operation 1: Rough");
    window.click("Depth");
    window.type_text("1/");
    assert_eq!(instructions(&mut window)[0].depth, 1.0);
    window.type_text("8in");
    assert_eq!(instructions(&mut window)[0].depth, 3.175);
    window.press(Modifiers::NONE, Key::Enter);
    assert_eq!(window.session().history().undo_label(), Some("depth of operation 1"));
    window.session().undo();
    assert_eq!(instructions(&mut window)[0].depth, 1.0);
    window.harness.run_steps(3);
    window.click("To row");
    window.type_text("99");
    window.press(Modifiers::NONE, Key::Tab);
    let first = window.session().part().sections[0].id;
    assert_eq!(instructions(&mut window)[0].to, first, "there is no row 99");
}

#[test]
fn the_area_of_an_instruction_is_picked_on_the_profile() {
    let mut window = instructed();
    click_part(&mut window, "Operation 1: Rough");
    window.click("pick on the profile");
    let node = |window: &Window, name: &str| window.harness.get_by_label_contains(name).rect().center();
    let (from, to) = (node(&window, "Node z 38.600  ⌀ 10.200"), node(&window, "Node z 41.000  ⌀ 10.200"));
    let row_7 = from + (to - from) * 0.5;
    let click = |window: &mut Window, at: egui::Pos2| {
        window.harness.hover_at(at);
        window.harness.run_steps(2);
        window.harness.drag_at(at);
        window.harness.drop_at(at);
        window.harness.run_steps(3);
    };
    click(&mut window, row_7);
    assert!(window.harness.query_by_label_contains("Click the last element of operation 1").is_some());
    let (from, to) = (node(&window, "Node z 50.400  ⌀ 16.200"), node(&window, "Node z 53.500  ⌀ 12.900"));
    click(&mut window, from + (to - from) * 0.5);
    let rows: Vec<u32> = window.session().part().sections.iter().map(|s| s.id).collect();
    let first = instructions(&mut window)[0].clone();
    assert_eq!((first.from, first.to), (rows[6], rows[10]));
    assert_eq!(window.session().history().undo_label(), Some("area of operation 1"));
    assert_eq!(window.session().selection.operation, Some(0), "the clicks selected nothing else");
}

fn with_folder(folder: &std::path::Path) -> Window {
    let surroundings = Surroundings { config_folder: Some(folder.to_owned()), ..Surroundings::default() };
    Window::with(egui::Theme::Light, surroundings)
}

fn edit(window: &mut Window, kind: Kind, key: &str) {
    let ctx = window.harness.ctx.clone();
    window.desk().act(&ctx, Action::EditData(kind, Some(key.to_owned())));
    window.harness.run_steps(3);
}

fn retype(window: &mut Window, field: &str, text: &str) {
    window.click(field);
    window.press(Modifiers::COMMAND, Key::A);
    window.type_text(text);
    window.press(Modifiers::NONE, Key::Tab);
}

#[test]
fn a_tool_is_edited_saved_and_used() {
    let folder = tempfile::tempdir().unwrap();
    let mut window = with_folder(folder.path());
    window.open_example("QUEEN");
    let before = window.session().setup().unwrap().tools[&1].nose_radius;
    assert_eq!(before, 0.2);
    edit(&mut window, Kind::Tools, "orac-right");
    retype(&mut window, "Nose radius", "0.8");
    window.click("Save");
    window.harness.run_steps(3);
    window.click("Close");
    window.until_current();
    assert_eq!(window.session().setup().unwrap().tools[&1].nose_radius, 0.8);
    let (catalog, complaints) = Catalog::load(Some(folder.path()));
    assert_eq!(complaints, []);
    assert!(matches!(catalog.tool("orac-right").unwrap().shape, ToolShape::Turning { nose_radius: 0.8, .. }));
}

#[test]
fn a_wrong_code_is_said_at_its_field_and_not_saved() {
    let folder = tempfile::tempdir().unwrap();
    let mut window = with_folder(folder.path());
    edit(&mut window, Kind::Tools, "pclnr-cnmg-08");
    retype(&mut window, "Insert", "XNMG120408");
    window.click("Save");
    assert!(std::fs::read_dir(folder.path()).unwrap().next().is_none(), "nothing is saved");
    assert!(window.harness.query_all_by_label_contains("shape.insert: ").next().is_some());
    retype(&mut window, "Insert", "DNMG150608");
    assert!(window.harness.query_all_by_label_contains("The holder takes the shape").next().is_some());
    retype(&mut window, "Holder", "PDJNR2525M15");
    retype(&mut window, "Id", "my-own");
    window.click("Save");
    assert!(Catalog::load(Some(folder.path())).0.tool("my-own").is_some());
    assert!(folder.path().join("tools/my-own.toml").exists());
}

#[test]
fn machines_and_materials_are_edited_too() {
    let folder = tempfile::tempdir().unwrap();
    let mut window = with_folder(folder.path());
    window.open_example("QUEEN");
    edit(&mut window, Kind::Machines, "orac");
    retype(&mut window, "Travel z", "300/2");
    window.harness.get_by_label("Station 1").scroll_to_me();
    window.harness.run_steps(20);
    retype(&mut window, "Station 1", "12");
    window.click("Save");
    edit(&mut window, Kind::Materials, "aluminum · mm");
    retype(&mut window, "Density", "2.7");
    window.click("Save");
    let catalog = Catalog::load(Some(folder.path())).0;
    let orac = catalog.machine("orac").unwrap();
    assert_eq!((orac.limits.travel_z_mm, orac.tools[0].station), (150.0, 12));
    assert_eq!(catalog.material("aluminum", turnwright::units::Unit::Mm).unwrap().density_kg_per_dm3, Some(2.7));
}

#[test]
fn without_a_folder_nothing_can_be_saved() {
    let mut window = Window::open();
    edit(&mut window, Kind::Tools, "orac-right");
    assert!(window.harness.query_by_label_contains("There is no configuration folder").is_some());
}
