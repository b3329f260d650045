//! Colours of the plots by role, for the light and the dark theme.

use crate::turning::{Operation, OperationKind};
use egui::Color32;

/// What every colour of a plot stands for. Operations and states use the Okabe-Ito set, which colour-blind people can
/// tell apart; red-orange is kept for what is wrong.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Palette {
    /// True for the dark theme.
    pub dark: bool,
    /// Background of a plot.
    pub ground: Color32,
    /// Text that matters.
    pub text: Color32,
    /// Text and lines that explain.
    pub quiet: Color32,
    /// Grid lines.
    pub grid: Color32,
    /// Centre line and construction lines.
    pub construction: Color32,
    /// Cut surface of the part.
    pub part: Color32,
    /// The half of the part that only mirrors the other.
    pub part_mirror: Color32,
    /// Edge of the part.
    pub edge: Color32,
    /// Edge of the mirrored half.
    pub edge_mirror: Color32,
    /// Material still to be cut.
    pub stock: Color32,
    /// Edge of the stock.
    pub stock_edge: Color32,
    /// Chuck jaws and tool holders.
    pub steel: Color32,
    /// Edge of chuck jaws and tool holders.
    pub steel_edge: Color32,
    /// Cutting inserts.
    pub insert: Color32,
    /// What is selected or can be taken hold of.
    pub accent: Color32,
    /// What is wrong: gouges, collisions.
    pub wrong: Color32,
    /// Areas that a tool cannot reach.
    pub unreachable: Color32,
    /// Background of a tooltip.
    pub tip: Color32,
    /// Text of a tooltip.
    pub tip_text: Color32,
}

const fn rgb(hex: u32) -> Color32 {
    let [_, r, g, b] = hex.to_be_bytes();
    Color32::from_rgb(r, g, b)
}

impl Palette {
    /// Colours on a white panel.
    pub const LIGHT: Self = Self {
        dark: false,
        ground: rgb(0xFF_FFFF),
        text: rgb(0x1F_2933),
        quiet: rgb(0x7B_8794),
        grid: rgb(0xEE_F0F3),
        construction: rgb(0x9A_A5B1),
        part: rgb(0xDC_E6F1),
        part_mirror: rgb(0xED_F2F8),
        edge: rgb(0x1F_2933),
        edge_mirror: rgb(0x9A_A5B1),
        stock: rgb(0xF6_EBD0),
        stock_edge: rgb(0xCF_BB86),
        steel: rgb(0xDF_E3E8),
        steel_edge: rgb(0x9A_A5B1),
        insert: rgb(0xF2_C849),
        accent: rgb(0x0B_62C4),
        wrong: rgb(0xD5_5E00),
        unreachable: rgb(0xE6_9F00),
        tip: rgb(0x1F_2933),
        tip_text: rgb(0xFF_FFFF),
    };

    /// Colours on a dark panel, same roles.
    pub const DARK: Self = Self {
        dark: true,
        ground: rgb(0x1A_1F26),
        text: rgb(0xE4_E7EB),
        quiet: rgb(0x8A_95A3),
        grid: rgb(0x24_2A33),
        construction: rgb(0x6B_7684),
        part: rgb(0x2C_3E54),
        part_mirror: rgb(0x22_2E3D),
        edge: rgb(0xDB_E2EA),
        edge_mirror: rgb(0x6B_7684),
        stock: rgb(0x3B_3523),
        stock_edge: rgb(0x80_7145),
        steel: rgb(0x30_3740),
        steel_edge: rgb(0x6B_7684),
        insert: rgb(0xD9_AE33),
        accent: rgb(0x5A_A2F0),
        wrong: rgb(0xF0_7A26),
        unreachable: rgb(0xE6_9F00),
        tip: rgb(0xE4_E7EB),
        tip_text: rgb(0x1A_1F26),
    };

    /// The palette that goes with the visuals in use.
    #[must_use]
    pub const fn of(visuals: &egui::Visuals) -> Self {
        if visuals.dark_mode { Self::DARK } else { Self::LIGHT }
    }

    /// Colour of the part in the round, before shading.
    #[must_use]
    pub const fn part_solid(&self) -> Color32 {
        rgb(if self.dark { 0x9F_B8D6 } else { 0xC6_D8EC })
    }

