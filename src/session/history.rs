//! Undo and redo: a bounded ring of snapshots.

use crate::document::Document;
use std::collections::VecDeque;
use std::sync::Arc;

/// Steps that can be undone. A snapshot is a few kB and shares nothing with the next one.
const STEPS_KEPT: usize = 200;

/// One gesture of the hand: all edits with the same id in a row are one step of undo.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct GestureId(pub u64);

/// Snapshots before and after the present document.
#[derive(Debug, Default)]
pub struct History {
    done: VecDeque<Step>,
    undone: Vec<Step>,
    gesture: Option<GestureId>,
}

#[derive(Debug)]
struct Step {
    label: String,
    document: Arc<Document>,
}

impl History {
    /// Remembers `before`, the document as it was before the edit called `label`.
    pub fn push(&mut self, label: &str, gesture: Option<GestureId>, before: Arc<Document>) {
        self.undone.clear();
        let goes_on = gesture.is_some() && gesture == self.gesture;
        self.gesture = gesture;
        if goes_on {
            if let Some(step) = self.done.back_mut() {
                label.clone_into(&mut step.label);
            }
            return;
        }
        if self.done.len() == STEPS_KEPT {
            self.done.pop_front();
        }
        self.done.push_back(Step { label: label.to_owned(), document: before });
    }

    /// The document before the gesture, which leaves no trace; `None` if it is not the last step.
    pub fn abandon(&mut self, gesture: GestureId) -> Option<Arc<Document>> {
        if self.gesture != Some(gesture) {
            return None;
        }
        self.gesture = None;
        self.done.pop_back().map(|step| step.document)
    }

    /// The document before the last step, in exchange for the present one.
    pub fn undo(&mut self, present: Arc<Document>) -> Option<Arc<Document>> {
        let step = self.done.pop_back()?;
        self.gesture = None;
        self.undone.push(Step { label: step.label, document: present });
        Some(step.document)
    }

    /// The document after the step undone last, in exchange for the present one.
    pub fn redo(&mut self, present: Arc<Document>) -> Option<Arc<Document>> {
        let step = self.undone.pop()?;
        self.gesture = None;
        self.done.push_back(Step { label: step.label, document: present });
        Some(step.document)
    }

    /// What would be undone.
    #[must_use]
    pub fn undo_label(&self) -> Option<&str> {
        self.done.back().map(|step| step.label.as_str())
    }

    /// What would be done again.
    #[must_use]
    pub fn redo_label(&self) -> Option<&str> {
        self.undone.last().map(|step| step.label.as_str())
    }
}
