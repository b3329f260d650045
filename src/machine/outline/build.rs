//! From the shape in a tool's file to its outline.

use super::holder::OVERHANG_IN_DIAMETERS;
use super::insert::{self, Polygon, STRAIGHT, bisector};
use super::{ToolKind, ToolOutline, holder};
use crate::geometry::{Contour, Point};
use crate::machine::iso::{InsertForm, IsoTool, Seat};
use crate::machine::{Hand, Shank, Tool, ToolShape};

/// Length of the body behind a tool that is given by interference lines, in widths.
const BODY_IN_WIDTHS: f64 = 8.0;

/// The outline of a tool with the holder that its shape or shank describes; `None` for codes that are not understood.
pub(super) fn built(tool: &Tool) -> Option<ToolOutline> {
    let shank = tool.shank;
    Some(match tool.shape {
        ToolShape::Iso { ref insert, ref holder } => iso(&IsoTool::read(insert, holder).ok()?),
        ToolShape::Turning { hand, nose_radius, corner_angle, approach_angle, edge_length } => {
            rhombic(nose_radius, corner_angle, approach_angle, edge_length, |p| beside(p, shank)).of_hand(hand)
        }
        ToolShape::Boring { hand, nose_radius, corner_angle, approach_angle, edge_length } => {
            let outside = rhombic(nose_radius, corner_angle, approach_angle, edge_length, |p| along(p, shank));
            ToolOutline { kind: ToolKind::Boring, ..outside.upside_down() }.of_hand(hand)
        }
        ToolShape::Copying { nose_radius, corner_angle, edge_length } => {
            let polygon = insert::rhombus(corner_angle.to_radians(), edge_length, STRAIGHT);
            let behind =
                |p: &Polygon| shank.map_or_else(Contour::default, |s| holder::head(p, s.width, s.length, true));
            pointed(polygon, nose_radius, 8, ToolKind::Turning, behind)
        }
        ToolShape::Button { diameter } => {
            let disc = insert::round(diameter, 8);
            let under = |s: Shank| holder::under_disc(disc.nose_center, diameter, s.width, s.length, true);
            ToolOutline { holder: shank.map(under).unwrap_or_default(), ..disc }
        }
        ToolShape::Threading { nose_radius, corner_angle, edge_length, inside } => {
            let polygon = insert::triangle(corner_angle.to_radians(), edge_length, STRAIGHT);
            if inside {
                let bar = |p: &Polygon| along(p, shank);
                pointed(polygon, nose_radius, 8, ToolKind::BoreThreading, bar).upside_down()
            } else {
                pointed(polygon, nose_radius, 8, ToolKind::Threading, |p| beside(p, shank))
            }
        }
        ToolShape::Parting { hand, width, nose_radius, depth, inside } => {
            let blade = match shank {
                Some(shank) => blade(width, nose_radius, depth, shank, inside),
                None => insert::blade(width, nose_radius, depth, 0.0),
            };
            let turned =
                if inside { ToolOutline { kind: ToolKind::BoreGrooving, ..blade.upside_down() } } else { blade };
            turned.of_hand(hand)
        }
        ToolShape::Drill { diameter, point_angle, length, pecks_from } => ToolOutline {
            holder: holder::drill_sleeve(diameter, length),
            pecks_from,
            ..insert::drill(diameter, point_angle, length)
        },
        ToolShape::Outline { purpose, orientation, nose_radius, ref corners, ref cuts } => {
            free(purpose, orientation, nose_radius, corners, cuts)
        }
        ToolShape::Interference { hand, nose_radius, width, angle, margin } => {
            interference(nose_radius, width, angle, margin).of_hand(hand)
        }
    })
}

fn pointed(
    polygon: Polygon,
    nose_radius: f64,
    orientation: u8,
    kind: ToolKind,
    holder: impl Fn(&Polygon) -> Contour,
) -> ToolOutline {
    let (outline, polygon) = insert::pointed(polygon, nose_radius, orientation, kind);
    ToolOutline { holder: holder(&polygon), ..outline }
}

fn rhombic(
    nose_radius: f64,
    corner_angle: f64,
    approach_angle: f64,
    edge_length: f64,
    holder: impl Fn(&Polygon) -> Contour,
) -> ToolOutline {
    let polygon = insert::rhombus(corner_angle.to_radians(), edge_length, bisector(approach_angle, corner_angle));
    pointed(polygon, nose_radius, 3, ToolKind::Turning, holder)
}

/// A common head on the tool's shank.
fn beside(insert: &Polygon, shank: Option<Shank>) -> Contour {
    shank.map_or_else(Contour::default, |s| holder::head(insert, s.width, s.length, false))
}

/// The tool's bar.
fn along(insert: &Polygon, bar: Option<Shank>) -> Contour {
    bar.map_or_else(Contour::default, |s| holder::bar(insert, s.width, s.length))
}

