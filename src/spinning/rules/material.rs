//! The limit of reduction belongs to a material; without one only the general limit is known.

use super::{Checked, setting};
use crate::diagnostic::{Diagnostic, Severity};
use crate::spinning::material::{LARGEST_REDUCTION, material, materials};

/// Materials that are not in the table.
pub(super) fn check(checked: &Checked<'_>) -> Vec<Diagnostic> {
    let name = &checked.shell.material;
    if material(name).is_some() {
        return Vec::new();
    }
    let known: Vec<&str> = materials().iter().map(|m| m.name).collect();
    let message = format!(
        "The limit of reduction of \"{name}\" is not known; the general {:.0} % is taken.",
        LARGEST_REDUCTION * 100.0
    );
    let said = Diagnostic::new(Severity::Info, "shell-material", setting("material"), message);
    vec![said.with_hint(format!("Known are {}.", known.join(", ")))]
}

#[cfg(test)]
mod tests {
    use super::super::test_shell::*;
    use super::*;
    use crate::spinning::Shell;

    #[test]
    fn fires_for_what_is_not_in_the_table() {
        assert_eq!(codes(check, &Shell { material: "GOLD".to_owned(), ..cone(30.0) }), ["shell-material"]);
        assert!(codes(check, &cone(30.0)).is_empty());
    }
}
