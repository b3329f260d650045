//! Type, colours and spacing of the window, for the light and the dark theme.

use super::plots::Palette;
use egui::{
    Color32, CornerRadius, FontData, FontDefinitions, FontFamily, FontId, Margin, RichText, Stroke, TextStyle, Theme,
    Visuals,
};
use std::sync::Arc;

/// Size of text, points.
pub(crate) const TEXT: f32 = 12.5;
/// Size of the program text and the log, points.
pub(crate) const CODE: f32 = 12.0;
/// Size of remarks, points.
pub(crate) const SMALL: f32 = 11.0;
/// Space between panels and around the desk, points.
pub(crate) const GAP: f32 = 8.0;
/// Space between the edge of a panel and what it holds, points.
pub(crate) const PAD: i8 = 12;
/// Height of one row of a table, points.
pub(crate) const ROW: f32 = 27.0;

const STRONG: &str = "strong";

const fn rgb(hex: u32) -> Color32 {
    let [_, r, g, b] = hex.to_be_bytes();
    Color32::from_rgb(r, g, b)
}

/// Colours of the window by role, beside the plots' [`Palette`].
#[derive(Debug, Clone, Copy)]
pub(crate) struct Colors {
    /// Colours shared with the plots.
    pub(crate) plot: Palette,
    /// Behind the panels.
    pub(crate) ground: Color32,
    /// Panels.
    pub(crate) panel: Color32,
    /// Lines between panels and rows.
    pub(crate) line: Color32,
    /// Border of fields and quiet buttons.
    pub(crate) field_line: Color32,
    /// Field that holds a bad value.
    pub(crate) wrong_field: Color32,
    /// Selected row.
    pub(crate) selected: Color32,
    /// Row under the pointer.
    pub(crate) hovered: Color32,
    /// The current block of a program.
    pub(crate) current: Color32,
    /// Good.
    pub(crate) good: Color32,
    /// Behind a word that says good.
    pub(crate) good_ground: Color32,
    /// Behind a word that says wrong.
    pub(crate) wrong_ground: Color32,
    /// Boxes with remarks, the log, code.
    pub(crate) inset: Color32,
    /// Tool words of a program.
    pub(crate) word_tool: Color32,
    /// Spindle speed words of a program.
    pub(crate) word_speed: Color32,
    /// Text on the accent colour.
    pub(crate) on_accent: Color32,
}

impl Colors {
    const LIGHT: Self = Self {
        plot: Palette::LIGHT,
        ground: rgb(0xF4_F5F7),
        panel: rgb(0xFF_FFFF),
        line: rgb(0xE1_E4E8),
        field_line: rgb(0xD5_DAE0),
        wrong_field: rgb(0xFD_EFE6),
        selected: rgb(0xE8_F0FA),
        hovered: rgb(0xF4_F7FB),
        current: rgb(0xFF_F4DA),
        good: rgb(0x00_7A59),
        good_ground: rgb(0xE3_F5EF),
        wrong_ground: rgb(0xFC_EADF),
        inset: rgb(0xF4_F5F7),
        word_tool: rgb(0x9C_3F78),
        word_speed: rgb(0x8A_5A00),
        on_accent: rgb(0xFF_FFFF),
    };
    const DARK: Self = Self {
        plot: Palette::DARK,
        ground: rgb(0x12_161B),
        panel: rgb(0x1A_1F26),
        line: rgb(0x2B_323B),
        field_line: rgb(0x3A_424D),
        wrong_field: rgb(0x3D_2719),
        selected: rgb(0x20_3450),
        hovered: rgb(0x22_2933),
        current: rgb(0x40_3518),
        good: rgb(0x3F_C99D),
        good_ground: rgb(0x17_3A30),
        wrong_ground: rgb(0x43_2917),
        inset: rgb(0x13_171D),
        word_tool: rgb(0xD9_8DB8),
        word_speed: rgb(0xE0_B050),
        on_accent: rgb(0x0E_1A28),
    };

    /// The colours that go with the visuals in use.
    #[must_use]
    pub(crate) const fn of(visuals: &Visuals) -> &'static Self {
        if visuals.dark_mode { &Self::DARK } else { &Self::LIGHT }
    }
}

/// Installs fonts and both themes; light where the system does not say which it wants.
pub fn install(ctx: &egui::Context) {
    ctx.set_fonts(fonts());
    ctx.options_mut(|options| options.fallback_theme = Theme::Light);
    for theme in [Theme::Light, Theme::Dark] {
        ctx.style_mut_of(theme, |style| {
            dress(style, if theme == Theme::Dark { &Colors::DARK } else { &Colors::LIGHT });
        });
    }
}

