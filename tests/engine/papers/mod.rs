//! Papers are read back from their files by readers that share nothing with the writers, and compared with pages and part.

mod dxf;
mod hpgl;
mod pdf;
mod picture;
mod svg;

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex};
use turnwright::cancel::Cancel;
use turnwright::geometry::{Contour, Point, Segment};
use turnwright::machine::Catalog;
use turnwright::papers::{DrawingChoice, Item, Page, Paper, PaperKind, Pen};
use turnwright::regen::{Cache, Derived, regenerate};
use turnwright::storage::{document_from_text, examples};

/// What follows from an example, or from the bearing housing of the test cases; made once for all tests.
fn derived(name: &str) -> Arc<(Derived, Catalog)> {
    static MADE: Mutex<BTreeMap<String, Arc<(Derived, Catalog)>>> = Mutex::new(BTreeMap::new());
    let mut made = MADE.lock().unwrap();
    Arc::clone(made.entry(name.to_owned()).or_insert_with(|| Arc::new(make(name))))
}

fn make(name: &str) -> (Derived, Catalog) {
    let example = examples().iter().find(|e| e.name == name).map(|e| e.text);
    let text = example.unwrap_or(include_str!("../../cases/parts/bearing-housing.turn"));
    let document = Arc::new(document_from_text(name, text).unwrap());
    let catalog = Catalog::shipped();
    let derived = regenerate(&document, &catalog, &mut Cache::default(), &Cancel::default()).unwrap();
    (derived, catalog)
}

fn drawing(name: &str, paper: Option<Paper>) -> Vec<Page> {
    let made = derived(name);
    PaperKind::Drawing(DrawingChoice { paper, scale: None }).pages(&made.0, &made.1).unwrap()
}

fn sheet(name: &str) -> Vec<Page> {
    let made = derived(name);
    PaperKind::SetupSheet.pages(&made.0, &made.1).unwrap()
}

/// The lines of a page that a pen draws.
fn drawn(page: &Page) -> Vec<(&Contour, Pen)> {
    let items = page.items.iter();
    items
        .filter_map(|i| if let Item::Path { path, pen: Some(pen), .. } = i { Some((path, *pen)) } else { None })
        .collect()
}

/// The texts of a page with their places.
fn texts(page: &Page) -> Vec<(&str, Point)> {
    let items = page.items.iter();
    items.filter_map(|i| if let Item::Text { text, at, .. } = i { Some((text.as_str(), *at)) } else { None }).collect()
}

/// Largest distance between two lines of the same number of segments, mm; arcs are compared at their ends and middles.
fn distance(one: &[Segment], other: &[Segment]) -> f64 {
    assert_eq!(one.len(), other.len(), "segments of {one:?} and {other:?}");
    let apart = |(a, b): (&Segment, &Segment)| {
        [0.0, 0.5, 1.0].into_iter().map(|t| a.point_at(t).distance(b.point_at(t))).fold(0.0, f64::max)
    };
    one.iter().zip(other).map(apart).fold(0.0, f64::max)
}
