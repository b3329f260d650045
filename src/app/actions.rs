//! What a person asks of the window as a whole. Panels ask, the desk acts after the frame.

use super::layout::Pane;
use crate::diagnostic::Place;
use std::path::PathBuf;

/// One request.
#[derive(Debug, Clone, PartialEq)]
pub enum Action {
    /// Start an empty part.
    New,
    /// Open a file or import one.
    Open(PathBuf),
    /// Open one of the examples, by index.
    OpenExample(usize),
    /// Back to the start page.
    Close,
    /// Take back the last step.
    Undo,
    /// Do again what was undone.
    Redo,
    /// Show or hide a panel.
    TogglePane(Pane),
    /// Bring a panel to the front.
    ShowPane(Pane),
    /// Put all panels back.
    ResetLayout,
    /// Light, dark or as the system.
    Theme(egui::ThemePreference),
    /// Change the zoom: 1 in, -1 out, 0 normal.
    Zoom(i8),
    /// Go to the place of a message.
    GoTo(Place),
}
