//! From text to blocks of words.

use super::super::{Trouble, shown};
use super::{Flow, Number, Tape, Word, WordBlock};
use crate::machine::Dialect;

/// Characters of a tape's leader and of the device codes of a serial line; they are no part of the program.
const NO_TEXT: [char; 7] = ['\0', '\u{11}', '\u{12}', '\u{13}', '\u{14}', '\u{7f}', '\u{feff}'];

/// Reads a program of letters and numbers.
#[must_use]
pub fn read(text: &str, dialect: Dialect) -> Tape {
    let mut reading = Reading { tape: Tape::default(), dialect, line: 0, over: false };
    // Line feeds part the blocks of all but some old texts, which have carriage returns alone.
    let parted_by = if text.contains('\n') { '\n' } else { '\r' };
    for (index, line) in text.split(parted_by).enumerate() {
        reading.line = index + 1;
        reading.take_line(line.trim_matches(|c: char| c.is_whitespace() || NO_TEXT.contains(&c)));
    }
    reading.tape
}

struct Reading {
    tape: Tape,
    dialect: Dialect,
    line: usize,
    /// The closing `%` has passed.
    over: bool,
}

impl Reading {
    fn trouble(&mut self, message: String) {
        let block = self.tape.blocks.len().max(1);
        self.tape.troubles.push(Trouble { block, line: self.line, message });
    }

    fn take_line(&mut self, line: &str) {
        if line.is_empty() {
            return;
        }
        let Some(rest) = line.strip_prefix('%') else {
            // `;` ends a block on Fanuc controls and begins a comment on LinuxCNC.
            if self.dialect == Dialect::Linuxcnc {
                self.take_block(line.split(';').next().unwrap_or(""));
            } else {
                self.take_parts(line.strip_suffix(';').unwrap_or(line));
            }
            return;
        };
        self.begin_block();
        let rest = rest.trim_matches(|c: char| c.is_whitespace() || c == ';');
        if !rest.is_empty() {
            self.trouble(format!("\"{}\" stands behind the tape mark %.", shown(rest)));
        }
        let empty = self.tape.blocks.iter().all(|block| block.words.is_empty());
        if empty && !self.tape.opened {
            self.tape.opened = true;
        } else {
            self.tape.closed = true;
            self.over = true;
        }
    }

    fn begin_block(&mut self) {
        self.tape.blocks.push(WordBlock { line: self.line, ..WordBlock::default() });
    }

    /// Parts a line at the `;` that stand outside comments.
    fn take_parts(&mut self, line: &str) {
        let (mut depth, mut from) = (0_usize, 0);
        for (at, c) in line.char_indices() {
            match c {
                '(' => depth += 1,
                ')' => depth = depth.saturating_sub(1),
                ';' if depth == 0 => {
                    self.take_block(&line[from..at]);
                    from = at + 1;
                }
                _ => {}
            }
        }
        self.take_block(&line[from..]);
    }

    fn take_block(&mut self, text: &str) {
        self.begin_block();
        let text = self.without_comments(text);
        let text = text.trim();
        if text.is_empty() {
            return;
        }
        if self.over {
            return self.trouble(format!("\"{}\" stands behind the closing tape mark % and is not run.", shown(text)));
        }
        let (text, optional) = text.strip_prefix('/').map_or((text, false), |rest| (rest.trim_start(), true));
        self.tape.blocks.iter_mut().last().into_iter().for_each(|block| block.optional = optional);
        if self.dialect == Dialect::Linuxcnc && text.starts_with(['o', 'O']) {
            self.flow(text);
        } else {
            self.words(text);
        }
    }

    /// The text outside parentheses.
    fn without_comments(&mut self, text: &str) -> String {
        let (mut depth, mut kept) = (0_usize, String::with_capacity(text.len()));
        for c in text.chars() {
            match c {
                '(' => depth += 1,
                ')' if depth > 0 => depth -= 1,
                ')' => self.trouble("A comment is closed that was not opened.".to_owned()),
                c if depth == 0 => kept.push(c),
                _ => {}
            }
        }
        if depth > 0 {
            self.trouble("The comment is not closed.".to_owned());
        }
        kept
    }

    fn words(&mut self, text: &str) {
        let mut rest = text.chars().filter(|c| !c.is_whitespace()).peekable();
        while let Some(c) = rest.next() {
            let letter = c.to_ascii_uppercase();
            let mut number = String::new();
            while let Some(c) = rest.next_if(|c| !c.is_ascii_alphabetic()) {
                number.push(c);
            }
            // A colon stands for O on tapes in ISO code.
            match if letter == ':' { 'O' } else { letter } {
                'A'..='Z' | ':' => self.word(if letter == ':' { 'O' } else { letter }, &number),
                _ => self.trouble(format!("\"{}\" is not a word.", shown(&format!("{c}{number}")))),
            }
        }
    }

    fn word(&mut self, letter: char, text: &str) {
        let Some(number) = Number::parse(text) else {
            let why =
                if text.contains(['#', '[', '=']) { "; parameters and expressions are not computed here" } else { "" };
            return self
                .trouble(format!("\"{}\" is not a word with a number{why}.", shown(&format!("{letter}{text}"))));
        };
        let twice = letter != 'G' && letter != 'M';
        let Some(block) = self.tape.blocks.last_mut() else { return };
        if letter == 'N' {
            if block.printed.is_some() || !block.words.is_empty() {
                return self.trouble(format!("N{text} does not stand at the beginning of its block."));
            }
            let Some(n) = number.whole() else {
                return self.trouble(format!("N{text} is not a whole number from 0 up."));
            };
            block.printed = Some(n);
        } else if twice && block.has(letter) {
            self.trouble(format!("{letter} is given twice in one block."));
        } else {
            block.words.push(Word { letter, number });
        }
    }

    /// `O100 sub`, `O<name> call`.
    fn flow(&mut self, text: &str) {
        let text: String = text[1..].trim_start().to_ascii_lowercase();
        let named = text.strip_prefix('<').and_then(|t| t.split_once('>'));
        let (name, rest) = named.unwrap_or_else(|| {
            let rest = text.trim_start_matches(|c: char| c.is_ascii_digit());
            text.split_at(text.len() - rest.len())
        });
        let name = name.to_owned();
        let rest = rest.trim();
        let flow = match rest {
            _ if name.is_empty() => None,
            "sub" => Some(Flow::Sub(name)),
            "endsub" => Some(Flow::EndSub(name)),
            "return" => Some(Flow::Return(name)),
            "call" => Some(Flow::Call(name)),
            _ => None,
        };
        match flow {
            Some(flow) => {
                self.tape.blocks.iter_mut().last().into_iter().for_each(|block| block.flow = Some(flow.clone()));
            }
            None => self.trouble(format!(
                "\"O{}\" is not followed: of LinuxCNC's O words sub, endsub, return and call without arguments are.",
                shown(&text)
            )),
        }
    }
}
