//! Small widgets that all panels share.

use super::theme::{self, Colors};
use crate::document::{Document, TurnedPart};
use crate::session::Session;
use crate::units::{Unit, parse_length};
use egui::{
    Align, Color32, CornerRadius, Id, Layout, Response, RichText, Sense, Stroke, TextEdit, Ui, WidgetInfo, vec2,
};

/// The first row of a panel: title and remark on the left, links on the right. The title is left out in a tab. True if
/// the panel is dragged by the title.
pub(crate) fn title_row(ui: &mut Ui, title: Option<&str>, remark: &str, right: impl FnOnce(&mut Ui)) -> bool {
    let colors = Colors::of(ui.visuals());
    let mut dragged = false;
    ui.horizontal(|ui| {
        ui.set_min_height(22.0);
        if let Some(title) = title {
            let label = egui::Label::new(theme::strong(title)).sense(Sense::drag()).selectable(false);
            dragged = ui.add(label).on_hover_cursor(egui::CursorIcon::Grab).drag_started();
        }
        if !remark.is_empty() {
            ui.add(egui::Label::new(theme::quiet(remark, colors)).truncate());
        }
        ui.with_layout(Layout::right_to_left(Align::Center), right);
    });
    dragged
}

/// A word in the accent colour that can be clicked.
pub(crate) fn link(ui: &mut Ui, text: &str) -> Response {
    let accent = Colors::of(ui.visuals()).plot.accent;
    let button = egui::Button::new(RichText::new(text).color(accent)).frame(false);
    ui.add(button).on_hover_cursor(egui::CursorIcon::PointingHand)
}

/// A word in the accent colour that switches something on and off; quiet while off.
pub(crate) fn toggle(ui: &mut Ui, on: &mut bool, text: &str) -> Response {
    let colors = Colors::of(ui.visuals());
    let color = if *on { colors.plot.accent } else { colors.plot.quiet };
    let response = ui.add(egui::Button::new(RichText::new(text).color(color)).frame(false));
    response.widget_info(|| WidgetInfo::selected(egui::Role::CheckBox, true, *on, text));
    if response.clicked() {
        *on = !*on;
    }
    response
}

/// The one button of a place that matters most.
pub(crate) fn primary_button(ui: &mut Ui, text: &str, enabled: bool) -> Response {
    let colors = Colors::of(ui.visuals());
    let text = RichText::new(text).font(theme::strong_font(theme::TEXT)).color(colors.on_accent);
    let button = egui::Button::new(text).fill(colors.plot.accent).stroke(Stroke::NONE).min_size(vec2(0.0, 27.0));
    padded(ui, |ui| ui.add_enabled(enabled, button))
}

/// The same room left and right of the text in menus, where it is less, and elsewhere.
fn padded(ui: &mut Ui, add: impl FnOnce(&mut Ui) -> Response) -> Response {
    let before = std::mem::replace(&mut ui.spacing_mut().button_padding, vec2(12.0, 4.0));
    let response = add(ui);
    ui.spacing_mut().button_padding = before;
    response
}

/// A word on a coloured ground with round ends.
pub(crate) fn chip(ui: &mut Ui, text: RichText, ground: Color32) -> Response {
    let button = egui::Button::new(text).fill(ground).stroke(Stroke::NONE).corner_radius(CornerRadius::same(13));
    padded(ui, |ui| ui.add(button.min_size(vec2(0.0, 25.0))))
}

/// A label in the left column of a form.
pub(crate) fn form_label(ui: &mut Ui, text: &str, width: f32) {
    let colors = Colors::of(ui.visuals());
    let (rect, _) = ui.allocate_exact_size(vec2(width, 26.0), Sense::hover());
    let font = egui::FontId::proportional(theme::TEXT);
    ui.painter().text(rect.left_center(), egui::Align2::LEFT_CENTER, text, font, colors.plot.quiet);
}

