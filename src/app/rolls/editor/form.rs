//! The edit that is being prepared: what is done, and its figures, typed or picked in the plot.

use crate::app::rolls::words;
use crate::app::theme::{self, Colors};
use crate::app::widgets::{Typed, choice, field, form_label, length_field, primary_button, remark, toggle};
use crate::document::{EditAction, ElementName, NewElement, RollPoint, TangentSide};
use crate::geometry::{Point, Segment};
use crate::rollform::Roll;
use crate::rollform::editor::described;
use crate::rollform::roll::RollElement;
use crate::units::Unit;
use egui::{Ui, vec2};

/// Width of labels, points.
const LABEL: f32 = 92.0;
/// Width of fields, points.
const FIELD: f32 = 158.0;

/// Height of a remark of two lines, points. It is kept free without one, too: a remark comes and goes with the design,
/// which arrives when it is done, and what is clicked below must not move away under the mouse.
const REMARK: f32 = 48.0;

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

/// What a distance is called, in place of a point.
const MOVED_BY: &str = "Moved by";

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

    /// Takes a clicked place, in mm, if one was asked for. Of a circle that is moved it is where its centre goes.
    pub(super) fn take_point(&mut self, p: Point, unit: Unit, elements: &[RollElement]) {
        let from = if self.tool == Tool::Moved { self.center_of_other(elements) } else { Some(Point::default()) };
        let Some(from) = from else { return };
        let point = RollPoint { z: (p.z - from.z) / unit.in_mm(), diameter: 2.0 * (p.r - from.r) / unit.in_mm() };
        match self.pick {
            Some(Pick::First) => self.first = point,
            Some(Pick::Second) => self.second = point,
            _ => return,
        }
        self.pick = None;
    }

    fn center_of_other(&self, elements: &[RollElement]) -> Option<Point> {
        let name = self.other?;
        elements.iter().find(|e| e.has(name)).and_then(|e| match e.segment {
            Segment::Arc { center, .. } => Some(center),
            Segment::Line { .. } => None,
        })
    }
}

/// A field for the number of an element, as it stands in the published layout.
fn number(ui: &mut Ui, name: &str, of: &mut Option<ElementName>, elements: &[RollElement], width: f32) {
    let present = of.and_then(|name| elements.iter().rposition(|e| e.has(name)));
    let shown = present.map_or_else(String::new, |index| (index + 1).to_string());
    let read = |text: &str| {
        let number = text.trim().parse::<usize>().ok();
        let found = number.and_then(|number| elements.get(number.checked_sub(1)?)?.names.last().copied());
        found.ok_or_else(|| format!("“{}” is no element. Type a number from 1 to {}.", text.trim(), elements.len()))
    };
    if let Some(Typed::Value(name) | Typed::Left(Some(name))) = field(ui, name, &shown, width, read) {
        *of = Some(name);
    }
}

/// What the form is about.
pub(super) struct Asked<'a> {
    /// The roll that is edited.
    pub(super) roll: &'a Roll,
    /// Unit of the document.
    pub(super) unit: Unit,
    /// True if nothing is missing.
    pub(super) ready: bool,
    /// Why the edit does not fit.
    pub(super) fault: Option<&'a str>,
}

/// Shows the form; true if the edit is to be made. `both` is whether it is made on both sides, where it can be.
pub(super) fn show(
    ui: &mut Ui,
    draft: &mut Draft,
    chosen: &mut Option<ElementName>,
    asked: &Asked<'_>,
    both: Option<&mut bool>,
) -> bool {
    let elements = &asked.roll.elements;
    row(ui, "Element", |ui| number(ui, "Element number", chosen, elements, FIELD));
    let all: Vec<(Tool, String)> = Tool::ALL.iter().map(|&(tool, text)| (tool, text.to_owned())).collect();
    row(ui, "Edit", |ui| {
        if let Some(tool) = choice(ui, "Edit", &draft.tool, &all, FIELD) {
            draft.tool = tool;
        }
    });
    if draft.tool.makes_element() {
        row(ui, "Place", |ui| {
            let places = [(false, "behind it".to_owned()), (true, "in its place".to_owned())];
            if let Some(replace) = choice(ui, "Place", &draft.replace, &places, FIELD) {
                draft.replace = replace;
            }
        });
    }
    figures(ui, draft, asked.unit, elements);
    let mut apply = false;
    ui.horizontal(|ui| {
        ui.add_space(LABEL + 8.0);
        apply = primary_button(ui, "Apply", asked.ready && asked.fault.is_none()).clicked();
        if let Some(both) = both {
            toggle(ui, both, "on both sides").on_hover_text("Keeps left and right of the roll alike");
        }
    });
    ui.scope(|ui| {
        ui.set_min_height(REMARK);
        corner(ui, draft, *chosen, asked.fault);
    });
    apply
}

/// Where the edit is made, or why it is not.
fn corner(ui: &mut Ui, draft: &Draft, chosen: Option<ElementName>, fault: Option<&str>) {
    let colors = Colors::of(ui.visuals());
    let text = match (chosen, fault) {
        (Some(_), Some(fault)) => return remark(ui, fault),
        (None, _) => "Click an element in the plot, or type its number.".to_owned(),
        (Some(name), None) => {
            let behind = if draft.tool == Tool::Delete || draft.replace { "at" } else { "behind" };
            format!("{behind} {}", described(name))
        }
    };
    ui.label(theme::quiet(text, colors));
}

fn figures(ui: &mut Ui, draft: &mut Draft, unit: Unit, elements: &[RollElement]) {
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
                let shown = format!("{}°", words::angle(draft.angle_deg));
                take(field(ui, "Angle", &shown, FIELD, words::parse_angle), &mut draft.angle_deg);
            });
        }
        Tool::Parallel => {
            first(ui, draft, "Point", unit);
            other(ui, draft, "Parallel to", elements);
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
            other(ui, draft, "Circle of", elements);
            second(ui, draft, MOVED_BY, unit);
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
    row(ui, if name == MOVED_BY { "  dz, d⌀" } else { "  z, ⌀" }, |ui| {
        let half = (FIELD - 8.0) / 2.0;
        take(length_field(ui, &format!("{name} z"), point.z, unit, half), &mut point.z);
        take(length_field(ui, &format!("{name} ⌀"), point.diameter, unit, half), &mut point.diameter);
    });
}

fn other(ui: &mut Ui, draft: &mut Draft, name: &str, elements: &[RollElement]) {
    /// Width of the number, points.
    const NUMBER: f32 = 44.0;
    row(ui, name, |ui| {
        number(ui, name, &mut draft.other, elements, NUMBER);
        let mut on = draft.pick == Some(Pick::Other);
        let text = match (on, draft.other) {
            (true, _) => "click one".to_owned(),
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
