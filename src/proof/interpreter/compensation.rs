//! Nose radius compensation, G41 and G42: the control keeps the nose beside the programmed path.
//!
//! The centre of the nose runs on the path's parallel at the nose radius; the programmed point follows the centre. Inside
//! corners are cut short where the parallels cross, outside corners are rolled round. Controls differ in how they drive round
//! outside corners (Fanuc prolongs straight parallels), but the nose touches the corner itself in each case, so what is cut
//! is the same. The first move ends, and the last one begins, square to the path.

use super::Run;
use super::block::Taken;
use super::codes::Side;
use crate::cancel::Cancelled;
use crate::geometry::{Point, Segment, Vector};
use crate::proof::findings::{Breach, Place};
use crate::proof::report::FindingKind;
use crate::proof::step::{Drive, Step};

/// Ends of parallels closer than this, mm, are one point: programs are written to 0.001.
const JOINT_MM: f64 = 0.001;

/// The compensation in force and the move that waits for the next one.
#[derive(Debug, Default)]
pub(super) struct Compensation {
    on: Option<Setting>,
    waiting: Option<Waiting>,
    /// Where the tool stands beside the programmed point after compensation, in part space; the next move begins there.
    pub stands: Option<Point>,
}

/// What the path is compensated by.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Setting {
    /// The nose is on the left of the path, seen with z to the right and r upwards.
    left: bool,
    /// Nose radius.
    radius: f64,
    /// Centre of the nose from the programmed point.
    nose: Vector,
}

/// A move whose end depends on the next one.
#[derive(Debug, Clone, Copy)]
struct Waiting {
    /// Path of the nose's centre.
    centre: Segment,
    /// The programmed path; `None` for the move on which compensation starts.
    programmed: Option<Segment>,
    drive: Drive,
    block: usize,
}

impl Compensation {
    /// True while moves are compensated.
    pub(super) const fn is_on(&self) -> bool {
        self.on.is_some()
    }
}

impl Setting {
    /// The parallel of a path; `None` for an arc that is tighter than the nose.
    fn parallel(&self, path: &Segment) -> Option<Segment> {
        let side = if self.left { 1.0 } else { -1.0 };
        match *path {
            Segment::Line { start, end } => {
                let along = path.direction_at(0.0);
                let away = Vector::new(-along.y, along.x) * (side * self.radius);
                Some(Segment::line(start + away, end + away))
            }
            Segment::Arc { start, end, center, ccw } => {
                let radius = start.distance(center);
                let wanted = radius - side * self.radius * if ccw { 1.0 } else { -1.0 };
                let scaled = |p: Point| center + (p - center) * (wanted / radius);
                (wanted > JOINT_MM).then(|| Segment::Arc { start: scaled(start), end: scaled(end), center, ccw })
            }
        }
    }
}

impl Run<'_, '_> {
    /// G40, G41 and G42.
    pub(super) fn compensate(&mut self, side: Option<Side>) -> Result<(), Cancelled> {
        if self.contour_only {
            return Ok(());
        }
        let setting = side.and_then(|side| self.setting(side));
        self.compensate_from_here(setting)
    }

    /// G41.1 and G42.1 of LinuxCNC: the nose's diameter is D, and L says where the tool's point lies beside the nose's centre,
    /// at the centre itself without it.
    pub(super) fn compensate_by(&mut self, side: Side, words: &mut Taken<'_>) -> Result<(), Cancelled> {
        let diameter = words.take('D').map_or(0.0, |d| self.mm(d));
        let orientation = words.take('L').map_or(Some(0), |l| l.whole());
        let Some(towards_nose) = orientation.and_then(towards_nose) else {
            self.unreadable("L of a compensated nose is its tip's orientation, 0 to 9.".to_owned());
            return Ok(());
        };
        if self.contour_only {
            return Ok(());
        }
        let radius = diameter.abs() / 2.0;
        let left = (side == Side::Left) != self.control.words.g2_is_ccw;
        let setting = Setting { left, radius, nose: towards_nose * radius };
        self.compensate_from_here(Some(setting).filter(|s| s.radius > 0.0))
    }

    fn compensate_from_here(&mut self, setting: Option<Setting>) -> Result<(), Cancelled> {
        if setting != self.compensation.on {
            self.end_compensation()?;
            self.compensation.on = setting;
        }
        Ok(())
    }

    fn setting(&mut self, side: Side) -> Option<Setting> {
        let tool = self.control.tool?;
        let outline = self.control.tools.get(&tool)?;
        // Seen along the machine's own X, which is turned over where G2 is.
        let left = (side == Side::Left) != self.control.words.g2_is_ccw;
        Some(Setting { left, radius: outline.nose_radius, nose: outline.nose_center - Point::default() })
            .filter(|s| s.radius > 0.0)
    }

