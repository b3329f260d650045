//! Everything that is designed from a set: strip and rolls of every station, in one call.

use super::drive::DriveDiameters;
use super::editor::{EditFault, decided, edited};
use super::part::turned_part;
use super::roll::{DesignedRoll, Frame, Openings, RollElement, StationRolls, contour, rules, station_rolls};
use super::strip::Strip;
use crate::diagnostic::{Diagnostic, Place, Severity, has_errors};
use crate::document::{RollCopy, RollKind, RollRef, RollSet, TurnedPart};
use crate::geometry::{Contour, Segment};

/// Strip and rolls of every station, mm.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct RollDesign {
    /// The stations in the direction of the strip.
    pub stations: Vec<StationDesign>,
    /// What there is to say about section, flower and line.
    pub diagnostics: Vec<Diagnostic>,
}

/// Strip and rolls of one station, mm.
#[derive(Debug, Clone, PartialEq)]
pub struct StationDesign {
    /// Id of the station.
    pub station: u32,
    /// Its number in the line, from 1.
    pub number: usize,
    /// The strip there.
    pub strip: Strip,
    /// The openings between its rolls.
    pub openings: Openings,
    /// Its rolls as they are to be turned: top, bottom, left, right, as far as there are any.
    pub rolls: Vec<Roll>,
    /// Where top and bottom roll drive the strip, and with which diameters.
    pub drive: Option<DriveDiameters>,
}

/// A roll of a set: its name and the part it is turned as.
#[derive(Debug, Clone, PartialEq)]
pub struct Roll {
    /// Which roll.
    pub roll: RollRef,
    /// Its name: `1470b-2T`.
    pub name: String,
    /// Its elements with their names, edits carried out; side faces included.
    pub elements: Vec<RollElement>,
    /// The elements as designed, before any edit.
    pub designed: Vec<RollElement>,
    /// Edits that do not fit.
    pub faults: Vec<EditFault>,
    /// Where it is in strip space.
    pub frame: Frame,
    /// The part, mm.
    pub part: TurnedPart,
    /// What there is to say about it.
    pub diagnostics: Vec<Diagnostic>,
}

impl RollDesign {
    /// Every roll, station by station.
    pub fn rolls(&self) -> impl Iterator<Item = &Roll> {
        self.stations.iter().flat_map(|station| &station.rolls)
    }

    /// True if no error is said about a roll or its station.
    #[must_use]
    pub fn is_sound(&self, roll: &Roll) -> bool {
        let about = |at: &Place| match at {
            Place::Roll { name } => *name == roll.name,
            Place::Station { id, .. } => *id == roll.roll.station,
            _ => false,
        };
        !has_errors(&roll.diagnostics)
            && !self.diagnostics.iter().any(|d| d.severity == Severity::Error && about(&d.at))
    }

    /// A roll.
    #[must_use]
    pub fn roll(&self, roll: RollRef) -> Option<&Roll> {
        self.rolls().find(|r| r.roll == roll)
    }
}

impl Roll {
    /// The contour in roll space, side faces included.
    #[must_use]
    pub fn contour(&self) -> Contour {
        contour(&self.elements)
    }

    /// The contour in the strip space of its station, closed along the axis.
    #[must_use]
    pub fn outline(&self) -> Contour {
        outline(&self.elements, &self.frame)
    }
}

/// A contour in strip space, closed along the axis.
fn outline(elements: &[RollElement], frame: &Frame) -> Contour {
    let mut segments: Vec<Segment> = elements.iter().map(|e| frame.to_strip(&e.segment)).collect();
    if let Some((first, last)) = segments.first().zip(segments.last()) {
        segments.push(Segment::line(last.end(), first.start()));
    }
    Contour::new(segments)
}

/// Designs the set `name`, which is in mm.
#[must_use]
pub fn design(name: &str, set: &RollSet) -> RollDesign {
    let plain: Vec<StationRolls> = (0..set.stations.len()).filter_map(|index| station_rolls(set, index)).collect();
    let mut design = RollDesign::default();
    for (number, (station, rolls)) in (1..).zip(set.stations.iter().zip(&plain)) {
        let rolls_here: Vec<Roll> = rolls
            .rolls
            .iter()
            .map(|designed| {
                let roll = RollRef { station: station.id, kind: designed.kind };
                roll_of(name, number, roll, designed, &plain, set)
            })
            .collect();
        let here = StationDesign {
            station: station.id,
            number,
            strip: rolls.strip.clone(),
            openings: rolls.openings,
            drive: DriveDiameters::of(set, station, &rolls.strip, &rolls_here),
            rolls: rolls_here,
        };
        design.diagnostics.extend(rules::check(set, station, &here));
        design.stations.push(here);
    }
    design.diagnostics.extend(rules::check_line(set, &design.stations));
    design
}

/// A roll of a station with its edits, as a part.
fn roll_of(name: &str, number: usize, roll: RollRef, own: &DesignedRoll, all: &[StationRolls], set: &RollSet) -> Roll {
    let name = format!("{name}-{number}{}", roll.kind.letter());
    let work = decided(set, roll);
    let base = work.same_as.and_then(|copy| copied(set, all, copy, own, 0));
    let designed = base.unwrap_or_else(|| own.clone());
    let done = edited(&designed.elements, &work.edits);
    let at = Place::Roll { name: name.clone() };
    let mut diagnostics: Vec<Diagnostic> = done.faults.iter().map(|fault| said(fault, &at)).collect();
    if work.same_as.is_some_and(|copy| copied(set, all, copy, own, 0).is_none()) {
        let message = "The roll is to be the same as another one, and that one is not there.";
        diagnostics.push(Diagnostic::error("roll-copy", at.clone(), message).with_hint("Choose another roll."));
    }
    let (part, more) = turned_part(set, &work, &done.elements, &at);
    diagnostics.extend(more);
    Roll {
        roll,
        name,
        elements: done.elements,
        designed: designed.elements,
        faults: done.faults,
        frame: designed.frame,
        part,
        diagnostics,
    }
}

