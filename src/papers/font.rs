//! The type of the papers and its measures: Inter, as on the screen.

use ttf_parser::Face;

/// Text.
pub(super) const REGULAR: &[u8] = include_bytes!("../../assets/fonts/Inter-Regular.otf");
/// Headings.
pub(super) const BOLD: &[u8] = include_bytes!("../../assets/fonts/Inter-SemiBold.otf");
/// Height of a capital as a share of the type's size; Inter's own figure is 0.727.
pub(super) const CAPITAL: f64 = 0.727;
/// Width of a character whose type cannot be read, as a share of the size: the mean of a text.
const USUAL_ADVANCE: f64 = 0.55;

/// Width of a text whose capitals are `height_mm` high, mm.
pub(super) fn width_mm(text: &str, height_mm: f64, bold: bool) -> f64 {
    let size = height_mm / CAPITAL;
    let Ok(face) = Face::parse(if bold { BOLD } else { REGULAR }, 0) else {
        return USUAL_ADVANCE * size * text.chars().map(|_| 1.0).sum::<f64>();
    };
    let advance = |c| face.glyph_index(c).and_then(|glyph| face.glyph_hor_advance(glyph)).map(f64::from);
    let units = f64::from(face.units_per_em());
    text.chars().map(|c| advance(c).map_or(USUAL_ADVANCE, |a| a / units)).sum::<f64>() * size
}

/// `text` or as much of its beginning as is at most `width` mm wide, with an ellipsis where something was left off.
pub(super) fn fitted(text: &str, height_mm: f64, width: f64) -> String {
    if width_mm(text, height_mm, false) <= width {
        return text.to_owned();
    }
    let mut kept: Vec<char> = text.chars().collect();
    while kept.pop().is_some() {
        let candidate: String = kept.iter().collect::<String>().trim_end().to_owned() + "…";
        if width_mm(&candidate, height_mm, false) <= width {
            return candidate;
        }
    }
    String::new()
}

/// `text` in lines of at most `width` mm, broken between words; a word that is wider is cut with an ellipsis.
pub(super) fn wrapped(text: &str, height_mm: f64, width: f64) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split_whitespace() {
        match lines.last_mut() {
            Some(line) if width_mm(&format!("{line} {word}"), height_mm, false) <= width => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(fitted(word, height_mm, width)),
        }
    }
    if lines.is_empty() { vec![String::new()] } else { lines }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_longer_text_is_wider_and_a_long_one_is_cut_with_an_ellipsis() {
        assert!(width_mm("Ø 25.400", 2.5, false) > width_mm("Ø 25.4", 2.5, false));
        let short = fitted("A very long name of a part", 2.5, 20.0);
        assert!(short.ends_with('…') && width_mm(&short, 2.5, false) <= 20.0, "{short}");
        assert_eq!(fitted("KNOB", 2.5, 20.0), "KNOB");
    }

    #[test]
    fn a_long_text_is_broken_between_its_words_and_none_is_lost() {
        let text = "10.793 mm are left on bore line 1 at z 21.900";
        let lines = wrapped(text, 2.5, 30.0);
        assert!(lines.len() > 2 && lines.iter().all(|line| width_mm(line, 2.5, false) <= 30.0), "{lines:?}");
        assert_eq!(lines.join(" "), text);
        assert_eq!(wrapped("", 2.5, 30.0), [""]);
    }
}
