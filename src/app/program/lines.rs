//! The lines of a program with their colours, the current block and the words found.

use crate::app::theme::{self, Colors};
use crate::machine::Dialect;
use crate::post::orac::{self, Instruction, PAGE_START};
use crate::proof::ProgramText;
use crate::proof::reader::words;
use crate::transfer::log::visible;
use egui::text::{LayoutJob, TextFormat};
use egui::{Align2, Color32, FontId, Rect, Response, Sense, Ui, vec2};

/// Height of a line, points.
const LINE: f32 = 19.0;
/// Width of the line numbers, points.
const NUMBERS: f32 = 44.0;

/// The lines of the program that is shown; made anew when the text changes.
#[derive(Default)]
pub(super) struct Lines {
    made_for: Option<(ProgramText, Dialect)>,
    instructions: Vec<Instruction>,
    all_readable: bool,
    /// Every line of the text with the block that it belongs to.
    text: Vec<(String, usize)>,
}

/// How the lines are shown.
pub(super) struct Shown<'a> {
    /// Every character, not one line an instruction.
    pub(super) exact: bool,
    /// The current block.
    pub(super) current: Option<usize>,
    /// Blocks that belong to what the pointer is on.
    pub(super) lit: &'a [usize],
    /// Words that are looked for.
    pub(super) search: &'a str,
}

/// The blocks that the pointer is on and has clicked.
#[derive(Default)]
pub(super) struct Pointed {
    /// Under the pointer.
    pub(super) hovered: Option<usize>,
    /// Just clicked.
    pub(super) clicked: Option<usize>,
}

impl Lines {
    /// Makes the lines of `program` in the language of its control if they are not made yet.
    pub(super) fn follow(&mut self, program: &ProgramText, dialect: Dialect) {
        if self.made_for.as_ref().is_some_and(|(made, of)| made == program && *of == dialect) {
            return;
        }
        self.made_for = Some((program.clone(), dialect));
        match dialect {
            Dialect::Orac => self.follow_pages(program),
            Dialect::Fanuc | Dialect::Linuxcnc => self.follow_words(program, dialect),
        }
    }

    /// A line of words is a block, or none if it is empty.
    fn follow_words(&mut self, program: &ProgramText, dialect: Dialect) {
        self.instructions.clear();
        self.all_readable = false;
        let tape = words::read(&program.text, dialect);
        let mut blocks = tape.blocks.iter().zip(1..).peekable();
        self.text.clear();
        for (line, written) in (1_usize..).zip(program.text.lines()) {
            let block = blocks.peek().filter(|(block, _)| block.line == line).map_or(0, |(_, number)| *number);
            while blocks.next_if(|(block, _)| block.line <= line).is_some() {}
            self.text.push((written.to_owned(), block));
        }
    }

    fn follow_pages(&mut self, program: &ProgramText) {
        let (instructions, complaints) = orac::compress(&program.text, &program.name);
        self.instructions = instructions;
        self.all_readable = complaints.is_empty();
        let mut block = 0;
        self.text.clear();
        for line in program.text.split_inclusive('\n') {
            block += line.chars().filter(|c| *c == PAGE_START).count();
            self.text.push((line.bytes().map(visible).collect(), block));
        }
    }

    /// True if the text is one of words, not of pages.
    pub(super) fn is_of_words(&self) -> bool {
        self.made_for.as_ref().is_some_and(|(_, dialect)| *dialect != Dialect::Orac)
    }

    /// True if every page of the text is an instruction.
    pub(super) const fn are_all_readable(&self) -> bool {
        self.all_readable
    }

    /// Blocks of the program.
    pub(super) fn blocks(&self) -> usize {
        self.text.iter().map(|(_, block)| *block).max().unwrap_or(0)
    }

    /// The first block after `after` with `words` in it, from the front again at the end.
    pub(super) fn find(&self, words: &str, after: usize) -> Option<usize> {
        let words = words.trim().to_lowercase();
        if words.is_empty() {
            return None;
        }
        let in_text =
            self.text.iter().filter(|(line, _)| line.to_lowercase().contains(&words)).map(|(_, block)| *block);
        let summaries = (1..).zip(&self.instructions).filter(|(_, i)| i.summary().to_lowercase().contains(&words));
        let mut found: Vec<usize> = in_text.chain(summaries.map(|(block, _)| block)).filter(|b| *b > 0).collect();
        found.sort_unstable();
        found.iter().find(|block| **block > after).or(found.first()).copied()
    }

