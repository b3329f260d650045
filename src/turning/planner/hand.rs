//! Which of several turning tools of one hand roughs, and which finishes.

use super::piece::SAME_MM;
use super::tool::Cutter;
use std::cmp::Ordering;
use std::sync::Arc;

/// Corner angle that stands for a disc, radians: stronger than 35° inserts, weaker than 55° ones.
const DISC_CORNER: f64 = 45.0 / 180.0 * std::f64::consts::PI;

/// The tools in the order of their strength for cuts of `depth` mm: square shoulders, high edges, wide corners, large noses.
pub(super) fn roughing(tools: &[Arc<Cutter>], depth: f64) -> Vec<Arc<Cutter>> {
    ranked(tools, |a, b| {
        let deep = |c: &Cutter| c.reach > depth;
        let order = b.square.cmp(&a.square).then(deep(b).cmp(&deep(a)));
        order.then(apart(corner(b), corner(a))).then(apart(b.nose, a.nose))
    })
}

/// The tools in the order of their fineness: square shoulders, small noses, slim corners.
pub(super) fn finishing(tools: &[Arc<Cutter>]) -> Vec<Arc<Cutter>> {
    ranked(tools, |a, b| b.square.cmp(&a.square).then(apart(a.nose, b.nose)).then(apart(corner(a), corner(b))))
}

/// In order; equal ones by station.
fn ranked(tools: &[Arc<Cutter>], order: impl Fn(&Cutter, &Cutter) -> Ordering) -> Vec<Arc<Cutter>> {
    let mut ranked = tools.to_vec();
    ranked.sort_by(|a, b| order(a, b).then(a.station.cmp(&b.station)));
    ranked
}

fn corner(cutter: &Cutter) -> f64 {
    if cutter.corner > 3.0 { DISC_CORNER } else { cutter.corner }
}

fn apart(a: f64, b: f64) -> Ordering {
    if (a - b).abs() <= SAME_MM.sqrt() { Ordering::Equal } else { a.total_cmp(&b) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::machine::Catalog;

    #[test]
    fn the_rolls_tools_rough_and_finish_as_their_names_say() {
        let catalog = Catalog::shipped();
        let names = ["6t-button-5", "6t-rough-55-right", "6t-rough-35-right", "6t-finish-35-right", "6t-copy-70"];
        let made = |(k, id)| Some(Arc::new(Cutter::new(k, &catalog.tool(id)?.outline())?));
        let tools: Vec<Arc<Cutter>> = (1..).zip(names).filter_map(made).collect();
        let stations = |tools: Vec<Arc<Cutter>>| tools.iter().map(|c| c.station).collect::<Vec<_>>();
        assert_eq!(stations(roughing(&tools, 3.0)), [2, 3, 4, 1, 5]);
        assert_eq!(stations(finishing(&tools))[0], 4);
    }
}
