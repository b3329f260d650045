//! What finishing passes were made from: the contour under the nose, for controls that compensate it (G41, G42).
//!
//! A pass is the path of the programmed point. The nose's centre lies beside it, and the contour one nose radius beside that;
//! a control that puts its nose on the contour drives the pass again. Where the nose rolls over a corner the contour has a
//! corner.

use crate::geometry::{Point, Segment, Vector};
use crate::machine::ToolOutline;
use crate::turning::{CutMove, FinishRecipe, Operation, OperationKind, Recipe, RecipeKind, Side, Task};

/// Ends of the contour closer than this meet, mm.
const SAME_MM: f64 = 1e-6;

/// Segments of the contour shorter than this are left out, mm: a control's smallest step.
const SHORTEST_MM: f64 = 0.001;

/// A tighter arc of the contour is a corner, mm.
const CORNER_MM: f64 = 1e-4;

/// The move to the contour is at least this many nose radii long: a control goes over from point to nose on it.
const LEAST_APPROACH: f64 = 2.1;

/// Of a piece beside an inner corner the nose runs along this much at least, mm: rounded words must not turn the rest around.
const LEAST_TOUCHED_MM: f64 = 0.01;

/// Adds the recipes of all finishing passes. Where the tool comes from open air its way to the contour is made long enough.
pub(super) fn add(task: &Task<'_>, datum: Point, operations: &mut [Operation]) {
    for operation in operations {
        let inside = match operation.kind {
            OperationKind::FinishRight | OperationKind::FinishLeft => false,
            OperationKind::FinishBore => true,
            _ => continue,
        };
        let tool = task.tools.get(&operation.tool).filter(|tool| tool.nose_radius > 0.0);
        if let Some(tool) = tool {
            let stock = task.setup.stock.bounds().map_or_else(Point::default, |b| b.max);
            operation.recipes = passes(operation, datum, tool, &Open { stock, tool, above: !inside });
        }
    }
}

/// Where there is nothing but air.
#[derive(Debug, Clone, Copy)]
struct Open<'a> {
    /// Free end and largest radius of the stock.
    stock: Point,
    tool: &'a ToolOutline,
    /// Outside it is open above any place that a tool came to from above.
    above: bool,
}

impl Open<'_> {
    /// The place `by` mm further back on the way from `from` to `to`, if there is air all the way.
    fn further(&self, from: Point, to: Point, by: f64) -> Option<Point> {
        let back = (from - to).try_normalize(0.0)?;
        let place = from + back * by;
        let straight_up = self.above && back.x.abs() <= SAME_MM && back.y > 0.0;
        let in_front = from.z >= self.stock.z && back.x >= 0.0 && self.is_clear(from, place);
        (straight_up || in_front).then_some(place)
    }

    /// True if all of the tool is in front of the stock on its way between two places, or above it where it may be.
    fn is_clear(&self, from: Point, to: Point) -> bool {
        let sides = self.tool.insert.segments.iter().chain(&self.tool.holder.segments).map(Segment::bounds);
        let low = Point::new(from.z.min(to.z), from.r.min(to.r));
        sides.into_iter().all(|side| {
            side.min.z + low.z >= self.stock.z - SAME_MM || (self.above && side.min.r + low.r >= self.stock.r)
        })
    }
}

/// The recipes of an operation's passes.
fn passes(operation: &mut Operation, datum: Point, tool: &ToolOutline, open: &Open<'_>) -> Vec<Recipe> {
    let mut recipes = Vec::new();
    let mut at = operation.change.unwrap_or(datum);
    let mut first = 0;
    while let Some(cut_move) = operation.moves.get(first) {
        let rest = operation.moves.get(first..).unwrap_or_default();
        let count = rest.iter().take_while(|m| matches!(m, CutMove::Line { .. } | CutMove::Arc { .. })).count();
        if count < 2 {
            at = end_of(cut_move).unwrap_or(at);
            first += 1;
            continue;
        }
        let moves = rest.get(..count).unwrap_or_default();
        let end = moves.last().and_then(end_of).unwrap_or(at);
        let longer =
            moves.first().and_then(end_of).and_then(|to| open.further(at, to, LEAST_APPROACH * tool.nose_radius));
        let found = finish(at, moves, tool, !open.above).map(|recipe| (recipe, at));
        let found = found.or_else(|| longer.and_then(|from| Some((finish(from, moves, tool, !open.above)?, from))));
        let lead_in = first.checked_sub(1).and_then(|k| operation.moves.get_mut(k));
        if let (Some((recipe, from)), Some(CutMove::Rapid { to })) = (found, lead_in) {
            *to = from;
            recipes.push(Recipe { moves: first..first + count, kind: RecipeKind::Finish(recipe) });
        }
        at = end;
        first += count;
    }
    recipes
}

