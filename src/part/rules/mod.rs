//! The rules of the section table, one a file.

mod above_bar;
mod arc_impossible;
mod arc_quadrant;
mod arc_radius;
mod arc_undercut;
mod bar_limit;
mod below_axis;
mod between_centres;
mod bore_between_centres;
mod bore_closed;
mod bore_wall;
mod chords;
mod facing_allowance;
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
mod plan_edits;
mod published_generator;
mod starts;
mod stock;
mod stock_bore;
mod taper;
mod thread_base;
mod tolerances;
mod travel;
mod wall;

#[cfg(test)]
mod test_table;

use super::check::Rule;

/// The rules of the outside's table and of the part as a whole, in the order of their messages.
pub(super) const RULES: [Rule; 31] = [
    figures::check,
    stock::check,
    facing_allowance::check,
    plan_edits::check,
    between_centres::check,
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
    starts::check,
    thread_base::check,
    tolerances::check,
    published_generator::check,
];

/// The rules of the bore's table, in the order of their messages.
pub(super) const BORE_RULES: [Rule; 25] = [
    figures::check,
    stock_bore::check,
    bore_between_centres::check,
    bore_closed::check,
    order::check,
    negative_diameter::check,
    gap::check,
    overlap::check,
    wall::check,
    outside_part::check,
    bore_wall::check,
    arc_impossible::check,
    arc_undercut::check,
    arc_quadrant::check,
    arc_radius::check,
    below_axis::check,
    parabola_points::check,
    parabola_straight::check,
    parabola_turns_back::check,
    chords::check,
    taper::check,
    pitch::check,
    starts::check,
    thread_base::check,
    published_generator::check,
];
