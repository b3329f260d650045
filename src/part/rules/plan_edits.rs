//! Figures that replace the planner's are above nothing, and so is the length of a thread's run-out or it is nothing.

use crate::diagnostic::{Diagnostic, Place};
use crate::part::check::Table;

/// Speeds, feeds and depths that no operation can have, and run-outs that no thread can have.
pub(super) fn check(table: &Table<'_>) -> Vec<Diagnostic> {
    let edits = table.part.plan.operations.iter().flat_map(|edit| edit.figures().into_iter().map(move |f| (edit, f)));
    let wrong = edits.filter(|(_, (_, value))| !(value.is_finite() && *value > 0.0));
    let said = wrong.map(|(edit, (key, value))| {
        let what = key.trim_end_matches("_m_per_min");
        let message = format!(
            "The {what} of \"{}\" with tool {} is {value}; it must be above 0. The planner's own is used.",
            edit.operation.kind.name(),
            edit.operation.tool
        );
        Diagnostic::error("operation-figure", Place::Document, message)
            .with_hint("Enter another figure, or take the planner's.")
    });
    let run_out = table.part.threading.run_out;
    let thread = (!(run_out.is_finite() && run_out >= 0.0)).then(|| {
        let message = format!("Threads run out over {run_out} pitches; that must be 0 or more.");
        Diagnostic::error("thread-run-out", Place::Document, message).with_hint("Enter 1 for the usual run-out.")
    });
    said.chain(thread).collect()
}

#[cfg(test)]
mod tests {
    use super::super::test_table::*;
    use super::*;
    use crate::document::{OperationKind, OperationRef, ThreadChoices};

    fn with_depth(depth: f64) -> TurnedPart {
        let mut part = part(vec![]);
        let face = OperationRef { clamping: String::new(), kind: OperationKind::Face, tool: 1 };
        part.plan.change(&face, |edit| edit.depth = Some(depth));
        part
    }

    #[test]
    fn fires_at_nothing_and_below() {
        assert!(check(&table(&with_depth(0.0)))[0].message.contains("depth of \"Face\" with tool 1 is 0"));
        assert_eq!(check(&table(&with_depth(f64::INFINITY))).len(), 1);
        let threading = ThreadChoices { run_out: -1.0, ..ThreadChoices::default() };
        assert_eq!(check(&table(&TurnedPart { threading, ..part(vec![]) }))[0].code, "thread-run-out");
    }

    #[test]
    fn says_nothing_above() {
        assert!(check(&table(&with_depth(0.1))).is_empty());
    }
}
