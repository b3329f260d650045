//! A function of z made of lines and arcs, with jumps and gaps: surfaces, limits of tools, remaining stock.

use super::piece::{EQUAL_MM, Lie, Piece, SAME_MM};

/// Stretches that are narrower than this are no place for a tool, mm: far below any control's smallest step.
pub(super) const PIT_MM: f64 = 1e-6;

/// Pieces in order of z; neighbours may differ in value (a face) and may have a gap between them (no value there).
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct Chain {
    pub(super) pieces: Vec<Piece>,
}

/// A stretch along z, mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Run {
    pub(super) z0: f64,
    pub(super) z1: f64,
}

impl Run {
    /// Its length, mm.
    pub(super) const fn width(&self) -> f64 {
        self.z1 - self.z0
    }

    /// From where the first of two begins to where the last one ends.
    pub(super) const fn and(self, other: Self) -> Self {
        Self { z0: self.z0.min(other.z0), z1: self.z1.max(other.z1) }
    }
}

impl Chain {
    /// A level line.
    pub(super) fn level(z0: f64, z1: f64, r: f64) -> Self {
        Self { pieces: vec![Piece::level(z0, z1, r)] }
    }

    /// Adds a piece behind the others, joined to the last one if it continues it.
    pub(super) fn push(&mut self, piece: Piece) {
        match self.pieces.last_mut() {
            Some(last) if last.form == piece.form && piece.z0 - last.z1 <= SAME_MM => last.z1 = piece.z1,
            _ => self.pieces.push(piece),
        }
    }

    /// Adds what of a piece lies between two positions.
    pub(super) fn push_part(&mut self, piece: &Piece, z0: f64, z1: f64) {
        if z1 - z0 > SAME_MM {
            self.push(Piece { z0, z1, form: piece.form });
        }
    }

    /// The pieces that reach into a stretch.
    pub(super) fn over(&self, z0: f64, z1: f64) -> &[Piece] {
        let first = self.pieces.partition_point(|p| p.z1 <= z0);
        let behind = self.pieces.get(first..).unwrap_or_default();
        behind.get(..behind.partition_point(|p| p.z0 < z1)).unwrap_or_default()
    }

    /// The part between two positions.
    pub(super) fn clipped(&self, z0: f64, z1: f64) -> Self {
        let over = self.over(z0, z1);
        let mut pieces = Vec::with_capacity(over.len());
        pieces.extend(over.iter().filter_map(|p| p.clipped(z0, z1)));
        Self { pieces }
    }

    /// The larger value at `z` of the pieces that end or begin there; `None` in a gap.
    pub(super) fn at(&self, z: f64) -> Option<f64> {
        let first = self.pieces.partition_point(|p| p.z1 < z);
        let here = self.pieces.iter().skip(first).take_while(|p| p.z0 <= z);
        here.map(|p| p.at(z)).reduce(f64::max)
    }

    /// Largest value in a stretch; −∞ in a gap.
    pub(super) fn highest(&self, z0: f64, z1: f64) -> f64 {
        let inside = self.over(z0, z1).iter().filter_map(|p| p.clipped(z0, z1)).map(|p| p.highest());
        inside.fold(f64::NEG_INFINITY, f64::max)
    }

    /// The function with its sign turned.
    pub(super) fn negated(mut self) -> Self {
        self.pieces.iter_mut().for_each(|p| *p = p.negated());
        self
    }

    /// The function with z turned round.
    pub(super) fn mirrored(&self) -> Self {
        Self { pieces: self.pieces.iter().rev().map(Piece::mirrored).collect() }
    }

    /// Where it begins and where it ends; `None` of nothing.
    pub(super) fn ends(&self) -> Option<(f64, f64)> {
        Some((self.pieces.first()?.z0, self.pieces.last()?.z1))
    }

    /// Largest value; −∞ of nothing.
    pub(super) fn top(&self) -> f64 {
        self.pieces.iter().map(Piece::highest).fold(f64::NEG_INFINITY, f64::max)
    }

    /// Smallest value in a stretch; ∞ in a gap.
    pub(super) fn lowest(&self, z0: f64, z1: f64) -> f64 {
        let inside = self.over(z0, z1).iter().filter_map(|p| p.clipped(z0, z1)).map(|p| p.lowest());
        inside.fold(f64::INFINITY, f64::min)
    }

    /// Takes away what lies above `lower`. Only the pieces beside it are touched.
    pub(super) fn cut(&mut self, lower: &Self) {
        let Some((z0, z1)) = lower.ends() else { return };
        let from = self.pieces.partition_point(|p| p.z1 <= z0);
        let to = self.pieces.partition_point(|p| p.z0 < z1).max(from);
        let Some(under) = self.pieces.get(from..to) else { return };
        let left = Self { pieces: under.to_vec() }.joined(lower, false, |f, g| g < f - EQUAL_MM);
        self.pieces.splice(from..to, left.pieces);
    }

