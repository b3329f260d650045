//! One stretch of a function of z: a line or half a circle, exact.

use crate::geometry::{Point, Segment};

/// Positions nearer than this are the same place, mm: far below any control's 0.001 and far above rounding noise.
pub(super) const SAME_MM: f64 = 1e-9;

/// Values nearer than this are equal when the larger of two functions is sought, mm: what rounding makes of one value.
pub(super) const EQUAL_MM: f64 = 1e-10;

/// A radius over `z0..=z1`, mm. Clipping keeps the supporting line or circle, so no error builds up.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Piece {
    pub(super) z0: f64,
    pub(super) z1: f64,
    pub(super) form: Form,
}

/// The curve that a piece lies on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Form {
    /// Through two points, `p.z < q.z`.
    Line { p: Point, q: Point },
    /// The upper or lower half of a circle.
    Arc { center: Point, radius: f64, upper: bool },
}

impl Piece {
    /// A line from `p` to `q`, `p.z < q.z`.
    pub(super) const fn line(p: Point, q: Point) -> Self {
        Self { z0: p.z, z1: q.z, form: Form::Line { p, q } }
    }

    /// A level line.
    pub(super) const fn level(z0: f64, z1: f64, r: f64) -> Self {
        Self::line(Point::new(z0, r), Point::new(z1, r))
    }

    /// The piece of a segment, whichever way it runs; `None` for a vertical one.
    pub(super) fn of(segment: &Segment) -> Option<Self> {
        let (a, b) = (segment.start(), segment.end());
        let (a, b) = if a.z <= b.z { (a, b) } else { (b, a) };
        if b.z - a.z <= SAME_MM {
            return None;
        }
        let Segment::Arc { center, .. } = *segment else { return Some(Self::line(a, b)) };
        let upper = segment.point_at(0.5).r >= center.r;
        Some(Self { z0: a.z, z1: b.z, form: Form::Arc { center, radius: a.distance(center), upper } })
    }

    /// Radius at `z`, mm.
    pub(super) fn at(&self, z: f64) -> f64 {
        match self.form {
            Form::Line { p, q } => p.r + (q.r - p.r) * ((z - p.z) / (q.z - p.z)),
            Form::Arc { center, radius, upper } => {
                let height = (radius * radius - (z - center.z) * (z - center.z)).max(0.0).sqrt();
                if upper { center.r + height } else { center.r - height }
            }
        }
    }

    /// The point at the smaller z.
    pub(super) fn left(&self) -> Point {
        Point::new(self.z0, self.at(self.z0))
    }

    /// The point at the larger z.
    pub(super) fn right(&self) -> Point {
        Point::new(self.z1, self.at(self.z1))
    }

    /// The part between two positions; `None` if it has no width.
    pub(super) fn clipped(&self, z0: f64, z1: f64) -> Option<Self> {
        let (z0, z1) = (self.z0.max(z0), self.z1.min(z1));
        (z1 - z0 > SAME_MM).then_some(Self { z0, z1, form: self.form })
    }

    /// Largest radius, mm.
    pub(super) fn highest(&self) -> f64 {
        let ends = self.at(self.z0).max(self.at(self.z1));
        match self.form {
            Form::Arc { center, radius, upper: true } if self.z0 < center.z && center.z < self.z1 => center.r + radius,
            _ => ends,
        }
    }

    /// Smallest radius, mm.
    pub(super) fn lowest(&self) -> f64 {
        -self.negated().highest()
    }

    /// Area below the piece down to the axis, mm²; what lies below the axis counts against it.
    pub(super) fn area(&self) -> f64 {
        let width = self.z1 - self.z0;
        match self.form {
            Form::Line { .. } => width * f64::midpoint(self.at(self.z0), self.at(self.z1)),
            Form::Arc { center, radius, upper } => {
                // ∫√(R² − x²) dx = (x·√(R² − x²) + R²·asin(x/R)) / 2.
                let integral = |z: f64| {
                    let x = (z - center.z).clamp(-radius, radius);
                    f64::midpoint(x * (radius * radius - x * x).max(0.0).sqrt(), radius * radius * (x / radius).asin())
                };
                let arc = integral(self.z1) - integral(self.z0);
                center.r * width + if upper { arc } else { -arc }
            }
        }
    }

