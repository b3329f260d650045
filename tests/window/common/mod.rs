//! Pictures of the window without a GPU: a rasteriser for egui's triangles, and a harness around the desk.

#![allow(unreachable_pub, dead_code, reason = "shared with the bench of a frame, which uses some of it")]
#![allow(clippy::expect_used, reason = "a test fails by panicking")]

pub mod raster;

use egui::accesskit::Role;
use egui::{Event, Key, Modifiers};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;
use raster::{Picture, Raster, Textures};
use std::cell::RefCell;
use std::path::Path;
use std::rc::Rc;
use std::time::{Duration, Instant};
use turnwright::app::{Action, Desk, Pane, Surroundings};
use turnwright::document::Content;
use turnwright::session::Session;
use turnwright::storage;

/// The window under test and what is needed to draw it.
pub struct Window {
    pub harness: Harness<'static, Option<Desk>>,
    textures: Rc<RefCell<Textures>>,
}

impl Window {
    /// A window of 1440 × 900 points with the start page on it.
    pub fn open() -> Self {
        Self::with_theme(egui::Theme::Light)
    }

    pub fn with_theme(theme: egui::Theme) -> Self {
        Self::with(theme, Surroundings::default())
    }

    pub fn with(theme: egui::Theme, surroundings: Surroundings) -> Self {
        let textures = Rc::new(RefCell::new(Textures::default()));
        let mut harness = Harness::builder()
            .with_size([1440.0, 900.0])
            .with_theme(theme)
            .with_max_steps(60)
            .with_step_dt(1.0 / 60.0)
            .with_context_setup(turnwright::app::install_theme)
            .renderer(Raster(Rc::clone(&textures)))
            .build_ui_state(
                move |ui, desk: &mut Option<Desk>| {
                    let ctx = ui.ctx().clone();
                    let whole_window = egui::UiBuilder::new().max_rect(ctx.content_rect());
                    let new_desk = || Desk::new(&ctx, surroundings.clone());
                    ui.scope_builder(whole_window, |ui| {
                        ui.set_clip_rect(ctx.content_rect());
                        desk.get_or_insert_with(new_desk).ui(ui);
                    });
                },
                None,
            );
        harness.run_steps(3);
        Self { harness, textures }
    }

    pub fn desk(&mut self) -> &mut Desk {
        self.harness.state_mut().as_mut().expect("the desk is made in the first frame")
    }

    /// The open document.
    pub fn session(&mut self) -> &mut Session {
        self.desk().session_mut().expect("a document is open")
    }

    /// Runs frames until `done`, for at most half a minute, or as many seconds as `WINDOW_PATIENCE` names on a slow machine.
    pub fn until(&mut self, what: &str, done: impl Fn(&Desk) -> bool) {
        let start = Instant::now();
        let patience = std::env::var("WINDOW_PATIENCE").ok().and_then(|seconds| seconds.parse().ok()).unwrap_or(30);
        while !self.harness.state().as_ref().is_some_and(&done) {
            assert!(start.elapsed() < Duration::from_secs(patience), "waited in vain until {what}");
            std::thread::sleep(Duration::from_millis(5));
            self.harness.step();
        }
        self.harness.run_steps(3);
    }

    /// Clicks the widget with this name.
    pub fn click(&mut self, name: &str) {
        self.harness.get_by_label(name).click();
        self.harness.run_steps(2);
    }

    /// Brings a panel to the front.
    pub fn show(&mut self, pane: Pane) {
        let ctx = self.harness.ctx.clone();
        self.desk().act(&ctx, Action::ShowPane(pane));
        self.harness.run_steps(4);
    }

    /// Presses a key.
    pub fn press(&mut self, modifiers: Modifiers, key: Key) {
        self.harness.key_press_modifiers(modifiers, key);
        self.harness.run_steps(3);
    }

    /// Types a text to whatever has the keyboard.
    pub fn type_text(&mut self, text: &str) {
        self.harness.event(Event::Text(text.to_owned()));
        self.harness.run_steps(3);
    }

    /// Types into a field of a form in the place of what it holds, and leaves it.
    pub fn type_into(&mut self, field: &str, text: &str) {
        self.harness.get_by_role_and_label(Role::TextInput, field).click();
        self.harness.run_steps(2);
        self.press(Modifiers::COMMAND, Key::A);
        self.type_text(text);
        self.press(Modifiers::NONE, Key::Tab);
    }

