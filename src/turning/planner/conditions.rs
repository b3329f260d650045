//! Feeds, speeds and depths of an operation.

use crate::machine::{CuttingOperation, Machine, Material, SpeedRule, ToolMaterial};
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
}

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
    /// The conditions of an operation by the material's tables; `None` if they do not have it.
    pub(super) fn of(kind: OperationKind, machine: &Machine, material: &Material) -> Option<Self> {
        let found = match machine.spindle.speed {
            SpeedRule::Radius { at_center_rpm, per_mm_radius_rpm } => {
                Self::published(kind, material, at_center_rpm, per_mm_radius_rpm, machine.rpm_limit())
            }
            SpeedRule::Surface | SpeedRule::Table => Self::of_table(kind, machine, material),
        };
        found.filter(Self::is_usable)
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
        })
    }

    fn of_table(kind: OperationKind, machine: &Machine, material: &Material) -> Option<Self> {
        let data = material.cutting(cutting_operation(kind), ToolMaterial::Carbide)?;
        let words = machine.words.as_ref();
        let surface = machine.spindle.speed == SpeedRule::Surface && words.is_some_and(|w| w.surface_speed);
        let turning = if surface {
            Turning::Surface { m_per_min: data.speed_m_per_min, max_rpm: machine.rpm_limit() }
        } else {
            Turning::Steps { m_per_min: data.speed_m_per_min, machine: Box::new(machine.clone()) }
        };
        let finish = material.cutting(CuttingOperation::Finish, ToolMaterial::Carbide).map(|d| d.depth_mm);
        let allowance = finish.filter(|d| *d > 0.0).unwrap_or(USUAL_ALLOWANCE_MM);
        Some(Self { feed: Feed::PerRev(data.feed_mm_per_rev), turning, depth: data.depth_mm, allowance })
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

    /// Feed and speed with the programmed point at `radius` mm.
    pub(super) fn cut(&self, radius: f64) -> Cut {
        let speed = match self.turning {
            Turning::Surface { m_per_min, max_rpm } => Speed::Surface { m_per_min, max_rpm },
            Turning::ByRadius { .. } | Turning::Steps { .. } => Speed::Rpm(self.rpm(radius)),
        };
        Cut { feed: self.feed, speed }
    }

    /// Spindle speed with the programmed point at `radius` mm, rev/min.
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
