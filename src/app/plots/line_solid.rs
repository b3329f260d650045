//! Rolls and strip of a station in the round, and the strip through the whole line.
//!
//! Space: x across the line to the right, y the height, z against the run of the strip, towards somebody who looks along it.
//! Turn by dragging, zoom with the wheel; with the focus, arrow keys turn and `+` `-` zoom; double click or `F` resets.

use super::depth::{self, Facet};
use super::lines::faded;
use super::palette::Palette;
use super::solid::{Pose, hint, lit, shaded, turn_by_hand};
use crate::document::{RollKind, RollRef};
use crate::geometry::Point;
use crate::rollform::loft::LoftSection;
use crate::rollform::{Roll, StationDesign};
use egui::{Align2, Color32, FontId, Pos2, Rect, Sense, TextureHandle, TextureOptions, Ui, Vec2, pos2};
use nalgebra::{Point3, Rotation3, Vector3};
use std::f64::consts::TAU;

/// Faces around a roll.
const AROUND: u32 = 96;
/// Chords of a roll's contour, mm.
const CHORD_MM: f64 = 0.05;
/// Share of the view that everything fills.
const FILLED: f64 = 0.9;
/// Half the length of the strip that a station shows, in largest radii of its rolls.
const STRIP_RADII: f64 = 1.6;
/// How much of the accent colour a roll has that stands out.
const STANDS_OUT: f32 = 0.55;
/// Size of the numbers of the stations, points.
const TEXT: f32 = 11.0;

/// What is shown.
#[derive(Clone, Copy)]
pub enum LineSubject<'a> {
    /// Rolls and strip of a station.
    Station {
        /// The station.
        design: &'a StationDesign,
        /// The roll that stands out.
        roll: Option<RollRef>,
        /// Diameter of the bore of a roll, mm.
        bore_mm: &'a dyn Fn(RollKind) -> f64,
    },
    /// The strip through the line.
    Line {
        /// Its cross-sections.
        sections: &'a [LoftSection],
    },
}

/// What the view keeps from frame to frame.
#[derive(Default)]
pub struct LineSolidView {
    station: Pose,
    line: Option<Pose>,
    made: Option<Made>,
}

impl std::fmt::Debug for LineSolidView {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("LineSolidView")
            .field("station", &self.station)
            .field("line", &self.line)
            .finish_non_exhaustive()
    }
}

/// A picture, and where numbers of stations stand in it, in pixels.
struct Made {
    key: Key,
    marks: Vec<(Pos2, usize)>,
    texture: TextureHandle,
}

/// Everything that a picture follows from.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Key {
    subject: u64,
    pose: Pose,
    size: [usize; 2],
    dark: bool,
}

/// How the line is seen at first: from its end, where the strip is formed, and from above.
const LINE_POSE: Pose = Pose { turn: std::f64::consts::PI - 0.8, tilt: 0.42, zoom: 1.0 };
/// A line is drawn at most so many times as long as its strip is wide: at full length nothing of its bends could be seen.
const LONGEST: f64 = 2.6;
/// Strength of the colour of every second way from station to station.
const SECOND: f32 = 0.82;

/// Shows `subject` in the room that is left in `ui`. `version` is another one whenever the subject is.
pub fn line_solid(ui: &mut Ui, view: &mut LineSolidView, subject: LineSubject<'_>, version: u64, palette: &Palette) {
    let response = ui.allocate_response(ui.available_size().max(Vec2::splat(40.0)), Sense::click_and_drag());
    let (name, pose, home) = match subject {
        LineSubject::Station { .. } => ("Station in the round", &mut view.station, Pose::default()),
        LineSubject::Line { .. } => {
            ("Strip through the line in the round", view.line.get_or_insert(LINE_POSE), LINE_POSE)
        }
    };
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Canvas, true, name));
    turn_by_hand(ui, pose, home, &response);
    let finer = ui.ctx().pixels_per_point();
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "sizes on the screen are small")]
    let pixels = |points: f32| (points * finer).round().max(1.0) as usize;
    let size = [pixels(response.rect.width()), pixels(response.rect.height())];
    let key = Key { subject: version, pose: *pose, size, dark: palette.dark };
    if view.made.as_ref().is_none_or(|made| made.key != key) {
        let scene = Scene::of(subject, palette);
        let placed = Placed::of(&scene, *pose, size);
        let picture = depth::drawn(&placed.facets(&scene), size);
        let texture = ui.ctx().load_texture("line in the round", picture, TextureOptions::LINEAR);
        let marks = scene.marks.iter().map(|(at, number)| (placed.on_screen(at), *number)).collect();
        view.made = Some(Made { key, marks, texture });
    }
    let painter = ui.painter_at(response.rect);
    if let Some(Made { marks, texture, .. }) = &view.made {
        let whole = Rect::from_min_max(pos2(0.0, 0.0), pos2(1.0, 1.0));
        painter.image(texture.id(), response.rect, whole, Color32::WHITE);
        for (at, number) in marks {
            let at = response.rect.min + at.to_vec2() / finer;
            painter.text(at, Align2::CENTER_BOTTOM, number.to_string(), FontId::proportional(TEXT), palette.text);
        }
    }
    hint(&painter, response.rect, faded(palette.quiet, 0.9));
}

