//! One open document: its undo history, what follows from it, what is selected, and whether it is saved.

mod edits;
mod history;
mod light;
mod parts;
mod problems;
mod saved;
mod shells;

use crate::diagnostic::{Diagnostic, Severity};
use crate::document::{Document, RollRef};
use crate::machine::Dialect;
use crate::proof::{ProgramText, ProofReport};
use crate::regen::{Derived, Operations, SetupDerived};
use crate::worker::{Order, Outcome, Regenerate, Worker};
use edits::Typing;
pub use history::{GestureId, History};
use light::Light;
pub use light::{Hovered, Lit};
use problems::Problems;
pub use problems::code_of;
pub use saved::SaveState;
use std::path::PathBuf;
use std::sync::Arc;
use std::time::{Duration, Instant};

/// What is selected everywhere in the window at once.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Selection {
    /// Row of the section table, by id.
    pub section: Option<u32>,
    /// Clamping shown, by index.
    pub setup: usize,
    /// Program shown, by index among the programs of the clamping.
    pub program: usize,
    /// Block of that program, from 1.
    pub block: Option<usize>,
    /// Operation of the clamping shown, by index in its path.
    pub operation: Option<usize>,
    /// Roll of a set.
    pub roll: Option<RollRef>,
    /// Element of a cross-section, by id.
    pub element: Option<u32>,
    /// Station of a roll-forming line, by id.
    pub station: Option<u32>,
}

/// What the proofs of all clampings say together.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Verdict {
    /// Regenerating, or not started.
    Pending,
    /// No program could be made.
    NoProgram,
    /// Every proof passed.
    Proved {
        /// Machining time of all programs, s.
        time_s: f64,
        /// Blocks of all programs.
        blocks: usize,
    },
    /// At least one finding or diagnostic is an error.
    Failed {
        /// How many errors.
        errors: usize,
    },
}

/// Where a document comes from.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Origin {
    /// Its own file.
    File(PathBuf),
    /// New, an example, or imported: it has no file of its own yet.
    Fresh,
    /// Unsaved work of a run that crashed, with the document's own file if it had one.
    Recovered(Option<PathBuf>),
}

/// One open document.
pub struct Session {
    document: Arc<Document>,
    history: History,
    gestures: u64,
    typing: Option<Typing>,
    saved: Option<Arc<Document>>,
    path: Option<PathBuf>,
    recovered: bool,
    edited_at: Option<Instant>,
    worker: Worker,
    derived: Option<Arc<Derived>>,
    took: Duration,
    fault: Option<(Arc<Document>, String)>,
    problems: Problems,
    light: Light,
    /// What is selected.
    pub selection: Selection,
}

impl Session {
    /// Opens `document` and starts to regenerate it. `make` makes the work of the thread, `notify` is called from the
    /// thread after every outcome.
    #[must_use]
    pub fn new(
        document: Document,
        origin: Origin,
        make: impl Fn() -> Regenerate + Send + 'static,
        notify: impl Fn() + Send + 'static,
    ) -> Self {
        let document = Arc::new(document);
        let worker = Worker::start(make, notify);
        worker.post(Order { document: Arc::clone(&document), shown: None });
        Self {
            saved: matches!(origin, Origin::File(_)).then(|| Arc::clone(&document)),
            recovered: matches!(origin, Origin::Recovered(_)),
            document,
            history: History::default(),
            gestures: 0,
            typing: None,
            path: match origin {
                Origin::File(path) => Some(path),
                Origin::Recovered(path) => path,
                Origin::Fresh => None,
            },
            edited_at: None,
            worker,
            derived: None,
            took: Duration::ZERO,
            fault: None,
            problems: Problems::default(),
            light: Light::default(),
            selection: Selection::default(),
        }
    }

    /// Regenerates with another thread from now on, as when machines, tools or materials have changed; see [`Self::new`].
    pub fn work_anew(&mut self, make: impl Fn() -> Regenerate + Send + 'static, notify: impl Fn() + Send + 'static) {
        self.worker = Worker::start(make, notify);
        // Another one of equal content: what followed from the old data is out of date.
        self.document = Arc::new((*self.document).clone());
        self.post();
    }

    fn post(&self) {
        self.worker.post(Order { document: Arc::clone(&self.document), shown: self.roll() });
    }

    /// The document as it is now.
    #[must_use]
    pub const fn document(&self) -> &Arc<Document> {
        &self.document
    }

