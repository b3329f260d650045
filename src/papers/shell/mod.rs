//! Papers of a flow-turned shell: its drawing with the wall along it, and the setup sheet for the spinning lathe.

mod drawing;
mod picture;
mod sheet;
#[cfg(test)]
mod tests;
mod walls;

use super::number::number;
use crate::diagnostic::{Diagnostic, Place};
use crate::document::{Content, Document, FormerShape, Shell};
use crate::machine::Machine;
use crate::regen::{Derived, ShellDerived};
use crate::units::Unit;

pub(super) use drawing::drawing;
pub(super) use sheet::sheet;

/// True for papers of a document of this kind.
pub(super) fn is_shell(derived: &Derived) -> bool {
    matches!(derived.document.content, Content::Shell(_))
}

/// A shell with all that papers say about it.
struct Subject<'a> {
    document: &'a Document,
    machine: Option<&'a Machine>,
    made: &'a ShellDerived,
}

impl<'a> Subject<'a> {
    /// # Errors
    /// A diagnostic if the figures of the document give no shell.
    fn of(derived: &'a Derived) -> Result<Self, Diagnostic> {
        let Some(made) = &derived.shell else {
            let message = "There is no shell to draw: the figures of former and blank give no contour.";
            let fault = Diagnostic::error("nothing-to-draw", Place::Document, message);
            return Err(fault.with_hint("Correct what is said about the former and the blank first."));
        };
        Ok(Self { document: &derived.document, machine: derived.machine.as_deref(), made })
    }

    const fn unit(&self) -> Unit {
        self.document.unit
    }

    /// The design in mm.
    fn shell(&self) -> &Shell {
        &self.made.shell
    }

    /// A length in mm as a drafter writes it.
    fn figure(&self, mm: f64) -> String {
        number(mm, self.unit())
    }

    /// The same with its unit.
    fn length(&self, mm: f64) -> String {
        format!("{} {}", self.figure(mm), self.unit().symbol())
    }

    /// The former's contour in words: `cone, 30° to the axis`.
    fn contour(&self) -> String {
        match self.shell().former.shape {
            FormerShape::Cone { half_angle_deg, .. } => format!("cone, {half_angle_deg}° to the axis"),
            FormerShape::Parabola { constant, .. } => {
                format!("parabola, travel² = {} × rise", self.length(constant))
            }
            FormerShape::Dish { focal_length, .. } => {
                format!("paraboloid, focus {} from the vertex", self.length(focal_length))
            }
            FormerShape::Ellipse { semi_axis, diameter, .. } if (2.0 * semi_axis - diameter).abs() < 1e-6 => {
                format!("hemisphere, R {}", self.length(semi_axis))
            }
            FormerShape::Ellipse { semi_axis, diameter, .. } => {
                format!("ellipse, {} along the axis, Ø {}", self.length(semi_axis), self.length(diameter))
            }
            FormerShape::Sections { ref sections } => format!("section table of {} rows", sections.len()),
        }
    }
}
