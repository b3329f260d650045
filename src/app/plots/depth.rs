//! Flat-shaded faces drawn into a picture with a depth for every pixel, so that bodies may stand in and behind one another.

use egui::{Color32, ColorImage};
use nalgebra::Point3;

/// Pixels of the drawing in each direction for one of the picture: smooth edges.
const FINER: usize = 2;
/// Widest and highest picture, pixels.
const MOST: usize = 4096;

/// A four-cornered face in the viewer's space: x right and y down in pixels of the picture, z towards the viewer.
#[derive(Debug, Clone)]
pub(super) struct Facet {
    /// Its corners, around.
    pub corners: [Point3<f64>; 4],
    /// Its colour, shaded.
    pub color: Color32,
}

/// Draws faces into a picture of this size on a transparent ground.
pub(super) fn drawn(facets: &[Facet], size: [usize; 2]) -> ColorImage {
    let [width, height] = size.map(|pixels| pixels.clamp(1, MOST));
    let mut canvas = Canvas::new(width * FINER, height * FINER);
    for facet in facets {
        let [a, b, c, d] = facet.corners;
        canvas.triangle([a, b, c], facet.color);
        canvas.triangle([a, c, d], facet.color);
    }
    canvas.reduced(width, height)
}

/// Pixels with their depths.
struct Canvas {
    width: usize,
    height: usize,
    pixels: Vec<Option<Color32>>,
    depths: Vec<f64>,
}

impl Canvas {
    fn new(width: usize, height: usize) -> Self {
        let count = width * height;
        Self { width, height, pixels: vec![None; count], depths: vec![f64::NEG_INFINITY; count] }
    }

    fn triangle(&mut self, corners: [Point3<f64>; 3], color: Color32) {
        let [a, b, c] = corners.map(|p| Point3::new(p.x * FINER as f64, p.y * FINER as f64, p.z));
        let area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
        if !area.is_finite() || area == 0.0 {
            return;
        }
        let columns = range([a.x, b.x, c.x], self.width);
        for row in range([a.y, b.y, c.y], self.height) {
            let y = row as f64 + 0.5;
            for column in columns.clone() {
                let x = column as f64 + 0.5;
                // Barycentric coordinates.
                let v = ((x - a.x) * (c.y - a.y) - (c.x - a.x) * (y - a.y)) / area;
                let w = ((b.x - a.x) * (y - a.y) - (x - a.x) * (b.y - a.y)) / area;
                if v >= 0.0 && w >= 0.0 && v + w <= 1.0 {
                    self.put(row * self.width + column, a.z + v * (b.z - a.z) + w * (c.z - a.z), color);
                }
            }
        }
    }

    fn put(&mut self, index: usize, depth: f64, color: Color32) {
        if let Some((nearest, pixel)) = self.depths.get_mut(index).zip(self.pixels.get_mut(index))
            && depth > *nearest
        {
            (*nearest, *pixel) = (depth, Some(color));
        }
    }

    /// The picture: every pixel the mean of the finer ones.
    fn reduced(&self, width: usize, height: usize) -> ColorImage {
        let fine = |row: usize, column: usize| self.pixels.get(row * self.width + column).copied().flatten();
        let mut pixels = Vec::with_capacity(width * height);
        for row in 0..height {
            for column in 0..width {
                let all = (0..FINER * FINER).map(|k| fine(row * FINER + k / FINER, column * FINER + k % FINER));
                pixels.push(mean(all));
            }
        }
        ColorImage::new([width, height], pixels)
    }
}

/// The mean of colours; what is empty lets the ground through.
#[allow(clippy::cast_possible_truncation, reason = "a mean of bytes is a byte")]
fn mean(colors: impl Iterator<Item = Option<Color32>>) -> Color32 {
    let (mut sums, mut count) = ([0_u32; 4], 0_u32);
    for color in colors {
        count += 1;
        let [r, g, b, a] = color.map_or([0; 4], |c| c.to_array());
        for (sum, part) in sums.iter_mut().zip([r, g, b, a]) {
            *sum += u32::from(part);
        }
    }
    let [r, g, b, a] = sums.map(|sum| (sum / count.max(1)) as u8);
    Color32::from_rgba_premultiplied(r, g, b, a)
}

/// The pixels that these places reach over.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped to the picture")]
fn range(places: [f64; 3], size: usize) -> std::ops::Range<usize> {
    let least = places.iter().copied().fold(f64::INFINITY, f64::min).floor().clamp(0.0, size as f64);
    let most = places.iter().copied().fold(f64::NEG_INFINITY, f64::max).ceil().clamp(0.0, size as f64);
    least as usize..most as usize
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square(left: f64, depth: f64, color: Color32) -> Facet {
        let corners = [(left, 2.0), (left + 6.0, 2.0), (left + 6.0, 8.0), (left, 8.0)];
        Facet { corners: corners.map(|(x, y)| Point3::new(x, y, depth)), color }
    }

    #[test]
    fn the_nearer_face_is_seen_whatever_comes_first() {
        let (near, far) = (square(4.0, 5.0, Color32::RED), square(1.0, 1.0, Color32::BLUE));
        for facets in [[near.clone(), far.clone()], [far, near]] {
            let picture = drawn(&facets, [12, 10]);
            let at = |x: usize, y: usize| picture.pixels[y * 12 + x];
            assert_eq!((at(2, 5), at(5, 5), at(8, 5)), (Color32::BLUE, Color32::RED, Color32::RED));
            assert_eq!((at(0, 0), at(11, 5)), (Color32::TRANSPARENT, Color32::TRANSPARENT));
        }
    }

    #[test]
    fn faces_outside_the_picture_or_without_extent_draw_nothing() {
        let mut broken = square(1.0, 1.0, Color32::RED);
        broken.corners[0].x = f64::NAN;
        let flat = Facet { corners: [Point3::new(3.0, 3.0, 0.0); 4], color: Color32::RED };
        let picture = drawn(&[square(-90.0, 1.0, Color32::RED), flat], [8, 8]);
        assert!(picture.pixels.iter().all(|p| *p == Color32::TRANSPARENT));
        assert_eq!(drawn(&[broken], [8, 8]).size, [8, 8]);
    }
}
