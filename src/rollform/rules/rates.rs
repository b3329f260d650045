//! Prices are not less than nothing.

use super::subject::Subject;
use crate::diagnostic::{Diagnostic, Place};

/// Prices of the set below 0.
pub(super) fn check(subject: &Subject<'_>) -> Vec<Diagnostic> {
    let rates = &subject.set.rates;
    let all = [("price of an hour", rates.machine_per_hour), ("price of a kilogram", rates.price_per_kg)];
    let bad = all.into_iter().filter_map(|(what, value)| Some((what, value.filter(|v| *v < 0.0)?)));
    bad.map(|(what, value)| {
        let message = format!("The {what} is {value}; it must be 0 or more.");
        Diagnostic::error("cost-rates", Place::Document, message).with_hint("Enter it below the list of the rolls.")
    })
    .collect()
}

#[cfg(test)]
mod tests {
    use super::super::subject::found;
    use super::*;
    use crate::rollform::fixtures::vee;

    #[test]
    fn fires_for_prices_below_nothing() {
        let mut set = vee(&[90.0]);
        set.rates.machine_per_hour = Some(60.0);
        assert!(found(check, &set).is_empty());
        set.rates.machine_per_hour = Some(-1.0);
        set.rates.price_per_kg = Some(-0.5);
        assert_eq!(found(check, &set).len(), 2);
    }
}