    fn changed(&mut self) {
        self.edited_at.get_or_insert_with(Instant::now);
        self.post();
        if self.selection.section.is_some_and(|id| self.part().row(id).is_none()) {
            self.selection.section = None;
        }
    }

    /// Takes what the thread has made since the last call; true if something came.
    pub fn receive(&mut self) -> bool {
        let outcomes: Vec<Outcome> = self.worker.outcomes().collect();
        let some = !outcomes.is_empty();
        for outcome in outcomes {
            match outcome {
                // What follows from the document as it is is here already, as after an undo: nothing older may take its place.
                Outcome::Done { derived, .. }
                    if self.is_designed() && !Arc::ptr_eq(&derived.document, &self.document) => {}
                Outcome::Done { derived, took } => {
                    self.fault = None;
                    self.took = took;
                    self.derived = Some(derived);
                }
                Outcome::Fault { document, message } => self.fault = Some((document, message)),
            }
        }
        if some {
            let fault = self.fault.as_ref().map(|(_, message)| message.as_str());
            self.problems = Problems::collect(fault, self.derived.as_deref());
            self.keep_selection_in_range();
            self.light.forget();
        }
        some
    }

    fn keep_selection_in_range(&mut self) {
        let Some(derived) = &self.derived else { return };
        let last = derived.setups.len().saturating_sub(1);
        self.selection.setup = match (&derived.rolls, self.selection.roll) {
            // A roll that cannot be turned has no clamping to show.
            (Some(rolls), Some(roll)) => rolls.of_roll(roll).map_or(derived.setups.len(), |roll| roll.setups.start),
            _ => self.selection.setup.min(last),
        };
        let programs = self.programs().len();
        self.selection.program = self.selection.program.min(programs.saturating_sub(1));
        let made = derived.setups.get(self.selection.setup).map_or(0, |s| s.path.operations.len());
        let operations = made.max(self.part().generator.instructions().len());
        self.selection.operation = self.selection.operation.filter(|index| *index < operations);
    }

    /// Everything that followed from the newest document that was regenerated.
    #[must_use]
    pub const fn derived(&self) -> Option<&Arc<Derived>> {
        self.derived.as_ref()
    }

    /// The clamping that is shown.
    #[must_use]
    pub fn setup(&self) -> Option<&SetupDerived> {
        self.derived.as_ref()?.setups.get(self.selection.setup)
    }

    /// The program that is shown, as it will be sent.
    #[must_use]
    pub fn program(&self) -> Option<&ProgramText> {
        self.programs().get(self.selection.program)
    }

    /// The programs of what is shown: of the clamping, or of the shell.
    #[must_use]
    pub fn programs(&self) -> &[ProgramText] {
        let shell = || self.derived.as_ref()?.shell.as_ref().map(|made| made.programs.as_slice());
        self.setup().map(|setup| setup.programs.as_slice()).or_else(shell).unwrap_or_default()
    }

    /// True if the programs of its machine are made of the ORAC's pages.
    #[must_use]
    pub fn is_in_pages(&self) -> bool {
        let machine = self.derived.as_ref().and_then(|d| d.machine.as_ref());
        machine.is_some_and(|machine| machine.dialect == Dialect::Orac)
    }

    /// Lights up what belongs to `hovered`: what is under the pointer, or else to the selected operation. True if something
    /// else is lit now.
    pub fn hover(&mut self, hovered: Option<Hovered>) -> bool {
        let hovered = hovered.or(self.selection.operation.map(Hovered::Operation));
        self.light.turn_to(hovered, self.derived.as_deref(), self.selection.setup)
    }

    /// The sections and blocks that belong to what the pointer is on.
    #[must_use]
    pub const fn lit(&self) -> &Lit {
        self.light.lit()
    }

    /// Selects an operation of the clamping shown and its first block, in place of a row of the table.
    pub fn select_operation(&mut self, index: usize) {
        self.selection.operation = Some(index);
        self.selection.section = None;
        let first = self.setup().and_then(|setup| Operations::of(setup).blocks(index).first().copied());
        if let Some(first) = first {
            self.selection.program = first.program;
            self.selection.block = Some(first.block);
        }
    }

    /// Selects a block of a program by name, in whatever clamping it is.
    pub fn select_block(&mut self, program: &str, block: usize) {
        let Some(derived) = &self.derived else { return };
        if let Some(index) =
            derived.shell.as_ref().and_then(|made| made.programs.iter().position(|p| p.name == program))
        {
            self.selection = Selection { program: index, block: Some(block), ..self.selection };
        }
        for (setup, of_setup) in derived.setups.iter().enumerate() {
            if let Some(index) = of_setup.programs.iter().position(|p| p.name == program) {
                let roll = derived.rolls.as_ref().and_then(|rolls| rolls.of_setup(setup)).map(|roll| roll.roll);
                self.selection = Selection { setup, roll, program: index, block: Some(block), ..self.selection };
            }
        }
    }

