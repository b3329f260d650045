//! The thread that regenerates, and the slot in front of it: the latest document wins.

use crate::cancel::{Cancel, Cancelled};
use crate::document::{Document, RollRef};
use crate::machine::Catalog;
use crate::regen::{Cache, Derived, Steps, regenerate_in_steps};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::mpsc::{Receiver, Sender, channel};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

/// A regeneration that is still running after this time gives way to a newer document; a quicker one is let finish,
/// so that the picture moves during a drag even where one regeneration takes several frames.
const PATIENCE: Duration = Duration::from_millis(300);

/// Makes everything that follows from a document. One lives as long as nothing panics; it may keep a cache.
pub type Regenerate = Box<dyn FnMut(&Order, &Cancel, &mut dyn FnMut(Derived)) -> Result<Derived, Cancelled>>;

/// A document to be regenerated.
#[derive(Debug, Clone)]
pub struct Order {
    /// The document.
    pub document: Arc<Document>,
    /// The roll of a set that is shown, to be made before the others.
    pub shown: Option<RollRef>,
}

/// The work of the window's thread: everything that follows from a document, with a cache from one to the next.
#[must_use]
pub fn regenerating(catalog: Arc<Catalog>) -> Regenerate {
    let mut cache = Cache::default();
    Box::new(move |order, cancel, tell| {
        let steps = Steps { first: order.shown, tell };
        regenerate_in_steps(&order.document, &catalog, &mut cache, cancel, steps)
    })
}

/// What came of one document.
#[derive(Debug, Clone)]
pub enum Outcome {
    /// It was regenerated.
    Done {
        /// What follows from it, or as much of it as there is by now.
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
    next: Option<Order>,
    running: Option<Running>,
    closed: bool,
}

struct Running {
    cancel: Cancel,
    since: Instant,
    /// The window has got something of it already.
    told: bool,
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

    /// Puts `order` into the slot in place of one that has not been started.
    pub fn post(&self, order: Order) {
        let mut state = self.shared.lock();
        state.next = Some(order);
        if let Some(running) = &state.running
            && (running.told || running.since.elapsed() > PATIENCE)
        {
            running.cancel.cancel();
        }
        self.shared.wake.notify_one();
    }

    /// True while a document is regenerated.
    #[cfg(test)]
    pub(crate) fn is_running(&self) -> bool {
        self.shared.lock().running.is_some()
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
        if let Some(running) = &state.running {
            running.cancel.cancel();
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
    fn take(&self) -> Option<(Order, Cancel)> {
        let mut state = self.lock();
        loop {
            if state.closed {
                return None;
            }
            if let Some(order) = state.next.take() {
                let cancel = Cancel::default();
                state.running = Some(Running { cancel: cancel.clone(), since: Instant::now(), told: false });
                return Some((order, cancel));
            }
            state = self.wake.wait(state).unwrap_or_else(PoisonError::into_inner);
        }
    }
}

fn run(shared: &Shared, make: &dyn Fn() -> Regenerate, sender: &Sender<Outcome>, notify: &dyn Fn()) {
    let mut regenerate = make();
    while let Some((order, cancel)) = shared.take() {
        let start = Instant::now();
        let mut tell = |derived| {
            let _ = sender.send(Outcome::Done { derived: Arc::new(derived), took: start.elapsed() });
            notify();
            shared.lock().running.iter_mut().for_each(|running| running.told = true);
        };
        let result = catch_unwind(AssertUnwindSafe(|| regenerate(&order, &cancel, &mut tell)));
        shared.lock().running = None;
        let outcome = match result {
            Ok(Ok(derived)) => Outcome::Done { derived: Arc::new(derived), took: start.elapsed() },
            Ok(Err(Cancelled)) => continue,
            Err(payload) => {
                regenerate = make();
                Outcome::Fault { document: order.document, message: words_of(payload.as_ref()) }
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

    fn order(name: &str) -> Order {
        Order { document: document(name), shown: None }
    }

    fn derived(document: &Arc<Document>) -> Derived {
        Derived {
            rolls: None,
            complete: true,
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
                Box::new(move |order, _, _| {
                    wait.lock().unwrap().recv().unwrap();
                    Ok(derived(&order.document))
                })
            },
            || {},
        );
        worker.post(order("first"));
        while !worker.is_running() {
            std::thread::yield_now();
        }
        worker.post(order("second"));
        worker.post(order("third"));
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
    fn a_document_that_was_shown_in_part_gives_way_at_once() {
        let worker = Worker::start(
            || {
                Box::new(move |order, cancel, tell| {
                    if order.document.name == "long" {
                        tell(Derived { complete: false, ..derived(&order.document) });
                        while cancel.check().is_ok() {
                            std::thread::yield_now();
                        }
                    }
                    cancel.check().map(|()| derived(&order.document))
                })
            },
            || {},
        );
        worker.post(order("long"));
        assert!(matches!(next(&worker), Outcome::Done { derived, .. } if !derived.complete));
        while !worker.shared.lock().running.as_ref().is_some_and(|running| running.told) {
            std::thread::yield_now();
        }
        worker.post(order("next"));
        assert!(matches!(next(&worker), Outcome::Done { derived, .. } if derived.document.name == "next"));
    }

    #[test]
    fn a_panic_becomes_an_outcome_and_the_thread_goes_on() {
        let worker = Worker::start(
            || {
                Box::new(|order, _, _| match order.document.name.as_str() {
                    "bad" => panic!("row 3 has no end"),
                    _ => Ok(derived(&order.document)),
                })
            },
            || {},
        );
        worker.post(order("bad"));
        assert!(matches!(next(&worker), Outcome::Fault { message, .. } if message == "row 3 has no end"));
        worker.post(order("good"));
        assert!(matches!(next(&worker), Outcome::Done { derived, .. } if derived.document.name == "good"));
    }
}
