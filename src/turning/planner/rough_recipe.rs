//! What roughing was made from, for controls with a cycle of their own (G71, and G70 for the finishing pass).
//!
//! Such a cycle cuts along the spindle down to one contour that neither falls nor turns back; so it stands for the roughing of a
//! part whose outside is finished in one pass of that kind.

use super::conditions::Conditions;
use super::link::CLEARANCE_MM;
use super::side::Side;
use crate::geometry::Point;
use crate::turning::{CutMove, Feed, Operation, OperationKind, Recipe, RecipeKind, RoughRecipe, Task};

/// Steps back smaller than this are none, mm: rounding.
const ROUNDING_MM: f64 = 1e-6;

/// Adds the recipe of roughing, if the plan of the outside begins with roughing and finishing all of it, one operation each.
pub(super) fn add(task: &Task<'_>, operations: &mut [Operation]) {
    let outside = |o: &Operation| {
        use OperationKind::{FinishLeft, FinishRight, Groove, Pocket, RoughLeft, RoughRight};
        matches!(o.kind, RoughRight | RoughLeft | FinishRight | FinishLeft | Groove | Pocket)
    };
    let of_outside: Vec<usize> = operations.iter().enumerate().filter(|(_, o)| outside(o)).map(|(k, _)| k).collect();
    let [rough, finish, ..] = of_outside[..] else { return };
    let Some((rough_operation, finish_operation)) = operations.get(rough).zip(operations.get(finish)) else { return };
    if (rough_operation.kind, finish_operation.kind) != (OperationKind::RoughRight, OperationKind::FinishRight) {
        return;
    }
    let recipe = recipe(task, rough_operation, finish_operation);
    if let (Some(recipe), Some(operation)) = (recipe, operations.get_mut(rough)) {
        operation.recipes = vec![recipe];
    }
}

fn recipe(task: &Task<'_>, rough: &Operation, finish: &Operation) -> Option<Recipe> {
    let [Recipe { moves, kind: RecipeKind::Finish(_) }] = finish.recipes.as_slice() else { return None };
    let pass = finish.moves.get(moves.clone())?;
    let CutMove::Rapid { to: before } = *finish.moves.get(moves.start.checked_sub(1)?)? else { return None };
    let nose = |station: u32| task.tools.get(&station).map(|tool| tool.nose_radius);
    let edge = task.tools.get(&rough.tool)?.edge;
    let conditions = Conditions::of(OperationKind::RoughRight, edge, Side::Outside, task.machine, task.material_mm)?;
    let stock = task.setup.stock.bounds()?;
    let is_thick_enough = nose(rough.tool)? - nose(finish.tool)? <= conditions.allowance;
    if before.z < stock.max.z || !only_rises(before, pass) || !is_thick_enough {
        return None;
    }
    let across = CutMove::Rapid { to: before };
    let recipe = RoughRecipe {
        start: Point::new(before.z, stock.max.r + CLEARANCE_MM),
        contour: std::iter::once(across).chain(pass.iter().cloned()).collect(),
        depth: conditions.depth,
        retract: CLEARANCE_MM,
        allowance_radius: conditions.allowance,
        allowance_z: conditions.allowance,
        cut: slowest(&rough.moves)?,
    };
    // All but the way home.
    let moves = 0..rough.moves.len().checked_sub(1)?;
    Some(Recipe { moves, kind: RecipeKind::Rough(recipe) })
}

/// True if a pass goes towards the chuck and outwards only.
fn only_rises(before: Point, pass: &[CutMove]) -> bool {
    let mut at = before;
    pass.iter().all(|m| {
        let (CutMove::Line { to, .. } | CutMove::Arc { to, .. }) = *m else { return false };
        let rises = to.z <= at.z + ROUNDING_MM && to.r >= at.r - ROUNDING_MM;
        // An arc within one quadrant, as its ends say.
        let within = match *m {
            CutMove::Arc { center, .. } => (at.z - center.z) * (to.z - center.z) >= -ROUNDING_MM,
            _ => true,
        };
        at = to;
        rises && within
    })
}

/// The cut with the least feed.
fn slowest(moves: &[CutMove]) -> Option<crate::turning::Cut> {
    let cuts = moves.iter().filter_map(|m| match *m {
        CutMove::Line { cut, .. } | CutMove::Arc { cut, .. } => Some(cut),
        _ => None,
    });
    let feed = |feed: Feed| match feed {
        Feed::PerMinute(feed) | Feed::PerRev(feed) => feed,
    };
    cuts.min_by(|a, b| feed(a.feed).total_cmp(&feed(b.feed)))
}
