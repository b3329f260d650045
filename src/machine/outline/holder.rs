//! Outlines of common holders about an insert, right-hand and outside: heads on a shank, bars, blades, drill holders.
//!
//! No standard gives the outline of a head. What is drawn here takes the standard's shank, bar and tip distance, comes out
//! under the insert well behind the ends of its cutting edges, and leaves the work more steeply than the insert does.

use super::insert::{Polygon, unit};
use crate::geometry::{Contour, Point};

/// How far the seat lies inside the cutting edges, mm, where the insert is large enough.
const SEAT_INSET_MM: f64 = 1.0;
/// Part of the back edge from the end of a cutting edge to where the holder comes out under the insert.
const OUT_OF_INSERT: f64 = 0.25;
/// How much steeper than the insert's last edge the head leaves the work, degrees.
const HEAD_RELIEF_DEG: f64 = 8.0;
/// Steepest flank of a head, degrees from z.
const STEEPEST_DEG: f64 = 80.0;
/// Flank of a head behind a threading insert, degrees from z.
const BROAD_HEAD_DEG: f64 = 35.0;
/// Length of a head in widths of its shank.
const HEAD_IN_WIDTHS: f64 = 1.3;
/// Length of a bar outside its sleeve in diameters: what steel bars bear (Sandvik Coromant, boring).
pub(super) const OVERHANG_IN_DIAMETERS: f64 = 4.0;

/// Distance from the far side of a shank to the tip by shank width, mm (ISO 5608, dimension f of offset shanks).
const TIP_FROM_SHANK: [(f64, f64); 9] = [
    (8.0, 10.0),
    (10.0, 12.0),
    (12.0, 16.0),
    (16.0, 20.0),
    (20.0, 25.0),
    (25.0, 32.0),
    (32.0, 40.0),
    (40.0, 50.0),
    (50.0, 60.0),
];
/// Distance from a bar's axis to the tip by bar diameter, mm (ISO 6261, dimension f).
const TIP_FROM_BAR: [(f64, f64); 9] = [
    (8.0, 6.0),
    (10.0, 7.0),
    (12.0, 9.0),
    (16.0, 11.0),
    (20.0, 13.0),
    (25.0, 17.0),
    (32.0, 22.0),
    (40.0, 27.0),
    (50.0, 35.0),
];

/// The standard distance for a size, or what lies between the standard sizes.
fn tip_distance(table: &[(f64, f64)], size: f64) -> f64 {
    let below = table.iter().rev().find(|(s, _)| *s <= size);
    let above = table.iter().find(|(s, _)| *s >= size);
    match (below, above) {
        (Some(&(s0, f0)), Some(&(s1, f1))) if s1 > s0 => f0 + (f1 - f0) * (size - s0) / (s1 - s0),
        (Some(&(s, f)), _) | (None, Some(&(s, f))) => f * size / s,
        (None, None) => size,
    }
}

/// Where the holder sits under an insert and comes out of it.
struct Under {
    /// Under the tip.
    tip: Point,
    /// Inside the far end of the trailing edge, and where the holder comes out there.
    trailing: [Point; 2],
    /// The same at the leading edge.
    leading: [Point; 2],
    /// Angle at which the head leaves the work, radians from z.
    flank: f64,
}

