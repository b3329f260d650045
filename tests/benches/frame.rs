//! What a frame of the window costs while a large part is dragged: `cargo bench --bench frame`.
//!
//! Parts of tapers, up to the most rows that a document may have. A node is dragged by one step a frame, while the thread
//! that regenerates works on every step. Measured is all that the window's thread does in a frame: input, panels and
//! plots, widgets for screen readers, and the triangles for the graphics card; not the drawing of these triangles, which
//! is the card's. No frame should take 33 ms.

#![allow(clippy::expect_used, reason = "a benchmark may stop at once when its data is not there")]
#![allow(clippy::print_stdout, reason = "a benchmark prints its figures")]

#[path = "../window/common/mod.rs"]
mod common;

use common::Window;
use egui::{Pos2, vec2};
use egui_kittest::kittest::Queryable;
use std::time::{Duration, Instant};
use turnwright::app::{Action, Pane};
use turnwright::document::{Content, Document};
use turnwright::part::Section;
use turnwright::storage;

/// Frames that are measured in each case.
const FRAMES: u16 = 120;

/// A wavy bar of `rows` tapers within the limits of the lathe.
fn wavy(rows: u32) -> Document {
    let example = storage::examples().iter().find(|e| e.name == "QUEEN").expect("the example is shipped");
    let mut document = storage::document_from_text("QUEEN", example.text).expect("shipped examples can be read");
    let Content::TurnedPart(part) = &mut document.content else { unreachable!("a turned part") };
    part.bar_diameter = 38.0;
    part.length = 80.0;
    let place = |row: u32| {
        let share = f64::from(row) / f64::from(rows);
        (part.length * share, 30.0 + 6.0 * (share * 40.0).sin())
    };
    part.sections = (0..rows)
        .map(|row| {
            let ((z1, d1), (z2, d2)) = (place(row), place(row + 1));
            Section::line(row + 1, z1, d1, z2, d2)
        })
        .collect();
    document
}

/// A window on `document` that shows `pane`, with everything regenerated once.
fn window_on(document: &Document, pane: Pane) -> Window {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("wavy.turn");
    storage::save_document(&path, document).expect("it is saved");
    let mut window = Window::open();
    let ctx = window.harness.ctx.clone();
    window.desk().act(&ctx, Action::Open(path));
    let start = Instant::now();
    while !window.session().is_current() {
        window.harness.step();
        std::thread::sleep(Duration::from_millis(20));
    }
    println!(
        "    regenerated in {:.2} s, {} problems",
        start.elapsed().as_secs_f64(),
        window.session().problems().len()
    );
    window.desk().act(&ctx, Action::ShowPane(pane));
    window.harness.run_steps(3);
    window
}

/// The handle of a node about a third along the part.
fn handle(window: &Window) -> Pos2 {
    let nodes: Vec<Pos2> =
        window.harness.get_all_by_label_contains("Node z").map(|node| node.rect().center()).collect();
    *nodes.get(nodes.len() / 3).expect("there are nodes")
}

/// One frame with its triangles. Copying the shapes, which the window itself does not, is not counted.
fn frame(window: &mut Window) -> Duration {
    let start = Instant::now();
    window.harness.step();
    let stepped = start.elapsed();
    let output = window.harness.output();
    let (shapes, pixels_per_point) = (output.shapes.clone(), output.pixels_per_point);
    let start = Instant::now();
    std::hint::black_box(window.harness.ctx.tessellate(shapes, pixels_per_point));
    stepped + start.elapsed()
}

fn drag(rows: u32, pane: Pane) {
    let mut window = window_on(&wavy(rows), pane);
    let from = handle(&window);
    window.harness.hover_at(from);
    window.harness.drag_at(from);
    let mut times: Vec<Duration> = (1..=FRAMES)
        .map(|step| {
            window.harness.hover_at(from + vec2(0.0, 6.0 * (f32::from(step) / 15.0).sin()));
            frame(&mut window)
        })
        .collect();
    window.harness.drop_at(from);
    window.harness.run_steps(2);
    let undo = window.session().history().undo_label().map(str::to_owned);
    times.sort_unstable();
    let ms = |share: usize| times[(times.len() - 1) * share / 100].as_secs_f64() * 1000.0;
    println!(
        "frame/{rows}-rows/{pane:?}: median {:.1} ms, 95 % {:.1} ms, longest {:.1} ms ({undo:?})",
        ms(50),
        ms(95),
        ms(100)
    );
}

fn main() {
    for rows in [200, 2000, 10_000] {
        for pane in [Pane::Program, Pane::Problems] {
            drag(rows, pane);
        }
    }
}
