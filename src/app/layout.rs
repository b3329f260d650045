//! Panels on the desk: which there are, where they lie, and how they are dragged about.

mod places;

use super::theme::{self, Colors};
use crate::document::Kind;
use egui::{Id, Rect, Response, Sense, Stroke, StrokeKind, Ui, WidgetText};
use egui_tiles::{Behavior, Container, SimplificationOptions, TabState, Tile, TileId, Tiles, Tree, UiResponse};
use serde::{Deserialize, Serialize};

/// A panel.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum Pane {
    /// Section table and stock.
    Sections,
    /// What is done in which order.
    Operations,
    /// The part.
    Profile,
    /// Tool paths and playback.
    Cut,
    /// Program text.
    Program,
    /// Diagnostics and findings.
    Problems,
    /// The part in the round.
    Solid,
    /// What is selected.
    Inspector,
    /// The way to the lathe.
    Transfer,
    /// Elements of the cross-section.
    Elements,
    /// The finished cross-section.
    CrossSection,
    /// Bend angles by element and station.
    Angles,
    /// The way of the strip through the stations.
    Flower,
    /// Rolls and strip of a station.
    Station,
    /// What a station is designed by.
    StationData,
    /// Corrections to the contour of one roll.
    RollEditor,
    /// All rolls with what is done about them.
    RollList,
    /// Strain, springback and properties of the section.
    Charts,
    /// What a shell is made by.
    ShellData,
    /// Former, shell and roller.
    ShellView,
    /// Thickness and reduction along the shell.
    Wall,
    /// The operator's sequence.
    Operator,
    /// The rig at work.
    Rig,
    /// Runs to compare.
    Runs,
}

impl Pane {
    /// The panels of a kind of document in the order of the View menu.
    #[must_use]
    pub const fn of(kind: Kind) -> &'static [Self] {
        match kind {
            Kind::TurnedPart => &PART_PANES,
            Kind::RollSet => &ROLL_PANES,
            Kind::Shell => &SHELL_PANES,
        }
    }

    /// Name for people.
    #[must_use]
    pub const fn title(self) -> &'static str {
        match self {
            Self::Sections => "Sections",
            Self::Operations => "Operations",
            Self::Profile => "Profile",
            Self::Cut => "Cut",
            Self::Program => "Program",
            Self::Problems => "Problems",
            Self::Solid => "3D",
            Self::Inspector => "Inspector",
            Self::Transfer => "Transfer",
            Self::Elements => "Elements",
            Self::CrossSection => "Cross-section",
            Self::Angles => "Bend angles",
            Self::Flower => "Flower",
            Self::Station => "Station",
            Self::StationData => "Station data",
            Self::RollEditor => "Roll editor",
            Self::RollList => "Rolls",
            Self::Charts => "Charts",
            Self::ShellData => "Shell",
            Self::ShellView => "Former and roller",
            Self::Wall => "Wall",
            Self::Operator => "Operator",
            Self::Rig => "Rig",
            Self::Runs => "Runs",
        }
    }
}

const PART_PANES: [Pane; 9] = [
    Pane::Sections,
    Pane::Operations,
    Pane::Profile,
    Pane::Cut,
    Pane::Program,
    Pane::Problems,
    Pane::Solid,
    Pane::Inspector,
    Pane::Transfer,
];

const ROLL_PANES: [Pane; 15] = [
    Pane::Elements,
    Pane::Angles,
    Pane::Flower,
    Pane::CrossSection,
    Pane::Station,
    Pane::RollEditor,
    Pane::Cut,
    Pane::Solid,
    Pane::Charts,
    Pane::Program,
    Pane::Operations,
    Pane::Problems,
    Pane::StationData,
    Pane::RollList,
    Pane::Transfer,
];

const SHELL_PANES: [Pane; 9] = [
    Pane::ShellData,
    Pane::ShellView,
    Pane::Wall,
    Pane::Rig,
    Pane::Runs,
    Pane::Program,
    Pane::Problems,
    Pane::Operator,
    Pane::Transfer,
];

/// Height of the row with the tabs of panels that share a place, points.
const TAB_BAR: f32 = 38.0;

/// The panels of a kind of document and their places.
pub(crate) struct Layout {
    kind: Kind,
    tree: Tree<Pane>,
}

/// Shows the content of a panel; true if the panel is dragged by its title.
pub(crate) type ShowPane<'a> = dyn FnMut(&mut Ui, Pane, bool) -> bool + 'a;

