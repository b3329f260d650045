//! The edit that is being prepared: what is done, and its figures, typed or picked in the plot.

use crate::app::theme::{self, Colors};
use crate::app::widgets::{Typed, choice, field, form_label, length_field, primary_button, remark, toggle};
use crate::document::{EditAction, ElementName, NewElement, RollPoint, TangentSide};
use crate::geometry::Point;
use crate::rollform::editor::described;
use crate::units::Unit;
use egui::{Ui, vec2};

/// Width of labels, points.
const LABEL: f32 = 92.0;
/// Width of fields, points.
const FIELD: f32 = 158.0;

/// What an edit does.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
enum Tool {
    #[default]
    Chamfer,
    Blend,
    TwoPoints,
    Angle,
    Parallel,
    Radius,
    Through,
    Moved,
    Tangent,
    Delete,
}

impl Tool {
    const ALL: [(Self, &'static str); 10] = [
        (Self::Chamfer, "chamfer"),
        (Self::Blend, "blending arc"),
        (Self::TwoPoints, "line by two points"),
        (Self::Angle, "line by point and angle"),
        (Self::Parallel, "line parallel to another"),
        (Self::Radius, "circle by centre and radius"),
        (Self::Through, "circle by centre and point"),
        (Self::Moved, "another circle, moved"),
        (Self::Tangent, "circle touching both"),
        (Self::Delete, "delete the element"),
    ];

    const fn makes_element(self) -> bool {
        !matches!(self, Self::Chamfer | Self::Blend | Self::Delete)
    }
}

/// Which figure the next click in the plot gives.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Pick {
    First,
    Second,
    Other,
}

/// The edit that is being prepared.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Draft {
    tool: Tool,
    replace: bool,
    /// Depth or radius.
    size: f64,
    first: RollPoint,
    second: RollPoint,
    angle_deg: f64,
    other: Option<ElementName>,
    before: TangentSide,
    after: TangentSide,
    pick: Option<Pick>,
}

impl Default for Draft {
    fn default() -> Self {
        let zero = RollPoint { z: 0.0, diameter: 0.0 };
        Self {
            tool: Tool::default(),
            replace: false,
            size: 2.0,
            first: zero,
            second: zero,
            angle_deg: 45.0,
            other: None,
            before: TangentSide::Above,
            after: TangentSide::Above,
            pick: None,
        }
    }
}

impl Draft {
    /// The edit at the chosen element; `None` while something is missing.
    pub(super) fn action(&self, chosen: Option<ElementName>) -> Option<EditAction> {
        let after = chosen?;
        Some(match self.tool {
            Tool::Chamfer => EditAction::Chamfer { after, depth: self.size },
            Tool::Blend => EditAction::Blend { after, radius: self.size },
            Tool::Delete => EditAction::Delete { element: after },
            _ if self.replace => EditAction::Replace { element: after, shape: self.shape()? },
            _ => EditAction::Insert { after, shape: self.shape()? },
        })
    }

    fn shape(&self) -> Option<NewElement> {
        let (point, center) = (self.first, self.first);
        Some(match self.tool {
            Tool::TwoPoints => NewElement::LineTwoPoints { first: point, second: self.second },
            Tool::Angle => NewElement::LineAngle { point, angle_deg: self.angle_deg },
            Tool::Parallel => NewElement::LineParallel { point, to: self.other? },
            Tool::Radius => NewElement::CircleRadius { center, radius: self.size },
            Tool::Through => NewElement::CirclePoint { center, point: self.second },
            Tool::Moved => {
                NewElement::CircleMoved { of: self.other?, dz: self.second.z, dr: self.second.diameter / 2.0 }
            }
            Tool::Tangent => NewElement::CircleTangent { radius: self.size, before: self.before, after: self.after },
            Tool::Chamfer | Tool::Blend | Tool::Delete => return None,
        })
    }

    /// Takes a clicked element, if one was asked for.
    pub(super) fn take_element(&mut self, name: Option<ElementName>) -> bool {
        match self.pick {
            Some(Pick::Other) => {
                self.other = name;
                self.pick = None;
                true
            }
            Some(_) => true,
            None => false,
        }
    }

    /// Takes a clicked place, in mm, if one was asked for.
    pub(super) fn take_point(&mut self, p: Point, unit: Unit) {
        let point = RollPoint { z: p.z / unit.in_mm(), diameter: 2.0 * p.r / unit.in_mm() };
        match self.pick {
            Some(Pick::First) => self.first = point,
            Some(Pick::Second) => self.second = point,
            _ => return,
        }
        self.pick = None;
    }
}

