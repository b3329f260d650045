//! The setup sheet: what the operator needs beside the lathe, for one clamping.

mod facts;
mod picture;
pub(super) mod tables;
mod tools;
pub(super) mod writer;

use super::number::number;
use super::page::Page;
use crate::document::TurnedPart;
use crate::machine::{Catalog, Machine};
use crate::regen::{Derived, SetupDerived};
use crate::units::Unit;
pub(super) use facts::title;
use writer::Writer;

/// The pages of one clamping's setup sheet, A4 upright: part, stock, holding, program zero with a picture of the set-up to scale,
/// tools with pictures, operations and programs with their times, and what the proof found.
pub(super) fn setup_sheet(derived: &Derived, item: &SetupDerived, catalog: &Catalog) -> Vec<Page> {
    let part = item.part.as_ref();
    let machine = derived.machine.as_deref();
    let subject = Subject { item, catalog, part, machine, unit: derived.document.unit };
    let mut writer = Writer::new(&item.name);
    facts::head(&subject, &mut writer);
    facts::facts(&subject, &mut writer);
    picture::picture(&subject, &mut writer);
    tools::tools(&subject, &mut writer);
    tables::operations(&subject, &mut writer);
    tables::programs(&subject, &mut writer);
    tables::findings(&subject, &mut writer);
    writer.done()
}

/// What the sheet is about.
struct Subject<'a> {
    item: &'a SetupDerived,
    catalog: &'a Catalog,
    /// The part in the document's unit.
    part: &'a TurnedPart,
    machine: Option<&'a Machine>,
    unit: Unit,
}

impl Subject<'_> {
    /// A length of mm in the document's unit, with the unit.
    fn length(&self, mm: f64) -> String {
        format!("{} {}", number(mm, self.unit), self.unit.symbol())
    }
}

/// A time as minutes and seconds.
pub(super) fn minutes(seconds: f64) -> String {
    let whole = seconds.max(0.0).round();
    format!("{:.0}:{:02.0} min", (whole / 60.0).floor(), whole % 60.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cancel::Cancel;
    use crate::papers::{Item, Paper};
    use crate::regen::{Cache, regenerate};
    use crate::storage::{document_from_text, examples_of};
    use std::sync::Arc;

    fn texts(pages: &[Page]) -> Vec<&str> {
        let items = pages.iter().flat_map(|page| &page.items);
        items.filter_map(|i| if let Item::Text { text, .. } = i { Some(text.as_str()) } else { None }).collect()
    }

    #[test]
    fn every_example_has_a_sheet_with_all_its_tools_operations_and_programs() {
        let catalog = Catalog::shipped();
        for example in examples_of(crate::document::Kind::TurnedPart) {
            let document = Arc::new(document_from_text("example.turn", example.text).unwrap());
            let derived = regenerate(&document, &catalog, &mut Cache::default(), &Cancel::default()).unwrap();
            for item in &derived.setups {
                let pages = setup_sheet(&derived, item, &catalog);
                let said = texts(&pages);
                let says = |wanted: &str| said.iter().any(|text| text.contains(wanted));
                for program in &item.post.programs {
                    assert!(says(&format!("{}.{}", program.name, program.extension)), "{}", program.name);
                }
                for operation in &item.path.operations {
                    assert!(says(&operation.name) && says(&format!("tool {}", operation.tool)), "{}", operation.name);
                }
                let verdict = if item.proof.passed { "Proved" } else { "NOT PROVED: do not run" };
                assert!(says(verdict) && says(&document.name) && says(&minutes(item.proof.times.total_s)));
                for page in &pages {
                    assert_eq!((page.width_mm, page.height_mm), Paper::A4.sides_mm());
                    let outside = page.items.iter().find(|item| match item {
                        Item::Path { path, .. } => path.bounds().is_some_and(|b| b.min.r < 10.0 || b.max.r > 290.0),
                        Item::Text { at, .. } => !(15.0..=196.0).contains(&at.z) || !(5.0..=290.0).contains(&at.r),
                    });
                    assert_eq!(outside, None, "{}", item.name);
                }
            }
        }
    }

    #[test]
    fn stock_holding_and_zero_are_told_with_their_figures() {
        let catalog = Catalog::shipped();
        let said = |text: &str| {
            let document = Arc::new(document_from_text("part.turn", text).unwrap());
            let derived = regenerate(&document, &catalog, &mut Cache::default(), &Cancel::default()).unwrap();
            let pages = derived.setups.iter().map(|item| setup_sheet(&derived, item, &catalog));
            pages.map(|pages| texts(&pages).join("\n")).collect::<Vec<_>>()
        };
        let housing = &said(include_str!("../../../tests/cases/parts/bearing-housing.turn"))[0];
        for fact in
            ["bar Ø 70 mm, 59 mm out of the chuck, 1 mm to face off", "chuck, 25 mm gripped", "finished free end"]
        {
            assert!(housing.contains(fact), "{fact} in {housing}");
        }
        let roll = &said(include_str!("../../../assets/examples/roll-top.turn"))[0];
        for fact in
            ["bar Ø 160 mm, 159.303 mm long", "between centres", "finished clamped end", "0.25 mm/rev, 200 m/min"]
        {
            assert!(roll.contains(fact), "{fact} in {roll}");
        }
        let spigot = said(include_str!("../../../assets/examples/spigot.turn"));
        assert!(spigot[0].contains("free end first") && spigot[1].contains("second end, turned round"));
        assert!(spigot[0].contains("Ø 1.25 in"), "lengths in the document's unit");
    }

    #[test]
    fn times_are_minutes_and_seconds() {
        assert_eq!([minutes(0.4), minutes(59.6), minutes(3600.0)], ["0:00 min", "1:00 min", "60:00 min"]);
    }
}
