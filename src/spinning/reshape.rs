//! What a drag on the drawing makes of a former.

use crate::document::{Former, FormerShape, Shell};
use crate::geometry::Point;
use crate::part::Section;

/// What can be taken hold of.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Grip {
    /// The edge of the flat tip.
    Tip,
    /// The end of the contour at the base.
    Base,
    /// An end of a row of the section table: row from 0, and whether it is the second end.
    Row(usize, bool),
}

/// The grips of a shell in mm with their places, part space.
#[must_use]
pub fn grips(shell_mm: &Shell, tip: Point, base: Point) -> Vec<(Grip, Point)> {
    let FormerShape::Sections { sections } = &shell_mm.former.shape else {
        return vec![(Grip::Tip, tip), (Grip::Base, base)];
    };
    let z0 = shell_mm.former.base_length - sections.first().map_or(0.0, |s| s.z1);
    let ends = |(row, s): (usize, &Section)| {
        let first = (row == 0).then(|| (Grip::Row(row, false), Point::new(z0 + s.z1, s.d1 / 2.0)));
        first.into_iter().chain([(Grip::Row(row, true), Point::new(z0 + s.z2, s.d2 / 2.0))])
    };
    sections.iter().enumerate().flat_map(ends).collect()
}

/// The shell in mm after `grip` was brought to `to`; figures are rounded to `step` mm or degrees.
#[must_use]
pub fn dragged(shell_mm: &Shell, grip: Grip, to: Point, step: f64) -> Shell {
    /// Nothing becomes smaller than this, mm.
    const LEAST_MM: f64 = 0.5;
    let mut shell = shell_mm.clone();
    let round = |value: f64| if step > 0.0 { (value / step).round() * step } else { value };
    let diameter = round(2.0 * to.r).max(2.0 * LEAST_MM);
    let long = round(to.z - shell.former.base_length).max(LEAST_MM);
    match (&mut shell.former.shape, grip) {
        (
            FormerShape::Cone { tip_diameter, length, .. } | FormerShape::Parabola { tip_diameter, length, .. },
            Grip::Tip,
        ) => {
            (*tip_diameter, *length) = (diameter, long);
        }
        (FormerShape::Ellipse { tip_diameter, diameter: most, .. }, Grip::Tip) => {
            *tip_diameter = diameter.min(0.95 * *most);
        }
        (FormerShape::Dish { tip_diameter, rim_diameter, .. }, Grip::Tip) => {
            *tip_diameter = diameter.min(0.95 * *rim_diameter);
        }
        (FormerShape::Cone { half_angle_deg, tip_diameter, length }, Grip::Base) => {
            let rise = (to.r - *tip_diameter / 2.0).max(0.0);
            *half_angle_deg = round(rise.atan2(*length).to_degrees()).clamp(1.0, 89.0);
        }
        (FormerShape::Parabola { constant, tip_diameter, length }, Grip::Base) => {
            let rise = (to.r - *tip_diameter / 2.0).max(LEAST_MM);
            *constant = round(*length * *length / rise).max(LEAST_MM);
        }
        (FormerShape::Dish { tip_diameter, rim_diameter, .. }, Grip::Base) => {
            *rim_diameter = diameter.max(1.05 * *tip_diameter);
        }
        (FormerShape::Ellipse { semi_axis, diameter: most, tip_diameter, length }, Grip::Base) => {
            let share = base_share(*semi_axis, *most, *tip_diameter, *length);
            *most = round(diameter / share).max(1.05 * *tip_diameter);
        }
        (FormerShape::Sections { sections }, Grip::Row(row, second)) => {
            let z0 = shell.former.base_length - sections.first().map_or(0.0, |s| s.z1);
            let (z, next) = (round(to.z - z0), row + 1);
            if let Some(section) = sections.get_mut(row) {
                if second {
                    (section.z2, section.d2) = (z.max(section.z1), diameter);
                } else {
                    section.d1 = diameter;
                }
            }
            let end = sections.get(row).map(|s| (s.z2, s.d2));
            if let (true, Some((z, d)), Some(follower)) = (second, end, sections.get_mut(next)) {
                (follower.z1, follower.d1) = (z, d);
            }
        }
        _ => {}
    }
    shell
}

