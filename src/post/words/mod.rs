//! Programs of word-address controls: one post for all of them, driven by the machine's `[words]`.
//!
//! The form is the one of the published listings of the Fanuc 6T (Wong 1983, Fig. 8.31): words are printed when they
//! change, G0, G2 and G3 always, G1 once; a tool begins with its change position and ends there. What other controls want
//! otherwise is data.

mod arc;
mod block;
mod comments;
mod control;
mod divide;
mod frame;
mod grid;
mod moves;
mod number;
mod recipes;
mod spindle;
mod thread;
mod time;
mod writer;

use super::{Header, Options, PostOutput};
use crate::diagnostic::{Diagnostic, Place};
use crate::geometry::Point;
use crate::machine::{Dialect, Machine, Words};
use crate::turning::{Cut, CutMove, CutterPath, Feed, Speed};
use control::Control;

/// The programs of one set-up. `name` is the item's name; a number is appended where there are several.
#[must_use]
pub fn post(name: &str, path: &CutterPath, options: &Options, header: &Header, machine: &Machine) -> PostOutput {
    let words = match usable(machine, path) {
        Ok(words) => words,
        Err(diagnostic) => return PostOutput { diagnostics: vec![*diagnostic], ..PostOutput::default() },
    };
    let control = Control::new(machine, words, options, path);
    let divide::Divided { programs, diagnostics } = divide::divided(name, path, &control, header);
    PostOutput { programs, side_files: Vec::new(), diagnostics }
}

/// The machine's words, if they and the path can become programs.
fn usable<'a>(machine: &'a Machine, path: &CutterPath) -> Result<&'a Words, Box<Diagnostic>> {
    let at = || Place::Machine { id: machine.id.clone() };
    let Some(words) = &machine.words else {
        let message = format!("The file of {} has no table [words]; its dialect needs one.", machine.name);
        return Err(Box::new(Diagnostic::error("machine-words", at(), message)));
    };
    if words.incremental && machine.dialect == Dialect::Linuxcnc {
        let message = "Increments U and W are axes of their own to LinuxCNC; the machine file asks for them.";
        let hint = "Set words.incremental to false.";
        return Err(Box::new(Diagnostic::error("machine-words", at(), message).with_hint(hint)));
    }
    if words.incremental && !words.codes.retract.is_empty() {
        let message = "After a block of words.codes.retract the tool's place is unknown, and increments need it.";
        let hint = "Leave retract empty, or set words.incremental to false.";
        return Err(Box::new(Diagnostic::error("machine-words", at(), message).with_hint(hint)));
    }
    let wrong =
        path.operations.iter().find(|o| !o.change.is_none_or(Point::is_finite) || !o.moves.iter().all(is_sound));
    if !path.datum.is_finite() || wrong.is_some() {
        let name = wrong.map_or("path", |o| o.name.as_str());
        let message = format!("\"{name}\" has a position, feed or speed that is no number; no program was made.");
        return Err(Box::new(Diagnostic::error("path-not-finite", Place::Document, message)));
    }
    Ok(words)
}

/// True if every figure of the move is a number that a word could hold.
fn is_sound(cut_move: &CutMove) -> bool {
    match cut_move {
        CutMove::Rapid { to } => to.is_finite(),
        CutMove::Line { to, cut } => to.is_finite() && is_sound_cut(cut),
        CutMove::Arc { to, center, cut, .. } => to.is_finite() && center.is_finite() && is_sound_cut(cut),
        CutMove::Thread { to_z, outside_radius, base_radius, pitch, depth_per_cut, rpm } => {
            [*to_z, *outside_radius, *base_radius, *pitch, *depth_per_cut, *rpm].iter().all(|v| v.is_finite())
        }
        CutMove::ThreadPass { to, lead, start_deg, rpm } => {
            to.is_finite() && [*lead, *start_deg, *rpm].iter().all(|v| v.is_finite())
        }
        CutMove::Dwell { seconds } => seconds.is_finite(),
        CutMove::Repeat { step, body, .. } => step.iter().all(|v| v.is_finite()) && body.iter().all(is_sound),
    }
}

/// A clamp may be missing, which is an infinite one.
fn is_sound_cut(cut: &Cut) -> bool {
    let feed = match cut.feed {
        Feed::PerMinute(feed) | Feed::PerRev(feed) => feed,
    };
    let speed = match cut.speed {
        Speed::Rpm(rpm) => rpm.is_finite(),
        Speed::Surface { m_per_min, max_rpm } => m_per_min.is_finite() && !max_rpm.is_nan(),
    };
    feed.is_finite() && speed
}
