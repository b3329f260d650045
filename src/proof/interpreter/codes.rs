//! What the G words of the two dialects mean, and which of them exclude one another.

use super::state::Motion;
use crate::machine::{ArcCenter, Dialect, Words};
use crate::units::Unit;

/// Meaning of a G word.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum G {
    /// How the axis words of this block and the next ones move.
    Motion(Motion),
    /// Wait.
    Dwell,
    /// Unit of lengths.
    Unit(Unit),
    /// X and Z are positions (or moves).
    Absolute(bool),
    /// X counts diameters (or radii).
    Diameter(bool),
    /// Where I and K count from.
    ArcCenter(ArcCenter),
    /// Feed per turn (or per minute).
    PerRev(bool),
    /// S is a cutting speed (or a spindle speed).
    Surface(bool),
    /// Nose radius compensation, with the tool on the left of the path or on the right; off.
    Compensate(Option<Side>),
    /// The same with the nose's diameter and the tip's orientation in the block, D and L.
    CompensateBy(Side),
    /// The present place gets these coordinates, or the speed this limit.
    Preset,
    /// The coordinates are what they were before presets.
    PresetOff,
    /// To the reference point.
    Home,
    /// Machine coordinates for this block.
    MachineCoordinates,
    /// A work offset: the program zero.
    WorkOffset,
    /// Tool offset of LinuxCNC on or off.
    ToolOffset(bool),
    /// G70.
    Finish,
    /// G71, and G72 if `facing`.
    Rough {
        /// Cuts run across the axis.
        facing: bool,
    },
    /// G73.
    Pattern,
    /// G74, and G75 if `groove`.
    Peck {
        /// Pecks run across the axis.
        groove: bool,
    },
    /// G76.
    ThreadCycle,
    /// How exactly LinuxCNC keeps to the path; here it does.
    PathControl,
    /// Known, and of no effect on the path of a lathe's tool.
    NoEffect,
}

/// Side of the path as the code names it on a machine whose X grows upwards in the profile frame.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Side {
    /// G41.
    Left,
    /// G42.
    Right,
}

/// The meaning of G `tenths / 10`; `None` if the control does not know it.
pub(super) fn meaning(tenths: u32, dialect: Dialect, words: &Words) -> Option<G> {
    common(tenths, words).or_else(|| match dialect {
        Dialect::Linuxcnc => linuxcnc(tenths),
        _ => fanuc(tenths, words),
    })
}

fn common(tenths: u32, words: &Words) -> Option<G> {
    Some(match tenths {
        0 => G::Motion(Motion::Rapid),
        10 => G::Motion(Motion::Line),
        20 => G::Motion(Motion::Arc { ccw: words.g2_is_ccw }),
        30 => G::Motion(Motion::Arc { ccw: !words.g2_is_ccw }),
        40 => G::Dwell,
        // The plane of a lathe.
        180 => G::NoEffect,
        200 => G::Unit(Unit::Inch),
        210 => G::Unit(Unit::Mm),
        280 => G::Home,
        400 => G::Compensate(None),
        410 => G::Compensate(Some(Side::Left)),
        420 => G::Compensate(Some(Side::Right)),
        530 => G::MachineCoordinates,
        540 | 550 | 560 | 570 | 580 | 590 => G::WorkOffset,
        760 => G::ThreadCycle,
        800 => G::Motion(Motion::None),
        960 if words.surface_speed => G::Surface(true),
        970 => G::Surface(false),
        _ => return None,
    })
}

fn fanuc(tenths: u32, words: &Words) -> Option<G> {
    Some(match tenths {
        // Checks of stroke and of spindle speed on and off, and the check of the reference point.
        220 | 230 | 250 | 260 | 270 => G::NoEffect,
        320 => G::Motion(Motion::Thread),
        500 => G::Preset,
        700 => G::Finish,
        710 => G::Rough { facing: false },
        720 => G::Rough { facing: true },
        730 => G::Pattern,
        740 => G::Peck { groove: false },
        750 => G::Peck { groove: true },
        900 => G::Motion(Motion::TurnCycle),
        920 => G::Motion(Motion::ThreadCycle),
        940 => G::Motion(Motion::FaceCycle),
        980 => G::PerRev(false),
        990 if words.feed_per_rev => G::PerRev(true),
        _ => return None,
    })
}

fn linuxcnc(tenths: u32) -> Option<G> {
    Some(match tenths {
        70 => G::Diameter(true),
        80 => G::Diameter(false),
        330 => G::Motion(Motion::Thread),
        411 => G::CompensateBy(Side::Left),
        421 => G::CompensateBy(Side::Right),
        430 => G::ToolOffset(true),
        490 => G::ToolOffset(false),
        591..=593 => G::WorkOffset,
        610 | 611 | 640 => G::PathControl,
        // The retract level of drilling cycles.
        980 | 990 => G::NoEffect,
        900 => G::Absolute(true),
        910 => G::Absolute(false),
        901 => G::ArcCenter(ArcCenter::Absolute),
        911 => G::ArcCenter(ArcCenter::Incremental),
        920 => G::Preset,
        921..=923 => G::PresetOff,
        940 => G::PerRev(false),
        950 => G::PerRev(true),
        _ => return None,
    })
}

impl G {
    /// Words with the same number exclude one another in a block.
    pub(super) const fn group(self) -> u8 {
        match self {
            Self::Motion(_) => 1,
            Self::Unit(_) => 2,
            Self::Absolute(_) => 3,
            Self::Diameter(_) => 4,
            Self::ArcCenter(_) => 5,
            Self::PerRev(_) => 6,
            Self::Surface(_) => 7,
            Self::Compensate(_) | Self::CompensateBy(_) => 8,
            Self::WorkOffset => 9,
            Self::ToolOffset(_) => 10,
            Self::Dwell
            | Self::Preset
            | Self::PresetOff
            | Self::Home
            | Self::Finish
            | Self::Rough { .. }
            | Self::Pattern
            | Self::Peck { .. }
            | Self::ThreadCycle => 11,
            Self::MachineCoordinates | Self::PathControl | Self::NoEffect => 0,
        }
    }
}
