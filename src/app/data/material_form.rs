//! The fields of a material.

use super::field::{Group, Is, Table, figure, maybe, plain};
use serde_json::{Value, json};

const UNITS: Is = Is::OneOf(&[("mm", "mm"), ("inch", "inch")]);
const OPERATIONS: Is = Is::OneOf(&[
    ("rough", "rough"),
    ("finish", "finish"),
    ("face", "face"),
    ("groove", "groove"),
    ("part-off", "part off"),
    ("drill", "drill"),
    ("bore-rough", "rough bore"),
    ("bore-finish", "finish bore"),
    ("thread", "thread"),
]);
const EDGES: Is = Is::OneOf(&[("carbide", "carbide"), ("hss", "hss")]);

/// The groups of fields of every material.
pub(super) const GROUPS: [Group; 2] = [
    Group {
        title: "",
        optional: None,
        fields: &[
            plain("name", "Name", Is::Text),
            maybe("specific_cutting_force_n_per_mm2", "Force kc1.1", "N/mm²"),
            maybe("mc", "Exponent mc", ""),
            maybe("density_kg_per_dm3", "Density", "kg/dm³"),
            maybe("price_per_kg", "Price", "per kg"),
        ],
    },
    Group {
        title: "Published ORAC generator",
        optional: Some(("orac", orac)),
        fields: &[
            plain("unit", "Unit of these", UNITS),
            figure("orac.feed_travel", "Travel feed", "/min"),
            figure("orac.feed_cut", "Cutting feed", "/min"),
            figure("orac.feed_part_off", "Part-off feed", "/min"),
            figure("orac.depth_rough", "Rough depth", ""),
            figure("orac.depth_finish", "Finish depth", ""),
            figure("orac.depth_thread", "Thread depth", ""),
        ],
    },
];

/// Cutting data by operation and tool.
pub(super) const CUTTING: Table = Table {
    title: "Cutting data",
    path: "operations",
    columns: &[
        plain("operation", "Operation", OPERATIONS),
        plain("tool", "Edge", EDGES),
        figure("speed_m_per_min", "Speed", "m/min"),
        figure("feed_mm_per_rev", "Feed", "mm/rev"),
        figure("depth_mm", "Depth", "mm"),
    ],
    fresh: row,
};

fn orac() -> Value {
    json!({"feed_travel": 1000.0, "feed_cut": 80.0, "feed_part_off": 20.0, "depth_rough": 1.0, "depth_finish": 0.1,
           "depth_thread": 0.05})
}

fn row() -> Value {
    json!({"operation": "rough", "tool": "carbide", "speed_m_per_min": 150.0, "feed_mm_per_rev": 0.2, "depth_mm": 1.5})
}

/// A material to go on from.
pub(super) fn fresh() -> Value {
    json!({"name": "MY MATERIAL", "unit": "mm", "orac": null, "specific_cutting_force_n_per_mm2": 1500.0, "mc": 0.25,
           "density_kg_per_dm3": null, "price_per_kg": null, "operations": [row()]})
}

#[cfg(test)]
mod tests {
    use super::super::field::get;
    use super::*;
    use crate::machine::{Catalog, Material, faults};

    #[test]
    fn fields_of_materials_are_there_and_a_new_one_is_without_fault() {
        let shipped = Catalog::shipped().materials.into_iter().map(|m| serde_json::to_value(m).unwrap());
        for value in shipped.chain([fresh()]) {
            for field in GROUPS[0].fields {
                assert!(get(&value, field.path).is_some(), "{}", field.path);
            }
        }
        let mut value = fresh();
        value["orac"] = orac();
        let read: Material = serde_json::from_value(value).unwrap();
        assert_eq!(faults(&read), []);
    }
}
