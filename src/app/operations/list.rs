//! The list: a line an operation, for mouse and keyboard.

use super::OperationsView;
use super::edit::ListEdit;
use super::line::Line;
use crate::app::actions::Action;
use crate::app::desk::Requests;
use crate::app::theme::{self, Colors};
use crate::app::widgets::clock;
use crate::document::Generator;
use crate::session::{Hovered, Session};
use egui::{Align2, EventFilter, FontId, Key, Modifiers, Rect, Response, Sense, Stroke, Ui, pos2, vec2};

/// Height of a line, points.
const LINE: f32 = 38.0;
/// Where the names begin, points from the left edge.
const NAME: f32 = 42.0;
/// Room for tool and time at the right edge, points.
const RIGHT: f32 = 92.0;

/// Shows the lines; what a key asks of the list of instructions.
pub(super) fn show(
    ui: &mut Ui,
    view: &mut OperationsView,
    session: &mut Session,
    requests: &mut Requests,
) -> Option<ListEdit> {
    if view.lines.all.is_empty() {
        let text = match session.part().generator {
            Generator::Cycles { .. } => "No instructions yet. Add the first one.",
            Generator::Oracap { .. } | Generator::Planned { .. } => "There are no operations yet.",
        };
        ui.label(theme::quiet(text, Colors::of(ui.visuals())));
        return None;
    }
    let can_edit = matches!(session.part().generator, Generator::Cycles { .. } | Generator::Planned { .. });
    let (mut wish, mut go_to) = (None, None);
    ui.scope(|ui| {
        ui.spacing_mut().item_spacing.y = 0.0;
        for (number, line) in (1_usize..).zip(&view.lines.all) {
            let selected = session.selection.operation == Some(line.index);
            let response = draw(ui, number, line, selected);
            if view.take_focus == Some(line.index) {
                response.request_focus();
                response.scroll_to_me(None);
                view.take_focus = None;
            }
            if response.hovered() {
                requests.hovered = requests.hovered.or(Some(Hovered::Operation(line.index)));
            }
            if response.clicked() {
                response.request_focus();
                select(session, requests, line.index);
            }
            if response.has_focus() {
                take_arrows(ui, &response);
                // Keys with Alt first: an arrow alone counts as pressed with Alt too.
                wish = edit_key(ui, line.index).filter(|_| can_edit).or(wish);
                go_to = step(ui).and_then(|by| neighbour(&view.lines.all, number - 1, by)).or(go_to);
            }
        }
    });
    if let Some(index) = go_to {
        select(session, requests, index);
        view.take_focus = Some(index);
    }
    wish
}

fn select(session: &mut Session, requests: &mut Requests, index: usize) {
    session.select_operation(index);
    requests.actions.push(Action::ShowBlock);
}

/// Keeps up and down for the list.
fn take_arrows(ui: &Ui, response: &Response) {
    let filter = EventFilter { vertical_arrows: true, ..EventFilter::default() };
    ui.memory_mut(|m| m.set_focus_lock_filter(response.id, filter));
}

fn step(ui: &Ui) -> Option<isize> {
    let pressed = |key| ui.input_mut(|i| i.consume_key(Modifiers::NONE, key));
    if pressed(Key::ArrowUp) { Some(-1) } else { pressed(Key::ArrowDown).then_some(1) }
}

fn neighbour(lines: &[Line], at: usize, by: isize) -> Option<usize> {
    lines.get(at.checked_add_signed(by)?).map(|line| line.index)
}

fn edit_key(ui: &Ui, index: usize) -> Option<ListEdit> {
    let keys = [
        (Modifiers::ALT, Key::ArrowUp, ListEdit::Up(index)),
        (Modifiers::ALT, Key::ArrowDown, ListEdit::Down(index)),
        (Modifiers::COMMAND, Key::D, ListEdit::Duplicate(index)),
        (Modifiers::COMMAND, Key::Delete, ListEdit::Delete(index)),
        (Modifiers::NONE, Key::Insert, ListEdit::Add(Some(index))),
    ];
    keys.into_iter().find(|(modifiers, key, _)| ui.input_mut(|i| i.consume_key(*modifiers, *key))).map(|(_, _, e)| e)
}

fn draw(ui: &mut Ui, number: usize, line: &Line, selected: bool) -> Response {
    let colors = Colors::of(ui.visuals());
    let (rect, response) = ui.allocate_exact_size(vec2(ui.available_width(), LINE), Sense::click());
    let time = line.time.map_or_else(|| "–".to_owned(), |time| clock(time.total_s()));
    response.widget_info(|| {
        let text = format!("Operation {number}: {}, tool {}, {}, {time}", line.name, line.tool, line.figures);
        egui::WidgetInfo::selected(egui::Role::ListItem, true, selected, text)
    });
    let painter = ui.painter();
    if selected {
        painter.rect_filled(rect, 0.0, colors.selected);
        painter.rect_filled(Rect::from_min_size(rect.min, vec2(3.0, rect.height())), 0.0, colors.plot.accent);
    } else if response.hovered() || response.has_focus() {
        painter.rect_filled(rect, 4.0, colors.hovered);
    }
    let (upper, lower) = (rect.top() + 12.0, rect.bottom() - 11.0);
    let square = Rect::from_center_size(pos2(rect.left() + 12.0, upper), vec2(9.0, 9.0));
    painter.rect_filled(square, 2.0, line.color);
    let font = FontId::proportional(theme::TEXT);
    let small = FontId::proportional(theme::SMALL);
    let (text, quiet) = (colors.plot.text, colors.plot.quiet);
    painter.text(pos2(rect.left() + 34.0, upper), Align2::RIGHT_CENTER, number.to_string(), font.clone(), quiet);
    let right = rect.right() - 6.0;
    painter.text(pos2(right, upper), Align2::RIGHT_CENTER, time, font.clone(), quiet);
    let tool = format!("T{}", line.tool);
    painter.text(pos2(right - 44.0, upper), Align2::RIGHT_CENTER, tool, font.clone(), colors.word_tool);
    let cut = |right: f32| ui.painter_at(Rect::from_x_y_ranges(rect.left()..=right, rect.y_range()));
    let name = pos2(rect.left() + NAME, upper);
    cut(rect.right() - RIGHT).text(name, Align2::LEFT_CENTER, &line.name, font, text);
    let under = pos2(rect.left() + NAME, lower);
    cut(right).text(under, Align2::LEFT_CENTER, &line.figures, small, quiet);
    painter.hline(rect.x_range(), rect.bottom(), Stroke::new(1.0, colors.line.gamma_multiply(0.7)));
    response
}
