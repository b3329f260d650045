//! Replacing a file so that there is the old one or the new one at every moment, never half of one.

use crate::diagnostic::Diagnostic;
use crate::textfile::file_place;
use std::fs::{self, File, Permissions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// Writes `bytes` as the file `path`: a temporary file in the same folder, synced, renamed, and the folder synced.
///
/// The permissions of a file that is replaced are kept, and a symbolic link stays one.
///
/// # Errors
/// A diagnostic with the reason. The old file is then whole and no temporary file is left behind. A file marked
/// read-only is not replaced.
pub fn replace_file(path: &Path, bytes: &[u8]) -> Result<(), Diagnostic> {
    replace_with(path, |file| file.write_all(bytes))
}

/// As [`replace_file`], with the way of writing as an argument; what fails while writing leaves the old file as it was.
///
/// # Errors
/// As [`replace_file`].
pub(crate) fn replace_with(path: &Path, write: impl FnOnce(&mut File) -> io::Result<()>) -> Result<(), Diagnostic> {
    let failed = |what: &str, e: io::Error| {
        let message = format!("The file cannot be saved: {what} failed ({e}). The old file, if any, is unchanged.");
        Diagnostic::error("save-failed", file_place(path), message)
            .with_hint("Save under another name or in another folder.")
    };
    let target = fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
    let old = fs::metadata(&target).ok();
    if old.as_ref().is_some_and(fs::Metadata::is_dir) {
        return Err(failed("replacing a folder", io::ErrorKind::IsADirectory.into()));
    }
    let permissions = old.map(|m| m.permissions());
    if permissions.as_ref().is_some_and(Permissions::readonly) {
        return Err(failed("replacing a read-only file", io::ErrorKind::PermissionDenied.into()));
    }
    let folder = folder_of(&target);
    let mut temporary = new_file_in(&folder).map_err(|e| failed("making a temporary file", e))?;
    write(temporary.as_file_mut()).map_err(|e| failed("writing", e))?;
    if let Some(permissions) = permissions {
        temporary.as_file().set_permissions(permissions).map_err(|e| failed("setting permissions", e))?;
    }
    temporary.as_file().sync_all().map_err(|e| failed("writing to the disk", e))?;
    temporary.persist(&target).map_err(|e| failed("replacing the old file", e.error))?;
    sync_folder(&folder).map_err(|e| {
        let message = format!("The file is saved, but its folder could not be written to the disk ({e}).");
        Diagnostic::error("save-not-synced", file_place(path), message).with_hint("Save again before switching off.")
    })
}

fn folder_of(path: &Path) -> PathBuf {
    let parent = path.parent().filter(|p| !p.as_os_str().is_empty());
    parent.map_or_else(|| PathBuf::from("."), Path::to_owned)
}

/// A temporary file with the permissions that any new file has, not the private ones of a secret.
fn new_file_in(folder: &Path) -> io::Result<tempfile::NamedTempFile> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(".turnwright-");
    #[cfg(unix)]
    let permissions: Permissions = std::os::unix::fs::PermissionsExt::from_mode(0o666);
    #[cfg(unix)]
    builder.permissions(permissions);
    builder.tempfile_in(folder)
}

/// Makes the rename itself last. File systems that cannot sync a folder say so, and then there is nothing to do.
#[cfg(unix)]
fn sync_folder(folder: &Path) -> io::Result<()> {
    match File::open(folder)?.sync_all() {
        Err(e) if matches!(e.kind(), io::ErrorKind::InvalidInput | io::ErrorKind::Unsupported) => Ok(()),
        other => other,
    }
}

/// Only Unix lets a folder be opened to be synced.
#[cfg(not(unix))]
fn sync_folder(_: &Path) -> io::Result<()> {
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(folder: &Path) -> Vec<String> {
        fs::read_dir(folder).unwrap().map(|e| e.unwrap().file_name().into_string().unwrap()).collect()
    }

    fn folder_with(text: &str) -> (tempfile::TempDir, PathBuf) {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.turn");
        fs::write(&path, text).unwrap();
        (folder, path)
    }

    #[test]
    fn a_file_is_made_and_replaced() {
        let (folder, path) = folder_with("old");
        replace_file(&path, b"new").unwrap();
        replace_file(&folder.path().join("b.turn"), b"other").unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"new");
        assert_eq!(names(folder.path()).len(), 2);
    }

    #[test]
    fn a_write_that_fails_half_way_leaves_the_old_file_and_nothing_else() {
        let (folder, path) = folder_with("old");
        let fault = replace_with(&path, |file| {
            file.write_all(b"half of the new")?;
            Err(io::ErrorKind::StorageFull.into())
        });
        assert!(fault.unwrap_err().message.contains("no storage space"));
        assert_eq!(fs::read(&path).unwrap(), b"old");
        assert_eq!(names(folder.path()), ["a.turn"]);
    }

    #[test]
    fn a_write_that_panics_leaves_the_old_file() {
        let (folder, path) = folder_with("old");
        let run = std::panic::catch_unwind(|| replace_with(&path, |_| panic!("injected")));
        assert!(run.is_err());
        assert_eq!(fs::read(&path).unwrap(), b"old");
        assert_eq!(names(folder.path()), ["a.turn"]);
    }

    #[test]
    fn read_only_files_folders_and_missing_folders_are_refused() {
        let (folder, path) = folder_with("old");
        let mut permissions = fs::metadata(&path).unwrap().permissions();
        permissions.set_readonly(true);
        fs::set_permissions(&path, permissions).unwrap();
        assert_eq!(replace_file(&path, b"new").unwrap_err().code, "save-failed");
        assert_eq!(fs::read(&path).unwrap(), b"old");
        assert_eq!(replace_file(folder.path(), b"new").unwrap_err().code, "save-failed");
        let fault = replace_file(&folder.path().join("none/a.turn"), b"new").unwrap_err();
        assert!(fault.message.contains("making a temporary file"), "{fault}");
        assert_eq!(names(folder.path()), ["a.turn"]);
    }

    #[cfg(unix)]
    #[test]
    fn permissions_and_symbolic_links_are_kept() {
        use std::os::unix::fs::PermissionsExt;
        let (folder, path) = folder_with("old");
        fs::set_permissions(&path, Permissions::from_mode(0o640)).unwrap();
        let link = folder.path().join("link.turn");
        std::os::unix::fs::symlink(&path, &link).unwrap();
        replace_file(&link, b"new").unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"new");
        assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
        assert_eq!(fs::metadata(&path).unwrap().permissions().mode() & 0o777, 0o640);
        let plain = folder.path().join("plain");
        fs::write(&plain, "").unwrap();
        replace_file(&folder.path().join("fresh"), b"").unwrap();
        let mode = |p: &Path| fs::metadata(p).unwrap().permissions().mode();
        assert_eq!(mode(&folder.path().join("fresh")), mode(&plain));
    }
}
