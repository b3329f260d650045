//! The developed width of a section: the strip that it is bent from, by the methods that the trade has names for.
//!
//! One file a method. Every method says how long a bend is in the flat strip; lines keep their length. The rolls of the
//! published sets follow the mean line, whatever method gives the strip size.

mod angel;
mod asm;
mod din6935;
mod rolfom;

use super::bends;
use crate::document::{CrossSection, DevelopedWidth, Element, ElementKind, Origin};

pub use din6935::length_difference_mm as din6935_length_difference_mm;

/// Length of an element in the flat strip.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MeanLength {
    /// Id of the element.
    pub element: u32,
    /// Its length, mm.
    pub length: f64,
}

/// The flat strip of a section.
#[derive(Debug, Clone, PartialEq)]
pub struct Developed {
    /// Width of the strip, mm; of a symmetrical section both sides together.
    pub width: f64,
    /// Length of every element of both lists, in their order.
    pub lengths: Vec<MeanLength>,
}

/// The flat strip of a section in mm by one method.
#[must_use]
pub fn developed(section: &CrossSection, method: DevelopedWidth) -> Developed {
    let length = |e: &Element| MeanLength { element: e.id, length: element_mm(&e.kind, section.thickness, method) };
    let lengths: Vec<MeanLength> = section.all().map(length).collect();
    let listed: f64 = lengths.iter().map(|l| l.length).sum();
    let sides = if section.origin == Origin::Symmetrical { 2.0 } else { 1.0 };
    Developed { width: listed * sides, lengths }
}

/// Length of one element in the flat strip, mm.
#[must_use]
pub fn element_mm(kind: &ElementKind, thickness: f64, method: DevelopedWidth) -> f64 {
    match *kind {
        ElementKind::Line { length } => length,
        ElementKind::Bend { inside_radius, angle_deg } => bend_mm(inside_radius, angle_deg.abs(), thickness, method),
    }
}

fn bend_mm(radius: f64, angle_deg: f64, thickness: f64, method: DevelopedWidth) -> f64 {
    let about = |neutral_radius: f64| neutral_radius * angle_deg.to_radians();
    match method {
        DevelopedWidth::MeanLine => bends::mean_length(radius, angle_deg, thickness),
        DevelopedWidth::RolfomTable => about(radius + rolfom::factor(angle_deg) * thickness),
        DevelopedWidth::Din6935 => about(radius + din6935::factor(radius, thickness) * thickness / 2.0),
        DevelopedWidth::Asm => about(radius + asm::factor(radius, thickness, asm::Metal::Normal) * thickness),
        DevelopedWidth::AsmLessFormable => {
            about(radius + asm::factor(radius, thickness, asm::Metal::LessFormable) * thickness)
        }
        DevelopedWidth::Angel => angel::allowance_mm(radius, angle_deg, thickness),
        DevelopedWidth::Own { k } => about(radius + k * thickness),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rollform::fixtures::{bend, line, published, set};

    fn width(method: DevelopedWidth) -> f64 {
        developed(&published().section, method).width
    }

    fn near(value: f64, wanted: f64) {
        assert!((value - wanted).abs() < 0.0005, "{value} is not {wanted}");
    }

    #[test]
    fn published_section_has_the_strip_sizes_of_its_reference() {
        near(width(DevelopedWidth::RolfomTable), 111.950);
        near(width(DevelopedWidth::MeanLine), 112.844);
        near(width(DevelopedWidth::Own { k: 0.5 }), 112.844);
    }

    #[test]
    fn every_method_has_its_width_of_the_published_section() {
        let methods = [
            DevelopedWidth::RolfomTable,
            DevelopedWidth::MeanLine,
            DevelopedWidth::Din6935,
            DevelopedWidth::Asm,
            DevelopedWidth::AsmLessFormable,
            DevelopedWidth::Angel,
            DevelopedWidth::Own { k: 0.4 },
        ];
        for method in methods {
            println!("{method:?}: {:.4} mm", width(method));
            assert!((width(method) - 112.4).abs() < 1.0, "{method:?}: {}", width(method));
        }
    }

    #[test]
    fn a_thicker_share_never_makes_the_strip_narrower() {
        let widths = [0.0, 0.3, 0.4, 0.5, 1.0].map(|k| width(DevelopedWidth::Own { k }));
        assert!(widths.is_sorted());
        for method in
            [DevelopedWidth::Din6935, DevelopedWidth::Asm, DevelopedWidth::AsmLessFormable, DevelopedWidth::Angel]
        {
            assert!(width(method) > widths[0] && width(method) < widths[4], "{method:?}");
        }
    }

    #[test]
    fn every_element_has_its_length_and_they_sum_to_the_width() {
        let developed = developed(&published().section, DevelopedWidth::MeanLine);
        let of = |id: u32| developed.lengths.iter().find(|l| l.element == id).unwrap().length;
        assert_eq!(of(1), 40.6499);
        near(of(10), 1.3744);
        near(of(12), 1.8239);
        near(developed.lengths.iter().map(|l| l.length).sum::<f64>() * 2.0, developed.width);
    }

    #[test]
    fn legs_measured_outside_give_the_same_strip_as_lines_and_a_bend() {
        // Legs of 100 mm measured outside, 3 mm strip, 3 mm radius, square: 94 mm lines and the bend between them.
        let elements = vec![line(1, 94.0), bend(2, 3.0, 90.0), line(3, 94.0)];
        let section = set(3.0, Origin::LeftToRight, elements, Vec::new()).section;
        near(developed(&section, DevelopedWidth::Din6935).width, 194.244);
        near(200.0 + din6935_length_difference_mm(90.0, 3.0, 3.0), 194.244);
    }

    #[test]
    fn one_sided_section_is_not_doubled() {
        let section = CrossSection { origin: Origin::LeftToRight, ..published().section };
        near(developed(&section, DevelopedWidth::MeanLine).width, 112.844 / 2.0);
    }
}
