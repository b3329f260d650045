//! Scales of technical drawings (ISO 5455).

use crate::units::trimmed;
use std::fmt::Write;

/// A scale.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::papers) struct Scale {
    /// mm on paper for one mm of the part.
    pub(in crate::papers) factor: f64,
}

const fn of(factor: f64) -> Scale {
    Scale { factor }
}

/// The usual scales, the largest first.
pub(in crate::papers) const SCALES: [Scale; 12] = [
    of(50.0),
    of(20.0),
    of(10.0),
    of(5.0),
    of(2.0),
    of(1.0),
    of(1.0 / 2.0),
    of(1.0 / 5.0),
    of(1.0 / 10.0),
    of(1.0 / 20.0),
    of(1.0 / 50.0),
    of(1.0 / 100.0),
];

impl Scale {
    /// `2:1`, `1:5`.
    pub(in crate::papers) fn name(self) -> String {
        let larger = self.factor >= 1.0;
        let figure = trimmed(if larger { self.factor } else { 1.0 / self.factor }, 3);
        let mut name = String::new();
        // Writing to a String cannot fail.
        let _ = if larger { write!(name, "{figure}:1") } else { write!(name, "1:{figure}") };
        name
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scales_are_named_as_drafters_do() {
        let names = SCALES.map(Scale::name);
        assert_eq!(names[..6], ["50:1", "20:1", "10:1", "5:1", "2:1", "1:1"]);
        assert_eq!(names[6..], ["1:2", "1:5", "1:10", "1:20", "1:50", "1:100"]);
        assert_eq!(of(2.5).name(), "2.5:1");
    }
}
