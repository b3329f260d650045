//! Where the two edges of the strip come together, the section is a tube: torsion and warping are those of open sections.

use super::subject::Subject;
use crate::diagnostic::{Diagnostic, Place};
use crate::geometry::Segment;
use crate::rollform::bends::Stage;
use crate::rollform::strip::Strip;

/// Edges of the finished section that are closer than the thickness.
pub(super) fn check(subject: &Subject<'_>) -> Vec<Diagnostic> {
    let thickness = subject.set.section.thickness;
    let gap = subject.flower.at(Stage::Finished).and_then(|shape| gap(&shape.strip));
    let Some(gap) = gap.filter(|gap| *gap < thickness && subject.bends().next().is_some()) else { return Vec::new() };
    let message = format!(
        "The edges of the finished section are {} apart, less than the thickness of {}.",
        subject.length(gap),
        subject.length(thickness)
    );
    vec![
        Diagnostic::warning("closed-section", Place::Document, message)
            .with_hint("Torsion, warping and shear centre are those of an open section; a welded tube is far stiffer."),
    ]
}

/// Distance of the two end faces of a strip, mm.
fn gap(strip: &Strip) -> Option<f64> {
    let (first, last) = (strip.pieces.first()?, strip.pieces.last()?);
    let one = Segment::line(first.bottom.start(), first.top.start());
    let other = Segment::line(last.bottom.end(), last.top.end());
    let from = |a: &Segment, b: &Segment| a.distance_to(b.start()).min(a.distance_to(b.end()));
    Some(from(&one, &other).min(from(&other, &one)))
}

#[cfg(test)]
mod tests {
    use super::super::subject::found;
    use super::*;
    use crate::document::{Origin, RollSet};
    use crate::rollform::fixtures::{bend, line, set};

    /// A square tube with its seam in the middle of a side.
    fn tube(gap: f64) -> RollSet {
        let half = (20.0 - gap) / 2.0;
        let elements = vec![line(1, 10.0), bend(2, 2.0, 90.0), line(3, 20.0), bend(4, 2.0, 90.0), line(5, half)];
        set(1.0, Origin::Symmetrical, elements, vec![])
    }

    #[test]
    fn fires_where_the_seam_is_narrower_than_the_strip_is_thick() {
        let narrow = found(check, &tube(0.4));
        assert!(narrow[0].message.contains("0.400 mm"), "{narrow:?}");
        assert!(found(check, &tube(1.5)).is_empty());
    }
}
