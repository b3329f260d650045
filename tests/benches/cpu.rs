//! Time that the processor spends on this thread.

use std::time::Instant;

/// Runs until this much time is spent, ms, so that the ticks by which the system counts do not matter.
const LONG_ENOUGH_MS: f64 = 200.0;

/// Time of this thread on a processor, ms. Where the system does not say it, the time of day since `begin`.
fn clock(begin: Instant) -> f64 {
    let spent = || {
        let status = std::fs::read_to_string("/proc/thread-self/schedstat").ok()?;
        Some(status.split_whitespace().next()?.parse::<f64>().ok()? * 1e-6)
    };
    spent().unwrap_or_else(|| begin.elapsed().as_secs_f64() * 1e3)
}

/// Milliseconds of one run: the smallest of three means, for nothing makes a run shorter than it is.
pub(crate) fn milliseconds(mut run: impl FnMut()) -> f64 {
    let begin = Instant::now();
    let mut mean = || {
        let (start, mut runs) = (clock(begin), 0.0);
        loop {
            run();
            runs += 1.0;
            let spent = clock(begin) - start;
            if spent >= LONG_ENOUGH_MS {
                return spent / runs;
            }
        }
    };
    mean().min(mean()).min(mean())
}
