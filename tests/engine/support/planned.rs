//! What the random parts of the planner's tests have in common.

use proptest::test_runner::{Config, RngSeed};
use turnwright::diagnostic::{Diagnostic, Place};
use turnwright::part::SectionKind;
use turnwright::regen::Derived;

/// So many cases of one seed, none of them kept in a file.
pub(crate) fn drawn(cases: u32, seed: u64) -> Config {
    Config { cases, failure_persistence: None, rng_seed: RngSeed::Fixed(seed), ..Config::default() }
}

/// A figure as people type it.
pub(crate) fn hundredths(v: f64) -> f64 {
    (v * 100.0).round() / 100.0
}

/// What a row of this width between two diameters is: 1 hollow, 2 bulge, else a line; the radius is a share of its chord.
pub(crate) fn bent(bend: u8, width: f64, (d1, d2): (f64, f64), share: f64) -> SectionKind {
    let radius = hundredths((width.hypot((d2 - d1) / 2.0) * share).max(2.0));
    match bend {
        1 => SectionKind::Concave { radius },
        2 => SectionKind::Convex { radius },
        _ => SectionKind::Line,
    }
}

/// True if the planner said that something stays on a row.
pub(crate) fn is_named(derived: &Derived, section: u32) -> bool {
    let of_row = |d: &Diagnostic| matches!(d.at, Place::Section { id, .. } if id == section);
    derived.diagnostics.iter().any(|d| d.code == "not-reached" && of_row(d))
}