    /// Puts another function in the place of a stretch.
    pub(super) fn replace(&mut self, z0: f64, z1: f64, by: &Self) {
        let from = self.pieces.partition_point(|p| p.z1 <= z0);
        let to = self.pieces.partition_point(|p| p.z0 < z1).max(from);
        let Some(over) = self.pieces.get(from..to) else { return };
        let before = over.iter().filter_map(|p| p.clipped(f64::NEG_INFINITY, z0));
        let behind = over.iter().filter_map(|p| p.clipped(z1, f64::INFINITY));
        let mut now = Self::default();
        before.chain(by.pieces.iter().copied()).chain(behind).for_each(|p| now.push(p));
        self.pieces.splice(from..to, now.pieces);
    }

    /// The larger of two functions; where one has a gap, the other.
    pub(super) fn max(&self, other: &Self) -> Self {
        self.joined(other, true, |f, g| g > f + EQUAL_MM)
    }

    /// The smaller of two functions; where one has a gap, the other.
    pub(super) fn min(&self, other: &Self) -> Self {
        self.joined(other, true, |f, g| g < f - EQUAL_MM)
    }

    /// This function, and the other one where it is `better`, or alone if that counts.
    fn joined(&self, other: &Self, alone: bool, better: impl Fn(f64, f64) -> bool) -> Self {
        let mut out = Self { pieces: Vec::with_capacity(self.pieces.len() + other.pieces.len()) };
        let (mut i, mut j) = (0, 0);
        let mut from = f64::NEG_INFINITY;
        loop {
            match (self.pieces.get(i), other.pieces.get(j)) {
                (Some(f), Some(g)) => {
                    let (f0, g0) = (f.z0.max(from), g.z0.max(from));
                    if f.z1 <= g0 {
                        out.push_part(f, f0, f.z1);
                        i += 1;
                    } else if g.z1 <= f0 {
                        if alone {
                            out.push_part(g, g0, g.z1);
                        }
                        j += 1;
                    } else {
                        if f0 < g0 {
                            out.push_part(f, f0, g0);
                        } else if alone {
                            out.push_part(g, g0, f0);
                        }
                        let (z0, z1) = (f0.max(g0), f.z1.min(g.z1));
                        out.push_better(f, g, (z0, z1), &better);
                        from = z1;
                        i += usize::from(f.z1 <= z1);
                        j += usize::from(g.z1 <= z1);
                    }
                }
                (Some(f), None) => {
                    out.push_part(f, f.z0.max(from), f.z1);
                    i += 1;
                }
                (None, Some(_)) if !alone => return out,
                (None, Some(g)) => {
                    out.push_part(g, g.z0.max(from), g.z1);
                    j += 1;
                }
                (None, None) => return out,
            }
        }
    }

    /// The better of two pieces over a stretch that both cover.
    fn push_better(&mut self, f: &Piece, g: &Piece, (z0, z1): (f64, f64), better: impl Fn(f64, f64) -> bool) {
        if z1 - z0 <= SAME_MM {
            return;
        }
        let chosen = |f_at: f64, g_at: f64| if better(f_at, g_at) { g } else { f };
        match f.against(g, z0, z1) {
            Lie::Above => self.push_part(chosen(1.0, 0.0), z0, z1),
            Lie::Below => self.push_part(chosen(0.0, 1.0), z0, z1),
            Lie::Near(meeting) => {
                let mut from = z0;
                for to in meeting.iter().chain([z1]) {
                    let middle = f64::midpoint(from, to);
                    self.push_part(chosen(f.at(middle), g.at(middle)), from, to);
                    from = to;
                }
            }
        }
    }

    /// The largest of many functions, joined two by two: n·log n for functions that are short and lie side by side.
    pub(super) fn largest(all: &[Self]) -> Self {
        match all {
            [] => Self::default(),
            [only] => only.clone(),
            [first, second] => first.max(second),
            _ => {
                let (left, right) = all.split_at(all.len() / 2);
                Self::largest(left).max(&Self::largest(right))
            }
        }
    }