fn fonts() -> FontDefinitions {
    let mut fonts = FontDefinitions::default();
    let bundled: [(&str, &'static [u8]); 3] = [
        ("inter", include_bytes!("../../assets/fonts/Inter-Regular.otf")),
        ("inter-semi-bold", include_bytes!("../../assets/fonts/Inter-SemiBold.otf")),
        ("jetbrains-mono", include_bytes!("../../assets/fonts/JetBrainsMono-Regular.ttf")),
    ];
    for (name, bytes) in bundled {
        fonts.font_data.insert(name.to_owned(), Arc::new(FontData::from_static(bytes)));
    }
    let fallback = fonts.families.get(&FontFamily::Proportional).cloned().unwrap_or_default();
    let after = |first: &str| [vec![first.to_owned()], fallback.clone()].concat();
    fonts.families.insert(FontFamily::Name(STRONG.into()), after("inter-semi-bold"));
    fonts.families.insert(FontFamily::Proportional, after("inter"));
    fonts.families.entry(FontFamily::Monospace).or_default().insert(0, "jetbrains-mono".to_owned());
    fonts
}

fn dress(style: &mut egui::Style, colors: &Colors) {
    style.text_styles = [
        (TextStyle::Small, FontId::proportional(SMALL)),
        (TextStyle::Body, FontId::proportional(TEXT)),
        (TextStyle::Button, FontId::proportional(TEXT)),
        (TextStyle::Heading, strong_font(TEXT)),
        (TextStyle::Monospace, FontId::monospace(CODE)),
    ]
    .into();
    let spacing = &mut style.spacing;
    spacing.item_spacing = egui::vec2(8.0, 5.0);
    spacing.button_padding = egui::vec2(10.0, 4.0);
    spacing.interact_size = egui::vec2(32.0, 24.0);
    spacing.menu_margin = Margin::same(6);
    spacing.scroll.bar_width = 7.0;
    style.visuals = visuals(colors);
}

fn visuals(colors: &Colors) -> Visuals {
    let mut v = if colors.plot.dark { Visuals::dark() } else { Visuals::light() };
    let p = &colors.plot;
    v.override_text_color = None;
    v.weak_text_color = Some(p.quiet);
    v.hyperlink_color = p.accent;
    v.panel_fill = colors.ground;
    v.window_fill = colors.panel;
    v.window_stroke = Stroke::new(1.0, colors.line);
    v.extreme_bg_color = colors.panel;
    v.faint_bg_color = colors.hovered;
    v.code_bg_color = colors.inset;
    v.error_fg_color = p.wrong;
    v.warn_fg_color = p.unreachable;
    v.selection.bg_fill = colors.selected;
    v.selection.stroke = Stroke::new(1.0, p.accent);
    v.window_corner_radius = CornerRadius::same(8);
    v.menu_corner_radius = CornerRadius::same(8);
    let w = &mut v.widgets;
    for state in [&mut w.noninteractive, &mut w.inactive, &mut w.hovered, &mut w.active, &mut w.open] {
        state.corner_radius = CornerRadius::same(5);
        state.fg_stroke = Stroke::new(1.0, p.text);
        state.expansion = 0.0;
    }
    w.noninteractive.bg_stroke = Stroke::new(1.0, colors.line);
    w.noninteractive.bg_fill = colors.panel;
    w.inactive.bg_fill = colors.line;
    w.inactive.weak_bg_fill = colors.panel;
    w.inactive.bg_stroke = Stroke::new(1.0, colors.field_line);
    w.hovered.bg_fill = colors.field_line;
    w.hovered.weak_bg_fill = colors.hovered;
    w.hovered.bg_stroke = Stroke::new(1.0, p.construction);
    w.active.bg_fill = p.accent;
    w.active.weak_bg_fill = colors.selected;
    w.active.bg_stroke = Stroke::new(1.0, p.accent);
    w.open.bg_fill = colors.hovered;
    w.open.weak_bg_fill = colors.hovered;
    w.open.bg_stroke = Stroke::new(1.0, colors.field_line);
    v
}

/// The semi-bold font.
#[must_use]
pub(crate) fn strong_font(size: f32) -> FontId {
    FontId::new(size, FontFamily::Name(STRONG.into()))
}

/// Semi-bold text.
pub(crate) fn strong(text: impl Into<String>) -> RichText {
    RichText::new(text).font(strong_font(TEXT))
}

/// Text that explains.
pub(crate) fn quiet(text: impl Into<String>, colors: &Colors) -> RichText {
    RichText::new(text).color(colors.plot.quiet)
}
