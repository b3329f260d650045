//! The part in the round: a surface of revolution, shaded on the CPU into one mesh.
//!
//! Turn by dragging, zoom with the wheel; with the focus, arrow keys turn and `+` `-` zoom; double click or `F` resets.

use super::canvas::arrow;
use super::cut::stock_ring_at;
use super::lines::faded;
use super::palette::Palette;
use super::profile::draw::Lines;
use crate::geometry::{Point, Vector};
use crate::part::PartContour;
use crate::proof::ProofReport;
use crate::regen::SetupDerived;
use egui::{Align2, Color32, Event, EventFilter, FontId, Key, Mesh, Painter, Pos2, Rect, Response, Sense, Ui, Vec2};
use nalgebra::{Point3, Rotation3, Vector3};
use std::f64::consts::{FRAC_PI_2, TAU};
use std::sync::Arc;

/// Quads around the axis.
const AROUND: usize = 72;
/// Rings along the part at most: with [`AROUND`] about 20,000 triangles.
const ALONG: usize = 140;
/// Chords of the outline in relation to its length.
const CHORDS: f64 = 1e-3;
/// Turn for one point of a drag, radians.
const DRAG: f64 = 0.009;
/// Turn for one press of an arrow key, radians.
const KEY_TURN: f64 = 0.15;
/// Factor of the scale for one press of `+`.
const KEY_ZOOM: f64 = 1.15;
/// Share of the view that the whole part fills.
const FILLED: f64 = 0.88;
/// Smallest and largest zoom, 1 shows the whole part.
const ZOOMS: (f64, f64) = (0.3, 12.0);
/// Shares of the light: from everywhere, from the lamp at the left above, from the viewer.
const LIGHT: [f64; 3] = [0.30, 0.42, 0.28];

/// What the view in the round shows.
pub struct SolidScene<'a> {
    /// Everything that follows for the set-up shown.
    pub derived: &'a SetupDerived,
    /// Show the stock at this time of the programs, s, instead of the finished part.
    pub stock_at_s: Option<f64>,
    /// Colours.
    pub palette: &'a Palette,
}

/// From where a body is seen.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Pose {
    /// Turn about the upright axis of the screen, radians.
    pub turn: f64,
    /// Tilt towards the viewer, radians.
    pub tilt: f64,
    /// 1 shows all of it.
    pub zoom: f64,
}

impl Default for Pose {
    fn default() -> Self {
        Self { turn: -0.55, tilt: 0.38, zoom: 1.0 }
    }
}

impl Pose {
    /// To the viewer's space: x right, y up, z towards the viewer.
    pub(super) fn rotation(&self) -> Rotation3<f64> {
        Rotation3::from_axis_angle(&Vector3::x_axis(), self.tilt)
            * Rotation3::from_axis_angle(&Vector3::y_axis(), self.turn)
    }
}

/// What the view in the round keeps from frame to frame.
#[derive(Debug, Default)]
pub struct SolidView {
    pose: Pose,
    made: Option<(Key3d, Arc<Mesh>)>,
}

/// Everything that a mesh follows from.
#[derive(Debug, Clone)]
struct Key3d {
    contour: Arc<PartContour>,
    bore: Arc<Option<PartContour>>,
    proof: Arc<ProofReport>,
    stock: Option<usize>,
    pose: Pose,
    rect: Rect,
    color: Color32,
}

impl PartialEq for Key3d {
    fn eq(&self, other: &Self) -> bool {
        // The proof matters only where its stock is shown.
        let same_stock = self.stock.is_none() || Arc::ptr_eq(&self.proof, &other.proof);
        Arc::ptr_eq(&self.contour, &other.contour)
            && Arc::ptr_eq(&self.bore, &other.bore)
            && same_stock
            && (self.stock, self.pose, self.rect, self.color) == (other.stock, other.pose, other.rect, other.color)
    }
}

/// Shows the part in the room that is left in `ui`.
pub fn solid_view(ui: &mut Ui, view: &mut SolidView, scene: &SolidScene<'_>) {
    let response = ui.allocate_response(ui.available_size().max(Vec2::splat(40.0)), Sense::click_and_drag());
    let name = format!("{} in the round", scene.derived.name);
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Canvas, true, &name));
    turn_by_hand(ui, &mut view.pose, Pose::default(), &response);
    let stock = scene.stock_at_s.map(|time_s| super::cut::stock_index_at(scene.derived, time_s));
    let key = Key3d {
        contour: Arc::clone(&scene.derived.contour),
        bore: Arc::clone(&scene.derived.bore),
        proof: Arc::clone(&scene.derived.proof),
        stock,
        pose: view.pose,
        rect: response.rect,
        color: if stock.is_some() { scene.palette.stock_edge } else { scene.palette.part_solid() },
    };
    let painter = ui.painter_at(response.rect);
    match &view.made {
        Some((made_for, mesh)) if *made_for == key => _ = painter.add(Arc::clone(mesh)),
        _ => {
            let mesh = Arc::new(build(scene.derived, &key));
            painter.add(Arc::clone(&mesh));
            view.made = Some((key, mesh));
        }
    }
    hint(&painter, response.rect, faded(scene.palette.quiet, 0.9));
}

