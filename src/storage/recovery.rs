//! Recovery files: what a crash leaves of unsaved work.
//!
//! Every running program has one recovery file beside a lock file in a folder of their own. The operating system frees
//! the lock when the program ends, however it ends; a recovery file whose lock is free is left over from a crash.

use super::{document_from_text, document_to_text, replace_file};
use crate::diagnostic::{Diagnostic, Place};
use crate::document::Document;
use crate::textfile::{self, file_place};
use serde::{Deserialize, Serialize};
use std::fs::{self, File, TryLockError};
use std::io;
use std::path::{Path, PathBuf};
use std::time::{Duration, SystemTime, UNIX_EPOCH};

/// Longest recovery file that is read, bytes: a document and its first line.
const MOST_BYTES: u64 = 33 << 20;
/// Runs that may start within one millisecond.
const MOST_PER_MS: u32 = 1000;
const RECOVERY: &str = "recovery";
const LOCK: &str = "lock";

/// The recovery file of this running program.
#[derive(Debug)]
pub struct RecoverySession {
    path: PathBuf,
    /// Held open: closing it frees the lock.
    _lock: File,
}

/// A document that an earlier run left behind.
#[derive(Debug, Clone, PartialEq)]
pub struct Recovered {
    /// The recovery file.
    pub path: PathBuf,
    /// Where the document was opened from or saved to; `None` if it never was.
    pub original: Option<PathBuf>,
    /// When the recovery file was written.
    pub written: SystemTime,
    /// The document.
    pub document: Document,
}

/// First line of a recovery file; the document follows.
#[derive(Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Header {
    recovery: u32,
    written_unix_ms: u64,
    original: Option<String>,
}

/// Version of the first line.
const HEADER_VERSION: u32 = 1;

impl RecoverySession {
    /// Takes a name for this run in `folder`, which is made if it is not there. No recovery file is written yet.
    ///
    /// # Errors
    /// A diagnostic if the folder or the lock file cannot be made.
    pub fn start(folder: &Path, now: SystemTime) -> Result<Self, Diagnostic> {
        let failed = |e: io::Error| {
            let message = format!("Unsaved work cannot be kept in this folder: {e}.");
            Diagnostic::error("recovery-folder", file_place(folder), message)
        };
        fs::create_dir_all(folder).map_err(failed)?;
        for number in 0..MOST_PER_MS {
            let name = format!("{}-{number}", unix_ms(now));
            let lock = File::options().write(true).create_new(true).open(folder.join(&name).with_extension(LOCK));
            match lock {
                Ok(lock) => {
                    lock.lock().map_err(failed)?;
                    return Ok(Self { path: folder.join(name).with_extension(RECOVERY), _lock: lock });
                }
                Err(e) if e.kind() == io::ErrorKind::AlreadyExists => {}
                Err(e) => return Err(failed(e)),
            }
        }
        Err(failed(io::ErrorKind::AlreadyExists.into()))
    }

    /// Writes `document` in place of what the recovery file holds. `original` is the document's own file, if it has one.
    ///
    /// # Errors
    /// A diagnostic if the document cannot be saved; the old recovery file is then whole.
    pub fn write(&self, document: &Document, original: Option<&Path>, now: SystemTime) -> Result<(), Diagnostic> {
        let header = Header {
            recovery: HEADER_VERSION,
            written_unix_ms: unix_ms(now),
            original: original.map(|p| p.to_string_lossy().into_owned()),
        };
        let header = serde_json::to_string(&header)
            .map_err(|e| Diagnostic::error("recovery-unwritable", Place::Document, format!("{e}.")))?;
        replace_file(&self.path, format!("{header}\n{}", document_to_text(document)?).as_bytes())
    }

    /// Removes the recovery file, because the document is saved or its changes are given up.
    ///
    /// # Errors
    /// A diagnostic if the file is there and cannot be removed.
    pub fn discard(&self) -> Result<(), Diagnostic> {
        remove(&self.path)
    }
}

