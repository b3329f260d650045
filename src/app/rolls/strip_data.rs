//! What the strip is: thickness, origin, material, developed width.

use super::fields::{Field, Form};
use super::words;
use crate::app::plots::fixed;
use crate::app::theme::{self, Colors};
use crate::app::widgets::toggle;
use crate::document::{DevelopedWidth, Opening, Origin, RollSet, Sharpening};
use crate::rollform::developed::developed;
use crate::session::Session;
use crate::units::Unit;
use egui::Ui;

const ORIGINS: [Origin; 5] =
    [Origin::Symmetrical, Origin::LeftToRight, Origin::RightToLeft, Origin::CentreRightFirst, Origin::CentreLeftFirst];

/// Distance of the neutral line from the inside in a new method with a k of one's own.
const USUAL_K: f64 = 0.4;

const METHODS: [DevelopedWidth; 7] = [
    DevelopedWidth::MeanLine,
    DevelopedWidth::RolfomTable,
    DevelopedWidth::Din6935,
    DevelopedWidth::Asm,
    DevelopedWidth::AsmLessFormable,
    DevelopedWidth::Angel,
    DevelopedWidth::Own { k: USUAL_K },
];

/// Room that the fields take, points.
pub(super) const fn height(with_material: bool, method: DevelopedWidth) -> f32 {
    let own = if matches!(method, DevelopedWidth::Own { .. }) { 31.0 } else { 0.0 };
    own + if with_material { 198.0 } else { 136.0 }
}

/// Shows the fields.
pub(super) fn show(ui: &mut Ui, set: &RollSet, unit: Unit, session: &mut Session, with_material: &mut bool) {
    let form = Form::two_columns(ui);
    let colors = Colors::of(ui.visuals());
    let width = developed(&set.section, set.section.developed_width).width;
    ui.horizontal(|ui| {
        ui.label(theme::strong("Strip"));
        let told = format!("developed width {} {}", fixed(width, unit.decimals()), unit.symbol());
        ui.label(theme::quiet(told, colors));
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
            toggle(ui, with_material, "material").on_hover_text("Strength, stiffness and density of the strip");
        });
    });
    Form::row(ui, |ui| {
        form.length(ui, session, Field::of("Thickness"), set.section.thickness, unit, |s, v| s.section.thickness = v);
        let methods =
            METHODS.map(|m| if same_method(m, set.section.developed_width) { set.section.developed_width } else { m });
        let all = methods.map(|m| (m, words::width_method(m).to_owned()));
        form.choice(ui, session, Field::of("Width by"), &set.section.developed_width, &all, |s, m| {
            s.section.developed_width = m;
        });
    });
    Form::row(ui, |ui| {
        let all = ORIGINS.map(|o| (o, words::origin(o).to_owned()));
        form.choice(ui, session, Field::of("Origin"), &set.section.origin, &all, |s, origin| s.section.origin = origin);
        form.angle(ui, session, Field::of("First slope"), set.section.first_angle_deg, |s, deg| {
            s.section.first_angle_deg = deg;
        });
    });
    if let DevelopedWidth::Own { k } = set.section.developed_width {
        Form::row(ui, |ui| {
            form.figure(ui, session, Field::of("k"), k, |s, k| s.section.developed_width = DevelopedWidth::Own { k });
        });
    }
    Form::row(ui, |ui| {
        let all = OPENINGS.map(|o| (o, words::opening(o).to_owned()));
        form.choice(ui, session, Field::of("Bends open"), &set.opening, &all, |s, opening| s.opening = opening);
        let sharpenings = sharpenings(set, session.selection.station);
        form.choice(ui, session, Field::of("Sharpened"), &set.sharpening, &sharpenings, |s, at| s.sharpening = at);
    });
    if *with_material {
        material(ui, set, form, session);
    }
}

/// What the strip is made of.
fn material(ui: &mut Ui, set: &RollSet, form: Form, session: &mut Session) {
    Form::row(ui, |ui| {
        let strip = &set.strip;
        form.figure(ui, session, Field::of("Yield MPa"), strip.yield_strength_mpa, |s, v| {
            s.strip.yield_strength_mpa = v;
        });
        form.figure(ui, session, Field::of("E GPa"), strip.youngs_modulus_gpa, |s, v| s.strip.youngs_modulus_gpa = v);
    });
    Form::row(ui, |ui| {
        let strip = &set.strip;
        form.figure(ui, session, Field::of("g/cm³"), strip.density_g_per_cm3, |s, v| s.strip.density_g_per_cm3 = v);
        form.figure(ui, session, Field::of("Least r/t"), strip.least_radius_per_thickness, |s, v| {
            s.strip.least_radius_per_thickness = v;
        });
    });
}

const OPENINGS: [Opening; 3] = [Opening::MeanLine, Opening::InsideRadius, Opening::ConstantRadius];

/// Nowhere, everywhere but at last, and the stations listed now with and without the one that is shown.
fn sharpenings(set: &RollSet, shown: Option<u32>) -> Vec<(Sharpening, String)> {
    let listed = if let Sharpening::Stations(ids) = &set.sharpening { ids.clone() } else { Vec::new() };
    let mut toggled = listed.clone();
    match shown {
        Some(id) if listed.contains(&id) => toggled.retain(|other| *other != id),
        Some(id) => toggled.push(id),
        None => {}
    }
    let stations = |ids: Vec<u32>| {
        let numbers = (1_usize..).zip(&set.stations).filter(|(_, s)| ids.contains(&s.id)).map(|(n, _)| n.to_string());
        let text = format!("stn {}", numbers.collect::<Vec<_>>().join(", "));
        (Sharpening::Stations(ids), text)
    };
    let mut all = vec![(Sharpening::None, "nowhere".to_owned()), (Sharpening::AllButLast, "all but last".to_owned())];
    if !listed.is_empty() {
        all.push(stations(listed.clone()));
    }
    if !toggled.is_empty() && toggled != listed {
        all.push(stations(toggled));
    }
    all
}

/// True if both are the same method, whatever k.
fn same_method(a: DevelopedWidth, b: DevelopedWidth) -> bool {
    std::mem::discriminant(&a) == std::mem::discriminant(&b)
}
