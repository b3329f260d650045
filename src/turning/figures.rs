//! What an operation's path says about itself, in words.

use super::{Cut, CutMove, Feed, Operation, RecipeKind, Speed};
use crate::machine::Machine;
use crate::units::{Unit, trimmed};

/// Smallest and largest of some figures.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Span {
    least: f64,
    most: f64,
}

/// Depth, allowance, feeds and speeds of an operation; lengths in mm.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Figures {
    depth: Option<Span>,
    allowance: Option<Span>,
    feed_per_min: Option<Span>,
    feed_per_rev: Option<Span>,
    rpm: Option<Span>,
    m_per_min: Option<Span>,
}

fn widen(span: &mut Option<Span>, value: f64) {
    *span =
        Some(span.map_or(Span { least: value, most: value }, |s| Span {
            least: s.least.min(value),
            most: s.most.max(value),
        }));
}

impl Figures {
    /// Those that the path of `operation` carries; feeds that count as rapid on `machine` are ways through air.
    #[must_use]
    pub fn of(operation: &Operation, machine: Option<&Machine>) -> Self {
        let mut figures = Self::default();
        figures.take(&operation.moves, machine);
        for recipe in &operation.recipes {
            match &recipe.kind {
                RecipeKind::Rough(rough) => {
                    widen(&mut figures.depth, rough.depth);
                    widen(&mut figures.allowance, rough.allowance_radius);
                }
                RecipeKind::Thread(thread) => widen(&mut figures.depth, thread.first_depth),
                RecipeKind::Finish(_) => {}
            }
        }
        figures
    }

    fn take(&mut self, moves: &[CutMove], machine: Option<&Machine>) {
        for m in moves {
            match m {
                CutMove::Line { cut, .. } | CutMove::Arc { cut, .. } => {
                    let rapid = |feed| machine.is_some_and(|m| m.counts_as_rapid(feed));
                    if !matches!(cut.feed, Feed::PerMinute(feed) if rapid(feed)) {
                        self.take_cut(cut);
                    }
                }
                CutMove::Thread { depth_per_cut, rpm, pitch, .. } => {
                    widen(&mut self.depth, *depth_per_cut);
                    widen(&mut self.rpm, *rpm);
                    widen(&mut self.feed_per_rev, *pitch);
                }
                CutMove::ThreadPass { lead, rpm, .. } => {
                    widen(&mut self.feed_per_rev, *lead);
                    widen(&mut self.rpm, *rpm);
                }
                CutMove::Repeat { body, .. } => self.take(body, machine),
                CutMove::Rapid { .. } | CutMove::Dwell { .. } => {}
            }
        }
    }

    fn take_cut(&mut self, cut: &Cut) {
        match cut.feed {
            Feed::PerMinute(feed) => widen(&mut self.feed_per_min, feed),
            Feed::PerRev(feed) => widen(&mut self.feed_per_rev, feed),
        }
        match cut.speed {
            Speed::Rpm(rpm) => widen(&mut self.rpm, rpm),
            Speed::Surface { m_per_min, .. } => widen(&mut self.m_per_min, m_per_min),
        }
    }

    /// Names and texts of the figures that there are, lengths in `unit`.
    #[must_use]
    pub fn texts(&self, unit: Unit) -> Vec<(&'static str, String)> {
        let (symbol, mm) = (unit.symbol(), unit.in_mm());
        let figures = [
            ("Depth", self.depth, mm, 3, symbol.to_owned()),
            ("Stock left", self.allowance, mm, 3, symbol.to_owned()),
            ("Feed", self.feed_per_min, mm, 3, format!("{symbol}/min")),
            ("Feed a turn", self.feed_per_rev, mm, 3, format!("{symbol}/rev")),
            ("Cutting speed", self.m_per_min, 1.0, 1, "m/min".to_owned()),
            ("Speed", self.rpm, 1.0, 0, "rev/min".to_owned()),
        ];
        let text = |(name, span, scale, decimals, unit): (_, Option<Span>, f64, usize, String)| {
            span.map(|span| (name, format!("{} {unit}", range(span, scale, decimals))))
        };
        figures.into_iter().filter_map(text).collect()
    }
}

fn range(span: Span, scale: f64, decimals: usize) -> String {
    let [least, most] = [span.least, span.most].map(|value| trimmed(value / scale, decimals));
    if least == most { least } else { format!("{least} to {most}") }
}

/// A figure with at most three decimals and no zeros behind them.
#[must_use]
pub fn short(value: f64) -> String {
    trimmed(value, 3)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Point;
    use crate::turning::OperationKind;

    #[test]
    fn figures_are_ranges_over_all_moves_and_their_repetitions() {
        let line = |feed, rpm| CutMove::Line { to: Point::default(), cut: Cut::per_minute(feed, rpm) };
        let body = vec![line(40.0, 2000.0)];
        let operation = Operation {
            kind: OperationKind::RoughRight,
            name: "Rough".into(),
            tool: 1,
            change: None,
            moves: vec![
                line(80.0, 1262.0),
                CutMove::Repeat { count: 2, step: crate::geometry::Vector::default(), body },
            ],
            recipes: Vec::new(),
        };
        let texts = Figures::of(&operation, None).texts(Unit::Mm);
        let orac = crate::machine::Catalog::shipped().machine("orac").cloned();
        let mut with_air = operation.clone();
        with_air.moves.push(line(1000.0, 900.0));
        assert_eq!(Figures::of(&with_air, orac.as_ref()).texts(Unit::Mm), texts);
        assert_eq!(texts, [("Feed", "40 to 80 mm/min".to_owned()), ("Speed", "1262 to 2000 rev/min".to_owned())]);
    }
}
