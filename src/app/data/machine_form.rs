//! The fields of a machine. Codes of its control, gears and serial line are edited in the file.

use super::field::{Field, Group, Is, Table, figure, get, maybe, plain};
use super::words_form;
use serde_json::{Value, json};

const CUTS: Is = Is::OneOf(&[("towards-headstock", "towards the headstock only"), ("both", "both ways")]);
const ZERO: Is = Is::OneOf(&[("free-end", "free end"), ("clamped-end", "clamped end")]);
const SIDE: Is = Is::OneOf(&[("rear", "behind the axis"), ("front", "in front of the axis")]);

/// The groups of fields of the machine `item`.
pub(super) fn groups(item: &Value) -> Vec<Group> {
    let mut groups = GROUPS.to_vec();
    if get(item, "words").is_some_and(|words| !words.is_null()) {
        groups.extend(words_form::GROUPS);
    }
    groups
}

/// The groups of every machine.
const GROUPS: [Group; 10] = [
    Group {
        title: "",
        optional: None,
        fields: &[
            plain("id", "Id", Is::Text),
            plain("name", "Name", Is::Text),
            figure("tool_change_s", "Tool change", "s"),
            plain("turret_side", "Turret", SIDE),
        ],
    },
    Group {
        title: "Travels and limits",
        optional: None,
        fields: &[
            figure("limits.bar_diameter_mm", "Largest ⌀", "mm"),
            figure("limits.travel_x_mm", "Travel x", "mm"),
            figure("limits.travel_z_mm", "Travel z", "mm"),
            figure("limits.taper_ratio", "Taper ratio", "to 1"),
            figure("limits.arc_radius_min_mm", "Smallest arc", "mm"),
            figure("limits.arc_radius_max_mm", "Largest arc", "mm"),
            plain("limits.arc_one_quadrant", "One quadrant", Is::YesNo),
            figure("limits.pitch_min_mm", "Least pitch", "mm"),
            figure("limits.pitch_max_mm", "Largest pitch", "mm"),
            figure("limits.feed_min_mm_per_min", "Lowest feed", "mm/min"),
            figure("limits.feed_max_mm_per_min", "Highest feed", "mm/min"),
            plain("limits.blocks_per_program", "Blocks held", Is::Whole),
        ],
    },
    Group {
        title: "Spindle",
        optional: None,
        fields: &[
            figure("limits.spindle_max_rpm", "Highest speed", "rev/min"),
            figure("spindle.min_rpm", "Lowest speed", "rev/min"),
            figure("spindle.thread_feed_mm_per_min", "Thread feed", "mm/min"),
            maybe("spindle.power_kw", "Power", "kW"),
            maybe("spindle.full_power_rpm", "Full power at", "rev/min"),
            figure("spindle.efficiency", "Efficiency", ""),
        ],
    },
    Group {
        title: "Rapid rates",
        optional: Some(("motion", motion)),
        fields: &[
            figure("motion.rapid_x_mm_per_min", "Rapid x", "mm/min"),
            figure("motion.rapid_z_mm_per_min", "Rapid z", "mm/min"),
            figure("motion.acceleration_mm_per_s2", "Acceleration", "mm/s²"),
        ],
    },
    Group {
        title: "Program zero and start",
        optional: None,
        fields: &[
            plain("datum.zero", "Zero at the", ZERO),
            figure("datum.radial_clearance_mm", "Above the bar", "mm"),
            figure("datum.axial_clearance_mm", "Before the end", "mm"),
        ],
    },
    Group {
        title: "Rest position",
        optional: Some(("rest", rest)),
        fields: &[figure("rest.z_mm", "z", "mm"), figure("rest.diameter_mm", "⌀", "mm")],
    },
    Group {
        title: "Chuck",
        optional: None,
        fields: &[
            figure("chuck.radius_mm", "Jaw radius", "mm"),
            figure("chuck.depth_mm", "Jaw depth", "mm"),
            figure("chuck.gap_mm", "Gap kept", "mm"),
            figure("chuck.grip_mm", "Grip", "mm"),
            figure("chuck.automatic_grip_mm", "Automatic grip", "mm"),
            plain("chuck.cuts", "Cuts", CUTS),
        ],
    },
    Group { title: "Driver between centres", optional: Some(("mandrel", mandrel)), fields: MANDREL },
    Group { title: "Tailstock", optional: Some(("tailstock", tailstock)), fields: TAILSTOCK },
    Group {
        title: "Cost",
        optional: Some(("cost", cost)),
        fields: &[
            plain("cost.currency", "Currency", Is::Text),
            figure("cost.machine_per_hour", "Per hour", ""),
            figure("cost.setup", "Setting up", ""),
        ],
    },
];

const MANDREL: &[Field] = &[Field { path: "mandrel.outline", label: "Corners z r", unit: "mm", is: Is::Rows(2) }];
const TAILSTOCK: &[Field] = &[Field { path: "tailstock.outline", label: "Corners z r", unit: "mm", is: Is::Rows(2) }];

/// The turret.
pub(super) const TURRET: Table = Table {
    title: "Turret",
    path: "tools",
    columns: &[
        plain("station", "Station", Is::Whole),
        plain("tool", "Tool", Is::Text),
        maybe("change_z_mm", "Change z", "mm"),
        maybe("change_diameter_mm", "Change ⌀", "mm"),
    ],
    fresh: station,
};

fn motion() -> Value {
    json!({"rapid_x_mm_per_min": 10000.0, "rapid_z_mm_per_min": 10000.0, "acceleration_mm_per_s2": 2000.0})
}

fn rest() -> Value {
    json!({"z_mm": 200.0, "diameter_mm": 200.0})
}

fn mandrel() -> Value {
    json!({"outline": [[-60.0, 0.0], [0.0, 0.0], [0.0, 10.0], [-20.0, 30.0], [-60.0, 30.0]]})
}

fn tailstock() -> Value {
    json!({"outline": [[0.0, 0.0], [160.0, 0.0], [160.0, 35.0], [60.0, 35.0], [30.0, 12.5], [0.0, 4.0]]})
}

fn cost() -> Value {
    json!({"currency": "EUR", "machine_per_hour": 60.0, "setup": 60.0})
}

fn station() -> Value {
    json!({"station": 1, "tool": "pclnr-cnmg-08", "offset": null, "change_z_mm": null, "change_diameter_mm": null})
}

#[cfg(test)]
mod tests {
    use super::super::field::set;
    use super::*;
    use crate::machine::{Catalog, Machine, faults};

    #[test]
    fn every_field_of_a_shipped_machine_is_there() {
        for machine in Catalog::shipped().machines {
            let mut value = serde_json::to_value(&machine).unwrap();
            for (path, first) in GROUPS.iter().filter_map(|g| g.optional) {
                assert!(get(&value, path).is_some(), "{path}");
                if get(&value, path).is_some_and(Value::is_null) {
                    set(&mut value, path, first());
                }
            }
            for field in GROUPS.iter().flat_map(|g| g.fields) {
                assert!(get(&value, field.path).is_some(), "{}: {}", machine.id, field.path);
            }
            let read: Machine = serde_json::from_value(value).unwrap();
            let optional =
                |path: &str| ["motion", "rest", "mandrel", "tailstock", "cost"].iter().any(|o| path.starts_with(o));
            // The ORAC's control takes no rapid rates; that is said at the group.
            let optional = |path: &str| optional(path) && path != "motion";
            assert!(faults(&read).iter().all(|f| !optional(&f.path)), "{:?}", faults(&read));
        }
    }
}
