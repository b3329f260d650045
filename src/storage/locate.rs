//! Where a value stands in a JSON text, so that a message about it can name the line.

/// Byte offset of the deepest value along `path` that `text` contains; `path` is keys and list indices (from 0) joined
/// by dots. `text` must be valid JSON; on any other text the answer is some offset within it.
pub(super) fn offset_of(text: &str, path: &str) -> usize {
    let mut reader = Reader { bytes: text.as_bytes(), at: 0 };
    reader.skip_blanks();
    for step in path.split('.') {
        if !reader.enter(step) {
            break;
        }
    }
    reader.at
}

struct Reader<'a> {
    bytes: &'a [u8],
    at: usize,
}

impl Reader<'_> {
    fn peek(&self) -> Option<u8> {
        self.bytes.get(self.at).copied()
    }

    fn skip_blanks(&mut self) {
        while self.peek().is_some_and(|b| b.is_ascii_whitespace() || b == b',' || b == b':') {
            self.at += 1;
        }
    }

    /// Goes to the value of `step` in the object or list that starts here; stays and returns false if there is none.
    fn enter(&mut self, step: &str) -> bool {
        let start = self.at;
        let found = match self.peek() {
            Some(b'{') => self.enter_key(step),
            Some(b'[') => step.parse().is_ok_and(|index| self.enter_index(index)),
            _ => false,
        };
        if !found {
            self.at = start;
        }
        found
    }

    fn enter_key(&mut self, key: &str) -> bool {
        self.at += 1;
        self.skip_blanks();
        while self.peek() == Some(b'"') {
            let start = self.at + 1;
            self.skip_string();
            let name = self.bytes.get(start..self.at.saturating_sub(1));
            self.skip_blanks();
            if name == Some(key.as_bytes()) {
                return true;
            }
            self.skip_value();
            self.skip_blanks();
        }
        false
    }

    fn enter_index(&mut self, index: usize) -> bool {
        self.at += 1;
        self.skip_blanks();
        for _ in 0..index {
            self.skip_value();
            self.skip_blanks();
        }
        !matches!(self.peek(), None | Some(b']'))
    }

    fn skip_value(&mut self) {
        let mut depth = 0_usize;
        loop {
            match self.peek() {
                None => return,
                Some(b'"') => self.skip_string(),
                Some(b'{' | b'[') => {
                    depth += 1;
                    self.at += 1;
                }
                Some(b'}' | b']' | b',') if depth == 0 => return,
                Some(b'}' | b']') => {
                    depth -= 1;
                    self.at += 1;
                }
                Some(_) => self.at += 1,
            }
            if depth == 0 && matches!(self.peek(), None | Some(b',' | b'}' | b']')) {
                return;
            }
        }
    }

    fn skip_string(&mut self) {
        self.at += 1;
        while let Some(byte) = self.peek() {
            self.at += if byte == b'\\' { 2 } else { 1 };
            if byte == b'"' {
                return;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = r#" {"a": "x,}\"", "b" : [ {"c":1}, [2, 3], {"c": {"d":[]}, "e":true} ], "f":null}"#;

    fn at(path: &str) -> &'static str {
        &TEXT[offset_of(TEXT, path)..]
    }

    #[test]
    fn values_are_found() {
        assert!(at("a").starts_with(r#""x,}"#));
        assert!(at("b.0.c").starts_with("1}"));
        assert!(at("b.1.1").starts_with("3]"));
        assert!(at("b.2.e").starts_with("true"));
        assert!(at("b.2.c.d").starts_with("[]}"));
        assert!(at("f").starts_with("null"));
    }

    #[test]
    fn a_missing_value_leads_to_what_should_hold_it() {
        assert!(at("b.0.none").starts_with(r#"{"c":1}"#));
        assert!(at("b.9").starts_with("[ {"));
        assert!(at("none.c").starts_with(r#"{"a""#));
        assert!(at("a.b.c").starts_with(r#""x,}"#));
    }

    #[test]
    fn any_text_ends() {
        for end in 0..TEXT.len() {
            assert!(offset_of(&TEXT[..end], "b.2.c.d") <= end);
        }
    }
}