impl Under {
    fn of(insert: &Polygon) -> Self {
        let count = insert.corners.len();
        let at = |i: usize| insert.corners.get((i + count) % count.max(1)).copied().unwrap_or_default();
        let (tip, next, last) = (at(0), at(1), at(count - 1));
        let (trailing_edge, leading_edge) = (next - tip, last - tip);
        let (along_trailing, along_leading) = (unit(trailing_edge), unit(leading_edge));
        let shorter = trailing_edge.norm().min(leading_edge.norm());
        let inset = SEAT_INSET_MM.min(shorter * 0.12);
        let corner = along_trailing.dot(&along_leading).clamp(-1.0, 1.0).acos();
        // On the bisector, behind both edges and behind the nose.
        let (half, nose) = ((corner / 2.0).sin(), insert.nose_radius);
        let behind = (inset / half).max(nose / half - nose + inset);
        let under_tip = tip + unit(along_trailing + along_leading) * behind;
        let (trailing_end, leading_end) = (at(insert.trailing_end), at(insert.leading_end));
        let near = |end: Point| under_tip + (end - under_tip) * 0.8;
        let out_trailing = trailing_end + (at(insert.trailing_end + 1) - trailing_end) * OUT_OF_INSERT;
        let out_leading = leading_end + (at(insert.leading_end + count - 1) - leading_end) * OUT_OF_INSERT;
        let last_edge = trailing_end - at(insert.trailing_end + count - 1);
        let back_edge = unit(at(insert.trailing_end + 1) - trailing_end);
        let flank = last_edge.y.atan2(last_edge.x) + HEAD_RELIEF_DEG.to_radians();
        // Behind a back edge that lies along the spindle the head is broad.
        let steepest = if back_edge.x < -0.95 { BROAD_HEAD_DEG } else { STEEPEST_DEG };
        Self {
            tip: under_tip,
            trailing: [near(next), out_trailing],
            leading: [near(last), out_leading],
            flank: flank.clamp(HEAD_RELIEF_DEG.to_radians(), steepest.to_radians()),
        }
    }
}

/// A head on a shank that stands square to the spindle. A straight one has its shank behind the tip, others beside it.
pub(super) fn head(insert: &Polygon, width: f64, length: f64, straight: bool) -> Contour {
    let under = Under::of(insert);
    let [inner_trailing, out_trailing] = under.trailing;
    let [inner_leading, out_leading] = under.leading;
    let far = if straight { width / 2.0 } else { tip_distance(&TIP_FROM_SHANK, width) };
    let far = far.max(out_trailing.z + 1.0);
    let near = if straight { (far - width).min(out_leading.z - 1.0) } else { far - width };
    let behind = out_trailing.r + (far - out_trailing.z) * under.flank.tan();
    let beside = if straight { behind } else { (HEAD_IN_WIDTHS * width).max(out_leading.r + 2.0) };
    let end = length.max(behind + 1.0).max(beside + 1.0);
    let mut points = vec![under.tip, inner_trailing, out_trailing];
    points.extend([(far, behind), (far, end), (near, end), (near, beside)].map(|(z, r)| Point::new(z, r)));
    points.extend([out_leading, inner_leading]);
    Contour::polygon(&points)
}

/// A bar along the spindle that stands `overhang` out of its sleeve; the tool lies upside down, as if outside.
pub(super) fn bar(insert: &Polygon, diameter: f64, overhang: f64) -> Contour {
    /// How far the bar's sides lie clear of the insert where it is wider than the bar, mm.
    const CLEAR_MM: f64 = 0.5;
    let under = Under::of(insert);
    let [inner_trailing, out_trailing] = under.trailing;
    let [inner_leading, out_leading] = under.leading;
    let axis = tip_distance(&TIP_FROM_BAR, diameter);
    let (low, high) = (axis - diameter / 2.0, (axis + diameter / 2.0).max(out_leading.r + CLEAR_MM));
    let rightmost = insert.corners.iter().map(|p| p.z).fold(f64::NEG_INFINITY, f64::max);
    // The bar begins where the flank has reached its side, or else just behind the insert.
    let begins = if out_trailing.r < low {
        let begins = out_trailing.z + (low - out_trailing.r) / under.flank.tan();
        vec![Point::new(begins.max(out_trailing.z + CLEAR_MM), low)]
    } else {
        let behind = rightmost.max(out_trailing.z) + CLEAR_MM;
        vec![Point::new(behind, out_trailing.r + CLEAR_MM), Point::new(behind, low)]
    };
    let front = out_leading.z + (high - out_leading.r) * 10_f64.to_radians().tan();
    let sleeve = begins.iter().map(|p| p.z + 1.0).fold(overhang, f64::max);
    let mut points = vec![under.tip, inner_trailing, out_trailing];
    let (sleeve_low, sleeve_high, sleeve_end) = (axis - diameter, axis + diameter, sleeve + 2.0 * diameter);
    let body = [
        (sleeve, low),
        (sleeve, sleeve_low),
        (sleeve_end, sleeve_low),
        (sleeve_end, sleeve_high.max(high + 1.0)),
        (sleeve, sleeve_high.max(high + 1.0)),
        (sleeve, high),
        (front, high),
    ];
    points.extend(begins);
    points.extend(body.map(|(z, r)| Point::new(z, r)));
    points.extend([out_leading, inner_leading]);
    Contour::polygon(&points)
}

