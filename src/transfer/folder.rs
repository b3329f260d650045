//! Programs for controls that read them from a folder: a file appears whole, under the program's name, or not at all.

use super::compare::{Blanks, Piece, compare_pieces};
use super::job::{Event, Outcome, State, Task};
use super::log::{Direction, LogLine, visible};
use crate::cancel::Cancel;
use crate::diagnostic::Diagnostic;
use crate::machine::FolderProfile;
use crate::replace::replace_with;
use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::sync::mpsc::{self, RecvTimeoutError};
use std::thread;
use std::time::{Duration, Instant};

/// Longest wait between two looks at the abort flag.
const LOOK: Duration = Duration::from_millis(20);

/// Saves or compares. A folder on a network may never answer, so a thread that nobody waits for touches it; `patience`
/// bounds the wait.
pub(super) fn run(
    task: Task,
    profile: &FolderProfile,
    patience: Duration,
    cancel: &Cancel,
    tell: &dyn Fn(Event),
) -> Outcome {
    let began = Instant::now();
    let name = match &task {
        Task::Send { name, .. } | Task::Compare { name, .. } => name,
        Task::Receive => {
            let folder = &profile.folder;
            let reason = format!("Nothing can be received: this control takes its programs from the folder {folder}.");
            return Outcome::Failed(reason);
        }
    };
    let path = match path_of(profile, name) {
        Ok(path) => path,
        Err(reason) => return Outcome::Failed(reason),
    };
    tell(Event::State(State::Saving));
    tell(Event::Log(LogLine { at: began.elapsed(), direction: Direction::Note, text: path.display().to_string() }));
    let (sender, done) = mpsc::channel();
    let given_up = Cancel::default();
    let for_thread = given_up.clone();
    thread::spawn(move || {
        // Nobody listens any more once the transfer was given up.
        let _ = sender.send(work(&task, &path, &for_thread));
    });
    loop {
        match done.recv_timeout(LOOK) {
            Ok(outcome) => return outcome,
            Err(RecvTimeoutError::Disconnected) => return failed("saving stopped unexpectedly"),
            Err(RecvTimeoutError::Timeout) => {}
        }
        if cancel.is_cancelled() {
            given_up.cancel();
            return Outcome::Aborted;
        }
        if began.elapsed() >= patience {
            given_up.cancel();
            return failed(&format!("its folder did not answer within {} s", patience.as_secs_f64()));
        }
    }
}

fn work(task: &Task, path: &Path, given_up: &Cancel) -> Outcome {
    match task {
        Task::Send { text, .. } => {
            let folder = path.parent().unwrap_or(path);
            if !folder.is_dir() {
                let folder = folder.display();
                return failed(&format!("there is no folder {folder}; make it, mount it, or choose another"));
            }
            match save(path, text, given_up) {
                Ok(()) => read_back(path, text),
                Err(diagnostic) => Outcome::Failed(diagnostic.to_string()),
            }
        }
        Task::Compare { sent, .. } => match fs::read(path) {
            Ok(bytes) => compare(sent, &String::from_utf8_lossy(&bytes)),
            Err(error) => Outcome::Failed(format!("{} cannot be read: {error}.", path.display())),
        },
        Task::Receive => failed("nothing was to be saved"),
    }
}

/// Writes the file whole and gives it its name, unless it was given up before.
fn save(path: &Path, text: &str, given_up: &Cancel) -> Result<(), Diagnostic> {
    replace_with(path, |file| {
        file.write_all(text.as_bytes())?;
        given_up.check().map_err(|_| io::ErrorKind::Interrupted.into())
    })
}

fn read_back(path: &Path, text: &str) -> Outcome {
    match fs::read(path) {
        Ok(bytes) if bytes == text.as_bytes() => Outcome::Saved(path.to_owned()),
        Ok(bytes) => compare(text, &String::from_utf8_lossy(&bytes)),
        Err(error) => failed(&format!("it was written to {} but cannot be read back ({error})", path.display())),
    }
}

fn compare(sent: &str, found: &str) -> Outcome {
    let (sent, found): (Vec<_>, Vec<_>) = (sent.split('\n').collect(), found.split('\n').collect());
    let differences = compare_pieces(Piece::Block, &sent, &found, Blanks::Exact);
    if differences.is_empty() { Outcome::Verified } else { Outcome::Different(differences) }
}

fn failed(why: &str) -> Outcome {
    Outcome::Failed(format!("The program was not saved: {why}."))
}

