//! Collects findings: one for each rule and block, the worst of all its executions.

use super::report::{Finding, FindingKind};
use crate::diagnostic::Severity;
use crate::geometry::Point;
use std::collections::HashMap;

/// A block of one of the programs.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(super) struct Place {
    /// Program by index.
    pub program: usize,
    /// Block from 1.
    pub block: usize,
}

/// A rule that something was compared with, and how it came out.
#[derive(Debug, Clone)]
pub(super) struct Breach {
    /// Name of the rule; a block has one finding for each.
    pub rule: &'static str,
    /// How much it matters.
    pub severity: Severity,
    /// Kind of finding.
    pub kind: FindingKind,
    /// Place in part space.
    pub at: Option<Point>,
    /// Measured value.
    pub value: f64,
    /// Its limit.
    pub limit: f64,
    /// Sentence with both.
    pub message: String,
}

impl Breach {
    /// An error without a place.
    pub(super) fn error(rule: &'static str, kind: FindingKind, value: f64, limit: f64, message: String) -> Self {
        Self { rule, severity: Severity::Error, kind, at: None, value, limit, message }
    }

    /// The same as a warning.
    pub(super) fn into_warning(self) -> Self {
        Self { severity: Severity::Warning, ..self }
    }

    /// The same as a mere note.
    pub(super) fn into_info(self) -> Self {
        Self { severity: Severity::Info, ..self }
    }

    /// The same at a place.
    pub(super) fn at(self, at: Point) -> Self {
        Self { at: Some(at), ..self }
    }
}

/// Findings so far.
#[derive(Debug, Default)]
pub(super) struct Findings {
    found: Vec<(Place, Breach)>,
    by_rule: HashMap<(Place, &'static str), usize>,
}

impl Findings {
    /// Adds a breach; if the block broke the same rule before, the larger value stays.
    pub(super) fn add(&mut self, place: Place, breach: Breach) {
        if let Some(&index) = self.by_rule.get(&(place, breach.rule)) {
            let known = &mut self.found[index].1;
            if breach.value.abs() > known.value.abs() {
                *known = breach;
            }
        } else {
            self.by_rule.insert((place, breach.rule), self.found.len());
            self.found.push((place, breach));
        }
    }

    /// Adds a breach even if the block broke the same rule before.
    pub(super) fn add_each(&mut self, place: Place, breach: Breach) {
        self.found.push((place, breach));
    }

    /// All findings in order of program and block, under the names of the programs.
    pub(super) fn in_order(mut self, names: &[String]) -> Vec<Finding> {
        self.found.sort_by_key(|(place, _)| *place);
        let finding = |(place, breach): (Place, Breach)| Finding {
            severity: breach.severity,
            kind: breach.kind,
            program: names.get(place.program).cloned().unwrap_or_default(),
            block: place.block,
            at: breach.at,
            value: breach.value,
            limit: breach.limit,
            message: breach.message,
        };
        self.found.into_iter().map(finding).collect()
    }
}
