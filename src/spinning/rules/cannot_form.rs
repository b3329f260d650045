//! A former has a flat tip to hold the blank, a length, and a contour that can be drawn.

use super::{Checked, setting};
use crate::diagnostic::Diagnostic;
use crate::document::FormerShape;
use crate::part::{Section, SectionKind, ShapeFault, row_fault};
use crate::spinning::limits::LARGEST_FIGURE;

/// Figures of a former or blank that describe none, each at its place.
pub(super) fn check(checked: &Checked<'_>) -> Vec<Diagnostic> {
    if checked.shape.is_some() {
        return Vec::new();
    }
    let shape = &checked.shell.former.shape;
    let mut said: Vec<Diagnostic> = thickness(checked).into_iter().collect();
    said.extend(match shape {
        FormerShape::Sections { sections } => rows(checked, sections),
        _ => wrong_figures(checked, shape),
    });
    // What is no number at all is told by its own rule.
    let usable = checked.shell.figures().iter().all(|(_, v)| v.is_finite() && v.abs() <= LARGEST_FIGURE);
    if said.is_empty() && usable {
        let message = format!(
            "The figures of the {} give no contour within {LARGEST_FIGURE} mm; make it shorter or less steep.",
            shape.name()
        );
        said.push(impossible("former.shape", message));
    }
    said
}

fn impossible(path: &str, message: String) -> Diagnostic {
    Diagnostic::error("former-impossible", setting(path), message)
}

fn thickness(checked: &Checked<'_>) -> Option<Diagnostic> {
    let thickness = checked.shell.blank.thickness;
    let message = format!("The blank is {} thick; it must be more than 0.", checked.length(thickness));
    let told = Diagnostic::error("blank-thickness", setting("blank.thickness"), message);
    (thickness.is_nan() || thickness <= 0.0).then_some(told)
}

/// A figure with its key, its name, what it is, whether it is possible, and what it must be.
type Figure = (&'static str, &'static str, String, bool, String);

fn wrong_figures(checked: &Checked<'_>, shape: &FormerShape) -> Vec<Diagnostic> {
    let mut figures: Vec<Figure> = Vec::new();
    let mut add = |key, name, value, good, limit: String| figures.push((key, name, value, good, limit));
    let length = |mm: f64| checked.length(mm);
    let more = || "more than 0".to_owned();
    match *shape {
        FormerShape::Cone { half_angle_deg: angle, tip_diameter, length: long } => {
            let within = angle > 0.0 && angle < 90.0;
            add(
                "half_angle_deg",
                "half angle of the cone",
                format!("{angle}°"),
                within,
                "between 0° and 90°".to_owned(),
            );
            add("tip_diameter", "diameter of the tip", length(tip_diameter), tip_diameter > 0.0, more());
            add("length", "length", length(long), long > 0.0, more());
        }
        FormerShape::Parabola { constant, tip_diameter, length: long } => {
            add("constant", "constant of the parabola", length(constant), constant > 0.0, more());
            add("tip_diameter", "diameter of the tip", length(tip_diameter), tip_diameter > 0.0, more());
            add("length", "length", length(long), long > 0.0, more());
        }
        FormerShape::Dish { focal_length: focus, tip_diameter, rim_diameter } => {
            add("focal_length", "focal length of the dish", length(focus), focus > 0.0, more());
            add("tip_diameter", "diameter of the tip", length(tip_diameter), tip_diameter > 0.0, more());
            let limit = format!("more than the tip's {}", length(tip_diameter));
            add("rim_diameter", "diameter of the rim", length(rim_diameter), rim_diameter > tip_diameter, limit);
        }
        FormerShape::Ellipse { semi_axis, diameter, tip_diameter, length: long } => {
            add("semi_axis", "semi-axis of the ellipse", length(semi_axis), semi_axis > 0.0, more());
            add("diameter", "largest diameter", length(diameter), diameter > 0.0, more());
            let limit = format!("more than 0 and less than the largest diameter, {}", length(diameter));
            let good = tip_diameter > 0.0 && tip_diameter < diameter;
            add("tip_diameter", "diameter of the tip", length(tip_diameter), good, limit);
            let most = semi_axis * (1.0 - (tip_diameter / diameter).powi(2)).max(0.0).sqrt();
            let limit = format!("more than 0 and at most {}, where the diameter is largest", length(most));
            add("length", "length", length(long), long > 0.0 && long <= most, limit);
        }
        FormerShape::Sections { .. } => {}
    }
    let wrong = figures.into_iter().filter(|(_, _, _, good, _)| !good);
    wrong
        .map(|(key, name, value, _, limit)| {
            impossible(&format!("former.shape.{key}"), format!("The {name} is {value}; it must be {limit}."))
        })
        .collect()
}

