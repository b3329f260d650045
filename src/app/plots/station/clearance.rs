//! The opening between a roll and the strip, and its colours.

use crate::app::plots::palette::Palette;
use crate::geometry::{Contour, Location, Point};
use egui::Color32;

/// Nearer than this a roll touches the strip, mm.
const TOUCH_MM: f64 = 0.005;
/// Further away a roll has nothing to do with the strip, as a multiple of its thickness.
const FAR: f64 = 2.0;

/// How a place of a roll stands to the strip.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Opening {
    /// Inside the strip by so much, mm.
    Pressed(f64),
    /// Touching.
    Touching,
    /// Clear of it by so much, mm.
    Clear(f64),
    /// Far from it.
    Far,
}

impl Opening {
    /// The opening at `p`; `strip` is the closed outline.
    pub(super) fn at(p: Point, strip: &Contour, thickness: f64) -> Self {
        let distance = strip.distance_to(p);
        match distance {
            d if d <= TOUCH_MM => Self::Touching,
            d if d > FAR * thickness => Self::Far,
            d if strip.locate(p, TOUCH_MM) == Location::Inside => Self::Pressed(d),
            d => Self::Clear(d),
        }
    }

    /// Its colour; none for a place that has nothing to do with the strip.
    pub(super) const fn color(self, palette: &Palette) -> Option<Color32> {
        match self {
            Self::Pressed(_) => Some(palette.wrong),
            Self::Touching => Some(palette.accent),
            Self::Clear(_) => Some(palette.unreachable),
            Self::Far => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_place_is_inside_on_or_clear_of_the_strip() {
        let corners = [(0.0, 0.0), (10.0, 0.0), (10.0, 1.0), (0.0, 1.0)].map(|(z, r)| Point::new(z, r));
        let mut ring = corners.to_vec();
        ring.push(corners[0]);
        let strip = Contour::polygon(&ring);
        let at = |z, r| Opening::at(Point::new(z, r), &strip, 1.0);
        assert!(matches!(at(5.0, 0.9), Opening::Pressed(d) if (d - 0.1).abs() < 1e-9));
        assert_eq!(at(5.0, 1.0), Opening::Touching);
        assert!(matches!(at(5.0, 1.1), Opening::Clear(d) if (d - 0.1).abs() < 1e-9));
        assert_eq!(at(5.0, 9.0), Opening::Far);
    }
}
