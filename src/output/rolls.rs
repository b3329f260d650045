//! Files of a set of form-rolls beside the programs: contours in the E layout and as DXF, the parts list, the aperture of
//! the die block.

use super::OutputFile;
use crate::papers::{parts_list_csv, roll_lines};
use crate::regen::Derived;
use crate::rollform::die::die_aperture;
use crate::storage::export::{die_dxf, e_layout, roll_dxf};

/// The files, roll by roll, then those of the set. None of another document.
pub(super) fn files(derived: &Derived) -> Vec<OutputFile> {
    let (Some(set), Some(document)) = (&derived.rolls, derived.document.content.roll_set()) else { return Vec::new() };
    let unit = derived.document.unit;
    let name = &derived.document.name;
    let mut files = Vec::new();
    let mut put = |name: String, text: String| files.push(OutputFile { name, text });
    for roll in set.design.rolls() {
        put(format!("E{}.txt", roll.name), e_layout(&roll.elements));
        if let Ok(text) = roll_dxf(&roll.elements, roll.part.stock_bore_diameter, unit) {
            put(format!("{}.dxf", roll.name), text);
        }
    }
    put(format!("{name}.parts.csv"), parts_list_csv(&roll_lines(derived)));
    let set = document.scaled(unit.in_mm());
    if let Ok(text) = die_dxf(&die_aperture(&set, set.die_clearance_mm()), unit) {
        put(format!("{name}.die.dxf"), text);
    }
    files
}
