//! Expressions in number fields: a finite figure or a sentence, in both units.
#![no_main]

use libfuzzer_sys::fuzz_target;
use turnwright::units::{Unit, parse_length};

fuzz_target!(|text: &str| {
    for unit in [Unit::Mm, Unit::Inch] {
        match parse_length(text, unit) {
            Ok(length) => assert!(length.is_finite()),
            Err(sentence) => assert!(!sentence.is_empty()),
        }
    }
});