/// Rows that have no curve, and rows that do not begin where the one before them ends.
fn rows(checked: &Checked<'_>, sections: &[Section]) -> Vec<Diagnostic> {
    /// Ends further apart leave a step, mm.
    const STEP_MM: f64 = 1e-6;
    if sections.is_empty() {
        let message = "The section table of the former has 0 rows; there must be at least 1.".to_owned();
        return vec![impossible("former.shape.sections", message)];
    }
    let path = |index: usize| format!("former.shape.sections[{index}]");
    let mut said: Vec<Diagnostic> = sections
        .iter()
        .enumerate()
        .filter_map(|(index, row)| Some(impossible(&path(index), row_message(checked, index + 1, row)?)))
        .collect();
    for (index, pair) in sections.windows(2).enumerate() {
        let [a, b] = pair else { continue };
        let step = (b.z1 - a.z2).abs().max((b.d1 - a.d2).abs() / 2.0);
        if step > STEP_MM {
            let message = format!(
                "Row {} begins {} from where row {} ends; there must be nothing between them.",
                index + 2,
                checked.length(step),
                index + 1
            );
            said.push(impossible(&path(index + 1), message));
        }
    }
    said
}

/// Why a row is none of a former; `None` if it is one.
fn row_message(checked: &Checked<'_>, number: usize, row: &Section) -> Option<String> {
    let length = |mm: f64| checked.length(mm);
    if let SectionKind::Thread { pitch, .. } = row.kind {
        let pitch = length(pitch);
        return Some(format!("Row {number} is a thread with a pitch of {pitch}; a former has none. Make it a line."));
    }
    let radius = match row.kind {
        SectionKind::Concave { radius } | SectionKind::Convex { radius } => radius,
        _ => 0.0,
    };
    Some(match row_fault(row)? {
        ShapeFault::Unusable => format!("A figure of row {number} is not a number or beyond {LARGEST_FIGURE}."),
        ShapeFault::Order => {
            format!("Row {number} ends at z {}; it must end beyond its start at z {}.", length(row.z2), length(row.z1))
        }
        ShapeFault::NegativeDiameter => {
            let least = length(row.d1.min(row.d2));
            format!("A diameter of row {number} is {least}; it must be 0 or more.")
        }
        ShapeFault::ArcWithoutRadius => {
            format!("The radius of row {number} is {}; it must be more than 0.", length(radius))
        }
        ShapeFault::ArcImpossible { chord } => format!(
            "The radius of row {number} is {}; between its ends, {} apart, it must be at least {}.",
            length(radius),
            length(chord),
            length(chord / 2.0)
        ),
        ShapeFault::ArcUndercut { overhang } => format!(
            "The arc of row {number} reaches {} beyond its ends along the spindle; it must not. Enter a larger radius \
             than {}.",
            length(overhang),
            length(radius)
        ),
        ShapeFault::BelowAxis { lowest } => {
            format!("Row {number} dips to a radius of {}; it must stay above the axis, at 0.", length(lowest))
        }
        ShapeFault::ParabolaWithoutPoints => {
            format!("Two of the 3 points of the parabola of row {number} are at the same place; they must differ.")
        }
        ShapeFault::ParabolaStraight => {
            format!("The 3 points of the parabola of row {number} lie on a line; move the third one.")
        }
        ShapeFault::ParabolaTurnsBack { vertex } => format!(
            "The parabola of row {number} turns back at a diameter of {}, between its ends; it must not.",
            length(2.0 * vertex)
        ),
    })
}

