//! Documents on disk, programs on disk, recovery files, imports and exports.

mod check;
mod document;
mod examples;
pub mod export;
mod folders;
pub mod import;
mod locate;
mod program;
pub mod recovery;
mod roll_set_check;

pub use crate::replace::replace_file;
pub use document::{document_from_text, document_to_text, open_document, save_document};
pub use examples::{Example, examples, examples_of};
pub use folders::{config_folder, data_folder};
pub use program::{assembled, is_program, read_pages, read_program};

use std::path::{Path, PathBuf};

/// The file of a bore's section table beside that of the outside: `NAME.bore.tsv` beside `NAME.tsv`.
fn bore_beside(path: &Path) -> PathBuf {
    let extension = path.extension().map(|e| e.to_string_lossy().into_owned()).unwrap_or_default();
    path.with_extension(format!("bore.{extension}"))
}
