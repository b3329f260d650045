//! Bends that are formed in parts, a straight piece, an arc and a straight piece, as a table.

use super::flower::name_of;
use super::words;
use crate::app::sheet::Takes;
use crate::app::sheet::{self, Cell, Change, Heading, Sheet};
use crate::diagnostic::Place;
use crate::document::{Composite, Document, Element, ElementKind, FixedComposite, RollSet};
use crate::session::Session;

/// Parts of a composite that is added, percent: a bend that is formed from its middle.
const FRESH: [f64; 3] = [25.0, 50.0, 25.0];

/// The bend, its three parts, the first and the last station.
const BEND: usize = 0;
const PARTS: std::ops::RangeInclusive<usize> = 1..=3;
const FIRST: usize = 4;

/// The composites of a set.
pub(super) struct Composites<'a> {
    set: &'a RollSet,
    headings: [Heading; 6],
    /// What is wrong with the composites of an element.
    wrong: Vec<(u32, String)>,
}

impl<'a> Composites<'a> {
    /// The table of a set.
    pub(super) fn new(set: &'a RollSet, session: &Session) -> Self {
        let headings = [
            Heading::figures("bend", 44.0),
            Heading::figures("lead %", 50.0),
            Heading::figures("arc %", 50.0),
            Heading::figures("trail %", 50.0),
            Heading::figures("from stn", 52.0),
            Heading::figures("to stn", 52.0),
        ];
        let problems = session.problems().iter().filter(|p| p.code == "composite-bend");
        let wrong = problems.filter_map(|p| {
            let Place::Element { id, .. } = p.at else { return None };
            Some((id, p.message.clone()))
        });
        Self { set, headings, wrong: wrong.collect() }
    }

    /// Number of a station by its id.
    fn station(&self, id: u32) -> String {
        self.set.station(id).map_or_else(|| "?".to_owned(), |(number, _)| number.to_string())
    }
}

/// The bend of this number.
fn bend_of(set: &RollSet, text: &str) -> Result<u32, String> {
    let wanted = text.trim();
    let (list, number) = match wanted.strip_suffix('\'') {
        Some(number) => (&set.section.other_side, number),
        None => (&set.section.elements, wanted),
    };
    let element = number.parse::<usize>().ok().and_then(|n| list.get(n.checked_sub(1)?));
    match element {
        Some(Element { id, kind: ElementKind::Bend { .. } }) => Ok(*id),
        Some(_) => Err(format!("Element {wanted} is a line; only a bend has parts.")),
        None => Err(format!("There is no element {wanted}. Type the number of a bend, such as 2.")),
    }
}

/// The station of this number.
fn station_of(set: &RollSet, text: &str) -> Result<u32, String> {
    let number = text.trim().parse::<usize>().ok();
    let station = number.and_then(|n| set.stations.get(n.checked_sub(1)?));
    station.map(|s| s.id).ok_or_else(|| {
        format!("There is no station {}. Type 1 to {}, or leave both empty.", text.trim(), set.stations.len())
    })
}

/// A composite that is added: of the first bend that has none.
pub(super) fn fresh(set: &RollSet) -> Option<Composite> {
    let bends = || set.section.all().filter(|e| matches!(e.kind, ElementKind::Bend { .. }));
    let without = bends().find(|e| !set.composites.iter().any(|c| c.element == e.id));
    let element = without.or_else(|| bends().next())?.id;
    Some(Composite { element, percent: FRESH, fixed: None })
}