    /// Colour of an operation; `None` stands for the start and end of a program.
    #[must_use]
    pub const fn operation(&self, kind: Option<OperationKind>) -> Color32 {
        let (light, dark) = match kind {
            Some(OperationKind::RoughRight | OperationKind::RoughBore) => (0x00_72B2, 0x3D_9BDC),
            Some(OperationKind::FinishRight | OperationKind::FinishBore) => (0x00_9E73, 0x1F_BF92),
            Some(OperationKind::RoughLeft | OperationKind::Pocket) => (0xE6_9F00, 0xE6_9F00),
            Some(OperationKind::FinishLeft) => (0xCC_79A7, 0xD9_8DB8),
            Some(OperationKind::Thread | OperationKind::ThreadBore | OperationKind::Groove) => (0x56_B4E9, 0x7C_C6F0),
            Some(OperationKind::PartOff | OperationKind::Face | OperationKind::Drill) => (0x52_606D, 0xC3_CBD4),
            None => (0xB8_C0CA, 0x59_6370),
        };
        rgb(if self.dark { dark } else { light })
    }

    /// Colour of every operation in order: that of its kind, or one after the other where two of a kind do something.
    #[must_use]
    pub fn operations(&self, operations: &[Operation]) -> Vec<Color32> {
        let busy = || operations.iter().filter(|o| !o.moves.is_empty());
        let repeated = busy().any(|o| busy().filter(|other| other.kind == o.kind).count() > 1);
        if !repeated {
            return operations.iter().map(|o| self.operation(Some(o.kind))).collect();
        }
        let mut turn = SERIES.iter().cycle();
        let mut next = || turn.next().map_or(self.text, |&kind| self.operation(Some(kind)));
        operations.iter().map(|o| if o.moves.is_empty() { self.quiet } else { next() }).collect()
    }

    /// Colour of material left on the part, by how many times the tolerance it is thick: yellow, orange, brown.
    #[must_use]
    pub const fn leftover(&self, class: LeftoverClass) -> Color32 {
        match class {
            LeftoverClass::Within => self.edge,
            LeftoverClass::Little => rgb(0xE3_D33A),
            LeftoverClass::Some => rgb(0xE6_9F00),
            LeftoverClass::Much => rgb(if self.dark { 0xC0_7A3E } else { 0x8C_510A }),
        }
    }
}

/// Kinds whose colours all differ, for operations that are told apart by their place in the order.
const SERIES: [OperationKind; 6] = [
    OperationKind::RoughRight,
    OperationKind::RoughLeft,
    OperationKind::FinishRight,
    OperationKind::FinishLeft,
    OperationKind::Groove,
    OperationKind::Face,
];

/// How much material is left, in classes of the tolerance.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum LeftoverClass {
    /// Within the tolerance.
    Within,
    /// Up to 4 times the tolerance.
    Little,
    /// Up to 16 times the tolerance.
    Some,
    /// More.
    Much,
}

impl LeftoverClass {
    /// Upper ends of the classes below [`Self::Much`], as multiples of the tolerance.
    pub const STEPS: [f64; 3] = [1.0, 4.0, 16.0];

    /// The class of `left_mm` of material where `tolerance_mm` is allowed.
    #[must_use]
    pub fn of(left_mm: f64, tolerance_mm: f64) -> Self {
        let [within, little, some] = Self::STEPS.map(|step| step * tolerance_mm);
        match left_mm {
            left if left <= within => Self::Within,
            left if left <= little => Self::Little,
            left if left <= some => Self::Some,
            _ => Self::Much,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn operations_of_one_kind_differ_in_colour() {
        let operation = |kind| Operation {
            kind,
            name: String::new(),
            tool: 1,
            change: None,
            moves: vec![crate::turning::CutMove::Dwell { seconds: 1.0 }],
            recipes: Vec::new(),
        };
        let palette = Palette::LIGHT;
        let kinds = [OperationKind::RoughRight, OperationKind::FinishRight];
        assert_eq!(palette.operations(&kinds.map(operation)), kinds.map(|kind| palette.operation(Some(kind))));
        let same = palette.operations(&[OperationKind::FinishRight; 6].map(operation));
        for (index, color) in same.iter().enumerate() {
            assert!(!same[..index].contains(color), "{same:?}");
            assert_ne!(*color, palette.wrong);
        }
    }

    #[test]
    fn leftover_classes_follow_the_tolerance() {
        assert_eq!(LeftoverClass::of(0.01, 0.02), LeftoverClass::Within);
        assert_eq!(LeftoverClass::of(0.05, 0.02), LeftoverClass::Little);
        assert_eq!(LeftoverClass::of(0.2, 0.02), LeftoverClass::Some);
        assert_eq!(LeftoverClass::of(2.0, 0.02), LeftoverClass::Much);
    }
}
