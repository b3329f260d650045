//! What the proof of long programs costs: `cargo bench --bench proof`.
//!
//! `proof/N` proves a program of N blocks, read and cut; the last lines say how the time grows with the blocks and how much
//! memory the longest one took at most.

#![allow(clippy::expect_used, reason = "a benchmark may stop at once when its data is not there")]

mod long_program;

use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use std::hint::black_box;
use std::time::Instant;
use turnwright::cancel::Cancel;
use turnwright::proof;

/// Blocks of the programs.
const BLOCKS: [u32; 4] = [100, 1_000, 10_000, 100_000];

fn long(c: &mut Criterion) {
    let mut group = c.benchmark_group("proof");
    group.sample_size(10);
    for blocks in BLOCKS {
        let input = long_program::input(blocks);
        group.bench_with_input(BenchmarkId::from_parameter(blocks), &input, |b, input| {
            b.iter(|| proof::prove(black_box(input), &Cancel::default()));
        });
    }
    group.finish();
}

#[allow(clippy::print_stdout, reason = "the figures are for people")]
fn growth(_: &mut Criterion) {
    let seconds = BLOCKS.map(|blocks| {
        let input = long_program::input(blocks);
        let mut runs = [0.0; 3].map(|_: f64| {
            let begin = Instant::now();
            black_box(proof::prove(&input, &Cancel::default()).expect("nobody cancels"));
            begin.elapsed().as_secs_f64()
        });
        runs.sort_by(f64::total_cmp);
        runs[1]
    });
    for (blocks, pair) in BLOCKS.iter().zip(seconds.windows(2)) {
        println!(
            "from {blocks} to {} blocks: time grows with the power {:.2}",
            blocks * 10,
            (pair[1] / pair[0]).log10()
        );
    }
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    println!("{}", status.lines().find(|line| line.starts_with("VmHWM")).unwrap_or("memory is not known here"));
}

criterion_group!(benches, long, growth);
criterion_main!(benches);
