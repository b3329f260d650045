//! Roll profiles and cutting instructions, apart by a form feed; what is read makes a document that can be saved.
#![no_main]

use libfuzzer_sys::fuzz_target;
use turnwright::storage::{document_to_text, import};

fuzz_target!(|text: &str| {
    let (profile, instructions) = text.split_once('\x0c').unwrap_or((text, ""));
    match import::roll("FUZZ.txt", profile) {
        Ok((document, _)) => {
            document_to_text(&document).expect("what was read can be saved");
            match import::instructions("FUZZ.json", instructions, document) {
                Ok((document, _)) => _ = document_to_text(&document).expect("what was read can be saved"),
                Err(diagnostics) => assert!(!diagnostics.is_empty(), "refused without a word"),
            }
        }
        Err(diagnostics) => assert!(!diagnostics.is_empty(), "refused without a word"),
    }
});
