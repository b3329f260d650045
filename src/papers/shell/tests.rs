use super::*;
use crate::cancel::Cancel;
use crate::machine::Catalog;
use crate::papers::{DrawingChoice, Item, Page, Paper, PaperKind};
use crate::regen::{Cache, regenerate};
use crate::storage::{document_from_text, examples_of};
use std::sync::Arc;

fn texts(pages: &[Page]) -> Vec<&str> {
    let items = pages.iter().flat_map(|page| &page.items);
    items.filter_map(|i| if let Item::Text { text, .. } = i { Some(text.as_str()) } else { None }).collect()
}

fn made(change: impl Fn(&mut Document)) -> Vec<Derived> {
    let catalog = Catalog::shipped();
    let make = |text: &str| {
        let mut document = document_from_text("shell.turn", text).unwrap();
        change(&mut document);
        regenerate(&Arc::new(document), &catalog, &mut Cache::default(), &Cancel::default()).unwrap()
    };
    examples_of(crate::document::Kind::Shell).map(|example| make(example.text)).collect()
}

fn pages(derived: &Derived, kind: PaperKind) -> Vec<Page> {
    kind.pages(derived, &Catalog::shipped()).unwrap()
}

/// Items that stick out of the frame of their page.
fn outside(page: &Page, margin: f64) -> Vec<&Item> {
    let within = |p: crate::geometry::Point| {
        (margin..=page.width_mm - margin).contains(&p.z) && (4.9..=page.height_mm - margin).contains(&p.r)
    };
    let inside = |item: &&Item| match item {
        Item::Path { path, .. } => path.bounds().is_none_or(|b| within(b.min) && within(b.max)),
        Item::Text { at, .. } => within(*at),
    };
    page.items.iter().filter(|item| !inside(item)).collect()
}

#[test]
fn every_shell_has_a_drawing_with_its_sizes_and_its_wall() {
    for derived in made(|_| ()) {
        let shell = derived.shell.clone().unwrap();
        let drawn = pages(&derived, PaperKind::Drawing(DrawingChoice::default()));
        let [page] = drawn.as_slice() else { panic!("one sheet") };
        let said = texts(&drawn);
        let tip = format!("Ø {}", number(2.0 * shell.shape.tip().r, Unit::Mm));
        let base = format!("Ø {}", number(2.0 * shell.shape.base().r, Unit::Mm));
        let thinnest = crate::papers::number::fixed(shell.shape.thinnest().unwrap().wall, Unit::Mm);
        for wanted in [derived.document.name.as_str(), &tip, &base, &thinnest, "Wall along the shell", "9"] {
            assert!(said.contains(&wanted), "{}: {wanted} in {said:?}", derived.document.name);
        }
        assert_eq!(outside(page, 9.0), Vec::<&Item>::new(), "{}", derived.document.name);
        // The outline on paper, measured with the page's own view, is the shell's.
        let view = page.part.unwrap();
        let corner = view.place(shell.shape.base());
        let near = |item: &Item| matches!(item, Item::Path { path, .. } if path.distance_to(corner) < 1e-6);
        assert!(page.items.iter().any(near));
    }
}

#[test]
fn figures_of_a_column_of_the_wall_table_stand_below_one_another() {
    for derived in made(|_| ()) {
        let walls = walls::walls(&Subject::of(&derived).unwrap());
        let decimals = |cell: &String| cell.trim_end_matches(['°', '%', ' ']).split_once('.').map(|(_, d)| d.len());
        for column in 0..5 {
            let all: Vec<_> = walls.iter().map(|wall| decimals(&wall.cells[column])).collect();
            assert!(all[0].is_some() && all.iter().all(|d| *d == all[0]), "{column}: {all:?}");
        }
    }
}

#[test]
fn a_machine_without_surface_speed_is_said_to_turn_at_one_speed() {
    let slow = made(|document| {
        let Content::Shell(shell) = &mut document.content else { unreachable!("a shell") };
        shell.machine = "swedish-1970s".to_owned();
    });
    let said = texts(&pages(&slow[0], PaperKind::SetupSheet)).join("\n");
    // 350 m/min at a base of 97.7 mm would be 1140 1/min; the spindle's next lower step is 1000.
    assert!(said.contains("1000 1/min all along, 307 m/min at the base"), "{said}");
}

#[test]
fn paper_and_scale_can_be_chosen_and_too_large_a_scale_is_refused_with_the_largest() {
    let cone = &made(|_| ())[0];
    let on = |paper, scale| DrawingChoice { paper: Some(paper), scale };
    let kind = |choice| PaperKind::Drawing(choice);
    let large = pages(cone, kind(on(Paper::A2, Some(2.0))));
    assert_eq!((large[0].height_mm, large[0].part.unwrap().scale), (420.0, 2.0));
    let fault = kind(on(Paper::A4, Some(10.0))).pages(cone, &Catalog::shipped()).unwrap_err();
    assert!(fault.code == "drawing-scale" && fault.message.contains("at most"), "{fault}");
}

#[test]
fn the_sheet_holds_former_blank_roller_speeds_and_programs() {
    for derived in made(|_| ()) {
        let shell = derived.shell.clone().unwrap();
        let sheet = pages(&derived, PaperKind::SetupSheet);
        let said = texts(&sheet).join("\n");
        for wanted in
            ["Proved", "nose R", "disc Ø", "tip Ø", "m/min", "1/min at most", "/rev", "set points", "Wall along"]
        {
            assert!(
                said.to_lowercase().contains(&wanted.to_lowercase()),
                "{}: {wanted} in {said}",
                derived.document.name
            );
        }
        let program = &shell.post.programs[0];
        assert!(said.contains(&format!("{}.{}", program.name, program.extension)));
        assert!(said.contains(&format!("{} blocks", program.blocks.len())));
        for page in &sheet {
            assert_eq!((page.width_mm, page.height_mm), Paper::A4.sides_mm());
            assert_eq!(outside(page, 10.0), Vec::<&Item>::new(), "{}", derived.document.name);
        }
    }
}

#[test]
fn a_shell_that_is_none_has_no_papers_and_one_that_fails_says_so() {
    let figures = |thickness: f64, angle: f64| {
        move |document: &mut Document| {
            let Content::Shell(shell) = &mut document.content else { unreachable!("a shell") };
            shell.blank.thickness = thickness;
            if let FormerShape::Cone { half_angle_deg, .. } = &mut shell.former.shape {
                *half_angle_deg = angle;
            }
        }
    };
    for kind in [PaperKind::SetupSheet, PaperKind::Drawing(DrawingChoice::default())] {
        let fault = kind.pages(&made(figures(-1.0, 30.0))[0], &Catalog::shipped()).unwrap_err();
        assert!(fault.code == "nothing-to-draw" && fault.message.contains("shell"), "{fault}");
    }
    let steep = &made(figures(1.6, 7.0))[0];
    let said = texts(&pages(steep, PaperKind::SetupSheet)).join("\n");
    assert!(said.contains("NOT PROVED") && said.contains("None:"), "{said}");
}
