//! Where the opening between the rolls changes, and on which face.

use super::face::StripFace;
use super::opening::Openings;
use crate::rollform::strip::Piece;

/// How far the roll faces stand off the strip, mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Relief {
    pub bottom: f64,
    pub top: f64,
}

impl Relief {
    pub(super) const fn of(self, face: StripFace) -> f64 {
        match face {
            StripFace::Bottom => self.bottom,
            StripFace::Top => self.top,
        }
    }

    fn on(face: StripFace, relief: f64, other: f64) -> Self {
        match face {
            StripFace::Bottom => Self { bottom: relief, top: other },
            StripFace::Top => Self { bottom: other, top: relief },
        }
    }
}

/// The reliefs of a wing: the one it starts with, and the new one of every piece in which it changes.
pub(super) struct Reliefs {
    pub start: Relief,
    pub changes: Vec<Option<Relief>>,
}

/// The reliefs of the pieces from the drive surface outwards, of which the first `driven` drive.
pub(super) fn reliefs(pieces: &[Piece], driven: usize, openings: Openings) -> Reliefs {
    let start = Relief { bottom: 0.0, top: openings.drive_excess() };
    let mut changes = vec![None; pieces.len()];
    if openings.relief() > openings.drive_excess() {
        let mut relieved: Option<StripFace> = None;
        let groups = groups(pieces, driven);
        for (position, group) in groups.iter().enumerate() {
            let turns_next = groups.get(position + 1).is_some_and(|next| next.outer != group.outer);
            let changes_here = relieved.is_none() || (turns_next && relieved != Some(group.outer));
            if !changes_here {
                continue;
            }
            let relief = match (relieved, group.outer) {
                // What the drive opening exceeds the thickness by stays on the top roll.
                (None, StripFace::Bottom) => Relief::on(group.outer, openings.relief() - start.top, start.top),
                _ => Relief::on(group.outer, openings.relief(), 0.0),
            };
            relieved = Some(group.outer);
            if let Some(change) = changes.get_mut(group.last) {
                *change = Some(relief);
            }
        }
    }
    Reliefs { start, changes }
}

/// Bent arcs of one sign that follow one another.
struct Group {
    /// The outer face of its arcs.
    outer: StripFace,
    /// Its last arc.
    last: usize,
}

fn groups(pieces: &[Piece], driven: usize) -> Vec<Group> {
    let mut groups: Vec<Group> = Vec::new();
    let mut straight = f64::INFINITY;
    for (index, piece) in pieces.iter().enumerate().skip(driven) {
        if !piece.is_bent() {
            straight += piece.mean.length();
            continue;
        }
        let outer = StripFace::outer(piece);
        let thickness = piece.bottom.start().distance(piece.top.start());
        match groups.last_mut() {
            Some(group) if group.outer == outer && straight <= thickness => group.last = index,
            _ => groups.push(Group { outer, last: index }),
        }
        straight = 0.0;
    }
    groups
}