    /// The piece moved by `dz` and `dr`.
    pub(super) fn shifted(&self, dz: f64, dr: f64) -> Self {
        let by = |p: Point| Point::new(p.z + dz, p.r + dr);
        let form = match self.form {
            Form::Line { p, q } => Form::Line { p: by(p), q: by(q) },
            Form::Arc { center, radius, upper } => Form::Arc { center: by(center), radius, upper },
        };
        Self { z0: self.z0 + dz, z1: self.z1 + dz, form }
    }

    /// The piece `by` mm higher.
    pub(super) fn raised(&self, by: f64) -> Self {
        self.shifted(0.0, by)
    }

    /// The function with its sign turned.
    pub(super) fn negated(&self) -> Self {
        let turn = |p: Point| Point::new(p.z, -p.r);
        let form = match self.form {
            Form::Line { p, q } => Form::Line { p: turn(p), q: turn(q) },
            Form::Arc { center, radius, upper } => Form::Arc { center: turn(center), radius, upper: !upper },
        };
        Self { form, ..*self }
    }

    /// The function with z turned round.
    pub(super) fn mirrored(&self) -> Self {
        let turn = |p: Point| p.mirrored_at_z(0.0);
        let form = match self.form {
            Form::Line { p, q } => Form::Line { p: turn(q), q: turn(p) },
            Form::Arc { center, radius, upper } => Form::Arc { center: turn(center), radius, upper },
        };
        Self { z0: -self.z1, z1: -self.z0, form }
    }

    /// The piece as a segment from the larger to the smaller z: the way a tool cuts towards the chuck.
    pub(super) fn towards_chuck(&self) -> Segment {
        let (start, end) = (self.right(), self.left());
        match self.form {
            Form::Line { .. } => Segment::Line { start, end },
            Form::Arc { center, upper, .. } => Segment::Arc { start, end, center, ccw: upper },
        }
    }

    /// How this piece lies to another one over a stretch that both cover. Where the difference of the two bends downwards only, it
    /// is nowhere less than at its ends.
    pub(super) fn against(&self, other: &Self, z0: f64, z1: f64) -> Lie {
        let bends = |piece: &Self| match piece.form {
            Form::Line { .. } => (true, true),
            Form::Arc { upper, .. } => (upper, !upper),
        };
        let ((down, up), (other_down, other_up)) = (bends(self), bends(other));
        let by = [self.at(z0) - other.at(z0), self.at(z1) - other.at(z1)];
        if down && other_up && by[0] > EQUAL_MM && by[1] > EQUAL_MM {
            return Lie::Above;
        }
        if up && other_down && by[0] < -EQUAL_MM && by[1] < -EQUAL_MM {
            return Lie::Below;
        }
        Lie::Near(self.meeting(other, z0, z1, by))
    }

    /// Positions strictly inside both pieces where they meet, at most two, in order.
    pub(super) fn meets(&self, other: &Self) -> Meeting {
        let (z0, z1) = (self.z0.max(other.z0), self.z1.min(other.z1));
        if z0 + SAME_MM >= z1 - SAME_MM {
            return Meeting::default();
        }
        match self.against(other, z0, z1) {
            Lie::Above | Lie::Below => Meeting::default(),
            Lie::Near(meeting) => meeting,
        }
    }

    /// Positions strictly between two where the pieces meet, of which this one lies so far above the other there.
    fn meeting(&self, other: &Self, z0: f64, z1: f64, by: [f64; 2]) -> Meeting {
        let (low, high) = (z0 + SAME_MM, z1 - SAME_MM);
        let mut found = match (self.form, other.form) {
            (Form::Line { .. }, Form::Line { .. }) => Meeting::one(z0 + (z1 - z0) * (by[0] / (by[0] - by[1]))),
            (Form::Line { p, q }, Form::Arc { center, radius, upper })
            | (Form::Arc { center, radius, upper }, Form::Line { p, q }) => line_and_half(p, q, center, radius, upper),
            (Form::Arc { center: a, radius: ra, upper: ua }, Form::Arc { center: b, radius: rb, upper: ub }) => {
                halves(a, ra, ua, b, rb, ub)
            }
        };
        found.keep(|z| z > low && z < high);
        found
    }
}

/// How one piece lies to another.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Lie {
    /// Above it all along, by more than [`EQUAL_MM`].
    Above,
    /// Below it all along, by more than [`EQUAL_MM`].
    Below,
    /// Neither for certain; they meet there.
    Near(Meeting),
}

/// Up to two positions in order.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Meeting {
    places: [f64; 2],
    count: usize,
}

