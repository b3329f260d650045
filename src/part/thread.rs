//! Threads to be cut on a set-up.

use super::shape::{self, SAME_PLACE_MM, is_usable};
use super::{Section, SectionKind};

/// A thread to be cut on a profile or in a bore, mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ThreadSpec {
    /// Row of the thread.
    pub section: u32,
    /// End towards the clamped end.
    pub z1: f64,
    /// End towards the free end.
    pub z2: f64,
    /// Radius of the cylinder that the thread is cut into: the major radius outside, the minor radius in a bore.
    pub crest_radius: f64,
    /// Base (root) radius: the minor radius outside, the major radius in a bore.
    pub base_radius: f64,
    /// Distance from one groove to the next.
    pub pitch: f64,
    /// Grooves that run side by side, at least 1.
    pub starts: u32,
}

impl ThreadSpec {
    /// Advance along the spindle per turn, mm.
    #[must_use]
    pub fn lead(&self) -> f64 {
        self.pitch * f64::from(self.starts)
    }

    /// The thread in the space of the other end of a part of `length` mm.
    pub(super) fn turned_round(&self, length: f64) -> Self {
        Self { z1: length - self.z2, z2: length - self.z1, ..*self }
    }
}

/// Threads of all usable thread rows, in order of position, within a part of `length` mm.
pub(super) fn threads(sections: &[Section], length: f64) -> Vec<ThreadSpec> {
    let mut threads: Vec<ThreadSpec> = sections.iter().filter_map(thread).collect();
    threads.sort_by(|a, b| a.z1.total_cmp(&b.z1));
    clipped(&threads, 0.0, length)
}

fn thread(section: &Section) -> Option<ThreadSpec> {
    let SectionKind::Thread { pitch, starts } = section.kind else { return None };
    (pitch > 0.0 && is_usable(pitch) && shape::curve(section).is_ok()).then_some(ThreadSpec {
        section: section.id,
        z1: section.z1,
        z2: section.z2,
        crest_radius: section.d1 / 2.0,
        base_radius: section.d2 / 2.0,
        pitch,
        starts: starts.max(1),
    })
}

/// What of the threads lies between `from` and `to`.
pub(super) fn clipped(threads: &[ThreadSpec], from: f64, to: f64) -> Vec<ThreadSpec> {
    let inside = threads.iter().map(|t| ThreadSpec { z1: t.z1.max(from), z2: t.z2.min(to), ..*t });
    inside.filter(|t| t.z2 - t.z1 > SAME_PLACE_MM).collect()
}