/// What a person does with a field.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Typed<T> {
    /// The text is about to be changed.
    Begun,
    /// The text says this now.
    Value(T),
    /// The text says nothing now, or what it said before.
    Nothing,
    /// The field was left with this; a bad text stays in it, marked.
    Left(Option<T>),
    /// Escape was pressed.
    GivenUp,
}

impl<T> Typed<T> {
    /// Puts what is typed into the document at once; all typing until the field is left is one step of undo.
    pub(crate) fn put_into(self, session: &mut Session, label: &str, change: impl FnOnce(&mut Document, T)) {
        self.put(session, |session, value| session.type_in(label, |document| change(document, value)));
    }

    /// Puts what is typed into the part; see [`Self::put_into`].
    pub(crate) fn put_into_part(self, session: &mut Session, label: &str, change: impl FnOnce(&mut TurnedPart, T)) {
        self.put(session, |session, value| session.type_in_part(label, |part| change(part, value)));
    }

    fn put(self, session: &mut Session, type_in: impl FnOnce(&mut Session, T)) {
        match self {
            Self::Begun => session.begin_typing(),
            Self::Value(value) => type_in(session, value),
            Self::Nothing => session.take_back_typing(),
            Self::Left(_) => session.end_typing(),
            Self::GivenUp => session.give_up_typing(),
        }
    }
}

/// A field for a length in `unit`, which may be an expression; see [`field`].
pub(crate) fn length_field(ui: &mut Ui, name: &str, value: f64, unit: Unit, width: f32) -> Option<Typed<f64>> {
    let shown = super::plots::fixed(value, unit.decimals());
    let read = |text: &str| parse_length(text, unit);
    field(ui, name, &shown, width, read)
}

/// What a field keeps while it is edited, and afterwards if its text says nothing.
#[derive(Debug, Clone, Default)]
struct Kept {
    text: String,
    /// What it showed before.
    before: String,
}

/// A field whose text is read while it is typed; a bad one is marked and stays until it is put right or Escape is pressed.
/// Tells what the person does. `name` is what a screen reader says.
pub(crate) fn field<T>(
    ui: &mut Ui,
    name: &str,
    shown: &str,
    width: f32,
    read: impl Fn(&str) -> Result<T, String>,
) -> Option<Typed<T>> {
    let id = ui.make_persistent_id(("field", name));
    let kept: Option<Kept> = ui.data(|d| d.get_temp(id));
    let says = |kept: &Kept| if kept.text == kept.before { Ok(None) } else { read(&kept.text).map(Some) };
    let error = kept.as_ref().and_then(|kept| says(kept).err());
    let mut text = kept.as_ref().map_or_else(|| shown.to_owned(), |kept| kept.text.clone());
    let response = framed_edit(ui, id, &mut text, width, error.is_some());
    response.widget_info(|| {
        let mut info = WidgetInfo::text_edit(true, shown, &text, "");
        info.label = Some(name.to_owned());
        info
    });
    if response.gained_focus() {
        select_all(ui, id, &text);
    }
    let kept = Kept { text, before: kept.map_or_else(|| shown.to_owned(), |kept| kept.before) };
    let typed = if response.lost_focus() {
        let escaped = ui.input(|i| i.key_pressed(egui::Key::Escape));
        let said = says(&kept);
        if escaped || said.is_ok() {
            ui.data_mut(|d| d.remove::<Kept>(id));
        }
        Some(if escaped { Typed::GivenUp } else { Typed::Left(said.ok().flatten()) })
    } else if response.changed() {
        Some(says(&kept).ok().flatten().map_or(Typed::Nothing, Typed::Value))
    } else {
        response.gained_focus().then_some(Typed::Begun)
    };
    if response.has_focus() {
        ui.data_mut(|d| d.insert_temp(id, kept));
    }
    if let Some(error) = error {
        response.on_hover_text(error);
    }
    typed
}