impl Meeting {
    /// A position, if it is one.
    fn one(z: f64) -> Self {
        Self { places: [z, 0.0], count: usize::from(z.is_finite()) }
    }

    fn push(&mut self, z: f64) {
        if let Some(place) = self.places.get_mut(self.count).filter(|_| z.is_finite()) {
            *place = z;
            self.count += 1;
        }
    }

    fn keep(&mut self, wanted: impl Fn(f64) -> bool) {
        let all = *self;
        *self = Self::default();
        all.iter().filter(|&z| wanted(z)).for_each(|z| self.push(z));
        if self.count == 2 && self.places[0] > self.places[1] {
            self.places.swap(0, 1);
        }
    }

    /// The positions.
    pub(super) fn iter(&self) -> impl DoubleEndedIterator<Item = f64> + use<> {
        self.places.into_iter().take(self.count)
    }
}

fn line_and_half(p: Point, q: Point, center: Point, radius: f64, upper: bool) -> Meeting {
    let (dz, dr) = (q.z - p.z, q.r - p.r);
    let length = (dz * dz + dr * dr).sqrt();
    let (uz, ur) = (dz / length, dr / length);
    let along = (center.z - p.z) * uz + (center.r - p.r) * ur;
    let foot = Point::new(p.z + uz * along, p.r + ur * along);
    let away = foot.distance(center);
    let mut found = Meeting::default();
    if away < radius {
        let half = ((radius - away) * (radius + away)).sqrt();
        for s in [-half, half] {
            let r = foot.r + ur * s - center.r;
            if (r >= 0.0) == upper {
                found.push(foot.z + uz * s);
            }
        }
    }
    found
}

fn halves(a: Point, ra: f64, ua: bool, b: Point, rb: f64, ub: bool) -> Meeting {
    let mut found = Meeting::default();
    let apart = a.distance(b);
    if apart <= SAME_MM || apart >= ra + rb || apart <= (ra - rb).abs() {
        return found;
    }
    let (uz, ur) = ((b.z - a.z) / apart, (b.r - a.r) / apart);
    let along = f64::midpoint(apart, (ra - rb) * (ra + rb) / apart);
    let half = ((ra - along) * (ra + along)).max(0.0).sqrt();
    for s in [-half, half] {
        let (z, r) = (a.z + uz * along - ur * s, a.r + ur * along + uz * s);
        if (r >= a.r) == ua && (r >= b.r) == ub {
            found.push(z);
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn piece() -> impl Strategy<Value = Piece> {
        let point = || (-10.0..10.0_f64, -10.0..10.0_f64).prop_map(|(z, r)| Point::new(z, r));
        let line = (point(), point()).prop_filter_map("has width", |(a, b)| Piece::of(&Segment::line(a, b)));
        let arc = (point(), 0.5..8.0_f64, any::<bool>()).prop_map(|(center, radius, upper)| Piece {
            z0: center.z - radius,
            z1: center.z + radius,
            form: Form::Arc { center, radius, upper },
        });
        prop_oneof![line, arc]
    }

    proptest! {
        #[test]
        fn the_area_is_the_sum_of_strips(f in piece()) {
            let width = (f.z1 - f.z0) / 2000.0;
            let strips: f64 = (0..2000).map(|k| f.at(f.z0 + width * (f64::from(k) + 0.5)) * width).sum();
            prop_assert!((f.area() - strips).abs() < 1e-3, "{} {strips}", f.area());
        }

        #[test]
        fn pieces_are_equal_where_they_meet_and_keep_their_order_between(f in piece(), g in piece()) {
            let (low, high) = (f.z0.max(g.z0), f.z1.min(g.z1));
            prop_assume!(high - low > 1e-3);
            let places: Vec<f64> = [low].into_iter().chain(f.meets(&g).iter()).chain([high]).collect();
            prop_assert!(places.windows(2).all(|w| w[0] <= w[1]));
            for &z in &places[1..places.len() - 1] {
                prop_assert!((f.at(z) - g.at(z)).abs() < 1e-4);
            }
            for w in places.windows(2) {
                let above: Vec<f64> = (1..20).map(|k| w[0] + (w[1] - w[0]) * f64::from(k) / 20.0).map(|z| f.at(z) - g.at(z)).collect();
                let (least, most) = above.iter().fold((f64::MAX, f64::MIN), |(a, b), &d| (a.min(d), b.max(d)));
                prop_assert!(least > -1e-6 || most < 1e-6, "{least} {most}");
            }
        }
    }
}
