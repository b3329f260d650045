//! `.turn` documents: whatever is read can be saved and is then the same.
#![no_main]

use libfuzzer_sys::fuzz_target;
use turnwright::storage::{document_from_text, document_to_text};

fuzz_target!(|text: &str| {
    match document_from_text("fuzz.turn", text) {
        Ok(document) => {
            let saved = document_to_text(&document).expect("what was read can be saved");
            assert_eq!(document_from_text("fuzz.turn", &saved).as_ref(), Ok(&document));
        }
        Err(diagnostics) => assert!(!diagnostics.is_empty(), "refused without a word"),
    }
});
