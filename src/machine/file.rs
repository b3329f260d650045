//! Reading machine, tool and material files: TOML with the line of every mistake.

use super::check::{self, Fault};
use super::{Machine, Material, Tool};
use crate::diagnostic::Diagnostic;
use crate::textfile::{line_and_column, line_place};
use serde::Deserialize;
use serde::de::DeserializeOwned;
use toml::de::{DeTable, DeValue};

/// An item of a file that passed its checks, with the place of its values.
#[derive(Clone)]
pub(super) struct Item<T> {
    /// The item.
    pub(super) value: T,
    /// Keys from the top of the file down to the item, joined by dots; empty for a file that is one item.
    path: String,
}

/// A file: its name for messages and its text.
#[derive(Clone, Copy)]
pub(super) struct Source<'a> {
    /// Name for messages.
    pub(super) name: &'a str,
    /// The whole text.
    pub(super) text: &'a str,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct ToolFile {
    tool: Vec<Tool>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct MaterialFile {
    material: Vec<Material>,
}

/// The machine of a machine file.
pub(super) fn machines(source: Source<'_>, diagnostics: &mut Vec<Diagnostic>) -> Vec<Item<Machine>> {
    let machine = parse::<Machine>(source, diagnostics).into_iter();
    let items = machine.map(|value| Item { value, path: String::new() }).collect();
    source.sound(items, check::machine, diagnostics)
}

/// The tools of a tool file.
pub(super) fn tools(source: Source<'_>, diagnostics: &mut Vec<Diagnostic>) -> Vec<Item<Tool>> {
    let tools = parse::<ToolFile>(source, diagnostics).map(|f| f.tool).unwrap_or_default();
    source.sound(listed("tool", tools), check::tool, diagnostics)
}

/// The materials of a material file.
pub(super) fn materials(source: Source<'_>, diagnostics: &mut Vec<Diagnostic>) -> Vec<Item<Material>> {
    let materials = parse::<MaterialFile>(source, diagnostics).map(|f| f.material).unwrap_or_default();
    source.sound(listed("material", materials), check::material, diagnostics)
}

fn listed<T>(key: &str, values: Vec<T>) -> Vec<Item<T>> {
    values.into_iter().enumerate().map(|(i, value)| Item { value, path: format!("{key}.{i}") }).collect()
}

fn parse<T: DeserializeOwned>(source: Source<'_>, diagnostics: &mut Vec<Diagnostic>) -> Option<T> {
    toml::from_str(source.text).map_err(|e| diagnostics.push(source.unreadable(&e))).ok()
}

impl Source<'_> {
    /// The items without fault; the faults of the others become diagnostics.
    fn sound<T>(
        self,
        items: Vec<Item<T>>,
        check: impl Fn(&T) -> Vec<Fault>,
        diagnostics: &mut Vec<Diagnostic>,
    ) -> Vec<Item<T>> {
        let mut sound = Vec::new();
        for item in items {
            let faults = check(&item.value);
            if faults.is_empty() {
                sound.push(item);
            } else {
                diagnostics.extend(faults.iter().map(|f| self.fault(&item, f)));
            }
        }
        sound
    }

    /// The diagnostic of a fault in an item of this file.
    pub(super) fn fault<T>(self, item: &Item<T>, fault: &Fault) -> Diagnostic {
        let path = if item.path.is_empty() { fault.path.clone() } else { format!("{}.{}", item.path, fault.path) };
        let (line, column) = line_and_column(self.text, offset_of(self.text, &path));
        let message = format!("{path}: {}", fault.message);
        Diagnostic::error("machine-data", line_place(self.name, line, Some(column)), message)
            .with_hint("The entry is left out until this is corrected.")
    }

    fn unreadable(self, error: &toml::de::Error) -> Diagnostic {
        let offset = error.span().map_or(0, |span| span.start);
        let (line, column) = line_and_column(self.text, offset);
        let written = self.text.lines().nth(line - 1).unwrap_or_default().trim();
        let message = format!("The file cannot be understood here: {}. The line reads `{written}`.", error.message());
        Diagnostic::error("machine-file", line_place(self.name, line, Some(column)), message)
            .with_hint("The whole file is left out until this is corrected.")
    }
}

/// Byte offset of the deepest value along `path` that the file contains.
fn offset_of(text: &str, path: &str) -> usize {
    let Ok(document) = DeTable::parse(text) else { return 0 };
    let mut offset = 0;
    let mut at: Option<&DeValue<'_>> = None;
    for step in path.split('.') {
        let next = match at {
            None => document.get_ref().get(step),
            Some(DeValue::Table(table)) => table.get(step),
            Some(DeValue::Array(array)) => step.parse::<usize>().ok().and_then(|i| array.get(i)),
            Some(_) => None,
        };
        let Some(value) = next else { break };
        offset = value.span().start;
        at = Some(value.get_ref());
    }
    offset
}
