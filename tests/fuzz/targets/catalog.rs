//! Machine, tool and material files of the user: the same text as each kind of file.
#![no_main]

use libfuzzer_sys::fuzz_target;
use std::sync::LazyLock;
use tempfile::TempDir;
use turnwright::machine::{Catalog, outlines};

const FOLDERS: [&str; 3] = ["machines", "tools", "materials"];

static FOLDER: LazyLock<TempDir> = LazyLock::new(|| {
    let folder = tempfile::tempdir().expect("a folder");
    for kind in FOLDERS {
        std::fs::create_dir(folder.path().join(kind)).expect("a folder");
    }
    folder
});

fuzz_target!(|bytes: &[u8]| {
    for kind in FOLDERS {
        std::fs::write(FOLDER.path().join(kind).join("fuzz.toml"), bytes).expect("a file");
    }
    let (catalog, _) = Catalog::load(Some(FOLDER.path()));
    for machine in &catalog.machines {
        let _ = outlines(machine, &catalog);
    }
});
