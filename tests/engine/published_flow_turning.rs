//! The published flow-turning controller against its cleaned tables: every step value for every allowed entry.
//!
//! `cargo test --test engine published_flow_turning:: -- --nocapture` prints how many were compared, equal and wrapped.

use serde_json::Value;
use std::collections::BTreeMap;
use turnwright::spinning::published::{
    Arithmetic, ConeParameters, ParabolaParameters, cone_points, form_length_pulses, parabola_points,
};

fn table(text: &str) -> Value {
    serde_json::from_str(text).unwrap()
}

fn number(value: &Value) -> u32 {
    u32::try_from(value.as_u64().unwrap()).unwrap()
}

/// The published interpolation in 16 bits, written from its description alone: steps at every travel.
fn steps_in_16_bits(num: u16, den: u16, length: u32, increment: u32) -> Vec<(u32, u32)> {
    let rounded = |value: u16, by: u16| value / by + u16::from(2 * (value % by) >= by);
    let mut moved = 0_u16;
    let mut out = Vec::new();
    while u32::from(moved) <= length {
        moved += u16::try_from(increment).unwrap();
        let pulses = rounded(moved.wrapping_mul(num), den);
        out.push((u32::from(moved), u32::from(rounded(pulses.wrapping_mul(32), 63))));
    }
    out
}

#[test]
fn every_published_cone_step_is_made_and_the_wrapped_ones_are_known() {
    let cone = table(include_str!("../cases/flow/cone.json"));
    let (mut compared, mut equal, mut wrapped, mut exact_equal) = (0, 0, 0, 0);
    let mut first_wrap: BTreeMap<u32, u32> = BTreeMap::new();
    for tangent in cone["tangent"].as_array().unwrap() {
        let angle = number(&tangent["angle_deg"]);
        let (num, den) = (number(&tangent["num"]), number(&tangent["den"]));
        for length_mm in 30..=74 {
            let length = number(&cone["form_length_pulses"][length_mm.to_string()]);
            assert_eq!(form_length_pulses(length_mm), length, "{length_mm} mm");
            for increment in 8..=16 {
                let parameters = ConeParameters::new(length_mm, increment, angle).unwrap();
                let own = cone_points(&parameters, Arithmetic::AsPublished);
                let exact = cone_points(&parameters, Arithmetic::Exact);
                let published =
                    steps_in_16_bits(u16::try_from(num).unwrap(), u16::try_from(den).unwrap(), length, increment);
                assert_eq!(own.len(), published.len());
                for ((own, exact), published) in own.iter().zip(&exact).zip(&published) {
                    compared += 1;
                    equal += u32::from((own.pulses, own.steps) == *published);
                    exact_equal += u32::from((exact.pulses, exact.steps) == *published);
                    if own.pulses * num > 65535 {
                        wrapped += 1;
                        let first = first_wrap.entry(angle).or_insert(length_mm);
                        *first = length_mm.min(*first);
                        assert!(own.wrapped && exact.steps > own.steps, "{angle}° {length_mm} mm {own:?}");
                    } else {
                        assert!(!own.wrapped);
                    }
                }
            }
        }
    }
    println!("cone: {compared} step values compared, {equal} equal as published, {wrapped} wrap in 16 bits");
    println!(
        "cone: {exact_equal} equal with wide integers; they differ where 16 bits wrap: {first_wrap:?} (° → from mm)"
    );
    assert_eq!(equal, compared);
    assert_eq!(exact_equal, compared - wrapped);
    let overflow = cone["overflow"].as_array().unwrap();
    let known: BTreeMap<u32, u32> =
        overflow.iter().map(|c| (number(&c["angle_deg"]), number(&c["from_form_length_mm"]))).collect();
    assert_eq!(first_wrap, known);
}

#[test]
fn every_published_parabola_step_is_made() {
    let parabola = table(include_str!("../cases/flow/parabola.json"));
    let rows = parabola["table"].as_array().unwrap();
    let (mut compared, mut equal) = (0, 0);
    for length_mm in 30..=74 {
        let parameters = ParabolaParameters::new(length_mm).unwrap();
        let own = parabola_points(&parameters, Arithmetic::AsPublished);
        let wanted = form_length_pulses(length_mm) / 16 + 1;
        assert_eq!(own.len(), usize::try_from(wanted).unwrap().min(72), "{length_mm} mm");
        for (own, row) in own.iter().zip(rows) {
            compared += 1;
            let published = (number(&row["carriage_pulses"]), number(&row["retract_steps"]));
            equal += u32::from((own.pulses, own.steps) == published);
            assert_eq!(own.target, 592 - i32::try_from(own.steps).unwrap());
        }
        let exact = parabola_points(&parameters, Arithmetic::Exact);
        assert_eq!(&exact[..own.len()], own.as_slice());
        assert_eq!(exact.len() - own.len(), usize::from(length_mm == 74));
    }
    println!("parabola: {compared} step values compared, {equal} equal; at 74 mm the 73rd point lies past the table");
    assert_eq!(equal, compared);
}
