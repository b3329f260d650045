//! What a part costs: its blank, and machine and operator for its time.

use super::input::ProofInput;
use super::report::PartCost;
use crate::geometry::{Contour, Point};
use std::f64::consts::PI;

/// Chords of the blank's outline, mm.
const CHORD_MM: f64 = 0.01;

/// The cost of one part; `None` if the machine's file names no rates. A material without mass or price has a blank of unknown
/// price, which is left out.
pub(super) fn of(input: &ProofInput, seconds: f64) -> Option<PartCost> {
    let rates = input.machine.cost.as_ref()?;
    let blank = input.work.as_ref().and_then(|work| {
        let material = work.material.as_ref()?;
        let kg = volume_mm3(&work.stock) * 1e-6 * material.density_kg_per_dm3?;
        Some(kg * material.price_per_kg?)
    });
    let machining = seconds / 3600.0 * rates.machine_per_hour;
    let part = machining + blank.unwrap_or(0.0);
    Some(PartCost { currency: rates.currency.clone(), setup: rates.setup, blank, machining, part })
}

/// Volume of the body that a closed outline sweeps around the axis, mm³: `V = π · Σ (r₁² + r₁r₂ + r₂²)/3 · (z₁ − z₂)` over its
/// edges, counter-clockwise (cones on the axis; what a hole takes away comes out by itself).
fn volume_mm3(outline: &Contour) -> f64 {
    let points = outline.polyline(CHORD_MM);
    let edges = points.iter().zip(points.iter().cycle().skip(1));
    let cone = |a: &Point, b: &Point| (a.r * a.r + a.r * b.r + b.r * b.r) / 3.0 * (a.z - b.z);
    (PI * edges.map(|(a, b)| cone(a, b)).sum::<f64>()).abs()
}

#[cfg(test)]
mod tests {
    use super::super::tests::{input_of, polygon, with_work, word_lathe, work};
    use super::*;
    use crate::machine::Catalog;
    use std::sync::Arc;

    #[test]
    fn a_tube_has_its_volume() {
        let tube = polygon(&[(0.0, 5.0), (20.0, 5.0), (20.0, 10.0), (0.0, 10.0)]);
        assert!((volume_mm3(&tube) - PI * 75.0 * 20.0).abs() < 1e-6);
    }

    #[test]
    fn time_blank_and_rates_add_up() {
        let mut material = Catalog::shipped().materials.remove(0);
        (material.density_kg_per_dm3, material.price_per_kg) = (Some(8.0), Some(2.0));
        let input = with_work(&[""], crate::proof::Work { material: Some(material), ..work() });
        let input = ProofInput { machine: Arc::new(word_lathe()), ..input };
        let cost = of(&input, 1800.0).unwrap();
        // A bar of radius 10 and 70 mm length.
        let blank = PI * 100.0 * 70.0 * 8e-6 * 2.0;
        assert!((cost.blank.unwrap() - blank).abs() < 1e-9 && (cost.machining - 35.0).abs() < 1e-9, "{cost:?}");
        assert!((cost.part - blank - 35.0).abs() < 1e-9);
        assert!(of(&input_of(&[""]), 1.0).is_none());
    }
}
