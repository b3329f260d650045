//! Nodes of a profile: ends of sections that lie at the same place are one node.

use crate::document::TurnedPart;
use crate::part::{Section, SectionKind};

/// Ends closer than this coincide, in the document's unit: far below the last decimal shown.
const SAME: f64 = 1e-6;

/// Which end of a section.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum End {
    /// `z1` and `d1`, towards the clamped end.
    Start,
    /// `z2` and `d2`, towards the free end. Of a thread `z2` and `d1`: both ends have the outside diameter.
    Finish,
}

/// One end of one row of the section table.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct SectionEnd {
    /// Row id.
    pub section: u32,
    /// Which end.
    pub end: End,
}

/// A move of a node to a position, in the document's unit.
#[derive(Debug, Clone, PartialEq)]
pub struct NodeMove {
    /// Ends that lie at the node and go with it in z and diameter: one, or both neighbours of a shared node.
    pub ends: Vec<SectionEnd>,
    /// Ends across a face, at the same z but another diameter: they go with it in z only, so that no gap opens.
    pub follow_z: Vec<SectionEnd>,
    /// New position along the spindle.
    pub z: f64,
    /// New diameter.
    pub diameter: f64,
}

impl NodeMove {
    /// Writes the new position into the rows of `part`. Rows that are gone are passed over.
    pub fn apply(&self, part: &mut TurnedPart) {
        for section in part.sections.iter_mut().chain(&mut part.bore) {
            for end in [End::Start, End::Finish] {
                let this = SectionEnd { section: section.id, end };
                let moves = self.ends.contains(&this);
                if moves || self.follow_z.contains(&this) {
                    *z_of(section, end) = self.z;
                }
                if moves {
                    *diameter_of(section, end) = self.diameter;
                }
            }
        }
    }
}

fn z_of(section: &mut Section, end: End) -> &mut f64 {
    match end {
        End::Start => &mut section.z1,
        End::Finish => &mut section.z2,
    }
}

fn diameter_of(section: &mut Section, end: End) -> &mut f64 {
    match (end, &section.kind) {
        (End::Start, _) | (_, SectionKind::Thread { .. }) => &mut section.d1,
        (End::Finish, _) => &mut section.d2,
    }
}

/// All nodes of a part, each as a move to where it is, in the order of its tables. Those of the bore are apart from those of
/// the outside, even at the same place.
///
/// Ends are compared in the order of their places, so that the time grows with the length of the table and not with its
/// square: this is done in every frame.
pub(super) fn nodes(part: &TurnedPart) -> Vec<NodeMove> {
    nodes_of(&part.sections).into_iter().chain(nodes_of(&part.bore)).collect()
}

fn nodes_of(sections: &[Section]) -> Vec<NodeMove> {
    let mut ends: Vec<Placed> = sections.iter().flat_map(ends_of).enumerate().map(Placed::new).collect();
    ends.sort_by(|a, b| a.z.total_cmp(&b.z));
    let mut nodes: Vec<(usize, NodeMove)> = Vec::new();
    for face in ends.chunk_by_mut(|a, b| near(a.z, b.z)) {
        face.sort_by(|a, b| a.diameter.total_cmp(&b.diameter));
        nodes.extend(nodes_of_face(face));
    }
    nodes.sort_by_key(|(order, _)| *order);
    nodes.into_iter().map(|(_, node)| node).collect()
}

/// An end of a section and where it lies.
struct Placed {
    /// Number of the end in the order of the table.
    order: usize,
    end: SectionEnd,
    z: f64,
    diameter: f64,
}

impl Placed {
    const fn new((order, (end, z, diameter)): (usize, (SectionEnd, f64, f64))) -> Self {
        Self { order, end, z, diameter }
    }
}

/// The nodes of ends at one z, sorted by diameter, each with the order of its first end.
fn nodes_of_face(face: &[Placed]) -> Vec<(usize, NodeMove)> {
    let groups: Vec<&[Placed]> = face.chunk_by(|a, b| near(a.diameter, b.diameter)).collect();
    let ends = |group: &[Placed]| {
        let mut ends: Vec<(usize, SectionEnd)> = group.iter().map(|p| (p.order, p.end)).collect();
        ends.sort_by_key(|(order, _)| *order);
        ends.into_iter().map(|(_, end)| end).collect::<Vec<SectionEnd>>()
    };
    let node = |(index, group): (usize, &&[Placed])| {
        let first = group.iter().min_by_key(|p| p.order)?;
        let others = groups.iter().enumerate().filter(|(other, _)| *other != index);
        let follow_z = others.flat_map(|(_, group)| ends(group)).collect();
        Some((first.order, NodeMove { ends: ends(group), follow_z, z: first.z, diameter: first.diameter }))
    };
    groups.iter().enumerate().filter_map(node).collect()
}

fn ends_of(section: &Section) -> [(SectionEnd, f64, f64); 2] {
    let far = if matches!(section.kind, SectionKind::Thread { .. }) { section.d1 } else { section.d2 };
    let end = |end| SectionEnd { section: section.id, end };
    [(end(End::Start), section.z1, section.d1), (end(End::Finish), section.z2, far)]
}

fn near(a: f64, b: f64) -> bool {
    (a - b).abs() <= SAME
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::plots::sample;

    fn at(section: u32, end: End) -> SectionEnd {
        SectionEnd { section, end }
    }

    #[test]
    fn ends_at_the_same_place_are_one_node() {
        let part = sample::part(vec![Section::line(1, 0.0, 20.0, 10.0, 16.0), Section::line(2, 10.0, 16.0, 30.0, 8.0)]);
        let nodes = nodes(&part);
        assert_eq!(nodes.len(), 3);
        assert_eq!(nodes[1].ends, vec![at(1, End::Finish), at(2, End::Start)]);
        assert!(nodes[1].follow_z.is_empty());
    }

    #[test]
    fn the_other_side_of_a_face_follows_in_z_only() {
        let mut part =
            sample::part(vec![Section::line(1, 0.0, 20.0, 10.0, 20.0), Section::line(2, 10.0, 16.0, 30.0, 8.0)]);
        let mut node = nodes(&part).remove(1);
        assert_eq!((node.ends.clone(), node.follow_z.clone()), (vec![at(1, End::Finish)], vec![at(2, End::Start)]));
        (node.z, node.diameter) = (12.0, 22.0);
        node.apply(&mut part);
        assert_eq!((part.sections[0].z2, part.sections[0].d2), (12.0, 22.0));
        assert_eq!((part.sections[1].z1, part.sections[1].d1), (12.0, 16.0));
    }

    #[test]
    fn both_ends_of_a_thread_move_its_outside_diameter() {
        let mut thread = Section::line(7, 5.0, 12.0, 20.0, 10.2);
        thread.kind = SectionKind::Thread { pitch: 1.75, starts: 1 };
        let mut part = sample::part(vec![thread]);
        let mut node = nodes(&part).remove(1);
        assert_eq!((node.z, node.diameter), (20.0, 12.0));
        node.diameter = 11.0;
        node.apply(&mut part);
        assert_eq!((part.sections[0].d1, part.sections[0].d2), (11.0, 10.2));
    }
}
