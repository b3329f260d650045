//! Section tables as text, from a file or the clipboard: every row that is read is written and read back the same.
#![no_main]

use libfuzzer_sys::fuzz_target;
use turnwright::storage::{export, import};
use turnwright::units::Unit;

fuzz_target!(|text: &str| {
    let (rows, _) = import::tsv("clipboard", text, Unit::Mm, 1);
    let (again, complaints) = import::tsv("clipboard", &export::tsv(&rows), Unit::Mm, 1);
    assert_eq!((again.len(), complaints.len()), (rows.len(), 0));
    let _ = import::tsv("clipboard", text, Unit::Inch, u32::MAX);
});
