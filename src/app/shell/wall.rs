//! Wall thickness and reduction along the shell.

use super::chart::{chart, limit, line};
use crate::app::plots::Palette;
use crate::app::widgets::title_row;
use crate::session::Session;
use crate::spinning::material::{LARGEST_REDUCTION, material};
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
    let Some(made) = made else { return dragged };
    let palette = Palette::of(ui.visuals());
    let size = vec2((ui.available_width() - 10.0) / 2.0, ui.available_height());
    let of = |value: fn(&crate::spinning::Station) -> f64| {
        made.shape.stations.iter().map(|s| [s.along, value(s)]).collect::<Vec<_>>()
    };
    let most = material(&made.shell.material).map_or(LARGEST_REDUCTION, |m| m.max_reduction);
    ui.horizontal(|ui| {
        chart(ui, "wall", ("along the wall from the tip, mm", "wall, mm"), size, |plot| {
            line(plot, "wall", of(|s| s.wall), palette.accent, 1.8);
            line(
                plot,
                "blank",
                of(|_| 0.0).into_iter().map(|[x, _]| [x, made.shape.thickness]).collect(),
                palette.construction,
                1.0,
            );
        });
        chart(ui, "reduction", ("along the wall from the tip, mm", "reduction, %"), size, |plot| {
            line(plot, "reduction", of(|s| 100.0 * s.reduction), palette.accent, 1.8);
            limit(plot, "limit of the material", 100.0 * most, &palette);
        });
    });
    dragged
}
