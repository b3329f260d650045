//! Comments: what a program says about itself and about its operations.

use super::control::Control;
use super::time::seconds;
use super::writer::Writer;
use crate::machine::Comments;
use crate::post::Header;
use crate::turning::{CutterPath, Operation};

/// Width of a comment where the control names none: a line of a small screen.
const USUAL_WIDTH: usize = 72;

/// The lines at the head of a program of the operations `indices` of `path`.
pub(super) fn header(control: &Control<'_>, header: &Header, path: &CutterPath, indices: &[usize]) -> Vec<String> {
    if control.words.comments == Comments::None {
        return Vec::new();
    }
    let operations = || indices.iter().filter_map(|&i| path.operations.get(i));
    let mut texts = Vec::new();
    for (label, value) in [
        ("PART", &header.part),
        ("MATERIAL", &header.material),
        ("STOCK", &header.stock),
        ("HELD IN", &header.holding),
        ("MACHINE", &control.machine.name),
    ] {
        if !value.trim().is_empty() {
            texts.push(format!("{label} {value}"));
        }
    }
    let mut stations: Vec<u32> = operations().map(|o| o.tool).collect();
    stations.sort_unstable();
    stations.dedup();
    for station in stations {
        let name = header.tools.get(&station).map_or("", String::as_str);
        texts.push(format!("TOOL {station} {name}"));
    }
    texts.push(time_text(control, path, operations()));
    texts.iter().flat_map(|text| comments(control, text)).collect()
}

/// The time with all tool changes, the one to the first tool as well.
fn time_text<'p>(control: &Control<'_>, path: &CutterPath, operations: impl Iterator<Item = &'p Operation>) -> String {
    let (mut total, mut tool) = (0.0, None);
    for operation in operations {
        let changes = tool.replace(operation.tool) != Some(operation.tool);
        total += seconds(operation, path, control.machine) + if changes { control.machine.tool_change_s } else { 0.0 };
    }
    let whole = super::control::rounded(total);
    format!("TIME {} MIN {} S", whole / 60, whole % 60)
}

/// `text` as comments, on as many lines as it needs.
fn comments(control: &Control<'_>, text: &str) -> Vec<String> {
    let width = control.words.max_line_chars.unwrap_or(USUAL_WIDTH).min(USUAL_WIDTH).saturating_sub(2).max(1);
    let plain = plain(text);
    plain.chunks(width).map(|part| format!("({})", part.iter().collect::<String>().trim())).collect()
}

/// The text as every control reads it: a sign of degrees becomes a word.
fn plain(text: &str) -> Vec<char> {
    text.trim().replace('°', " DEG").chars().map(readable).collect()
}

/// The character as every control reads it: capital letters of ISO 646, no parentheses within a comment.
fn readable(c: char) -> char {
    match c {
        '(' | '[' | '{' => '<',
        ')' | ']' | '}' => '>',
        '%' | ';' | '–' | '—' => '-',
        ' '..='~' => c.to_ascii_uppercase(),
        'ä' | 'Ä' | 'å' | 'Å' | 'á' | 'à' | 'â' => 'A',
        'ö' | 'Ö' | 'ø' | 'Ø' | 'ó' | 'ô' => 'O',
        'ü' | 'Ü' | 'ú' | 'û' => 'U',
        'é' | 'è' | 'ê' => 'E',
        '⌀' => 'D',
        '×' => 'X',
        _ => '_',
    }
}

impl Writer<'_> {
    /// Says which operation begins.
    pub(super) fn title(&mut self, index: usize, operation: &Operation) {
        if self.control.words.comments == Comments::None {
            return;
        }
        for comment in comments(self.control, &format!("{} {}", index + 1, operation.name)) {
            self.push_bare(&comment);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn comments_hold_what_every_control_reads() {
        let text = |text: &str| plain(text).into_iter().collect::<String>();
        assert_eq!(text("Ø20 (steel) ⌀; 35° insert"), "O20 <STEEL> D- 35 DEG INSERT");
        assert_eq!(text(" 0.5° "), "0.5 DEG");
    }
}
