//! The operations with their colour and time.

use crate::app::theme::{self, Colors};
use crate::app::widgets::clock;
use crate::regen::SetupDerived;
use crate::session::Session;
use crate::turning::OperationKind;
use egui::{Align2, FontId, Rect, Sense, Stroke, Ui, vec2};
use std::collections::BTreeMap;

/// Name of an operation for people.
#[must_use]
pub(crate) const fn name(kind: OperationKind) -> &'static str {
    match kind {
        OperationKind::RoughRight => "Rough, right-hand",
        OperationKind::FinishRight => "Finish, right-hand",
        OperationKind::RoughLeft => "Rough, left-hand",
        OperationKind::FinishLeft => "Finish, left-hand",
        OperationKind::Thread => "Thread",
        OperationKind::PartOff => "Part off",
    }
}

/// Lists the operations of the clamping that is shown.
pub(crate) fn show(ui: &mut Ui, session: &Session) {
    let Some(setup) = session.setup() else { return };
    let colors = Colors::of(ui.visuals());
    ui.label(theme::strong("Operations"));
    ui.spacing_mut().item_spacing.y = 0.0;
    let times = times(setup);
    for operation in setup.path.operations.iter().filter(|o| !o.moves.is_empty()) {
        let kind = operation.kind;
        row(ui, colors, name(kind), colors.plot.operation(Some(kind)), times.get(&Some(kind)).copied().unwrap_or(0.0));
    }
    if let Some(rest) = times.get(&None).copied().filter(|t| *t >= 1.0) {
        row(ui, colors, "Start, tool changes, end", colors.plot.operation(None), rest);
    }
}

/// Time of each operation, s; the proof's times by block, summed by what the post says the block is for.
fn times(setup: &SetupDerived) -> BTreeMap<Option<OperationKind>, f64> {
    let mut times = BTreeMap::new();
    for block in &setup.proof.blocks {
        let program = setup.post.programs.iter().find(|p| p.name == block.program);
        let info = program.and_then(|p| p.blocks.get(block.block.saturating_sub(1)));
        *times.entry(info.and_then(|i| i.operation)).or_insert(0.0) += block.time_s;
    }
    times
}

fn row(ui: &mut Ui, colors: &Colors, name: &str, color: egui::Color32, time_s: f64) {
    let (rect, response) = ui.allocate_exact_size(vec2(ui.available_width(), 26.0), Sense::hover());
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Label, true, format!("{name} {}", clock(time_s))));
    let painter = ui.painter();
    let square = Rect::from_center_size(egui::pos2(rect.left() + 8.0, rect.center().y), vec2(9.0, 9.0));
    painter.rect_filled(square, 2.0, color);
    let font = FontId::proportional(theme::TEXT);
    let text = egui::pos2(rect.left() + 22.0, rect.center().y);
    painter.text(text, Align2::LEFT_CENTER, name, font.clone(), colors.plot.text);
    painter.text(rect.right_center() - vec2(6.0, 0.0), Align2::RIGHT_CENTER, clock(time_s), font, colors.plot.quiet);
    painter.hline(rect.x_range(), rect.bottom(), Stroke::new(1.0, colors.line.gamma_multiply(0.7)));
}
