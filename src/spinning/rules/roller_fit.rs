//! The nose of the roller must fit into every hollow of the contour, its wall included.

use super::{Checked, setting};
use crate::diagnostic::Diagnostic;
use crate::geometry::Segment;
use crate::spinning::law;
use crate::spinning::offset;

/// Hollows narrower than nose and wall together.
pub(super) fn check(checked: &Checked<'_>) -> Vec<Diagnostic> {
    let Some(shape) = checked.shape else { return Vec::new() };
    let nose = checked.shell.roller.nose_radius;
    let narrowest = shape
        .inside
        .segments
        .iter()
        .filter(|s| s.sweep() < 0.0)
        .filter_map(|s| Some((s.radius()? - wall(checked, s), s)))
        .min_by(|a, b| a.0.total_cmp(&b.0));
    let Some((room, segment)) = narrowest.filter(|(room, _)| *room <= nose) else { return Vec::new() };
    let message = format!(
        "The nose radius is {}; the hollow at {} from the tip leaves {} for it.",
        checked.length(nose),
        checked.length(shape.tip().z - segment.start().z),
        checked.length(room)
    );
    vec![
        Diagnostic::error("roller-too-large", setting("roller.nose_radius"), message)
            .with_hint("Take a roller with a smaller nose, or open the hollow."),
    ]
}

/// The thicker wall of the two ends.
fn wall(checked: &Checked<'_>, segment: &Segment) -> f64 {
    let at = |share: f64| {
        let angle = offset::half_angle(segment.direction_at(share));
        law::wall(checked.shell.forming, checked.shell.blank.thickness, angle)
    };
    at(0.0).max(at(1.0))
}

#[cfg(test)]
mod tests {
    use super::super::test_shell::*;
    use super::*;
    use crate::document::FormerShape;
    use crate::part::{Section, SectionKind};

    #[test]
    fn fires_for_a_nose_larger_than_the_hollow() {
        let row = Section { kind: SectionKind::Concave { radius: 12.0 }, ..Section::line(1, 0.0, 60.0, 8.0, 44.0) };
        let mut shell = with_shape(FormerShape::Sections { sections: vec![row] });
        shell.roller.nose_radius = 11.0;
        assert_eq!(codes(check, &shell), ["roller-too-large"]);
        shell.roller.nose_radius = 9.0;
        assert!(codes(check, &shell).is_empty());
    }
}