fn framed_edit(ui: &mut Ui, id: Id, text: &mut String, width: f32, wrong: bool) -> Response {
    let colors = Colors::of(ui.visuals());
    let focused = ui.memory(|m| m.has_focus(id));
    let (line, fill) = match (wrong, focused) {
        (true, _) => (colors.plot.wrong, colors.wrong_field),
        (false, true) => (colors.plot.accent, colors.panel),
        (false, false) => (colors.field_line, colors.panel),
    };
    let frame = egui::Frame::new()
        .fill(fill)
        .stroke(Stroke::new(if focused { 1.5 } else { 1.0 }, line))
        .corner_radius(5)
        .inner_margin(egui::Margin::symmetric(8, 4));
    let edit = TextEdit::singleline(text)
        .id(id)
        .frame(frame)
        .desired_width(width - 16.0)
        .align(egui::Align2::RIGHT_CENTER)
        .min_size(vec2(width, 26.0));
    ui.add(edit)
}

/// Selects all of the text in the field, as a person who types a new figure expects.
pub(crate) fn select_all(ui: &Ui, id: Id, text: &str) {
    let mut state = TextEdit::load_state(ui.ctx(), id).unwrap_or_default();
    let end = egui::text::CCursor::new(text.chars().count());
    state.cursor.set_char_range(Some(egui::text::CCursorRange::two(egui::text::CCursor::new(0), end)));
    TextEdit::store_state(ui.ctx(), id, state);
}

/// Height of a list of choices, beyond which it is scrolled, points.
const MENU: f32 = 420.0;

/// A list of choices behind a button with the present one on it. Gives the new choice when there is one.
pub(crate) fn choice<T: PartialEq + Clone>(
    ui: &mut Ui,
    name: &str,
    present: &T,
    all: &[(T, String)],
    width: f32,
) -> Option<T> {
    let shown = all.iter().find(|(value, _)| value == present).map_or("", |(_, text)| text.as_str());
    let colors = Colors::of(ui.visuals());
    let (rect, response) = ui.allocate_exact_size(vec2(width, 26.0), Sense::click());
    response.widget_info(|| {
        let mut info = WidgetInfo::labeled(egui::Role::ComboBox, true, name);
        info.current_text_value = Some(shown.to_owned());
        info
    });
    let lifted = response.hovered() || response.has_focus();
    let line = if lifted { colors.plot.construction } else { colors.field_line };
    ui.painter().rect(rect.shrink(0.5), 5.0, colors.panel, Stroke::new(1.0, line), egui::StrokeKind::Middle);
    let font = egui::FontId::proportional(theme::TEXT);
    let mut job = egui::text::LayoutJob::simple_singleline(shown.to_owned(), font, colors.plot.text);
    job.wrap = egui::text::TextWrapping::truncate_at_width(rect.width() - 30.0);
    let galley = ui.painter().layout_job(job);
    let at = egui::pos2(rect.right() - 20.0 - galley.size().x, rect.center().y - galley.size().y / 2.0);
    ui.painter().galley(at, galley, colors.plot.text);
    let tip = egui::pos2(rect.right() - 12.0, rect.center().y + 2.0);
    let arrow = vec![tip - vec2(3.5, 4.0), tip + vec2(3.5, -4.0), tip];
    ui.painter().add(egui::Shape::convex_polygon(arrow, colors.plot.quiet, Stroke::NONE));
    let mut chosen = None;
    egui::Popup::menu(&response).width(width).show(|ui| {
        egui::ScrollArea::vertical().max_height(MENU).show(ui, |ui| {
            for (value, text) in all {
                if ui.selectable_label(value == present, text).clicked() {
                    chosen = Some(value.clone());
                    ui.close();
                }
            }
        });
    });
    chosen.filter(|value| value != present)
}

/// A remark on a quiet ground.
pub(crate) fn remark(ui: &mut Ui, text: &str) {
    let colors = Colors::of(ui.visuals());
    egui::Frame::new().fill(colors.inset).corner_radius(6).inner_margin(egui::Margin::same(9)).show(ui, |ui| {
        ui.set_width(ui.available_width());
        ui.label(RichText::new(text).color(colors.plot.quiet));
    });
}

/// Seconds as `m:ss`.
#[must_use]
pub(crate) fn clock(seconds: f64) -> String {
    super::plots::clock(seconds)
}
