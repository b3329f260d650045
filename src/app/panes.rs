//! From a panel's name to what it shows.

use super::desk::{Requests, Views};
use super::layout::Pane;
use super::plots::{self, CutEvent, CutScene, Dimension, End, Palette, Phase, ProfileEvent, ProfileScene, SolidScene};
use super::sections::{self, cells};
use super::transfer::{self, TransferPanel};
use super::widgets::{link, title_row, toggle};
use super::{inspector, operations, problems, program, rolls, shell};
use crate::diagnostic::Column;
use crate::proof::BlockRef;
use crate::session::{Hovered, Session};
use egui::Ui;

/// Shows `pane`; true if it is dragged by its title.
pub(crate) fn show(
    ui: &mut Ui,
    pane: Pane,
    titled: bool,
    session: &mut Session,
    views: &mut Views,
    transfer: &mut TransferPanel,
    requests: &mut Requests,
) -> bool {
    match pane {
        Pane::Sections => sections::show(ui, &mut views.sections, session, requests, titled),
        Pane::Operations => operations::show(ui, &mut views.operations, session, requests, titled),
        Pane::Profile => profile(ui, titled, session, views, requests),
        Pane::Cut => cut(ui, titled, session, views, requests),
        Pane::Program => program::show(ui, &mut views.program, session, requests, titled),
        Pane::Problems => problems::show(ui, &mut views.problems, session, requests, titled),
        Pane::Solid if session.document().content.roll_set().is_none() => solid(ui, titled, session, views),
        Pane::Inspector => inspector::show(ui, &mut views.operations, session, requests, titled),
        Pane::Transfer => transfer::show(ui, transfer, session, requests, titled),
        Pane::Elements
        | Pane::Angles
        | Pane::Flower
        | Pane::CrossSection
        | Pane::Station
        | Pane::Solid
        | Pane::StationData
        | Pane::RollEditor
        | Pane::RollList
        | Pane::Charts => rolls::show(ui, pane, titled, session, &mut views.rolls, requests),
        Pane::ShellData | Pane::ShellView | Pane::Wall | Pane::Operator | Pane::Rig | Pane::Runs => {
            shell::show(ui, pane, titled, session, &mut views.shell, requests)
        }
    }
}

fn profile(ui: &mut Ui, titled: bool, session: &mut Session, views: &mut Views, requests: &mut Requests) -> bool {
    let unit = session.document().unit;
    let remark = views.operations.asks().unwrap_or_else(|| unit.symbol().to_owned());
    let dragged = title_row(ui, titled.then_some("Profile"), &remark, |ui| {
        if link(ui, "fit").clicked() {
            views.profile.canvas.fit();
        }
        toggle(ui, &mut views.profile.dimensions, "dimensions");
        toggle(ui, &mut views.profile.full_section, "full section");
        setup_choice(ui, session);
    });
    if ui.input(|i| i.key_pressed(egui::Key::Escape)) {
        views.operations.stop_picking();
    }
    let Some(setup) = session.setup() else { return dragged };
    let palette = Palette::of(ui.visuals());
    let lit: Vec<u32> = session.lit().sections.iter().copied().chain(views.operations.picked()).collect();
    let scene = ProfileScene {
        derived: setup,
        part: session.part(),
        unit,
        machine: session.derived().and_then(|d| d.machine.as_deref()),
        selected: session.selection.section,
        lit: &lit,
        palette: &palette,
    };
    ui.set_opacity(if session.is_current() { 1.0 } else { STALE });
    for event in plots::profile_plot(ui, &mut views.profile, &scene) {
        profile_event(event, session, views, requests);
    }
    dragged
}

/// Opacity of what belongs to an older document. Hardly dimmed, so that a drag does not flicker.
const STALE: f32 = 0.85;

fn solid(ui: &mut Ui, titled: bool, session: &Session, views: &mut Views) -> bool {
    let dragged = title_row(ui, titled.then_some("3D"), "", |_| {});
    let Some(setup) = session.setup() else { return dragged };
    let palette = Palette::of(ui.visuals());
    let stock_at_s = views.cut.stock.then_some(views.cut.time_s).filter(|_| views.cut.playing);
    plots::solid_view(ui, &mut views.solid, &SolidScene { derived: setup, stock_at_s, palette: &palette });
    dragged
}

fn setup_choice(ui: &mut Ui, session: &mut Session) {
    let count = session.derived().map_or(0, |d| d.setups.len());
    if count < 2 {
        return;
    }
    for index in (0..count).rev() {
        let name = if index == 0 { "first end" } else { "second end" };
        let mut on = session.selection.setup == index;
        if toggle(ui, &mut on, name).clicked() {
            session.selection.setup = index;
            session.selection.program = 0;
        }
    }
}

