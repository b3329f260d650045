//! The window: what a person does on it and what becomes of the document.

mod common;

use common::Window;

#[test]
fn the_start_page_opens_an_example() {
    let mut window = Window::open();
    window.harness.run_steps(3);
    window.screenshot("start-page");
    window.open_example("QUEEN");
    let desk = window.desk();
    assert_eq!(desk.session().unwrap().document().name, "QUEEN");
    window.screenshot("queen");
}
