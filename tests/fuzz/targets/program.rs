//! ORAC programs of either layout: read and run without stock, within the step budget.
#![no_main]

use libfuzzer_sys::fuzz_target;
use std::collections::BTreeMap;
use std::sync::{Arc, LazyLock};
use turnwright::cancel::Cancel;
use turnwright::machine::{Catalog, Machine, ToolOutline, outlines};
use turnwright::proof::{ProgramText, ProofInput, proof_json, prove};

static LATHE: LazyLock<(Arc<Machine>, Arc<BTreeMap<u32, ToolOutline>>)> = LazyLock::new(|| {
    let catalog = Catalog::shipped();
    let machine = catalog.machine("orac").expect("shipped").clone();
    let tools = outlines(&machine, &catalog);
    (Arc::new(machine), Arc::new(tools))
});

fuzz_target!(|text: &str| {
    let (machine, tools) = &*LATHE;
    let programs = Arc::new(vec![ProgramText { name: "FUZZ".to_owned(), text: text.to_owned(), edited: true }]);
    let input = ProofInput { machine: Arc::clone(machine), tools: Arc::clone(tools), programs, work: None };
    let report = prove(&input, &Cancel::default()).expect("nobody cancels");
    assert!(report.times.total_s.is_finite() && report.times.total_s >= 0.0, "{:?}", report.times);
    let _ = proof_json(&input, &report);
});