impl Sheet for Composites<'_> {
    fn name(&self) -> &'static str {
        "Composite bend"
    }

    fn headings(&self) -> &[Heading] {
        &self.headings
    }

    fn rows(&self) -> usize {
        self.set.composites.len()
    }

    fn cell(&self, row: usize, column: usize) -> Cell {
        let Some(composite) = self.set.composites.get(row) else { return Cell::default() };
        let text = match column {
            BEND => words::number(self.set, composite.element),
            column if PARTS.contains(&column) => {
                words::plain(composite.percent.get(column - PARTS.start()).copied().unwrap_or_default(), 3)
            }
            column => composite
                .fixed
                .map_or_else(String::new, |fixed| self.station(if column == FIRST { fixed.first } else { fixed.last })),
        };
        let wrong = self.wrong.iter().find(|(id, _)| column == BEND && *id == composite.element);
        Cell { text, takes: Takes::Text, wrong: wrong.map(|(_, message)| message.clone()), ..Cell::default() }
    }

    fn write(&self, document: &mut Document, row: usize, column: usize, text: &str) -> Result<(), String> {
        let Some(set) = super::set_mut(document) else { return Ok(()) };
        let empty = text.trim().is_empty() || text.trim() == "–";
        let bend = if column == BEND { Some(bend_of(set, text)?) } else { None };
        let station = if column >= FIRST && !empty { Some(station_of(set, text)?) } else { None };
        let Some(composite) = set.composites.get_mut(row) else { return Ok(()) };
        if let Some(bend) = bend {
            composite.element = bend;
        } else if let Some(part) = column.checked_sub(*PARTS.start()).and_then(|i| composite.percent.get_mut(i)) {
            *part = words::parse_figure(text.trim().trim_end_matches('%'))?;
        } else {
            composite.fixed = station.map(|station| {
                let before = composite.fixed.unwrap_or(FixedComposite { first: station, last: station });
                if column == FIRST {
                    FixedComposite { first: station, ..before }
                } else {
                    FixedComposite { last: station, ..before }
                }
            });
        }
        Ok(())
    }

    fn change(&self, document: &mut Document, change: &Change) -> bool {
        let Some(set) = super::set_mut(document) else { return false };
        let fresh = fresh(set);
        let list = &mut set.composites;
        match change {
            Change::Insert(at) => {
                let Some(fresh) = fresh else { return false };
                list.insert((*at).min(list.len()), fresh);
            }
            Change::Delete(rows) => {
                let end = rows.end().saturating_add(1).min(list.len());
                list.drain((*rows.start()).min(end)..end);
            }
            Change::Duplicate(rows) => {
                let copies: Vec<Composite> =
                    list.iter().skip(*rows.start()).take(rows.clone().count()).cloned().collect();
                let at = rows.end().saturating_add(1).min(list.len());
                list.splice(at..at, copies);
            }
            Change::Move { rows, down } => return sheet::shift(list, rows, *down),
        }
        true
    }

    fn selected(&self, session: &Session) -> Option<usize> {
        let id = session.selection.element?;
        self.set.composites.iter().position(|c| c.element == id)
    }

    fn select(&self, session: &mut Session, row: usize, _column: usize) {
        if let Some(composite) = self.set.composites.get(row) {
            session.selection.element = Some(composite.element);
        }
    }
}

/// What is said where there are none.
pub(super) fn nothing_yet(set: &RollSet) -> String {
    let first = fresh(set).map_or_else(|| "a bend".to_owned(), |c| name_of(set, c.element));
    format!(
        "Every bend is one arc while it opens. “+ Bend” forms {first} from a straight piece, an arc and a straight piece, \
         in percent of its length, everywhere or from one station to another."
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::{Content, FORMAT_VERSION};
    use crate::rollform::fixtures::vee;
    use crate::units::Unit;

    fn document(set: RollSet) -> Document {
        Document { turnwright: FORMAT_VERSION, name: "x".to_owned(), unit: Unit::Mm, content: Content::RollSet(set) }
    }

    fn table(set: &RollSet) -> Composites<'_> {
        Composites { set, headings: std::array::from_fn(|_| Heading::figures("", 1.0)), wrong: Vec::new() }
    }

    #[test]
    fn parts_and_stations_are_typed_as_they_are_numbered() {
        let set = vee(&[30.0, 60.0, 90.0]);
        let mut document = document(set.clone());
        let sheet = table(&set);
        assert!(sheet.change(&mut document, &Change::Insert(0)));
        for (column, text) in [(1, "20"), (2, "60 %"), (3, "20"), (FIRST, "2"), (5, "3")] {
            sheet.write(&mut document, 0, column, text).unwrap();
        }
        let changed = document.content.roll_set().unwrap();
        let fixed = Some(FixedComposite { first: 2, last: 3 });
        assert_eq!(changed.composites, [Composite { element: 2, percent: [20.0, 60.0, 20.0], fixed }]);
        let texts: Vec<String> = (0..6).map(|column| table(changed).cell(0, column).text).collect();
        assert_eq!(texts, ["2", "20", "60", "20", "2", "3"]);
    }

    #[test]
    fn what_is_no_bend_or_station_is_refused_with_a_reason() {
        let mut set = vee(&[90.0]);
        set.composites.extend(fresh(&set));
        let mut document = document(set.clone());
        let sheet = table(&set);
        assert!(sheet.write(&mut document, 0, BEND, "1").unwrap_err().contains("is a line"));
        assert!(sheet.write(&mut document, 0, BEND, "9").unwrap_err().contains("no element 9"));
        assert!(sheet.write(&mut document, 0, FIRST, "4").unwrap_err().contains("1 to 1"));
        assert!(sheet.write(&mut document, 0, 1, "much").is_err());
        assert_eq!(document.content.roll_set(), Some(&set));
        sheet.write(&mut document, 0, FIRST, "").unwrap();
        assert_eq!(document.content.roll_set().unwrap().composites[0].fixed, None);
    }
}
