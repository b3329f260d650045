//! What the strip is: thickness, origin, material, developed width.

use super::fields::{Field, Form};
use super::words;
use crate::app::plots::fixed;
use crate::app::theme::{self, Colors};
use crate::document::{DevelopedWidth, Origin, RollSet};
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

/// Shows the fields.
pub(super) fn show(ui: &mut Ui, set: &RollSet, unit: Unit, session: &mut Session) {
    let form = Form::two_columns(ui);
    let colors = Colors::of(ui.visuals());
    let width = developed(&set.section, set.section.developed_width).width;
    ui.horizontal(|ui| {
        ui.label(theme::strong("Strip"));
        let told = format!("developed width {} {}", fixed(width, unit.decimals()), unit.symbol());
        ui.label(theme::quiet(told, colors));
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
        match set.section.developed_width {
            DevelopedWidth::Own { k } => form.figure(ui, session, Field::of("k"), k, |s, k| {
                s.section.developed_width = DevelopedWidth::Own { k };
            }),
            _ => form.angle(ui, session, Field::of("First slope"), set.section.first_angle_deg, |s, deg| {
                s.section.first_angle_deg = deg;
            }),
        }
    });
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

/// True if both are the same method, whatever k.
fn same_method(a: DevelopedWidth, b: DevelopedWidth) -> bool {
    std::mem::discriminant(&a) == std::mem::discriminant(&b)
}
