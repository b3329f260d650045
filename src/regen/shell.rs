//! A flow-turned shell: former, wall and roller path to programs and proofs.

use super::Derived;
use crate::cancel::{Cancel, Cancelled};
use crate::document::{Document, Shell};
use crate::machine::Catalog;
use std::sync::Arc;

/// Everything that follows from a shell.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ShellDerived {}

/// The stages of a shell.
#[derive(Debug, Default)]
pub(super) struct ShellCache {}

/// Makes everything that follows from `shell`, which is the content of `document`.
pub(super) fn regenerate(
    document: &Arc<Document>,
    _shell: &Shell,
    _catalog: &Catalog,
    _cache: &mut ShellCache,
    cancel: &Cancel,
) -> Result<Derived, Cancelled> {
    cancel.check()?;
    Ok(Derived { shell: Some(Arc::default()), ..Derived::only(document, Vec::new()) })
}