/// A four-cornered face in space, and a direction out of the body there.
struct Face {
    corners: [Point3<f64>; 4],
    outwards: Vector3<f64>,
    color: Color32,
}

/// Faces, and where stations are named.
#[derive(Default)]
struct Scene {
    faces: Vec<Face>,
    marks: Vec<(Point3<f64>, usize)>,
}

impl Scene {
    fn of(subject: LineSubject<'_>, palette: &Palette) -> Self {
        let mut scene = Self::default();
        match subject {
            LineSubject::Station { design, roll, bore_mm } => {
                for each in &design.rolls {
                    let plain = palette.part_solid();
                    let shown = plain.lerp_to_gamma(palette.accent, STANDS_OUT);
                    let color = if roll == Some(each.roll) { shown } else { plain };
                    scene.roll(each, bore_mm(each.roll.kind) / 2.0, color);
                }
                scene.strip_of(design, palette.wrong);
            }
            LineSubject::Line { sections } => scene.line(&shortened(sections), palette.wrong),
        }
        scene
    }

    /// A roll with its bore.
    fn roll(&mut self, roll: &Roll, bore: f64, color: Color32) {
        let contour = roll.contour().polyline(CHORD_MM);
        let hollow = |p: &Point| Point::new(p.z, p.r.max(bore));
        let mut ring: Vec<Point> = contour.iter().map(hollow).collect();
        if let Some(first) = ring.first().copied().filter(|_| bore > 0.0) {
            ring.push(first);
        }
        for pair in ring.windows(2) {
            let [a, b] = pair else { continue };
            let normal = Point::new(-(b.r - a.r), b.z - a.z);
            for step in 0..AROUND {
                let angle = |k: u32| f64::from(k) / f64::from(AROUND) * TAU;
                let at = |p: &Point, angle: f64| in_space(roll, *p, angle);
                let (from, to) = (angle(step), angle(step + 1));
                let middle = f64::midpoint(from, to);
                let outwards = in_space(roll, normal, middle) - in_space(roll, Point::default(), middle);
                self.faces.push(Face { corners: [at(a, from), at(b, from), at(b, to), at(a, to)], outwards, color });
            }
        }
    }

    /// The strip of a station, as far before and behind its axes as its rolls are large.
    fn strip_of(&mut self, design: &StationDesign, color: Color32) {
        /// Pieces along the line, so that no face is long.
        const PIECES: u32 = 2;
        let largest = |roll: &Roll| roll.contour().bounds().map_or(0.0, |b| b.max.r);
        let half = design.rolls.iter().map(largest).fold(0.0, f64::max) * STRIP_RADII;
        let half = if half > 0.0 { half } else { design.strip.mean_length() };
        let (bottom, top) = faces_of(design);
        let sections: Vec<LoftSection> = (0..=PIECES)
            .map(|k| LoftSection {
                along: half * (2.0 * f64::from(k) / f64::from(PIECES) - 1.0),
                station: None,
                bottom: bottom.clone(),
                top: top.clone(),
            })
            .collect();
        self.strip(&sections, color);
    }

    /// The strip through the line, from station to station in two tones, with the stations' numbers at its edge.
    fn line(&mut self, sections: &[LoftSection], color: Color32) {
        let starts: Vec<usize> =
            (0..sections.len()).filter(|k| sections.get(*k).is_some_and(|s| s.station.is_some())).collect();
        let ends = starts.iter().copied().chain([sections.len().saturating_sub(1)]);
        let mut from = 0;
        for (number, to) in ends.enumerate() {
            let tone = if number % 2 == 1 { super::solid::shaded(color, SECOND) } else { color };
            self.body(sections.get(from..=to).unwrap_or_default(), tone);
            from = to;
        }
        self.ends(sections, color);
        let named = sections.iter().filter_map(|s| Some((s, s.station?)));
        self.marks.extend(named.filter_map(|(s, station)| {
            let edge = s.top.last()?;
            Some((Point3::new(edge.z, edge.r, -s.along), station + 1))
        }));
    }

