//! Reading a text file: every way in which it can fail becomes a diagnostic.

use crate::diagnostic::{Diagnostic, Place};
use std::fs::File;
use std::io::Read;
use std::path::Path;

/// Reads a UTF-8 file of at most `most_bytes` bytes; a byte order mark at its start is dropped.
///
/// # Errors
/// A diagnostic that names the file (and the line of a byte that is not UTF-8) if it cannot be opened or read, is not a
/// regular file, is longer than `most_bytes`, or is not UTF-8.
pub fn read(path: &Path, most_bytes: u64) -> Result<String, Diagnostic> {
    let bytes = read_bytes(path, most_bytes)?;
    let text = String::from_utf8(bytes).map_err(|e| not_utf8(path, e.as_bytes(), e.utf8_error().valid_up_to()))?;
    Ok(text.strip_prefix('\u{feff}').map(str::to_owned).unwrap_or(text))
}

/// Reads a regular file of at most `most_bytes` bytes.
///
/// # Errors
/// As [`read`], for any bytes.
pub fn read_bytes(path: &Path, most_bytes: u64) -> Result<Vec<u8>, Diagnostic> {
    let cannot_read = |e: std::io::Error| {
        Diagnostic::error("file-unreadable", file_place(path), format!("The file cannot be read: {e}."))
    };
    // Asked before opening: opening a pipe would wait for its other end.
    if !std::fs::metadata(path).map_err(cannot_read)?.is_file() {
        let message = "This is not a regular file but a folder or a device.";
        return Err(Diagnostic::error("not-a-file", file_place(path), message));
    }
    let mut bytes = Vec::new();
    let file = File::open(path).map_err(cannot_read)?;
    file.take(most_bytes.saturating_add(1)).read_to_end(&mut bytes).map_err(cannot_read)?;
    if u64::try_from(bytes.len()).is_ok_and(|len| len <= most_bytes) {
        return Ok(bytes);
    }
    let message = format!("The file is longer than {most_bytes} bytes, the limit for its kind.");
    Err(Diagnostic::error("file-too-long", file_place(path), message))
}

/// The place of a file as a whole.
#[must_use]
pub fn file_place(path: &Path) -> Place {
    Place::File { file: path.display().to_string() }
}

/// The place of a line of a file; lines and columns count from 1.
#[must_use]
pub fn line_place(file: &str, line: usize, column: Option<usize>) -> Place {
    Place::Line { file: file.to_owned(), line, column }
}

/// Line and column (in characters), both from 1, of a byte offset in `text`; the end of the text if it is beyond.
#[must_use]
pub fn line_and_column(text: &str, offset: usize) -> (usize, usize) {
    let before = text.char_indices().take_while(|&(at, _)| at < offset).map(|(_, c)| c);
    before.fold((1, 1), |(line, column), c| if c == '\n' { (line + 1, 1) } else { (line, column + 1) })
}

fn not_utf8(path: &Path, bytes: &[u8], valid: usize) -> Diagnostic {
    let before = bytes.get(..valid).unwrap_or_default();
    let line = before.split(|&b| b == b'\n').count();
    let byte = bytes.get(valid).copied().unwrap_or_default();
    let message = format!("Byte 0x{byte:02X} at offset {valid} is not UTF-8 text.");
    Diagnostic::error("not-utf8", line_place(&path.display().to_string(), line, None), message)
        .with_hint("Save the file as UTF-8 text.")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn file(bytes: &[u8]) -> tempfile::NamedTempFile {
        let file = tempfile::NamedTempFile::new().unwrap();
        std::fs::write(file.path(), bytes).unwrap();
        file
    }

    #[test]
    fn text_without_byte_order_mark_is_returned() {
        assert_eq!(read(file("\u{feff}a ⌀".as_bytes()).path(), 10).unwrap(), "a ⌀");
    }

    #[test]
    fn folder_missing_long_and_foreign_bytes_are_diagnostics() {
        let folder = tempfile::tempdir().unwrap();
        assert_eq!(read(folder.path(), 10).unwrap_err().code, "not-a-file");
        assert_eq!(read(&folder.path().join("none"), 10).unwrap_err().code, "file-unreadable");
        assert_eq!(read(file(b"12345").path(), 4).unwrap_err().code, "file-too-long");
        let fault = read(file(b"a\nb\xff").path(), 9).unwrap_err();
        assert!(matches!(fault.at, Place::Line { line: 2, .. }), "{fault}");
        assert!(fault.message.contains("0xFF"), "{fault}");
    }

    #[test]
    fn offsets_become_lines_and_columns() {
        assert_eq!(line_and_column("ab\n⌀d", 0), (1, 1));
        assert_eq!(line_and_column("ab\n⌀d", 6), (2, 2));
        assert_eq!(line_and_column("ab\n", 99), (2, 1));
    }
}