/// Says how the view is turned.
pub(super) fn hint(painter: &Painter, rect: Rect, color: Color32) {
    let text = "drag turns · wheel zooms · double click resets";
    painter.text(
        rect.left_bottom() + Vec2::new(8.0, -6.0),
        Align2::LEFT_BOTTOM,
        text,
        FontId::proportional(10.5),
        color,
    );
}

/// Turns a view as the person does; `home` is where a double click brings it.
pub(super) fn turn_by_hand(ui: &Ui, view: &mut Pose, home: Pose, response: &Response) {
    if response.dragged() {
        let delta = response.drag_delta();
        view.turn += f64::from(delta.x) * DRAG;
        view.tilt += f64::from(delta.y) * DRAG;
    }
    if response.clicked() {
        response.request_focus();
    }
    if response.double_clicked() {
        *view = home;
    }
    if ui.rect_contains_pointer(response.rect) {
        let (scroll, pinch) = ui.input(|i| (i.smooth_scroll_delta().y, i.zoom_delta()));
        view.zoom *= (f64::from(scroll) / 250.0).exp() * f64::from(pinch);
    }
    if response.has_focus() {
        let filter = EventFilter { horizontal_arrows: true, vertical_arrows: true, ..EventFilter::default() };
        ui.memory_mut(|m| m.set_focus_lock_filter(response.id, filter));
        ui.input(|i| i.events.iter().for_each(|event| turn_by_key(view, home, event)));
    }
    view.tilt = view.tilt.clamp(-FRAC_PI_2, FRAC_PI_2);
    view.zoom = view.zoom.clamp(ZOOMS.0, ZOOMS.1);
}

fn turn_by_key(view: &mut Pose, home: Pose, event: &Event) {
    let Event::Key { key, pressed: true, modifiers, .. } = event else { return };
    if modifiers.command || modifiers.alt {
        return;
    }
    match key {
        Key::Plus | Key::Equals => view.zoom *= KEY_ZOOM,
        Key::Minus => view.zoom /= KEY_ZOOM,
        Key::F => *view = home,
        _ => {
            let way = arrow(*key).unwrap_or_default();
            view.turn += f64::from(way.x) * KEY_TURN;
            view.tilt += f64::from(way.y) * KEY_TURN;
        }
    }
}

fn build(derived: &SetupDerived, key: &Key3d) -> Mesh {
    let outline = match key.stock {
        Some(index) => stock_ring_at(derived, index, derived.setup.chuck_face_z),
        None => Lines::of(derived, CHORDS * derived.setup.length.max(1.0)).outline(),
    };
    revolve(&outline, key.pose, key.rect, key.color)
}

/// The surface that `outline` sweeps about the spindle axis, seen in `rect`, nearest faces last.
///
/// The outline runs from the axis to the axis with the material on its right hand.
fn revolve(outline: &[Point], view: Pose, rect: Rect, color: Color32) -> Mesh {
    let outline = reduced(outline);
    let mut mesh = Mesh::default();
    let Some(bounds) = crate::geometry::Bounds::around(outline.iter().copied().filter(|p| p.is_finite())) else {
        return mesh;
    };
    let middle = f64::midpoint(bounds.min.z, bounds.max.z);
    let across = Vector::new(bounds.max.z - bounds.min.z, 2.0 * bounds.max.r).norm().max(1e-9);
    // The height at this tilt, however the part is turned: a scale that followed the turn would breathe.
    let tall = 2.0 * bounds.max.r * view.tilt.cos().abs() + across * view.tilt.sin().abs();
    let scale = (f64::from(rect.width()) / across).min(f64::from(rect.height()) / tall.max(1e-9)) * FILLED * view.zoom;
    let pose = view.rotation();
    let mut faces: Vec<Face> = outline
        .windows(2)
        .flat_map(|pair| (0..AROUND).filter_map(move |k| Face::new(pair, k, middle, &pose)))
        .collect();
    faces.sort_by(|a, b| a.depth.total_cmp(&b.depth));
    for face in faces {
        face.add_to(&mut mesh, rect, scale, color);
    }
    mesh
}

/// One quad of the surface, turned to the viewer's space: x right, y up, z towards the viewer.
struct Face {
    corners: [Point3<f64>; 4],
    depth: f64,
    light: f64,
}

