//! The former of a shell and the contours that it can have.

use crate::part::{Section, SectionKind};
use serde::{Deserialize, Serialize};
use std::borrow::Cow;

/// The former (mandrel): a flat tip that holds the blank, the contour, and a cylinder behind it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Former {
    /// The contour between tip and base.
    pub shape: FormerShape,
    /// Length of the cylinder behind the contour, up to the chuck's face.
    pub base_length: f64,
}

/// Contours of a former, from its flat tip towards the chuck.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(tag = "type", rename_all = "snake_case", deny_unknown_fields)]
pub enum FormerShape {
    /// A straight cone.
    Cone {
        /// Angle between wall and axis, degrees.
        half_angle_deg: f64,
        /// Diameter of the flat tip.
        tip_diameter: f64,
        /// Length along the axis.
        length: f64,
    },
    /// The parabola of the published controller: the radius grows with the square of the travel from the tip,
    /// `travel² = constant · rise`. It leaves the tip parallel to the axis.
    Parabola {
        /// The constant 4a.
        constant: f64,
        /// Diameter of the tip, at the vertex.
        tip_diameter: f64,
        /// Length along the axis.
        length: f64,
    },
    /// A dish whose inside is a paraboloid about the axis, as reflectors have: `r² = 4 · focus · depth`.
    Dish {
        /// Distance from the vertex to the focus.
        focal_length: f64,
        /// Diameter of the flat tip.
        tip_diameter: f64,
        /// Diameter of the rim.
        rim_diameter: f64,
    },
    /// A hemisphere or half an ellipsoid about the axis, from its flat tip towards its largest diameter.
    Ellipse {
        /// Semi-axis along the spindle; that of a hemisphere is half its diameter.
        semi_axis: f64,
        /// Largest diameter.
        diameter: f64,
        /// Diameter of the flat tip.
        tip_diameter: f64,
        /// Length along the axis from the tip.
        length: f64,
    },
    /// Any contour, as the section table of a turned part; the last row ends at the tip.
    Sections {
        /// The table, positions from the base.
        sections: Vec<Section>,
    },
}

