//! What one step of a drag of a shell costs, and a run on the simulated rig: `cargo bench --bench shell`.
//!
//! `drag/...` moves one figure to and fro and makes everything anew: former, wall, path, set points, program and proof.
//! `run/CONE` runs the published 30° cone of 50 mm to its end.

#![allow(clippy::expect_used, reason = "a benchmark may stop at once when its data is not there")]

use criterion::{Criterion, criterion_group, criterion_main};
use std::hint::black_box;
use std::sync::Arc;
use turnwright::cancel::Cancel;
use turnwright::document::{Content, Document, FormerShape, Kind};
use turnwright::machine::Catalog;
use turnwright::regen::{self, Cache};
use turnwright::spinning::control::{Plan, Watch};
use turnwright::spinning::published::{Arithmetic, ConeParameters, cone_points};
use turnwright::spinning::rig::{RigModel, SimulatedRig};
use turnwright::spinning::run::Run;
use turnwright::storage;

/// The example with one figure of its contour changed by `by`.
fn dragged(name: &str, figure: &str, by: f64) -> Arc<Document> {
    let example = storage::examples_of(Kind::Shell).find(|e| e.name == name).expect("the example is shipped");
    let mut document = storage::document_from_text(name, example.text).expect("shipped examples can be read");
    if let Content::Shell(shell) = &mut document.content {
        let shape: &mut FormerShape = &mut shell.former.shape;
        let value = shape.figures().iter().find(|(n, _)| n == figure).map_or(0.0, |(_, value)| *value);
        shape.set(figure, value + by);
    }
    Arc::new(document)
}

fn drag(c: &mut Criterion) {
    let catalog = Catalog::shipped();
    for (name, figure) in [("CONE", "half_angle_deg"), ("DISH", "rim_diameter"), ("PARABOLA", "length")] {
        let documents = [dragged(name, figure, 0.0), dragged(name, figure, 0.1)];
        let mut cache = Cache::default();
        let mut step = 0;
        c.bench_function(&format!("drag/{name}"), |b| {
            b.iter(|| {
                step += 1;
                let document = documents.get(step % 2).expect("two documents");
                black_box(regen::regenerate(document, &catalog, &mut cache, &Cancel::default()))
            });
        });
    }
}

fn run(c: &mut Criterion) {
    let cone = ConeParameters::new(50, 16, 30).expect("within the published ranges");
    let model = RigModel::new(95.0, 1.27);
    let watch = Watch { limit_mm: 2.5, carriage_mm_per_s: model.carriage_mm_per_s() };
    c.bench_function("run/CONE", |b| {
        b.iter(|| {
            let plan = Plan::published(&cone_points(&cone, Arithmetic::Exact), cone.roller_position()).watched(watch);
            let run = Run::simulated(plan, SimulatedRig::new(model, Vec::new()));
            black_box(run.errors())
        });
    });
}

criterion_group!(benches, drag, run);
criterion_main!(benches);
