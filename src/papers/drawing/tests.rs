//! Figures never stand on one another and nothing leaves the frame, whatever the part.

use super::outline::Outline;
use super::subject::Subject;
use super::*;
use crate::document::{Content, Document, TurnedPart};
use crate::geometry::Segment;
use crate::machine::Catalog;
use crate::papers::font;
use crate::papers::page::{Align, Item};
use crate::part::{self, Section, SectionKind};
use crate::storage::{document_from_text, examples_of};
use crate::units::Unit;
use proptest::prelude::*;

fn document(text: &str) -> Document {
    document_from_text("example.turn", text).expect("a document")
}

fn roll() -> Document {
    document(include_str!("../../../assets/examples/roll-top.turn"))
}

fn of_part(part: TurnedPart) -> Document {
    Document { turnwright: 1, name: "PART".to_owned(), unit: Unit::Mm, content: Content::TurnedPart(part) }
}

fn pages(document: &Document, choice: DrawingChoice) -> Result<Vec<Page>, Diagnostic> {
    let Content::TurnedPart(part) = &document.content else { unreachable!("a turned part") };
    let catalog = Catalog::shipped();
    let machine = catalog.machine(&part.machine).expect("a shipped machine");
    let (setups, _) = part::setups(&part.scaled(document.unit.in_mm()), machine);
    let contour = |profile| part::contour(profile, 0.0005);
    let outline = |profile| Outline::new(profile, &contour(profile));
    let outside = setups.first().map(|s| outline(&s.profile)).unwrap_or_default();
    let bore = setups.first().and_then(|s| s.bore.as_ref()).map(outline);
    drawn(&Subject::with(document, outside, bore)?, choice)
}

/// The rectangle that a text covers.
fn covered(item: &Item) -> Option<Bounds> {
    let Item::Text { at, height_mm, align, upright, bold, text, .. } = item else { return None };
    let width = font::width_mm(text, *height_mm, *bold);
    let back = match align {
        Align::Start => 0.0,
        Align::Middle => width / 2.0,
        Align::End => width,
    };
    let (min, max) = if *upright {
        (Point::new(at.z - height_mm, at.r - back), Point::new(at.z, at.r - back + width))
    } else {
        (Point::new(at.z - back, at.r), Point::new(at.z - back + width, at.r + height_mm))
    };
    (!text.is_empty()).then_some(Bounds { min, max })
}

/// What is wrong with the look of a page, if anything.
fn flaw(page: &Page) -> Option<String> {
    let frame = Bounds { min: Point::new(19.7, 9.7), max: Point::new(page.width_mm - 9.7, page.height_mm - 9.7) };
    let within = |b: Bounds| {
        b.min.z >= frame.min.z && b.min.r >= frame.min.r && b.max.z <= frame.max.z && b.max.r <= frame.max.r
    };
    for item in &page.items {
        let bounds = if let Item::Path { path, .. } = item { path.bounds() } else { covered(item) };
        if bounds.is_some_and(|b| !within(b)) {
            return Some(format!("outside the frame: {item:?}"));
        }
    }
    let texts: Vec<(Bounds, &Item)> = page.items.iter().filter_map(|i| Some((covered(i)?, i))).collect();
    for (k, (a, one)) in texts.iter().enumerate() {
        let overlap = texts[k + 1..].iter().find(|(b, _)| a.touches(*b));
        if let Some((_, other)) = overlap {
            return Some(format!("{one:?} stands on {other:?}"));
        }
    }
    None
}

#[test]
fn every_example_is_drawn_on_every_paper_without_a_flaw() {
    for example in examples_of(crate::document::Kind::TurnedPart).map(|e| document(e.text)) {
        for paper in Paper::ALL {
            let choice = DrawingChoice { paper: Some(paper), scale: None };
            let pages = pages(&example, choice).unwrap_or_else(|e| panic!("{} on {}: {e}", example.name, paper.name()));
            for page in &pages {
                assert_eq!((page.height_mm, page.width_mm), paper.sides_mm());
                assert_eq!(flaw(page), None, "{} on {}", example.name, paper.name());
            }
        }
    }
}

