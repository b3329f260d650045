//! The keyboard shortcuts.

use crate::app::theme::{self, Colors};
use egui::{Grid, RichText, Ui};

/// Keys and what they do, by place.
const KEYS: [(&str, &[(&str, &str)]); 6] = [
    (
        "Everywhere",
        &[
            ("Ctrl+N / Ctrl+O", "new part / open or import"),
            ("Ctrl+S / Ctrl+Shift+S", "save / save as"),
            ("Ctrl+E", "export"),
            ("Ctrl+Z / Ctrl+Shift+Z", "undo / redo"),
            ("Ctrl+Enter", "send to the lathe"),
            ("Ctrl+plus / minus / 0", "larger / smaller / normal"),
            ("F1", "these shortcuts"),
        ],
    ),
    (
        "Section table",
        &[
            ("arrows, Tab, Enter", "go from cell to cell"),
            ("F2, or just type", "edit the cell; Escape gives up"),
            ("Insert", "insert a row above"),
            ("Ctrl+D", "duplicate rows"),
            ("Alt+↑ / Alt+↓", "move rows"),
            ("Ctrl+Delete", "delete rows"),
            ("Ctrl+C / Ctrl+V", "copy / paste rows or cells"),
        ],
    ),
    (
        "Operations",
        &[
            ("↑ / ↓", "the one before / after"),
            ("Insert, Ctrl+D", "add / duplicate an instruction"),
            ("Alt+↑ / Alt+↓", "move it"),
            ("Ctrl+Delete", "take it out"),
        ],
    ),
    (
        "Rig of a shell",
        &[
            ("Space, Enter, letters, digits", "answer the operator's panel"),
            ("Escape", "emergency stop while it runs, whatever is shown"),
        ],
    ),
    (
        "Profile",
        &[
            ("arrows", "nudge the selected node"),
            ("Shift, Alt while dragging", "lock an axis, no snapping"),
            ("wheel, + / -", "zoom"),
            ("F, double click", "show everything"),
        ],
    ),
    ("Cut", &[("Space", "play / stop"), ("← / →", "one block back / on"), ("Home / End", "beginning / end")]),
];

/// Shows the list; true when it is closed.
pub(super) fn show(ui: &mut Ui) -> bool {
    let colors = Colors::of(ui.visuals());
    ui.set_width(760.0);
    ui.label(theme::strong("Keyboard").size(15.0));
    ui.add_space(6.0);
    ui.columns(2, |columns| {
        for (index, (place, keys)) in KEYS.iter().enumerate() {
            let Some(ui) = columns.get_mut(usize::from(index >= 2)) else { continue };
            ui.label(theme::strong(*place));
            Grid::new(*place).num_columns(2).spacing([14.0, 5.0]).show(ui, |ui| {
                for (key, what) in *keys {
                    ui.label(RichText::new(*key).color(colors.plot.accent));
                    ui.label(*what);
                    ui.end_row();
                }
            });
            ui.add_space(10.0);
        }
    });
    ui.button("Close").clicked()
}
