//! The set points for a small controller: as a table of comma-separated values and as a C header.

use super::interpolation::SetPoint;
use super::published::{MM_PER_PULSE, MM_PER_STEP};
use std::fmt::Write;

/// `pulses,retreat_um,steps`, one set point a line.
#[must_use]
pub fn csv(points: &[SetPoint]) -> String {
    let mut text = String::from("pulses,retreat_um,steps\n");
    for p in points {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "{},{},{}", p.pulses, p.retreat_um, p.steps);
    }
    text
}

/// A C header with one array of pulses, micrometres and steps. `name` becomes the identifier.
#[must_use]
pub fn c_header(name: &str, points: &[SetPoint]) -> String {
    let id = identifier(name);
    let guard = id.to_uppercase();
    let mut text = format!(
        "/* {id}: set points of the roller. Carriage travel in encoder pulses of {MM_PER_PULSE} mm from the former's tip;\n   \
         distance of the roller from its start, away from the axis, in micrometres and in steps of {MM_PER_STEP} mm. */\n\
         #ifndef {guard}_SET_POINTS_H\n#define {guard}_SET_POINTS_H\n\n#include <stdint.h>\n\n\
         #define {guard}_COUNT {}\n\n\
         struct {id}_set_point {{\n    uint32_t pulses;\n    int32_t retreat_um;\n    int16_t steps;\n}};\n\n\
         static const struct {id}_set_point {id}_set_points[{guard}_COUNT] = {{\n",
        points.len()
    );
    for p in points {
        let _ = writeln!(text, "    {{ {}u, {}, {} }},", p.pulses, p.retreat_um, p.steps);
    }
    text.push_str("};\n\n#endif\n");
    text
}

/// Letters, digits and underscores, beginning with a letter.
fn identifier(name: &str) -> String {
    let id: String =
        name.chars().map(|c| if c.is_ascii_alphanumeric() { c.to_ascii_lowercase() } else { '_' }).collect();
    if id.starts_with(|c: char| c.is_ascii_lowercase()) { id } else { format!("shell_{id}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    const POINTS: [SetPoint; 2] =
        [SetPoint { pulses: 0, retreat_um: 0, steps: 0 }, SetPoint { pulses: 16, retreat_um: 587, steps: 5 }];

    #[test]
    fn both_forms_hold_every_point() {
        assert_eq!(csv(&POINTS), "pulses,retreat_um,steps\n0,0,0\n16,587,5\n");
        let header = c_header("30 DEG", &POINTS);
        assert!(header.contains("#define SHELL_30_DEG_COUNT 2\n"), "{header}");
        assert!(header.contains("    { 16u, 587, 5 },\n"));
        assert_eq!(header.matches("#ifndef").count(), header.matches("#endif").count());
    }
}
