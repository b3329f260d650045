//! Changes of the document: edits, what is being typed, and undo.

use super::{GestureId, History, Session};
use crate::document::Document;
use std::sync::Arc;

/// A value that is being typed.
#[derive(Debug, Clone)]
pub(super) struct Typing {
    gesture: GestureId,
    before: Arc<Document>,
}

impl Session {
    /// A gesture that no edit has used yet.
    pub fn new_gesture(&mut self) -> GestureId {
        self.gestures += 1;
        GestureId(self.gestures)
    }

    /// Changes the document. An edit that changes nothing leaves no trace; edits of one gesture are one step of undo.
    pub fn edit(&mut self, label: &str, gesture: Option<GestureId>, change: impl FnOnce(&mut Document)) {
        self.typing = None;
        self.put_in(label, gesture, change);
    }

    fn put_in(&mut self, label: &str, gesture: Option<GestureId>, change: impl FnOnce(&mut Document)) {
        let mut edited = (*self.document).clone();
        change(&mut edited);
        if edited == *self.document {
            return;
        }
        let before = std::mem::replace(&mut self.document, Arc::new(edited));
        self.history.push(label, gesture, before);
        self.changed();
    }

    /// Begins to type a value: what is typed from here on is one step of undo.
    pub fn begin_typing(&mut self) {
        self.typing = Some(Typing { gesture: self.new_gesture(), before: Arc::clone(&self.document) });
    }

    /// Puts what has been typed so far into the document as it was before the typing, so that nothing is left of a shorter
    /// text.
    pub fn type_in(&mut self, label: &str, change: impl FnOnce(&mut Document)) {
        if self.typing.is_none() {
            self.begin_typing();
        }
        let Some(Typing { gesture, before }) = self.typing.clone() else { return };
        let mut typed = (*before).clone();
        change(&mut typed);
        if typed == *before {
            self.take_back_typing();
        } else {
            self.put_in(label, Some(gesture), |document| *document = typed);
        }
    }

    /// Puts the value before the typing back, as when the text is none; the typing goes on.
    pub fn take_back_typing(&mut self) {
        if let Some(Typing { gesture, .. }) = self.typing
            && let Some(before) = self.history.abandon(gesture)
        {
            self.document = before;
            self.changed();
        }
    }

    /// Ends the typing; what was typed stays.
    pub fn end_typing(&mut self) {
        self.typing = None;
    }

    /// Ends the typing and puts the value before it back.
    pub fn give_up_typing(&mut self) {
        self.take_back_typing();
        self.end_typing();
    }

    /// Takes back the last step.
    pub fn undo(&mut self) {
        self.typing = None;
        if let Some(before) = self.history.undo(Arc::clone(&self.document)) {
            self.document = before;
            self.changed();
        }
    }

    /// Does again what was undone last.
    pub fn redo(&mut self) {
        self.typing = None;
        if let Some(after) = self.history.redo(Arc::clone(&self.document)) {
            self.document = after;
            self.changed();
        }
    }

    /// The steps that can be undone and done again.
    #[must_use]
    pub const fn history(&self) -> &History {
        &self.history
    }
}
