//! A small tooltip drawn on a plot: one strong line and quiet ones below.

use super::lines::faded;
use super::palette::Palette;
use egui::{Align2, FontId, Painter, Pos2, Rect, Vec2};

/// Room around the text, points.
const ROOM: Vec2 = Vec2::new(8.0, 5.0);
/// Distance above the place that it speaks of, points.
const ABOVE: f32 = 12.0;

/// Draws `lines` above `at`, or below where there is no room.
pub(super) fn tip(painter: &Painter, palette: &Palette, at: Pos2, lines: &[String]) {
    let galleys: Vec<_> = lines
        .iter()
        .enumerate()
        .map(|(k, line)| {
            let (size, strength) = if k == 0 { (11.5, 1.0) } else { (10.5, 0.72) };
            painter.layout_no_wrap(line.clone(), FontId::proportional(size), faded(palette.tip_text, strength))
        })
        .collect();
    let text = galleys.iter().fold(Vec2::ZERO, |room, g| Vec2::new(room.x.max(g.size().x), room.y + g.size().y));
    let rect = placed(painter.clip_rect(), at, text + 2.0 * ROOM);
    painter.rect_filled(rect, 4.0, palette.tip);
    let mut place = rect.min + ROOM;
    for galley in galleys {
        let height = galley.size().y;
        painter.galley(place, galley, palette.tip_text);
        place.y += height;
    }
}

/// The tooltip's rectangle: above `at`, or below, and within `clip`.
fn placed(clip: Rect, at: Pos2, size: Vec2) -> Rect {
    let above = Align2::CENTER_BOTTOM.anchor_size(at - Vec2::new(0.0, ABOVE), size);
    let below = Align2::CENTER_TOP.anchor_size(at + Vec2::new(0.0, ABOVE), size);
    let rect = if above.top() >= clip.top() { above } else { below };
    let into = (clip.left() - rect.left()).max(0.0) - (rect.right() - clip.right()).max(0.0);
    rect.translate(Vec2::new(into, 0.0))
}

#[cfg(test)]
mod tests {
    use super::*;
    use egui::pos2;

    #[test]
    fn a_tip_stays_on_its_plot() {
        let clip = Rect::from_min_max(pos2(0.0, 0.0), pos2(300.0, 200.0));
        assert_eq!(placed(clip, pos2(150.0, 100.0), Vec2::new(80.0, 30.0)).bottom(), 100.0 - ABOVE);
        assert_eq!(placed(clip, pos2(150.0, 10.0), Vec2::new(80.0, 30.0)).top(), 10.0 + ABOVE);
        assert_eq!(placed(clip, pos2(299.0, 100.0), Vec2::new(80.0, 30.0)).right(), 300.0);
        assert_eq!(placed(clip, pos2(1.0, 100.0), Vec2::new(80.0, 30.0)).left(), 0.0);
    }
}
