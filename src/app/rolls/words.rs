//! Words and figures that the panels of a set share.

use crate::document::{DevelopedWidth, Element, Opening, Origin, RollSet};
use crate::machine::Catalog;
use crate::units::{Unit, parse_length};

/// Decimals of an angle on the screen, degrees.
const ANGLE_DECIMALS: usize = 3;

/// What an origin is called.
pub(super) const fn origin(origin: Origin) -> &'static str {
    match origin {
        Origin::LeftToRight => "left to right",
        Origin::RightToLeft => "right to left",
        Origin::CentreRightFirst => "centre, right first",
        Origin::CentreLeftFirst => "centre, left first",
        Origin::Symmetrical => "symmetrical",
    }
}

/// What a method of the developed width is called.
pub(super) const fn width_method(method: DevelopedWidth) -> &'static str {
    match method {
        DevelopedWidth::MeanLine => "r + t/2",
        DevelopedWidth::RolfomTable => "ROLFOM table",
        DevelopedWidth::Din6935 => "DIN 6935",
        DevelopedWidth::Asm => "ASM",
        DevelopedWidth::AsmLessFormable => "ASM, brittle",
        DevelopedWidth::Angel => "Angel",
        DevelopedWidth::Own { .. } => "own k",
    }
}

/// What stays constant while a bend opens.
pub(super) const fn opening(opening: Opening) -> &'static str {
    match opening {
        Opening::MeanLine => "mean r × θ",
        Opening::InsideRadius => "inside r × θ",
        Opening::ConstantRadius => "constant r",
    }
}

/// Number of an element as it stands in its table; of the other side's list with a stroke behind it.
pub(super) fn number(set: &RollSet, id: u32) -> String {
    let in_list = |list: &[Element]| list.iter().position(|e| e.id == id).map(|index| index + 1);
    let other = || in_list(&set.section.other_side).map(|n| format!("{n}'"));
    in_list(&set.section.elements).map(|n| n.to_string()).or_else(other).unwrap_or_else(|| "?".to_owned())
}

/// Names of the materials of a unit in small letters, and the present one if the table has it not.
pub(super) fn material_names(catalog: &Catalog, unit: Unit, present: Option<String>) -> Vec<String> {
    let of_unit = catalog.materials.iter().filter(|material| material.unit == unit);
    let names: Vec<String> = of_unit.map(|material| material.name.to_lowercase()).collect();
    let unknown = present.filter(|name| !names.contains(name));
    unknown.into_iter().chain(names).collect()
}

/// An angle without needless zeros.
pub(super) fn angle(deg: f64) -> String {
    plain(deg, ANGLE_DECIMALS)
}

/// A figure with at most so many decimals, without needless zeros.
pub(super) fn plain(value: f64, decimals: usize) -> String {
    let text = crate::app::plots::fixed(value, decimals);
    if !text.contains('.') {
        return text;
    }
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

/// Reads an angle, degrees, or an expression of angles.
pub(super) fn parse_angle(text: &str) -> Result<f64, String> {
    plain_figure(text.trim().trim_end_matches('°'), "an angle in degrees such as 45 or -22.5")
}

/// Reads a figure without a unit, or an expression of figures.
pub(super) fn parse_figure(text: &str) -> Result<f64, String> {
    plain_figure(text, "a figure such as 0.5")
}

fn plain_figure(text: &str, what: &str) -> Result<f64, String> {
    if text.contains(|c: char| c.is_alphabetic() || c == '"') {
        return Err(format!("“{text}” is no figure. Type {what}."));
    }
    parse_length(text, Unit::Mm).map_err(|_| format!("“{text}” cannot be read. Type {what}."))
}
