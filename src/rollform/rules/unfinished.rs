//! A flower may end before the finished section, as the published one does; whoever reads it should know.

use super::subject::{Subject, degrees};
use crate::diagnostic::Diagnostic;
use crate::rollform::bends::{Stage, angles_deg};

/// Angles closer to the finished one than this have reached it, degrees.
const REACHED_DEG: f64 = 1e-6;

/// Bends that the last station leaves short of their finished angle.
pub(super) fn check(subject: &Subject<'_>) -> Vec<Diagnostic> {
    let Some(last) = subject.set.stations.len().checked_sub(1) else { return Vec::new() };
    let angles = angles_deg(subject.set, Stage::Station(last));
    let short: Vec<(u32, f64, f64)> = subject
        .bends()
        .filter_map(|(id, _, finished)| Some((id, *angles.get(&id)?, finished)))
        .filter(|(_, angle, finished)| finished.abs() - angle.abs() > REACHED_DEG)
        .collect();
    let worst = short.iter().max_by(|a, b| (a.2 - a.1).abs().total_cmp(&(b.2 - b.1).abs()));
    let Some(&(id, angle, finished)) = worst else { return Vec::new() };
    let (name, number) = (subject.name(id), short.len());
    let bends = if number == 1 { "1 bend is".to_owned() } else { format!("{number} bends are") };
    let message = format!(
        "After the last station {bends} not finished; the furthest is {name}, at {} of {}.",
        degrees(angle),
        degrees(finished)
    );
    vec![
        Diagnostic::new(crate::diagnostic::Severity::Info, "unfinished-flower", subject.station(last), message)
            .with_related(subject.element(id)),
    ]
}

#[cfg(test)]
mod tests {
    use super::super::subject::found;
    use super::*;
    use crate::rollform::fixtures::{published, vee};

    #[test]
    fn says_how_far_the_last_station_gets() {
        assert!(found(check, &vee(&[45.0, 90.0])).is_empty());
        assert!(found(check, &vee(&[])).is_empty());
        // Elements 2, 4 and 12 are never bent, and 20 reaches 75 of 180 degrees.
        let found = found(check, &published());
        assert!(found[0].message.contains("4 bends") && found[0].message.contains("-75° of -180°"), "{found:?}");
    }
}