    /// Takes a move in part space while compensation is on.
    pub(super) fn compensated(&mut self, path: Segment, drive: Drive) -> Result<(), Cancelled> {
        let Some(setting) = self.compensation.on else { return Ok(()) };
        if path.length() == 0.0 {
            return Ok(());
        }
        let block = self.at_block;
        let Some(parallel) = setting.parallel(&path) else {
            self.interference(&path, setting.radius);
            return Ok(());
        };
        let Some(before) = self.compensation.waiting.take() else {
            // The move on which compensation starts: its end waits for the path that follows.
            let centre = Segment::line(path.start() + setting.nose, path.end() + setting.nose);
            self.compensation.waiting = Some(Waiting { centre, programmed: None, drive, block });
            return Ok(());
        };
        let now = Waiting { centre: parallel, programmed: Some(path), drive, block };
        let (before, between, now) = self.joined(setting, before, now);
        self.emit(setting, before)?;
        if let Some(between) = between {
            self.emit(setting, between)?;
        }
        self.compensation.waiting = Some(now);
        Ok(())
    }

    /// Lets one move end where the next one begins; outside corners get an arc between.
    fn joined(&mut self, setting: Setting, before: Waiting, now: Waiting) -> (Waiting, Option<Waiting>, Waiting) {
        let start = now.centre.start();
        let Some(programmed) = before.programmed else {
            return (Waiting { centre: with_end(before.centre, start), ..before }, None, now);
        };
        if before.centre.end().distance(start) <= JOINT_MM {
            return (Waiting { centre: with_end(before.centre, start), ..before }, None, now);
        }
        let (from, to) =
            (programmed.direction_at(1.0), now.programmed.map_or_else(Vector::zeros, |p| p.direction_at(0.0)));
        let turn = from.x * to.y - from.y * to.x;
        if turn > 0.0 && setting.left || turn < 0.0 && !setting.left {
            return self.inside(setting, before, now);
        }
        let center = programmed.end();
        let arc = Segment::Arc { start: before.centre.end(), end: start, center, ccw: !setting.left };
        (before, Some(Waiting { centre: arc, programmed: None, ..now }), now)
    }

    /// An inside corner: both parallels end where they cross.
    fn inside(&mut self, setting: Setting, before: Waiting, now: Waiting) -> (Waiting, Option<Waiting>, Waiting) {
        let corner = before.programmed.map_or(before.centre.end(), |p| p.end());
        let crossings = before.centre.intersection(&now.centre, JOINT_MM / 10.0).points();
        let nearest = crossings.into_iter().min_by(|a, b| a.distance(corner).total_cmp(&b.distance(corner)));
        if let Some(p) = nearest {
            let before = Waiting { centre: with_end(before.centre, p), ..before };
            return (before, None, Waiting { centre: with_start(now.centre, p), ..now });
        }
        let path = now.programmed.unwrap_or(now.centre);
        self.interference(&path, setting.radius);
        let centre = Segment::line(before.centre.end(), now.centre.start());
        (before, Some(Waiting { centre, programmed: None, ..now }), now)
    }

    fn interference(&mut self, path: &Segment, radius: f64) {
        let message = format!(
            "The nose of radius {radius:.3} mm does not fit into the programmed path at this block: a corner, a step or an arc is \
             too small for it. The control stops here with an interference alarm."
        );
        let breach = Breach::error("interference", FindingKind::Control, radius, path.length(), message);
        self.find(breach.at(path.start()));
    }

    /// Moves from here on are not compensated. The last move ends square to its path; the way back is part of the next move.
    pub(super) fn end_compensation(&mut self) -> Result<(), Cancelled> {
        let Some(setting) = self.compensation.on.take() else { return Ok(()) };
        let Some(last) = self.compensation.waiting.take() else { return Ok(()) };
        self.emit(setting, last)?;
        self.compensation.stands = Some(last.centre.end() - setting.nose);
        Ok(())
    }

    /// The path of the programmed point to the sink.
    fn emit(&mut self, setting: Setting, waiting: Waiting) -> Result<(), Cancelled> {
        let path = waiting.centre.translated(-setting.nose);
        if path.length() == 0.0 {
            return Ok(());
        }
        let tool = self.control.tool.unwrap_or(0);
        let place = Place { program: self.program, block: waiting.block + 1 };
        self.sink.step(place.block, Step::Move { path, drive: waiting.drive, tool }, self.findings)
    }
}

/// The nose's centre from the tool's point, in nose radii, by LinuxCNC's number of the tip's orientation, whose picture has X
/// pointing down.
const fn towards_nose(orientation: u32) -> Option<Vector> {
    let (z, r) = match orientation {
        0 | 9 => (0.0, 0.0),
        1 => (-1.0, 1.0),
        2 => (1.0, 1.0),
        3 => (1.0, -1.0),
        4 => (-1.0, -1.0),
        5 => (1.0, 0.0),
        6 => (0.0, 1.0),
        7 => (-1.0, 0.0),
        8 => (0.0, -1.0),
        _ => return None,
    };
    Some(Vector::new(z, r))
}

fn with_end(path: Segment, end: Point) -> Segment {
    match path {
        Segment::Line { start, .. } => Segment::Line { start, end },
        Segment::Arc { start, center, ccw, .. } => Segment::Arc { start, end, center, ccw },
    }
}

pub(super) fn with_start(path: Segment, start: Point) -> Segment {
    match path {
        Segment::Line { end, .. } => Segment::Line { start, end },
        Segment::Arc { end, center, ccw, .. } => Segment::Arc { start, end, center, ccw },
    }
}