impl Layout {
    /// The places that every new user finds.
    #[must_use]
    pub(crate) fn standard(kind: Kind) -> Self {
        let (tiles, root) = match kind {
            Kind::TurnedPart => places::part(PART_PANES),
            Kind::RollSet => places::rolls(ROLL_PANES),
            Kind::Shell => places::shell(SHELL_PANES),
        };
        Self { kind, tree: Tree::new(Id::unique("desk-layout").with(kind), root, tiles) }
    }

    /// The layout in `text`, if it is one with every panel of the kind in it.
    #[must_use]
    pub(crate) fn from_text(kind: Kind, text: &str) -> Option<Self> {
        let tree: Tree<Pane> = serde_json::from_str(text).ok()?;
        Pane::of(kind).iter().all(|pane| tree.tiles.find_pane(pane).is_some()).then_some(Self { kind, tree })
    }

    /// The layout as text for [`Self::from_text`].
    #[must_use]
    pub(crate) fn to_text(&self) -> Option<String> {
        serde_json::to_string(&self.tree).ok()
    }

    /// The kind of document.
    #[must_use]
    pub(crate) const fn kind(&self) -> Kind {
        self.kind
    }

    /// The panels of this kind of document.
    #[must_use]
    pub(crate) const fn panes(&self) -> &'static [Pane] {
        Pane::of(self.kind)
    }

    /// True if `pane` is not hidden.
    #[must_use]
    pub(crate) fn is_shown(&self, pane: Pane) -> bool {
        self.tree.tiles.find_pane(&pane).is_some_and(|tile| self.tree.tiles.is_visible(tile))
    }

    /// Shows or hides `pane`.
    pub(crate) fn set_shown(&mut self, pane: Pane, shown: bool) {
        if let Some(tile) = self.tree.tiles.find_pane(&pane) {
            self.tree.set_visible(tile, shown);
        }
    }

    /// Shows `pane` in front of the panels that share its place.
    pub(crate) fn bring_to_front(&mut self, pane: Pane) {
        self.set_shown(pane, true);
        self.tree.make_active(|_, tile| matches!(tile, Tile::Pane(p) if *p == pane));
    }

    /// Shows all panels in the room that is left in `ui`. `badge` gives the figure behind a title.
    pub(crate) fn ui(&mut self, ui: &mut Ui, badge: &dyn Fn(Pane) -> Option<usize>, show: &mut ShowPane<'_>) {
        let colors = Colors::of(ui.visuals());
        for rect in self.cards() {
            ui.painter().rect(rect, 8.0, colors.panel, Stroke::new(1.0, colors.line), StrokeKind::Inside);
        }
        let tabbed: Vec<TileId> = self.tabs().flat_map(|tabs| tabs.children.clone()).collect();
        self.tree.ui(&mut Desktop { colors, badge, show, tabbed }, ui);
    }

    fn tabs(&self) -> impl Iterator<Item = &egui_tiles::Tabs> {
        self.tree.tiles.tiles().filter_map(|tile| match tile {
            Tile::Container(Container::Tabs(tabs)) => Some(tabs),
            _ => None,
        })
    }

    /// Where cards lie: every panel that is alone at its place, and every place with tabs.
    fn cards(&self) -> Vec<Rect> {
        let in_tabs = |id: TileId| self.tabs().any(|tabs| tabs.children.contains(&id));
        let is_card = |id: TileId, tile: &Tile<Pane>| match tile {
            Tile::Pane(_) => !in_tabs(id),
            Tile::Container(container) => matches!(container, Container::Tabs(_)),
        };
        let shown = self.tree.active_tiles();
        let cards = self.tree.tiles.iter().filter(|(id, tile)| shown.contains(id) && is_card(**id, tile));
        cards.filter_map(|(id, _)| self.tree.tiles.rect(*id)).collect()
    }
}

struct Desktop<'a, 'b> {
    colors: &'static Colors,
    badge: &'a dyn Fn(Pane) -> Option<usize>,
    show: &'a mut ShowPane<'b>,
    tabbed: Vec<TileId>,
}

impl Behavior<Pane> for Desktop<'_, '_> {
    fn pane_ui(&mut self, ui: &mut Ui, tile_id: TileId, pane: &mut Pane) -> UiResponse {
        let tabbed = self.tabbed.contains(&tile_id);
        let mut margin = egui::Margin::same(theme::PAD);
        if tabbed {
            margin.top = 2;
        }
        let frame = egui::Frame::new().inner_margin(margin);
        let dragged = frame.show(ui, |ui| {
            ui.set_min_size(ui.available_size());
            (self.show)(ui, *pane, !tabbed)
        });
        if dragged.inner { UiResponse::DragStarted } else { UiResponse::None }
    }

