//! From operations to programs that the control's memory holds.

use super::block::{Block, Fault};
use super::comments;
use super::control::Control;
use super::writer::Writer;
use crate::diagnostic::{Diagnostic, Place};
use crate::post::{BlockInfo, Header, Program};
use crate::turning::CutterPath;

/// Messages about the blocks of one program; more of them say nothing new.
const MOST_MESSAGES: usize = 20;

/// Programs of a path, and what is to be said about their blocks.
pub(super) struct Divided {
    pub(super) programs: Vec<Program>,
    pub(super) diagnostics: Vec<Diagnostic>,
}

/// The operations of `path` as programs: one, one for each operation if asked, or as many as the memory needs.
pub(super) fn divided(name: &str, path: &CutterPath, control: &Control<'_>, header: &Header) -> Divided {
    let written = written(path, control, header);
    let several = written.len() > 1;
    let mut all = Divided { programs: Vec::new(), diagnostics: Vec::new() };
    for (number, (blocks, indices)) in (1..).zip(&written) {
        let name = if several { format!("{name}-{number}") } else { name.to_owned() };
        all.diagnostics.extend(said(&name, blocks));
        all.diagnostics.extend(too_long(&name, blocks, indices, control, path));
        all.programs.push(program(name, blocks, control, path));
    }
    all
}

/// Blocks of each program with the indices of its operations.
fn written(path: &CutterPath, control: &Control<'_>, header: &Header) -> Vec<(Vec<Block>, Vec<usize>)> {
    let mut divider = Divider { path, control, header, done: Vec::new() };
    let mut writer: Option<Writer<'_>> = None;
    let mut indices: Vec<usize> = Vec::new();
    for (index, operation) in path.operations.iter().enumerate().filter(|(_, o)| !o.moves.is_empty()) {
        if let Some(open) = &mut writer {
            let mark = open.mark();
            if !control.options.separate_programs {
                open.between();
                open.operation(index, operation, path);
                indices.push(index);
                if divider.fits(open, &indices) {
                    continue;
                }
                indices.pop();
                open.back_to(mark);
            }
            divider.close(writer.take(), std::mem::take(&mut indices));
        }
        let mut fresh = Writer::new(control);
        fresh.begin(operation.change.unwrap_or(path.datum));
        fresh.operation(index, operation, path);
        indices.push(index);
        writer = Some(fresh);
    }
    divider.close(writer, indices);
    divider.done
}

struct Divider<'a> {
    path: &'a CutterPath,
    control: &'a Control<'a>,
    header: &'a Header,
    done: Vec<(Vec<Block>, Vec<usize>)>,
}

impl Divider<'_> {
    /// True if the memory holds the program with its head and its end.
    fn fits(&self, writer: &Writer<'_>, indices: &[usize]) -> bool {
        let mut whole = writer.clone();
        whole.end();
        let head = self.head(indices);
        let chars = whole.chars + head.iter().map(|line| line.len() + self.end_chars()).sum::<usize>();
        let words = self.control.words;
        let tape = usize::from(words.tape_marks) * (2 + 2 * self.end_chars());
        whole.blocks.len() + head.len() <= self.control.machine.limits.blocks_per_program
            && words.max_program_chars.is_none_or(|most| chars + tape <= most)
    }

    fn end_chars(&self) -> usize {
        self.control.words.block_end.chars().count()
    }

    /// Program number and comments.
    fn head(&self, indices: &[usize]) -> Vec<String> {
        let number = self.control.words.program_number.as_ref().map(|word| {
            let first = self.control.options.program_number.unwrap_or(word.first);
            let number = first.saturating_add(u32::try_from(self.done.len()).unwrap_or(u32::MAX));
            format!("{}{number:0>width$}", word.prefix, width = usize::from(word.digits))
        });
        let comments = comments::header(self.control, self.header, self.path, indices);
        number.into_iter().chain(comments).collect()
    }

    fn close(&mut self, writer: Option<Writer<'_>>, indices: Vec<usize>) {
        let Some(mut writer) = writer else { return };
        writer.end();
        let bare = |text: String| Block { text, ..Block::default() };
        let mark = self.control.words.tape_marks.then(|| bare("%".to_owned()));
        let head = self.head(&indices).into_iter().map(bare);
        let blocks = mark.clone().into_iter().chain(head).chain(writer.blocks).chain(mark).collect();
        self.done.push((blocks, indices));
    }
}

fn program(name: String, blocks: &[Block], control: &Control<'_>, path: &CutterPath) -> Program {
    let end = &control.words.block_end;
    let text: String = blocks.iter().flat_map(|b| [b.text.as_str(), end.as_str()]).collect();
    let infos = (1..).zip(blocks).map(|(line, b)| BlockInfo {
        summary: b.summary(),
        operation: b.operation.and_then(|i| path.operations.get(i)).map(|o| o.kind),
        operation_index: b.operation,
        line,
        lines: 1,
    });
    Program { name, extension: control.words.extension.clone(), blocks: infos.collect(), text }
}

fn said(name: &str, blocks: &[Block]) -> Vec<Diagnostic> {
    let faults = (1..).zip(blocks).flat_map(|(k, b)| b.faults.iter().map(move |fault| (k, fault)));
    let place = |block| Place::Block { program: name.to_owned(), block };
    let message = |(k, fault): (usize, &Fault)| {
        Diagnostic::new(fault.severity, fault.code, place(k), fault.message.clone()).with_hint(fault.hint)
    };
    faults.take(MOST_MESSAGES).map(message).collect()
}

/// An operation that alone is longer than the control's memory.
fn too_long(
    name: &str,
    blocks: &[Block],
    indices: &[usize],
    control: &Control<'_>,
    path: &CutterPath,
) -> Option<Diagnostic> {
    let most_blocks = control.machine.limits.blocks_per_program;
    let chars: usize = blocks.iter().map(|b| b.text.chars().count() + control.words.block_end.chars().count()).sum();
    let (measured, most, what) = if blocks.len() > most_blocks {
        (blocks.len(), most_blocks, "blocks")
    } else {
        (chars, control.words.max_program_chars.filter(|&most| chars > most)?, "characters")
    };
    let operation = indices.first().and_then(|&i| path.operations.get(i)).map_or("", |o| o.name.as_str());
    let message =
        format!("\"{operation}\" alone has {measured} {what}; {} holds {most} in one program.", control.machine.name);
    let at = Place::Block { program: name.to_owned(), block: blocks.len() };
    Some(
        Diagnostic::error("program-too-long", at, message)
            .with_hint("Take larger depths of cut, or run the program from the tape or over the wire."),
    )
}
