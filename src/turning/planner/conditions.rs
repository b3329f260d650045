//! Feeds, speeds and depths of an operation.

use super::side::Side;
use crate::document::OperationEdit;
use crate::machine::{Chip, CuttingOperation, Machine, Material, SpeedRule, Spindle, ToolMaterial};
use crate::turning::{Cut, Feed, OperationKind, Speed};

/// How one operation cuts.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Conditions {
    feed: Feed,
    turning: Turning,
    /// Depth of a cut on the radius, mm.
    pub(super) depth: f64,
    /// What is left for finishing, mm.
    pub(super) allowance: f64,
    side: Side,
    /// What limits the feed, if it is known.
    power: Option<Box<Power>>,
}

/// A cut and the spindle that must bear it.
#[derive(Debug, Clone, PartialEq)]
struct Power {
    spindle: Spindle,
    material: Material,
    /// Depth of cut, or width of the edge where that decides, mm.
    width: f64,
}

/// The angle between cutting edge and direction of feed that needs the most power, degrees.
const SQUARE_DEG: f64 = 90.0;

/// A chip whose width was measured counts as this much wider: short moves are rounded.
const WIDER: f64 = 1.05;

/// What a cut may need counts as so much more: its words of speed and feed are rounded, up too.
const SPARED: f64 = 1.01;

/// How the speed follows the radius.
#[derive(Debug, Clone, PartialEq)]
enum Turning {
    /// A line over the radius, as on a machine whose speed does not depend on the material.
    ByRadius { at_center_rpm: f64, per_mm_radius_rpm: f64, max_rpm: f64 },
    /// The control keeps a cutting speed.
    Surface { m_per_min: f64, max_rpm: f64 },
    /// A cutting speed, by steps or whole speeds that the machine can turn at.
    Steps { m_per_min: f64, machine: Box<Machine> },
}

/// Finishing depths of the published table that roughing leaves.
const PUBLISHED_FINISHING_PASSES: f64 = 2.0;

/// What roughing leaves where the material's table does not say, mm: half the depth of usual finishing cuts.
const USUAL_ALLOWANCE_MM: f64 = 0.2;

impl Conditions {
    /// The conditions of an operation with an edge of `edge` by the material's tables; `None` if they do not have it.
    pub(super) fn of(
        kind: OperationKind,
        edge: ToolMaterial,
        side: Side,
        machine: &Machine,
        material: &Material,
    ) -> Option<Self> {
        let found = match machine.spindle.speed {
            SpeedRule::Radius { at_center_rpm, per_mm_radius_rpm } => {
                Self::published(kind, material, at_center_rpm, per_mm_radius_rpm, machine.rpm_limit())
            }
            SpeedRule::Surface | SpeedRule::Table => Self::of_table(kind, edge, machine, material),
        };
        found.map(|conditions| Self { side, ..conditions }).filter(Self::is_usable)
    }

    fn published(
        kind: OperationKind,
        material: &Material,
        at_center_rpm: f64,
        per_mm_radius_rpm: f64,
        max_rpm: f64,
    ) -> Option<Self> {
        let row = material.orac?;
        let (feed, depth) = match kind {
            OperationKind::PartOff => (row.feed_part_off, row.depth_rough),
            OperationKind::Thread | OperationKind::ThreadBore => (row.feed_cut, row.depth_thread),
            _ => (row.feed_cut, row.depth_rough),
        };
        Some(Self {
            feed: Feed::PerMinute(feed),
            turning: Turning::ByRadius { at_center_rpm, per_mm_radius_rpm, max_rpm },
            depth,
            allowance: PUBLISHED_FINISHING_PASSES * row.depth_finish,
            side: Side::Outside,
            power: None,
        })
    }

    fn of_table(kind: OperationKind, edge: ToolMaterial, machine: &Machine, material: &Material) -> Option<Self> {
        let data = material.cutting(cutting_operation(kind), edge)?;
        let words = machine.words.as_ref();
        let surface = machine.spindle.speed == SpeedRule::Surface && words.is_some_and(|w| w.surface_speed);
        let turning = if surface {
            Turning::Surface { m_per_min: data.speed_m_per_min, max_rpm: machine.rpm_limit() }
        } else {
            Turning::Steps { m_per_min: data.speed_m_per_min, machine: Box::new(machine.clone()) }
        };
        let finishing = match kind {
            OperationKind::RoughBore | OperationKind::FinishBore => CuttingOperation::BoreFinish,
            _ => CuttingOperation::Finish,
        };
        let finish = material.cutting(finishing, edge).map(|d| d.depth_mm);
        let allowance = finish.filter(|d| *d > 0.0).unwrap_or(USUAL_ALLOWANCE_MM);
        Some(Self {
            feed: Feed::PerRev(data.feed_mm_per_rev),
            turning,
            depth: data.depth_mm,
            allowance,
            side: Side::Outside,
            power: None,
        })
    }

