//! The finer the feed, the smoother the surface: 0.0508 to 1.27 mm for one turn (Mohamad 1988, section 1.6).

use super::{Checked, setting};
use crate::diagnostic::{Diagnostic, Severity};

/// The published range, mm/rev.
const RANGE_MM: [f64; 2] = [0.0508, 1.27];

/// Feeds that are none, or outside the range.
pub(super) fn check(checked: &Checked<'_>) -> Vec<Diagnostic> {
    let feed = checked.shell.speeds.feed_per_rev;
    let place = setting("speeds.feed_per_rev");
    if feed.is_nan() || feed <= 0.0 {
        let message = format!("The feed is {} for one turn; it must be more than 0.", checked.length(feed));
        return vec![Diagnostic::error("shell-feed", place, message)];
    }
    let [least, most] = RANGE_MM;
    if feed >= least - 1e-9 && feed <= most + 1e-9 {
        return Vec::new();
    }
    let message = format!(
        "The feed is {} for one turn; best results come between {} and {}.",
        checked.length(feed),
        checked.length(least),
        checked.length(most)
    );
    vec![Diagnostic::new(Severity::Info, "feed-range", place, message)]
}

#[cfg(test)]
mod tests {
    use super::super::test_shell::*;
    use super::*;

    #[test]
    fn fires_outside_the_range_and_for_none() {
        for (feed, code) in [(0.01, "feed-range"), (2.0, "feed-range"), (0.0, "shell-feed"), (-1.0, "shell-feed")] {
            let mut shell = cone(30.0);
            shell.speeds.feed_per_rev = feed;
            assert_eq!(codes(check, &shell), [code]);
        }
        assert!(codes(check, &cone(30.0)).is_empty());
    }
}
