//! Properties of the section at every stage.

use super::line;
use crate::app::plots::fixed;
use crate::document::RollSet;
use crate::geometry::Point;
use crate::rollform::bends::Stage;
use crate::rollform::flower::Flower;
use crate::rollform::properties::SectionProperties;
use egui::Ui;

/// Width of the names, points.
const NAME: f32 = 150.0;
/// Width of a figure, points.
const FIGURE: f32 = 84.0;

/// A property: what it is called, and how it is written.
type Row = (&'static str, fn(&SectionProperties, f64) -> String);

const ROWS: [Row; 11] = [
    ("Area, mm²", |p, _| format!("{:.2}", p.area)),
    ("Mass, kg/m", |p, density| format!("{:.3}", p.mass_kg_per_m(density))),
    ("Centroid x, y, mm", |p, _| point(p.centroid)),
    ("Ix, mm⁴", |p, _| figure(p.ix)),
    ("Iy, mm⁴", |p, _| figure(p.iy)),
    ("Ixy, mm⁴", |p, _| figure(p.ixy)),
    ("I1, I2, mm⁴", |p, _| format!("{}, {}", figure(p.i1), figure(p.i2))),
    ("Angle of axis 1", |p, _| format!("{:.2}°", p.principal_angle_rad.to_degrees())),
    ("Torsion J, mm⁴", |p, _| figure(p.torsion)),
    ("Warping Cw, mm⁶", |p, _| figure(p.warping)),
    ("Shear centre x, y, mm", |p, _| point(p.shear_centre)),
];

/// Shows the table.
pub(super) fn show(ui: &mut Ui, flower: &Flower, set: &RollSet) {
    let shapes: Vec<(String, &SectionProperties)> =
        flower.shapes.iter().rev().filter_map(|shape| Some((name(shape.stage), shape.properties.as_ref()?))).collect();
    let widths: Vec<f32> = std::iter::once(NAME).chain(shapes.iter().map(|_| FIGURE + 26.0)).collect();
    egui::ScrollArea::both().id_salt("properties").auto_shrink([false, false]).show(ui, |ui| {
        ui.spacing_mut().item_spacing.y = 0.0;
        let head: Vec<String> =
            std::iter::once(String::new()).chain(shapes.iter().map(|(name, _)| name.clone())).collect();
        line(ui, &head, &widths, false, true);
        for (name, write) in ROWS {
            let values = shapes.iter().map(|(_, properties)| write(properties, set.strip.density_g_per_cm3));
            let cells: Vec<String> = std::iter::once(name.to_owned()).chain(values).collect();
            line(ui, &cells, &widths, false, false);
        }
    });
}

fn name(stage: Stage) -> String {
    match stage {
        Stage::Flat => "flat".to_owned(),
        Stage::Station(index) => format!("station {}", index + 1),
        Stage::Finished => "final".to_owned(),
    }
}

fn point(p: Point) -> String {
    format!("{}, {}", fixed(p.z, 2), fixed(p.r, 2))
}

/// A figure with five digits that matter.
fn figure(value: f64) -> String {
    match value.abs() {
        v if v < 1e-6 => "0".to_owned(),
        v if v < 1000.0 => format!("{value:.2}"),
        v if v < 1e6 => format!("{value:.0}"),
        _ => format!("{value:.4e}"),
    }
}
