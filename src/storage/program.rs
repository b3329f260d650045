//! Programs on disk.

use crate::diagnostic::{Diagnostic, Place, has_errors};
use crate::post::orac::{Instruction, PAGE_START, pages_text, parse_instructions};
use std::path::Path;

/// More than any control holds; keeps a wrong file from filling the memory.
const LARGEST_PROGRAM_BYTES: u64 = 64 * 1024 * 1024;
/// Endings of the files that controls, posts and people give to programs.
const ENDINGS: [&str; 9] = ["nc", "ngc", "cnc", "tap", "eia", "min", "mpf", "anc", "bnc"];

/// True if the ending of `path` is that of a program.
#[must_use]
pub fn is_program(path: &Path) -> bool {
    path.extension().is_some_and(|e| ENDINGS.iter().any(|ending| e.eq_ignore_ascii_case(ending)))
}

/// The text of a program file as it stands. Bytes that are no UTF-8 become `U+FFFD`, which every reader reports.
///
/// # Errors
/// If the file cannot be read or has more than 64 MiB.
pub fn read_program(path: &Path) -> Result<String, Diagnostic> {
    let at = || Place::File { file: path.display().to_string() };
    let unreadable =
        |e: &std::io::Error| Diagnostic::error("cannot-read", at(), format!("The program cannot be read: {e}."));
    let size = std::fs::metadata(path).map_err(|e| unreadable(&e))?.len();
    if size > LARGEST_PROGRAM_BYTES {
        let message = format!("The file has {size} bytes; a program may have {LARGEST_PROGRAM_BYTES} bytes at most.");
        return Err(Diagnostic::error("file-too-large", at(), message));
    }
    let bytes = std::fs::read(path).map_err(|e| unreadable(&e))?;
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}

/// The pages of a program for the ORAC, from its pages or from its instructions (`.anc`, `.bnc`).
///
/// # Errors
/// If the file cannot be read, or a line of it is no instruction.
pub fn read_pages(path: &Path) -> Result<String, Vec<Diagnostic>> {
    let text = read_program(path).map_err(|d| vec![d])?;
    if text.contains(PAGE_START) {
        return Ok(text);
    }
    let (instructions, diagnostics) = parse_instructions(&text, &path.display().to_string());
    if has_errors(&diagnostics) { Err(diagnostics) } else { Ok(assembled(instructions)) }
}

/// The pages of these instructions, with the END that a program for the lathe needs.
#[must_use]
pub fn assembled(mut instructions: Vec<Instruction>) -> String {
    if !instructions.contains(&Instruction::End) {
        instructions.push(Instruction::End);
    }
    pages_text(&instructions)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn instructions_become_pages_and_pages_stay() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("a.anc");
        std::fs::write(&file, "  1  INC\n  2  MM\n").unwrap();
        let pages = read_pages(&file).unwrap();
        assert_eq!(pages.matches(PAGE_START).count(), 3, "{pages:?}");
        assert!(pages.contains("END-PROGRAM"));
        std::fs::write(&file, &pages).unwrap();
        assert_eq!(read_pages(&file).unwrap(), pages);
    }

    #[test]
    fn a_file_that_is_no_program_is_refused_with_its_lines() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("letter.anc");
        std::fs::write(&file, "  1  INC\nDear Sir,\n").unwrap();
        let reasons = read_pages(&file).unwrap_err();
        assert!(matches!(&reasons[0].at, Place::Line { line: 2, .. }), "{reasons:?}");
        assert_eq!(read_program(&folder.path().join("none.nc")).unwrap_err().code, "cannot-read");
    }

    #[test]
    fn programs_are_known_by_their_endings() {
        for name in ["a.NC", "b.ngc", "c.cnc", "d.anc"] {
            assert!(is_program(Path::new(name)), "{name}");
        }
        for name in ["a.turn", "nc", "c.CAD", "e.dxf"] {
            assert!(!is_program(Path::new(name)), "{name}");
        }
    }
}
