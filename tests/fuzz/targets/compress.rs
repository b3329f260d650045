//! Page and instruction files back to instructions: what is read is written and read back the same, and the proof's own
//! reader has no trouble with it.
#![no_main]

use libfuzzer_sys::fuzz_target;
use turnwright::post::orac::{compress, instructions_text, optimize, pages_text, parse_instructions};
use turnwright::proof::reader;

fuzz_target!(|text: &str| {
    for (list, _) in [compress(text, "FUZZ"), parse_instructions(text, "fuzz.anc")] {
        let _ = optimize(&list);
        let (pages, lines) = (pages_text(&list), instructions_text(&list));
        assert_eq!(compress(&pages, "FUZZ").0, list);
        assert_eq!(parse_instructions(&lines, "fuzz.anc").0, list);
        for written in [pages, lines] {
            let listing = reader::read(&written);
            assert_eq!((listing.blocks.len(), listing.troubles), (list.len(), Vec::new()), "{written}");
        }
    }
});
