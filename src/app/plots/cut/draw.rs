//! The picture of the cut: stock, part, paths, tool, and what is wrong.

use super::paths::Shown;
use super::stock;
use super::{CutView, Frame};
use crate::app::plots::lines::{DASHED, dashed, faded, thinned};
use crate::app::plots::palette::{LeftoverClass, Palette};
use crate::app::plots::profile::draw::{EDGE, LIT, LIT_STRENGTH, Lines, body, centre_line, chuck, on_screen};
use crate::app::plots::regions::Triangles;
use crate::diagnostic::Severity;
use crate::proof::{Finding, FindingKind};
use egui::{Align2, FontId, Painter, Pos2, Shape, Stroke, Vec2};

/// Width of the line that shows what is left on a section, points.
const LEFTOVER: f32 = 3.4;
/// Height of a line of the legend, points.
const LINE: f32 = 15.0;
/// Length of the sample of a colour in the legend, points.
const DASH: f32 = 16.0;
/// Radius of the ring around a finding, points.
const FINDING: f32 = 6.0;
/// Share of the form tolerance that a gouge must be thick on average to be drawn.
const DRAWN_GOUGE: f64 = 0.5;

/// Draws everything.
pub(super) fn picture(painter: &Painter, frame: &Frame<'_>, view: &mut CutView) {
    let (scene, screen) = (frame.scene, &frame.screen);
    let derived = scene.derived;
    let index = super::stock_index_at(derived, view.time_s);
    let shown = view.states.state(derived, index, scene.form_tolerance_mm * DRAWN_GOUGE);
    if view.stock {
        stock_left(painter, frame, &shown);
        swept(painter, frame, view);
    }
    part(painter, frame);
    shown.gouged.fill(painter, screen, scene.palette.wrong);
    if view.leftover {
        leftover(painter, frame);
    }
    if let Some(machine) = scene.machine {
        chuck(painter, screen, derived.setup.chuck_face_z, &machine.chuck, scene.palette);
    }
    for holder in [&derived.setup.mandrel, &derived.setup.tailstock].into_iter().flatten() {
        body(painter, screen, holder, scene.palette);
    }
    centre_line(painter, screen, scene.palette);
    lit_sections(painter, frame);
    let colors = scene.palette.operations(&derived.path.operations);
    let now = frame.now.map(|now| now.index);
    let shown = Shown { now, lit: scene.lit_blocks, selected: scene.selected, colors: &colors };
    view.paths.draw(painter, scene.palette, &shown);
    tool_now(painter, frame, view);
    findings(painter, frame);
    if view.leftover {
        legend(painter, frame);
    }
}

fn stock_left(painter: &Painter, frame: &Frame<'_>, shown: &stock::Shown) {
    let (palette, screen) = (frame.scene.palette, &frame.screen);
    let Some(state) = &shown.state else { return stock_before(painter, frame) };
    shown.region.fill(painter, screen, palette.stock);
    for ring in state.rings.iter() {
        painter.add(Shape::closed_line(on_screen(screen, ring), Stroke::new(1.0, palette.stock_edge)));
    }
}

/// Without a proof the stock of the set-up stands in.
fn stock_before(painter: &Painter, frame: &Frame<'_>) {
    let (palette, screen) = (frame.scene.palette, &frame.screen);
    let outline = frame.scene.derived.setup.stock.polyline(screen.tolerance());
    Triangles::of(std::slice::from_ref(&outline)).fill(painter, screen, palette.stock);
    dashed(painter, &on_screen(screen, &outline), DASHED, Stroke::new(1.0, palette.stock_edge));
}

fn swept(painter: &Painter, frame: &Frame<'_>, view: &CutView) {
    let Some((now, running)) = frame.now.and_then(|now| Some((now, frame.running(now)?))) else { return };
    view.tools.swept(painter, &frame.screen, frame.scene.palette, running, now.share);
}

fn part(painter: &Painter, frame: &Frame<'_>) {
    let (palette, screen) = (frame.scene.palette, &frame.screen);
    let lines = Lines::of(frame.scene.derived, screen.tolerance());
    Triangles::between(&lines.outside, &lines.bore).fill(painter, screen, palette.part);
    let edge = on_screen(screen, &lines.outline());
    painter.add(Shape::line(edge, Stroke::new(EDGE, palette.edge)));
}

fn tool_now(painter: &Painter, frame: &Frame<'_>, view: &CutView) {
    let Some((now, running)) = frame.now.and_then(|now| Some((now, frame.running(now)?))) else { return };
    view.tools.draw(painter, &frame.screen, frame.scene.palette, running.tool, now.at);
}

