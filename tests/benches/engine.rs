//! What whole parts cost: `cargo bench --bench engine`.
//!
//! `plan+post+proof/...` makes the paths, posts the programs and proves them; `plan+post/staircase-103` roughs and finishes a
//! staircase of 103 points. `-- times` prints one table more: the processor's time of each step, which other work on the
//! machine does not lengthen, and how it grows from 100 over 1,000 to 10,000 sections.

#![allow(clippy::expect_used, reason = "a benchmark may stop at once when its data is not there")]

mod cpu;
mod subject;

use criterion::{Criterion, criterion_group, criterion_main};
use std::hint::black_box;
use subject::Subject;
use turnwright::document::Document;

/// The parts with names: as they come, and as planned.
fn named() -> Vec<(String, Document)> {
    let both = |name: &str| {
        let document = subject::example(name);
        [(name.to_owned(), document.clone()), (format!("{name} planned"), subject::planned(document))]
    };
    ["1470b-2T", "QUEEN"].into_iter().flat_map(both).collect()
}

fn whole(c: &mut Criterion) {
    let mut group = c.benchmark_group("plan+post+proof");
    group.sample_size(20);
    for (name, document) in named() {
        let subject = Subject::of(&document);
        group.bench_function(&name, |b| b.iter(|| black_box(subject.all())));
    }
    group.finish();
}

fn staircase(c: &mut Criterion) {
    let subject = Subject::of(&subject::staircase());
    c.bench_function("plan+post/staircase-103", |b| b.iter(|| black_box(subject.post(&subject.plan()))));
    c.bench_function("plan+post+proof/staircase-103", |b| b.iter(|| black_box(subject.all())));
}

/// Milliseconds of plan, post and proof.
fn steps(document: &Document) -> [f64; 3] {
    let subject = Subject::of(document);
    let path = subject.plan();
    let programs = subject.post(&path);
    [
        cpu::milliseconds(|| drop(black_box(subject.plan()))),
        cpu::milliseconds(|| drop(black_box(subject.post(&path)))),
        cpu::milliseconds(|| drop(black_box(subject.prove(&programs)))),
    ]
}

#[allow(clippy::print_stdout, reason = "the figures are for people")]
fn times(_: &mut Criterion) {
    if !std::env::args().any(|arg| arg == "times") {
        return;
    }
    println!("| part | plan ms | post ms | proof ms | all |\n|---|---|---|---|---|");
    let staircase = ("staircase-103".to_owned(), subject::staircase());
    for (name, document) in named().into_iter().chain([staircase]) {
        let [plan, post, proof] = steps(&document);
        println!("| {name} | {plan:.2} | {post:.2} | {proof:.2} | {:.2} |", plan + post + proof);
    }
    let mut before: Option<[f64; 4]> = None;
    println!("\n| sections | plan ms | post ms | proof ms | all | (power of the growth)\n|---|---|---|---|---|");
    for sections in [100, 1_000, 10_000] {
        let [plan, post, proof] = steps(&subject::wavy(sections));
        let now = [plan, post, proof, plan + post + proof];
        let shown = |(k, ms): (usize, &f64)| {
            let power = before.map(|b| format!(" ({:.2})", (ms / b[k]).log10())).unwrap_or_default();
            format!("{ms:.2}{power}")
        };
        println!("| {sections} | {} |", now.iter().enumerate().map(shown).collect::<Vec<_>>().join(" | "));
        before = Some(now);
    }
}

criterion_group!(benches, whole, staircase, times);
criterion_main!(benches);
