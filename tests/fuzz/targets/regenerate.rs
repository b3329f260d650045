//! Everything that follows from a document that could be read: checks, contour, paths, programs, proof.
#![no_main]

mod watch;

use libfuzzer_sys::fuzz_target;
use std::sync::{Arc, LazyLock};
use turnwright::machine::Catalog;
use turnwright::regen::{Cache, regenerate};
use turnwright::storage::document_from_text;

static CATALOG: LazyLock<Catalog> = LazyLock::new(Catalog::shipped);

fuzz_target!(|text: &str| {
    if let Ok(document) = document_from_text("fuzz.turn", text) {
        watch::bounded(|cancel| {
            let _ = regenerate(&Arc::new(document), &CATALOG, &mut Cache::default(), cancel);
        });
    }
});