    /// The body between cross-sections, with its ends.
    fn strip(&mut self, sections: &[LoftSection], color: Color32) {
        self.body(sections, color);
        self.ends(sections, color);
    }

    /// The body between cross-sections: both faces and both edges.
    fn body(&mut self, sections: &[LoftSection], color: Color32) {
        let at = |s: &LoftSection, p: &Point| Point3::new(p.z, p.r, -s.along);
        for pair in sections.windows(2) {
            let [a, b] = pair else { continue };
            for (faces, other) in [((&a.bottom, &b.bottom), &a.top), ((&a.top, &b.top), &a.bottom)] {
                let (near, far) = faces;
                let corners = near.windows(2).zip(far.windows(2)).zip(other);
                for ((n, f), opposite) in corners {
                    let ([n0, n1], [f0, f1]) = (n, f) else { continue };
                    let outwards = at(a, n0) - at(a, opposite);
                    self.faces.push(Face { corners: [at(a, n0), at(a, n1), at(b, f1), at(b, f0)], outwards, color });
                }
            }
            for (end, next) in [(0, 1), (a.bottom.len().wrapping_sub(1), a.bottom.len().wrapping_sub(2))] {
                let corner = |s: &LoftSection, face: &[Point], k: usize| face.get(k).map(|p| at(s, p));
                let all = [
                    corner(a, &a.bottom, end),
                    corner(a, &a.top, end),
                    corner(b, &b.top, end),
                    corner(b, &b.bottom, end),
                ];
                let (Some(inside), [Some(p), Some(q), Some(r), Some(s)]) = (corner(a, &a.bottom, next), all) else {
                    continue;
                };
                self.faces.push(Face { corners: [p, q, r, s], outwards: p - inside, color });
            }
        }
    }

    /// The faces in front and behind.
    fn ends(&mut self, sections: &[LoftSection], color: Color32) {
        for (section, outwards) in [(sections.first(), Vector3::z()), (sections.last(), -Vector3::z())] {
            let Some(section) = section else { continue };
            for (low, high) in section.bottom.windows(2).zip(section.top.windows(2)) {
                let ([l0, l1], [h0, h1]) = (low, high) else { continue };
                let corners = [l0, l1, h1, h0].map(|p| Point3::new(p.z, p.r, -section.along));
                self.faces.push(Face { corners, outwards, color });
            }
        }
    }
}

/// A line that is not longer than can be drawn.
fn shortened(sections: &[LoftSection]) -> Vec<LoftSection> {
    let by = line_shortening(sections);
    sections.iter().map(|s| LoftSection { along: s.along * by, ..s.clone() }).collect()
}

/// How long a line is drawn, as a part of its length: lines are many times longer than wide.
pub(crate) fn line_shortening(sections: &[LoftSection]) -> f64 {
    let across = sections.iter().flat_map(|s| &s.bottom).map(|p| p.z.abs()).fold(0.0, f64::max) * 2.0;
    let length = sections.last().map_or(0.0, |s| s.along) - sections.first().map_or(0.0, |s| s.along);
    if length > 0.0 { (LONGEST * across / length).min(1.0) } else { 1.0 }
}

/// Points of both faces of a station's strip, one above the other.
fn faces_of(design: &StationDesign) -> (Vec<Point>, Vec<Point>) {
    /// Parts of a bend.
    const PARTS: u32 = 12;
    let (mut bottom, mut top) = (Vec::new(), Vec::new());
    for piece in &design.strip.pieces {
        let parts = if piece.is_bent() { PARTS } else { 1 };
        for step in u32::from(!bottom.is_empty())..=parts {
            let t = f64::from(step) / f64::from(parts);
            bottom.push(piece.bottom.point_at(t));
            top.push(piece.top.point_at(t));
        }
    }
    (bottom, top)
}

/// A point of a roll, turned about its axis.
fn in_space(roll: &Roll, p: Point, angle: f64) -> Point3<f64> {
    let (frame, up, aside) = (roll.frame, p.r * angle.cos(), p.r * angle.sin());
    match roll.roll.kind {
        RollKind::Top | RollKind::Bottom => Point3::new(frame.face + p.z, frame.axis + up, aside),
        RollKind::Left | RollKind::Right => Point3::new(frame.axis + up, frame.face + p.z, aside),
    }
}

/// A scene as it is seen.
struct Placed {
    turned: Rotation3<f64>,
    middle: Point3<f64>,
    scale: f64,
    size: [f64; 2],
}

