//! The rules of the section table, one a file.

mod above_bar;
mod arc_impossible;
mod arc_quadrant;
mod arc_radius;
mod arc_undercut;
mod bar_limit;
mod below_axis;
mod chords;
mod figures;
mod gap;
mod machined_away;
mod negative_diameter;
mod no_sections;
mod order;
mod outside_part;
mod overlap;
mod parabola_points;
mod parabola_straight;
mod parabola_turns_back;
mod pitch;
mod stock;
mod taper;
mod thread_base;
mod tolerances;
mod travel;
mod wall;

#[cfg(test)]
mod test_table;

use super::check::Rule;

/// All rules, in the order of their messages.
pub(super) const RULES: [Rule; 26] = [
    figures::check,
    stock::check,
    no_sections::check,
    order::check,
    negative_diameter::check,
    gap::check,
    overlap::check,
    wall::check,
    outside_part::check,
    machined_away::check,
    arc_impossible::check,
    arc_undercut::check,
    arc_quadrant::check,
    arc_radius::check,
    below_axis::check,
    parabola_points::check,
    parabola_straight::check,
    parabola_turns_back::check,
    chords::check,
    above_bar::check,
    bar_limit::check,
    travel::check,
    taper::check,
    pitch::check,
    thread_base::check,
    tolerances::check,
];
