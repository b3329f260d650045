//! Areas that a tool cannot reach: hatched, with their tool on hover.

use super::draw::on_screen;
use super::{Frame, ProfileScene};
use crate::app::plots::lines::{DASHED, dashed, faded};
use crate::turning::UnreachableArea;
use egui::{Painter, Pos2, Rect, Shape, Stroke};

/// Distance of hatch lines, points.
const SPACING: f32 = 6.0;

/// Draws all areas; one that no tool can reach stronger than one that only some tool cannot.
pub(super) fn hatches(painter: &Painter, frame: &Frame<'_>) {
    let (screen, scene) = (&frame.screen, frame.scene);
    for area in scene.derived.unreachable.iter() {
        let strength = if area.tool.is_none() { 1.0 } else { 0.55 };
        let stroke = Stroke::new(1.0, faded(scene.palette.unreachable, strength));
        let mut outline = on_screen(screen, &area.outline);
        let lines = hatch_lines(&outline, SPACING, painter.clip_rect());
        let thin = Stroke::new(0.7, faded(stroke.color, 0.6));
        painter.extend(lines.into_iter().map(|line| Shape::line_segment(line, thin)));
        outline.extend(outline.first().copied());
        dashed(painter, &outline, DASHED, stroke);
    }
}

/// What the area under the pointer says, if there is one.
pub(super) fn hover_text(frame: &Frame<'_>, pos: Pos2) -> Option<[String; 2]> {
    let (screen, scene) = (&frame.screen, frame.scene);
    let contains = |area: &&UnreachableArea| inside(&on_screen(screen, &area.outline), pos);
    let area = scene.derived.unreachable.iter().find(contains)?;
    let who = area.tool.map_or_else(|| "No tool".to_owned(), |station| tool_name(scene, station));
    let height = area.height_mm / scene.unit.in_mm();
    let (decimals, symbol) = (scene.unit.decimals(), scene.unit.symbol());
    Some([format!("{who} cannot reach this area"), format!("up to {height:.decimals$} {symbol} stays on the part")])
}

fn tool_name(scene: &ProfileScene<'_>, station: u32) -> String {
    let tools = scene.machine.map_or(&[][..], |m| &m.tools);
    let tool = tools.iter().find(|t| t.station == station);
    tool.map_or_else(|| format!("Tool {station}"), |t| format!("Tool {station}, {},", t.tool))
}

/// Lines at 45° inside a polygon, `spacing` points apart, within `clip`.
///
/// Line k is where x + y = k·spacing·√2, so the hatching of neighbouring areas runs on and stays while points move.
fn hatch_lines(polygon: &[Pos2], spacing: f32, clip: Rect) -> Vec<[Pos2; 2]> {
    let step = spacing * std::f32::consts::SQRT_2;
    let shown = Rect::from_points(polygon).intersect(clip);
    let mut lines = Vec::new();
    if !shown.is_positive() {
        return lines;
    }
    let mut sum = ((shown.min.x + shown.min.y) / step).ceil() * step;
    while sum <= shown.max.x + shown.max.y {
        let mut crossings: Vec<Pos2> = edges(polygon).filter_map(|(a, b)| crossing(a, b, sum)).collect();
        crossings.sort_by(|a, b| a.x.total_cmp(&b.x));
        lines.extend(crossings.chunks_exact(2).map(|pair| [pair[0], pair[1]]));
        sum += step;
    }
    lines
}

fn edges(polygon: &[Pos2]) -> impl Iterator<Item = (Pos2, Pos2)> {
    polygon.iter().copied().zip(polygon.iter().copied().cycle().skip(1))
}

/// Where the line from a to b crosses x + y = sum; the end counts as crossed, the start does not.
fn crossing(a: Pos2, b: Pos2, sum: f32) -> Option<Pos2> {
    let (from, to) = (a.x + a.y - sum, b.x + b.y - sum);
    ((from < 0.0) != (to < 0.0)).then(|| a + (b - a) * (from / (from - to)))
}

/// True if `pos` lies inside the polygon (even-odd rule).
fn inside(polygon: &[Pos2], pos: Pos2) -> bool {
    let left = |a: Pos2, b: Pos2| a.x + (pos.y - a.y) / (b.y - a.y) * (b.x - a.x) > pos.x;
    edges(polygon).filter(|&(a, b)| (a.y > pos.y) != (b.y > pos.y) && left(a, b)).count() % 2 == 1
}

#[cfg(test)]
mod tests {
    use super::*;
    use egui::pos2;

    const CLIP: Rect = Rect { min: pos2(-1e4, -1e4), max: pos2(1e4, 1e4) };

    /// An L: the square 0..40 without its quarter at the largest x and y.
    fn ell() -> Vec<Pos2> {
        [(0.0, 0.0), (40.0, 0.0), (40.0, 20.0), (20.0, 20.0), (20.0, 40.0), (0.0, 40.0)]
            .map(|(x, y)| pos2(x, y))
            .to_vec()
    }

    #[test]
    fn hatching_covers_its_share_and_stays_inside() {
        let lines = hatch_lines(&ell(), 2.0, CLIP);
        let length: f32 = lines.iter().map(|l| l[0].distance(l[1])).sum();
        assert!((length * 2.0 - 1200.0).abs() < 80.0, "length times spacing is the area");
        for [a, b] in lines {
            assert!(inside(&ell(), a + (b - a) * 0.5));
        }
    }

    #[test]
    fn what_is_off_the_screen_is_not_hatched() {
        let far: Vec<Pos2> = ell().iter().map(|p| *p + egui::vec2(5e4, 0.0)).collect();
        assert!(hatch_lines(&far, 2.0, CLIP).is_empty());
    }

    #[test]
    fn inside_knows_the_notch_of_an_ell() {
        assert!(inside(&ell(), pos2(10.0, 30.0)));
        assert!(!inside(&ell(), pos2(30.0, 30.0)));
    }
}
