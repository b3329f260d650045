//! The follower presses the blank against the flat tip; where it is wider than the tip, the roller runs into it. Its length
//! keeps the tailstock away.

use super::{Checked, setting};
use crate::diagnostic::Diagnostic;

/// Followers wider than the tip, or none.
pub(super) fn check(checked: &Checked<'_>) -> Vec<Diagnostic> {
    length(checked).into_iter().chain(diameter(checked)).collect()
}

fn length(checked: &Checked<'_>) -> Option<Diagnostic> {
    let own = checked.shell.blank.follower_length;
    let message = format!("The follower is {} long; it must be 0 or more.", checked.length(own));
    (own < 0.0).then(|| Diagnostic::error("follower", setting("blank.follower_length"), message))
}

fn diameter(checked: &Checked<'_>) -> Option<Diagnostic> {
    let shape = checked.shape?;
    let (own, tip) = (checked.shell.blank.follower_diameter, 2.0 * shape.tip().r);
    if own > 0.0 && own <= tip {
        return None;
    }
    let message = format!(
        "The follower is {} in diameter; it must be more than 0 and at most the tip's {}.",
        checked.length(own),
        checked.length(tip)
    );
    Some(Diagnostic::error("follower", setting("blank.follower_diameter"), message))
}

#[cfg(test)]
mod tests {
    use super::super::test_shell::*;
    use super::*;

    #[test]
    fn fires_for_a_follower_wider_than_the_tip() {
        let mut shell = cone(30.0);
        assert!(codes(check, &shell).is_empty());
        shell.blank.follower_diameter = 41.0;
        assert_eq!(codes(check, &shell), ["follower"]);
        shell.blank.follower_diameter = 0.0;
        assert_eq!(codes(check, &shell), ["follower"]);
        shell.blank.follower_length = -1.0;
        assert_eq!(codes(check, &shell), ["follower", "follower"]);
    }
}
