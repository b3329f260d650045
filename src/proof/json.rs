//! The proof as a file for people and other programs, and the path of the tool as it was run.

use super::input::ProofInput;
use super::report::{Motion, Move, ProofReport};
use crate::geometry::{Point, Segment};
use serde::Serialize;

/// Version of the two formats; it changes when a field changes its meaning.
const VERSION: u32 = 1;

/// Contents of `NAME.proof.json`: the verdict first, then everything of the report but playback.
#[derive(Serialize)]
struct ProofFile<'a> {
    verdict: &'static str,
    version: u32,
    programs: Vec<&'a str>,
    errors: usize,
    first_wrong_block: Option<FirstWrong<'a>>,
    #[serde(flatten)]
    report: &'a ProofReport,
}

#[derive(Serialize)]
struct FirstWrong<'a> {
    program: &'a str,
    block: usize,
}

/// One move in program space: x a radius, z from the program zero, mm.
#[derive(Serialize)]
struct PathMove<'a> {
    program: &'a str,
    block: usize,
    motion: Motion,
    from: Position,
    to: Position,
    #[serde(skip_serializing_if = "Option::is_none")]
    center: Option<Position>,
    #[serde(skip_serializing_if = "Option::is_none")]
    ccw: Option<bool>,
    feed_mm_per_min: f64,
    rpm: f64,
    tool: u32,
    starts_s: f64,
    lasts_s: f64,
}

#[derive(Serialize)]
struct Position {
    x: f64,
    z: f64,
}

/// The proof as JSON text, verdict first.
#[must_use]
pub fn proof_json(input: &ProofInput, report: &ProofReport) -> String {
    let file = ProofFile {
        verdict: if report.passed { "passed" } else { "failed" },
        version: VERSION,
        programs: input.programs.iter().map(|p| p.name.as_str()).collect(),
        errors: report.errors().count(),
        first_wrong_block: report.first_wrong_block().map(|(program, block)| FirstWrong { program, block }),
        report,
    };
    // Plain numbers, text and lists cannot fail to become JSON; an empty text would fail its reader, not pass it.
    serde_json::to_string_pretty(&file).unwrap_or_default() + "\n"
}

/// Every move that was run as a JSON list, one move a line, in program space and mm, loops and subroutines unrolled.
#[must_use]
pub fn path_json(input: &ProofInput, report: &ProofReport) -> String {
    let zero_z = input.work.as_ref().map_or(0.0, |work| work.program_zero_z);
    let name = |m: &Move| input.programs.get(m.program).map_or("", |p| p.name.as_str());
    let line = |m: &Move| serde_json::to_string(&path_move(m, name(m), zero_z)).unwrap_or_default();
    let moves: Vec<String> = report.moves.iter().map(line).collect();
    format!("[\n{}\n]\n", moves.join(",\n"))
}

fn path_move<'a>(m: &Move, program: &'a str, zero_z: f64) -> PathMove<'a> {
    let position = |p: Point| Position { x: rounded(p.r), z: rounded(p.z - zero_z) };
    let (center, ccw) = match m.path {
        Segment::Arc { center, ccw, .. } => (Some(position(center)), Some(ccw)),
        Segment::Line { .. } => (None, None),
    };
    PathMove {
        program,
        block: m.block,
        motion: m.motion,
        from: position(m.path.start()),
        to: position(m.path.end()),
        center,
        ccw,
        feed_mm_per_min: rounded(m.feed_mm_per_min),
        rpm: rounded(m.rpm),
        tool: m.tool,
        starts_s: rounded(m.starts_s),
        lasts_s: rounded(m.lasts_s),
    }
}

/// To a millionth, so that sums of increments show no digits that mean nothing; never −0.
fn rounded(value: f64) -> f64 {
    (value * 1e6).round() / 1e6 + 0.0
}
