//! A former has a flat tip to hold the blank, a length, and a contour that can be drawn.

use super::{Checked, setting};
use crate::diagnostic::Diagnostic;
use crate::document::FormerShape;

/// Figures of a former or blank that describe none.
pub(super) fn check(checked: &Checked<'_>) -> Vec<Diagnostic> {
    if checked.shape.is_some() {
        return Vec::new();
    }
    let thickness = checked.shell.blank.thickness;
    if thickness.is_nan() || thickness <= 0.0 {
        let message = format!("The blank is {} thick; it must be more than 0.", checked.length(thickness));
        return vec![Diagnostic::error("blank-thickness", setting("blank.thickness"), message)];
    }
    let message = match &checked.shell.former.shape {
        FormerShape::Cone { half_angle_deg, .. } if !(*half_angle_deg > 0.0 && *half_angle_deg < 90.0) => {
            format!("The half angle of the cone is {half_angle_deg}°; it must lie between 0° and 90°.")
        }
        FormerShape::Ellipse { semi_axis, length, .. } if length >= semi_axis => format!(
            "The contour is {} long, its semi-axis {}; it must end before its largest diameter.",
            checked.length(*length),
            checked.length(*semi_axis)
        ),
        FormerShape::Sections { sections } => format!(
            "The {} rows of the former are no contour: each must begin where the one before it ends.",
            sections.len()
        ),
        shape => {
            let (name, value) =
                shape.figures().into_iter().min_by(|a, b| a.1.total_cmp(&b.1)).unwrap_or(("length", 0.0));
            format!(
                "The figures of the {} give no contour (smallest: {name} = {value}); all must be more than 0 and the tip \
                 smaller than the base.",
                shape.name()
            )
        }
    };
    vec![Diagnostic::error("former-impossible", setting("former.shape"), message)]
}

#[cfg(test)]
mod tests {
    use super::super::test_shell::*;
    use super::*;

    #[test]
    fn fires_for_formers_that_are_none() {
        assert_eq!(codes(check, &cone(95.0)), ["former-impossible"]);
        let dish = FormerShape::Dish { focal_length: 50.0, tip_diameter: 40.0, rim_diameter: 30.0 };
        assert_eq!(codes(check, &with_shape(dish)), ["former-impossible"]);
        assert_eq!(codes(check, &with_shape(FormerShape::Sections { sections: Vec::new() })), ["former-impossible"]);
        let mut thin = cone(30.0);
        thin.blank.thickness = -1.0;
        assert_eq!(codes(check, &thin), ["blank-thickness"]);
    }

    #[test]
    fn says_nothing_about_a_former() {
        assert!(codes(check, &cone(30.0)).is_empty());
    }
}
