//! The thread that regenerates, and the slot in front of it: the latest document wins.

use crate::cancel::{Cancel, Cancelled};
use crate::document::Document;
use crate::machine::Catalog;
use crate::regen::{Cache, Derived, regenerate};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::mpsc::{Receiver, Sender, channel};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

/// A regeneration that is still running after this time gives way to a newer document; a quicker one is let finish,
/// so that the picture moves during a drag even where one regeneration takes several frames.
const PATIENCE: Duration = Duration::from_millis(300);

/// Makes everything that follows from a document. One lives as long as nothing panics; it may keep a cache.
pub type Regenerate = Box<dyn FnMut(&Arc<Document>, &Cancel) -> Result<Derived, Cancelled>>;

/// The work of the window's thread: everything that follows from a document, with a cache from one to the next.
#[must_use]
pub fn regenerating(catalog: Arc<Catalog>) -> Regenerate {
    let mut cache = Cache::default();
    Box::new(move |document, cancel| regenerate(document, &catalog, &mut cache, cancel))
}

/// What came of one document.
#[derive(Debug, Clone)]
pub enum Outcome {
    /// It was regenerated.
    Done {
        /// What follows from it.
        derived: Arc<Derived>,
        /// How long that took.
        took: Duration,
    },
    /// The regeneration stopped by a fault of the program.
    Fault {
        /// The document that was not regenerated.
        document: Arc<Document>,
        /// What the fault said.
        message: String,
    },
}

/// A thread with a slot in front of it; dropping it cancels the work and ends the thread after it.
pub struct Worker {
    shared: Arc<Shared>,
    outcomes: Receiver<Outcome>,
}

#[derive(Default)]
struct Shared {
    state: Mutex<State>,
    wake: Condvar,
}

#[derive(Default)]
struct State {
    next: Option<Arc<Document>>,
    running: Option<(Cancel, Instant)>,
    closed: bool,
}

impl Worker {
    /// Starts the thread. `make` makes the work at the start and anew after a fault; `notify` is called after every
    /// outcome, from the thread.
    #[must_use]
    pub fn start(make: impl Fn() -> Regenerate + Send + 'static, notify: impl Fn() + Send + 'static) -> Self {
        let shared = Arc::new(Shared::default());
        let (sender, outcomes) = channel();
        let of_thread = Arc::clone(&shared);
        std::thread::spawn(move || run(&of_thread, &make, &sender, &notify));
        Self { shared, outcomes }
    }

    /// Puts `document` into the slot in place of one that has not been started.
    pub fn post(&self, document: Arc<Document>) {
        let mut state = self.shared.lock();
        state.next = Some(document);
        if let Some((cancel, since)) = &state.running
            && since.elapsed() > PATIENCE
        {
            cancel.cancel();
        }
        self.shared.wake.notify_one();
    }

    /// The outcomes since the last call, oldest first.
    pub fn outcomes(&self) -> impl Iterator<Item = Outcome> + '_ {
        self.outcomes.try_iter()
    }
}

impl Drop for Worker {
    fn drop(&mut self) {
        let mut state = self.shared.lock();
        state.closed = true;
        if let Some((cancel, _)) = &state.running {
            cancel.cancel();
        }
        self.shared.wake.notify_one();
    }
}

impl Shared {
    /// The state holds plain values, so a panic elsewhere leaves nothing half done behind the lock.
    fn lock(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Waits for a document; `None` once the worker is dropped.
    fn take(&self) -> Option<(Arc<Document>, Cancel)> {
        let mut state = self.lock();
        loop {
            if state.closed {
                return None;
            }
            if let Some(document) = state.next.take() {
                let cancel = Cancel::default();
                state.running = Some((cancel.clone(), Instant::now()));
                return Some((document, cancel));
            }
            state = self.wake.wait(state).unwrap_or_else(PoisonError::into_inner);
        }
    }
}

fn run(shared: &Shared, make: &dyn Fn() -> Regenerate, sender: &Sender<Outcome>, notify: &dyn Fn()) {
    let mut regenerate = make();
    while let Some((document, cancel)) = shared.take() {
        let start = Instant::now();
        let result = catch_unwind(AssertUnwindSafe(|| regenerate(&document, &cancel)));
        shared.lock().running = None;
        let outcome = match result {
            Ok(Ok(derived)) => Outcome::Done { derived: Arc::new(derived), took: start.elapsed() },
            Ok(Err(Cancelled)) => continue,
            Err(payload) => {
                regenerate = make();
                Outcome::Fault { document, message: words_of(payload.as_ref()) }
            }
        };
        if sender.send(outcome).is_err() {
            return;
        }
        notify();
    }
}

fn words_of(payload: &(dyn std::any::Any + Send)) -> String {
    let text = payload.downcast_ref::<&str>().copied();
    text.map(str::to_owned)
        .or_else(|| payload.downcast_ref::<String>().cloned())
        .unwrap_or_else(|| "the fault left no message".to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::{Content, TurnedPart};
    use crate::units::Unit;

    fn document(name: &str) -> Arc<Document> {
        let part = TurnedPart {
            machine: "orac".into(),
            material: "aluminium".into(),
            bar_diameter: 20.0,
            length: 30.0,
            ends: crate::document::Ends::One,
            part_off: false,
            automatic: false,
            form_tolerance: 0.1,
            sections: Vec::new(),
            ..TurnedPart::default()
        };
        Arc::new(Document { turnwright: 1, name: name.into(), unit: Unit::Mm, content: Content::TurnedPart(part) })
    }

    fn derived(document: &Arc<Document>) -> Derived {
        Derived {
            rolls: None,
            shell: None,
            document: Arc::clone(document),
            machine: None,
            material: None,
            setups: Vec::new(),
            diagnostics: Vec::new(),
        }
    }

    fn next(worker: &Worker) -> Outcome {
        worker.outcomes.recv_timeout(Duration::from_secs(30)).expect("an outcome")
    }

    #[test]
    fn the_latest_document_wins() {
        let (gate, wait) = channel::<()>();
        let wait = Arc::new(Mutex::new(wait));
        let worker = Worker::start(
            move || {
                let wait = Arc::clone(&wait);
                Box::new(move |d, _| {
                    wait.lock().unwrap().recv().unwrap();
                    Ok(derived(d))
                })
            },
            || {},
        );
        worker.post(document("first"));
        while worker.shared.lock().running.is_none() {
            std::thread::yield_now();
        }
        worker.post(document("second"));
        worker.post(document("third"));
        gate.send(()).unwrap();
        gate.send(()).unwrap();
        let names: Vec<String> = [next(&worker), next(&worker)]
            .iter()
            .map(|o| match o {
                Outcome::Done { derived, .. } => derived.document.name.clone(),
                Outcome::Fault { message, .. } => message.clone(),
            })
            .collect();
        assert_eq!(names, ["first", "third"]);
    }

    #[test]
    fn a_panic_becomes_an_outcome_and_the_thread_goes_on() {
        let worker = Worker::start(
            || Box::new(|d, _| if d.name == "bad" { panic!("row 3 has no end") } else { Ok(derived(d)) }),
            || {},
        );
        worker.post(document("bad"));
        assert!(matches!(next(&worker), Outcome::Fault { message, .. } if message == "row 3 has no end"));
        worker.post(document("good"));
        assert!(matches!(next(&worker), Outcome::Done { derived, .. } if derived.document.name == "good"));
    }
}