fn profile_event(event: ProfileEvent, session: &mut Session, views: &mut Views, requests: &mut Requests) {
    match event {
        ProfileEvent::HoverSection(id) => requests.hovered = requests.hovered.or(Some(Hovered::Section(id))),
        ProfileEvent::SelectSection(section) => {
            if !views.operations.take_click(session, section) {
                session.selection.section = Some(section);
            }
        }
        ProfileEvent::Pointer(pointer) => requests.pointer = requests.pointer.or(pointer),
        ProfileEvent::DragNode { node, phase } => {
            let gesture = gesture(session, views, phase);
            let row = node.ends.first().map_or(0, |end| end.section);
            session.selection.section = Some(row);
            let label = format!("drag {}", name_of(session, row));
            session.edit_part(&label, gesture, |part| node.apply(part));
        }
        ProfileEvent::DragRadius { section, radius, phase } => {
            let gesture = gesture(session, views, phase);
            session.selection.section = Some(section);
            let label = format!("drag radius of {}", name_of(session, section));
            session.edit_part(&label, gesture, |part| {
                if let Some(row) = part.row_mut(section) {
                    use crate::part::SectionKind::{Concave, Convex};
                    if let Concave { radius: r } | Convex { radius: r } = &mut row.kind {
                        *r = radius;
                    }
                }
            });
        }
        ProfileEvent::EditDimension { dimension, text } => edit_dimension(dimension, &text, session, requests),
    }
}

fn gesture(session: &mut Session, views: &mut Views, phase: Phase) -> Option<crate::session::GestureId> {
    match phase {
        Phase::Begin => views.drag = Some(session.new_gesture()),
        Phase::Single => return None,
        Phase::Move | Phase::End => {}
    }
    let gesture = views.drag;
    if phase == Phase::End {
        views.drag = None;
    }
    gesture
}

fn name_of(session: &Session, id: u32) -> String {
    session.part().row(id).map(|(table, row, section)| cells::row_name(table, row, section)).unwrap_or_default()
}

fn edit_dimension(dimension: Dimension, text: &str, session: &mut Session, requests: &mut Requests) {
    let unit = session.document().unit;
    let value = match crate::units::parse_length(text, unit) {
        Ok(value) => value,
        Err(reason) => return requests.complain(reason),
    };
    match dimension {
        Dimension::PartLength => session.edit_part("part length", None, |part| part.length = value),
        Dimension::BarDiameter => session.edit_part("bar diameter", None, |part| part.bar_diameter = value),
        Dimension::SectionLength { section } => edit_row(session, section, "length", |row| row.z2 = row.z1 + value),
        Dimension::Diameter(end) => {
            edit_row(session, end.section, "diameter", |row| match end.end {
                End::Start => row.d1 = value,
                End::Finish if matches!(row.kind, crate::part::SectionKind::Thread { .. }) => row.d1 = value,
                End::Finish => row.d2 = value,
            });
        }
        Dimension::Radius { section } => {
            edit_row(session, section, "radius", |row| {
                let _ = cells::set(row, Column::Radius, text, unit);
            });
        }
    }
}

fn edit_row(session: &mut Session, id: u32, what: &str, change: impl FnOnce(&mut crate::part::Section)) {
    let label = format!("{what} of {}", name_of(session, id));
    session.edit_part(&label, None, |part| {
        if let Some(row) = part.row_mut(id) {
            change(row);
        }
    });
}

fn cut(ui: &mut Ui, titled: bool, session: &mut Session, views: &mut Views, requests: &mut Requests) -> bool {
    let remark = session.setup().map(|s| views.cut.status(s)).unwrap_or_default();
    let dragged = title_row(ui, titled.then_some("Cut"), &remark, |ui| {
        if link(ui, "fit").clicked() {
            views.cut.canvas.fit();
        }
        toggle(ui, &mut views.cut.leftover, "leftover");
        toggle(ui, &mut views.cut.stock, "stock left");
    });
    let Some(setup) = session.setup() else { return dragged };
    let palette = Palette::of(ui.visuals());
    let program = session.selection.program;
    let scene = CutScene {
        derived: setup,
        unit: session.document().unit,
        machine: session.derived().and_then(|d| d.machine.as_deref()),
        form_tolerance_mm: session.part().form_tolerance * session.document().unit.in_mm(),
        selected: session.selection.block.map(|block| BlockRef { program, block }),
        lit_blocks: &session.lit().blocks,
        lit_sections: &session.lit().sections,
        palette: &palette,
    };
    ui.set_opacity(if session.is_current() { 1.0 } else { STALE });
    for event in plots::cut_plot(ui, &mut views.cut, &scene) {
        match event {
            CutEvent::SelectBlock(at) => {
                session.selection.program = at.program;
                session.selection.block = Some(at.block);
            }
            CutEvent::Pointer(pointer) => requests.pointer = requests.pointer.or(pointer),
            CutEvent::HoverBlock(block) => requests.hovered = requests.hovered.or(Some(Hovered::Block(block))),
            CutEvent::Scrub(_) => {}
        }
    }
    follow_slider(session, views);
    dragged
}

/// The block at the slider is the selected one, whoever moved the slider.
fn follow_slider(session: &mut Session, views: &mut Views) {
    let at_slider = session.setup().and_then(|setup| views.cut.block(setup));
    if at_slider != views.block_at_slider {
        views.block_at_slider = at_slider;
        if let Some(at) = at_slider {
            session.selection.program = at.program;
            session.selection.block = Some(at.block);
        }
    }
}
