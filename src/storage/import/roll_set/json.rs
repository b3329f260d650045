//! Looking up fields of the published inputs as JSON, collecting what is wrong with them.

use crate::diagnostic::{Diagnostic, Place, has_errors};
use crate::storage::locate::offset_of;
use crate::textfile::{line_and_column, line_place};
use serde_json::{Map, Value};

/// Largest magnitude of a length, mm, and of an angle, degrees.
pub(super) const MOST: f64 = 100_000.0;

/// A file of published input.
pub(super) struct Reader<'a> {
    file: &'a str,
    text: &'a str,
    diagnostics: Vec<Diagnostic>,
}

/// An object and its place in the file.
#[derive(Clone)]
pub(super) struct Fields<'a> {
    object: &'a Map<String, Value>,
    /// Keys and indices down to it, joined by dots; empty for the whole file.
    path: String,
}

impl Fields<'_> {
    /// Path of a field.
    pub(super) fn path(&self, key: &str) -> String {
        if self.path.is_empty() { key.to_owned() } else { format!("{}.{key}", self.path) }
    }

    /// True if the object has this field.
    pub(super) fn has(&self, key: &str) -> bool {
        self.object.contains_key(key)
    }

    /// The value of a field.
    pub(super) fn get(&self, key: &str) -> Option<&Value> {
        self.object.get(key)
    }
}

impl<'a> Reader<'a> {
    /// A reader of `text`, which is the file `file`.
    pub(super) const fn new(file: &'a str, text: &'a str) -> Self {
        Self { file, text, diagnostics: Vec::new() }
    }

    /// The whole file as JSON.
    pub(super) fn parse(&self) -> Result<Value, Vec<Diagnostic>> {
        serde_json::from_str(self.text).map_err(|error| {
            let at = line_place(self.file, error.line().max(1), Some(error.column().max(1)));
            vec![Diagnostic::error("input-syntax", at, format!("The file is not whole JSON: {error}."))]
        })
    }

    /// The object that the whole file is.
    pub(super) fn root<'v>(&mut self, value: &'v Value) -> Option<Fields<'v>> {
        let object = value.as_object();
        if object.is_none() {
            self.refuse("", "The file is no object with fields.");
        }
        Some(Fields { object: object?, path: String::new() })
    }

    /// The object in a field; reported if there is none.
    pub(super) fn object<'v>(&mut self, fields: &Fields<'v>, key: &str) -> Option<Fields<'v>> {
        let object = fields.object.get(key).and_then(Value::as_object);
        if object.is_none() {
            self.refuse(&fields.path, format!("There is no object `{key}`."));
        }
        Some(Fields { object: object?, path: fields.path(key) })
    }

    /// What was made, or why not.
    pub(super) fn outcome<T>(self, made: Option<T>) -> Result<(T, Vec<Diagnostic>), Vec<Diagnostic>> {
        match made {
            Some(made) if !has_errors(&self.diagnostics) => Ok((made, self.diagnostics)),
            _ => Err(self.diagnostics),
        }
    }

    fn at(&self, path: &str) -> Place {
        let (line, column) = line_and_column(self.text, offset_of(self.text, path));
        line_place(self.file, line, Some(column))
    }

    /// Reports an error at a path.
    pub(super) fn refuse(&mut self, path: &str, message: impl Into<String>) {
        let at = self.at(path);
        self.diagnostics.push(Diagnostic::error("input-value", at, message));
    }

    /// Reports a warning at a path.
    pub(super) fn warn(&mut self, path: &str, message: impl Into<String>) {
        let at = self.at(path);
        self.diagnostics.push(Diagnostic::warning("input-value", at, message));
    }

    /// The objects of a list; reported if there is no list, or something else in it.
    pub(super) fn list<'v>(&mut self, fields: &Fields<'v>, key: &str, most: usize) -> Vec<Fields<'v>> {
        let path = fields.path(key);
        let Some(list) = fields.object.get(key).and_then(Value::as_array) else {
            self.refuse(&fields.path, format!("There is no list `{key}`."));
            return Vec::new();
        };
        if list.len() > most {
            self.refuse(&path, format!("`{key}` has {} entries; the limit is {most}.", list.len()));
            return Vec::new();
        }
        let entries = list.iter().enumerate().filter_map(|(index, entry)| {
            let path = format!("{path}.{index}");
            let object = entry.as_object();
            if object.is_none() {
                self.refuse(&path, format!("Entry {} of `{key}` is no object with fields.", index + 1));
            }
            Some(Fields { object: object?, path })
        });
        entries.collect()
    }

    /// A number between limits.
    pub(super) fn number(&mut self, fields: &Fields<'_>, key: &str, least: f64, most: f64) -> Option<f64> {
        let path = fields.path(key);
        let Some(value) = fields.object.get(key) else {
            self.refuse(&fields.path, format!("The field `{key}` is missing."));
            return None;
        };
        let Some(number) = value.as_f64().filter(|n| n.is_finite()) else {
            self.refuse(&path, format!("`{key}` is {value}; it must be a number."));
            return None;
        };
        if !(least..=most).contains(&number) {
            self.refuse(&path, format!("`{key}` is {number}; it must be {least} to {most}."));
            return None;
        }
        Some(number)
    }

    /// A whole number between limits.
    pub(super) fn whole(&mut self, fields: &Fields<'_>, key: &str, least: i64, most: i64) -> Option<i64> {
        let path = fields.path(key);
        let Some(value) = fields.object.get(key) else {
            self.refuse(&fields.path, format!("The field `{key}` is missing."));
            return None;
        };
        let number = value.as_i64().filter(|n| (least..=most).contains(n));
        if number.is_none() {
            self.refuse(&path, format!("`{key}` is {value}; it must be a whole number from {least} to {most}."));
        }
        number
    }

    /// A length in mm: the field `key_mm`, or `key_in` in inches, from `least` on.
    pub(super) fn length_mm(&mut self, fields: &Fields<'_>, key: &str, least: f64) -> Option<f64> {
        let inches = format!("{key}_in");
        if fields.has(&inches) {
            return self.number(fields, &inches, least, MOST).map(|value| value * 25.4);
        }
        self.number(fields, &format!("{key}_mm"), least, MOST)
    }
}
