//! The log of a transfer: one line each, control characters by their names, the whole line on hover.

use crate::app::theme::Colors;
use crate::transfer::log::{Direction, LogLine};
use egui::text::{LayoutJob, TextFormat, TextWrapping};
use egui::{Color32, FontId, Sense, Ui, vec2};
use std::collections::VecDeque;

/// Height of one line, points.
const LINE: f32 = 16.0;
/// Size of the characters, points.
const TEXT: f32 = 10.5;
/// Size of the names of control characters, points.
const NAME: f32 = 8.5;
/// Room beside the name of a control character, points.
const BESIDE: f32 = 3.0;
/// Widest line of the text shown on hover, points.
const WIDEST: f32 = 560.0;
/// Names of the control characters 0 to 31 in ASCII.
const NAMES: [&str; 32] = [
    "NUL", "SOH", "STX", "ETX", "EOT", "ENQ", "ACK", "BEL", "BS", "HT", "LF", "VT", "FF", "CR", "SO", "SI", "DLE",
    "DC1", "DC2", "DC3", "DC4", "NAK", "SYN", "ETB", "CAN", "EM", "SUB", "ESC", "FS", "GS", "RS", "US",
];

/// Shows the lines, the newest at the foot.
pub(super) fn show(ui: &mut Ui, lines: &VecDeque<LogLine>) {
    if lines.is_empty() {
        return;
    }
    let colors = Colors::of(ui.visuals());
    egui::Frame::new().fill(colors.inset).corner_radius(6).inner_margin(egui::Margin::same(8)).show(ui, |ui| {
        ui.spacing_mut().item_spacing.y = 0.0;
        let area = egui::ScrollArea::vertical().id_salt("log").auto_shrink([false, false]).stick_to_bottom(true);
        area.show_rows(ui, LINE, lines.len(), |ui, rows| {
            lines.range(rows).for_each(|line| show_line(ui, line, colors));
        });
    });
}

fn show_line(ui: &mut Ui, line: &LogLine, colors: &Colors) {
    let mut job = job(line, colors.plot.quiet, colors.plot.accent);
    job.wrap = TextWrapping::truncate_at_width(ui.available_width());
    let whole = job.text.clone();
    let (rect, response) = ui.allocate_exact_size(vec2(ui.available_width(), LINE), Sense::hover());
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Label, true, &whole));
    let galley = ui.painter().layout_job(job);
    let cut_short = galley.elided;
    ui.painter().galley(rect.min, galley, colors.plot.quiet);
    if cut_short {
        response.on_hover_ui(|ui| {
            ui.set_max_width(WIDEST);
            ui.label(self::job(line, colors.plot.text, colors.plot.accent));
        });
    }
}

/// A line with its time and direction; control characters are names in `accent`.
fn job(line: &LogLine, color: Color32, accent: Color32) -> LayoutJob {
    let arrow = match line.direction {
        Direction::Sent => "→",
        Direction::Received => "←",
        Direction::Note => "·",
    };
    let seconds = line.at.as_secs_f64();
    let head = format!("{}:{:04.1} {arrow} ", (seconds / 60.0).floor(), seconds % 60.0);
    let plain = TextFormat::simple(FontId::monospace(TEXT), color);
    let mut job = LayoutJob::single_section(head, plain.clone());
    job.break_on_newline = false;
    let mut room: f32 = 0.0;
    for (name, text) in parts(&line.text) {
        if let Some(name) = name {
            job.append(name, room.max(BESIDE), TextFormat::simple(FontId::monospace(NAME), accent));
            room = BESIDE;
        }
        if !text.is_empty() {
            job.append(text, room, plain.clone());
            room = 0.0;
        }
    }
    job
}

/// The name of a control character, if the part begins with one, and the text after it.
fn parts(text: &str) -> Vec<(Option<&'static str>, &str)> {
    let mut parts = Vec::new();
    let (mut name, mut rest) = (None, text);
    loop {
        let next = rest.char_indices().find_map(|(at, c)| Some((at, c, name_of(c)?)));
        let Some((at, picture, found)) = next else {
            parts.push((name, rest));
            return parts;
        };
        let (before, after) = rest.split_at(at);
        if name.is_some() || !before.is_empty() {
            parts.push((name, before));
        }
        (name, rest) = (Some(found), after.get(picture.len_utf8()..).unwrap_or_default());
    }
}

/// The name of the control character that `picture` stands for.
fn name_of(picture: char) -> Option<&'static str> {
    match u32::from(picture).checked_sub(0x2400)? {
        0x21 => Some("DEL"),
        code => NAMES.get(usize::try_from(code).ok()?).copied(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::time::Duration;

    #[test]
    fn control_characters_are_named() {
        let found = parts("␂PAGE 01␍␊");
        assert_eq!(found, [(Some("STX"), "PAGE 01"), (Some("CR"), ""), (Some("LF"), "")]);
        assert_eq!(parts("a␡␄"), [(None, "a"), (Some("DEL"), ""), (Some("EOT"), "")]);
        assert_eq!(parts("plain"), [(None, "plain")]);
    }

    #[test]
    fn a_line_says_when_and_which_way() {
        let line = LogLine { at: Duration::from_millis(62_300), direction: Direction::Sent, text: "X␍".to_owned() };
        assert_eq!(job(&line, Color32::BLACK, Color32::BLUE).text, "1:02.3 → XCR");
    }
}