/// The recipe of one pass from `before`: the first move goes to it, the others are it.
fn finish(before: Point, moves: &[CutMove], tool: &ToolOutline, inside: bool) -> Option<FinishRecipe> {
    let (approach, pass) = moves.split_first()?;
    let start = end_of(approach)?;
    let towards_chuck = pass.last().and_then(end_of)?.z < start.z;
    let side = if towards_chuck == inside { Side::Left } else { Side::Right };
    let to_nose = tool.nose_center - Point::default();
    let mut at = start;
    let mut contour: Vec<(Segment, &CutMove)> = Vec::with_capacity(pass.len());
    for cut_move in pass {
        let segment = segment(at, cut_move)?;
        at = segment.end();
        let under = under_nose(&segment.translated(to_nose), tool.nose_radius, side);
        contour.extend(under.map(|under| (under, cut_move)));
    }
    let contour = joined(contour)?;
    if !fits(contour.iter().map(|(segment, _)| segment), tool.nose_radius, side) {
        return None;
    }
    let first = contour.first()?.0.start();
    if before.distance(first) < LEAST_APPROACH * tool.nose_radius {
        return None;
    }
    let CutMove::Line { cut, .. } = *approach else { return None };
    let all = std::iter::once(CutMove::Line { to: first, cut });
    let contour = all.chain(contour.into_iter().map(|(segment, like)| moved(&segment, like))).collect();
    Some(FinishRecipe { contour, side, nose_radius: tool.nose_radius, orientation: tool.orientation })
}

/// The contour under a segment of the nose's centre; `None` where it is a corner.
fn under_nose(center: &Segment, nose: f64, side: Side) -> Option<Segment> {
    // The work is on the other side of the way than the tool.
    let left = if side == Side::Right { 1.0 } else { -1.0 };
    match *center {
        Segment::Line { start, end } => {
            let along = center.direction_at(0.0);
            let away = Vector::new(-along.y, along.x) * (left * nose);
            Some(Segment::line(start + away, end + away))
        }
        Segment::Arc { start, end, center: c, ccw } => {
            let radius = start.distance(c);
            let wanted = radius - left * nose * if ccw { 1.0 } else { -1.0 };
            let on = |p: Point| c + (p - c) * (wanted / radius);
            (wanted > CORNER_MM).then(|| Segment::Arc { start: on(start), end: on(end), center: c, ccw })
        }
    }
}

/// The contour with neighbours that meet; `None` if a piece of it would run backwards.
fn joined(contour: Vec<(Segment, &CutMove)>) -> Option<Vec<(Segment, &CutMove)>> {
    let mut out: Vec<(Segment, &CutMove)> = Vec::with_capacity(contour.len());
    for (segment, like) in contour {
        let Some((last, _)) = out.last_mut() else {
            out.push((segment, like));
            continue;
        };
        if last.end().distance(segment.start()) <= SAME_MM {
            out.push((segment, like));
            continue;
        }
        let meeting = last.prolonged_meeting(&segment, segment.start())?;
        let (before, after) = (between(last, last.start(), meeting), between(&segment, meeting, segment.end()));
        if is_turned(last, &before) || is_turned(&segment, &after) {
            return None;
        }
        *last = before;
        out.push((after, like));
    }
    out.retain(|(segment, _)| segment.start().distance(segment.end()) > SHORTEST_MM);
    let meets = out.windows(2).all(|w| w[0].0.end().distance(w[1].0.start()) <= 2.0 * SHORTEST_MM);
    meets.then_some(out)
}

/// True if a nose that a control puts on the contour touches every piece of it. A piece that is too short between inner corners,
/// or an arc tighter than the nose, stops the control with an alarm.
fn fits<'a>(contour: impl Iterator<Item = &'a Segment>, nose: f64, side: Side) -> bool {
    let mut last: Option<Segment> = None;
    for piece in contour {
        let Some(mut center) = under_nose(piece, -nose, side) else { return false };
        if let Some(before) = last.filter(|before| is_inner(before, &center, side)) {
            let Some(meeting) = before.prolonged_meeting(&center, center.start()) else { return false };
            let (to, from) = (between(&before, before.start(), meeting), between(&center, meeting, center.end()));
            let touched = |is: &Segment, was: &Segment| is.length() >= LEAST_TOUCHED_MM && !is_turned(was, is);
            if !touched(&to, &before) || !touched(&from, &center) {
                return false;
            }
            center = from;
        }
        last = Some(center);
    }
    true
}

/// True if the way of the nose's centre turns towards the tool's side between two segments.
fn is_inner(before: &Segment, after: &Segment, side: Side) -> bool {
    let (from, to) = (before.direction_at(1.0), after.direction_at(0.0));
    let turn = from.perp(&to);
    if side == Side::Left { turn > SAME_MM } else { turn < -SAME_MM }
}

/// A segment on the same line or circle between other ends.
fn between(segment: &Segment, start: Point, end: Point) -> Segment {
    match *segment {
        Segment::Line { .. } => Segment::line(start, end),
        Segment::Arc { center, ccw, .. } => Segment::Arc { start, end, center, ccw },
    }
}

