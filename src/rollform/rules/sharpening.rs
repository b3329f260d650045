//! Radii are sharpened at stations of the line.

use super::subject::Subject;
use crate::diagnostic::{Diagnostic, Place};
use crate::document::Sharpening;

/// Stations that the line does not have.
pub(super) fn check(subject: &Subject<'_>) -> Vec<Diagnostic> {
    let Sharpening::Stations(ids) = &subject.set.sharpening else { return Vec::new() };
    let unknown = ids.iter().filter(|id| subject.set.station(**id).is_none());
    let message =
        |id: &u32| format!("Radii are sharpened at the station with the id {id}; the line has no such station.");
    unknown.map(|id| Diagnostic::error("sharpening-station", Place::Document, message(id))).collect()
}

#[cfg(test)]
mod tests {
    use super::super::subject::found;
    use super::*;
    use crate::rollform::fixtures::vee;

    #[test]
    fn fires_for_stations_that_are_gone() {
        let mut set = vee(&[45.0, 90.0]);
        set.sharpening = Sharpening::Stations(vec![2, 7]);
        assert_eq!(found(check, &set).len(), 1);
        set.sharpening = Sharpening::AllButLast;
        assert!(found(check, &set).is_empty());
    }
}
