//! A flow-turned shell. Lengths are in the unit of the document, angles in degrees.

use crate::part::Section;
use serde::{Deserialize, Serialize};

/// A shell formed over a former.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Shell {
    /// Id of the machine that the program is written for.
    pub machine: String,
    /// Name of the material, which names its limit of reduction.
    pub material: String,
    /// What the roller and the former are lubricated with, for the setup.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub lubricant: String,
    /// The tool that gives the inside.
    pub former: Former,
    /// What becomes of the wall.
    #[serde(default)]
    pub forming: Forming,
    /// The flat disc that is formed.
    pub blank: Blank,
    /// The forming roller.
    pub roller: Roller,
    /// Passes from the flat blank to the finished shell.
    #[serde(default = "one")]
    pub passes: u32,
    /// Speeds and feed of the program.
    pub speeds: Speeds,
    /// Deviation of the gap between roller and former from the wall that the proof allows.
    pub gap_tolerance: f64,
    /// How the hydraulic rig forms it.
    #[serde(default)]
    pub rig: RigChoices,
}

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

/// What becomes of the wall.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Forming {
    /// Flow-turning (shear forming): every element keeps its radius, and the wall follows the sine law.
    #[default]
    Shear,
    /// Conventional spinning: the wall keeps the blank's thickness, and the diameter shrinks.
    Spinning,
}

/// The flat disc.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Blank {
    /// Thickness.
    pub thickness: f64,
    /// Diameter; by constant volume without.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub diameter: Option<f64>,
    /// Diameter of the follower that presses the blank against the tip.
    pub follower_diameter: f64,
    /// Length of the follower up to the tailstock.
    #[serde(default = "follower_length")]
    pub follower_length: f64,
}

/// The forming roller.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Roller {
    /// Turret station of the roller.
    #[serde(default = "one")]
    pub station: u32,
    /// Radius of the nose.
    pub nose_radius: f64,
    /// Diameter.
    pub diameter: f64,
    /// Width.
    pub width: f64,
    /// Angle between its plane and the plane across the spindle, degrees, positive away from the chuck.
    pub swivel_deg: f64,
    /// Angle between a flank and its plane, degrees.
    #[serde(default = "flank_deg")]
    pub flank_deg: f64,
}

/// Speeds and feed of the program.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Speeds {
    /// Surface speed, m/min.
    pub surface_m_per_min: f64,
    /// Spindle speed that is never exceeded, rev/min.
    pub max_rpm: f64,
    /// Feed along the contour for one turn.
    pub feed_per_rev: f64,
}

/// How the hydraulic rig forms the shell.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RigChoices {
    /// Spindle speed, rev/min.
    pub rpm: f64,
    /// Carriage feed for one turn.
    pub feed_per_rev: f64,
    /// Encoder pulses from one set point to the next.
    pub increment_pulses: u32,
    /// Distance of the roller from its path at which the controller retracts and stops.
    pub path_limit: f64,
}

impl Default for RigChoices {
    /// The settings of the published tests, and a limit that their overshoot keeps.
    fn default() -> Self {
        Self { rpm: 95.0, feed_per_rev: 1.27, increment_pulses: 8, path_limit: 2.0 }
    }
}

const fn one() -> u32 {
    1
}

const fn follower_length() -> f64 {
    40.0
}

const fn flank_deg() -> f64 {
    20.0
}

impl Default for Shell {
    /// The 30° cone of the published tests: 1.6 mm sheet, roller nose 9 mm, form length 50 mm.
    fn default() -> Self {
        Self {
            machine: "linuxcnc".to_owned(),
            material: "ALUMINIUM".to_owned(),
            lubricant: String::new(),
            former: Former {
                shape: FormerShape::Cone { half_angle_deg: 30.0, tip_diameter: 40.0, length: 50.0 },
                base_length: 40.0,
            },
            forming: Forming::Shear,
            blank: Blank { thickness: 1.6, diameter: None, follower_diameter: 36.0, follower_length: 40.0 },
            roller: Roller {
                station: 1,
                nose_radius: 9.0,
                diameter: 100.0,
                width: 30.0,
                swivel_deg: 30.0,
                flank_deg: 20.0,
            },
            passes: 1,
            speeds: Speeds { surface_m_per_min: 350.0, max_rpm: 1500.0, feed_per_rev: 0.5 },
            gap_tolerance: 0.02,
            rig: RigChoices::default(),
        }
    }
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