impl Drop for RecoverySession {
    /// Takes the lock file along, but never the recovery file: only [`RecoverySession::discard`] gives up work.
    fn drop(&mut self) {
        if !self.path.exists() {
            // A lock file that stays behind without recovery file is harmless.
            let _ = fs::remove_file(self.path.with_extension(LOCK));
        }
    }
}

impl Recovered {
    /// Removes the recovery file and its lock file.
    ///
    /// # Errors
    /// A diagnostic if a file is there and cannot be removed.
    pub fn discard(&self) -> Result<(), Diagnostic> {
        remove(&self.path)?;
        remove(&self.path.with_extension(LOCK))
    }
}

/// What earlier runs left in `folder`, newest first, and a diagnostic for every recovery file that cannot be read.
///
/// Files of programs that are still running are passed over, and an unreadable file is left where it is.
#[must_use]
pub fn left_over(folder: &Path) -> (Vec<Recovered>, Vec<Diagnostic>) {
    let mut found = Vec::new();
    let mut diagnostics = Vec::new();
    let entries = match fs::read_dir(folder) {
        Ok(entries) => entries,
        Err(e) if e.kind() == io::ErrorKind::NotFound => return (found, diagnostics),
        Err(e) => {
            let message = format!("The folder of unsaved work cannot be read: {e}.");
            return (found, vec![Diagnostic::error("recovery-folder", file_place(folder), message)]);
        }
    };
    let paths = entries.filter_map(|e| Some(e.ok()?.path()));
    for path in paths.filter(|p| p.extension().is_some_and(|e| e == RECOVERY) && !is_running(p)) {
        match read(&path) {
            Ok(recovered) => found.push(recovered),
            Err(faults) => diagnostics.extend(faults),
        }
    }
    found.sort_by(|a, b| b.written.cmp(&a.written).then_with(|| a.path.cmp(&b.path)));
    (found, diagnostics)
}

/// True if the lock beside a recovery file is held by a running program.
fn is_running(recovery: &Path) -> bool {
    let lock = File::open(recovery.with_extension(LOCK));
    lock.is_ok_and(|file| matches!(file.try_lock(), Err(TryLockError::WouldBlock)))
}

fn read(path: &Path) -> Result<Recovered, Vec<Diagnostic>> {
    let name = path.display().to_string();
    let text = textfile::read(path, MOST_BYTES).map_err(|d| vec![d])?;
    let header = text.lines().next().unwrap_or_default();
    let header: Header = serde_json::from_str(header).map_err(|e| {
        let message = format!("The first line is not that of a recovery file ({e}); it reads `{header:.80}`.");
        vec![Diagnostic::error("recovery-unreadable", textfile::line_place(&name, 1, Some(e.column())), message)]
    })?;
    if header.recovery != HEADER_VERSION {
        let message =
            format!("The recovery file is of version {}; this program reads {HEADER_VERSION}.", header.recovery);
        return Err(vec![Diagnostic::error("newer-version", textfile::line_place(&name, 1, None), message)]);
    }
    // The first line is blanked, not cut off, so that messages keep the numbers of the lines.
    let document = document_from_text(&name, text.get(text.find('\n').unwrap_or(text.len())..).unwrap_or_default())?;
    Ok(Recovered {
        path: path.to_owned(),
        original: header.original.map(PathBuf::from),
        written: UNIX_EPOCH + Duration::from_millis(header.written_unix_ms),
        document,
    })
}

fn remove(path: &Path) -> Result<(), Diagnostic> {
    match fs::remove_file(path) {
        Err(e) if e.kind() != io::ErrorKind::NotFound => {
            let message = format!("The file of unsaved work cannot be removed: {e}.");
            Err(Diagnostic::error("recovery-unremovable", file_place(path), message))
        }
        _ => Ok(()),
    }
}

