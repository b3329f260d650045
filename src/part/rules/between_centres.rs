//! Between centres the work is held at both its ends: that needs a tailstock, and nothing is parted off.

use crate::diagnostic::{Diagnostic, Place};
use crate::document::Holding;
use crate::part::check::Table;

/// Work between centres on a machine without a tailstock, or to be parted off.
pub(super) fn check(table: &Table<'_>) -> Vec<Diagnostic> {
    if table.part.holding != Holding::BetweenCentres {
        return Vec::new();
    }
    let mut found = Vec::new();
    if table.machine.tailstock.is_none() {
        let message =
            format!("The work is held between centres, which takes 2; {} has no tailstock.", table.machine.name);
        let hint = "Hold it in the chuck, or choose another machine.";
        found.push(Diagnostic::error("between-centres", Place::Stock, message).with_hint(hint));
    }
    if table.part.part_off {
        let message = "The work is held between centres; once parted off, 1 of its 2 pieces is held by nothing.";
        let hint = "Hold it in the chuck, or switch parting-off off.";
        found.push(Diagnostic::error("between-centres", Place::Document, message).with_hint(hint));
    }
    found
}

#[cfg(test)]
mod tests {
    use super::super::test_table::*;
    use super::*;
    use crate::machine::Catalog;
    use crate::units::Unit;

    fn between(part_off: bool) -> TurnedPart {
        TurnedPart { holding: Holding::BetweenCentres, part_off, ..part(vec![]) }
    }

    #[test]
    fn fires_without_a_tailstock_and_for_parting_off() {
        assert_eq!(check(&table(&between(false)))[0].at, Place::Stock);
        assert_eq!(check(&table(&between(true))).len(), 2);
    }

    #[test]
    fn says_nothing_on_a_machine_with_a_tailstock_or_in_the_chuck() {
        let catalog = Catalog::shipped();
        let machine = catalog.machine("fanuc-0i").unwrap();
        assert!(check(&Table::new(&between(false), Unit::Mm, machine)).is_empty());
        assert!(check(&table(&TurnedPart { holding: Holding::Chuck, ..between(true) })).is_empty());
    }
}