fn blade(width: f64, nose_radius: f64, depth: f64, shank: Shank, inside: bool) -> ToolOutline {
    let insert = insert::blade_insert(width, nose_radius, depth);
    let insert_depth = insert.insert.bounds().map_or(depth, |b| b.max.r);
    let holder = if inside {
        holder::blade_bar(width, insert_depth, depth, shank.width, shank.length)
    } else {
        holder::blade(width, insert_depth, depth, shank.width, shank.length)
    };
    ToolOutline { holder, ..insert }
}

/// Insert and holder by their codes.
fn iso(tool: &IsoTool) -> ToolOutline {
    let IsoTool { insert, holder } = tool;
    let hand = holder.hand.unwrap_or_default();
    if let InsertForm::Round { diameter } = insert.form {
        return disc(diameter, holder.seat, holder.hand);
    }
    let corner_deg = match insert.form {
        InsertForm::Rhombus { corner_deg, .. } => corner_deg,
        InsertForm::Trigon { .. } => 80.0,
        _ => 60.0,
    };
    let bisector = holder.approach_deg.map_or(STRAIGHT, |approach| bisector(approach, corner_deg));
    let Some(polygon) = insert::polygon(insert.form, bisector) else { return ToolOutline::default() };
    let orientation = if holder.approach_deg.is_some() { 3 } else { 8 };
    let is_thread = insert.inside.is_some();
    match holder.seat {
        Seat::Shank { width, length } => {
            let kind = if is_thread { ToolKind::Threading } else { ToolKind::Turning };
            let straight = holder.hand.is_none();
            pointed(polygon, insert.nose_radius, orientation, kind, |p| holder::head(p, width, length, straight))
        }
        Seat::Bar { diameter } => {
            let kind = if is_thread { ToolKind::BoreThreading } else { ToolKind::Boring };
            let overhang = OVERHANG_IN_DIAMETERS * diameter;
            pointed(polygon, insert.nose_radius, orientation, kind, |p| holder::bar(p, diameter, overhang))
                .upside_down()
        }
    }
    .of_hand(hand)
}

fn disc(diameter: f64, seat: Seat, hand: Option<Hand>) -> ToolOutline {
    let disc = insert::round(diameter, if hand.is_none() { 8 } else { 3 });
    match seat {
        Seat::Shank { width, length } => {
            let holder = holder::under_disc(disc.nose_center, diameter, width, length, hand.is_none());
            ToolOutline { holder, ..disc }.of_hand(hand.unwrap_or_default())
        }
        Seat::Bar { diameter: bar } => {
            // A square about the disc stands for it where the bar is drawn.
            let square = insert::rhombus(std::f64::consts::FRAC_PI_2, diameter, STRAIGHT / 2.0);
            let holder = holder::bar(&square, bar, OVERHANG_IN_DIAMETERS * bar);
            let outline = ToolOutline { holder, kind: ToolKind::Boring, ..disc };
            outline.upside_down().of_hand(hand.unwrap_or_default())
        }
    }
}

fn free(kind: ToolKind, orientation: u8, nose_radius: f64, corners: &[[f64; 2]], cuts: &[usize]) -> ToolOutline {
    let points: Vec<Point> = corners.iter().map(|&[z, r]| Point::new(z, r)).collect();
    let chosen: Vec<bool> = (0..points.len()).map(|i| i == 0).collect();
    let segments = insert::rounded(&points, &chosen, nose_radius);
    let nose = usize::from(nose_radius > 0.0);
    let nose_center = match segments.first() {
        Some(&crate::geometry::Segment::Arc { center, .. }) => center,
        _ => points.first().copied().unwrap_or_default(),
    };
    let last = points.len().saturating_sub(1);
    let edge_cuts = |edge: usize| if cuts.is_empty() { edge == 0 || edge == last } else { cuts.contains(&edge) };
    let cutting = (0..segments.len()).map(|i| i.checked_sub(nose).is_none_or(edge_cuts)).collect();
    let insert = Contour::new(segments);
    ToolOutline { insert, kind, nose_radius, nose_center, orientation, cutting, ..ToolOutline::default() }
}

/// Front edge square to the spindle, flank at `angle` from the nose to the tool's width, body behind it.
fn interference(nose_radius: f64, width: f64, angle: f64, margin: f64) -> ToolOutline {
    let flank = angle.to_radians();
    let top = width * flank.tan();
    let corners = vec![Point::default(), Point::new(width, top), Point::new(0.0, top)];
    let polygon = Polygon { corners, nose_radius, rounded: vec![true, false, false], trailing_end: 1, leading_end: 2 };
    let body = |p: &Polygon| {
        let top = p.corners.last().map_or(top, |c| c.r);
        holder::behind_flank(width, top, margin, BODY_IN_WIDTHS * width)
    };
    pointed(polygon, nose_radius, 3, ToolKind::Turning, body)
}
