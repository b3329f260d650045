//! Pages as files; the kind goes by the extension.

use super::page::Page;
use super::{dxf, hpgl, pdf, svg};
use crate::diagnostic::Diagnostic;
use crate::replace::replace_file;
use crate::textfile::file_place;
use std::path::{Path, PathBuf};

/// Writes pages as `.pdf`, `.svg`, `.dxf`, or HP-GL (`.plt` or `.hpgl`), and returns the files.
///
/// A PDF holds all pages. The other kinds hold one: of several, each becomes a file of its own with its number behind
/// the name, `NAME-1.svg`.
///
/// # Errors
/// A diagnostic if the extension names no such kind or a file cannot be written; a file that was there is then whole.
pub fn save(path: &Path, pages: &[Page]) -> Result<Vec<PathBuf>, Diagnostic> {
    let extension = path.extension().map(|e| e.to_string_lossy().to_ascii_lowercase()).unwrap_or_default();
    let contents = match extension.as_str() {
        "pdf" => vec![pdf(pages)?],
        "svg" => pages.iter().map(|page| svg(page).into_bytes()).collect(),
        "dxf" => pages.iter().map(|page| dxf(page).map(String::into_bytes)).collect::<Result<_, _>>()?,
        "plt" | "hpgl" => pages.iter().map(|page| hpgl(page).into_bytes()).collect(),
        _ => {
            let message = format!("Papers cannot be written as \".{extension}\".");
            let fault = Diagnostic::error("unknown-file-kind", file_place(path), message);
            return Err(fault.with_hint("Use .pdf, .svg, .dxf or .plt (HP-GL)."));
        }
    };
    let files: Vec<PathBuf> = match contents.len() {
        1 => vec![path.to_owned()],
        count => (1..=count).map(|number| numbered(path, number)).collect(),
    };
    for (file, bytes) in files.iter().zip(contents) {
        replace_file(file, &bytes)?;
    }
    Ok(files)
}

/// `NAME-2.svg` of `NAME.svg` and 2.
fn numbered(path: &Path, number: usize) -> PathBuf {
    let name = |part: Option<&std::ffi::OsStr>| part.unwrap_or_default().to_string_lossy().into_owned();
    path.with_file_name(format!("{}-{number}.{}", name(path.file_stem()), name(path.extension())))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Point;
    use crate::papers::page::{Align, Pen};

    fn pages(count: usize) -> Vec<Page> {
        let mut page = Page::new(100.0, 50.0, "A");
        page.line(Point::new(1.0, 1.0), Point::new(9.0, 1.0), Pen::EDGE);
        page.text(Point::new(1.0, 2.0), 2.5, Align::Start, "Ø 8");
        vec![page; count]
    }

    #[test]
    fn every_kind_is_written_and_only_a_pdf_holds_more_than_one_page() {
        let folder = tempfile::tempdir().unwrap();
        for (name, first_bytes) in [("a.pdf", "%PDF"), ("a.SVG", "<?xml"), ("a.dxf", "  0"), ("a.plt", "IN;")] {
            let path = folder.path().join(name);
            assert_eq!(save(&path, &pages(1)).unwrap(), [&*path]);
            assert!(std::fs::read(&path).unwrap().starts_with(first_bytes.as_bytes()), "{name}");
        }
        assert_eq!(save(&folder.path().join("b.pdf"), &pages(2)).unwrap().len(), 1);
        let files = save(&folder.path().join("b.svg"), &pages(2)).unwrap();
        assert_eq!(files, ["b-1.svg", "b-2.svg"].map(|name| folder.path().join(name)));
        assert!(files.iter().all(|file| file.exists()) && !folder.path().join("b.svg").exists());
    }

    #[test]
    fn what_cannot_be_written_is_said_and_the_old_file_stays() {
        let folder = tempfile::tempdir().unwrap();
        let fault = save(&folder.path().join("none/a.pdf"), &pages(1)).unwrap_err();
        assert!(fault.code == "save-failed" && fault.message.contains("cannot be saved"), "{fault}");
        let fault = save(&folder.path().join("a.docx"), &pages(1)).unwrap_err();
        assert!(fault.code == "unknown-file-kind" && fault.message.contains(".docx"), "{fault}");
        let old = folder.path().join("old.pdf");
        std::fs::write(&old, "old").unwrap();
        let mut permissions = std::fs::metadata(&old).unwrap().permissions();
        permissions.set_readonly(true);
        std::fs::set_permissions(&old, permissions).unwrap();
        assert_eq!(save(&old, &pages(1)).unwrap_err().code, "save-failed");
        assert_eq!(std::fs::read(&old).unwrap(), b"old");
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1, "no temporary file is left");
    }
}
