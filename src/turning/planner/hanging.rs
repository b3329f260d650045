//! Stock that hangs over what was cut: a leaning edge leaves slivers on the wall behind it, one above the other where it cut in
//! several levels.

use super::chain::{Chain, Run};
use super::surface::Surface;
use std::cmp::Ordering;

/// What is thinner than this everywhere is gone, mm: rounding.
const GONE_MM: f64 = 1e-6;

/// What lies between two functions over one stretch.
#[derive(Debug, Clone, PartialEq)]
struct Band {
    z0: f64,
    z1: f64,
    /// Smallest value of `low` and largest of `high`, mm.
    bottom: f64,
    top: f64,
    low: Chain,
    high: Chain,
}

/// All that hangs over, in order of where it begins.
#[derive(Debug, Clone, Default, PartialEq)]
pub(super) struct Hanging {
    bands: Vec<Band>,
    /// Width of the widest, mm: what begins further away does not reach here.
    widest: f64,
}

impl Band {
    /// What lies between two functions wherever there is something.
    fn between(low: &Chain, high: &Chain) -> impl Iterator<Item = Self> {
        let runs = high.runs_over(low, GONE_MM).into_iter();
        runs.filter_map(|Run { z0, z1 }| Self::of(low.clipped(z0, z1), high.clipped(z0, z1)))
    }

    fn of(low: Chain, high: Chain) -> Option<Self> {
        let (z0, z1) = low.ends()?;
        Some(Self { z0, z1, bottom: low.lowest(z0, z1), top: high.top(), low, high })
    }

    fn clipped(&self, z0: f64, z1: f64) -> Option<Self> {
        Self::of(self.low.clipped(z0, z1), self.high.clipped(z0, z1))
    }

    /// By where they begin; of those that begin together the lowest first.
    fn order(&self, other: &Self) -> Ordering {
        self.z0.total_cmp(&other.z0).then(self.bottom.total_cmp(&other.bottom))
    }

    /// True if what lies between two functions may take something of it.
    fn is_met(&self, low: &Chain, high: &Chain) -> bool {
        self.top > low.lowest(self.z0, self.z1) && self.bottom < high.highest(self.z0, self.z1)
    }

    /// What stays if everything between two functions over a stretch is taken.
    fn without(&self, stretch: Run, low: &Chain, high: &Chain) -> Vec<Self> {
        let beside = [self.clipped(f64::NEG_INFINITY, stretch.z0), self.clipped(stretch.z1, f64::INFINITY)];
        let mut rest: Vec<Self> = beside.into_iter().flatten().collect();
        if let Some(here) = self.clipped(stretch.z0, stretch.z1) {
            let (low, high) = (low.clipped(here.z0, here.z1), high.clipped(here.z0, here.z1));
            rest.extend(Self::between(&here.low, &here.high.min(&low)));
            rest.extend(Self::between(&here.low.max(&high), &here.high));
        }
        rest
    }
}

impl Hanging {
    /// Numbers of what may reach into a stretch.
    fn near(&self, z0: f64, z1: f64) -> std::ops::Range<usize> {
        let first = self.bands.partition_point(|b| b.z0 <= z0 - self.widest);
        first..self.bands.partition_point(|b| b.z0 < z1).max(first)
    }

    fn over(&self, z0: f64, z1: f64) -> impl Iterator<Item = &Band> {
        let near = self.bands.get(self.near(z0, z1)).unwrap_or_default();
        near.iter().filter(move |b| b.z1 > z0)
    }

    /// True if something hangs over somewhere between two positions.
    pub(super) fn is_over(&self, z0: f64, z1: f64) -> bool {
        self.over(z0, z1).next().is_some()
    }

    /// The top of it between two positions, and of `stock` below it.
    pub(super) fn top_over(&self, stock: Chain, z0: f64, z1: f64) -> Chain {
        self.over(z0, z1).fold(stock, |top, band| top.max(&band.high.clipped(z0, z1)))
    }

    /// True if it is met more than `by` mm deep by what lies between two functions.
    pub(super) fn meets(&self, low: &Chain, high: &Chain, by: f64) -> bool {
        self.within(low, high).any(|(bottom, top)| !top.runs_over(&bottom, by).is_empty())
    }

    /// Area of what lies between two functions, mm².
    pub(super) fn area_within(&self, low: &Chain, high: &Chain) -> f64 {
        self.within(low, high).map(|(bottom, top)| top.area_over(&bottom)).sum()
    }

