//! What one step of a drag costs: `cargo bench --bench drag`.
//!
//! `drag/QUEEN` moves the diameter of one node of the chess queen to and fro and makes everything anew: contour, paths, program
//! and proof. The cases `stage/...` measure its parts on the same part.

#![allow(clippy::expect_used, reason = "a benchmark may stop at once when its data is not there")]

use criterion::{Criterion, criterion_group, criterion_main};
use std::hint::black_box;
use std::sync::Arc;
use turnwright::cancel::Cancel;
use turnwright::document::{Content, Document, TurnedPart};
use turnwright::machine::{self, Catalog};
use turnwright::post::orac;
use turnwright::proof;
use turnwright::regen::{self, Cache};
use turnwright::storage;
use turnwright::{part, turning};

fn example(name: &str) -> Document {
    let example = storage::examples().iter().find(|e| e.name == name).expect("the example is shipped");
    storage::document_from_text(name, example.text).expect("shipped examples can be read")
}

fn part_of(document: &Document) -> &TurnedPart {
    let Content::TurnedPart(part) = &document.content else { unreachable!("a turned part") };
    part
}

/// The queen with the node between sections 9 and 10 (z 42.7, diameter 10.2) at two places a drag passes.
fn dragged() -> [Arc<Document>; 2] {
    [0.0, 0.1].map(|by| {
        let mut document = example("QUEEN");
        let Content::TurnedPart(part) = &mut document.content else { unreachable!("a turned part") };
        part.sections[8].d2 += by;
        part.sections[9].d1 += by;
        Arc::new(document)
    })
}

fn drag(c: &mut Criterion) {
    let catalog = Catalog::shipped();
    let documents = dragged();
    let mut cache = Cache::default();
    let mut step = 0;
    c.bench_function("drag/QUEEN", |b| {
        b.iter(|| {
            step += 1;
            let document = &documents[step % 2];
            black_box(regen::regenerate(document, &catalog, &mut cache, &Cancel::default()))
        });
    });
}

fn full(c: &mut Criterion) {
    let catalog = Catalog::shipped();
    for name in ["QUEEN", "MASTER"] {
        let document = Arc::new(example(name));
        c.bench_function(&format!("from-nothing/{name}"), |b| {
            b.iter(|| black_box(regen::regenerate(&document, &catalog, &mut Cache::default(), &Cancel::default())));
        });
    }
}

fn stages(c: &mut Criterion) {
    let catalog = Catalog::shipped();
    let document = Arc::new(example("QUEEN"));
    let derived =
        regen::regenerate(&document, &catalog, &mut Cache::default(), &Cancel::default()).expect("nobody cancels");
    let (part_mm, item) = (part_of(&document), &derived.setups[0]);
    let machine = derived.machine.clone().expect("the machine is shipped");
    let material = catalog.material(&part_mm.material, document.unit).expect("the material is shipped").in_mm();
    let tools = machine::outlines(&machine, &catalog);
    c.bench_function("stage/checks", |b| b.iter(|| part::check(black_box(part_mm), document.unit, &machine)));
    c.bench_function("stage/setups", |b| b.iter(|| part::setups(black_box(part_mm), &machine)));
    c.bench_function("stage/contour", |b| {
        b.iter(|| part::contour(black_box(&item.setup.profile), regen::CONTOUR_TOLERANCE_MM));
    });
    c.bench_function("stage/unreachable", |b| {
        b.iter(|| turning::unreachable(black_box(&item.setup), &tools, &machine));
    });
    let today = catalog.machine("fanuc-0i").expect("the machine is shipped");
    let todays_tools = machine::outlines(today, &catalog);
    c.bench_function("stage/unreachable with ISO holders", |b| {
        b.iter(|| turning::unreachable(black_box(&item.setup), &todays_tools, today));
    });
    c.bench_function("stage/paths", |b| {
        b.iter(|| turning::published::generate(black_box(&item.setup), part_mm, &machine, &material));
    });
    let options = regen::post_options(part_mm, document.unit);
    c.bench_function("stage/program", |b| {
        b.iter(|| orac::post(&item.name, black_box(&item.path), &options, &machine));
    });
    let input = regen::proof_input(&derived, item).expect("the machine is shipped");
    c.bench_function("stage/proof", |b| b.iter(|| proof::prove(black_box(&input), &Cancel::default())));
}

criterion_group!(benches, drag, full, stages);
criterion_main!(benches);
