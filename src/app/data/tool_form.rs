//! The fields of a tool, by the kind of its shape and by how its holder is given.

use super::field::{Field, Group, Is, figure, get, plain, set};
use serde_json::{Value, json};

/// Kinds of shape with their names.
pub(super) const KINDS: [(&str, &str); 10] = [
    ("iso", "ISO codes of insert and holder"),
    ("turning", "turning, pointed insert"),
    ("copying", "copying, points straight at the work"),
    ("button", "button, round insert"),
    ("boring", "boring bar"),
    ("threading", "threading"),
    ("parting", "grooving and parting blade"),
    ("drill", "drill"),
    ("outline", "free outline"),
    ("interference", "interference lines (MTIRA)"),
];

/// Ways in which the holder of a shape without one of its own is given.
pub(super) const HOLDERS: [(&str, &str); 3] =
    [("shank", "common head on a shank"), ("holder", "free outline"), ("interference_lines", "interference lines")];

const HANDS: Is = Is::OneOf(&[("right", "right, towards the chuck"), ("left", "left, away from the chuck")]);
const EDGES: Is = Is::OneOf(&[("carbide", "carbide"), ("hss", "high-speed steel")]);
const USES: Is = Is::OneOf(&[
    ("turning", "turning"),
    ("grooving", "grooving"),
    ("threading", "threading"),
    ("boring", "boring"),
    ("bore-grooving", "grooving in a bore"),
    ("bore-threading", "threading in a bore"),
    ("drill", "drilling"),
]);

const NAMES: &[Field] = &[plain("id", "Id", Is::Text), plain("name", "Name", Is::Text), plain("edge", "Edge", EDGES)];

const HAND: Field = plain("shape.hand", "Hand", HANDS);
const NOSE: Field = figure("shape.nose_radius", "Nose radius", "mm");
const CORNER: Field = figure("shape.corner_angle", "Corner", "°");
const APPROACH: Field = figure("shape.approach_angle", "Approach", "°");
const EDGE: Field = figure("shape.edge_length", "Edge length", "mm");
const WIDTH: Field = figure("shape.width", "Width", "mm");
const DIAMETER: Field = figure("shape.diameter", "Diameter", "mm");
const INSIDE: Field = plain("shape.inside", "In a bore", Is::YesNo);

const fn group(title: &'static str, fields: &'static [Field]) -> Group {
    Group { title, optional: None, fields }
}

/// The groups of fields of a tool as it is now.
pub(super) fn groups(tool: &Value) -> Vec<Group> {
    let mut groups = vec![group("", NAMES), group("Cutting part", of_shape(kind(tool)))];
    if let Some(way) = holder(tool) {
        groups.push(group("Holder", of_holder(way)));
    }
    groups
}

/// Kind of the tool's shape.
pub(super) fn kind(tool: &Value) -> &str {
    get(tool, "shape.kind").and_then(Value::as_str).unwrap_or_default()
}

const ISO: &[Field] = &[plain("shape.insert", "Insert", Is::Text), plain("shape.holder", "Holder", Is::Text)];
const POINTED: &[Field] = &[HAND, NOSE, CORNER, APPROACH, EDGE];
const PARTING: &[Field] = &[HAND, WIDTH, NOSE, figure("shape.depth", "Depth", "mm"), INSIDE];
const DRILL: &[Field] = &[
    DIAMETER,
    figure("shape.point_angle", "Point", "°"),
    figure("shape.length", "Length", "mm"),
    figure("shape.pecks_from", "Pecks from", "diameters"),
];
const INTERFERENCE: &[Field] =
    &[HAND, NOSE, WIDTH, figure("shape.angle", "Flank", "°"), figure("shape.margin", "Margin", "mm")];
const OUTLINE: &[Field] = &[
    plain("shape.use", "Use", USES),
    plain("shape.orientation", "Orientation", Is::Whole),
    NOSE,
    Field { path: "shape.corners", label: "Corners z r", unit: "mm", is: Is::Rows(2) },
];
const SHANK: &[Field] = &[figure("shank.width", "Width", "mm"), figure("shank.length", "Length", "mm")];

fn of_shape(kind: &str) -> &'static [Field] {
    match kind {
        "iso" => ISO,
        "turning" | "boring" => POINTED,
        "copying" => &[NOSE, CORNER, EDGE],
        "button" => &[DIAMETER],
        "threading" => &[NOSE, CORNER, EDGE, INSIDE],
        "parting" => PARTING,
        "drill" => DRILL,
        "interference" => INTERFERENCE,
        "outline" => OUTLINE,
        _ => &[],
    }
}

fn of_holder(way: &str) -> &'static [Field] {
    match way {
        "shank" => SHANK,
        "holder" => &[Field { path: "holder", label: "Corners z r", unit: "mm", is: Is::Rows(2) }],
        _ => &[Field { path: "interference_lines", label: "Lines z r z r", unit: "mm", is: Is::Rows(4) }],
    }
}

