//! The virtual lathe on a pseudo-terminal, for other processes.

use super::{Control, LatheEvent, PtyOptions, VirtualLathe, serve};
use crate::cancel::Cancel;
use crate::machine::SerialProfile;
use crate::transfer::line;
use crate::transfer::serial::SerialLink;
use serialport::{SerialPort, TTYPort};
use std::fs;
use std::io::ErrorKind;
use std::os::unix::fs::symlink;
use std::path::{Path, PathBuf};

/// Serves until cancelled or unplugged by a fault. The first event is [`LatheEvent::Ready`] with the port to use.
///
/// # Errors
/// A sentence, if the line settings are impossible or the port or its link cannot be made.
pub fn run_on_pty(
    profile: &SerialProfile,
    options: &PtyOptions,
    on_event: &mut dyn FnMut(LatheEvent),
    cancel: &Cancel,
) -> Result<(), String> {
    line::check(profile)?;
    // The slave stays open here, so that a program that closes the port does not hang the lathe up.
    let (master, slave) = TTYPort::pair().map_err(|_| "The system gives no pseudo-terminal.".to_owned())?;
    let device = slave.name().ok_or("The system does not name the pseudo-terminal.")?;
    let guard = options.link.as_deref().map(|path| LinkGuard::make(&device, path)).transpose()?;
    let port = guard.as_ref().map_or(device, |guard| guard.0.display().to_string());
    on_event(LatheEvent::Ready { port });
    let lathe = VirtualLathe::new(options.faults.clone());
    let control = Control::new(lathe.clone(), profile, options.unpaced);
    let mut tell = || {
        lathe.take_events().into_iter().for_each(&mut *on_event);
        forget_exclusive_use(&slave);
    };
    serve(&mut SerialLink::new(master), control, cancel, &mut tell);
    Ok(())
}

/// A program that was killed leaves its mark of exclusive use on the terminal as long as the slave is open here, and no
/// other program could open it. Closing a second handle takes the mark away.
fn forget_exclusive_use(slave: &TTYPort) {
    drop(slave.try_clone_native());
}

/// A symbolic link that goes when this does.
struct LinkGuard(PathBuf);

impl LinkGuard {
    fn make(device: &str, path: &Path) -> Result<Self, String> {
        let shown = path.display();
        match fs::symlink_metadata(path) {
            Ok(found) if found.is_symlink() => {
                fs::remove_file(path).map_err(|_| format!("The old link {shown} could not be replaced."))?;
            }
            Ok(_) => return Err(format!("{shown} exists and is no symbolic link. Choose another name for the link.")),
            Err(_) => {}
        }
        symlink(device, path).map_err(|error| match error.kind() {
            ErrorKind::NotFound => format!("The folder of the link {shown} does not exist."),
            ErrorKind::PermissionDenied => format!("The link {shown} may not be made in this folder."),
            _ => format!("The link {shown} could not be made."),
        })?;
        Ok(Self(path.to_owned()))
    }
}

impl Drop for LinkGuard {
    fn drop(&mut self) {
        // A link that is gone already, or cannot be removed, hurts nobody: the next lathe replaces it.
        let _ = fs::remove_file(&self.0);
    }
}
