//! `NAME.setup.json`: machine, stock, work holding, part zero and the tools that the programs call.

use super::contour::outline;
use crate::machine::Machine;
use crate::regen::{Derived, SetupDerived};
use serde_json::{Value, json};
use std::collections::BTreeSet;

pub(super) fn setup(derived: &Derived, item: &SetupDerived) -> Value {
    let setup = &item.setup;
    let part = &item.part;
    let in_mm = derived.document.unit.in_mm();
    let (hole, facing) = (part.stock_bore_diameter * in_mm, part.facing_allowance * in_mm);
    json!({
        "name": item.name,
        "unit": "mm",
        "space": "part space of the set-up: z along the spindle, growing away from the chuck; r a radius",
        "machine": derived.machine.as_deref().map(machine),
        "stock": {
            "bar_diameter": 2.0 * setup.bar_radius,
            "hole_diameter": hole,
            "facing_allowance": facing,
            "outline": outline(&setup.stock),
        },
        "work_holding": derived.machine.as_deref().map(|m| json!({
            "kind": setup.holding,
            "face_z": setup.chuck_face_z,
            "radius": m.chuck.radius_mm,
            "depth": m.chuck.depth_mm,
            "directions": setup.directions,
            "mandrel": setup.mandrel.as_ref().map(outline),
            "tailstock": setup.tailstock.as_ref().map(outline),
        })),
        "part": {
            "length": setup.length,
            "machined_from_z": setup.machined_from_z,
            "bored_from_z": setup.bore.as_ref().map(|_| setup.bored_from_z),
            "turned_round": setup.turned_round,
        },
        "part_zero": {
            "program_zero_z": item.path.program_zero_z,
            "datum": item.path.datum,
            "note": "program z = part z - program_zero_z; program x is a radius",
        },
        "tools": tools(derived, item),
    })
}

fn machine(machine: &Machine) -> Value {
    json!({ "id": machine.id, "name": machine.name, "dialect": machine.dialect, "limits": machine.limits })
}

fn tools(derived: &Derived, item: &SetupDerived) -> Value {
    let used: BTreeSet<u32> = item.proof.moves.iter().map(|m| m.tool).collect();
    let station_of = |station: u32| {
        let tool = derived.machine.as_deref()?.tools.iter().find(|t| t.station == station)?;
        let shape = item.tools.get(&station)?;
        Some(json!({
            "station": station,
            "id": tool.tool,
            "space": "tool space: the origin is the programmed point",
            "insert": outline(&shape.insert),
            "holder": outline(&shape.holder),
        }))
    };
    used.into_iter().filter_map(station_of).collect()
}