    /// The function without pits narrower than [`PIT_MM`], which rounding leaves where pieces that should meet miss one another:
    /// they take the value of the higher side. A place of no value between two pieces is such a pit, too: a floor that is put in
    /// later would show through it.
    pub(super) fn without_pits(mut self) -> Self {
        self.close_gaps();
        let is_wide = |p: &Piece| p.z1 - p.z0 > PIT_MM;
        if self.pieces.iter().all(is_wide) {
            return self;
        }
        let mut kept: Vec<Piece> = Vec::with_capacity(self.pieces.len());
        let mut rest = self.pieces.into_iter().peekable();
        while let Some(pit) = rest.next() {
            if is_wide(&pit) {
                kept.push(pit);
                continue;
            }
            let bottom = pit.at(f64::midpoint(pit.z0, pit.z1));
            let (before, after) = (kept.last_mut(), rest.peek_mut());
            let left = before.as_deref().filter(|b| pit.z0 - b.z1 <= SAME_MM).map(|b| b.at(b.z1));
            let right = after.as_deref().filter(|a| a.z0 - pit.z1 <= SAME_MM).map(|a| a.at(a.z0));
            let (left, right) = (left.filter(|r| *r > bottom), right.filter(|r| *r > bottom));
            match if left >= right { before } else { after } {
                Some(side) if left.or(right).is_some() => {
                    (side.z0, side.z1) = (side.z0.min(pit.z0), side.z1.max(pit.z1));
                }
                _ => kept.push(pit),
            }
        }
        Self { pieces: kept }
    }

    /// Lets the higher neighbour have every gap narrower than [`PIT_MM`].
    fn close_gaps(&mut self) {
        for k in 1..self.pieces.len() {
            let [left, right] = &mut self.pieces[k - 1..=k] else { return };
            let gap = right.z0 - left.z1;
            if gap <= 0.0 || gap > PIT_MM {
                continue;
            }
            if left.at(left.z1) >= right.at(right.z0) {
                left.z1 = right.z0;
            } else {
                right.z0 = left.z1;
            }
        }
    }

    /// The same of functions that nobody else needs.
    pub(super) fn largest_of(mut all: Vec<Self>) -> Self {
        while all.len() > 1 {
            let mut left = all.into_iter();
            let mut joined = Vec::with_capacity(left.len().div_ceil(2));
            while let Some(first) = left.next() {
                joined.push(match left.next() {
                    Some(second) => first.max(&second),
                    None => first,
                });
            }
            all = joined;
        }
        all.pop().unwrap_or_default()
    }

    /// Area between this function and another one where this is above it, mm²; where the other has a gap nothing counts.
    pub(super) fn area_over(&self, other: &Self) -> f64 {
        let runs = self.runs_over(other, EQUAL_MM);
        let area = |chain: &Self, run: &Run| -> f64 {
            chain.over(run.z0, run.z1).iter().filter_map(|p| p.clipped(run.z0, run.z1)).map(|p| p.area()).sum()
        };
        let (Some(first), Some(last)) = (other.pieces.first(), other.pieces.last()) else { return 0.0 };
        let inside = runs.iter().map(|r| Run { z0: r.z0.max(first.z0), z1: r.z1.min(last.z1) });
        inside.filter(|r| r.width() > 0.0).map(|r| area(self, &r) - area(other, &r)).sum()
    }

    /// Where the function is not above `level`, in order of z; gaps do not count.
    pub(super) fn runs_below(&self, level: f64) -> Vec<Run> {
        self.runs(|p| p.at(f64::midpoint(p.z0, p.z1)) <= level, level)
    }

    /// Where the function is above `level`, in order of z.
    pub(super) fn runs_above(&self, level: f64) -> Vec<Run> {
        self.runs(|p| p.at(f64::midpoint(p.z0, p.z1)) > level, level)
    }

    fn runs(&self, wanted: impl Fn(&Piece) -> bool, level: f64) -> Vec<Run> {
        let mut runs: Vec<Run> = Vec::new();
        for piece in &self.pieces {
            let mut from = piece.z0;
            for to in piece.meets(&Piece::level(piece.z0, piece.z1, level)).iter().chain([piece.z1]) {
                if wanted(&Piece { z0: from, z1: to, ..*piece }) {
                    join(&mut runs, Run { z0: from, z1: to });
                }
                from = to;
            }
        }
        runs
    }

    /// Where the function is more than `by` above `other`; where `other` has a gap it counts as being far below.
    pub(super) fn runs_over(&self, other: &Self, by: f64) -> Vec<Run> {
        let mut runs: Vec<Run> = Vec::new();
        for f in &self.pieces {
            let mut from = f.z0;
            for g in other.over(f.z0, f.z1) {
                let (z0, z1) = (g.z0.max(f.z0), g.z1.min(f.z1));
                if z0 - from > SAME_MM {
                    join(&mut runs, Run { z0: from, z1: z0 });
                }
                from = z1;
                if z1 - z0 > SAME_MM {
                    over_by(&Piece { z0, z1, ..*f }, &Piece { z0, z1, ..*g }, by, &mut runs);
                }
            }
            if f.z1 - from > SAME_MM {
                join(&mut runs, Run { z0: from, z1: f.z1 });
            }
        }
        runs
    }
}

