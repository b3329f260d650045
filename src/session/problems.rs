//! All that is to be said about a document and its programs, findable by row.

use crate::diagnostic::{Diagnostic, Place, Severity};
use crate::proof::{Finding, FindingKind};
use crate::regen::Derived;
use std::collections::HashMap;

/// The messages, worst first, and which of them are about a row of the section tables.
#[derive(Debug, Default)]
pub(super) struct Problems {
    all: Vec<Diagnostic>,
    /// Positions in `all` by the id of a row.
    of_rows: HashMap<u32, Vec<usize>>,
    counts: HashMap<Severity, usize>,
}

impl Problems {
    /// What `derived` has to say, and why it could not be made, if so.
    pub(super) fn collect(fault: Option<&str>, derived: Option<&Derived>) -> Self {
        let mut all: Vec<Diagnostic> = fault.map(of_fault).into_iter().collect();
        if let Some(derived) = derived {
            all.extend(derived.diagnostics.iter().cloned());
            all.extend(derived.setups.iter().flat_map(|s| s.proof.findings.iter().map(of_finding)));
        }
        all.sort_by_key(|d| std::cmp::Reverse(d.severity));
        let (mut of_rows, mut counts) = (HashMap::<u32, Vec<usize>>::new(), HashMap::new());
        for (index, problem) in all.iter().enumerate() {
            *counts.entry(problem.severity).or_default() += 1;
            if let Place::Section { id, .. } = &problem.at {
                of_rows.entry(*id).or_default().push(index);
            }
        }
        Self { all, of_rows, counts }
    }

    pub(super) fn all(&self) -> &[Diagnostic] {
        &self.all
    }

    pub(super) fn of_row(&self, id: u32) -> impl Iterator<Item = &Diagnostic> {
        self.of_rows.get(&id).into_iter().flatten().filter_map(|&index| self.all.get(index))
    }

    pub(super) fn count(&self, severity: Severity) -> usize {
        self.counts.get(&severity).copied().unwrap_or(0)
    }
}

fn of_fault(message: &str) -> Diagnostic {
    let text = format!("The program stopped while it worked on this document: {message}.");
    let hint = "Undo the last edit. The document is safe and can be saved.";
    Diagnostic::error("regeneration-fault", Place::Document, text).with_hint(hint)
}

fn of_finding(finding: &Finding) -> Diagnostic {
    let at = Place::Block { program: finding.program.clone(), block: finding.block };
    Diagnostic::new(finding.severity, code_of(finding.kind), at, finding.message.clone())
}

/// Stable short name of a kind of finding.
#[must_use]
pub const fn code_of(kind: FindingKind) -> &'static str {
    match kind {
        FindingKind::Unreadable => "unreadable",
        FindingKind::Gouge => "gouge",
        FindingKind::RapidContact => "rapid-contact",
        FindingKind::FlankCollision => "flank-collision",
        FindingKind::HolderCollision => "holder-collision",
        FindingKind::ChuckCollision => "chuck-collision",
        FindingKind::Leftover => "leftover",
        FindingKind::OverTravel => "over-travel",
        FindingKind::OutsideLimits => "outside-limits",
        FindingKind::NotClosed => "not-closed",
        FindingKind::Control => "control",
        FindingKind::Structure => "structure",
        FindingKind::Lint => "lint",
        FindingKind::Power => "power",
        FindingKind::TailstockCollision => "tailstock-collision",
    }
}
