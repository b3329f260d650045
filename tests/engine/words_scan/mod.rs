//! A scanner of word-address blocks that shares nothing with the program: letters and numbers, comments left out.

pub(crate) mod listing;
pub(crate) mod paths;
pub(crate) mod read;

/// One word.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Word {
    /// Address.
    pub(crate) letter: char,
    /// Its number as it stands.
    pub(crate) number: String,
    /// The number's value.
    pub(crate) value: f64,
}

impl Word {
    /// The word as it stands.
    pub(crate) fn text(&self) -> String {
        format!("{}{}", self.letter, self.number)
    }
}

/// The words of a line; `%` has none.
pub(crate) fn scan(line: &str) -> Vec<Word> {
    let mut words: Vec<Word> = Vec::new();
    let mut in_comment = false;
    for c in line.chars() {
        match c {
            '(' => in_comment = true,
            ')' => in_comment = false,
            _ if in_comment || c.is_whitespace() || c == '%' => {}
            _ if c.is_ascii_uppercase() => words.push(Word { letter: c, number: String::new(), value: f64::NAN }),
            _ => words.last_mut().unwrap_or_else(|| panic!("{line:?} begins with a number")).number.push(c),
        }
    }
    for word in &mut words {
        word.value = word.number.parse().unwrap_or_else(|_| panic!("{word:?} of {line:?} is no number"));
    }
    words
}