/// Shows the form; true if the edit is to be made. `fault` is why it does not fit.
pub(super) fn show(
    ui: &mut Ui,
    draft: &mut Draft,
    chosen: Option<ElementName>,
    unit: Unit,
    ready: bool,
    fault: Option<&str>,
) -> bool {
    let all: Vec<(Tool, String)> = Tool::ALL.iter().map(|&(tool, text)| (tool, text.to_owned())).collect();
    row(ui, "Edit", |ui| {
        if let Some(tool) = choice(ui, "Edit", &draft.tool, &all, FIELD) {
            draft.tool = tool;
        }
    });
    if draft.tool.makes_element() {
        row(ui, "Place", |ui| {
            let places = [(false, "behind the chosen one".to_owned()), (true, "in place of it".to_owned())];
            if let Some(replace) = choice(ui, "Place", &draft.replace, &places, FIELD) {
                draft.replace = replace;
            }
        });
    }
    figures(ui, draft, unit);
    let colors = Colors::of(ui.visuals());
    let mut apply = false;
    match (chosen, fault) {
        (None, _) => {
            ui.label(theme::quiet("Click an element in the plot first.", colors));
        }
        (Some(_), Some(fault)) => remark(ui, fault),
        (Some(name), None) => {
            let behind = if draft.tool == Tool::Delete || draft.replace { "at" } else { "behind" };
            ui.label(theme::quiet(format!("{behind} {}", described(name)), colors));
        }
    }
    ui.horizontal(|ui| {
        ui.add_space(LABEL + 8.0);
        apply = primary_button(ui, "Apply", ready && fault.is_none()).clicked();
    });
    apply
}

fn figures(ui: &mut Ui, draft: &mut Draft, unit: Unit) {
    match draft.tool {
        Tool::Chamfer => size(ui, draft, "Depth", unit),
        Tool::Blend => size(ui, draft, "Radius", unit),
        Tool::TwoPoints => {
            first(ui, draft, "First point", unit);
            second(ui, draft, "Second point", unit);
        }
        Tool::Angle => {
            first(ui, draft, "Point", unit);
            row(ui, "Angle", |ui| {
                let shown = format!("{}°", draft.angle_deg);
                let read = |text: &str| {
                    let figure = text.trim().trim_end_matches('°').trim().parse::<f64>().ok().filter(|v| v.is_finite());
                    figure.ok_or_else(|| format!("\"{text}\" is no angle in degrees."))
                };
                take(field(ui, "Angle", &shown, FIELD, read), &mut draft.angle_deg);
            });
        }
        Tool::Parallel => {
            first(ui, draft, "Point", unit);
            other(ui, draft, "Parallel to");
        }
        Tool::Radius => {
            first(ui, draft, "Centre", unit);
            size(ui, draft, "Radius", unit);
        }
        Tool::Through => {
            first(ui, draft, "Centre", unit);
            second(ui, draft, "Point", unit);
        }
        Tool::Moved => {
            other(ui, draft, "Circle of");
            second(ui, draft, "Moved by", unit);
        }
        Tool::Tangent => {
            size(ui, draft, "Radius", unit);
            side(ui, "Seen from 1st", &mut draft.before);
            side(ui, "Seen from 2nd", &mut draft.after);
        }
        Tool::Delete => {}
    }
}

fn size(ui: &mut Ui, draft: &mut Draft, name: &str, unit: Unit) {
    row(ui, name, |ui| take(length_field(ui, name, draft.size, unit, FIELD), &mut draft.size));
}

fn first(ui: &mut Ui, draft: &mut Draft, name: &str, unit: Unit) {
    let mut point = draft.first;
    place(ui, &mut draft.pick, Pick::First, &mut point, name, unit);
    draft.first = point;
}

fn second(ui: &mut Ui, draft: &mut Draft, name: &str, unit: Unit) {
    let mut point = draft.second;
    place(ui, &mut draft.pick, Pick::Second, &mut point, name, unit);
    draft.second = point;
}

fn place(ui: &mut Ui, pick: &mut Option<Pick>, which: Pick, point: &mut RollPoint, name: &str, unit: Unit) {
    row(ui, name, |ui| {
        let mut on = *pick == Some(which);
        let text = if on { "click in the plot" } else { "pick in the plot" };
        if toggle(ui, &mut on, text).clicked() {
            *pick = on.then_some(which);
        }
    });
    row(ui, "  z, ⌀", |ui| {
        let half = (FIELD - 8.0) / 2.0;
        take(length_field(ui, &format!("{name} z"), point.z, unit, half), &mut point.z);
        take(length_field(ui, &format!("{name} ⌀"), point.diameter, unit, half), &mut point.diameter);
    });
}

fn other(ui: &mut Ui, draft: &mut Draft, name: &str) {
    row(ui, name, |ui| {
        let mut on = draft.pick == Some(Pick::Other);
        let text = match (on, draft.other) {
            (true, _) => "click an element".to_owned(),
            (false, Some(name)) => described(name),
            (false, None) => "pick in the plot".to_owned(),
        };
        if toggle(ui, &mut on, &text).clicked() {
            draft.pick = on.then_some(Pick::Other);
        }
    });
}

fn side(ui: &mut Ui, name: &str, side: &mut TangentSide) {
    let all = [
        (TangentSide::Above, "above, or left".to_owned()),
        (TangentSide::Below, "below, or right".to_owned()),
        (TangentSide::Inside, "inside the circle".to_owned()),
        (TangentSide::Outside, "outside the circle".to_owned()),
    ];
    row(ui, name, |ui| {
        if let Some(chosen) = choice(ui, name, side, &all, FIELD) {
            *side = chosen;
        }
    });
}

fn row(ui: &mut Ui, name: &str, content: impl FnOnce(&mut Ui)) {
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing = vec2(8.0, 4.0);
        form_label(ui, name, LABEL);
        content(ui);
    });
}

#[allow(clippy::needless_pass_by_value, reason = "callers hand over what a field just said")]
fn take(typed: Option<Typed<f64>>, value: &mut f64) {
    if let Some(Typed::Value(new) | Typed::Left(Some(new))) = typed {
        *value = new;
    }
}
