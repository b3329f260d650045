//! Where the program keeps what is the user's.

use std::path::PathBuf;

/// Folder of the user's machines, tools and materials, on Linux `~/.config/turnwright`; `None` where the system names none.
#[must_use]
pub fn config_folder() -> Option<PathBuf> {
    dirs::config_dir().map(|folder| folder.join("turnwright"))
}

/// Folder of recovery files, on Linux `~/.local/share/turnwright`; `None` where the system names none.
#[must_use]
pub fn data_folder() -> Option<PathBuf> {
    dirs::data_dir().map(|folder| folder.join("turnwright"))
}
