//! Time to place: which move runs at a moment, where the tool is, and steps from block to block.

use crate::geometry::Point;
use crate::proof::{BlockRef, Move};

/// Where the tool is at a moment.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Position {
    /// Index of the move that runs.
    pub(super) index: usize,
    /// How much of its length is done, 0 to 1.
    pub(super) share: f64,
    /// The programmed point.
    pub(super) at: Point,
}

/// Duration of all moves, s.
pub(super) fn total_s(moves: &[Move]) -> f64 {
    moves.last().map_or(0.0, |m| m.starts_s + m.lasts_s)
}

/// Where the tool is at `time_s`; before the start it waits at the start, after the end at the end. `None` without moves.
pub(super) fn position_at(moves: &[Move], time_s: f64) -> Option<Position> {
    let index = moves.partition_point(|m| m.starts_s <= time_s).saturating_sub(1);
    let m = moves.get(index)?;
    let share = if m.lasts_s > 0.0 { ((time_s - m.starts_s) / m.lasts_s).clamp(0.0, 1.0) } else { 1.0 };
    Some(Position { index, share, at: m.path.point_at(share) })
}

/// Index of the stock state that is whole at `position`: the one before the running move, unless that is done.
pub(super) fn stock_at(moves: &[Move], position: Position) -> usize {
    let done = if position.share >= 1.0 { Some(position.index) } else { position.index.checked_sub(1) };
    done.and_then(|k| moves.get(k)).map_or(0, |m| m.stock_after)
}

/// Time at which the block after the one at `time_s` starts; the end if there is none.
pub(super) fn next_block_s(moves: &[Move], time_s: f64) -> f64 {
    let from = moves.partition_point(|m| m.starts_s <= time_s);
    let now = from.checked_sub(1).and_then(|k| moves.get(k)).map(BlockRef::of);
    let mut later = moves.iter().skip(from);
    later.find(|m| Some(BlockRef::of(m)) != now).map_or_else(|| total_s(moves), |m| m.starts_s)
}

/// Time at which the block at `time_s` starts, or if it has just started, the one before it.
pub(super) fn previous_block_s(moves: &[Move], time_s: f64) -> f64 {
    let before = moves.partition_point(|m| m.starts_s < time_s);
    let Some(last) = before.checked_sub(1).and_then(|k| moves.get(k)) else { return 0.0 };
    let earlier = moves.iter().take(before).rev();
    earlier.take_while(|m| BlockRef::of(m) == BlockRef::of(last)).last().map_or(0.0, |m| m.starts_s)
}

/// Minutes and seconds: `7:26`.
#[must_use]
pub fn clock(seconds: f64) -> String {
    let whole = if seconds.is_finite() { seconds.max(0.0).round().abs() } else { 0.0 };
    format!("{:.0}:{:02.0}", (whole / 60.0).floor(), whole % 60.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Segment;
    use crate::proof::Motion;
    use proptest::prelude::*;

    fn moves(lasting: &[(usize, f64)]) -> Vec<Move> {
        let mut starts_s = 0.0;
        let mut z = 0.0;
        let mut made = Vec::new();
        for (k, &(block, lasts_s)) in lasting.iter().enumerate() {
            let path = Segment::line(Point::new(z, 5.0), Point::new(z - 10.0, 5.0));
            made.push(Move {
                program: 0,
                block,
                path,
                motion: Motion::Feed,
                tool: 1,
                feed_mm_per_min: 80.0,
                rpm: 1000.0,
                starts_s,
                lasts_s,
                stock_after: k + 1,
            });
            starts_s += lasts_s;
            z -= 10.0;
        }
        made
    }

    #[test]
    fn the_tool_is_where_the_time_says() {
        let m = moves(&[(1, 2.0), (2, 4.0)]);
        let p = position_at(&m, 3.0).unwrap();
        assert_eq!((p.index, p.share, p.at), (1, 0.25, Point::new(-12.5, 5.0)));
        assert_eq!(position_at(&m, -1.0).unwrap().at, Point::new(0.0, 5.0));
        assert_eq!(position_at(&m, 99.0).unwrap().at, Point::new(-20.0, 5.0));
        assert!(position_at(&[], 0.0).is_none());
    }

    #[test]
    fn stock_changes_when_a_move_is_done() {
        let m = moves(&[(1, 2.0), (2, 4.0)]);
        assert_eq!(stock_at(&m, position_at(&m, 1.0).unwrap()), 0);
        assert_eq!(stock_at(&m, position_at(&m, 3.0).unwrap()), 1);
        assert_eq!(stock_at(&m, position_at(&m, 6.0).unwrap()), 2);
    }

    #[test]
    fn steps_go_from_block_to_block() {
        let m = moves(&[(4, 1.0), (4, 1.0), (5, 2.0), (6, 3.0)]);
        assert_eq!(next_block_s(&m, 0.0), 2.0);
        assert_eq!(next_block_s(&m, 2.0), 4.0);
        assert_eq!(next_block_s(&m, 5.0), 7.0);
        assert_eq!(previous_block_s(&m, 7.0), 4.0);
        assert_eq!(previous_block_s(&m, 3.0), 2.0);
        assert_eq!(previous_block_s(&m, 2.0), 0.0);
        assert_eq!(previous_block_s(&m, 0.0), 0.0);
    }

    #[test]
    fn clocks_show_minutes_and_seconds() {
        assert_eq!(clock(446.2), "7:26");
        assert_eq!(clock(59.7), "1:00");
        assert_eq!(clock(f64::NAN), "0:00");
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(200))]
        #[test]
        fn the_binary_search_finds_the_running_move(
            lasting in prop::collection::vec((1..50_usize, 0.01..5.0_f64), 1..60), share in 0.0..0.999_f64,
        ) {
            let m = moves(&lasting);
            let time_s = total_s(&m) * share;
            let p = position_at(&m, time_s).unwrap();
            prop_assert!(m[p.index].starts_s <= time_s);
            prop_assert!(time_s <= m[p.index].starts_s + m[p.index].lasts_s + 1e-9);
        }
    }
}