#[test]
fn paper_and_scale_are_chosen_to_show_the_part_in_its_true_size_or_larger() {
    let roll = roll();
    let pages = pages(&roll, DrawingChoice::default()).unwrap();
    assert_eq!((pages[0].width_mm, pages[0].height_mm), (420.0, 297.0));
    assert_eq!(pages[0].part.map(|view| view.scale), Some(1.0));
    assert_eq!(pages.len(), 2, "two crowds of figures are shown in details");
    assert!(pages[1].part.is_some_and(|view| view.scale >= 5.0));
}

/// The bore takes the row below the view; the crowds of the outside are shown in details all the same, and no figure is lost.
#[test]
fn a_roll_with_a_bore_has_its_details_too() {
    let texts = |pages: &[Page]| -> std::collections::BTreeSet<String> {
        let items = pages.iter().flat_map(|page| &page.items);
        let upright = items.filter_map(|item| match item {
            Item::Text { text, upright: true, .. } => Some(text.clone()),
            _ => None,
        });
        upright.collect()
    };
    let solid = roll();
    let mut bored = solid.clone();
    let Content::TurnedPart(part) = &mut bored.content else { unreachable!("a turned part") };
    part.bore = vec![Section::line(900, 0.0, 50.0, part.length, 50.0)];
    let [solid, bored] = [&solid, &bored].map(|d| pages(d, DrawingChoice::default()).unwrap());
    assert_eq!((bored.len(), bored[0].part.map(|view| view.scale)), (2, Some(1.0)));
    let (mut before, after) = (texts(&solid), texts(&bored));
    before.insert("Ø 50".to_owned());
    assert_eq!(after, before);
    for page in &bored {
        assert_eq!(flaw(page), None);
    }
}

#[test]
fn a_long_shaft_is_drawn_at_half_its_size_and_a_pin_larger() {
    let part = |length: f64, d: f64| TurnedPart {
        length,
        bar_diameter: d,
        sections: vec![Section::line(1, 0.0, d, length, d)],
        ..TurnedPart::default()
    };
    let drawn = |part| pages(&of_part(part), DrawingChoice::default()).unwrap().swap_remove(0);
    let (shaft, pin) = (drawn(part(620.0, 30.0)), drawn(part(9.0, 4.0)));
    assert_eq!((shaft.width_mm, shaft.part.unwrap().scale), (420.0, 0.5));
    assert_eq!((pin.width_mm, pin.part.unwrap().scale), (297.0, 20.0));
}

#[test]
fn thousands_of_sections_are_refused_at_once() {
    let section = |k: u32| Section::line(k + 1, f64::from(k), 20.0 + f64::from(k % 2), f64::from(k) + 1.0, 21.0);
    let sections: Vec<Section> = (0..5000).map(section).collect();
    let part = TurnedPart { length: 5000.0, bar_diameter: 30.0, sections, ..TurnedPart::default() };
    assert_eq!(pages(&of_part(part), DrawingChoice::default()).unwrap_err().code, "drawing-crowded");
}

#[test]
fn a_scale_that_does_not_fit_is_refused_with_the_largest_that_does() {
    let roll = roll();
    let ask = |paper, scale| pages(&roll, DrawingChoice { paper: Some(paper), scale: Some(scale) });
    let fault = ask(Paper::A3, 2.0).unwrap_err();
    assert_eq!(fault.code, "drawing-scale");
    let message = &fault.message;
    assert!(message.contains("159.303 mm long and 147.336 mm") && message.contains("1:1 is the largest"), "{message}");
    assert!(ask(Paper::A1, 2.0).is_ok());
    assert!(ask(Paper::A3, f64::NAN).unwrap_err().message.contains("no scale"));
}