fn leftover(painter: &Painter, frame: &Frame<'_>) {
    let scene = frame.scene;
    for left in &scene.derived.proof.leftover {
        let class = LeftoverClass::of(left.largest_mm, scene.form_tolerance_mm);
        if class == LeftoverClass::Within {
            continue;
        }
        section_line(painter, frame, left.section, Stroke::new(LEFTOVER, scene.palette.leftover(class)));
    }
}

/// Draws the lines of the sections that belong to what the pointer is on.
fn lit_sections(painter: &Painter, frame: &Frame<'_>) {
    let stroke = Stroke::new(LIT, faded(frame.scene.palette.accent, LIT_STRENGTH));
    for &section in frame.scene.lit_sections {
        section_line(painter, frame, section, stroke);
    }
}

fn section_line(painter: &Painter, frame: &Frame<'_>, section: u32, stroke: Stroke) {
    let derived = frame.scene.derived;
    let contours = std::iter::once(derived.contour.as_ref()).chain(derived.bore.as_ref());
    let segments = contours.flat_map(|contour| contour.contour.segments.iter().zip(&contour.sections));
    for (segment, _) in segments.filter(|(_, of)| **of == section) {
        let start = std::iter::once(segment.start());
        let points = start.chain(segment.polyline_points(frame.screen.tolerance())).map(|p| frame.screen.pos(p));
        painter.add(Shape::line(thinned(points), stroke));
    }
}

/// What the colours of the leftover mean, in the right upper corner.
fn legend(painter: &Painter, frame: &Frame<'_>) {
    let scene = frame.scene;
    let unit = |mm: f64| format!("{:.*}", scene.unit.decimals(), mm / scene.unit.in_mm());
    let [within, little, some] = LeftoverClass::STEPS.map(|step| unit(step * scene.form_tolerance_mm));
    let symbol = scene.unit.symbol();
    let rows = [
        (LeftoverClass::Little, format!("{within} to {little} {symbol} left")),
        (LeftoverClass::Some, format!("{little} to {some} {symbol} left")),
        (LeftoverClass::Much, format!("over {some} {symbol} left")),
    ];
    let layout = |text| painter.layout_no_wrap(text, FontId::proportional(10.5), scene.palette.quiet);
    let rows = rows.map(|(class, text)| (class, layout(text)));
    let widest = rows.iter().map(|(_, galley)| galley.size().x).fold(0.0, f32::max);
    let size = Vec2::new(widest + DASH + 20.0, LINE * 3.0 + 8.0);
    let plate = Align2::RIGHT_TOP.anchor_size(painter.clip_rect().right_top(), size);
    painter.rect_filled(plate, 4.0, faded(scene.palette.ground, 0.88));
    let mut at = plate.left_top() + Vec2::new(8.0, 4.0 + LINE / 2.0);
    for (class, galley) in rows {
        let stroke = Stroke::new(LEFTOVER, scene.palette.leftover(class));
        painter.line_segment([at, at + Vec2::new(DASH, 0.0)], stroke);
        let text = at + Vec2::new(DASH + 6.0, -galley.size().y / 2.0);
        painter.galley(text, galley, scene.palette.quiet);
        at.y += LINE;
    }
}

/// Findings with a place that are more than material left.
fn shown_findings<'a>(frame: &'a Frame<'_>) -> impl Iterator<Item = (Pos2, &'a Finding)> {
    let wrong = frame.scene.derived.proof.findings.iter().filter(|f| f.kind != FindingKind::Leftover);
    wrong.filter_map(|f| Some((frame.screen.pos(f.at?), f)))
}

fn findings(painter: &Painter, frame: &Frame<'_>) {
    let palette: &Palette = frame.scene.palette;
    for (pos, finding) in shown_findings(frame).filter(|(pos, _)| painter.clip_rect().expand(FINDING).contains(*pos)) {
        // What is within the tolerance is marked, but not as wrong.
        let color = if finding.severity == Severity::Info { palette.quiet } else { palette.wrong };
        painter.circle(pos, FINDING, faded(color, 0.15), Stroke::new(1.6, color));
    }
}

/// What the finding at `pos` says.
pub(super) fn finding_at(frame: &Frame<'_>, pos: Pos2) -> Option<Vec<String>> {
    let near = shown_findings(frame).find(|(at, _)| at.distance(pos) <= FINDING + 2.0);
    near.map(|(_, f)| vec![f.message.clone(), format!("{} block {}", f.program, f.block)])
}