/// The support under a disc: a neck narrower than the disc, then the shank.
pub(super) fn under_disc(center: Point, diameter: f64, width: f64, length: f64, straight: bool) -> Contour {
    let neck = 0.38 * diameter;
    let far = if straight { width / 2.0 } else { tip_distance(&TIP_FROM_SHANK, width) - center.z };
    let (left, right) = (far - width, far.max(neck + 1.0));
    let (shoulder, end) = (1.2 * diameter, length.max(1.2 * diameter + 2.0 * width));
    let points = [
        (-0.3 * diameter, 0.35 * diameter),
        (0.3 * diameter, 0.35 * diameter),
        (neck, diameter / 2.0),
        (neck, shoulder),
        (right, shoulder + (right - neck)),
        (right, end),
        (left.min(-neck), end),
        (left.min(-neck), shoulder + (-neck - left).max(1.0)),
        (-neck, shoulder),
        (-neck, diameter / 2.0),
    ];
    Contour::polygon(&points.map(|(z, r)| Point::new(z + center.z, r)))
}

/// The support of a blade, narrower than its insert, and the shank above its depth, flush with the side towards the chuck.
pub(super) fn blade(width: f64, insert_depth: f64, depth: f64, shank: f64, length: f64) -> Contour {
    let aside = width * 0.12;
    let (low, neck) = (insert_depth * 0.7, depth.max(insert_depth + 0.1));
    let end = length.max(neck + shank);
    let points = [
        (aside, low),
        (width - aside, low),
        (width - aside, neck),
        (shank.max(width), neck + (shank - width).max(0.0) * 0.2),
        (shank.max(width), end),
        (aside, end),
    ];
    Contour::polygon(&points.map(|(z, r)| Point::new(z, r)))
}

/// The bar of a blade for bores, as if outside: a neck as deep as the blade reaches, then the bar along the spindle.
pub(super) fn blade_bar(width: f64, insert_depth: f64, depth: f64, diameter: f64, overhang: f64) -> Contour {
    let aside = width * 0.12;
    let (low, neck) = (insert_depth * 0.7, depth.max(insert_depth + 0.1));
    let (high, sleeve) = (neck + diameter, overhang.max(2.0 * width));
    let body = [
        (aside, low),
        (width - aside, low),
        (width - aside, neck),
        (sleeve, neck),
        (sleeve, neck - diameter / 2.0),
        (sleeve + 2.0 * diameter, neck - diameter / 2.0),
        (sleeve + 2.0 * diameter, high + diameter / 2.0),
        (sleeve, high + diameter / 2.0),
        (sleeve, high),
        (aside, high),
    ];
    Contour::polygon(&body.map(|(z, r)| Point::new(z, r)))
}

/// The sleeve that holds a drill, from where the drill stands out of it.
pub(super) fn drill_sleeve(diameter: f64, length: f64) -> Contour {
    let (radius, end) = (diameter.max(10.0), length + 3.0 * diameter.max(10.0));
    let corners = [(length, -radius), (end, -radius), (end, radius), (length, radius)];
    Contour::polygon(&corners.map(|(z, r)| Point::new(z, r)))
}

/// The body behind the flank of a contouring tool given by width, angle and margin: it begins where the flank has reached
/// the tool's width and is wider by the margin.
pub(super) fn behind_flank(width: f64, top: f64, margin: f64, length: f64) -> Contour {
    let corners = [(0.0, top), (width + margin, top), (width + margin, top + length), (0.0, top + length)];
    Contour::polygon(&corners.map(|(z, r)| Point::new(z, r)))
}