impl Face {
    /// The quad between two points of the outline at one step around; `None` if its back is seen.
    fn new(pair: &[Point], step: usize, middle: f64, pose: &Rotation3<f64>) -> Option<Self> {
        let [a, b] = pair else { return None };
        let angle = |k: usize| k as f64 / AROUND as f64 * TAU;
        let place = |p: &Point, angle: f64| pose * Point3::new(p.z - middle, p.r * angle.cos(), p.r * angle.sin());
        let (from, to, half) = (angle(step), angle(step + 1), angle(step) + TAU / AROUND as f64 / 2.0);
        let corners = [place(a, from), place(b, from), place(b, to), place(a, to)];
        // The normal of the outline turned up from its direction, swept to the middle of the step.
        let normal = Vector::new(-(b.r - a.r), b.z - a.z).try_normalize(0.0)?;
        let normal = pose * Vector3::new(normal.x, normal.y * half.cos(), normal.y * half.sin());
        let depth = corners.iter().map(|c| c.z).sum::<f64>() / 4.0;
        let light = lit(&normal);
        (normal.z > -1e-3).then_some(Self { corners, depth, light })
    }

    #[allow(clippy::cast_possible_truncation, reason = "screen positions and colours are f32 in egui")]
    fn add_to(&self, mesh: &mut Mesh, rect: Rect, scale: f64, color: Color32) {
        let shade = shaded(color, self.light as f32);
        let Ok(first) = u32::try_from(mesh.vertices.len()) else { return };
        for corner in &self.corners {
            let by = Vec2::new((corner.x * scale) as f32, (-corner.y * scale) as f32);
            let pos: Pos2 = rect.center() + by;
            mesh.colored_vertex(pos, shade);
        }
        mesh.add_triangle(first, first + 1, first + 2);
        mesh.add_triangle(first, first + 2, first + 3);
    }
}

/// Light on a surface with this normal in the viewer's space, 0 to 1.
pub(super) fn lit(normal: &Vector3<f64>) -> f64 {
    let lamp = normal.dot(&Vector3::new(-0.35, 0.7, 0.62)).max(0.0);
    LIGHT[0] + LIGHT[1] * lamp + LIGHT[2] * normal.z.max(0.0)
}

/// `color` under `light` from 0 to 1.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped to 0..=255")]
pub(super) fn shaded(color: Color32, light: f32) -> Color32 {
    let part = |c: u8| (f32::from(c) * light).clamp(0.0, 255.0) as u8;
    Color32::from_rgb(part(color.r()), part(color.g()), part(color.b()))
}

/// At most [`ALONG`] of the points, first and last among them, evenly taken.
fn reduced(outline: &[Point]) -> Vec<Point> {
    let stride = outline.len().div_ceil(ALONG).max(1);
    let last = outline.len().checked_sub(1);
    let kept = outline.iter().enumerate().filter(|(k, _)| k % stride == 0 || Some(*k) == last);
    kept.map(|(_, p)| *p).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use egui::pos2;

    const RECT: Rect = Rect { min: pos2(0.0, 0.0), max: pos2(400.0, 200.0) };

    const LEVEL: Pose = Pose { turn: 0.0, tilt: 0.0, zoom: 1.0 };

    fn cylinder() -> Vec<Point> {
        [(0.0, 0.0), (0.0, 10.0), (40.0, 10.0), (40.0, 0.0)].map(|(z, r)| Point::new(z, r)).to_vec()
    }

    #[test]
    fn about_half_of_a_cylinder_is_seen() {
        let mesh = revolve(&cylinder(), LEVEL, RECT, Color32::WHITE);
        let seen = mesh.indices.len() / 6;
        assert!((AROUND / 2..=2 * AROUND + AROUND / 2 + 2).contains(&seen), "{seen}");
        assert!(mesh.is_valid());
    }

    #[test]
    fn everything_stays_in_view_however_it_is_turned() {
        for turn in [-2.0, 0.0, 0.7, 3.0] {
            let mesh = revolve(&cylinder(), Pose { turn, tilt: 0.5, zoom: 1.0 }, RECT, Color32::WHITE);
            assert!(mesh.vertices.iter().all(|v| RECT.contains(v.pos)));
        }
    }

    #[test]
    fn an_outline_without_points_is_no_surface() {
        assert!(revolve(&[], LEVEL, RECT, Color32::WHITE).is_empty());
        let broken = [Point::new(f64::NAN, 1.0), Point::new(f64::NAN, 2.0)];
        assert!(revolve(&broken, LEVEL, RECT, Color32::WHITE).is_empty());
    }

    #[test]
    fn long_outlines_are_reduced_with_their_ends() {
        let many: Vec<Point> = (0..5000_i16).map(|k| Point::new(f64::from(k), 1.0)).collect();
        let kept = reduced(&many);
        assert!(kept.len() <= ALONG + 1);
        assert_eq!((kept.first(), kept.last()), (many.first(), many.last()));
    }
}
