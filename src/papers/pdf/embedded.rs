//! A font in a PDF file: only the glyphs that are used, addressed by their number in the small font.

use super::single;
use pdf_writer::types::{CidFontType, FontFlags, SystemInfo, UnicodeCmap};
use pdf_writer::{Finish, Name, Pdf, Rect, Ref, Str};
use std::collections::BTreeMap;
use subsetter::GlyphRemapper;
use ttf_parser::{Face, RawFace, Tag};

/// How the glyphs are numbered.
const IDENTITY: SystemInfo<'static> = SystemInfo { registry: Str(b"Adobe"), ordering: Str(b"Identity"), supplement: 0 };
/// Thickness of upright strokes, thousandths of the size; viewers use it only where they have to replace the font.
const STEM_V: f32 = 90.0;

/// A font and the glyphs of it that the pages use.
pub(super) struct EmbeddedFont {
    data: &'static [u8],
    face: Face<'static>,
    name: String,
    glyphs: GlyphRemapper,
    /// Character of every used glyph, by its number in the small font.
    characters: BTreeMap<u16, char>,
}

impl EmbeddedFont {
    /// The font of a file; `name` is the one that the PDF gives it.
    pub(super) fn new(data: &'static [u8], name: &str) -> Result<Self, String> {
        let face = Face::parse(data, 0).map_err(|e| format!("the font {name} cannot be read ({e})"))?;
        // Six letters and a plus mark a font that is not whole.
        let name = format!("TWPAGE+{name}");
        Ok(Self { data, face, name, glyphs: GlyphRemapper::new(), characters: BTreeMap::new() })
    }

    /// The text as glyph numbers of two bytes; a character that the font lacks becomes its box.
    pub(super) fn encode(&mut self, text: &str) -> Vec<u8> {
        let mut codes = Vec::with_capacity(2 * text.len());
        for c in text.chars() {
            let glyph = self.face.glyph_index(c).map_or(0, |id| self.glyphs.remap(id.0));
            self.characters.entry(glyph).or_insert(c);
            codes.extend(glyph.to_be_bytes());
        }
        codes
    }

    /// Writes the font as object `id` and others from `next` on.
    pub(super) fn write(&self, pdf: &mut Pdf, id: Ref, next: &mut Ref) -> Result<(), String> {
        let (cid, descriptor, to_unicode, file) = (next.bump(), next.bump(), next.bump(), next.bump());
        let small = subsetter::subset(self.data, 0, &self.glyphs).map_err(|e| format!("{}: {e}", self.name))?;
        let outlines = RawFace::parse(&small, 0).ok().and_then(|raw| raw.table(Tag::from_bytes(b"CFF ")));
        let outlines = outlines.ok_or_else(|| format!("{} has no outlines", self.name))?;
        let base = Name(self.name.as_bytes());
        let full_name = format!("{}-Identity-H", self.name);
        pdf.type0_font(id)
            .base_font(Name(full_name.as_bytes()))
            .encoding_predefined(Name(b"Identity-H"))
            .descendant_font(cid)
            .to_unicode(to_unicode);
        let mut font = pdf.cid_font(cid);
        font.subtype(CidFontType::Type0).base_font(base).system_info(IDENTITY).font_descriptor(descriptor);
        font.default_width(0.0).widths().consecutive(0, self.glyphs.remapped_gids().map(|g| self.width(g)));
        font.finish();
        self.describe(pdf, descriptor, file);
        let mut map = UnicodeCmap::<u16>::new(Name(b"Custom"), IDENTITY);
        // Number 0 is the box of characters that the font lacks.
        self.characters.iter().filter(|(glyph, _)| **glyph > 0).for_each(|(glyph, c)| map.pair(*glyph, *c));
        pdf.cmap(to_unicode, &map.finish());
        pdf.stream(file, outlines).pair(Name(b"Subtype"), Name(b"CIDFontType0C"));
        Ok(())
    }

    fn describe(&self, pdf: &mut Pdf, id: Ref, file: Ref) {
        let face = &self.face;
        let bounds = face.global_bounding_box();
        let [left, low, right, high] =
            [bounds.x_min, bounds.y_min, bounds.x_max, bounds.y_max].map(|v| self.per_mille(v));
        pdf.font_descriptor(id)
            .name(Name(self.name.as_bytes()))
            .flags(FontFlags::SYMBOLIC)
            .bbox(Rect::new(left, low, right, high))
            .italic_angle(0.0)
            .ascent(self.per_mille(face.ascender()))
            .descent(self.per_mille(face.descender()))
            .cap_height(self.per_mille(face.capital_height().unwrap_or(face.ascender())))
            .stem_v(STEM_V)
            .font_file3(file);
    }

    /// Advance of a glyph of the whole font, thousandths of the size.
    fn width(&self, glyph: u16) -> f32 {
        let advance = self.face.glyph_hor_advance(ttf_parser::GlyphId(glyph)).unwrap_or(0);
        single(f64::from(advance) * 1000.0 / f64::from(self.face.units_per_em()))
    }

    /// A length of the font in thousandths of the size.
    fn per_mille(&self, units: i16) -> f32 {
        single(f64::from(units) * 1000.0 / f64::from(self.face.units_per_em()))
    }
}
