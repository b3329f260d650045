//! A flow-turned shell. Lengths are in the unit of the document, angles in degrees.

mod former;

use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

pub use former::{Former, FormerShape};

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
    /// Programs edited by hand, by program name: the text that replaces the generated one.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub overrides: BTreeMap<String, String>,
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
            overrides: BTreeMap::new(),
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
    fn unknown_fields_are_refused() {
        let text = serde_json::to_string(&Shell::default()).unwrap();
        assert_eq!(serde_json::from_str::<Shell>(&text).unwrap(), Shell::default());
        let wrong = text.replace("\"width\"", "\"breadth\"");
        assert!(serde_json::from_str::<Shell>(&wrong).unwrap_err().to_string().contains("breadth"));
    }
}
