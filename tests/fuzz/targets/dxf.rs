//! DXF drawings with a profile.
#![no_main]

use libfuzzer_sys::fuzz_target;
use turnwright::storage::{document_to_text, import};

fuzz_target!(|bytes: &[u8]| {
    match import::dxf("fuzz.dxf", "FUZZ", bytes, "orac") {
        Ok((document, _)) => _ = document_to_text(&document).expect("what was read can be saved"),
        Err(diagnostics) => assert!(!diagnostics.is_empty(), "refused without a word"),
    }
});
