//! What a turning tool can reach: behind a wall it needs room, along a line of 45 degrees from the wall's top.
//!
//! e(z) = max( s(z), max over z' > z of s(z') − (z' − z) ) for a tool that cuts towards smaller z. The tool of the other
//! hand sees the same surface mirrored.

use super::span::{SAME_MM, Span};
use super::surface::Surface;

/// Areas lower than this are cut through along the contour, mm. Arcs that are a little steeper than 45 degrees at one end
/// make such slivers (up to 0.035 mm in the published queen); they are not worth a change of tool.
pub(super) const LOWEST_AREA_MM: f64 = 0.05;

/// What a tool cutting towards smaller z leaves of a surface.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Envelope {
    /// The surface with a 45-degree line over every area that cannot be reached.
    pub(super) surface: Surface,
    /// The areas under those lines, in order of z.
    pub(super) shadows: Vec<Shadow>,
}

/// An area that cannot be reached: between the surface and the line `r = z + k`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Shadow {
    pub(super) z0: f64,
    pub(super) z1: f64,
    pub(super) k: f64,
    /// Greatest height of the line above the surface, mm.
    pub(super) height: f64,
}

impl Shadow {
    /// True if the area is worth cutting with the tool of the other hand.
    pub(super) fn is_worth_cutting(&self) -> bool {
        self.height >= LOWEST_AREA_MM
    }

    fn span(&self) -> Span {
        Span::diagonal(self.z0, self.z1, self.k)
    }
}

impl Envelope {
    /// The envelope of `surface`.
    pub(super) fn of(surface: &Surface) -> Self {
        let mut walk = Walk { k: f64::NEG_INFINITY, shadows: Vec::new() };
        for span in surface.spans.iter().rev() {
            let middle = span.tangent_at_45_degrees().unwrap_or(span.z0);
            for part in [span.clipped(middle, span.z1), span.clipped(span.z0, middle)].into_iter().flatten() {
                walk.pass(&part);
            }
        }
        let mut shadows = walk.shadows;
        shadows.reverse();
        for shadow in &mut shadows {
            shadow.height = height_above(shadow, surface);
        }
        Self { surface: covered(surface, &shadows), shadows }
    }

    /// The contour that the tool finishes: the surface, with the 45-degree line over every area worth a change of tool.
    pub(super) fn finished(&self, surface: &Surface) -> Surface {
        let kept: Vec<Shadow> = self.shadows.iter().copied().filter(Shadow::is_worth_cutting).collect();
        covered(surface, &kept)
    }

    /// The envelope with z turned round, its areas left out.
    pub(super) fn mirrored_surface(&self) -> Surface {
        self.surface.mirrored()
    }
}

/// Going from the free end towards the chuck: `k` is the greatest `r − z` met so far.
struct Walk {
    k: f64,
    shadows: Vec<Shadow>,
}

impl Walk {
    /// Goes over a span on which `r − z` only rises or only falls.
    fn pass(&mut self, span: &Span) {
        let at_left = span.at(span.z0) - span.z0;
        let at_right = span.at(span.z1) - span.z1;
        if at_left < at_right - SAME_MM {
            self.k = self.k.max(at_right);
            self.cast(span.z0, span.z1);
        } else if at_right >= self.k - SAME_MM {
            self.k = self.k.max(at_left);
        } else if at_left <= self.k {
            self.cast(span.z0, span.z1);
        } else {
            let z = span.meets(1.0, self.k).last().copied().unwrap_or(span.z1);
            self.cast(z, span.z1);
            self.k = at_left;
        }
    }

    fn cast(&mut self, z0: f64, z1: f64) {
        let k = self.k;
        match self.shadows.last_mut() {
            Some(last) if last.k == k && last.z0 - z1 <= SAME_MM => last.z0 = z0,
            _ if z1 - z0 > SAME_MM => self.shadows.push(Shadow { z0, z1, k, height: 0.0 }),
            _ => {}
        }
    }
}

fn height_above(shadow: &Shadow, surface: &Surface) -> f64 {
    let under = surface.clipped(shadow.z0, shadow.z1);
    let places = under.spans.iter().flat_map(|s| {
        [Some(s.z0), s.tangent_at_45_degrees(), Some(s.z1)].into_iter().flatten().map(|z| z + shadow.k - s.at(z))
    });
    places.fold(0.0, f64::max)
}

/// `surface` with every area of `shadows` replaced by its 45-degree line.
fn covered(surface: &Surface, shadows: &[Shadow]) -> Surface {
    let mut spans = Vec::new();
    let mut from = f64::NEG_INFINITY;
    for shadow in shadows {
        spans.extend(surface.clipped(from, shadow.z0).spans);
        spans.push(shadow.span());
        from = shadow.z1;
    }
    spans.extend(surface.clipped(from, f64::INFINITY).spans);
    Surface { spans }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Point, Segment};
    use proptest::prelude::*;

    fn surface(corners: &[(f64, f64)]) -> Surface {
        let points: Vec<Point> = corners.iter().map(|&(z, r)| Point::new(z, r)).collect();
        let segments: Vec<Segment> = points.windows(2).map(|w| Segment::line(w[0], w[1])).collect();
        Surface::new(&segments)
    }

    #[test]
    fn a_wall_casts_a_line_of_45_degrees() {
        let e = Envelope::of(&surface(&[(0.0, 5.0), (10.0, 5.0), (10.0, 8.0), (12.0, 8.0)]));
        assert_eq!(e.shadows, [Shadow { z0: 7.0, z1: 10.0, k: -2.0, height: 3.0 }]);
        assert_eq!(e.surface.spans.len(), 3);
    }

    #[test]
    fn a_slope_below_45_degrees_casts_none() {
        assert!(Envelope::of(&surface(&[(0.0, 5.0), (10.0, 14.0), (12.0, 8.0), (12.0, 1.0)])).shadows.is_empty());
    }

    proptest! {
        #[test]
        fn the_envelope_equals_its_definition(radii in proptest::collection::vec(0.5..12.0_f64, 3..12), probe in 0.0..1.0_f64) {
            let corners: Vec<(f64, f64)> = radii.iter().enumerate().map(|(k, &r)| (k as f64 * 2.5, r)).collect();
            let s = surface(&corners);
            let e = Envelope::of(&s).surface;
            let z = probe * corners[corners.len() - 1].0;
            let at = |surface: &Surface, z: f64| {
                surface.spans.iter().find(|p| z >= p.z0 && z <= p.z1).map(|p| p.at(z)).unwrap()
            };
            let behind = corners.iter().filter(|c| c.0 > z).map(|c| c.1 - (c.0 - z)).fold(at(&s, z), f64::max);
            prop_assert!((at(&e, z) - behind).abs() < 1e-6, "{} {}", at(&e, z), behind);
        }
    }
}