/// A former of another kind, as large as `before`; `name` as of [`FormerShape::name`].
#[must_use]
pub fn of_kind(name: &str, before: &FormerShape) -> FormerShape {
    /// What a former without figures begins with, mm.
    const FIRST: (f64, f64, f64) = (40.0, 100.0, 50.0);
    let former = Former { shape: before.clone(), base_length: 0.0 };
    let ends = super::contour(&former).and_then(|c| {
        let (tip, base) = (c.segments.first()?.start(), c.segments.last()?.end());
        Some((2.0 * tip.r, 2.0 * base.r, tip.z - base.z))
    });
    let (tip_diameter, base_diameter, length) = ends.unwrap_or(FIRST);
    let rise = ((base_diameter - tip_diameter) / 2.0).max(1.0);
    match name {
        "parabola" => FormerShape::Parabola { constant: length * length / rise, tip_diameter, length },
        "dish" => {
            let rim_diameter = base_diameter.max(1.1 * tip_diameter);
            let depth = (rim_diameter * rim_diameter - tip_diameter * tip_diameter) / 4.0;
            FormerShape::Dish { focal_length: depth / (4.0 * length), tip_diameter, rim_diameter }
        }
        "ellipse" => FormerShape::Ellipse {
            semi_axis: length * 1.5,
            diameter: base_diameter.max(1.2 * tip_diameter),
            tip_diameter,
            length: length.min(length * 1.5 * 0.8),
        },
        "sections" => {
            FormerShape::Sections { sections: vec![Section::line(1, 0.0, base_diameter, length, tip_diameter)] }
        }
        _ => FormerShape::Cone { half_angle_deg: rise.atan2(length).to_degrees(), tip_diameter, length },
    }
}

/// Radius at the base of an ellipse as a share of its largest.
fn base_share(along: f64, diameter: f64, tip: f64, length: f64) -> f64 {
    let start = along * (1.0 - (tip / diameter).powi(2)).max(0.0).sqrt();
    let end = (start - length) / along;
    (1.0 - end * end).max(0.01).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::spinning::shape;

    #[test]
    fn the_base_of_a_cone_turns_its_angle_and_the_tip_its_length() {
        let shell = Shell::default();
        let turned = dragged(&shell, Grip::Base, Point::new(40.0, 70.0), 0.1);
        let FormerShape::Cone { half_angle_deg, .. } = turned.former.shape else { unreachable!("a cone") };
        assert!((half_angle_deg - 45.0).abs() < 1e-9);
        let longer = dragged(&shell, Grip::Tip, Point::new(100.04, 15.0), 0.1);
        let FormerShape::Cone { tip_diameter, length, .. } = longer.former.shape else { unreachable!("a cone") };
        assert!((tip_diameter - 30.0).abs() < 1e-9 && (length - 60.0).abs() < 1e-9);
    }

    #[test]
    fn a_grip_that_is_not_moved_changes_nothing_much() {
        let mut shell = Shell::default();
        for former in [
            FormerShape::Cone { half_angle_deg: 30.0, tip_diameter: 40.0, length: 50.0 },
            FormerShape::Parabola { constant: 273.8, tip_diameter: 40.0, length: 70.0 },
            FormerShape::Dish { focal_length: 60.0, tip_diameter: 44.0, rim_diameter: 180.0 },
            FormerShape::Ellipse { semi_axis: 40.0, diameter: 100.0, tip_diameter: 30.0, length: 30.0 },
            FormerShape::Sections {
                sections: vec![Section::line(1, 0.0, 90.0, 20.0, 60.0), Section::line(2, 20.0, 60.0, 50.0, 40.0)],
            },
        ] {
            shell.former.shape = former;
            let before = shape(&shell).unwrap();
            for (grip, at) in grips(&shell, before.tip(), before.base()) {
                let after = shape(&dragged(&shell, grip, at, 0.0)).unwrap();
                let moved = after.base().distance(before.base()) + after.tip().distance(before.tip());
                assert!(moved < 0.02, "{grip:?} of {:?}: {moved}", shell.former.shape);
            }
        }
    }

    #[test]
    fn every_kind_follows_every_other_with_a_contour() {
        let mut shell = Shell::default();
        for name in
            ["dish", "sections", "parabola", "ellipse", "cone", "ellipse", "dish", "parabola", "sections", "cone"]
        {
            shell.former.shape = of_kind(name, &shell.former.shape);
            assert_eq!(shell.former.shape.name(), name);
            assert!(shape(&shell).is_some(), "{:?}", shell.former.shape);
        }
    }

    #[test]
    fn no_drag_makes_a_former_that_is_none() {
        let shell = Shell::default();
        for to in [Point::new(-50.0, -10.0), Point::new(1e4, 1e4), Point::new(40.0, 0.0)] {
            for grip in [Grip::Tip, Grip::Base] {
                assert!(shape(&dragged(&shell, grip, to, 0.1)).is_some(), "{grip:?} {to:?}");
            }
        }
    }
}