    /// The same with what the user changed: figures that are no positive numbers change nothing.
    pub(super) fn changed(mut self, edit: &OperationEdit, machine: &Machine) -> Self {
        let usable = |figure: Option<f64>| figure.filter(|v| v.is_finite() && *v > 0.0);
        self.depth = usable(edit.depth).unwrap_or(self.depth);
        if let Some(feed) = usable(edit.feed) {
            self.feed = match self.feed {
                Feed::PerMinute(_) => Feed::PerMinute(feed),
                Feed::PerRev(_) => Feed::PerRev(feed),
            };
        }
        if let Some(m_per_min) = usable(edit.speed_m_per_min) {
            self.turning = match self.turning {
                Turning::Surface { max_rpm, .. } => Turning::Surface { m_per_min, max_rpm },
                Turning::ByRadius { .. } | Turning::Steps { .. } => {
                    Turning::Steps { m_per_min, machine: Box::new(machine.clone()) }
                }
            };
        }
        self
    }

    /// The same with the feed that the spindle's power allows for a chip of `width` mm, if tables give what it takes.
    pub(super) fn within_power(self, spindle: &Spindle, material: &Material, width: f64) -> Self {
        let known = spindle.power_kw.is_some() && material.specific_cutting_force_n_per_mm2.is_some();
        let power = known.then(|| Box::new(Power { spindle: spindle.clone(), material: material.clone(), width }));
        Self { power, ..self }
    }

    fn is_usable(&self) -> bool {
        let (Feed::PerMinute(feed) | Feed::PerRev(feed)) = self.feed;
        let speed = match self.turning {
            Turning::ByRadius { max_rpm, .. } => max_rpm,
            Turning::Surface { m_per_min, .. } | Turning::Steps { m_per_min, .. } => m_per_min,
        };
        let all = [feed, speed];
        all.iter().all(|v| v.is_finite() && *v > 0.0) && self.depth >= 0.0 && self.allowance >= 0.0
    }

    /// True if the spindle's power limits the feed.
    pub(super) const fn knows_power(&self) -> bool {
        self.power.is_some()
    }

    /// Feed and speed of a cut between two radii as the planner counts them, mm: the speed at the end, and the feed that the
    /// spindle's power allows at both for a chip of `width` mm, at least that of the operation.
    pub(super) fn cut(&self, from: f64, to: f64, width: f64) -> Cut {
        let (from, to) = (self.side.radius(from), self.side.radius(to));
        let speed = match self.turning {
            Turning::Surface { m_per_min, max_rpm } => Speed::Surface { m_per_min, max_rpm },
            Turning::ByRadius { .. } | Turning::Steps { .. } => Speed::Rpm(self.rpm(to)),
        };
        let cut = Cut { feed: self.feed, speed };
        self.limited(self.limited(cut, from, width), to, width)
    }

    /// Radius of the part for a radius of the planner, mm.
    pub(super) fn radius(&self, r: f64) -> f64 {
        self.side.radius(r)
    }

    /// The cut with no more feed than the spindle's power allows at a radius of the part, mm.
    fn limited(&self, cut: Cut, radius: f64, width: f64) -> Cut {
        let (Some(power), Feed::PerRev(feed_mm_per_rev)) = (&self.power, cut.feed) else { return cut };
        let rpm = cut.rpm_at(radius);
        let speed = std::f64::consts::TAU * radius.abs() * rpm / 1000.0;
        let depth_mm = SPARED * power.width.max(WIDER * width);
        let chip = Chip { depth_mm, feed_mm_per_rev, approach_deg: SQUARE_DEG };
        Cut { feed: Feed::PerRev(power.spindle.feed_within_power(&power.material, chip, speed, rpm)), ..cut }
    }

    /// Feed and a fixed speed, that of an edge at `radius` mm of the part: for drills, whose programmed point is on the axis.
    pub(super) fn fixed(&self, radius: f64) -> Cut {
        self.limited(Cut { feed: self.feed, speed: Speed::Rpm(self.rpm(radius)) }, radius, 0.0)
    }

    /// Spindle speed with the programmed point at `radius` mm of the part, rev/min.
    fn rpm(&self, radius: f64) -> f64 {
        let by_surface = |m_per_min: f64| m_per_min * 1000.0 / (std::f64::consts::TAU * radius.abs());
        match &self.turning {
            Turning::ByRadius { at_center_rpm, per_mm_radius_rpm, max_rpm } => {
                (at_center_rpm - per_mm_radius_rpm * radius.max(0.0)).clamp(0.0, *max_rpm)
            }
            Turning::Surface { m_per_min, max_rpm } => by_surface(*m_per_min).min(*max_rpm),
            Turning::Steps { m_per_min, machine } => machine.nearest_rpm(by_surface(*m_per_min)),
        }
    }
}

const fn cutting_operation(kind: OperationKind) -> CuttingOperation {
    match kind {
        OperationKind::RoughRight | OperationKind::RoughLeft | OperationKind::Pocket => CuttingOperation::Rough,
        OperationKind::FinishRight | OperationKind::FinishLeft => CuttingOperation::Finish,
        OperationKind::Face => CuttingOperation::Face,
        OperationKind::Groove => CuttingOperation::Groove,
        OperationKind::Drill => CuttingOperation::Drill,
        OperationKind::RoughBore => CuttingOperation::BoreRough,
        OperationKind::FinishBore => CuttingOperation::BoreFinish,
        OperationKind::Thread | OperationKind::ThreadBore => CuttingOperation::Thread,
        OperationKind::PartOff => CuttingOperation::PartOff,
    }
}
