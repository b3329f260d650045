//! What the operator has asked for.

use crate::spinning::control::{Plan, Watch};
use crate::spinning::interpolation::SetPoint;
use crate::spinning::published::{
    Arithmetic, ConeParameters, LARGEST_STEP, ParabolaParameters, cone_points, parabola_points,
};

/// A contour to be run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Job {
    /// The published cone.
    Cone(ConeParameters),
    /// The published parabola.
    Parabola(ParabolaParameters),
    /// The shell of the document.
    Design,
}

impl Job {
    /// The run of this job; `design` are the exact set points of the document's shell.
    #[must_use]
    pub fn plan(&self, design: &[SetPoint], arithmetic: Arithmetic, watch: Option<Watch>) -> Plan {
        let plan = match self {
            Self::Cone(cone) => Plan::published(&cone_points(cone, arithmetic), cone.roller_position()),
            Self::Parabola(p) => Plan::published(&parabola_points(p, arithmetic), p.roller_position()),
            Self::Design => Plan::along(design, design_start(design)),
        };
        Plan { watch, ..plan }
    }

    /// Name with its figures.
    #[must_use]
    pub fn name(&self) -> String {
        match self {
            Self::Cone(c) => {
                format!("cone {}°, {} mm, {} pulses", c.angle_deg(), c.form_length_mm(), c.increment_pulses())
            }
            Self::Parabola(p) => format!("parabola {} mm", p.form_length_mm()),
            Self::Design => "shell of the document".to_owned(),
        }
    }
}

/// Reading at which the roller begins a design: the published tip, or further in where the contour needs more of the stroke.
fn design_start(design: &[SetPoint]) -> i32 {
    /// The published start at a former's tip, steps.
    const TIP: i32 = 602;
    /// Kept free at the datum, steps.
    const FREE: i32 = 16;
    let rise = design.iter().map(|p| p.steps).max().unwrap_or(0);
    let most = i32::from(LARGEST_STEP) - FREE;
    // A rise beyond the stroke is left to the controller, which says so and moves nothing.
    TIP.max((rise + FREE).min(most))
}
