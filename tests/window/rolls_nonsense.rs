//! Nonsense typed into every field of a set of form-rolls: it is marked or told, nothing breaks, and undone all is as before.

use crate::common::Window;
use egui::accesskit::Role;
use egui::{Key, Modifiers};
use egui_kittest::kittest::{NodeT, Queryable};
use turnwright::app::Pane;
use turnwright::document::Document;

/// What a person may type that makes no sense, and what is far too much or too little.
const NONSENSE: [&str; 8] = ["ten", "", "NaN", "1e300", "-1", "0", "1/0", "99999999999999999999"];

fn texts(window: &Window, role: Role) -> Vec<String> {
    let labels = window.harness.query_all_by_role(role).filter_map(|n| n.accesskit_node().label());
    let mut labels: Vec<String> = labels.collect();
    labels.sort();
    labels.dedup();
    labels
}

/// Types into what has the keyboard, and leaves it.
fn type_over(window: &mut Window, text: &str) {
    window.press(Modifiers::COMMAND, Key::A);
    window.press(Modifiers::NONE, Key::Delete);
    if !text.is_empty() {
        window.type_text(text);
    }
    window.press(Modifiers::NONE, Key::Tab);
}

/// Waits for the design, and takes back what was changed.
fn back_to(window: &mut Window, before: &Document) -> usize {
    window.until_designed();
    let said = window.session().problems().len();
    for _ in 0..4 {
        if window.session().document().as_ref() == before {
            break;
        }
        window.session().undo();
    }
    assert_eq!(window.session().document().as_ref(), before, "undone all is as before");
    said
}

#[test]
fn nonsense_in_any_field_is_survived_and_undone() {
    let mut window = Window::with_one_station();
    let before = window.session().document().as_ref().clone();
    let mut fields = 0;
    for pane in [Pane::Elements, Pane::StationData, Pane::RollEditor, Pane::RollList] {
        window.show(pane);
        for (number, label) in texts(&window, Role::TextInput).into_iter().enumerate() {
            // Every text in every field takes long; the fields get them in turn.
            let text = NONSENSE[number % NONSENSE.len()];
            let Some(node) = window.harness.query_all_by_role_and_label(Role::TextInput, &label).next() else {
                continue;
            };
            node.click();
            window.harness.run_steps(2);
            type_over(&mut window, text);
            window.press(Modifiers::NONE, Key::Escape);
            back_to(&mut window, &before);
            fields += 1;
        }
    }
    assert!(fields >= 20, "{fields}");
}

#[test]
fn nonsense_in_the_tables_is_marked_or_told_at_its_place() {
    let mut window = Window::with_one_station();
    let before = window.session().document().as_ref().clone();
    for pane in [Pane::Elements, Pane::Angles] {
        window.show(pane);
    }
    let cells: Vec<String> = texts(&window, Role::Cell);
    let wanted = |name: &&String| {
        ["length / r of Element 1:", "bend ° of Element 2:", "stn 1 of Bend 10:"].iter().any(|w| name.starts_with(w))
    };
    let cells: Vec<&String> = cells.iter().filter(wanted).collect();
    assert_eq!(cells.len(), 3, "{cells:?}");
    let mut told = 0;
    for cell in cells {
        for text in ["ten", "1e300", "-1e300", "0", "NaN"] {
            window.click(cell);
            window.type_text(text);
            window.press(Modifiers::NONE, Key::Enter);
            told += usize::from(back_to(&mut window, &before) > 0);
            // A text that is no figure stays, marked, until it is taken back.
            if window.harness.query_by_label(cell).is_none() {
                let start = format!("{}:", cell.rsplit_once(':').map_or(cell.as_str(), |(name, _)| name));
                window.harness.get_by_label_contains(&start).click();
                window.harness.run_steps(2);
                window.press(Modifiers::NONE, Key::F2);
                window.press(Modifiers::NONE, Key::Escape);
                window.harness.run_steps(3);
            }
            assert!(window.harness.query_by_label(cell).is_some(), "{cell} after {text}");
        }
    }
    assert!(told >= 5, "{told}");
}
