//! What the rules look at.

use crate::diagnostic::Place;
use crate::document::{Element, ElementKind, RollSet, Station};
use crate::rollform::flower::Flower;
use crate::units::Unit;
use std::collections::BTreeMap;

/// A set with its flower, in mm.
pub(super) struct Subject<'a> {
    pub(super) set: &'a RollSet,
    pub(super) flower: &'a Flower,
    places: BTreeMap<u32, Place>,
    unit: Unit,
}

impl<'a> Subject<'a> {
    pub(super) fn new(set: &'a RollSet, flower: &'a Flower, unit: Unit) -> Self {
        let listed = |list: &[Element], other_side| -> Vec<(u32, Place)> {
            let place = |(number, e): (usize, &Element)| (e.id, Place::Element { id: e.id, number, other_side });
            (1..).zip(list).map(place).collect()
        };
        let [one, other] = [listed(&set.section.elements, false), listed(&set.section.other_side, true)];
        // Of elements with one id the first one is meant.
        let places = other.into_iter().rev().chain(one.into_iter().rev()).collect();
        Self { set, flower, places, unit }
    }

    /// The place of the element with this id; the document if there is none.
    pub(super) fn element(&self, id: u32) -> Place {
        self.places.get(&id).cloned().unwrap_or(Place::Document)
    }

    /// True if the section has an element with this id.
    pub(super) fn has_element(&self, id: u32) -> bool {
        self.places.contains_key(&id)
    }

    /// What the element is called in a sentence.
    pub(super) fn name(&self, id: u32) -> String {
        self.places.get(&id).map_or_else(|| format!("element id {id}"), ToString::to_string)
    }

    /// Both lists with whether they are the other side's.
    pub(super) fn lists(&self) -> [(&'a [Element], bool); 2] {
        [(&self.set.section.elements, false), (&self.set.section.other_side, true)]
    }

    /// The bends of the section: id, inside radius in mm, finished angle in degrees.
    pub(super) fn bends(&self) -> impl Iterator<Item = (u32, f64, f64)> {
        self.set.section.all().filter_map(|e| match e.kind {
            ElementKind::Line { .. } => None,
            ElementKind::Bend { inside_radius, angle_deg } => Some((e.id, inside_radius, angle_deg)),
        })
    }

    /// Finished angle of a bend, degrees.
    pub(super) fn finished_deg(&self, id: u32) -> Option<f64> {
        self.bends().find(|&(bend, ..)| bend == id).map(|(.., angle)| angle)
    }

    /// The stations with their places.
    pub(super) fn stations(&self) -> impl Iterator<Item = (Place, &'a Station)> {
        (1..).zip(&self.set.stations).map(|(number, s)| (Place::Station { id: s.id, number }, s))
    }

    /// The place of the station with this index.
    pub(super) fn station(&self, index: usize) -> Place {
        let id = self.set.stations.get(index).map_or(0, |s| s.id);
        Place::Station { id, number: index + 1 }
    }

    /// A length with its unit, in the unit of the document.
    pub(super) fn length(&self, mm: f64) -> String {
        format!("{:.*} {}", self.unit.decimals(), mm / self.unit.in_mm(), self.unit.symbol())
    }
}

/// An angle with its unit.
pub(super) fn degrees(angle: f64) -> String {
    let rounded = (angle * 1000.0).round() / 1000.0;
    format!("{}°", if rounded == 0.0 { 0.0 } else { rounded })
}

/// What one rule says about a set.
#[cfg(test)]
pub(super) fn found(rule: super::Rule, set: &RollSet) -> Vec<crate::diagnostic::Diagnostic> {
    rule(&Subject::new(set, &Flower::of(set), Unit::Mm))
}