    /// Shows the lines, scrolled to the block `reveal`; what the pointer does with them.
    pub(super) fn show(&self, ui: &mut Ui, shown: &Shown<'_>, reveal: Option<usize>) -> Pointed {
        let exact = shown.exact;
        let count = if exact { self.text.len() } else { self.instructions.len() };
        let mut area = egui::ScrollArea::vertical().id_salt("program").auto_shrink([false, false]);
        if let Some(line) = reveal.and_then(|block| self.line_of(block, exact)) {
            area = area.vertical_scroll_offset((line as f32 * LINE - ui.available_height() / 2.0 + LINE).max(0.0));
        }
        ui.spacing_mut().item_spacing.y = 0.0;
        let mut pointed = Pointed::default();
        area.show_rows(ui, LINE, count, |ui, rows| {
            for index in rows {
                let block = if exact { self.text.get(index).map_or(0, |(_, b)| *b) } else { index + 1 };
                let response = self.line(ui, index, block, shown);
                pointed.hovered = pointed.hovered.or((block > 0 && response.hovered()).then_some(block));
                pointed.clicked = pointed.clicked.or((block > 0 && response.clicked()).then_some(block));
            }
        });
        pointed
    }

    fn line_of(&self, block: usize, exact: bool) -> Option<usize> {
        if exact { self.text.iter().position(|(_, b)| *b == block) } else { block.checked_sub(1) }
    }

    fn line(&self, ui: &mut Ui, index: usize, block: usize, shown: &Shown<'_>) -> Response {
        let colors = Colors::of(ui.visuals());
        let (rect, response) = ui.allocate_exact_size(vec2(ui.available_width(), LINE), Sense::click());
        let job = match (shown.exact, self.instructions.get(index), self.text.get(index)) {
            (false, Some(instruction), _) => instruction_job(instruction, colors),
            (true, _, Some((line, _))) if self.is_of_words() => words_job(line, colors),
            (true, _, Some((line, _))) => text_job(line, colors),
            _ => LayoutJob::default(),
        };
        response.widget_info(|| {
            egui::WidgetInfo::labeled(
                egui::Role::ListItem,
                true,
                format!("Line {}: {}", index + 1, job.text.trim_end()),
            )
        });
        let search = shown.search.trim().to_lowercase();
        let found = !search.is_empty() && job.text.to_lowercase().contains(&search);
        let lit = block > 0 && shown.lit.contains(&block);
        let mark = |color| {
            let mark = Rect::from_min_size(rect.min, vec2(3.0, rect.height()));
            ui.painter().rect_filled(mark, 0.0, color);
        };
        if block > 0 && shown.current == Some(block) {
            ui.painter().rect_filled(rect, 2.0, colors.current);
            mark(colors.plot.unreachable);
        } else if lit || found || response.hovered() {
            ui.painter().rect_filled(rect, 2.0, if lit || found { colors.selected } else { colors.hovered });
        }
        if lit {
            mark(colors.plot.accent);
        }
        let number = egui::pos2(rect.left() + NUMBERS - 12.0, rect.center().y);
        let font = FontId::monospace(theme::CODE - 0.5);
        ui.painter().text(number, Align2::RIGHT_CENTER, (index + 1).to_string(), font, colors.plot.construction);
        let galley = ui.painter().layout_job(job);
        let at = egui::pos2(rect.left() + NUMBERS, rect.center().y - galley.size().y / 2.0);
        ui.painter_at(rect).galley(at, galley, colors.plot.text);
        response
    }
}

fn append(job: &mut LayoutJob, text: &str, color: Color32) {
    job.append(text, 0.0, TextFormat::simple(FontId::monospace(theme::CODE), color));
}

/// An instruction in columns: word, positions, feed, tool, speed.
fn instruction_job(instruction: &Instruction, colors: &Colors) -> LayoutJob {
    let mut job = LayoutJob::default();
    let summary = instruction.summary();
    let mut words = summary.split_whitespace();
    append(&mut job, &format!("{:<6}", words.next().unwrap_or_default()), colors.plot.accent);
    let mut words = words.peekable();
    while let Some(word) = words.next() {
        let color = word_color(word, colors);
        let is_address = word.chars().all(char::is_alphabetic);
        let figure = words.next_if(|next| is_address && next.starts_with(|c: char| c == '-' || c.is_ascii_digit()));
        match figure {
            Some(figure) => {
                append(&mut job, &format!("{word} "), color);
                let wide = figure.contains('.');
                let figure = if wide { format!("{figure:>9}   ") } else { format!("{figure:>4}   ") };
                append(&mut job, &figure, if wide { colors.plot.text } else { color });
            }
            None => append(&mut job, &format!("{word}   "), color),
        }
    }
    job
}