/// Milliseconds since 1970; 0 for a clock that is set before it.
fn unix_ms(time: SystemTime) -> u64 {
    time.duration_since(UNIX_EPOCH).ok().and_then(|d| u64::try_from(d.as_millis()).ok()).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::storage::examples;

    fn document() -> Document {
        document_from_text("", examples()[0].text).unwrap()
    }

    fn at(ms: u64) -> SystemTime {
        UNIX_EPOCH + Duration::from_millis(ms)
    }

    /// What the end of a program without clean-up does: the lock is freed, the files stay.
    fn crash(session: RecoverySession) {
        drop(session);
    }

    #[test]
    fn work_of_a_crashed_run_is_found_newest_first_and_can_be_discarded() {
        let folder = tempfile::tempdir().unwrap();
        let dir = folder.path().join("recovery");
        assert_eq!(left_over(&dir), (vec![], vec![]));
        let (never_saved, saved) =
            (RecoverySession::start(&dir, at(5)).unwrap(), RecoverySession::start(&dir, at(5)).unwrap());
        never_saved.write(&document(), None, at(10)).unwrap();
        saved.write(&document(), Some(Path::new("/home/x/queen.turn")), at(15)).unwrap();
        saved.write(&document(), Some(Path::new("/home/x/queen.turn")), at(20)).unwrap();
        crash(never_saved);
        crash(saved);
        let (found, diagnostics) = left_over(&dir);
        assert_eq!(diagnostics, []);
        assert_eq!(found.iter().map(|f| f.written).collect::<Vec<_>>(), [at(20), at(10)]);
        assert_eq!(found[0].original.as_deref(), Some(Path::new("/home/x/queen.turn")));
        assert_eq!((&found[1].original, &found[1].document), (&None, &document()));
        for recovered in found {
            recovered.discard().unwrap();
        }
        assert_eq!(left_over(&dir), (vec![], vec![]));
        assert_eq!(fs::read_dir(&dir).unwrap().count(), 0);
    }

    #[test]
    fn a_running_program_keeps_its_file_to_itself() {
        let folder = tempfile::tempdir().unwrap();
        let session = RecoverySession::start(folder.path(), at(5)).unwrap();
        session.write(&document(), None, at(10)).unwrap();
        assert_eq!(left_over(folder.path()), (vec![], vec![]));
        crash(session);
        assert_eq!(left_over(folder.path()).0.len(), 1);
    }

    #[test]
    fn a_clean_end_leaves_nothing() {
        let folder = tempfile::tempdir().unwrap();
        let session = RecoverySession::start(folder.path(), at(5)).unwrap();
        session.write(&document(), None, at(10)).unwrap();
        session.discard().unwrap();
        session.discard().unwrap();
        drop(session);
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0);
    }

    #[test]
    fn a_broken_recovery_file_is_reported_and_kept() {
        let folder = tempfile::tempdir().unwrap();
        let session = RecoverySession::start(folder.path(), at(5)).unwrap();
        session.write(&document(), None, at(10)).unwrap();
        let path = session.path.clone();
        crash(session);
        let text = fs::read_to_string(&path).unwrap();
        for end in (0..text.len() - 2).step_by(97) {
            fs::write(&path, &text[..end]).unwrap();
            let (found, diagnostics) = left_over(folder.path());
            assert!(found.is_empty() && !diagnostics.is_empty(), "{end}");
        }
        fs::write(&path, text.replace("56.0", "NaN")).unwrap();
        let (_, diagnostics) = left_over(folder.path());
        let line = 1 + text.lines().position(|l| l.contains("56.0")).unwrap();
        assert!(matches!(diagnostics[0].at, Place::Line { line: l, .. } if l == line), "{}", diagnostics[0]);
        fs::write(&path, text.replacen("\"recovery\":1", "\"recovery\":2", 1)).unwrap();
        assert_eq!(left_over(folder.path()).1[0].code, "newer-version");
        assert!(path.exists());
    }
}
