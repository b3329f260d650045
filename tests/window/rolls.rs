//! The desk of a set of form-rolls: the published section with all its rolls, its papers, and what keeps a roll from the lathe.
//!
//! `UPDATE_SCREENSHOTS=1 cargo test --test window rolls::` draws the picture in `screenshots/` anew.

use crate::common::Window;
use turnwright::app::Action;
use turnwright::document::{Content, EditAction, RollKind, RollRef};
use turnwright::papers::{DrawingChoice, PaperKind};
use turnwright::session::Verdict;

const TOP_1: RollRef = RollRef { station: 1, kind: RollKind::Top };
const TOP_2: RollRef = RollRef { station: 2, kind: RollKind::Top };

fn open() -> Window {
    Window::with_file("assets/examples/1470b.turn")
}

#[test]
fn the_published_section_is_on_the_desk_with_all_its_rolls() {
    let mut window = open();
    let derived = window.session().derived().unwrap().clone();
    window.screenshot("roll-set");
    assert_eq!(derived.rolls.as_ref().unwrap().rolls.len(), 8);
    assert_eq!(window.session().rolls_proved(), Some((8, 8)));
}

#[test]
fn papers_of_the_set_and_of_the_roll_shown_are_saved() {
    let mut window = open();
    let folder = tempfile::tempdir().unwrap();
    let choice = DrawingChoice::default();
    let kinds = [
        PaperKind::Section(choice),
        PaperKind::Templates(choice),
        PaperKind::PartsList,
        PaperKind::Drawing(choice),
        PaperKind::SetupSheet,
    ];
    for (number, kind) in kinds.into_iter().enumerate() {
        let path = folder.path().join(format!("{number}.pdf"));
        let ctx = window.harness.ctx.clone();
        window.desk().act(&ctx, Action::WritePapers(path.clone(), kind));
        window.until(kind.name(), |_| path.exists());
    }
}

#[test]
fn edits_that_do_not_fit_keep_their_roll_from_the_lathe_and_no_other() {
    let mut window = open();
    window.session().edit("far too deep", None, |document| {
        let Content::RollSet(set) = &mut document.content else { panic!("a set") };
        for edit in &mut set.roll_mut(TOP_2).edits {
            if let EditAction::Chamfer { depth, .. } = &mut edit.action {
                *depth = 500.0;
            }
        }
    });
    window.until_current();
    let session = window.session();
    let said = session.problems().iter().filter(|d| d.message.starts_with("Edit ")).count();
    assert_eq!((said, session.rolls_proved()), (2, Some((7, 8))), "both chamfers are named");
    session.select_roll(TOP_2);
    assert!(matches!(session.verdict(), Verdict::Failed { .. }), "{:?}", session.verdict());
    session.select_roll(TOP_1);
    assert!(matches!(session.verdict(), Verdict::Proved { .. }), "{:?}", session.verdict());
}
