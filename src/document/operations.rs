//! Operations: what they are for, and what a user changes of those that the planner chose.

use serde::{Deserialize, Serialize};

/// Purpose of an operation.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum OperationKind {
    /// Roughing towards the chuck.
    RoughRight,
    /// Finishing towards the chuck.
    FinishRight,
    /// Roughing what the right-hand tool leaves.
    RoughLeft,
    /// Finishing what the right-hand tool leaves.
    FinishLeft,
    /// Facing the free end.
    Face,
    /// Grooves with a blade.
    Groove,
    /// Hollows that a turning tool enters along a cut-in line.
    Pocket,
    /// Drilling on the axis.
    Drill,
    /// Roughing a bore.
    RoughBore,
    /// Finishing a bore.
    FinishBore,
    /// Threading outside.
    Thread,
    /// Threading in a bore.
    ThreadBore,
    /// Parting off.
    PartOff,
}

impl OperationKind {
    /// Name for people.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::RoughRight => "Rough, right-hand",
            Self::FinishRight => "Finish, right-hand",
            Self::RoughLeft => "Rough, left-hand",
            Self::FinishLeft => "Finish, left-hand",
            Self::Face => "Face",
            Self::Groove => "Groove",
            Self::Pocket => "Pocket",
            Self::Drill => "Drill",
            Self::RoughBore => "Rough bore",
            Self::FinishBore => "Finish bore",
            Self::Thread => "Thread",
            Self::ThreadBore => "Thread in bore",
            Self::PartOff => "Part off",
        }
    }

    /// True if a clamping has one operation of this kind at most, whatever its tool.
    #[must_use]
    pub const fn is_single(self) -> bool {
        matches!(self, Self::Face | Self::PartOff)
    }
}

/// An operation of the planner: there is one for each purpose, tool and clamping.
#[derive(Debug, Clone, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct OperationRef {
    /// Suffix of the clamping: empty with one end machined, `A` and `B` with two.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub clamping: String,
    /// Its purpose.
    pub kind: OperationKind,
    /// Turret station of the tool that the planner chose.
    pub tool: u32,
}

/// What a user changed of one planned operation. Lengths in the unit of the document; what is absent is the planner's choice.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct OperationEdit {
    /// Which operation.
    pub operation: OperationRef,
    /// It is left out.
    #[serde(default, skip_serializing_if = "is_false")]
    pub skip: bool,
    /// It is made with these choices whatever else the planner would choose.
    #[serde(default, skip_serializing_if = "is_false")]
    pub locked: bool,
    /// Turret station of another tool.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub tool: Option<u32>,
    /// Cutting speed, m/min whatever the document's unit.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub speed_m_per_min: Option<f64>,
    /// Feed per turn; per minute on a machine whose feeds are.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub feed: Option<f64>,
    /// Depth of cut on the radius; of a thread that of the first pass.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub depth: Option<f64>,
}

/// What a user changed of the planner's operations.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct PlanEdits {
    /// Changed operations.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub operations: Vec<OperationEdit>,
    /// Order of operations; those that are not in it stay behind the one that the planner put before them.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub order: Vec<OperationRef>,
}

impl OperationRef {
    /// True if this is the operation of a clamping for `kind` with the planner's choice of `tool`.
    #[must_use]
    pub fn is(&self, clamping: &str, kind: OperationKind, tool: u32) -> bool {
        self.clamping == clamping && self.kind == kind && (kind.is_single() || self.tool == tool)
    }

    /// True if both stand for one operation.
    #[must_use]
    pub fn is_same(&self, other: &Self) -> bool {
        self.is(&other.clamping, other.kind, other.tool)
    }
}

impl OperationEdit {
    /// No change of an operation yet.
    #[must_use]
    pub const fn of(operation: OperationRef) -> Self {
        Self { operation, skip: false, locked: false, tool: None, speed_m_per_min: None, feed: None, depth: None }
    }

    /// True if nothing is changed.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        *self == Self::of(self.operation.clone())
    }

    /// Every figure with its key in a file.
    #[must_use]
    pub fn figures(&self) -> Vec<(&'static str, f64)> {
        let all = [("speed_m_per_min", self.speed_m_per_min), ("feed", self.feed), ("depth", self.depth)];
        all.into_iter().filter_map(|(key, value)| Some((key, value?))).collect()
    }
}

