//! Operations, programs and findings of a clamping.

use super::writer::{Cell, LEFT_MM, LINE_MM, RIGHT_MM, Writer, cell, figure, grey};
use super::{Subject, minutes};
use crate::diagnostic::Severity;
use crate::papers::page::Ink;
use crate::proof::{Finding, Motion};
use crate::regen::Operations;
use crate::turning::Operation;
use crate::turning::figures::Figures;

/// Findings that are told; the others are counted.
const MOST_FINDINGS: usize = 12;

/// Every operation with its tool, blocks and time.
pub(super) fn operations(subject: &Subject<'_>, to: &mut Writer) {
    to.heading("Operations", 2.0 * LINE_MM);
    let operations = Operations::of(subject.item);
    let (times, _) = operations.times();
    for (k, (operation, time)) in subject.item.path.operations.iter().zip(&times).enumerate() {
        to.row(&[
            figure(LEFT_MM, 6.0, (k + 1).to_string()),
            cell(LEFT_MM + 9.0, 50.0, operation.name.as_str()),
            cell(LEFT_MM + 61.0, 14.0, format!("tool {}", operation.tool)),
            grey(LEFT_MM + 77.0, 56.0, feeds_and_speeds(operation, subject)),
            figure(LEFT_MM + 133.0, 19.0, format!("{} blocks", operations.blocks(k).len())),
            figure(LEFT_MM + 153.0, 22.0, minutes(time.total_s())),
        ]);
    }
}

/// Feeds and speeds of an operation: `0.3 mm/rev, 200 m/min`.
fn feeds_and_speeds(operation: &Operation, subject: &Subject<'_>) -> String {
    let figures = Figures::of(operation, subject.machine).texts(subject.unit);
    let wanted = figures.into_iter().filter(|(name, _)| name.starts_with("Feed") || name.ends_with("peed"));
    wanted.map(|(_, text)| text).collect::<Vec<_>>().join(", ")
}

/// Every program in the order of running, with its size and time.
pub(super) fn programs(subject: &Subject<'_>, to: &mut Writer) {
    to.heading("Programs", 2.0 * LINE_MM);
    for (k, program) in subject.item.post.programs.iter().enumerate() {
        let moves = subject.item.proof.moves.iter().filter(|m| m.program == k);
        let (total, cutting) = moves.fold((0.0, 0.0), |(total, cutting), m| {
            let cuts = matches!(m.motion, Motion::Feed | Motion::Thread);
            (total + m.lasts_s, cutting + if cuts { m.lasts_s } else { 0.0 })
        });
        let text = subject.item.programs.get(k);
        let edited = text.is_some_and(|p| p.edited);
        let blocks = if edited {
            text.map_or(0, |p| p.text.lines().filter(|line| !line.trim().is_empty()).count())
        } else {
            program.blocks.len()
        };
        to.row(&[
            cell(LEFT_MM, 60.0, format!("{}.{}", program.name, program.extension)),
            grey(LEFT_MM + 62.0, 35.0, if edited { "edited by hand" } else { "" }),
            figure(LEFT_MM + 95.0, 25.0, format!("{blocks} {}", if edited { "lines" } else { "blocks" })),
            figure(LEFT_MM + 122.0, 24.0, minutes(total)),
            Cell { ink: Ink::Grey, ..figure(LEFT_MM + 146.0, 29.0, format!("cutting {}", minutes(cutting))) },
        ]);
    }
}

/// The errors and warnings of the proof.
pub(super) fn findings(subject: &Subject<'_>, to: &mut Writer) {
    found(&subject.item.proof.findings, subject.item.programs.len() > 1, to);
}

/// Findings by block, and by program where there are `several`.
pub(in crate::papers) fn found(findings: &[Finding], several: bool, to: &mut Writer) {
    let told: Vec<_> = findings.iter().filter(|f| f.severity != Severity::Info).collect();
    if told.is_empty() {
        return;
    }
    to.heading("What the proof found", 2.0 * LINE_MM);
    for finding in told.iter().take(MOST_FINDINGS) {
        let ink = if finding.severity == Severity::Error { Ink::Red } else { Ink::Black };
        let mut place = format!("block {}", finding.block);
        if several {
            place = format!("{} {place}", finding.program);
        }
        let left = LEFT_MM + if several { 44.0 } else { 20.0 };
        to.wrapped_row(
            Some(Cell { ink, ..cell(LEFT_MM, left - LEFT_MM - 2.0, place) }),
            &cell(left, RIGHT_MM - left, finding.message.as_str()),
        );
    }
    if told.len() > MOST_FINDINGS {
        to.row(&[grey(LEFT_MM, 100.0, format!("and {} more", told.len() - MOST_FINDINGS))]);
    }
}
