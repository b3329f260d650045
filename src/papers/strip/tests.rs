use super::*;
use crate::cancel::Cancel;
use crate::document::{Content, FORMAT_VERSION};
use crate::machine::Catalog;
use crate::papers::page::{Item, Pen};
use crate::regen::{Cache, regenerate};
use crate::rollform::fixtures::published;
use std::sync::Arc;

fn derived(set: RollSet) -> Derived {
    // Without rolls, which the papers of the strip do not need.
    let mut set = set;
    set.stations.iter_mut().for_each(|station| station.without_rolls = true);
    let content = Content::RollSet(set);
    let document = Document { turnwright: FORMAT_VERSION, name: "1470b".to_owned(), unit: Unit::Mm, content };
    regenerate(&Arc::new(document), &Catalog::shipped(), &mut Cache::default(), &Cancel::default()).unwrap()
}

fn texts(page: &Page) -> Vec<&str> {
    page.items.iter().filter_map(|i| if let Item::Text { text, .. } = i { Some(text.as_str()) } else { None }).collect()
}

/// True if all lines lie within the sheet.
fn is_inside(page: &Page) -> bool {
    page.items.iter().all(|item| match item {
        Item::Path { path, .. } => path
            .bounds()
            .is_none_or(|b| b.min.z >= 0.0 && b.min.r >= 0.0 && b.max.z <= page.width_mm && b.max.r <= page.height_mm),
        Item::Text { at, .. } => at.z >= 0.0 && at.r >= 0.0 && at.z <= page.width_mm && at.r <= page.height_mm,
    })
}

#[test]
fn section_has_its_sizes_its_numbers_and_its_table() {
    let pages = section_drawing(&derived(published()), DrawingChoice::default()).unwrap();
    assert_eq!(pages.len(), 2);
    assert!(pages.iter().all(is_inside));
    let drawn = texts(&pages[0]);
    for wanted in ["Finished section", "1470b", "112.844 (r + t/2)", "0.5", "DC01", "1", "11", "20", "21"] {
        assert!(drawn.contains(&wanted), "{wanted}: {drawn:?}");
    }
    let table = texts(&pages[1]);
    for wanted in ["R 1.5", "-23°", "bend down", "1.824", "40.65", "-180°"] {
        assert!(table.contains(&wanted), "{wanted}: {table:?}");
    }
}

#[test]
fn every_station_has_a_template_on_any_paper() {
    for paper in Paper::ALL {
        let choice = DrawingChoice { paper: Some(paper), scale: None };
        let pages = templates(&derived(published()), choice).unwrap();
        assert_eq!(pages.len(), 3);
        assert!(pages.iter().all(is_inside), "{paper:?}");
        assert!(pages.iter().all(|page| page.part.is_some_and(|view| view.scale <= 10.0)));
    }
    let large = templates(&derived(published()), DrawingChoice { paper: Some(Paper::A0), scale: Some(9.0) }).unwrap();
    assert!(large.iter().all(|page| page.part.unwrap().scale == 9.0 && is_inside(page)));
}

#[test]
fn a_scale_that_does_not_fit_is_refused_with_the_largest_that_does() {
    let asked = |scale| DrawingChoice { paper: Some(Paper::A4), scale: Some(scale) };
    let refused = templates(&derived(published()), asked(10.0)).unwrap_err();
    assert_eq!(refused.code, "drawing-scale");
    assert!(refused.message.contains("on A4") && refused.message.contains("at most 2.06"), "{}", refused.message);
    for scale in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(section_drawing(&derived(published()), asked(scale)).is_err());
    }
}

#[test]
fn every_station_is_drawn_with_its_rolls_on_any_paper() {
    let content = Content::RollSet(crate::rollform::fixtures::published_rolls());
    let document = Document { turnwright: FORMAT_VERSION, name: "1470b".to_owned(), unit: Unit::Mm, content };
    let document = Arc::new(document);
    // The first results of a set are its design; programs are not needed.
    let (mut first, cancel) = (None, Cancel::default());
    let mut tell = |made: Derived| {
        first = first.take().or(Some(made));
        cancel.cancel();
    };
    let steps = crate::regen::Steps { first: None, tell: &mut tell };
    let mut cache = Cache::default();
    _ = crate::regen::regenerate_in_steps(&document, &Catalog::shipped(), &mut cache, &cancel, steps);
    let derived = first.unwrap();
    for paper in Paper::ALL {
        let pages = stations(&derived, DrawingChoice { paper: Some(paper), scale: None }).unwrap();
        assert_eq!(pages.len(), 3);
        assert!(pages.iter().all(is_inside), "{paper:?}");
        let drawn = texts(&pages[1]);
        for wanted in
            ["2T", "2B", "147.3", "pass height 74.295", "axes 130.683", "openings 0.5 and 0.61", "drawn 10 apart"]
        {
            assert!(drawn.iter().any(|text| text.contains(wanted)), "{wanted}: {drawn:?}");
        }
    }
    // The strip lies in the gap: on paper top and bottom roll are the gap apart where they touch it otherwise.
    let scale = 0.5;
    let page = &stations(&derived, DrawingChoice { paper: Some(Paper::A2), scale: Some(scale) }).unwrap()[1];
    let areas: Vec<_> = page
        .items
        .iter()
        .filter_map(|item| match item {
            Item::Path { path, fill: Some(_), .. } => path.bounds(),
            _ => None,
        })
        .collect();
    let (top, bottom) = (areas[areas.len() - 3], areas[areas.len() - 2]);
    let axes = top.max.r - bottom.min.r;
    assert!((axes - (130.683 + 10.0) * scale).abs() < 1e-6, "{axes}");
    // It lies behind the halves of the rolls: a hidden edge, all of it.
    let strip = derived.rolls.as_ref().unwrap().design.stations[1].strip.outline();
    let hidden = page.items.iter().filter_map(|item| match item {
        Item::Path { path, pen: Some(pen), fill: Some(_) } if *pen == Pen::DASHED => Some(path),
        _ => None,
    });
    let hidden: Vec<_> = hidden.collect();
    assert!(hidden.len() == 1 && hidden[0].segments.len() == strip.segments.len(), "{hidden:?}");
    let [wide, of_strip] = [hidden[0], &strip].map(|outline| outline.bounds().map(|b| b.max.z - b.min.z).unwrap());
    assert!((wide - of_strip * scale).abs() < 1e-6, "{wide}");
}

#[test]
fn nothing_to_draw_says_so() {
    let mut set = published();
    set.stations.clear();
    assert_eq!(templates(&derived(set.clone()), DrawingChoice::default()).unwrap_err().code, "nothing-to-draw");
    set.section.elements.clear();
    assert_eq!(section_drawing(&derived(set), DrawingChoice::default()).unwrap_err().code, "nothing-to-draw");
}
