//! What an edit of a set of form-rolls costs: `cargo bench --bench rolls`.
//!
//! Every case bends one element of a station to and fro by 0.1°. `angle/design` is the time until strip and rolls of all stations
//! can be shown, `angle/shown roll` until the roll on screen has its plan, program and proof too, `angle/whole set` until
//! all rolls that change have. `from-nothing` makes the whole set without anything kept; one of 9 stations with 4 rolls each, too.

#![allow(clippy::expect_used, reason = "a benchmark may stop at once when its data is not there")]

use criterion::{Criterion, criterion_group, criterion_main};
use std::hint::black_box;
use std::sync::Arc;
use std::time::{Duration, Instant};
use turnwright::cancel::Cancel;
use turnwright::document::{Content, Document, RollKind, RollRef, Station};
use turnwright::machine::Catalog;
use turnwright::regen::{Cache, Steps, regenerate, regenerate_in_steps};
use turnwright::storage;

/// Sets that are measured.
const SETS: [&str; 2] = ["U-CHANNEL", "HAT"];

/// The set with the last bend that its middle station names at two angles which a drag passes, and that station's top roll.
fn dragged(name: &str) -> ([Arc<Document>; 2], RollRef) {
    let example = storage::examples().iter().find(|e| e.name == name).expect("the example is shipped");
    let mut shown = RollRef { station: 0, kind: RollKind::Top };
    let documents = [0.0, 0.1].map(|by| {
        let mut document = storage::document_from_text(name, example.text).expect("shipped examples can be read");
        let Content::RollSet(set) = &mut document.content else { unreachable!("a set of form-rolls") };
        let middle = set.stations.len() / 2;
        shown.station = set.stations[middle].id;
        set.stations[middle].bends.last_mut().expect("a bend changes").angle_deg -= by;
        Arc::new(document)
    });
    (documents, shown)
}

/// Time of one edit until `told` interim results have come; the rest is cancelled.
fn until_told(document: &Arc<Document>, catalog: &Catalog, cache: &mut Cache, shown: RollRef, told: usize) -> Duration {
    let (start, cancel) = (Instant::now(), Cancel::default());
    let (mut count, mut took) = (0, None);
    let mut tell = |derived| {
        black_box(derived);
        count += 1;
        if count == told {
            took = Some(start.elapsed());
            cancel.cancel();
        }
    };
    let steps = Steps { first: Some(shown), tell: &mut tell };
    let _ = regenerate_in_steps(document, catalog, cache, &cancel, steps);
    took.unwrap_or_else(|| start.elapsed())
}

fn angle(c: &mut Criterion) {
    let catalog = Catalog::shipped();
    for name in SETS {
        let (documents, shown) = dragged(name);
        for (case, told) in [("design", 1), ("shown roll", 2), ("whole set", usize::MAX)] {
            let mut cache = Cache::default();
            let mut step = 0;
            c.bench_function(&format!("angle/{case}/{name}"), |b| {
                b.iter_custom(|times| {
                    (0..times)
                        .map(|_| {
                            step += 1;
                            until_told(&documents[step % 2], &catalog, &mut cache, shown, told)
                        })
                        .sum()
                });
            });
        }
    }
}

/// The last station of U-CHANNEL but one, with rolls on all sides of the strip, at nine angles.
fn nine_stations() -> Arc<Document> {
    let ([document, _], _) = dragged("U-CHANNEL");
    let mut document = (*document).clone();
    let Content::RollSet(set) = &mut document.content else { unreachable!("a set of form-rolls") };
    let all_sides = set.stations[set.stations.len() - 2].clone();
    let at = |k: u32| {
        let mut station = Station { id: k + 1, ..all_sides.clone() };
        station.bends.iter_mut().for_each(|bend| bend.angle_deg = 74.0 + 2.0 * f64::from(k));
        station
    };
    set.stations = (0..9).map(at).collect();
    set.rolls.clear();
    Arc::new(document)
}

fn full(c: &mut Criterion) {
    let catalog = Catalog::shipped();
    let nine = nine_stations();
    let made = || regenerate(&nine, &catalog, &mut Cache::default(), &Cancel::default()).expect("nobody cancels");
    assert_eq!(made().rolls.expect("a set of form-rolls").rolls.len(), 36);
    c.bench_function("from-nothing/9 stations with 4 rolls each", |b| b.iter(|| black_box(made())));
    for name in SETS {
        let (documents, _) = dragged(name);
        c.bench_function(&format!("from-nothing/{name}"), |b| {
            b.iter(|| black_box(regenerate(&documents[0], &catalog, &mut Cache::default(), &Cancel::default())));
        });
    }
}

criterion_group! {
    name = benches;
    config = Criterion::default().sample_size(10);
    targets = angle, full
}
criterion_main!(benches);