fn word_color(word: &str, colors: &Colors) -> Color32 {
    match word.chars().next() {
        Some('F') => colors.good,
        Some('T') => colors.word_tool,
        Some('S') => colors.word_speed,
        _ => colors.plot.text,
    }
}

/// A line of a page: its word in colour, control characters quiet.
fn text_job(line: &str, colors: &Colors) -> LayoutJob {
    let mut job = LayoutJob::default();
    let words = line.find(|c: char| c.is_ascii_alphanumeric()).unwrap_or(line.len());
    let (before, rest) = line.split_at(words);
    append(&mut job, before, colors.plot.construction);
    let end = rest.find(['␍', '␊', '␄']).unwrap_or(rest.len());
    let (content, after) = rest.split_at(end);
    let color = match content.split(|c: char| !c.is_ascii_alphabetic()).next().unwrap_or_default() {
        "PAGE" => colors.plot.accent,
        "FEEDRATE" => colors.good,
        "TOOL" => colors.word_tool,
        "SPINDLE" => colors.word_speed,
        _ => colors.plot.text,
    };
    append(&mut job, content, color);
    append(&mut job, after, colors.plot.construction);
    job
}

/// A line of words: every word in the colour of its letter, comments quiet.
fn words_job(line: &str, colors: &Colors) -> LayoutJob {
    let mut job = LayoutJob::default();
    let (mut depth, mut color) = (0_u32, colors.plot.text);
    let mut letters = [0_u8; 4];
    for c in line.chars() {
        match c {
            '(' => depth += 1,
            ')' => depth = depth.saturating_sub(1),
            'G' | 'M' => color = colors.plot.accent,
            'F' => color = colors.good,
            'T' => color = colors.word_tool,
            'S' => color = colors.word_speed,
            'N' | 'O' | '%' => color = colors.plot.construction,
            c if c.is_ascii_alphabetic() => color = colors.plot.text,
            _ => {}
        }
        let quiet = depth > 0 || c == ')';
        append(&mut job, c.encode_utf8(&mut letters), if quiet { colors.plot.quiet } else { color });
    }
    job
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lines() -> Lines {
        let instructions =
            [Instruction::Inc, Instruction::Ptp { x: -800, z: 0, feed: 80, tool: 1, rpm: 1262 }, Instruction::End];
        let text = orac::pages_text(&instructions);
        let mut lines = Lines::default();
        lines.follow(&ProgramText { name: "QUEEN1".into(), text, edited: false }, Dialect::Orac);
        lines
    }

    #[test]
    fn pages_become_blocks_and_lines() {
        let lines = lines();
        assert!(lines.are_all_readable());
        assert_eq!(lines.blocks(), 3);
        assert_eq!(lines.line_of(2, false), Some(1));
        assert_eq!(lines.line_of(2, true), Some(1));
        assert!(lines.text[1].0.starts_with('␂'));
    }

    #[test]
    fn lines_of_words_are_blocks() {
        let text = "%\nO0001\n\n(A COMMENT)\nN10 G0 X10.\nN20 M30\n%\n".to_owned();
        let mut lines = Lines::default();
        lines.follow(&ProgramText { name: "A".into(), text, edited: false }, Dialect::Fanuc);
        let blocks: Vec<usize> = lines.text.iter().map(|(_, block)| *block).collect();
        assert_eq!(blocks, [1, 2, 0, 3, 4, 5, 6]);
        assert_eq!((lines.blocks(), lines.line_of(5, true), lines.find("m30", 0)), (6, Some(5), Some(5)));
        assert!(!lines.are_all_readable());
    }

    #[test]
    fn a_search_goes_on_and_begins_again() {
        let lines = lines();
        assert_eq!(lines.find("page", 0), Some(1));
        assert_eq!(lines.find("page", 1), Some(2));
        assert_eq!(lines.find("page", 3), Some(1));
        assert_eq!(lines.find("-0.800", 0), Some(2));
        assert_eq!(lines.find("G99", 0), None);
        assert_eq!(lines.find("  ", 0), None);
    }
}