fn over_by(f: &Piece, g: &Piece, by: f64, runs: &mut Vec<Run>) {
    let raised = g.raised(by);
    let meeting = match f.against(&raised, f.z0, f.z1) {
        Lie::Above => return join(runs, Run { z0: f.z0, z1: f.z1 }),
        Lie::Below => return,
        Lie::Near(meeting) => meeting,
    };
    let mut from = f.z0;
    for to in meeting.iter().chain([f.z1]) {
        let middle = f64::midpoint(from, to);
        if f.at(middle) > raised.at(middle) {
            join(runs, Run { z0: from, z1: to });
        }
        from = to;
    }
}

fn join(runs: &mut Vec<Run>, run: Run) {
    match runs.last_mut() {
        Some(last) if run.z0 - last.z1 <= SAME_MM => last.z1 = run.z1,
        _ => runs.push(run),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Point;
    use proptest::prelude::*;

    fn chain(corners: &[f64]) -> Chain {
        let points: Vec<Point> = corners.iter().enumerate().map(|(k, &r)| Point::new(k as f64, r)).collect();
        Chain { pieces: points.windows(2).map(|w| Piece::line(w[0], w[1])).collect() }
    }

    proptest! {
        #[test]
        fn the_larger_function_is_the_larger_value(
            a in proptest::collection::vec(0.0..9.0_f64, 2..9), b in proptest::collection::vec(0.0..9.0_f64, 2..9),
            shift in 0.0..5.0_f64,
        ) {
            let (f, mut g) = (chain(&a), chain(&b));
            g.pieces.iter_mut().for_each(|p| *p = p.shifted(shift, 0.0));
            let (larger, smaller) = (f.max(&g), f.min(&g));
            for k in 0..97 {
                let z = f64::from(k) * 0.137 + 1e-5;
                let both = [f.at(z), g.at(z)];
                let expected = both.into_iter().flatten().reduce(f64::max);
                prop_assert_eq!(larger.at(z).is_some(), expected.is_some());
                prop_assert!((larger.at(z).unwrap_or(0.0) - expected.unwrap_or(0.0)).abs() < 1e-6);
                let least = both.into_iter().flatten().reduce(f64::min);
                prop_assert!((smaller.at(z).unwrap_or(0.0) - least.unwrap_or(0.0)).abs() < 1e-6);
                if let [Some(f), Some(g)] = both {
                    let inside = chain(&a).runs_over(&larger.min(&smaller), 0.5).iter().any(|r| r.z0 <= z && z <= r.z1);
                    prop_assert!(inside == (f > f.min(g) + 0.5) || (f - f.min(g) - 0.5).abs() < 1e-6);
                }
            }
        }
    }

    #[test]
    fn pits_of_rounding_are_filled_from_the_higher_side() {
        let pieces = vec![
            Piece::level(0.0, 1.0, 5.0),
            Piece::level(1.0, 1.0 + 2e-9, 2.0),
            Piece::level(1.0 + 2e-9, 2.0, 4.0),
            Piece::level(2.0, 2.0 + 2e-9, 6.0),
            Piece::level(2.0 + 2e-9, 3.0, 1.0),
        ];
        let filled = Chain { pieces: pieces.clone() }.without_pits();
        assert_eq!(filled.pieces.len(), 4, "a peak stays: {filled:?}");
        assert_eq!((filled.pieces[0].z1, filled.at(1.0 + 1e-9)), (1.0 + 2e-9, Some(5.0)));
        let step = Chain { pieces: pieces[..2].iter().rev().map(Piece::mirrored).collect() }.without_pits();
        assert_eq!(step.pieces, [Piece { z0: -1.0 - 2e-9, z1: 0.0, ..Piece::level(-1.0, 0.0, 5.0) }]);
    }

    #[test]
    fn a_gap_that_rounding_leaves_is_closed_and_a_real_one_stays() {
        let pieces =
            vec![Piece::level(0.0, 1.0, 5.0), Piece::level(1.0 + 1.5e-9, 2.0, 4.0), Piece::level(2.5, 3.0, 1.0)];
        let closed = Chain { pieces }.without_pits();
        assert_eq!((closed.pieces[0].z1, closed.at(1.0 + 1e-9), closed.at(2.2)), (1.0 + 1.5e-9, Some(5.0), None));
        let floor = Chain::level(0.0, 3.0, -1.0);
        assert_eq!(closed.max(&floor).runs_below(3.0).len(), 1, "no pit down to the floor");
    }

    #[test]
    fn runs_below_a_level_are_joined_over_pieces() {
        let runs = chain(&[4.0, 2.0, 2.0, 4.0, 0.0]).runs_below(3.0);
        assert_eq!(runs, [Run { z0: 0.5, z1: 2.5 }, Run { z0: 3.25, z1: 4.0 }]);
        assert_eq!(chain(&[4.0, 2.0, 4.0]).runs_above(3.0).len(), 2);
    }
}
