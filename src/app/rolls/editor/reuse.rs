//! A roll that is the same as another one, turned round or not.

use crate::app::widgets::{choice, form_label};
use crate::document::{RollCopy, RollKind, RollRef, RollSet};
use crate::rollform::Roll;
use crate::session::Session;
use egui::Ui;

/// Width of the label and of the field, points; those of the form below.
const LABEL: f32 = 92.0;
const FIELD: f32 = 158.0;

/// Where the contour of a roll comes from.
pub(super) fn show(ui: &mut Ui, session: &mut Session, set: &RollSet, roll: &Roll) {
    let present = set.roll(roll.roll).and_then(|work| work.same_as);
    let all = choices(set, roll.roll);
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 8.0;
        form_label(ui, "Contour", LABEL);
        if let Some(copy) = choice(ui, "Contour", &present, &all, FIELD) {
            session.edit("contour of a roll", None, |document| {
                if let Some(set) = crate::app::rolls::set_mut(document) {
                    set.roll_mut(roll.roll).same_as = copy;
                }
            });
        }
    });
}

/// Its own design, and every other roll on such an axis, each as it is and turned round.
fn choices(set: &RollSet, own: RollRef) -> Vec<(Option<RollCopy>, String)> {
    let upright = |kind| matches!(kind, RollKind::Left | RollKind::Right);
    let stations = (1_usize..).zip(&set.stations).filter(|(_, station)| !station.without_rolls);
    let others = stations.flat_map(|(number, station)| {
        let kinds = RollKind::ALL.into_iter().filter(|kind| match kind {
            RollKind::Left | RollKind::Right => station.side_right.is_some() || station.side_left.is_some(),
            RollKind::Top | RollKind::Bottom => true,
        });
        kinds.map(move |kind| (number, RollRef { station: station.id, kind }))
    });
    let others = others.filter(|(_, roll)| *roll != own && upright(roll.kind) == upright(own.kind));
    let of_roll = |(number, roll): (usize, RollRef)| {
        let name = format!("as {number}{}", roll.kind.letter());
        [
            (Some(RollCopy { roll, mirrored: false }), name.clone()),
            (Some(RollCopy { roll, mirrored: true }), name + ", turned"),
        ]
    };
    std::iter::once((None, "designed here".to_owned())).chain(others.flat_map(of_roll)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rollform::design;
    use crate::rollform::fixtures::published_rolls;

    #[test]
    fn every_choice_is_a_roll_that_can_be_taken() {
        let mut set = published_rolls();
        for (kind, count) in [(RollKind::Top, 5), (RollKind::Left, 1)] {
            let own = RollRef { station: 3, kind };
            let all = choices(&set, own);
            assert_eq!(all.len(), 1 + 2 * count, "{all:?}");
            for (copy, name) in all {
                set.roll_mut(own).same_as = copy;
                let design = design("x", &set);
                let roll = design.roll(own).unwrap();
                assert!(!roll.diagnostics.iter().any(|d| d.code == "roll-copy"), "{name}");
            }
            set.roll_mut(own).same_as = None;
        }
    }
}
