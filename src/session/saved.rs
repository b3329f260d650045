//! Where the document stands against its file and its recovery file.

use super::Session;
use crate::document::Document;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Duration;

/// Where the document stands against its file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SaveState {
    /// Never saved.
    New,
    /// The file holds this very document.
    Saved,
    /// Edited since.
    Edited,
}

impl Session {
    /// The document's file.
    #[must_use]
    pub fn path(&self) -> Option<&Path> {
        self.path.as_deref()
    }

    /// Notes that `document` is now in the file `path`.
    pub fn set_saved(&mut self, path: PathBuf, document: Arc<Document>) {
        self.path = Some(path);
        self.saved = Some(document);
    }

    /// Where the document stands against its file.
    #[must_use]
    pub fn save_state(&self) -> SaveState {
        match &self.saved {
            Some(saved) if Arc::ptr_eq(saved, &self.document) || **saved == *self.document => SaveState::Saved,
            Some(_) => SaveState::Edited,
            None => SaveState::New,
        }
    }

    /// True if closing would lose work: edited since it was opened or saved.
    #[must_use]
    pub fn has_unsaved_work(&self) -> bool {
        match self.save_state() {
            SaveState::Saved => false,
            SaveState::Edited => true,
            SaveState::New => self.recovered || self.history.undo_label().is_some(),
        }
    }

    /// Time since the oldest edit that no recovery file holds yet.
    #[must_use]
    pub fn unrecovered_for(&self) -> Option<Duration> {
        self.edited_at.map(|at| at.elapsed())
    }

    /// Notes that a recovery file holds the document as it is now.
    pub const fn set_recovered(&mut self) {
        self.edited_at = None;
    }
}
