//! A bend of 0° is no bend, and a strip cannot be bent through its own root: a full turn comes back to where it began.

use super::subject::{Subject, degrees};
use crate::diagnostic::Diagnostic;

/// A full turn, degrees.
const FULL_TURN_DEG: f64 = 360.0;

/// Bends of 0° or of a full turn and more.
pub(super) fn check(subject: &Subject<'_>) -> Vec<Diagnostic> {
    let bad = subject.bends().filter(|&(_, _, angle)| angle == 0.0 || angle.abs() >= FULL_TURN_DEG);
    bad.map(|(id, _, angle)| {
        let message =
            format!("The bend angle is {}; it must not be 0° and be less than 360° either way.", degrees(angle));
        Diagnostic::error("bend-angle", subject.element(id), message)
    })
    .collect()
}

#[cfg(test)]
mod tests {
    use super::super::subject::found;
    use super::*;
    use crate::rollform::fixtures::{bend, vee};

    #[test]
    fn fires_at_0_and_at_a_full_turn() {
        for (angle, count) in [(0.0, 1), (0.1, 0), (-180.0, 0), (359.0, 0), (-360.0, 1)] {
            let mut set = vee(&[90.0]);
            set.section.elements[1] = bend(2, 2.0, angle);
            assert_eq!(found(check, &set).len(), count, "{angle}");
        }
    }
}
