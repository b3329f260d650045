//! The wall becomes as thin as the sine law says; more than the material bears tears it. Where several passes follow one
//! another without annealing, the reduction still adds up.

use super::{Checked, setting};
use crate::diagnostic::Diagnostic;
use crate::spinning::material::{LARGEST_REDUCTION, material};

/// Reductions beyond the material's limit.
pub(super) fn check(checked: &Checked<'_>) -> Vec<Diagnostic> {
    let Some(thinnest) = checked.shape.and_then(|s| s.thinnest().map(|t| (s, t))) else { return Vec::new() };
    let (shape, station) = thinnest;
    let known = material(&checked.shell.material);
    let limit = known.map_or(LARGEST_REDUCTION, |m| m.max_reduction);
    if station.reduction <= limit + 1e-9 {
        return Vec::new();
    }
    let message = format!(
        "The wall is reduced by {:.1} % to {} at {} from the tip; {} bears {:.0} %.",
        station.reduction * 100.0,
        checked.length(station.wall),
        checked.length(shape.tip().z - station.at.z),
        known.map_or("any material", |m| m.name),
        limit * 100.0,
    );
    let hint = "Make the wall less steep, choose another material, or form it by conventional spinning.";
    vec![Diagnostic::error("reduction", setting("former.shape"), message).with_hint(hint)]
}

#[cfg(test)]
mod tests {
    use super::super::test_shell::*;
    use super::*;
    use crate::spinning::Shell;

    #[test]
    fn fires_beyond_the_limit_of_the_material() {
        // 1 − sin 14° = 75.8 %, 1 − sin 15° = 74.1 %.
        assert_eq!(codes(check, &cone(14.0)), ["reduction"]);
        assert!(codes(check, &cone(15.0)).is_empty());
        assert_eq!(codes(check, &Shell { material: "EN AW-2024".to_owned(), ..cone(29.0) }), ["reduction"]);
        assert!(codes(check, &Shell { material: "unheard of".to_owned(), ..cone(14.0) }).is_empty());
    }
}