    /// Its figures with their names in the file.
    #[must_use]
    pub fn figures(&self) -> Vec<(&'static str, f64)> {
        match *self {
            Self::Cone { half_angle_deg, tip_diameter, length } => {
                vec![("half_angle_deg", half_angle_deg), ("tip_diameter", tip_diameter), ("length", length)]
            }
            Self::Parabola { constant, tip_diameter, length } => {
                vec![("constant", constant), ("tip_diameter", tip_diameter), ("length", length)]
            }
            Self::Dish { focal_length, tip_diameter, rim_diameter } => {
                vec![("focal_length", focal_length), ("tip_diameter", tip_diameter), ("rim_diameter", rim_diameter)]
            }
            Self::Ellipse { semi_axis, diameter, tip_diameter, length } => vec![
                ("semi_axis", semi_axis),
                ("diameter", diameter),
                ("tip_diameter", tip_diameter),
                ("length", length),
            ],
            Self::Sections { ref sections } => {
                sections.iter().flat_map(|s| [("z1", s.z1), ("d1", s.d1), ("z2", s.z2), ("d2", s.d2)]).collect()
            }
        }
    }
}

impl Shell {
    /// The same shell with every length multiplied by `factor`, as when the unit changes.
    #[must_use]
    pub fn scaled(&self, factor: f64) -> Self {
        let Self { former, blank, roller, speeds, rig, .. } = self;
        Self {
            former: Former { shape: former.shape.scaled(factor), base_length: former.base_length * factor },
            blank: Blank {
                thickness: blank.thickness * factor,
                diameter: blank.diameter.map(|d| d * factor),
                follower_diameter: blank.follower_diameter * factor,
                follower_length: blank.follower_length * factor,
            },
            roller: Roller {
                nose_radius: roller.nose_radius * factor,
                diameter: roller.diameter * factor,
                width: roller.width * factor,
                ..roller.clone()
            },
            speeds: Speeds { feed_per_rev: speeds.feed_per_rev * factor, ..speeds.clone() },
            gap_tolerance: self.gap_tolerance * factor,
            rig: RigChoices {
                feed_per_rev: rig.feed_per_rev * factor,
                path_limit: rig.path_limit * factor,
                ..rig.clone()
            },
            ..self.clone()
        }
    }

    /// Every figure with its path in the file below the shell.
    #[must_use]
    pub fn figures(&self) -> Vec<(String, f64)> {
        let Self { blank, roller, speeds, rig, .. } = self;
        let shape =
            self.former.shape.figures().into_iter().map(|(name, value)| (format!("former.shape.{name}"), value));
        let others = [
            ("former.base_length", self.former.base_length),
            ("blank.thickness", blank.thickness),
            ("blank.diameter", blank.diameter.unwrap_or_default()),
            ("blank.follower_diameter", blank.follower_diameter),
            ("blank.follower_length", blank.follower_length),
            ("roller.nose_radius", roller.nose_radius),
            ("roller.diameter", roller.diameter),
            ("roller.width", roller.width),
            ("roller.swivel_deg", roller.swivel_deg),
            ("roller.flank_deg", roller.flank_deg),
            ("speeds.surface_m_per_min", speeds.surface_m_per_min),
            ("speeds.max_rpm", speeds.max_rpm),
            ("speeds.feed_per_rev", speeds.feed_per_rev),
            ("gap_tolerance", self.gap_tolerance),
            ("rig.rpm", rig.rpm),
            ("rig.feed_per_rev", rig.feed_per_rev),
            ("rig.path_limit", rig.path_limit),
        ];
        shape.chain(others.map(|(name, value)| (name.to_owned(), value))).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scaling_there_and_back_changes_no_figure() {
        let shell = Shell::default();
        let there = shell.scaled(1.0 / 25.4);
        for ((name, was), (_, is)) in shell.figures().iter().zip(there.scaled(25.4).figures()) {
            assert!((was - is).abs() < 1e-9, "{name}: {was} {is}");
        }
        assert!((there.former.base_length - 40.0 / 25.4).abs() < 1e-12);
    }

    #[test]
    fn every_figure_of_a_contour_can_be_set_by_its_name() {
        for mut shape in [
            FormerShape::Cone { half_angle_deg: 1.0, tip_diameter: 1.0, length: 1.0 },
            FormerShape::Parabola { constant: 1.0, tip_diameter: 1.0, length: 1.0 },
            FormerShape::Dish { focal_length: 1.0, tip_diameter: 1.0, rim_diameter: 1.0 },
            FormerShape::Ellipse { semi_axis: 1.0, diameter: 1.0, tip_diameter: 1.0, length: 1.0 },
        ] {
            for (name, _) in shape.figures() {
                shape.set(name, 7.0);
            }
            shape.set("colour", 8.0);
            assert!(shape.figures().iter().all(|(_, value)| *value == 7.0), "{shape:?}");
        }
    }

    #[test]
    fn unknown_fields_are_refused() {
        let text = serde_json::to_string(&Shell::default()).unwrap();
        assert_eq!(serde_json::from_str::<Shell>(&text).unwrap(), Shell::default());
        let wrong = text.replace("\"width\"", "\"breadth\"");
        assert!(serde_json::from_str::<Shell>(&wrong).unwrap_err().to_string().contains("breadth"));
    }
}
