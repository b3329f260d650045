//! Writing machines, tools and materials as files of the user's own.

use super::check::{self, Fault};
use super::file::{self, Source};
use super::{Machine, Material, Tool};
use crate::diagnostic::{Diagnostic, Place};
use crate::replace::replace_file;
use crate::textfile::{self, file_place};
use serde::Serialize;
use std::path::{Path, PathBuf};

/// Something that has files of its own: a machine, a tool or a material.
pub trait Item: Serialize + private::Kind {}

impl Item for Machine {}
impl Item for Tool {}
impl Item for Material {}

mod private {
    use super::Fault;

    /// What differs between the kinds of files.
    pub trait Kind {
        /// Folder of the user's files.
        const FOLDER: &'static str;
        /// Key of the list in the file; `None` where the file is the item.
        const LIST: Option<&'static str>;
        /// What tells items apart.
        fn key(&self) -> String;
        /// Everything that cannot be right.
        fn faults(&self) -> Vec<Fault>;
        /// Keys of the items in the text of a file.
        fn keys_in(text: &str) -> Vec<String>;
    }
}

impl private::Kind for Machine {
    const FOLDER: &'static str = "machines";
    const LIST: Option<&'static str> = None;
    fn key(&self) -> String {
        self.id.clone()
    }
    fn faults(&self) -> Vec<Fault> {
        check::machine(self)
    }
    fn keys_in(text: &str) -> Vec<String> {
        file::machines(Source { name: "", text }, &mut Vec::new()).iter().map(|item| item.value.key()).collect()
    }
}

impl private::Kind for Tool {
    const FOLDER: &'static str = "tools";
    const LIST: Option<&'static str> = Some("tool");
    fn key(&self) -> String {
        self.id.clone()
    }
    fn faults(&self) -> Vec<Fault> {
        check::tool(self)
    }
    fn keys_in(text: &str) -> Vec<String> {
        file::tools(Source { name: "", text }, &mut Vec::new()).iter().map(|item| item.value.key()).collect()
    }
}

impl private::Kind for Material {
    const FOLDER: &'static str = "materials";
    const LIST: Option<&'static str> = Some("material");
    fn key(&self) -> String {
        format!("{} {}", self.name.to_lowercase(), self.unit.symbol())
    }
    fn faults(&self) -> Vec<Fault> {
        check::material(self)
    }
    fn keys_in(text: &str) -> Vec<String> {
        file::materials(Source { name: "", text }, &mut Vec::new()).iter().map(|item| item.value.key()).collect()
    }
}

/// Everything that cannot be right in an item, field by field. What it names is looked for when it is loaded.
#[must_use]
pub fn faults<T: Item>(item: &T) -> Vec<Fault> {
    item.faults()
}

/// The text of a file with this item alone, which reads back equal.
#[must_use]
pub fn to_toml<T: Item>(item: &T) -> String {
    let text = match T::LIST {
        None => toml::to_string(item),
        Some(list) => toml::to_string(&std::collections::BTreeMap::from([(list, [item])])),
    };
    // Only maps with keys that are no text cannot be written, and there are none.
    text.unwrap_or_default()
}

/// Saves an item in the user's folder, whole or not at all, and returns its path: the folder `machines`, `tools` or
/// `materials` in `user_dir`, and a file named after the item. A shipped item of the same name is replaced by it from the next
/// loading on.
///
/// # Errors
/// A diagnostic if the item has a mistake, if a file that is read later holds an item of this name too, or if the file cannot
/// be written.
pub fn save_user<T: Item>(user_dir: &Path, item: &T) -> Result<PathBuf, Diagnostic> {
    let folder = user_dir.join(T::FOLDER);
    let path = folder.join(file_name(&item.key()));
    if let Some(fault) = item.faults().first() {
        let message = format!("{}: {} It is not saved.", fault.path, fault.message);
        return Err(Diagnostic::error("machine-data", file_place(&path), message));
    }
    if let Some(other) = later_file_with::<T>(&folder, &path, &item.key()) {
        let message =
            format!("\"{}\" is in this file too, which is read later and would win. It is not saved.", item.key());
        return Err(Diagnostic::error("saved-twice", Place::File { file: other.display().to_string() }, message)
            .with_hint("Take the entry out of this file."));
    }
    std::fs::create_dir_all(&folder).map_err(|e| {
        let message = format!("The folder cannot be made: {e}.");
        Diagnostic::error("save-failed", file_place(&folder), message)
    })?;
    replace_file(&path, to_toml(item).as_bytes())?;
    Ok(path)
}

/// A file of the folder, other than `path` and read after it, that holds an item with this key.
fn later_file_with<T: Item>(folder: &Path, path: &Path, key: &str) -> Option<PathBuf> {
    let entries = std::fs::read_dir(folder).ok()?;
    let mut later: Vec<PathBuf> = entries.filter_map(|e| Some(e.ok()?.path())).filter(|p| p.as_path() > path).collect();
    later.retain(|p| p.extension().is_some_and(|e| e.eq_ignore_ascii_case("toml")));
    later.into_iter().find(|p| {
        let text = textfile::read(p, super::catalog::MOST_BYTES).unwrap_or_default();
        T::keys_in(&text).iter().any(|k| k == key)
    })
}

/// A file name for a key on any system: letters, digits, dots and hyphens.
fn file_name(key: &str) -> String {
    let kept = key.chars().map(|c| if c.is_alphanumeric() || c == '.' || c == '-' { c } else { '-' });
    format!("{}.toml", kept.collect::<String>().trim_matches('.'))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::machine::Catalog;

    #[test]
    fn everything_that_is_shipped_reads_back_equal() {
        let shipped = Catalog::shipped();
        let folder = tempfile::tempdir().unwrap();
        let dir = folder.path();
        shipped.tools.iter().for_each(|t| assert!(save_user(dir, t).is_ok(), "{}", t.id));
        shipped.materials.iter().for_each(|m| assert!(save_user(dir, m).is_ok(), "{}", m.name));
        shipped.machines.iter().for_each(|m| assert!(save_user(dir, m).is_ok(), "{}", m.id));
        let (loaded, diagnostics) = Catalog::load(Some(dir));
        assert_eq!(diagnostics, []);
        assert_eq!(loaded, shipped);
        let files = |name: &str| std::fs::read_dir(dir.join(name)).unwrap().count();
        assert_eq!(files("machines") + files("tools"), shipped.machines.len() + shipped.tools.len());
        assert_eq!(files("materials"), shipped.materials.len());
    }

    #[test]
    fn an_item_with_a_mistake_is_not_saved() {
        let folder = tempfile::tempdir().unwrap();
        let mut tool = Catalog::shipped().tools.remove(0);
        tool.name = String::new();
        let refused = save_user(folder.path(), &tool).unwrap_err();
        assert!(refused.message.contains("name"), "{refused}");
        assert!(!folder.path().join("tools").exists());
    }

    #[test]
    fn an_entry_that_another_file_would_override_is_refused() {
        let folder = tempfile::tempdir().unwrap();
        let tool = Catalog::shipped().tools.remove(0);
        let path = save_user(folder.path(), &tool).unwrap();
        std::fs::rename(&path, path.with_file_name("zzz.toml")).unwrap();
        assert_eq!(save_user(folder.path(), &tool).unwrap_err().code, "saved-twice");
    }

    #[test]
    fn a_folder_that_is_a_file_is_a_diagnostic() {
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join("tools"), "").unwrap();
        let tool = Catalog::shipped().tools.remove(0);
        assert_eq!(save_user(folder.path(), &tool).unwrap_err().code, "save-failed");
    }
}