    fn tab_title_for_pane(&mut self, pane: &Pane) -> WidgetText {
        pane.title().into()
    }

    fn tab_ui(&mut self, tiles: &mut Tiles<Pane>, ui: &mut Ui, id: Id, tile_id: TileId, state: &TabState) -> Response {
        let Some(Tile::Pane(pane)) = tiles.get(tile_id) else {
            return ui.allocate_response(egui::Vec2::ZERO, Sense::hover());
        };
        tab(ui, id, *pane, (self.badge)(*pane), state, self.colors)
    }

    fn tab_bar_height(&self, _style: &egui::Style) -> f32 {
        TAB_BAR
    }

    fn gap_width(&self, _style: &egui::Style) -> f32 {
        theme::GAP
    }

    fn min_size(&self) -> f32 {
        90.0
    }

    fn resize_stroke(&self, _style: &egui::Style, state: egui_tiles::ResizeState) -> Stroke {
        match state {
            egui_tiles::ResizeState::Idle => Stroke::NONE,
            _ => Stroke::new(2.0, self.colors.plot.accent.gamma_multiply(0.6)),
        }
    }

    fn tab_bar_color(&self, _visuals: &egui::Visuals) -> egui::Color32 {
        egui::Color32::TRANSPARENT
    }

    fn tab_bar_hline_stroke(&self, _visuals: &egui::Visuals) -> Stroke {
        Stroke::NONE
    }

    fn simplification_options(&self) -> SimplificationOptions {
        SimplificationOptions { all_panes_must_have_tabs: false, ..SimplificationOptions::default() }
    }
}

/// A tab: its name, a figure, and a line under it while it is in front.
fn tab(ui: &mut Ui, id: Id, pane: Pane, badge: Option<usize>, state: &TabState, colors: &Colors) -> Response {
    let font = if state.active { theme::strong_font(theme::TEXT) } else { egui::FontId::proportional(theme::TEXT) };
    let color = if state.active { colors.plot.text } else { colors.plot.quiet };
    let title = ui.painter().layout_no_wrap(pane.title().to_owned(), font, color);
    let badge_color = if badge == Some(0) { colors.good } else { colors.plot.wrong };
    let figure = badge
        .map(|n| ui.painter().layout_no_wrap(n.to_string(), egui::FontId::proportional(theme::SMALL), badge_color));
    let badge_width = figure.as_ref().map_or(0.0, |f| f.size().x + 18.0);
    let (_, rect) = ui.allocate_space(egui::vec2(title.size().x + badge_width + 18.0, ui.available_height()));
    let response = ui.interact(rect, id, Sense::click_and_drag());
    response.widget_info(|| egui::WidgetInfo::selected(egui::Role::Tab, true, state.active, pane.title()));
    let text_at = egui::pos2(rect.left() + 12.0, rect.center().y - title.size().y / 2.0);
    let width = title.size().x;
    ui.painter().galley(text_at, title, color);
    if let Some(figure) = figure {
        let ground = if badge == Some(0) { colors.good_ground } else { colors.wrong_ground };
        let size = figure.size() + egui::vec2(11.0, 3.0);
        let pill = Rect::from_min_size(egui::pos2(text_at.x + width + 6.0, rect.center().y - size.y / 2.0), size);
        ui.painter().rect_filled(pill, size.y / 2.0, ground);
        ui.painter().galley(pill.center() - figure.size() / 2.0, figure, badge_color);
    }
    if state.active {
        let line = Rect::from_x_y_ranges(text_at.x..=text_at.x + width, rect.bottom() - 6.0..=rect.bottom() - 4.0);
        ui.painter().rect_filled(line, 1.0, colors.plot.accent);
    }
    response
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_layout_survives_its_text() {
        let mut layout = Layout::standard(Kind::TurnedPart);
        layout.set_shown(Pane::Transfer, false);
        let back = Layout::from_text(Kind::TurnedPart, &layout.to_text().unwrap()).unwrap();
        assert!(!back.is_shown(Pane::Transfer));
        assert!(back.is_shown(Pane::Profile));
    }

    #[test]
    fn a_text_without_every_panel_is_no_layout() {
        assert!(Layout::from_text(Kind::TurnedPart, "{}").is_none());
        assert!(Layout::from_text(Kind::TurnedPart, "").is_none());
    }
}
