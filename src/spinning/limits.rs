//! Limits of what is calculated with.

/// Figures beyond this are refused, mm, degrees, rev/min or m/min: no spinning lathe is as large.
pub const LARGEST_FIGURE: f64 = 1e5;

/// Most passes in which a shell is formed; published practice knows one and two.
pub const MOST_PASSES: u32 = 8;

/// Longest note of the lubricant, characters: it fits into one line of the setup sheet.
pub const LONGEST_LUBRICANT: usize = 60;

/// Stations of a turret that programs can call.
pub const STATIONS: std::ops::RangeInclusive<u32> = 1..=99;