#[cfg(test)]
mod tests {
    use super::super::test_shell::*;
    use super::*;
    use crate::diagnostic::Place;
    use crate::spinning::{Shell, shape};
    use crate::units::Unit;

    /// Places of what is said of a shell.
    fn places(shell: &Shell) -> Vec<String> {
        let made = shape::shape(shell);
        let said = check(&Checked { shell, unit: Unit::Mm, shape: made.as_ref() });
        assert!(said.iter().all(|d| d.message.contains(|c: char| c.is_ascii_digit())), "{said:?}");
        let path = |d: Diagnostic| if let Place::Setting { path } = d.at { path } else { panic!("{d:?}") };
        said.into_iter().map(path).map(|p| p.trim_start_matches("former.shape.").to_owned()).collect()
    }

    #[test]
    fn fires_at_the_figure_of_formers_that_are_none() {
        assert_eq!(places(&cone(95.0)), ["half_angle_deg"]);
        assert_eq!(places(&cone(0.0)), ["half_angle_deg"]);
        assert_eq!(places(&cone(89.999_999)), ["former.shape"]);
        let dish = FormerShape::Dish { focal_length: 50.0, tip_diameter: 40.0, rim_diameter: 30.0 };
        assert_eq!(places(&with_shape(dish)), ["rim_diameter"]);
        let ball = |length| FormerShape::Ellipse { semi_axis: 50.0, diameter: 100.0, tip_diameter: 60.0, length };
        assert_eq!(places(&with_shape(ball(40.1))), ["length"]);
        assert!(places(&with_shape(ball(40.0))).is_empty());
        let parabola = FormerShape::Parabola { constant: -1.0, tip_diameter: 0.0, length: -3.0 };
        assert_eq!(places(&with_shape(parabola)), ["constant", "tip_diameter", "length"]);
        let mut thin = cone(30.0);
        thin.blank.thickness = -1.0;
        assert_eq!(codes(check, &thin), ["blank-thickness"]);
    }

    #[test]
    fn fires_at_the_row_of_a_table_that_is_none() {
        let of = |sections| places(&with_shape(FormerShape::Sections { sections }));
        let line = |id, z1, d1, z2, d2| Section::line(id, z1, d1, z2, d2);
        let arc = |radius| Section { kind: SectionKind::Convex { radius }, ..line(2, 30.0, 60.0, 50.0, 40.0) };
        assert_eq!(of(Vec::new()), ["sections"]);
        assert_eq!(of(vec![line(1, 0.0, 90.0, 30.0, 60.0), line(2, 31.0, 60.0, 50.0, 40.0)]), ["sections[1]"]);
        assert_eq!(of(vec![line(1, 0.0, 90.0, -1.0, 60.0)]), ["sections[0]"]);
        assert_eq!(of(vec![line(1, 0.0, 90.0, 30.0, 60.0), arc(5.0)]), ["sections[1]"]);
        assert_eq!(of(vec![line(1, 0.0, 90.0, 30.0, 60.0), arc(0.0)]), ["sections[1]"]);
        let thread = Section { kind: SectionKind::Thread { pitch: 1.0, starts: 1 }, ..line(1, 0.0, 60.0, 30.0, 60.0) };
        assert_eq!(of(vec![thread]), ["sections[0]"]);
    }

    #[test]
    fn says_nothing_about_a_former() {
        assert!(codes(check, &cone(30.0)).is_empty());
    }
}