    /// Chooses from a list.
    pub fn choose(&mut self, list: &str, what: &str) {
        self.harness.get_by_role_and_label(Role::ComboBox, list).click();
        self.harness.run_steps(4);
        self.harness.get_by_label(what).click();
        self.harness.run_steps(4);
    }

    /// Opens an example and waits until it is regenerated.
    pub fn open_example(&mut self, name: &str) {
        let card = format!("Open {name}");
        self.harness.get_by_label(&card).scroll_to_me();
        self.harness.run_steps(10);
        self.click(&card);
        self.until_current();
        self.harness.remove_cursor();
        self.harness.run_steps(3);
    }

    /// A window with a file of the project, regenerated.
    pub fn with_file(name: &str) -> Self {
        let mut window = Self::with_design_of(name);
        window.until_current();
        window.harness.run_steps(3);
        window
    }

    /// A window with a file of the project, of which a set of form-rolls is designed, though its rolls may be in the making.
    pub fn with_design_of(name: &str) -> Self {
        Self::open().designed(name)
    }

    /// The window with the published set's first station alone, designed: two rolls, soon made.
    pub fn with_one_station() -> Self {
        let text = std::fs::read_to_string("assets/examples/1470b.turn").expect("the example is there");
        let mut document = storage::document_from_text("1470b.turn", &text).expect("it can be read");
        if let Content::RollSet(set) = &mut document.content {
            set.stations.truncate(1);
            set.rolls.clear();
        }
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("1470b.turn");
        std::fs::write(&path, storage::document_to_text(&document).expect("it can be written")).expect("there is room");
        Self::with_design_of(path.to_str().expect("plain letters"))
    }

    /// The same window when a set of form-rolls is opened and designed.
    pub fn designed(mut self, name: &str) -> Self {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(name);
        let ctx = self.harness.ctx.clone();
        self.desk().act(&ctx, Action::Open(path));
        self.until("opened", |desk| desk.session().is_some());
        self.until_designed();
        self
    }

    /// Writes the window as it is now to the folder `WINDOW_PICTURES` names, if there is one.
    pub fn keep_picture(&self, name: &str) {
        let picture = self.picture();
        assert!(picture.colors() > 8, "{name}: an empty picture");
        if let Some(folder) = std::env::var_os("WINDOW_PICTURES") {
            picture.save(&Path::new(&folder).join(format!("{name}.png")));
        }
    }

    /// Waits until the stations are designed, though rolls may be in the making.
    pub fn until_designed(&mut self) {
        self.until("designed", |desk| desk.session().is_some_and(Session::is_designed));
    }

    /// Waits until what is drawn belongs to the document as it is.
    pub fn until_current(&mut self) {
        self.until("regenerated", |desk| desk.session().is_some_and(Session::is_current));
    }

    /// The window as it is now.
    pub fn picture(&self) -> Picture {
        self.textures.borrow().paint(&self.harness.ctx, self.harness.output())
    }

    /// Draws the window as it is now and writes it to `screenshots/NAME.png` if `UPDATE_SCREENSHOTS=1`.
    pub fn screenshot(&self, name: &str) {
        let picture = self.picture();
        assert!(picture.colors() > 8, "{name}: an empty picture");
        if std::env::var_os("UPDATE_SCREENSHOTS").is_some_and(|v| v == "1") {
            let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("screenshots");
            picture.save(&folder.join(format!("{name}.png")));
        }
    }
}

/// The published trick: one z of an assembled program is changed by hand, here a cut goes 4 mm too far.
pub fn change_one_z(window: &mut Window) {
    use turnwright::post::orac::{Instruction, compress, pages_text};
    let program = window.session().program().cloned().expect("a program");
    let (mut instructions, _) = compress(&program.text, &program.name);
    let last_cut = instructions.iter_mut().rev().find_map(|i| match i {
        Instruction::Ptp { z, feed, .. } if *z < -1000 && *feed < 1000 => Some(z),
        _ => None,
    });
    *last_cut.expect("a cut towards the chuck") -= 4000;
    let text = pages_text(&instructions);
    window.session().edit_part("change one z by hand", None, |part| _ = part.overrides.insert(program.name, text));
    window.until_current();
}
