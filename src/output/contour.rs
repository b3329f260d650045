//! `NAME.contour.json`: the finished contour as lines and arcs, and that of the bore as a second chain.

use crate::geometry::{Contour, Segment};
use crate::part::PartContour;
use crate::regen::SetupDerived;
use serde_json::{Value, json};

pub(super) fn contour(item: &SetupDerived) -> Value {
    json!({
        "name": item.name,
        "unit": "mm",
        "space": "part space of the set-up: z along the spindle, growing away from the chuck; r a radius",
        "segments": chain(&item.contour),
        "bore": item.bore.as_ref().as_ref().map(chain),
    })
}

/// The segments of a contour with their rows; row 0 is the hole of a tube that no row describes.
fn chain(contour: &PartContour) -> Value {
    let segments = contour.contour.segments.iter().zip(&contour.sections).map(|(s, &section)| {
        let mut value = segment(s);
        value["section"] = json!(section);
        value
    });
    segments.collect()
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
