//! Why an instruction cannot be carried out.

use crate::diagnostic::{Diagnostic, Place};

/// A reason, still without the instruction that it belongs to.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Fault {
    /// Short name of the rule, kebab-case.
    pub code: &'static str,
    /// A sentence with the value and the limit.
    pub message: String,
    /// What to do.
    pub hint: &'static str,
}

impl Fault {
    pub(super) fn new(code: &'static str, message: impl Into<String>, hint: &'static str) -> Self {
        Self { code, message: message.into(), hint }
    }

    /// The message about one instruction: `operation` names it, `at` is where it begins.
    pub(super) fn diagnostic(self, operation: &str, at: Place) -> Diagnostic {
        Diagnostic::error(self.code, at, format!("{operation}: {}", self.message)).with_hint(self.hint)
    }
}
