//! The path of the roller's nose centre: approach, contour, retreat, for every pass.

use super::law;
use super::offset;
use super::shape::ShellShape;
use crate::document::{Forming, Shell};
use crate::geometry::{Contour, Point, Segment, Vector};

/// Distance that the roller keeps from the flat blank before it begins and from everything when it travels, mm.
pub const CLEARANCE_MM: f64 = 3.0;

/// Distance of chords from the contour between two passes, mm: no former is there.
const FREE_PASS_TOLERANCE_MM: f64 = 0.005;

/// One pass of the roller.
#[derive(Debug, Clone, PartialEq)]
pub struct RollerPass {
    /// Where the roller stands clear of the blank, in front of the contour.
    pub approach: Point,
    /// Path of the nose's centre from tip to base; without segments where the roller fits nowhere.
    pub contour: Contour,
    /// Where it leaves to, straight away from the axis.
    pub retreat: Point,
}

/// All passes.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct RollerPath {
    /// Passes in order; the last one follows the former.
    pub passes: Vec<RollerPass>,
    /// Radius at which the roller travels freely, mm.
    pub free_radius: f64,
}

/// The path of a design in mm over its shape.
#[must_use]
pub fn path(shell_mm: &Shell, shape: &ShellShape) -> RollerPath {
    let nose = shell_mm.roller.nose_radius;
    let passes = shell_mm.passes.clamp(1, super::limits::MOST_PASSES);
    let contours: Vec<Contour> = (1..=passes).map(|pass| pass_contour(shell_mm, shape, pass, passes)).collect();
    let highest =
        contours.iter().filter_map(Contour::bounds).map(|b| b.max.r).fold(shape.blank_radius + nose, f64::max);
    let free_radius = highest + nose + CLEARANCE_MM;
    let clear_z = shape.tip().z + shape.thickness + nose + CLEARANCE_MM;
    let made = contours.into_iter().filter_map(|contour| {
        let (start, end) = (contour.segments.first()?.start(), contour.segments.last()?.end());
        let back = (clear_z - start.z).max(CLEARANCE_MM);
        Some(RollerPass { approach: start + Vector::new(back, back), contour, retreat: Point::new(end.z, free_radius) })
    });
    RollerPath { passes: made.collect(), free_radius }
}

fn pass_contour(shell: &Shell, shape: &ShellShape, pass: u32, passes: u32) -> Contour {
    let nose = shell.roller.nose_radius;
    if pass == passes {
        return shape.centres.clone();
    }
    let angle = |at: f64| law::angle_after(shell.forming, at, pass, passes);
    let mut at = shape.tip();
    let mut centres = Vec::new();
    let mut push = |at: Point, half_angle: f64| {
        let wall = law::wall(shell.forming, shape.thickness, half_angle);
        centres.push(at + offset::outward(half_angle) * (wall + nose));
    };
    for segment in &shape.former.segments {
        let count = segment.polyline_points(FREE_PASS_TOLERANCE_MM).len().max(1);
        let angle_at = |share: f64| angle(offset::half_angle(segment.direction_at(share)));
        push(at, angle_at(0.0));
        for k in 1..=count {
            let (from, to) = ((k - 1) as f64 / count as f64, k as f64 / count as f64);
            let chord = segment.point_at(to) - segment.point_at(from);
            let middle = angle_at(f64::midpoint(from, to));
            at = at + step(shell.forming, chord, middle);
            push(at, angle_at(to));
        }
    }
    Contour::new(centres.windows(2).filter(|w| w[0] != w[1]).map(|w| Segment::line(w[0], w[1])).collect())
}

/// Where an element of the wall ends that stands at `half_angle` now: flow-turning keeps its radii, spinning its length.
fn step(forming: Forming, chord: Vector, half_angle: f64) -> Vector {
    match forming {
        Forming::Shear => {
            let steepest = half_angle.tan().max(1e-3);
            Vector::new(-chord.y / steepest, chord.y)
        }
        Forming::Spinning => Vector::new(-half_angle.cos(), half_angle.sin()) * chord.norm(),
    }
}

impl RollerPath {
    /// The pass that follows the former.
    #[must_use]
    pub fn last(&self) -> Option<&RollerPass> {
        self.passes.last()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::FormerShape;
    use crate::spinning::shape::shape;

    fn made(shell: &Shell) -> (ShellShape, RollerPath) {
        let shape = shape(shell).unwrap();
        let path = path(shell, &shape);
        (shape, path)
    }

    #[test]
    fn the_centre_of_a_cone_runs_nose_and_wall_above_it() {
        let (shape, path) = made(&Shell::default());
        let [pass] = path.passes.as_slice() else { panic!("one pass") };
        assert_eq!(pass.contour.segments.len(), 1);
        for k in 0..=10 {
            let centre = pass.contour.segments[0].point_at(f64::from(k) / 10.0);
            assert!((shape.former.distance_to(centre) - 9.8).abs() < 1e-9);
        }
        // The published compensation R(1 − cos 30°) is how much lower the centre lies than straight above the tip.
        let start = pass.contour.segments[0].start();
        let rise = start.r - shape.tip().r - 0.8 * 30.0_f64.to_radians().cos();
        assert!((9.0 - rise - 9.0 * (1.0 - 30.0_f64.to_radians().cos())).abs() < 1e-9);
    }

    #[test]
    fn two_passes_end_on_the_former_and_the_first_is_wider() {
        let mut shell = Shell { passes: 2, ..Shell::default() };
        shell.former.shape = FormerShape::Cone { half_angle_deg: 10.0, tip_diameter: 60.0, length: 80.0 };
        let (shape, path) = made(&shell);
        let [first, second] = path.passes.as_slice() else { panic!("two passes") };
        let angle = |c: &Contour| offset::half_angle(c.segments[0].direction_at(0.0)).to_degrees();
        assert!((angle(&second.contour) - 10.0).abs() < 1e-9);
        let want = 10.0_f64.to_radians().sin().sqrt().asin().to_degrees();
        assert!((angle(&first.contour) - want).abs() < 1e-9, "{}", angle(&first.contour));
        assert!(first.approach.z > shape.tip().z + shape.thickness + 9.0);
    }

    #[test]
    fn passes_of_a_dish_stay_off_the_former() {
        let mut shell = Shell { passes: 3, ..Shell::default() };
        shell.former.shape = FormerShape::Dish { focal_length: 60.0, tip_diameter: 30.0, rim_diameter: 180.0 };
        let (shape, path) = made(&shell);
        assert_eq!(path.passes.len(), 3);
        for pass in &path.passes {
            let end = pass.contour.segments.last().unwrap().end();
            assert!(shape.former.distance_to(end) >= 9.0 && end.r < path.free_radius);
        }
    }
}
