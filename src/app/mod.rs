//! The window: the only place that knows egui.

mod actions;
mod acts;
pub mod data;
mod desk;
mod dialogs;
mod files;
mod inspector;
mod layout;
mod menus;
mod new;
mod operations;
mod panes;
pub mod plots;
mod problems;
mod program;
mod rolls;
mod sections;
mod sheet;
mod shell;
mod shortcuts;
mod start;
mod status;
mod theme;
mod transfer;
mod widgets;

pub use actions::Action;
pub use desk::{Desk, Surroundings};
pub use layout::Pane;
use std::path::PathBuf;
pub use theme::install as install_theme;

/// Opens the window, on `path` if one is given, and returns when it is closed.
///
/// # Errors
/// A sentence that says why the window could not be opened.
pub fn run(path: Option<PathBuf>) -> Result<(), String> {
    if no_display() {
        return Err("There is no display to open the window on.".to_owned());
    }
    let viewport = egui::ViewportBuilder::default()
        .with_title("Turnwright")
        .with_app_id("turnwright")
        .with_inner_size([1440.0, 900.0])
        .with_min_inner_size([900.0, 600.0])
        .with_drag_and_drop(true);
    let options = eframe::NativeOptions { viewport, ..eframe::NativeOptions::default() };
    let create = move |cc: &eframe::CreationContext<'_>| -> Result<Box<dyn eframe::App>, _> {
        let mut desk = Desk::new(&cc.egui_ctx, Surroundings::of_user());
        if let Some(storage) = cc.storage {
            desk.restore(|key| storage.get_string(key));
        }
        if let Some(path) = path {
            desk.act(&cc.egui_ctx, Action::Open(path));
        }
        Ok(Box::new(App(desk)))
    };
    eframe::run_native("turnwright", options, Box::new(create))
        .map_err(|reason| format!("The window could not be opened: {reason}."))
}

fn no_display() -> bool {
    cfg!(all(unix, not(target_os = "macos")))
        && ["DISPLAY", "WAYLAND_DISPLAY", "WAYLAND_SOCKET"]
            .iter()
            .all(|name| std::env::var_os(name).is_none_or(|v| v.is_empty()))
}

struct App(Desk);

impl eframe::App for App {
    fn ui(&mut self, ui: &mut egui::Ui, _frame: &mut eframe::Frame) {
        self.0.ui(ui);
    }

    fn save(&mut self, storage: &mut dyn eframe::Storage) {
        self.0.remember(|key, value| storage.set_string(key, value));
    }
}