impl Placed {
    fn of(scene: &Scene, pose: Pose, size: [usize; 2]) -> Self {
        let turned = pose.rotation();
        let size = size.map(|pixels| pixels as f64);
        let corners = || scene.faces.iter().flat_map(|f| f.corners).filter(|c| c.iter().all(|v| v.is_finite()));
        let least = corners().fold(Vector3::repeat(f64::INFINITY), |least, c| least.inf(&c.coords));
        let most = corners().fold(Vector3::repeat(f64::NEG_INFINITY), |most, c| most.sup(&c.coords));
        if least.x > most.x {
            return Self { turned, middle: Point3::origin(), scale: 1.0, size };
        }
        let middle = Point3::from((least + most) / 2.0);
        // What is seen at this tilt, however it is turned: a scale that followed the turn would breathe.
        let (up, aside) = (pose.tilt.cos().abs(), pose.tilt.sin().abs());
        let seen = corners().map(|c| c - middle).map(|v| (v.x.hypot(v.z), v.y.abs()));
        let half = seen.fold([1e-9_f64; 2], |[x, y], (h, v)| [x.max(h), y.max(v * up + h * aside)]);
        let scale = (size[0] / half[0]).min(size[1] / half[1]) / 2.0 * FILLED * pose.zoom;
        Self { turned, middle, scale, size }
    }

    /// A point in pixels, with its nearness.
    fn seen(&self, p: &Point3<f64>) -> Point3<f64> {
        let v = self.turned * (p - self.middle) * self.scale;
        Point3::new(self.size[0] / 2.0 + v.x, self.size[1] / 2.0 - v.y, v.z)
    }

    #[allow(clippy::cast_possible_truncation, reason = "screen positions are f32 in egui")]
    fn on_screen(&self, p: &Point3<f64>) -> Pos2 {
        let at = self.seen(p);
        pos2(at.x as f32, at.y as f32 - 5.0)
    }

    /// The faces whose outside is seen.
    fn facets(&self, scene: &Scene) -> Vec<Facet> {
        scene.faces.iter().filter_map(|face| self.facet(face)).collect()
    }

    #[allow(clippy::cast_possible_truncation, reason = "light is f32 in egui's colours")]
    fn facet(&self, face: &Face) -> Option<Facet> {
        let [a, b, c, d] = face.corners;
        let across = (c - a).cross(&(d - b)).try_normalize(0.0)?;
        let normal = self.turned * if across.dot(&face.outwards) < 0.0 { -across } else { across };
        let corners = face.corners.map(|p| self.seen(&p));
        (normal.z > -1e-3).then(|| Facet { corners, color: shaded(face.color, lit(&normal) as f32) })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rollform::design;
    use crate::rollform::fixtures::published_rolls;
    use crate::rollform::loft::loft;

    fn coloured(subject: LineSubject<'_>, pose: Pose) -> (usize, usize) {
        let palette = Palette::LIGHT;
        let scene = Scene::of(subject, &palette);
        let placed = Placed::of(&scene, pose, [300, 200]);
        let facets = placed.facets(&scene);
        let picture = depth::drawn(&facets, [300, 200]);
        let inside =
            facets.iter().flat_map(|f| f.corners).all(|c| (0.0..=300.0).contains(&c.x) && (0.0..=200.0).contains(&c.y));
        assert!(inside, "everything is in view");
        let red = |c: &Color32| c.a() == 255 && i32::from(c.r()) > i32::from(c.b()) + 40;
        (picture.pixels.iter().filter(|c| c.a() > 0).count(), picture.pixels.iter().filter(|c| red(c)).count())
    }

    #[test]
    fn rolls_and_strip_of_a_station_are_seen_from_everywhere() {
        let design = design("x", &published_rolls());
        let station = &design.stations[2];
        assert_eq!(station.rolls.len(), 4);
        for turn in [-2.0, -0.55, 0.0, 1.0] {
            let pose = Pose { turn, ..Pose::default() };
            let subject = LineSubject::Station { design: station, roll: None, bore_mm: &|_| 40.0 };
            let (seen, strip) = coloured(subject, pose);
            assert!(seen > 10_000, "{turn}: {seen}");
            assert!(strip > 20, "{turn}: the strip runs out of the rolls, {strip}");
        }
    }

    #[test]
    fn the_strip_runs_through_the_line_with_a_number_at_every_station() {
        let sections = loft(&published_rolls());
        let scene = Scene::of(LineSubject::Line { sections: &sections }, &Palette::LIGHT);
        assert_eq!(scene.marks.iter().map(|(_, n)| *n).collect::<Vec<_>>(), [1, 2, 3]);
        assert!(coloured(LineSubject::Line { sections: &sections }, LINE_POSE).1 > 2000);
    }

    #[test]
    fn nothing_is_an_empty_picture() {
        assert_eq!(coloured(LineSubject::Line { sections: &[] }, LINE_POSE), (0, 0));
    }
}