    /// Lower and upper side of every part of it where two functions leave something between them and it.
    fn within<'a>(&'a self, low: &'a Chain, high: &'a Chain) -> impl Iterator<Item = (Chain, Chain)> + 'a {
        let (from, to) = (low.pieces.first().map_or(0.0, |p| p.z0), low.pieces.last().map_or(0.0, |p| p.z1));
        self.over(from, to).map(move |band| {
            let (z0, z1) = (band.z0.max(from), band.z1.min(to));
            (band.low.max(low).clipped(z0, z1), band.high.min(high).clipped(z0, z1))
        })
    }

    /// Takes away what lies between two functions, and adds what of `stock` lies above the upper one; gives a stretch outside which
    /// nothing changed.
    pub(super) fn cut(&mut self, low: &Chain, high: &Chain, stock: &Surface) -> Option<Run> {
        let (z0, z1) = low.ends()?;
        let (near, stretch) = (self.near(z0, z1), Run { z0, z1 });
        let mut now: Vec<Band> = Band::between(high, &stock.above(high).clipped(z0, z1)).collect();
        let is_met = |band: &Band| band.is_met(low, high);
        if now.is_empty() && !self.bands.get(near.clone()).unwrap_or_default().iter().any(is_met) {
            return None;
        }
        let (met, apart): (Vec<Band>, Vec<Band>) = self.bands.drain(near.clone()).partition(is_met);
        let changed = met.iter().chain(&now).map(|b| Run { z0: b.z0.max(z0), z1: b.z1.min(z1) }).reduce(Run::and);
        now.extend(met.iter().flat_map(|band| band.without(stretch, low, high)).chain(apart));
        self.widest = now.iter().map(|b| b.z1 - b.z0).fold(self.widest, f64::max);
        now.sort_by(Band::order);
        self.put(near.start, now);
        changed
    }

    /// Puts bands in order at a place; one whose beginning was cut off may now begin behind its neighbours.
    fn put(&mut self, at: usize, bands: Vec<Band>) {
        let behind = bands.last().zip(self.bands.get(at)).is_some_and(|(last, next)| last.order(next).is_gt());
        self.bands.splice(at..at, bands);
        if behind {
            self.bands.sort_by(Band::order);
        }
    }

    /// Only what lies to the left of a position.
    pub(super) fn clipped_at(&self, z1: f64) -> Self {
        let bands = self.bands.iter().filter_map(|b| b.clipped(f64::NEG_INFINITY, z1)).collect();
        Self { bands, widest: self.widest }
    }

    /// With z turned round.
    pub(super) fn mirrored(&self) -> Self {
        let turned = |b: &Band| Band { z0: -b.z1, z1: -b.z0, low: b.low.mirrored(), high: b.high.mirrored(), ..*b };
        let mut bands: Vec<Band> = self.bands.iter().map(turned).collect();
        bands.sort_by(Band::order);
        Self { bands, widest: self.widest }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slivers_of_several_levels_hang_one_above_the_other() {
        let mut hanging = Hanging::default();
        let mut stock = Surface::from(Chain::level(0.0, 10.0, 10.0));
        // Three strokes below each other, each of which leaves 1 mm above itself.
        for (low, high) in [(8.0, 9.0), (6.0, 7.0), (4.0, 5.0)] {
            let (low, high) = (Chain::level(2.0, 5.0, low), Chain::level(2.0, 5.0, high));
            hanging.cut(&low, &high, &stock);
            stock.cut(&low);
        }
        let meets = |hanging: &Hanging, low: f64, high: f64| {
            hanging.meets(&Chain::level(3.0, 4.0, low), &Chain::level(3.0, 4.0, high), 1e-5)
        };
        for (low, high, there) in
            [(9.2, 9.3, true), (8.2, 8.8, false), (7.5, 7.6, true), (5.5, 5.6, true), (4.1, 4.9, false)]
        {
            assert_eq!(meets(&hanging, low, high), there, "{low} to {high}");
        }
        assert_eq!(hanging.top_over(stock.chain(), 0.0, 10.0).at(3.0), Some(10.0));
        // Through the middle one, and a bit of the top one from below.
        hanging.cut(&Chain::level(0.0, 4.0, 6.0), &Chain::level(0.0, 4.0, 9.5), &stock);
        assert!(!meets(&hanging, 6.5, 9.4) && meets(&hanging, 9.4, 9.6) && hanging.is_over(4.0, 4.5));
        let beside = (Chain::level(4.2, 4.8, 7.5), Chain::level(4.2, 4.8, 7.6));
        assert!(hanging.meets(&beside.0, &beside.1, 1e-5), "beside the cut it stays");
        assert!((hanging.area_within(&beside.0, &beside.1) - 0.6 * 0.1).abs() < 1e-9);
        assert_eq!(hanging.mirrored().mirrored(), hanging);
        assert!(!hanging.clipped_at(2.5).is_over(2.6, 9.0) && hanging.is_over(2.6, 9.0));
    }
}
