//! `NAME.contour.json`: the finished contour as lines and arcs.

use crate::geometry::{Contour, Segment};
use crate::regen::SetupDerived;
use serde_json::{Value, json};

pub(super) fn contour(item: &SetupDerived) -> Value {
    let segments = item.contour.contour.segments.iter().zip(&item.contour.sections).map(|(s, &section)| {
        let mut value = segment(s);
        value["section"] = json!(section);
        value
    });
    json!({
        "name": item.name,
        "unit": "mm",
        "space": "part space of the set-up: z along the spindle, growing away from the chuck; r a radius",
        "segments": segments.collect::<Vec<_>>(),
    })
}

/// One segment with everything that a reader may want to know of it.
pub(super) fn segment(segment: &Segment) -> Value {
    match *segment {
        Segment::Line { start, end } => json!({ "type": "line", "start": start, "end": end }),
        Segment::Arc { start, end, center, ccw } => json!({
            "type": "arc",
            "start": start,
            "end": end,
            "center": center,
            "radius": start.distance(center),
            "ccw": ccw,
        }),
    }
}

pub(super) fn outline(contour: &Contour) -> Value {
    contour.segments.iter().map(segment).collect()
}