    /// True if [`Self::derived`] belongs to the document as it is now, and is all of it.
    #[must_use]
    pub fn is_current(&self) -> bool {
        self.is_designed() && self.derived.as_ref().is_some_and(|d| d.complete)
    }

    /// True if [`Self::derived`] belongs to the document as it is now, though rolls may still be in the making.
    #[must_use]
    pub fn is_designed(&self) -> bool {
        self.derived.as_ref().is_some_and(|d| Arc::ptr_eq(&d.document, &self.document))
    }

    /// Why what follows from the document must not leave the window yet: it belongs to an older one. `None` if it may.
    #[must_use]
    pub fn outdated(&self) -> Option<&'static str> {
        match &self.fault {
            _ if self.is_current() => None,
            Some((document, _)) if Arc::ptr_eq(document, &self.document) => {
                Some("The program of the document as it is now could not be made. Undo the last edit first.")
            }
            _ => Some("The program is being made anew from the last edit."),
        }
    }

    /// How long the last regeneration took.
    #[must_use]
    pub const fn took(&self) -> Duration {
        self.took
    }

    /// All that is to be said about the document and its programs, worst first.
    #[must_use]
    pub fn problems(&self) -> &[Diagnostic] {
        self.problems.all()
    }

    /// Those of [`Self::problems`] that are about a row of the section tables, worst first.
    pub fn problems_of_row(&self, id: u32) -> impl Iterator<Item = &Diagnostic> {
        self.problems.of_row(id)
    }

    /// How many of [`Self::problems`] are of this severity.
    #[must_use]
    pub fn problem_count(&self, severity: Severity) -> usize {
        self.problems.count(severity)
    }

    /// What the proofs say of the document as it is now; of a set, of the roll that is shown.
    #[must_use]
    pub fn verdict(&self) -> Verdict {
        if !self.is_current() {
            return if self.fault.is_some() { Verdict::Failed { errors: 1 } } else { Verdict::Pending };
        }
        let errors = self.errors_of_shown();
        if errors > 0 {
            return Verdict::Failed { errors };
        }
        let Some(shown) = self.shown() else { return Verdict::NoProgram };
        if let Some(made) = &shown.shell {
            return shells::verdict(made);
        }
        let proofs = || shown.setups.iter().map(|s| s.proof.as_ref());
        let blocks = proofs().map(|p| p.blocks.len()).sum();
        if blocks == 0 {
            return Verdict::NoProgram;
        }
        if !proofs().all(|p: &ProofReport| p.passed) {
            return Verdict::Failed { errors: 1 };
        }
        Verdict::Proved { time_s: proofs().map(|p| p.times.total_s).sum(), blocks }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::storage;
    use std::sync::Mutex;
    use std::sync::mpsc::channel;

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

    #[test]
    fn after_an_undo_what_is_late_of_the_undone_document_is_not_shown() {
        let example = &storage::examples()[0];
        let document = storage::document_from_text(example.name, example.text).unwrap();
        let ((gate, wait), (done, made)) = (channel::<()>(), channel::<()>());
        let wait = Arc::new(Mutex::new(wait));
        let make = move || -> Regenerate {
            let wait = Arc::clone(&wait);
            Box::new(move |order: &Order, _: &_, _: &mut _| {
                wait.lock().unwrap().recv().unwrap();
                Ok(derived(&order.document))
            })
        };
        let mut session = Session::new(document, Origin::Fresh, make, move || _ = done.send(()));
        let patience = Duration::from_secs(30);
        let next = || {
            gate.send(()).unwrap();
            made.recv_timeout(patience).unwrap();
        };
        next();
        assert!(session.receive() && session.is_current());
        session.edit("another name", None, |document| document.name.push('2'));
        // The work on the edit has begun when it is undone.
        let start = Instant::now();
        while !session.worker.is_running() {
            assert!(start.elapsed() < patience);
            std::thread::yield_now();
        }
        session.undo();
        assert!(session.is_current());
        next();
        assert!(session.receive() && session.is_current(), "what came belongs to the edit");
        next();
        assert!(session.receive() && session.is_current());
    }
}
