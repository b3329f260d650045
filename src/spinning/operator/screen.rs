//! What the operator sees.

use super::events::Key;

/// Something that the operator can do now.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Choice {
    /// What it is called on a button.
    pub label: &'static str,
    /// The key for it.
    pub key: Key,
}

/// One screen.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Screen {
    /// Where in the sequence.
    pub title: &'static str,
    /// The question or instruction, in large letters.
    pub prompt: String,
    /// What is known so far.
    pub notes: Vec<String>,
    /// What has been typed into the field that is open; `None` without one.
    pub field: Option<String>,
    /// Why the last entry was not taken.
    pub wrong: Option<String>,
    /// What can be done; the first is the obvious next thing.
    pub choices: Vec<Choice>,
}
