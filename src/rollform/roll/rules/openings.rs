//! The openings between the rolls: above 0, not below the thickness of the strip, the clearance not below the drive opening, and
//! nothing taken off a clearance.

use super::Checked;
use crate::diagnostic::Diagnostic;
use crate::document::Pinch;

/// Figures in inches differ from those in mm by rounding, mm.
const EQUAL_MM: f64 = 1e-6;

/// Openings that rolls cannot have or hardly should.
pub(super) fn check(checked: &Checked<'_>) -> Vec<Diagnostic> {
    if let Pinch::Clearance { added } = checked.station.pinch
        && (added < 0.0 || !added.is_finite())
    {
        let message = format!("The clearance added to the thickness is {added} mm; it must be 0 mm or more.");
        return vec![
            Diagnostic::error("roll-clearance-negative", checked.at(), message)
                .with_hint("Enter 0 or a positive figure."),
        ];
    }
    let openings = checked.design.openings;
    let (drive, clearance) = (openings.drive, openings.clearance);
    if checked.design.strip.thickness > 0.0 && !openings.are_usable() {
        let message = format!("The openings are {drive} mm and {clearance} mm; both must be more than 0 mm.");
        return vec![
            Diagnostic::error("roll-opening", checked.at(), message).with_hint("Enter the thickness or more."),
        ];
    }
    if clearance < drive {
        let message = format!(
            "The opening on clearing surfaces is {clearance:.3} mm, that on driving surfaces {drive:.3} mm; the smaller one \
             would drive. The drive opening is taken everywhere."
        );
        let warning = Diagnostic::warning("roll-clearance-below-drive", checked.at(), message);
        return vec![warning.with_hint("Exchange the two figures.")];
    }
    let thickness = checked.design.strip.thickness;
    if drive < thickness - EQUAL_MM {
        let message = format!(
            "The opening on driving surfaces is {drive:.3} mm, and the strip is {thickness:.3} mm thick; the rolls would squeeze it \
             by {:.3} mm.",
            thickness - drive
        );
        return vec![
            Diagnostic::warning("roll-opening-below-strip", checked.at(), message)
                .with_hint("Enter the thickness or more, or choose an opening that follows the thickness."),
        ];
    }
    Vec::new()
}
