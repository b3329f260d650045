//! What the data editor edits: a machine, a tool or a material, as a value of fields.

use super::field::{Group, Table};
use super::{machine_form, material_form, tool_form};
use crate::diagnostic::Diagnostic;
use crate::machine::{Catalog, Fault, Machine, Material, Tool, faults, save_user};
use serde_json::Value;
use std::path::{Path, PathBuf};

/// Kinds of data.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// Tools.
    Tools,
    /// Machines.
    Machines,
    /// Materials.
    Materials,
}

/// An item that can be saved.
#[derive(Debug, Clone, PartialEq)]
pub enum Entry {
    /// A tool.
    Tool(Tool),
    /// A machine.
    Machine(Box<Machine>),
    /// A material.
    Material(Material),
}

impl Kind {
    pub(super) const ALL: [Self; 3] = [Self::Tools, Self::Machines, Self::Materials];

    pub(super) const fn title(self) -> &'static str {
        match self {
            Self::Tools => "Tools",
            Self::Machines => "Machines",
            Self::Materials => "Materials",
        }
    }

    /// Every item of this kind: what it is called in lists, and its fields.
    pub(super) fn items(self, catalog: &Catalog) -> Vec<(String, Value)> {
        let value = |item: serde_json::Result<Value>| item.unwrap_or_default();
        match self {
            Self::Tools => catalog.tools.iter().map(|t| (t.id.clone(), value(serde_json::to_value(t)))).collect(),
            Self::Machines => catalog.machines.iter().map(|m| (m.id.clone(), value(serde_json::to_value(m)))).collect(),
            Self::Materials => {
                let name = |m: &Material| format!("{} · {}", m.name.to_lowercase(), m.unit.symbol());
                catalog.materials.iter().map(|m| (name(m), value(serde_json::to_value(m)))).collect()
            }
        }
    }

    /// An item to go on from; a machine begins as a copy of another.
    pub(super) fn fresh(self) -> Option<Value> {
        match self {
            Self::Tools => Some(tool_form::fresh()),
            Self::Materials => Some(material_form::fresh()),
            Self::Machines => None,
        }
    }

    /// The field that tells items apart.
    pub(super) const fn key(self) -> &'static str {
        match self {
            Self::Tools | Self::Machines => "id",
            Self::Materials => "name",
        }
    }

    /// The fields of an item as it is now.
    pub(super) fn groups(self, item: &Value) -> Vec<Group> {
        match self {
            Self::Tools => tool_form::groups(item),
            Self::Machines => machine_form::groups(item),
            Self::Materials => material_form::GROUPS.to_vec(),
        }
    }

    /// The list in an item, if it has one.
    pub(super) const fn table(self) -> Option<Table> {
        match self {
            Self::Tools => None,
            Self::Machines => Some(machine_form::TURRET),
            Self::Materials => Some(material_form::CUTTING),
        }
    }

    /// The item that these fields make.
    ///
    /// # Errors
    /// A sentence why they make none.
    pub(super) fn read(self, item: &Value) -> Result<Entry, String> {
        let item = item.clone();
        let entry = match self {
            Self::Tools => serde_json::from_value(item).map(Entry::Tool),
            Self::Machines => serde_json::from_value(item).map(|machine| Entry::Machine(Box::new(machine))),
            Self::Materials => serde_json::from_value(item).map(Entry::Material),
        };
        entry.map_err(|reason| format!("The fields do not fit together: {reason}."))
    }
}

impl Entry {
    /// Everything that cannot be right, field by field.
    pub(super) fn faults(&self, catalog: &Catalog) -> Vec<Fault> {
        match self {
            Self::Tool(tool) => faults(tool),
            Self::Material(material) => faults(material),
            Self::Machine(machine) => {
                let mut all = faults(machine.as_ref());
                let unknown = machine.tools.iter().enumerate().filter(|(_, t)| catalog.tool(&t.tool).is_none());
                all.extend(unknown.map(|(index, t)| Fault {
                    path: format!("tools.{index}.tool"),
                    message: format!("There is no tool “{}”.", t.tool),
                }));
                all
            }
        }
    }

    /// Saves it among the user's own.
    ///
    /// # Errors
    /// Why it cannot be saved.
    pub(crate) fn save(&self, folder: &Path) -> Result<PathBuf, Diagnostic> {
        match self {
            Self::Tool(tool) => save_user(folder, tool),
            Self::Machine(machine) => save_user(folder, machine.as_ref()),
            Self::Material(material) => save_user(folder, material),
        }
    }
}
