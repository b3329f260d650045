//! Wall thickness and reduction along the shell.

use super::chart::{chart, limit, line};
use crate::app::plots::Palette;
use crate::app::widgets::title_row;
use crate::session::Session;
use crate::spinning::material::{LARGEST_REDUCTION, material};
use crate::units::Unit;
use egui::{Ui, vec2};

/// Shows the panel; true if it is dragged by its title.
pub(super) fn show(ui: &mut Ui, titled: bool, session: &Session) -> bool {
    let made = session.derived().and_then(|d| d.shell.clone());
    let remark = made.as_ref().map_or_else(String::new, |made| {
        let material = &made.shell.material;
        let limit = crate::spinning::material::material(material).map_or(LARGEST_REDUCTION, |m| m.max_reduction);
        format!("{material} bears {:.0} % (guide value)", limit * 100.0)
    });
    let dragged = title_row(ui, titled.then_some("Wall"), &remark, |_| {});
    let Some(made) = made else {
        super::view::nothing_to_draw(ui, session);
        return dragged;
    };
    let palette = Palette::of(ui.visuals());
    let size = vec2((ui.available_width() - 10.0) / 2.0, ui.available_height());
    let (mm, (along, thick)) = match session.document().unit {
        unit @ Unit::Mm => (unit.in_mm(), ("along the wall from the tip, mm", "wall, mm")),
        unit @ Unit::Inch => (unit.in_mm(), ("along the wall from the tip, in", "wall, in")),
    };
    let of = |value: &dyn Fn(&crate::spinning::Station) -> f64| {
        made.shape.stations.iter().map(|s| [s.along / mm, value(s)]).collect::<Vec<_>>()
    };
    let most = material(&made.shell.material).map_or(LARGEST_REDUCTION, |m| m.max_reduction);
    ui.horizontal(|ui| {
        chart(ui, "wall", (along, thick), size, |plot| {
            line(plot, "wall", of(&|s| s.wall / mm), palette.accent, 1.8);
            line(plot, "blank", of(&|_| made.shape.thickness / mm), palette.construction, 1.0);
        });
        chart(ui, "reduction", (along, "reduction, %"), size, |plot| {
            line(plot, "reduction", of(&|s| 100.0 * s.reduction), palette.accent, 1.8);
            limit(plot, "limit of the material", 100.0 * most, &palette);
        });
    });
    dragged
}