#[test]
fn more_figures_than_a_row_has_room_for_are_counted() {
    let section = |k: u32| {
        let z = 2.0 * f64::from(k);
        Section::line(k + 1, z, 20.0 + f64::from(k % 2), z + 2.0, 20.0 + f64::from(k % 2))
    };
    let part = TurnedPart {
        length: 400.0,
        bar_diameter: 30.0,
        sections: (0..200).map(section).collect(),
        ..TurnedPart::default()
    };
    let fault = pages(&of_part(part), DrawingChoice { paper: Some(Paper::A4), scale: None }).unwrap_err();
    assert!(fault.code == "drawing-crowded" && fault.message.contains("A4 has room for 66"), "{fault}");
}

#[test]
fn nothing_to_draw_is_said() {
    let part = TurnedPart { length: 10.0, bar_diameter: 0.0, ..TurnedPart::default() };
    assert_eq!(pages(&of_part(part), DrawingChoice::default()).unwrap_err().code, "nothing-to-draw");
}

#[test]
fn a_part_with_a_bore_is_cut_below_the_axis() {
    let part = TurnedPart {
        length: 40.0,
        bar_diameter: 60.0,
        sections: vec![Section::line(1, 0.0, 50.0, 40.0, 50.0)],
        bore: vec![Section::line(2, 10.0, 20.0, 40.0, 20.0)],
        ..TurnedPart::default()
    };
    let pages = pages(&of_part(part), DrawingChoice { paper: Some(Paper::A4), scale: Some(1.0) }).unwrap();
    let view = pages[0].part.unwrap();
    let lines = pages[0].items.iter().filter_map(|item| match item {
        Item::Path { path, .. } if path.segments.len() == 1 => path.segments.first(),
        _ => None,
    });
    let oblique = |s: &&Segment| {
        let d = s.end() - s.start();
        (d.x - d.y).abs() < 1e-6 && d.x.abs() > 2.0
    };
    let hatch: Vec<&Segment> = lines.filter(oblique).collect();
    assert!(hatch.len() > 10, "hatched");
    for line in hatch {
        let (z, r) = {
            let p = view.part_point(line.point_at(0.5));
            (p.z, -p.r)
        };
        assert!((0.0..=40.0).contains(&z) && (0.0..=25.0).contains(&r) && !(z > 10.1 && r < 9.9), "z {z}, r {r}");
    }
    let says = |wanted: &str| pages[0].items.iter().any(|i| matches!(i, Item::Text { text, .. } if text == wanted));
    assert!(says("Ø 20") && says("Ø 50") && says("10"));
}

/// A row of sections one behind the other.
fn sections() -> impl Strategy<Value = Vec<Section>> {
    let one = (0.05..8.0_f64, 2.0..60.0_f64, 2.0..60.0_f64, 0..5_u8);
    proptest::collection::vec(one, 1..40).prop_map(|rows| {
        let mut z = 0.0;
        let mut sections = Vec::new();
        for (id, (length, d1, d2, kind)) in (1..).zip(rows) {
            let radius = 0.6 * length.hypot((d2 - d1) / 2.0);
            let (d2, kind) = match kind {
                0 => (d1, SectionKind::Line),
                1 => (d2, SectionKind::Line),
                2 => (d2, SectionKind::Concave { radius }),
                3 => (d2, SectionKind::Convex { radius }),
                _ => (d1 - 1.2, SectionKind::Thread { pitch: 1.0, starts: 1 }),
            };
            sections.push(Section { kind, ..Section::line(id, z, d1, z + length, d2) });
            z += length;
        }
        sections
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]
    #[test]
    fn no_part_makes_a_drawing_with_a_flaw(sections in sections(), bored in any::<bool>(), paper in 0..5_usize) {
        let length = sections.last().map_or(0.0, |s| s.z2);
        let bore = if bored { vec![Section::line(900, 0.0, 1.2, length / 2.0, 1.2)] } else { Vec::new() };
        let part = TurnedPart { length, bar_diameter: 64.0, sections, bore, ..TurnedPart::default() };
        let choice = DrawingChoice { paper: Some(Paper::ALL[paper]), scale: None };
        match pages(&of_part(part), choice) {
            Ok(pages) => for page in &pages {
                prop_assert_eq!(flaw(page), None);
            },
            Err(refused) => prop_assert_eq!(refused.code, "drawing-crowded"),
        }
    }
}
