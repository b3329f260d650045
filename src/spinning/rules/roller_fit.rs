//! The nose of the roller must fit into every hollow of the contour, its wall included. Into a narrower one between two
//! walls it does not reach: the shell spans it, and the rest is formed. A hollow without walls for the roller to rest on
//! cannot be formed at all.

use super::{Checked, setting};
use crate::diagnostic::{Diagnostic, Place};
use crate::document::FormerShape;
use crate::geometry::{Point, Segment};
use crate::spinning::law;
use crate::spinning::offset;
use crate::spinning::shape::ShellShape;

/// Hollows narrower than nose and wall together.
pub(super) fn check(checked: &Checked<'_>) -> Vec<Diagnostic> {
    let Some(shape) = checked.shape else { return Vec::new() };
    let mut said = spanned(checked, shape);
    said.extend(impossible(checked, shape));
    said
}

/// Hollows that the shell spans, standing off the former by more than the tolerance of the gap.
fn spanned(checked: &Checked<'_>, shape: &ShellShape) -> Vec<Diagnostic> {
    let limit = checked.shell.gap_tolerance;
    let length = |mm: f64| checked.length(mm);
    let message = |hollow: &super::super::Hollow| {
        let place = length(shape.tip().z - hollow.at.z);
        let kind = if hollow.former_radius > 0.0 {
            format!("The hollow of the former at {place} from the tip has a radius of {}", length(hollow.former_radius))
        } else {
            format!("The hollow of the former at {place} from the tip is a sharp corner (radius {})", length(0.0))
        };
        format!(
            "{kind}; a nose of {} leaves a radius of {} inside at least. The shell will stand off the former by {} there; the \
             limit is {}.",
            length(checked.shell.roller.nose_radius),
            length(hollow.shell_radius),
            length(hollow.stands_off),
            length(limit)
        )
    };
    let wide = shape.hollows.iter().filter(|hollow| hollow.stands_off > limit);
    wide.map(|hollow| {
        Diagnostic::warning("hollow-not-formed", place(checked, shape, hollow.at), message(hollow)).with_hint(
            "Round the former's corner to that radius, or take a roller with a smaller nose; the rest is programmed.",
        )
    })
    .collect()
}

/// The row of the table that ends or lies there; the roller's nose where there is no table.
fn place(checked: &Checked<'_>, shape: &ShellShape, at: Point) -> Place {
    /// Rows end this near to their corner, mm.
    const SAME_MM: f64 = 1e-6;
    let FormerShape::Sections { sections } = &checked.shell.former.shape else { return setting("roller.nose_radius") };
    let base = sections.first().map_or(0.0, |first| shape.base_length - first.z1);
    let row = sections.iter().position(|s| base + s.z2 >= at.z - SAME_MM);
    row.map_or_else(|| setting("former.shape.sections"), |row| setting(&format!("former.shape.sections[{row}]")))
}

/// A hollow that is narrower than the roller and has no walls on which it could rest.
fn impossible(checked: &Checked<'_>, shape: &ShellShape) -> Option<Diagnostic> {
    let nose = checked.shell.roller.nose_radius;
    let spanned = |index: usize| shape.hollows.iter().any(|hollow| hollow.segments.contains(&index));
    let (room, segment) = (0..)
        .zip(&shape.former.segments)
        .filter(|(index, s)| s.sweep() < 0.0 && !spanned(*index))
        .filter_map(|(_, s)| Some((s.radius()? - wall(checked, s), s)))
        .min_by(|a, b| a.0.total_cmp(&b.0))
        .filter(|(room, _)| *room <= nose)?;
    let message = format!(
        "The nose radius is {}; the hollow at {} from the tip leaves {} for it.",
        checked.length(nose),
        checked.length(shape.tip().z - segment.start().z),
        checked.length(room)
    );
    let said = Diagnostic::error("roller-too-large", setting("roller.nose_radius"), message);
    Some(said.with_hint("Take a roller with a smaller nose, or open the hollow."))
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
    use crate::part::{Section, SectionKind};
    use crate::spinning::shape;
    use crate::units::Unit;

    #[test]
    fn fires_for_a_nose_larger_than_the_hollow() {
        let row = Section { kind: SectionKind::Concave { radius: 12.0 }, ..Section::line(1, 0.0, 60.0, 8.0, 44.0) };
        let mut shell = with_shape(FormerShape::Sections { sections: vec![row] });
        shell.roller.nose_radius = 11.0;
        assert_eq!(codes(check, &shell), ["roller-too-large"]);
        shell.roller.nose_radius = 9.0;
        assert!(codes(check, &shell).is_empty());
    }

    #[test]
    fn a_sharp_hollow_corner_is_told_with_place_value_and_limit() {
        let rows = |d: f64| vec![Section::line(1, 0.0, 120.0, 10.0, d), Section::line(2, 10.0, d, 40.0, 60.0)];
        let mut shell = with_shape(FormerShape::Sections { sections: rows(90.0) });
        let made = shape::shape(&shell);
        let said = check(&Checked { shell: &shell, unit: Unit::Mm, shape: made.as_ref() });
        assert_eq!(said.len(), 1);
        assert_eq!((said[0].code.as_str(), &said[0].at), ("hollow-not-formed", &setting("former.shape.sections[0]")));
        for figure in ["at 30.000 mm", "radius 0.000 mm", "nose of 9.000 mm", "the limit is 0.020 mm"] {
            assert!(said[0].message.contains(figure), "{figure}: {}", said[0].message);
        }
        // A turn so small that the shell stays within the tolerance, and a smaller nose.
        shell.former.shape = FormerShape::Sections { sections: rows(100.5) };
        let nearly = check(&Checked { shell: &shell, unit: Unit::Mm, shape: shape::shape(&shell).as_ref() });
        shell.roller.nose_radius = 0.1;
        shell.blank.thickness = 0.05;
        let fine = check(&Checked { shell: &shell, unit: Unit::Mm, shape: shape::shape(&shell).as_ref() });
        println!("{nearly:?}");
        assert_eq!(fine, []);
    }
}
