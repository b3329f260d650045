//! How the flower looks: quiet shapes, one that stands out, and that one after release.

use super::FlowerScene;
use crate::app::plots::canvas::Screen;
use crate::app::plots::lines::{CENTRE_LINE, DASHED, dashed, faded, thinned};
use crate::geometry::{Contour, Point, Vector};
use crate::rollform::bends::Stage;
use crate::rollform::strip::Strip;
use egui::{Align2, Color32, FontId, Painter, Pos2, Shape, Stroke, pos2};

/// Least width of the strip that stands out, points.
const LEAST_WIDTH: f32 = 2.4;

/// All shapes at their places.
pub(super) fn shapes(painter: &Painter, screen: &Screen, scene: &FlowerScene<'_>, places: &[Vector]) {
    if !scene.side_by_side {
        centre_line(painter, screen, scene);
    }
    for (shape, place) in scene.flower.shapes.iter().zip(places) {
        let stands_out = scene.side_by_side && scene.stage == Some(shape.stage);
        if stands_out {
            strong(painter, screen, scene, &shape.strip, *place);
        } else {
            let points = on_screen(screen, &shape.strip.mean(), *place);
            painter.add(Shape::line(points, Stroke::new(1.2, color(scene, shape.stage))));
        }
        if scene.side_by_side {
            label(painter, screen, scene, &shape.strip, *place, &stage_name(shape.stage), stands_out);
        }
    }
    if scene.side_by_side {
        return;
    }
    strong(painter, screen, scene, scene.shown, Vector::zeros());
    if let Some(released) = scene.released {
        let points = on_screen(screen, &released.mean(), Vector::zeros());
        dashed(painter, &points, DASHED, Stroke::new(1.4, scene.palette.wrong));
    }
}

/// What a stage is called on its button.
pub(super) fn stage_name(stage: Stage) -> String {
    match stage {
        Stage::Flat => "flat".to_owned(),
        Stage::Station(index) => (index + 1).to_string(),
        Stage::Finished => "final".to_owned(),
    }
}

fn color(scene: &FlowerScene<'_>, stage: Stage) -> Color32 {
    match stage {
        Stage::Flat => faded(scene.palette.construction, 0.6),
        Stage::Station(_) => faded(scene.palette.accent, 0.5),
        Stage::Finished => scene.palette.quiet,
    }
}

/// The strip in its own thickness, with the selected element in it.
fn strong(painter: &Painter, screen: &Screen, scene: &FlowerScene<'_>, strip: &Strip, place: Vector) {
    #[allow(clippy::cast_possible_truncation, reason = "widths on the screen are f32 in egui")]
    let width = ((strip.thickness * screen.scale()) as f32).max(LEAST_WIDTH);
    painter.add(Shape::line(on_screen(screen, &strip.mean(), place), Stroke::new(width, scene.palette.accent)));
    for piece in strip.pieces.iter().filter(|piece| Some(piece.element) == scene.selected) {
        let points = on_screen(screen, &Contour::new(vec![piece.mean]), place);
        painter.add(Shape::line(points, Stroke::new(width + 1.5, scene.palette.text)));
    }
}

fn on_screen(screen: &Screen, contour: &Contour, place: Vector) -> Vec<Pos2> {
    thinned(contour.polyline(screen.tolerance()).into_iter().map(|p| screen.pos(p + place)))
}

fn centre_line(painter: &Painter, screen: &Screen, scene: &FlowerScene<'_>) {
    let x = screen.pos(Point::default()).x;
    let ends = [pos2(x, screen.rect.top() + 6.0), pos2(x, screen.rect.bottom() - 6.0)];
    dashed(painter, &ends, CENTRE_LINE, Stroke::new(1.0, scene.palette.construction));
}

fn label(
    painter: &Painter,
    screen: &Screen,
    scene: &FlowerScene<'_>,
    strip: &Strip,
    place: Vector,
    text: &str,
    strong: bool,
) {
    let Some(bounds) = strip.mean().bounds() else { return };
    let middle = screen.pos(Point::new(f64::midpoint(bounds.min.z, bounds.max.z), bounds.min.r) + place);
    let color = if strong { scene.palette.accent } else { scene.palette.quiet };
    painter.text(middle + egui::vec2(0.0, 8.0), Align2::CENTER_TOP, text, FontId::proportional(11.0), color);
}
