//! Limits of what a material may be.

use super::{Check, FEED, Fault};
use crate::machine::{Material, OperationData, OracData};
use crate::units::Unit;
use std::collections::BTreeSet;
use std::ops::RangeInclusive;

/// The finest step that a slide can make is near this, in either unit.
const DEPTH: RangeInclusive<f64> = 0.0001..=100.0;
/// Cutting speeds, m/min.
const SPEED_M_PER_MIN: RangeInclusive<f64> = 0.1..=5000.0;
/// Feeds per turn, mm.
const FEED_PER_REV_MM: RangeInclusive<f64> = 0.001..=20.0;
/// Specific cutting forces: plastics have some tens, the hardest alloys some thousands of N/mm².
const SPECIFIC_FORCE: RangeInclusive<f64> = 10.0..=10_000.0;

/// Everything that cannot be right in a material.
pub(in crate::machine) fn material(material: &Material) -> Vec<Fault> {
    let mut check = Check::default();
    check.text("name", &material.name);
    if let Some(row) = &material.orac {
        orac(&mut check, row, material.unit);
    }
    if let Some(force) = material.specific_cutting_force_n_per_mm2 {
        check.range("specific_cutting_force_n_per_mm2", force, SPECIFIC_FORCE, "N/mm²");
    }
    if let Some(mc) = material.mc {
        check.range("mc", mc, 0.0..=0.9, "");
        if material.specific_cutting_force_n_per_mm2.is_none() {
            let message = format!("The exponent is {mc}, and specific_cutting_force_n_per_mm2 is missing beside it.");
            check.fault("mc", message);
        }
    }
    if let Some(density) = material.density_kg_per_dm3 {
        check.range("density_kg_per_dm3", density, 0.1..=25.0, "kg/dm³");
    }
    if let Some(price) = material.price_per_kg {
        check.range("price_per_kg", price, 0.0..=1e6, "per kg");
    }
    if material.orac.is_none() && material.operations.is_empty() && material.like.is_none() {
        let message = "There are no cutting data: neither `operations` nor `like` nor `orac`; give at least one.";
        check.fault("name", message.to_owned());
    }
    operations(&mut check, &material.operations);
    check.0
}

fn orac(check: &mut Check, row: &OracData, unit: Unit) {
    let unit = unit.symbol();
    for (path, feed) in [
        ("orac.feed_travel", row.feed_travel),
        ("orac.feed_cut", row.feed_cut),
        ("orac.feed_part_off", row.feed_part_off),
    ] {
        check.range(path, feed, FEED, &format!("{unit}/min"));
    }
    for (path, depth) in [
        ("orac.depth_rough", row.depth_rough),
        ("orac.depth_finish", row.depth_finish),
        ("orac.depth_thread", row.depth_thread),
    ] {
        check.range(path, depth, DEPTH, unit);
    }
}

fn operations(check: &mut Check, rows: &[OperationData]) {
    let mut seen = BTreeSet::new();
    for (i, row) in rows.iter().enumerate() {
        let at = |key: &str| format!("operations.{i}.{key}");
        check.range(&at("speed_m_per_min"), row.speed_m_per_min, SPEED_M_PER_MIN, "m/min");
        check.range(&at("feed_mm_per_rev"), row.feed_mm_per_rev, FEED_PER_REV_MM, "mm");
        check.range(&at("depth_mm"), row.depth_mm, 0.0..=*DEPTH.end(), "mm");
        if !seen.insert((row.operation, row.tool)) {
            let message = "This operation with this tool material is there twice; it must be there once.".to_owned();
            check.fault(&at("operation"), message);
        }
    }
}