impl PlanEdits {
    /// What was changed of the operation for `kind` with the planner's choice of `tool`.
    #[must_use]
    pub fn of(&self, clamping: &str, kind: OperationKind, tool: u32) -> Option<&OperationEdit> {
        self.operations.iter().find(|edit| edit.operation.is(clamping, kind, tool))
    }

    /// The operation that is made for `kind` with `tool`: one that was given this tool, or the planner's own.
    #[must_use]
    pub fn made_with(&self, clamping: &str, kind: OperationKind, tool: u32) -> OperationRef {
        let own = OperationRef { clamping: clamping.to_owned(), kind, tool };
        let of_kind = |edit: &&OperationEdit| edit.operation.clamping == clamping && edit.operation.kind == kind;
        let given = self.operations.iter().filter(of_kind).find(|edit| edit.tool == Some(tool));
        given.map_or(own, |edit| edit.operation.clone())
    }

    /// Changes an operation; a change that leaves nothing changed is forgotten.
    pub fn change(&mut self, operation: &OperationRef, change: impl FnOnce(&mut OperationEdit)) {
        let known = self.operations.iter().position(|edit| edit.operation.is_same(operation));
        let mut edit = known.map_or_else(|| OperationEdit::of(operation.clone()), |k| self.operations.remove(k));
        change(&mut edit);
        if !edit.is_empty() {
            self.operations.insert(known.unwrap_or(self.operations.len()), edit);
        }
    }

    /// The edits with every length multiplied by `factor`, as when the unit changes.
    #[must_use]
    pub fn scaled(&self, factor: f64) -> Self {
        let scaled = |edit: &OperationEdit| OperationEdit {
            feed: edit.feed.map(|feed| feed * factor),
            depth: edit.depth.map(|depth| depth * factor),
            ..edit.clone()
        };
        Self { operations: self.operations.iter().map(scaled).collect(), order: self.order.clone() }
    }

    /// The operations in the user's order; those that the user did not order stay behind the one that is before them in
    /// `planned`.
    #[must_use]
    pub fn ordered(&self, planned: Vec<OperationRef>) -> Vec<OperationRef> {
        let mut groups: Vec<Vec<OperationRef>> = vec![Vec::new()];
        for operation in planned {
            match groups.last_mut() {
                Some(group) if !self.order.iter().any(|wanted| wanted.is_same(&operation)) => group.push(operation),
                _ => groups.push(vec![operation]),
            }
        }
        let place = |group: &Vec<OperationRef>| {
            let first = group.first()?;
            self.order.iter().position(|wanted| wanted.is_same(first))
        };
        groups.sort_by_key(place);
        groups.concat()
    }
}

#[allow(clippy::trivially_copy_pass_by_ref, reason = "the signature that serde asks for")]
const fn is_false(value: &bool) -> bool {
    !*value
}

#[cfg(test)]
mod tests {
    use super::*;

    fn operation(kind: OperationKind, tool: u32) -> OperationRef {
        OperationRef { clamping: String::new(), kind, tool }
    }

    #[test]
    fn ordered_operations_take_those_behind_them_along() {
        let [a, b, c, d] = [1, 2, 3, 4].map(|tool| operation(OperationKind::RoughRight, tool));
        let gone = operation(OperationKind::Drill, 9);
        let edits = PlanEdits { order: vec![d.clone(), gone, a.clone()], ..PlanEdits::default() };
        let planned = vec![a.clone(), b.clone(), c.clone(), d.clone()];
        assert_eq!(edits.ordered(planned), [d, a, b, c]);
    }

    #[test]
    fn a_change_that_changes_nothing_is_forgotten() {
        let mut edits = PlanEdits::default();
        let face = operation(OperationKind::Face, 1);
        edits.change(&face, |edit| edit.feed = Some(0.2));
        edits.change(&face, |edit| edit.tool = Some(3));
        assert_eq!(edits.of("", OperationKind::Face, 7).and_then(|e| e.feed), Some(0.2), "there is one facing only");
        assert_eq!(edits.made_with("", OperationKind::Face, 3), face);
        assert_eq!(edits.scaled(25.4).operations[0].feed, Some(0.2 * 25.4));
        edits.change(&face, |edit| (edit.feed, edit.tool) = (None, None));
        assert_eq!(edits, PlanEdits::default());
    }
}
