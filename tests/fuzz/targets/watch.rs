//! Cancels work that takes too long; what does not heed it runs into the fuzzer's own time limit and is a finding.

use std::sync::mpsc::channel;
use std::time::Duration;
use turnwright::cancel::Cancel;

/// Longest that the window would wait before it asks for something newer.
const PATIENCE: Duration = Duration::from_millis(500);

pub fn bounded(work: impl FnOnce(&Cancel)) {
    let cancel = Cancel::default();
    let (done, finished) = channel::<()>();
    let of_watch = cancel.clone();
    let watch = std::thread::spawn(move || {
        // An error that is no time-out says that the work is done.
        let _ = finished.recv_timeout(PATIENCE);
        of_watch.cancel();
    });
    work(&cancel);
    drop(done);
    watch.join().expect("the watch only waits");
}
