//! The rules of the process, one a file.

mod base_length;
mod blank;
mod cannot_form;
mod feed;
mod figures;
mod follower;
mod gap_tolerance;
mod half_angle;
mod material;
mod passes;
mod reduction;
mod rig;
mod roller;
mod roller_fit;
mod spinning_ratio;
mod surface_speed;
mod turns_back;

use super::shape::ShellShape;
use crate::diagnostic::{Diagnostic, Place};
use crate::document::Shell;
use crate::units::Unit;

/// What the rules look at.
pub(super) struct Checked<'a> {
    /// The design in mm.
    pub shell: &'a Shell,
    /// Unit of the document, for messages.
    pub unit: Unit,
    /// The shell, where the figures describe one.
    pub shape: Option<&'a ShellShape>,
}

type Rule = fn(&Checked<'_>) -> Vec<Diagnostic>;

const RULES: [Rule; 17] = [
    figures::check,
    cannot_form::check,
    base_length::check,
    turns_back::check,
    half_angle::check,
    passes::check,
    reduction::check,
    spinning_ratio::check,
    material::check,
    blank::check,
    follower::check,
    roller::check,
    roller_fit::check,
    surface_speed::check,
    feed::check,
    gap_tolerance::check,
    rig::check,
];

/// What every rule has to say about a design in mm, whose document shows lengths in `unit`.
#[must_use]
pub fn check(shell_mm: &Shell, shape: Option<&ShellShape>, unit: Unit) -> Vec<Diagnostic> {
    let checked = Checked { shell: shell_mm, unit, shape };
    RULES.iter().flat_map(|rule| rule(&checked)).collect()
}

impl Checked<'_> {
    /// A length in the unit of the document.
    fn length(&self, mm: f64) -> String {
        let decimals = self.unit.decimals();
        format!("{:.decimals$} {}", mm / self.unit.in_mm(), self.unit.symbol())
    }
}

/// A figure of the shell.
fn setting(path: &str) -> Place {
    Place::Setting { path: path.to_owned() }
}

#[cfg(test)]
mod test_shell {
    use super::*;
    use crate::document::FormerShape;
    use crate::spinning::shape;

    /// What a rule says of a shell, by code.
    pub(super) fn codes(rule: Rule, shell: &Shell) -> Vec<String> {
        let shape = shape::shape(shell);
        let said = rule(&Checked { shell, unit: Unit::Mm, shape: shape.as_ref() });
        assert!(said.iter().all(|d| d.message.ends_with('.')), "{said:?}");
        said.into_iter().map(|d| d.code).collect()
    }

    pub(super) fn with_shape(shape: FormerShape) -> Shell {
        let mut shell = Shell::default();
        shell.former.shape = shape;
        shell
    }

    pub(super) fn cone(half_angle_deg: f64) -> Shell {
        with_shape(FormerShape::Cone { half_angle_deg, tip_diameter: 40.0, length: 30.0 })
    }

    #[test]
    fn the_default_shell_is_without_mistakes() {
        let shell = Shell::default();
        assert_eq!(check(&shell, shape::shape(&shell).as_ref(), Unit::Mm), []);
    }
}
