//! Limits of what is calculated with.

/// Figures beyond this are refused, mm, degrees, rev/min or m/min: no spinning lathe is as large.
pub const LARGEST_FIGURE: f64 = 1e5;

/// Most passes in which a shell is formed; published practice knows one and two.
pub const MOST_PASSES: u32 = 8;
