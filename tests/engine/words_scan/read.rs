//! What a program of words moves, by its machine's table of words. Shares nothing with the post or the proof.

use super::{Word, scan};
use turnwright::geometry::Point;
use turnwright::machine::{ArcCenter, DecimalPoint, DwellWord, Machine, Words, Zeros};

/// One move, in program space: z from the program zero and a radius, mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Step {
    Rapid { to: Point },
    Line { to: Point, feed: f64 },
    Arc { to: Point, center: Point, ccw: bool, feed: f64 },
    Thread { to: Point, lead: f64 },
    Dwell { seconds: f64 },
}

impl Step {
    pub(crate) fn to(&self) -> Option<Point> {
        match *self {
            Self::Rapid { to } | Self::Line { to, .. } | Self::Arc { to, .. } | Self::Thread { to, .. } => Some(to),
            Self::Dwell { .. } => None,
        }
    }
}

/// The value of a number by the rules of the control; `decimals` are those of the word.
fn value(words: &Words, number: &str, decimals: u8, before: u8) -> f64 {
    if words.decimal_point == DecimalPoint::Always {
        return number.parse().unwrap();
    }
    let (sign, digits) = number.strip_prefix('-').map_or((1.0, number), |digits| (-1.0, digits));
    let full = match words.zeros {
        Zeros::DropTrailing => format!("{digits:0<width$}", width = usize::from(before + decimals)),
        Zeros::Keep | Zeros::DropLeading => digits.to_owned(),
    };
    sign * full.parse::<f64>().unwrap() / 10_f64.powi(i32::from(decimals))
}

/// The moves of `text` from `start` (program space).
pub(crate) fn read(text: &str, machine: &Machine, start: Point) -> Vec<Step> {
    let words = machine.words.as_ref().unwrap();
    let mut reader = Reader { words, at: start, motion: 0, feed: 0.0, steps: Vec::new() };
    text.lines().filter(|line| !line.starts_with('O')).for_each(|line| reader.block(&scan(line)));
    reader.steps
}

struct Reader<'a> {
    words: &'a Words,
    at: Point,
    motion: u32,
    feed: f64,
    steps: Vec<Step>,
}

impl Reader<'_> {
    fn length(&self, block: &[Word], letter: char) -> Option<f64> {
        let word = block.iter().find(|w| w.letter == letter)?;
        Some(value(self.words, &word.number, self.words.decimals_mm, self.words.digits_before))
    }

    fn x_per_radius(&self) -> f64 {
        f64::from(self.words.x_sign) * if self.words.x_is_diameter { 2.0 } else { 1.0 }
    }

    fn target(&self, block: &[Word]) -> Option<Point> {
        let (x, z) = (self.length(block, 'X'), self.length(block, 'Z'));
        let (u, w) = (self.length(block, 'U'), self.length(block, 'W'));
        x.or(z).or(u).or(w)?;
        let r = x.map_or(self.at.r + u.unwrap_or(0.0) / self.x_per_radius(), |x| x / self.x_per_radius());
        Some(Point::new(z.unwrap_or(self.at.z + w.unwrap_or(0.0)), r))
    }

    fn block(&mut self, block: &[Word]) {
        let codes: Vec<f64> = block.iter().filter(|w| w.letter == 'G').map(|w| w.value).collect();
        if codes.iter().any(|g| [28.0, 53.0].contains(g)) {
            return;
        }
        if codes.contains(&50.0) {
            self.at = self.target(block).unwrap_or(self.at);
            return;
        }
        if codes.contains(&4.0) {
            let seconds = match self.words.dwell {
                DwellWord::PMilliseconds => block.iter().find(|w| w.letter == 'P').unwrap().value / 1000.0,
                DwellWord::PSeconds => block.iter().find(|w| w.letter == 'P').unwrap().value,
                DwellWord::XSeconds => self.length(block, 'X').unwrap(),
            };
            self.steps.push(Step::Dwell { seconds });
            return;
        }
        if let Some(f) = block.iter().find(|w| w.letter == 'F') {
            let decimals = match (self.words.feed_per_rev, codes.contains(&32.0)) {
                (false, false) => self.words.feed_per_min_decimals,
                _ => self.words.feed_per_rev_decimals,
            };
            self.feed = value(self.words, &f.number, decimals, 4);
        }
        for code in codes {
            if [0.0, 1.0, 2.0, 3.0, 32.0, 33.0].contains(&code) {
                self.motion = code as u32;
            }
        }
        let Some(to) = self.target(block) else { return };
        let feed = self.feed;
        self.steps.push(match self.motion {
            0 => Step::Rapid { to },
            1 => Step::Line { to, feed },
            32 => Step::Thread { to, lead: feed },
            33 => Step::Thread { to, lead: self.length(block, 'K').unwrap() },
            g => {
                let ccw = (g == 2) == self.words.g2_is_ccw;
                Step::Arc { to, center: self.center(block, to, ccw), ccw, feed }
            }
        });
        self.at = to;
    }

    fn center(&self, block: &[Word], to: Point, ccw: bool) -> Point {
        let sign = f64::from(self.words.x_sign);
        if self.words.arc_center == ArcCenter::Radius {
            let radius = self.length(block, 'R').unwrap();
            let chord = to - self.at;
            let height = (radius * radius - chord.norm_squared() / 4.0).max(0.0).sqrt() / chord.norm();
            let side = if ccw { height } else { -height };
            return Point::new(
                f64::midpoint(self.at.z, to.z) - chord.y * side,
                f64::midpoint(self.at.r, to.r) + chord.x * side,
            );
        }
        let (i, k) = (self.length(block, 'I').unwrap_or(0.0), self.length(block, 'K').unwrap_or(0.0));
        let absolute = self.words.arc_center == ArcCenter::Absolute;
        let from = |i: f64, k: f64| {
            if absolute { Point::new(k, i * sign) } else { Point::new(self.at.z + k, self.at.r + i * sign) }
        };
        // Positions without signs are positive.
        if self.words.arc_center_signed || absolute {
            return from(i, k);
        }
        // Without signs: the centre that lies equally far from both ends, on the side that keeps the arc in a quadrant.
        let sweep = |c: Point| {
            let angle = |p: Point| (p.r - c.r).atan2(p.z - c.z);
            let turn = (angle(to) - angle(self.at)) * if ccw { 1.0 } else { -1.0 };
            turn.rem_euclid(std::f64::consts::TAU)
        };
        let signs = [(1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)];
        let candidates = signs.map(|(a, b)| from(i * a, k * b));
        let off = |c: Point| (c.distance(self.at) - c.distance(to)).abs();
        let fitting = candidates.into_iter().filter(|&c| sweep(c) < 1.6);
        fitting.min_by(|a, b| off(*a).total_cmp(&off(*b))).expect("an unsigned centre fits")
    }
}