/// How the holder is given; `None` for shapes that bring their own.
pub(super) fn holder(tool: &Value) -> Option<&'static str> {
    if matches!(kind(tool), "iso" | "drill" | "interference") {
        return None;
    }
    let given = |path| get(tool, path).is_some_and(|v| v.as_array().map_or(!v.is_null(), |list| !list.is_empty()));
    HOLDERS.iter().map(|(way, _)| *way).find(|way| given(way)).or(Some("shank"))
}

/// True if the holder of this kind of shape may be a common head on a shank.
pub(super) fn takes_shank(tool: &Value) -> bool {
    kind(tool) != "outline"
}

/// Gives the holder in another way, with figures to go on from.
pub(super) fn set_holder(tool: &mut Value, way: &str) {
    for (other, _) in HOLDERS {
        set(tool, other, if other == "shank" { Value::Null } else { json!([]) });
    }
    let first = match way {
        "shank" => json!({"width": 25.0, "length": 150.0}),
        "holder" => json!([[2.0, 12.0], [25.0, 12.0], [25.0, 100.0], [2.0, 100.0]]),
        "interference_lines" => json!([[2.0, 12.0, 25.0, 12.0], [25.0, 100.0, 2.0, 100.0]]),
        _ => return,
    };
    set(tool, way, first);
}

/// Makes the shape one of another kind; figures that both kinds know stay.
pub(super) fn set_kind(tool: &mut Value, kind: &str) {
    let mut shape = first_shape(kind);
    let old = get(tool, "shape").cloned().unwrap_or_default();
    if let (Value::Object(new), Value::Object(old)) = (&mut shape, old) {
        for (key, value) in new.iter_mut().filter(|(key, _)| *key != "kind") {
            if let Some(kept) = old.get(key) {
                value.clone_from(kept);
            }
        }
    }
    set(tool, "shape", shape);
    let way = match kind {
        "iso" | "drill" | "interference" => "",
        "outline" => "holder",
        _ => holder(tool).unwrap_or("shank"),
    };
    let given = !way.is_empty() && get(tool, way).is_some_and(|v| v.as_array().map_or(!v.is_null(), |l| !l.is_empty()));
    if !given {
        set_holder(tool, way);
    }
}

fn first_shape(kind: &str) -> Value {
    let pointed = |kind| {
        json!({"kind": kind, "hand": "right", "nose_radius": 0.4, "corner_angle": 55.0, "approach_angle": 93.0,
               "edge_length": 11.0})
    };
    match kind {
        "turning" | "boring" => pointed(kind),
        "copying" => json!({"kind": kind, "nose_radius": 0.4, "corner_angle": 35.0, "edge_length": 16.0}),
        "button" => json!({"kind": kind, "diameter": 6.0}),
        "threading" => {
            json!({"kind": kind, "nose_radius": 0.1, "corner_angle": 60.0, "edge_length": 8.0, "inside": false})
        }
        "parting" => {
            json!({"kind": kind, "hand": "right", "width": 3.0, "nose_radius": 0.1, "depth": 20.0, "inside": false})
        }
        "drill" => json!({"kind": kind, "diameter": 12.0, "point_angle": 140.0, "length": 80.0, "pecks_from": 3.0}),
        "outline" => {
            json!({"kind": kind, "use": "turning", "orientation": 3, "nose_radius": 0.4,
                   "corners": [[0.0, 0.0], [10.0, 4.0], [10.0, 12.0], [1.0, 12.0]], "cuts": []})
        }
        "interference" => {
            json!({"kind": kind, "hand": "right", "nose_radius": 0.8, "width": 20.0, "angle": 35.0, "margin": 2.0})
        }
        _ => json!({"kind": "iso", "insert": "CNMG120408", "holder": "PCLNR2525M12"}),
    }
}

/// A tool to go on from.
pub(super) fn fresh() -> Value {
    json!({"id": "my-tool", "name": "My tool", "edge": "carbide", "shape": first_shape("iso"), "shank": null,
           "holder": [], "interference_lines": []})
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::machine::{Catalog, Tool, faults};

    #[test]
    fn every_kind_begins_without_fault_from_any_other() {
        for (from, _) in KINDS {
            for (to, _) in KINDS {
                let mut tool = fresh();
                set_kind(&mut tool, from);
                set_kind(&mut tool, to);
                let read: Tool =
                    serde_json::from_value(tool.clone()).unwrap_or_else(|e| panic!("{from} {to}: {e} {tool}"));
                // Figures of one kind may be out of range for another; that is said at the field.
                assert!(faults(&read).iter().all(|f| f.path.starts_with("shape.")), "{from} {to}: {:?}", faults(&read));
            }
            let mut tool = fresh();
            set_kind(&mut tool, from);
            let read: Tool = serde_json::from_value(tool).unwrap();
            assert_eq!(faults(&read), [], "{from}");
        }
    }

    #[test]
    fn every_field_of_a_shipped_tool_is_there() {
        for tool in Catalog::shipped().tools {
            let value = serde_json::to_value(&tool).unwrap();
            for field in groups(&value).iter().flat_map(|g| g.fields) {
                assert!(get(&value, field.path).is_some(), "{}: {}", tool.id, field.path);
            }
        }
    }
}
