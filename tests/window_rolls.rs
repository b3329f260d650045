//! The desk of a set of form-rolls: elements, bend angles, stations and rolls, as a person works with them.
//!
//! `UPDATE_SCREENSHOTS=1 cargo test --test window_rolls` draws the picture in `screenshots/` anew.

#![cfg(feature = "gui")]
#![allow(clippy::unwrap_used, reason = "a test may stop at what cannot be")]

mod common;

use common::Window;
use std::path::Path;
use turnwright::app::Action;

/// The published section.
fn open() -> Window {
    let mut window = Window::open();
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/examples/1470b.turn");
    let ctx = window.harness.ctx.clone();
    window.desk().act(&ctx, Action::Open(path));
    window.until("opened", |desk| desk.session().is_some());
    window.until_current();
    window.harness.run_steps(3);
    window
}

#[test]
fn the_published_section_is_on_the_desk_with_all_its_rolls() {
    let mut window = open();
    let derived = window.session().derived().unwrap().clone();
    window.screenshot("roll-set");
    assert_eq!(derived.rolls.as_ref().unwrap().rolls.len(), 8);
}