fn said(fault: &EditFault, at: &Place) -> Diagnostic {
    let message = format!("Edit {}: {}", fault.edit, fault.message);
    Diagnostic::error(fault.code, at.clone(), message).with_hint(fault.hint)
}

/// Another roll with its edits, at the place of `own`.
fn copied(
    set: &RollSet,
    all: &[StationRolls],
    copy: RollCopy,
    own: &DesignedRoll,
    depth: usize,
) -> Option<DesignedRoll> {
    /// Rolls that are the same as others that are the same as others; more is a circle.
    const MOST: usize = 20;
    if depth > MOST {
        return None;
    }
    let index = set.stations.iter().position(|s| s.id == copy.roll.station)?;
    let source = all.get(index)?.rolls.iter().find(|r| r.kind == copy.roll.kind)?;
    let work = decided(set, copy.roll);
    let source = match work.same_as {
        Some(further) => copied(set, all, further, source, depth + 1)?,
        None => source.clone(),
    };
    let elements = edited(&source.elements, &work.edits).elements;
    let width = contour(&elements).bounds().map_or(0.0, |b| b.max.z);
    let (elements, face) = if copy.mirrored {
        let turned = elements.iter().rev().map(|e| RollElement {
            segment: e.segment.mirrored_at_z(width / 2.0).reversed(),
            names: e.names.iter().rev().map(|name| name.mirrored()).collect(),
        });
        // On a level axis it lies mirrored at the middle of the strip; beside the strip it stays at its height.
        let level = matches!(own.kind, RollKind::Top | RollKind::Bottom);
        (turned.collect(), if level { -(source.frame.face + width) } else { source.frame.face })
    } else {
        (elements, source.frame.face)
    };
    Some(DesignedRoll { kind: own.kind, elements, frame: Frame { face, ..own.frame } })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnostic::has_errors;
    use crate::document::{EditAction, ElementName, RollEdit, RollKind, Side};
    use crate::rollform::fixtures::published_rolls;

    #[test]
    fn every_station_has_its_rolls_by_name() {
        let design = design("1470b", &published_rolls());
        let names: Vec<&str> = design.rolls().map(|r| r.name.as_str()).collect();
        let wanted = ["1T", "1B", "2T", "2B", "3T", "3B", "3L", "3R"].map(|n| format!("1470b-{n}"));
        assert_eq!(names, wanted);
        assert!(!has_errors(&design.diagnostics), "{:?}", design.diagnostics);
        assert!(design.rolls().all(|r| !has_errors(&r.diagnostics)));
    }

    #[test]
    fn the_published_top_roll_is_a_part_on_the_next_standard_blank() {
        let design = design("1470b", &published_rolls());
        let part = &design.rolls().nth(2).unwrap().part;
        assert_eq!((part.bar_diameter, part.sections.len()), (160.0, 32));
        assert!((part.length - 159.303).abs() < 0.005);
    }

    #[test]
    fn a_roll_used_again_has_contour_and_edits_of_the_other_one() {
        let mut set = published_rolls();
        let top = |station| RollRef { station, kind: RollKind::Top };
        let flank = ElementName::Flank { side: Side::Left };
        set.roll_mut(top(2)).edits = vec![RollEdit { id: 1, action: EditAction::Chamfer { after: flank, depth: 2.0 } }];
        set.roll_mut(top(1)).same_as = Some(RollCopy { roll: top(2), mirrored: false });
        let same = design("x", &set);
        let of = |design: &RollDesign, station| design.roll(top(station)).unwrap().elements.clone();
        assert_eq!(of(&same, 1), of(&same, 2));
        set.roll_mut(top(1)).same_as = Some(RollCopy { roll: top(2), mirrored: true });
        let turned = design("x", &set);
        let (first, other) = (of(&turned, 1), of(&turned, 2));
        assert_eq!(first.len(), other.len());
        assert!(
            (first[1].segment.length() - other.last().map_or(0.0, |_| other[other.len() - 2].segment.length())).abs()
                < 1e-9
        );
        set.roll_mut(top(2)).same_as = Some(RollCopy { roll: top(1), mirrored: false });
        let circle = design("x", &set);
        assert!(circle.roll(top(1)).unwrap().diagnostics.iter().any(|d| d.code == "roll-copy"));
    }

    #[test]
    fn an_edit_that_does_not_fit_is_reported_at_its_roll() {
        let mut set = published_rolls();
        let roll = RollRef { station: 2, kind: RollKind::Bottom };
        let edge = ElementName::Edge { side: Side::Left };
        set.roll_mut(roll).edits = vec![RollEdit { id: 7, action: EditAction::Blend { after: edge, radius: 2.0 } }];
        let design = design("1470b", &set);
        let found = &design.roll(roll).unwrap().diagnostics[0];
        assert_eq!(
            (found.code.as_str(), &found.at),
            ("edit-corner-size", &Place::Roll { name: "1470b-2B".to_owned() })
        );
    }
}
