//! Saving, recovery and what a crash left behind, all away from the window's thread.

use crate::diagnostic::Diagnostic;
use crate::document::Document;
use crate::machine::Catalog;
use crate::papers::{self, PaperKind};
use crate::regen::Derived;
use crate::storage::recovery::{Recovered, RecoverySession, left_over};
use crate::storage::{export, replace_file};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::mpsc::{Receiver, Sender, channel};
use std::time::SystemTime;

/// What was written where, or why not.
pub(crate) struct Written {
    /// The file.
    pub(crate) path: PathBuf,
    /// The document as it was written; `None` if it was a program or a paper.
    pub(crate) document: Option<Arc<Document>>,
    /// Remarks, or the reasons why nothing was written.
    pub(crate) result: Result<Vec<Diagnostic>, Vec<Diagnostic>>,
}

enum Order {
    Write(PathBuf, Arc<Document>, Arc<Catalog>),
    Text(PathBuf, Arc<str>),
    Papers(PathBuf, PaperKind, Arc<Derived>, Arc<Catalog>),
    Recovery(Arc<Document>, Option<PathBuf>),
    DiscardRecovery,
    TakeOver(Box<Recovered>),
}

/// The thread that writes files, in the order of the orders.
pub(crate) struct Files {
    orders: Sender<Order>,
    written: Receiver<Written>,
    thread: Option<std::thread::JoinHandle<()>>,
}

impl Files {
    /// Starts the thread. Recovery files go into `recovery_folder`; without one there are none.
    pub(crate) fn start(recovery_folder: Option<PathBuf>, notify: impl Fn() + Send + 'static) -> Self {
        let (orders, inbox) = channel();
        let (outbox, written) = channel();
        let thread = std::thread::spawn(move || {
            let recovery = recovery_folder.and_then(|folder| RecoverySession::start(&folder, SystemTime::now()).ok());
            for order in inbox {
                match order {
                    Order::Write(path, document, catalog) => {
                        let result = export::any(&document, &catalog, &path);
                        // The window may be gone; the file is written all the same.
                        let _ = outbox.send(Written { path, document: Some(document), result });
                        notify();
                    }
                    Order::Text(path, text) => {
                        let result = replace_file(&path, text.as_bytes()).map(|()| Vec::new()).map_err(|d| vec![d]);
                        let _ = outbox.send(Written { path, document: None, result });
                        notify();
                    }
                    Order::Papers(path, kind, derived, catalog) => {
                        let saved = kind.pages(&derived, &catalog).and_then(|pages| papers::save(&path, &pages));
                        let (path, result) = match saved {
                            Ok(files) => (files.into_iter().next().unwrap_or(path), Ok(Vec::new())),
                            Err(reason) => (path, Err(vec![reason])),
                        };
                        let _ = outbox.send(Written { path, document: None, result });
                        notify();
                    }
                    // A failed recovery file must not disturb the work; the next edit tries again.
                    Order::Recovery(document, path) => {
                        let write = |r: &RecoverySession| r.write(&document, path.as_deref(), SystemTime::now());
                        let _ = recovery.as_ref().map(write);
                    }
                    Order::TakeOver(left) => {
                        let write =
                            |r: &RecoverySession| r.write(&left.document, left.original.as_deref(), SystemTime::now());
                        if recovery.as_ref().is_some_and(|r| write(r).is_ok()) {
                            // If it stays behind, it is offered once more; nothing is lost.
                            let _ = left.discard();
                        }
                    }
                    Order::DiscardRecovery => _ = recovery.as_ref().map(RecoverySession::discard),
                }
            }
        });
        Self { orders, written, thread: Some(thread) }
    }

    /// Writes `document`, which names things of `catalog`; the kind of file goes by the extension of `path`.
    pub(crate) fn write(&self, path: PathBuf, document: Arc<Document>, catalog: Arc<Catalog>) {
        let _ = self.orders.send(Order::Write(path, document, catalog));
    }

    /// Writes a text as it is.
    pub(crate) fn write_text(&self, path: PathBuf, text: Arc<str>) {
        let _ = self.orders.send(Order::Text(path, text));
    }

    /// Makes papers of `derived`, whose tools are in `catalog`, and writes them; the kind of file goes by the extension.
    pub(crate) fn write_papers(&self, path: PathBuf, kind: PaperKind, derived: Arc<Derived>, catalog: Arc<Catalog>) {
        let _ = self.orders.send(Order::Papers(path, kind, derived, catalog));
    }

    /// Writes a recovery file of `document`.
    pub(crate) fn recover(&self, document: Arc<Document>, path: Option<&Path>) {
        let _ = self.orders.send(Order::Recovery(document, path.map(Path::to_owned)));
    }

    /// Keeps what an earlier run left as this run's own recovery file.
    pub(crate) fn take_over(&self, left: Recovered) {
        let _ = self.orders.send(Order::TakeOver(Box::new(left)));
    }

    /// Removes the recovery file: the work is saved, or given up.
    pub(crate) fn discard_recovery(&self) {
        let _ = self.orders.send(Order::DiscardRecovery);
    }

    /// What was written since the last call.
    pub(crate) fn written(&self) -> Option<Written> {
        self.written.try_recv().ok()
    }
}

impl Drop for Files {
    /// Waits for what is being written, so that closing the window never cuts a file short.
    fn drop(&mut self) {
        let (nobody, _) = channel();
        self.orders = nobody;
        if let Some(thread) = self.thread.take() {
            let _ = thread.join();
        }
    }
}

/// What earlier runs left in the recovery folder, newest first.
pub(crate) fn recovered(folder: Option<&Path>) -> Vec<Recovered> {
    folder.map(|folder| left_over(folder).0).unwrap_or_default()
}
