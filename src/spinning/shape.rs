//! The shell over its former: inside, outside, wall and reduction along it, and the blank that it is made from.

use super::former::{self, CONTOUR_TOLERANCE_MM};
use super::hollow::{self, Hollow};
use super::law;
use super::limits::LARGEST_FIGURE;
use super::offset::{self, Distance};
use crate::document::Shell;
use crate::geometry::{Contour, Point, Segment};
use std::f64::consts::PI;

/// Distance of chords from arcs where the shell is sampled, mm.
const SAMPLE_TOLERANCE_MM: f64 = 0.01;

/// One place along the shell.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Station {
    /// Inside point.
    pub at: Point,
    /// Length along the wall from the tip, mm.
    pub along: f64,
    /// Angle of the wall to the axis, radians.
    pub half_angle: f64,
    /// Wall thickness, mm.
    pub wall: f64,
    /// Reduction of the blank's thickness, a share.
    pub reduction: f64,
}

/// The finished shell. Part space, z = 0 at the chuck's face, mm.
#[derive(Debug, Clone, PartialEq)]
pub struct ShellShape {
    /// Contour of the former from tip to base.
    pub former: Contour,
    /// Inside of the shell from tip to base: the former's contour but for the hollows that the roller spans.
    pub inside: Contour,
    /// Outside of the shell from tip to base.
    pub outside: Contour,
    /// Hollows of the former that the roller does not reach into, from tip to base.
    pub hollows: Vec<Hollow>,
    /// Path of the roller's nose centre along the former.
    pub centres: Contour,
    /// Places along it, from tip to base; both sides of a corner are there.
    pub stations: Vec<Station>,
    /// Thickness of the blank, mm.
    pub thickness: f64,
    /// Length of the cylinder behind the contour, mm.
    pub base_length: f64,
    /// Volume of the shell with its flat tip, mm³.
    pub volume: f64,
    /// Radius of the disc of equal volume, mm.
    pub volume_radius: f64,
    /// Radius of the blank: as given, or by volume, mm.
    pub blank_radius: f64,
}

impl ShellShape {
    /// Where the contour leaves the flat tip.
    #[must_use]
    pub fn tip(&self) -> Point {
        self.former.segments.first().map(Segment::start).unwrap_or_default()
    }

    /// Where the contour ends.
    #[must_use]
    pub fn base(&self) -> Point {
        self.former.segments.last().map(Segment::end).unwrap_or_default()
    }

    /// The place with the thinnest wall.
    #[must_use]
    pub fn thinnest(&self) -> Option<&Station> {
        self.stations.iter().min_by(|a, b| a.wall.total_cmp(&b.wall))
    }

    /// Closed outline of the former with its base cylinder, half above the axis.
    #[must_use]
    pub fn former_outline(&self, tolerance: f64) -> Vec<Point> {
        let (tip, base) = (self.tip(), self.base());
        let mut outline = vec![Point::new(tip.z, 0.0)];
        outline.extend(self.former.polyline(tolerance));
        outline.extend([Point::new(0.0, base.r), Point::new(0.0, 0.0)]);
        outline
    }

    /// Closed outline of the finished shell, half above the axis.
    #[must_use]
    pub fn shell_outline(&self, tolerance: f64) -> Vec<Point> {
        let tip = self.tip();
        let face = tip.z + self.thickness;
        let mut outline = vec![Point::new(tip.z, 0.0)];
        outline.extend(self.inside.polyline(tolerance));
        outline.extend(self.outside.polyline(tolerance).into_iter().rev());
        outline.extend([Point::new(face, tip.r), Point::new(face, 0.0)]);
        outline
    }
}

/// The shell of a design in mm; `None` where its figures describe none.
#[must_use]
pub fn shape(shell_mm: &Shell) -> Option<ShellShape> {
    let thickness = shell_mm.blank.thickness;
    let usable = |value: &f64| *value > 0.0 && *value <= LARGEST_FIGURE;
    if !usable(&thickness) {
        return None;
    }
    let former = former::contour(&shell_mm.former)?;
    let wall = Distance { forming: shell_mm.forming, thickness, more: 0.0 };
    let nose = Some(shell_mm.roller.nose_radius).filter(usable).unwrap_or_default();
    let to_centre = Distance { more: nose, ..wall };
    let centres = offset::offset(&former, to_centre, CONTOUR_TOLERANCE_MM);
    let (inside, hollows) = hollow::formed(&former, &centres, to_centre);
    let outside = offset::offset(&inside, wall, CONTOUR_TOLERANCE_MM).contour;
    let stations = stations(&inside, shell_mm);
    let mut shape = ShellShape {
        former,
        inside,
        hollows,
        centres: centres.contour,
        outside,
        stations,
        thickness,
        base_length: shell_mm.former.base_length,
        volume: 0.0,
        volume_radius: 0.0,
        blank_radius: 0.0,
    };
    shape.volume = turned_volume(&shape.shell_outline(CONTOUR_TOLERANCE_MM));
    shape.volume_radius = law::disc_radius(shape.volume, thickness);
    let given = shell_mm.blank.diameter.filter(usable);
    shape.blank_radius = given.map_or(shape.volume_radius, |d| d / 2.0);
    Some(shape)
}

