//! How long moves take.
//!
//! A rapid move starts and ends at rest. Each slide runs up at the machine's acceleration `a` to its rapid rate `v` and down
//! again, a trapezoid of speed: `t = d/v + v/a` for a way `d` of at least `v²/a`, else `t = 2·√(d/a)`; the slower slide counts.
//! Moves at cutting feed follow one another without a stop, as controls run them in cutting mode, and take `length / feed`.

use super::record::Played;
use super::report::Motion;
use super::step::{Drive, Feed};
use crate::geometry::{Point, Segment};
use crate::machine::{Axis, Dialect, Machine};

/// Time of a straight rapid move, s.
pub(super) fn rapid_seconds(machine: &Machine, from: Point, to: Point) -> f64 {
    let d = to - from;
    if machine.dialect == Dialect::Orac {
        // Its slides run together along the path at one feed.
        return d.norm() / machine.rapid_mm_per_min(Axis::Z) * 60.0;
    }
    let acceleration = machine.motion.map_or(f64::INFINITY, |motion| motion.acceleration_mm_per_s2);
    let slide = |way: f64, axis| trapezoid(way.abs(), machine.rapid_mm_per_min(axis) / 60.0, acceleration);
    slide(d.x, Axis::Z).max(slide(d.y, Axis::X))
}

/// Time from rest to rest over `way` mm at `speed` mm/s and `acceleration` mm/s² at most, s.
fn trapezoid(way: f64, speed: f64, acceleration: f64) -> f64 {
    if way >= speed * speed / acceleration {
        way / speed + speed / acceleration
    } else {
        2.0 * (way / acceleration).sqrt()
    }
}

/// A move as it is recorded: kind, mean feed and speed, duration.
pub(super) fn played(path: &Segment, drive: &Drive, tool: u32, machine: &Machine) -> Played {
    let middle = path.point_at(0.5).r;
    let length = path.length();
    if drive.rapid {
        let lasts_s = rapid_seconds(machine, path.start(), path.end());
        let feed = if lasts_s > 0.0 { length / lasts_s * 60.0 } else { machine.rapid_mm_per_min(Axis::Z) };
        return Played { path: *path, motion: Motion::Rapid, tool, feed, rpm: drive.speed.rpm_at(middle), lasts_s };
    }
    let lasts_s = drive.cutting_seconds(path);
    let feed = if lasts_s > 0.0 { length / lasts_s * 60.0 } else { drive.feed_at(middle) };
    let rpm = match drive.feed {
        Feed::PerRev(per_rev) if per_rev > 0.0 => feed / per_rev,
        _ => drive.speed.rpm_at(middle),
    };
    // By the feed that is written: the mean of a whole way is that but for its last digit.
    let rapid = machine.counts_as_rapid(feed.max(drive.feed_at(middle)));
    let motion = if rapid { Motion::Rapid } else { Motion::Feed };
    Played { path: *path, motion, tool, feed, rpm, lasts_s }
}

#[cfg(test)]
mod tests {
    use super::super::tests::word_lathe;
    use super::*;

    #[test]
    fn rapids_run_up_and_down() {
        // 0.1 m/s and 1 m/s²: 10 mm are needed to run up and down.
        assert!((trapezoid(110.0, 100.0, 1000.0) - 1.2).abs() < 1e-12);
        assert!((trapezoid(10.0, 100.0, 1000.0) - 0.2).abs() < 1e-12);
        assert!((trapezoid(2.5, 100.0, 1000.0) - 0.1).abs() < 1e-12);
        assert_eq!(trapezoid(0.0, 100.0, 1000.0), 0.0);
        assert!((trapezoid(50.0, 100.0, f64::INFINITY) - 0.5).abs() < 1e-12);
    }

    #[test]
    fn the_slower_slide_counts() {
        let machine = word_lathe();
        let motion = machine.motion.unwrap();
        let at = |z, r| rapid_seconds(&machine, Point::default(), Point::new(z, r));
        assert!(motion.rapid_x_mm_per_min < motion.rapid_z_mm_per_min);
        assert_eq!(at(100.0, 100.0), at(0.0, 100.0));
        assert!(at(100.0, 0.0) < at(0.0, 100.0));
    }
}
