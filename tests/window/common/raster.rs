//! A rasteriser for egui's triangles: textured, clipped, premultiplied.

#![allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "pixels are clipped to the picture")]

use egui::{Color32, ImageData, Rect, TextureId, TexturesDelta, epaint};
use std::cell::RefCell;
use std::collections::{HashMap, HashSet};
use std::path::Path;
use std::rc::Rc;

/// Receives the textures of a harness.
pub struct Raster(pub Rc<RefCell<Textures>>);

impl egui_kittest::TestRenderer for Raster {
    fn handle_delta(&mut self, delta: &mut TexturesDelta) {
        self.0.borrow_mut().update(delta);
    }
}

/// A picture or a texture, row by row.
#[derive(Default, Clone)]
pub struct Picture {
    width: usize,
    height: usize,
    pixels: Vec<Color32>,
}

#[derive(Default)]
pub struct Textures(HashMap<TextureId, Picture>);

impl Textures {
    fn update(&mut self, delta: &mut TexturesDelta) {
        for (id, changes) in &delta.set {
            for change in changes {
                self.change(*id, change);
            }
        }
        for id in &delta.free {
            self.0.remove(id);
        }
        delta.clear();
    }

    fn change(&mut self, id: TextureId, change: &epaint::ImageDelta) {
        let ImageData::Color(image) = &change.image;
        let [w, h] = image.size;
        let Some([x, y]) = change.pos else {
            self.0.insert(id, Picture { width: w, height: h, pixels: image.pixels.clone() });
            return;
        };
        let texture = self.0.get_mut(&id).expect("a part of a texture that exists");
        for row in 0..h {
            let at = (y + row) * texture.width + x;
            texture.pixels[at..at + w].copy_from_slice(&image.pixels[row * w..(row + 1) * w]);
        }
    }

    /// Paints what a frame put out.
    pub fn paint(&self, ctx: &egui::Context, output: &egui::FullOutput) -> Picture {
        let scale = output.pixels_per_point;
        let size = ctx.content_rect().size() * scale;
        let (width, height) = (size.x as usize, size.y as usize);
        let mut picture = Picture { width, height, pixels: vec![Color32::BLACK; width * height] };
        for job in ctx.tessellate(output.shapes.clone(), scale) {
            let epaint::Primitive::Mesh(mesh) = &job.primitive else { continue };
            let Some(texture) = self.0.get(&mesh.texture_id) else { continue };
            for corners in mesh.indices.chunks_exact(3) {
                let corners = [0, 1, 2].map(|i| mesh.vertices[corners[i] as usize]);
                picture.triangle(
                    &corners.map(|v| epaint::Vertex { pos: v.pos * scale, ..v }),
                    texture,
                    job.clip_rect * scale,
                );
            }
        }
        picture
    }
}

impl Picture {
    fn triangle(&mut self, [a, b, c]: &[epaint::Vertex; 3], texture: &Self, clip: Rect) {
        let area = (b.pos - a.pos).x * (c.pos - a.pos).y - (b.pos - a.pos).y * (c.pos - a.pos).x;
        let whole = Rect::from_min_size(egui::Pos2::ZERO, egui::vec2(self.width as f32, self.height as f32));
        let bounds = Rect::from_points(&[a.pos, b.pos, c.pos]).intersect(clip).intersect(whole);
        if area == 0.0 || bounds.is_negative() {
            return;
        }
        let centres = |from: f32, to: f32| (from - 0.5).ceil().max(0.0) as usize..(to + 0.5).floor() as usize;
        for y in centres(bounds.top(), bounds.bottom()) {
            for x in centres(bounds.left(), bounds.right()) {
                let p = egui::pos2(x as f32 + 0.5, y as f32 + 0.5);
                let weight = |u: egui::Pos2, v: egui::Pos2| {
                    let w = ((v - u).x * (p - u).y - (v - u).y * (p - u).x) / area;
                    (w > 0.0 || (w == 0.0 && is_top_left(u, v, area))).then_some(w)
                };
                let weights = (weight(b.pos, c.pos), weight(c.pos, a.pos), weight(a.pos, b.pos));
                let (Some(wa), Some(wb), Some(wc)) = weights else { continue };
                let texel = texture.at(a.uv.to_vec2() * wa + b.uv.to_vec2() * wb + c.uv.to_vec2() * wc);
                let color = std::array::from_fn(|i| {
                    let [a, b, c] = [a, b, c].map(|v| f32::from(v.color[i]));
                    (a * wa + b * wb + c * wc) * texel[i] / 255.0
                });
                self.blend(y * self.width + x, color);
            }
        }
    }

    /// The texture between its texels, as a GPU reads it.
    fn at(&self, uv: egui::Vec2) -> [f32; 4] {
        let (u, v) = (uv.x * self.width as f32 - 0.5, uv.y * self.height as f32 - 0.5);
        let (fx, fy) = (u - u.floor(), v - v.floor());
        let texel = |dx: f32, dy: f32| {
            let x = (u.floor() + dx).clamp(0.0, self.width as f32 - 1.0) as usize;
            let y = (v.floor() + dy).clamp(0.0, self.height as f32 - 1.0) as usize;
            self.pixels[y * self.width + x].to_array().map(f32::from)
        };
        let (p, q, r, s) = (texel(0.0, 0.0), texel(1.0, 0.0), texel(0.0, 1.0), texel(1.0, 1.0));
        std::array::from_fn(|i| (p[i] * (1.0 - fx) + q[i] * fx) * (1.0 - fy) + (r[i] * (1.0 - fx) + s[i] * fx) * fy)
    }

    fn blend(&mut self, index: usize, [r, g, b, a]: [f32; 4]) {
        let under = self.pixels[index];
        let over = |top: f32, bottom: u8| (top + f32::from(bottom) * (1.0 - a / 255.0)).round().clamp(0.0, 255.0) as u8;
        self.pixels[index] = Color32::from_rgb(over(r, under.r()), over(g, under.g()), over(b, under.b()));
    }

    /// The pixels within a rectangle, at one pixel a point.
    pub fn part(&self, rect: Rect) -> Vec<Color32> {
        let within =
            |from: f32, to: f32, most: usize| (from.max(0.0) as usize).min(most)..(to.max(0.0) as usize).min(most);
        let columns = within(rect.left(), rect.right(), self.width);
        let rows = within(rect.top(), rect.bottom(), self.height);
        rows.flat_map(|row| self.pixels[row * self.width..][columns.clone()].iter().copied()).collect()
    }

    /// How many colours there are in it.
    pub fn colors(&self) -> usize {
        self.pixels.iter().collect::<HashSet<_>>().len()
    }

    pub fn save(&self, path: &Path) {
        let file = std::fs::File::create(path).expect("the screenshot can be written");
        let mut encoder = png::Encoder::new(std::io::BufWriter::new(file), self.width as u32, self.height as u32);
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_compression(png::Compression::High);
        let bytes: Vec<u8> = self.pixels.iter().flat_map(|p| [p.r(), p.g(), p.b()]).collect();
        encoder.write_header().and_then(|mut w| w.write_image_data(&bytes)).expect("the screenshot can be written");
    }
}

/// Pixels whose centre lies on an edge belong to one of the two triangles that share it.
fn is_top_left(u: egui::Pos2, v: egui::Pos2, area: f32) -> bool {
    let edge = if area > 0.0 { v - u } else { u - v };
    edge.y < 0.0 || (edge.y == 0.0 && edge.x > 0.0)
}