fn stations(inside: &Contour, shell: &Shell) -> Vec<Station> {
    let thickness = shell.blank.thickness;
    let mut stations = Vec::new();
    let mut along = 0.0;
    for segment in &inside.segments {
        let points = segment.polyline_points(SAMPLE_TOLERANCE_MM).len().max(1);
        for k in 0..=points {
            let share = k as f64 / points as f64;
            let half_angle = offset::half_angle(segment.direction_at(share));
            let wall = law::wall(shell.forming, thickness, half_angle);
            stations.push(Station {
                at: segment.point_at(share),
                along: along + segment.length() * share,
                half_angle,
                wall,
                reduction: law::reduction(wall, thickness),
            });
        }
        along += segment.length();
    }
    stations
}

/// Volume that a closed outline above the axis sweeps round it: `π ∮ r² dz`, exact for its straight sides.
fn turned_volume(outline: &[Point]) -> f64 {
    let next = outline.iter().cycle().skip(1);
    let sum: f64 = outline.iter().zip(next).map(|(a, b)| (b.z - a.z) * (a.r * a.r + a.r * b.r + b.r * b.r) / 3.0).sum();
    (PI * sum).abs()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::{FormerShape, Forming};

    fn shell(shape: FormerShape, forming: Forming) -> Shell {
        let mut shell = Shell { forming, ..Shell::default() };
        shell.former.shape = shape;
        shell
    }

    #[test]
    fn the_blank_of_a_sheared_cone_is_as_wide_as_the_cone() {
        let made = shape(&Shell::default()).unwrap();
        let base = 20.0 + 50.0 * 30.0_f64.to_radians().tan();
        // Sheared along the axis every ring keeps its radius; the edge is square to the wall, so the disc reaches half of it.
        let edge = 0.8 * 30.0_f64.to_radians().cos();
        assert!(made.blank_radius > base && made.blank_radius < base + edge, "{}", made.blank_radius);
        assert!((made.stations[0].wall - 0.8).abs() < 1e-12);
        assert!((made.stations[0].reduction - 0.5).abs() < 1e-12);
    }

    #[test]
    fn spinning_keeps_wall_and_area() {
        let cone = FormerShape::Cone { half_angle_deg: 45.0, tip_diameter: 40.0, length: 30.0 };
        let made = shape(&shell(cone, Forming::Spinning)).unwrap();
        // Area of the middle surface times the wall; the bend at the tip is left out of it.
        let (r1, r2) = (20.0 + 0.8 * 0.5_f64.sqrt(), 50.0 + 0.8 * 0.5_f64.sqrt());
        let area = PI * (r1 + r2) * 30.0 * 2.0_f64.sqrt() + PI * 400.0;
        assert!((made.volume / (area * 1.6) - 1.0).abs() < 0.02, "{} {}", made.volume, area * 1.6);
    }

    #[test]
    fn half_a_ball_thins_towards_its_edge() {
        let ball = FormerShape::Ellipse { semi_axis: 50.0, diameter: 100.0, tip_diameter: 20.0, length: 35.0 };
        let made = shape(&shell(ball, Forming::Shear)).unwrap();
        assert!(made.stations.windows(2).all(|w| w[1].wall <= w[0].wall + 1e-12));
        let last = made.stations.last().unwrap();
        let z = 50.0 * (1.0 - 0.04_f64).sqrt() - 35.0;
        assert!((last.half_angle.sin() - z / 50.0).abs() < 1e-9);
        assert!((last.at.z - 40.0).abs() < 1e-9);
    }

    #[test]
    fn impossible_blanks_have_no_shape() {
        let mut thin = Shell::default();
        thin.blank.thickness = f64::NAN;
        assert_eq!(shape(&thin), None);
    }
}
