//! Fields of data editors: where a value stands, what it is called, and how it is typed.

use serde_json::{Number, Value};

/// One value of an item.
#[derive(Debug, Clone, Copy)]
pub(super) struct Field {
    /// Keys from the item down to the value, joined by dots, as in messages.
    pub(super) path: &'static str,
    /// What it is called.
    pub(super) label: &'static str,
    /// Unit, for people.
    pub(super) unit: &'static str,
    /// What it is.
    pub(super) is: Is,
}

/// What a value is.
#[derive(Debug, Clone, Copy)]
pub(super) enum Is {
    /// A text.
    Text,
    /// A figure.
    Figure,
    /// A figure, or nothing.
    MaybeFigure,
    /// A whole figure.
    Whole,
    /// A whole figure, or nothing.
    MaybeWhole,
    /// True or false.
    YesNo,
    /// One of some words, with what they are called.
    OneOf(&'static [(&'static str, &'static str)]),
    /// A list of rows with this many figures each.
    Rows(usize),
}

/// A figure.
pub(super) const fn figure(path: &'static str, label: &'static str, unit: &'static str) -> Field {
    Field { path, label, unit, is: Is::Figure }
}

/// A figure that may be missing.
pub(super) const fn maybe(path: &'static str, label: &'static str, unit: &'static str) -> Field {
    Field { path, label, unit, is: Is::MaybeFigure }
}

/// Anything without a unit.
pub(super) const fn plain(path: &'static str, label: &'static str, is: Is) -> Field {
    Field { path, label, unit: "", is }
}

/// Where a group that may be missing stands, and what it is at first.
pub(super) type Optional = (&'static str, fn() -> Value);

/// Fields under one heading.
#[derive(Debug, Clone, Copy)]
pub(super) struct Group {
    /// The heading; empty for fields that need none.
    pub(super) title: &'static str,
    /// Set if the group as a whole may be missing.
    pub(super) optional: Option<Optional>,
    /// Its fields.
    pub(super) fields: &'static [Field],
}

/// A list of equal entries, one a row.
#[derive(Debug, Clone, Copy)]
pub(super) struct Table {
    /// The heading.
    pub(super) title: &'static str,
    /// Where the list stands.
    pub(super) path: &'static str,
    /// Columns; their paths count from the entry.
    pub(super) columns: &'static [Field],
    /// A new entry.
    pub(super) fresh: fn() -> Value,
}

/// The value at a path.
pub(super) fn get<'a>(item: &'a Value, path: &str) -> Option<&'a Value> {
    path.split('.').try_fold(item, |value, key| match value {
        Value::Array(list) => list.get(key.parse::<usize>().ok()?),
        other => other.get(key),
    })
}

/// Puts a value at a path whose parent is there; nothing happens otherwise.
pub(super) fn set(item: &mut Value, path: &str, value: Value) {
    let (parent, key) = path.rsplit_once('.').map_or((None, path), |(parent, key)| (Some(parent), key));
    let keys = parent.into_iter().flat_map(|parent| parent.split('.'));
    let mut at = item;
    for key in keys {
        let next = match at {
            Value::Array(list) => key.parse::<usize>().ok().and_then(|index| list.get_mut(index)),
            other => other.get_mut(key),
        };
        let Some(next) = next else { return };
        at = next;
    }
    match at {
        Value::Object(map) => _ = map.insert(key.to_owned(), value),
        Value::Array(list) => {
            if let Some(place) = key.parse::<usize>().ok().and_then(|index| list.get_mut(index)) {
                *place = value;
            }
        }
        _ => {}
    }
}

/// A figure as JSON; `None` if it is not finite.
pub(super) fn number(value: f64) -> Option<Value> {
    Number::from_f64(value).map(Value::Number)
}

/// A value as a person reads it in a field.
pub(super) fn text(value: Option<&Value>) -> String {
    match value {
        Some(Value::String(text)) => text.clone(),
        Some(Value::Number(number)) => {
            let text = number.to_string();
            text.strip_suffix(".0").map_or(text.clone(), str::to_owned)
        }
        Some(Value::Bool(yes)) => if *yes { "yes" } else { "no" }.to_owned(),
        Some(Value::Array(rows)) => rows.iter().map(row).collect::<Vec<_>>().join("\n"),
        _ => String::new(),
    }
}

fn row(row: &Value) -> String {
    let figures = row.as_array().into_iter().flatten();
    figures.map(|figure| text(Some(figure))).collect::<Vec<_>>().join("  ")
}

/// Reads rows of `per_row` figures, one row a line.
///
/// # Errors
/// A sentence that names the line.
pub(super) fn read_rows(text: &str, per_row: usize) -> Result<Value, String> {
    let mut rows = Vec::new();
    for (line, written) in (1_usize..).zip(text.lines()).filter(|(_, written)| !written.trim().is_empty()) {
        let words = written.split(|c: char| c.is_whitespace() || c == ';' || c == ',').filter(|w| !w.is_empty());
        let figures: Option<Vec<Value>> = words.map(|w| w.parse().ok().and_then(number)).collect();
        match figures {
            Some(figures) if figures.len() == per_row => rows.push(Value::Array(figures)),
            _ => return Err(format!("Line {line} is “{}”; it must be {per_row} figures.", written.trim())),
        }
    }
    Ok(Value::Array(rows))
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn values_are_read_and_written_by_path() {
        let mut item = json!({"shape": {"nose_radius": 0.8}, "tools": [{"station": 1}, {"station": 2}]});
        assert_eq!(get(&item, "shape.nose_radius"), Some(&json!(0.8)));
        assert_eq!(get(&item, "tools.1.station"), Some(&json!(2)));
        set(&mut item, "tools.1.station", json!(7));
        set(&mut item, "shape.hand", json!("left"));
        set(&mut item, "nowhere.at.all", json!(1));
        assert_eq!(
            item,
            json!({"shape": {"nose_radius": 0.8, "hand": "left"}, "tools": [{"station": 1}, {"station": 7}]})
        );
    }

    #[test]
    fn rows_survive_their_text() {
        let rows = json!([[0.5, 2.0], [-1.25, 3.0]]);
        assert_eq!(text(Some(&rows)), "0.5  2\n-1.25  3");
        assert_eq!(read_rows(&text(Some(&rows)), 2), Ok(rows));
        assert_eq!(read_rows("1 2\n\n3;4", 2), Ok(json!([[1.0, 2.0], [3.0, 4.0]])));
        assert!(read_rows("1 2\n3", 2).is_err_and(|e| e.contains("Line 2")));
        assert!(read_rows("1 inf", 2).is_err());
    }
}
