//! The operations with their colour and time, and where the time goes.

use crate::app::plots::{time_bar, time_shares};
use crate::app::theme::{self, Colors};
use crate::app::widgets::clock;
use crate::session::Session;
use egui::{Align2, Color32, FontId, Rect, Sense, Stroke, Ui, vec2};

/// Lists the operations of the clamping that is shown.
pub(crate) fn show(ui: &mut Ui, session: &Session) {
    let Some(setup) = session.setup() else { return };
    let colors = Colors::of(ui.visuals());
    let shares = time_shares(setup);
    if shares.is_empty() {
        return;
    }
    ui.label(theme::strong("Operations"));
    ui.scope(|ui| {
        ui.spacing_mut().item_spacing.y = 0.0;
        for share in &shares {
            row(ui, colors, share.name(), colors.plot.operation(share.operation), share.time_s);
        }
    });
    ui.add_space(10.0);
    time_bar(ui, &shares, &colors.plot);
    let times = setup.proof.times;
    ui.horizontal(|ui| {
        ui.label(theme::quiet(format!("cutting {}", clock(times.feed_s)), colors));
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
            ui.label(theme::quiet(format!("rapid {}", clock(times.rapid_s)), colors));
        });
    });
}

fn row(ui: &mut Ui, colors: &Colors, name: &str, color: Color32, time_s: f64) {
    let (rect, response) = ui.allocate_exact_size(vec2(ui.available_width(), 25.0), Sense::hover());
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