/// The file of a program.
fn path_of(profile: &FolderProfile, name: &str) -> Result<PathBuf, String> {
    if let Some((_, message)) = profile.faults().into_iter().next() {
        return Err(message);
    }
    if let Some(stray) = name.chars().find(|&c| !(c.is_alphanumeric() || "-_. ".contains(c))) {
        let shown = u8::try_from(stray).map_or_else(|_| stray.to_string(), visible);
        return Err(format!("The program is named \"{name}\"; a file name cannot hold `{shown}`. Rename the program."));
    }
    if name.trim().is_empty() || name.starts_with('.') {
        return Err(format!("The program is named \"{name}\"; that is no name for a file. Rename the program."));
    }
    let folder = match profile.folder.strip_prefix("~/") {
        None => PathBuf::from(&profile.folder),
        Some(rest) => dirs::home_dir()
            .ok_or_else(|| format!("The home folder for {} is not known. Choose an absolute path.", profile.folder))?
            .join(rest),
    };
    Ok(folder.join(format!("{name}.{}", profile.extension)))
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "G21\nM2\n";

    fn profile(folder: &Path) -> FolderProfile {
        FolderProfile { folder: folder.display().to_string(), extension: "ngc".to_owned() }
    }

    fn send_to(folder: &Path, name: &str, cancel: &Cancel) -> Outcome {
        let task = Task::Send { name: name.to_owned(), text: TEXT.to_owned(), verify: false };
        run(task, &profile(folder), Duration::from_secs(10), cancel, &|_| ())
    }

    fn files(folder: &Path) -> Vec<String> {
        fs::read_dir(folder).unwrap().map(|e| e.unwrap().file_name().into_string().unwrap()).collect()
    }

    #[test]
    fn a_program_is_saved_whole_under_its_name_and_compared() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("QUEEN1.ngc");
        for old in [None, Some("old")] {
            if let Some(old) = old {
                fs::write(&path, old).unwrap();
            }
            assert_eq!(send_to(folder.path(), "QUEEN1", &Cancel::default()), Outcome::Saved(path.clone()));
            assert_eq!(fs::read_to_string(&path).unwrap(), TEXT);
            assert_eq!(files(folder.path()), ["QUEEN1.ngc"]);
        }
        let compare = || Task::Compare { name: "QUEEN1".to_owned(), sent: TEXT.to_owned() };
        let run = |task| run(task, &profile(folder.path()), Duration::from_secs(10), &Cancel::default(), &|_| ());
        assert_eq!(run(compare()), Outcome::Verified);
        fs::write(&path, "G20\nM2\n").unwrap();
        assert!(matches!(run(compare()), Outcome::Different(list) if list.len() == 1));
        fs::remove_file(&path).unwrap();
        assert!(matches!(run(compare()), Outcome::Failed(reason) if reason.contains("cannot be read")));
        assert!(matches!(run(Task::Receive), Outcome::Failed(reason) if reason.contains("Nothing can be received")));
    }

    #[test]
    fn what_cannot_be_saved_is_told_and_leaves_nothing_behind() {
        let folder = tempfile::tempdir().unwrap();
        fs::create_dir(folder.path().join("BUSY.ngc")).unwrap();
        fs::write(folder.path().join("file"), "").unwrap();
        for (place, name, words) in [
            (folder.path().join("none"), "A", "there is no folder"),
            (folder.path().join("file"), "A", "there is no folder"),
            (folder.path().to_owned(), "BUSY", "replacing a folder"),
            (folder.path().to_owned(), "../A", "cannot hold `/`"),
            (folder.path().to_owned(), ".A", "no name for a file"),
            (folder.path().to_owned(), " ", "no name for a file"),
            (PathBuf::from("relative"), "A", "must be an absolute path"),
        ] {
            let outcome = send_to(&place, name, &Cancel::default());
            assert!(matches!(&outcome, Outcome::Failed(reason) if reason.contains(words)), "{words}: {outcome:?}");
        }
        assert_eq!(files(folder.path()).len(), 2);
    }

    #[test]
    fn a_save_that_was_given_up_leaves_the_old_file() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("A.ngc");
        fs::write(&path, "old").unwrap();
        let given_up = Cancel::default();
        given_up.cancel();
        assert!(save(&path, TEXT, &given_up).is_err());
        assert_eq!((fs::read_to_string(&path).unwrap().as_str(), files(folder.path()).len()), ("old", 1));
    }
}
