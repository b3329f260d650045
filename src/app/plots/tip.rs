//! A small tooltip drawn on a plot: one strong line and quiet ones below.

use super::lines::{clipped, faded};
use super::palette::Palette;
use egui::{Align2, FontId, Painter, Pos2, Rect, Vec2};

/// Room around the text, points.
const ROOM: Vec2 = Vec2::new(8.0, 5.0);
/// Distance above the place that it speaks of, points.
const ABOVE: f32 = 12.0;

/// What it costs to lie outside the plot or on the place itself: more than covering any line.
const OUTSIDE: f32 = 1e6;

/// Draws `lines` above `at`, or where there is room and it covers the least of the polylines `keep_free`.
pub(super) fn tip(painter: &Painter, palette: &Palette, at: Pos2, lines: &[String], keep_free: &[Vec<Pos2>]) {
    let galleys: Vec<_> = lines
        .iter()
        .enumerate()
        .map(|(k, line)| {
            let (size, strength) = if k == 0 { (11.5, 1.0) } else { (10.5, 0.72) };
            painter.layout_no_wrap(line.clone(), FontId::proportional(size), faded(palette.tip_text, strength))
        })
        .collect();
    let text = galleys.iter().fold(Vec2::ZERO, |room, g| Vec2::new(room.x.max(g.size().x), room.y + g.size().y));
    let rect = placed(painter.clip_rect(), at, text + 2.0 * ROOM, keep_free);
    painter.rect_filled(rect, 4.0, palette.tip);
    let mut place = rect.min + ROOM;
    for galley in galleys {
        let height = galley.size().y;
        painter.galley(place, galley, palette.tip_text);
        place.y += height;
    }
}

/// The tooltip's rectangle within `clip`: of the places around `at` the first of those that cover least of `keep_free`.
fn placed(clip: Rect, at: Pos2, size: Vec2, keep_free: &[Vec<Pos2>]) -> Rect {
    let places = [
        (Align2::CENTER_BOTTOM, Vec2::new(0.0, -ABOVE)),
        (Align2::LEFT_BOTTOM, Vec2::new(ABOVE, -ABOVE)),
        (Align2::RIGHT_BOTTOM, Vec2::new(-ABOVE, -ABOVE)),
        (Align2::CENTER_TOP, Vec2::new(0.0, ABOVE)),
        (Align2::LEFT_CENTER, Vec2::new(ABOVE, 0.0)),
        (Align2::RIGHT_CENTER, Vec2::new(-ABOVE, 0.0)),
        (Align2::LEFT_TOP, Vec2::new(ABOVE, ABOVE)),
        (Align2::RIGHT_TOP, Vec2::new(-ABOVE, ABOVE)),
    ];
    let rects = places.map(|(align, away)| within(clip, align.anchor_size(at + away, size)));
    let cost = |rect: &Rect| {
        let outside = if clip.contains_rect(*rect) { 0.0 } else { OUTSIDE };
        outside + covered(*rect, keep_free) + if rect.contains(at) { OUTSIDE } else { 0.0 }
    };
    rects.into_iter().min_by(|a, b| cost(a).total_cmp(&cost(b))).unwrap_or(rects[0])
}

/// `rect` moved sideways into `clip`.
fn within(clip: Rect, rect: Rect) -> Rect {
    let into = (clip.left() - rect.left()).max(0.0) - (rect.right() - clip.right()).max(0.0);
    rect.translate(Vec2::new(into, 0.0))
}

/// Length of the polylines under `rect`, points.
fn covered(rect: Rect, polylines: &[Vec<Pos2>]) -> f32 {
    let lines = polylines.iter().flat_map(|line| line.windows(2));
    lines.filter_map(|w| clipped(w[0], w[1], rect)).map(|[a, b]| a.distance(b)).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use egui::pos2;

    #[test]
    fn a_tip_stays_on_its_plot() {
        let clip = Rect::from_min_max(pos2(0.0, 0.0), pos2(300.0, 200.0));
        assert_eq!(placed(clip, pos2(150.0, 100.0), Vec2::new(80.0, 30.0), &[]).bottom(), 100.0 - ABOVE);
        assert_eq!(placed(clip, pos2(150.0, 10.0), Vec2::new(80.0, 30.0), &[]).top(), 10.0 + ABOVE);
        assert_eq!(placed(clip, pos2(299.0, 100.0), Vec2::new(80.0, 30.0), &[]).right(), 300.0);
        assert_eq!(placed(clip, pos2(1.0, 100.0), Vec2::new(80.0, 30.0), &[]).left(), 0.0);
    }
    #[test]
    fn a_tip_leaves_free_what_is_dragged() {
        let clip = Rect::from_min_max(pos2(0.0, 0.0), pos2(300.0, 200.0));
        let size = Vec2::new(80.0, 30.0);
        let steep = vec![vec![pos2(150.0, 100.0), pos2(155.0, 20.0)], vec![pos2(150.0, 100.0), pos2(60.0, 130.0)]];
        let rect = placed(clip, pos2(150.0, 100.0), size, &steep);
        assert_eq!(covered(rect, &steep), 0.0);
        assert!(clip.contains_rect(rect));
        assert!(covered(placed(clip, pos2(150.0, 100.0), size, &[]), &steep) > 0.0);
    }
}