/// True if a segment runs against its own direction, or once around instead of nowhere.
fn is_turned(was: &Segment, is: &Segment) -> bool {
    if is.start().distance(is.end()) <= SHORTEST_MM {
        return false;
    }
    match was {
        Segment::Line { .. } => was.direction_at(0.0).dot(&is.direction_at(0.0)) < 0.0,
        Segment::Arc { .. } => (is.sweep() - was.sweep()).abs() > std::f64::consts::FRAC_PI_2,
    }
}

fn segment(at: Point, cut_move: &CutMove) -> Option<Segment> {
    match *cut_move {
        CutMove::Line { to, .. } => Some(Segment::line(at, to)),
        CutMove::Arc { to, center, ccw, .. } => Some(Segment::Arc { start: at, end: to, center, ccw }),
        _ => None,
    }
}

/// A segment as a move with the feed and speed of another.
fn moved(segment: &Segment, like: &CutMove) -> CutMove {
    let (CutMove::Line { cut, .. } | CutMove::Arc { cut, .. }) = *like else { return like.clone() };
    match *segment {
        Segment::Line { end, .. } => CutMove::Line { to: end, cut },
        Segment::Arc { end, center, ccw, .. } => CutMove::Arc { to: end, center, ccw, cut },
    }
}

const fn end_of(cut_move: &CutMove) -> Option<Point> {
    match *cut_move {
        CutMove::Rapid { to } | CutMove::Line { to, .. } | CutMove::Arc { to, .. } | CutMove::ThreadPass { to, .. } => {
            Some(to)
        }
        CutMove::Thread { .. } | CutMove::Dwell { .. } | CutMove::Repeat { .. } => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::machine::Catalog;
    use crate::turning::Cut;

    #[test]
    fn the_way_to_a_pass_is_made_longer_only_where_all_of_the_tool_is_clear() {
        let (catalog, stock) = (Catalog::shipped(), Point::new(50.0, 20.0));
        let (from, to) = (Point::new(52.0, 6.0), Point::new(51.9, 7.0));
        for (tool, outwards) in [("svjbr-vbmt-04", true), ("6t-button-5", false)] {
            let tool = catalog.tool(tool).unwrap().outline();
            let open = Open { stock, tool: &tool, above: true };
            assert_eq!(open.further(from, to, 4.0).is_some(), outwards, "a shank over the stock stays where it is");
            assert!(
                open.further(Point::new(30.0, 22.0), Point::new(30.0, 20.0), 4.0).is_some(),
                "straight up it is open"
            );
            assert!(open.further(Point::new(30.0, 22.0), Point::new(30.1, 20.0), 4.0).is_none());
        }
    }

    #[test]
    fn a_wall_that_is_lower_than_the_nose_needs_is_left_to_the_path() {
        let contour = |wall: f64| {
            let corners = [(50.0, 20.0), (10.0, 20.0), (10.0, 20.0 + wall), (0.0, 20.0 + wall)];
            let corners = corners.map(|(z, r)| Point::new(z, r));
            [0, 1, 2].map(|k| Segment::line(corners[k], corners[k + 1]))
        };
        assert!(fits(contour(1.0).iter(), 0.4, Side::Right));
        assert!(!fits(contour(0.3).iter(), 0.4, Side::Right));
        assert!(fits(contour(0.3).iter(), 0.2, Side::Right));
        let tight = Segment::Arc {
            start: Point::new(10.0, 20.0),
            end: Point::new(9.7, 20.3),
            center: Point::new(10.0, 20.3),
            ccw: false,
        };
        assert!(fits([tight].iter(), 0.2, Side::Right) && !fits([tight].iter(), 0.4, Side::Right));
    }

    #[test]
    fn the_contour_under_a_pass_has_the_corners_of_the_part() {
        let tool = Catalog::shipped().tool("svjbr-vbmt-04").unwrap().outline();
        let nose = tool.nose_radius;
        let cut = Cut::per_minute(100.0, 1000.0);
        let line = |z, r| CutMove::Line { to: Point::new(z, r), cut };
        // A cylinder of radius 20, a chamfer of 2 mm at 45° up to radius 22, and on.
        let shift = nose * (std::f64::consts::PI / 8.0).tan();
        let moves =
            [line(51.0, 20.0), line(10.0 - nose + shift, 20.0), line(8.0 - nose + shift, 22.0), line(0.0, 22.0)];
        let recipe = finish(Point::new(53.0, 20.0), &moves, &tool, false).unwrap();
        let ends: Vec<Point> = recipe.contour.iter().filter_map(end_of).collect();
        assert_eq!((recipe.side, recipe.orientation, ends.len()), (Side::Right, 3, 4));
        let expected = [(51.0 + nose, 20.0), (10.0, 20.0), (8.0, 22.0), (nose, 22.0)];
        for (end, (z, r)) in ends.iter().zip(expected) {
            assert!(end.distance(Point::new(z, r)) < 1e-9, "{end:?} is not {z}, {r}");
        }
    }
}
