//! Pages as a PDF file (ISO 32000-1): lines, curves and texts with embedded fonts.

mod content;
mod embedded;

use super::font;
use super::page::Page;
use crate::diagnostic::{Diagnostic, Place};
use embedded::EmbeddedFont;
use pdf_writer::{Finish, Name, Pdf, Rect, Ref, TextStr};

/// Points in a mm: 72 to the inch.
const POINTS_PER_MM: f64 = 72.0 / 25.4;
/// What the pages call the fonts.
const REGULAR: Name<'static> = Name(b"F0");
/// What the pages call the fonts.
const BOLD: Name<'static> = Name(b"F1");

/// The pages as one PDF file; arcs become curves within a millionth of their radius, fonts are embedded. No date and no
/// chance is in it: the same pages always give the same file.
///
/// # Errors
/// A diagnostic if a page has no area or a font cannot be embedded.
pub fn pdf(pages: &[Page]) -> Result<Vec<u8>, Diagnostic> {
    let mut regular = EmbeddedFont::new(font::REGULAR, "Inter-Regular").map_err(unwritable)?;
    let mut bold = EmbeddedFont::new(font::BOLD, "Inter-SemiBold").map_err(unwritable)?;
    let mut next = Ref::new(1);
    let (catalog, tree, info) = (next.bump(), next.bump(), next.bump());
    let mut pdf = Pdf::new();
    pdf.catalog(catalog).pages(tree);
    let title = pages.first().map(|page| page.title.as_str()).unwrap_or_default();
    pdf.document_info(info).title(TextStr(title)).creator(TextStr("Turnwright"));
    let (regular_id, bold_id) = (next.bump(), next.bump());
    let mut ids = Vec::with_capacity(pages.len());
    for page in pages {
        if !(page.width_mm > 0.0 && page.height_mm > 0.0) {
            return Err(unwritable("a page has no area"));
        }
        let (id, stream) = (next.bump(), next.bump());
        ids.push(id);
        pdf.stream(stream, &content::content(page, &mut regular, &mut bold));
        let mut sheet = pdf.page(id);
        let size = Rect::new(0.0, 0.0, single(page.width_mm * POINTS_PER_MM), single(page.height_mm * POINTS_PER_MM));
        sheet.parent(tree).media_box(size).contents(stream);
        sheet.resources().fonts().pair(REGULAR, regular_id).pair(BOLD, bold_id);
        sheet.finish();
    }
    let count = i32::try_from(ids.len()).map_err(|_| unwritable("it has too many pages"))?;
    pdf.pages(tree).kids(ids).count(count);
    regular.write(&mut pdf, regular_id, &mut next).map_err(unwritable)?;
    bold.write(&mut pdf, bold_id, &mut next).map_err(unwritable)?;
    Ok(pdf.finish())
}

fn unwritable(reason: impl std::fmt::Display) -> Diagnostic {
    Diagnostic::error("pdf-unwritable", Place::Document, format!("The PDF cannot be made: {reason}."))
}

/// A figure as the file holds it.
#[allow(clippy::cast_possible_truncation, reason = "the file holds single precision: 0.0001 mm on an A0 sheet")]
const fn single(value: f64) -> f32 {
    value as f32
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Point;
    use crate::papers::page::{Align, Pen};

    #[test]
    fn a_page_becomes_a_file_with_its_size_and_its_font() {
        let mut page = Page::new(297.0, 210.0, "KNOB");
        page.line(Point::new(10.0, 10.0), Point::new(20.0, 10.0), Pen::EDGE);
        page.text(Point::new(10.0, 20.0), 2.5, Align::End, "Ø 25.4");
        let bytes = pdf(&[page.clone()]).unwrap();
        let text = String::from_utf8_lossy(&bytes);
        assert!(text.starts_with("%PDF-"), "a PDF header");
        assert!(text.contains("/MediaBox [0 0 841.8898 595.27"), "the size in points");
        assert!(text.contains("Inter-Regular") && text.contains("CIDFontType0C"), "the font is embedded");
        assert!(text.contains("<00D8>"), "Ø can be searched for");
        assert_eq!(bytes, pdf(&[page]).unwrap(), "the same page gives the same file");
    }

    #[test]
    fn a_page_without_an_area_is_refused() {
        let fault = pdf(&[Page::new(0.0, 100.0, "")]).unwrap_err();
        assert_eq!(fault.code, "pdf-unwritable");
    }
}
