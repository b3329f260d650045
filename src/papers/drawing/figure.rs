//! Figures of a drawing: lengths, chamfers and threads as a drafter writes them.

use crate::papers::number::number;
use crate::part::{Parabola, ParabolaAxis, Section, SectionKind};
use crate::units::{MM_PER_INCH, Unit, trimmed};

/// Depth of an outside ISO metric thread for its pitch, on the diameter: d − d3 = 1.22687·P (ISO 68-1).
const METRIC_OUTSIDE: f64 = 1.226_87;
/// Depth of an inside ISO metric thread for its pitch, on the diameter: D − D1 = 1.08253·P (ISO 68-1).
const METRIC_INSIDE: f64 = 1.082_53;
/// Difference of a core diameter from the one of the standard that still makes the thread metric, as a share of the pitch.
const METRIC_LIMIT: f64 = 0.06;

/// `Ø 25.4` of a radius in mm.
pub(super) fn diameter(radius_mm: f64, unit: Unit) -> String {
    format!("Ø {}", number(2.0 * radius_mm, unit))
}

/// `2 × 45°`: a chamfer by its length along the axis, mm.
pub(super) fn chamfer(length_mm: f64, unit: Unit) -> String {
    format!("{} × 45°", number(length_mm, unit))
}

/// A parabola by the coordinate that is the quadratic one and a third point, at half of its length.
pub(super) fn parabola(parabola: &Parabola, unit: Unit) -> String {
    let axis = match parabola.axis {
        ParabolaAxis::AlongZ => "parabola z(r)",
        ParabolaAxis::AlongX => "parabola r(z)",
    };
    let middle = parabola.point_at(0.5);
    format!("{axis}, {} at {}", diameter(middle.r, unit), number(middle.z, unit))
}

/// What a thread row of lengths in mm is called: `M12 × 1.75`, `M20 × Ph 5 P 2.5` or, where its core is not that of a metric
/// thread, all its figures.
pub(super) fn thread(row_mm: &Section, inside: bool, unit: Unit) -> String {
    let SectionKind::Thread { pitch, starts } = row_mm.kind else { return String::new() };
    let (major, minor) = if inside { (row_mm.d2, row_mm.d1) } else { (row_mm.d1, row_mm.d2) };
    let depth = if inside { METRIC_INSIDE } else { METRIC_OUTSIDE };
    let metric = unit == Unit::Mm && (major - minor - depth * pitch).abs() <= METRIC_LIMIT * pitch;
    let lead = pitch * f64::from(starts.max(1));
    let pitch_text = match starts {
        0 | 1 => number(pitch, unit),
        _ => format!("Ph {} P {}", number(lead, unit), number(pitch, unit)),
    };
    if metric {
        return format!("M{} × {pitch_text}", number(major, unit));
    }
    let per_inch = MM_PER_INCH / pitch;
    let pitch_text = match unit {
        Unit::Inch if starts <= 1 => format!("{} to the inch", trimmed(per_inch, 2)),
        Unit::Inch | Unit::Mm => pitch_text,
    };
    format!("thread {} × {pitch_text}, core {}", number(major, unit), number(minor, unit))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(d1: f64, d2: f64, pitch: f64, starts: u32) -> Section {
        Section { kind: SectionKind::Thread { pitch, starts }, ..Section::line(1, 0.0, d1, 20.0, d2) }
    }

    #[test]
    fn diameters_and_chamfers_have_their_signs() {
        assert_eq!(diameter(12.7, Unit::Inch), "Ø 1");
        assert_eq!(chamfer(2.0, Unit::Mm), "2 × 45°");
    }

    #[test]
    fn only_a_thread_with_a_metric_core_is_called_metric() {
        assert_eq!(thread(&row(12.0, 9.85, 1.75, 1), false, Unit::Mm), "M12 × 1.75");
        assert_eq!(thread(&row(43.376, 45.0, 1.5, 1), true, Unit::Mm), "M45 × 1.5");
        assert_eq!(thread(&row(20.0, 16.933, 2.5, 2), false, Unit::Mm), "M20 × Ph 5 P 2.5");
        assert_eq!(thread(&row(12.0, 10.5, 1.75, 1), false, Unit::Mm), "thread 12 × 1.75, core 10.5");
        let inch = row(12.7, 10.3, 25.4 / 13.0, 1);
        assert_eq!(thread(&inch, false, Unit::Inch), "thread 0.5 × 13 to the inch, core 0.4055");
    }
}
