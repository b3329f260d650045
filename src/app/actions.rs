//! What a person asks of the window as a whole. Panels ask, the desk acts after the frame.

use super::data::{Entry, Kind};
use super::layout::Pane;
use crate::diagnostic::Place;
use crate::document::Document;
use crate::papers::PaperKind;
use std::path::PathBuf;
use std::sync::Arc;

/// One request.
#[derive(Debug, Clone, PartialEq)]
pub enum Action {
    /// Start a new document.
    New(crate::document::Kind),
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
    /// Send the program that is shown to the lathe.
    Send,
    /// Send it although its proof fails: the second step.
    SendAllTheSame,
    /// Put the slider to the selected block.
    ShowBlock,
    /// Emergency stop of the rig.
    StopRig,
    /// Save, then do this.
    SaveThen(Box<Action>),
    /// Give up unsaved work, then do this.
    GiveUp(Box<Action>),
    /// Save into the document's file, or ask for one.
    Save,
    /// Ask where to save.
    SaveAs,
    /// Ask for a file to open or import.
    AskOpen,
    /// Ask for the file of a program that takes the place of the program shown.
    AskOpenProgram,
    /// Ask for a drawing of a cross-section, of which a set of form-rolls is made.
    AskOpenSection,
    /// Make a set of form-rolls of a drawing of its cross-section.
    OpenSection(PathBuf),
    /// Put the program of a file in the place of the program that is shown.
    OpenProgram(PathBuf),
    /// Open a document that was made here: a new shell, or a shell's former as a part.
    OpenMade(Box<Document>),
    /// Ask for a file to export to.
    AskExport,
    /// Ask for a file to save this text in, which is a program by this name.
    AskSaveProgram {
        /// Name without extension.
        name: String,
        /// The pages, control characters and all.
        text: Arc<str>,
    },
    /// Ask for a file to save this text in: a contour that follows from the document.
    AskSaveText {
        /// Name with extension.
        name: String,
        /// What the file says.
        text: Arc<str>,
    },
    /// Ask for a file to save papers of the part in.
    AskSavePapers(PaperKind),
    /// Write papers of the part into a file whose kind goes by its extension.
    WritePapers(PathBuf, PaperKind),
    /// Write a text as it is into a file.
    WriteText(PathBuf, Arc<str>),
    /// Write the document into a file whose kind goes by its extension.
    WriteTo(PathBuf),
    /// Open what a run that crashed left behind, by index.
    Recover(usize),
    /// Throw away what a run that crashed left behind, by index.
    ForgetRecovered(usize),
    /// Edit machines, tools or materials; with an id, that one first.
    EditData(Kind, Option<String>),
    /// Save a machine, a tool or a material among the user's own.
    SaveData(Box<Entry>),
    /// List the keyboard shortcuts.
    Shortcuts,
    /// Close the window.
    Quit,
    /// Go to the place of a message.
    GoTo(Place),
}

impl Action {
    /// True if the open document is left by it.
    pub(crate) const fn leaves_document(&self) -> bool {
        matches!(
            self,
            Self::New(_)
                | Self::OpenMade(_)
                | Self::Open(_)
                | Self::OpenExample(_)
                | Self::Recover(_)
                | Self::Close
                | Self::Quit
        )
    }
}
