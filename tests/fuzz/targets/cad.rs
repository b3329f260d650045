//! ORACAP part files: `.CAD`, `.SIZ` and `.END`, apart by form feeds; what is read goes through the exports and back.
#![no_main]

use libfuzzer_sys::fuzz_target;
use turnwright::storage::{document_to_text, export, import};

fuzz_target!(|text: &str| {
    let mut files = text.split('\x0c').map(str::to_owned);
    let cad = files.next().unwrap_or_default();
    let texts = import::CadTexts { cad, siz: files.next(), end: files.next() };
    match import::cad("FUZZ.CAD", "FUZZ", &texts, "orac") {
        Ok((document, _)) => {
            document_to_text(&document).expect("what was read can be saved");
            let part = document.content.turned_part().expect("a part file holds a part");
            let (written, _) = export::cad(&document, part);
            let _ = import::cad("FUZZ.CAD", "FUZZ", &written, "orac");
        }
        Err(diagnostics) => assert!(!diagnostics.is_empty(), "refused without a word"),
    }
});