impl FormerShape {
    /// Name for people.
    #[must_use]
    pub const fn name(&self) -> &'static str {
        match self {
            Self::Cone { .. } => "cone",
            Self::Parabola { .. } => "parabola",
            Self::Dish { .. } => "dish",
            Self::Ellipse { .. } => "ellipse",
            Self::Sections { .. } => "sections",
        }
    }

    /// The same contour with every length multiplied by `factor`.
    #[must_use]
    pub fn scaled(&self, factor: f64) -> Self {
        match *self {
            Self::Cone { half_angle_deg, tip_diameter, length } => {
                Self::Cone { half_angle_deg, tip_diameter: tip_diameter * factor, length: length * factor }
            }
            Self::Parabola { constant, tip_diameter, length } => Self::Parabola {
                constant: constant * factor,
                tip_diameter: tip_diameter * factor,
                length: length * factor,
            },
            Self::Dish { focal_length, tip_diameter, rim_diameter } => Self::Dish {
                focal_length: focal_length * factor,
                tip_diameter: tip_diameter * factor,
                rim_diameter: rim_diameter * factor,
            },
            Self::Ellipse { semi_axis, diameter, tip_diameter, length } => Self::Ellipse {
                semi_axis: semi_axis * factor,
                diameter: diameter * factor,
                tip_diameter: tip_diameter * factor,
                length: length * factor,
            },
            Self::Sections { ref sections } => {
                Self::Sections { sections: sections.iter().map(|s| s.scaled(factor)).collect() }
            }
        }
    }

    /// Sets the figure with this name in the file; one that the contour does not have is left alone.
    pub fn set(&mut self, name: &str, value: f64) {
        let ((Self::Cone { half_angle_deg: figure, .. }, "half_angle_deg")
        | (
            Self::Cone { tip_diameter: figure, .. }
            | Self::Parabola { tip_diameter: figure, .. }
            | Self::Dish { tip_diameter: figure, .. }
            | Self::Ellipse { tip_diameter: figure, .. },
            "tip_diameter",
        )
        | (
            Self::Cone { length: figure, .. }
            | Self::Parabola { length: figure, .. }
            | Self::Ellipse { length: figure, .. },
            "length",
        )
        | (Self::Parabola { constant: figure, .. }, "constant")
        | (Self::Dish { focal_length: figure, .. }, "focal_length")
        | (Self::Dish { rim_diameter: figure, .. }, "rim_diameter")
        | (Self::Ellipse { semi_axis: figure, .. }, "semi_axis")
        | (Self::Ellipse { diameter: figure, .. }, "diameter")) = (self, name)
        else {
            return;
        };
        *figure = value;
    }

    /// Its figures with their names in the file; those of a section table as `sections[0].z1`.
    #[must_use]
    pub fn figures(&self) -> Vec<(Cow<'static, str>, f64)> {
        let named = |figures: &[(&'static str, f64)]| figures.iter().map(|(n, v)| (Cow::Borrowed(*n), *v)).collect();
        match *self {
            Self::Cone { half_angle_deg, tip_diameter, length } => {
                named(&[("half_angle_deg", half_angle_deg), ("tip_diameter", tip_diameter), ("length", length)])
            }
            Self::Parabola { constant, tip_diameter, length } => {
                named(&[("constant", constant), ("tip_diameter", tip_diameter), ("length", length)])
            }
            Self::Dish { focal_length, tip_diameter, rim_diameter } => {
                named(&[("focal_length", focal_length), ("tip_diameter", tip_diameter), ("rim_diameter", rim_diameter)])
            }
            Self::Ellipse { semi_axis, diameter, tip_diameter, length } => named(&[
                ("semi_axis", semi_axis),
                ("diameter", diameter),
                ("tip_diameter", tip_diameter),
                ("length", length),
            ]),
            Self::Sections { ref sections } => sections.iter().enumerate().flat_map(row_figures).collect(),
        }
    }
}

/// Figures of a row of the section table with their names.
fn row_figures((index, row): (usize, &Section)) -> Vec<(Cow<'static, str>, f64)> {
    let of_kind: &[(&str, f64)] = match row.kind {
        SectionKind::Line => &[],
        SectionKind::Concave { radius } | SectionKind::Convex { radius } => &[("radius", radius)],
        SectionKind::Thread { pitch, .. } => &[("pitch", pitch)],
        SectionKind::ParabolaAlongZ { z3, d3, .. } | SectionKind::ParabolaAlongX { z3, d3, .. } => {
            &[("z3", z3), ("d3", d3)]
        }
    };
    let ends = [("z1", row.z1), ("d1", row.d1), ("z2", row.z2), ("d2", row.d2)];
    let named = |(name, value): &(&str, f64)| (Cow::Owned(format!("sections[{index}].{name}")), *value);
    ends.iter().chain(of_kind).map(named).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_figure_of_a_contour_can_be_set_by_its_name() {
        for mut shape in [
            FormerShape::Cone { half_angle_deg: 1.0, tip_diameter: 1.0, length: 1.0 },
            FormerShape::Parabola { constant: 1.0, tip_diameter: 1.0, length: 1.0 },
            FormerShape::Dish { focal_length: 1.0, tip_diameter: 1.0, rim_diameter: 1.0 },
            FormerShape::Ellipse { semi_axis: 1.0, diameter: 1.0, tip_diameter: 1.0, length: 1.0 },
        ] {
            for (name, _) in shape.figures() {
                shape.set(&name, 7.0);
            }
            shape.set("colour", 8.0);
            assert!(shape.figures().iter().all(|(_, value)| *value == 7.0), "{shape:?}");
        }
    }

    #[test]
    fn figures_of_a_table_are_named_by_their_row_and_none_is_left_out() {
        let arc = Section { kind: SectionKind::Concave { radius: 9.0 }, ..Section::line(2, 4.0, 3.0, 5.0, 2.0) };
        let shape = FormerShape::Sections { sections: vec![Section::line(1, 0.0, 6.0, 4.0, 3.0), arc] };
        let figures = shape.figures();
        assert_eq!(figures.len(), 9);
        assert_eq!((figures[0].0.as_ref(), &figures[8]), ("sections[0].z1", &("sections[1].radius".into(), 9.0)));
    }
}
