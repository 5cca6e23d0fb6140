//! The whole picture: the nearest surface, the shadow count and the colour of each pixel.

use std::collections::HashMap;

use glam::{DMat3, DVec2, DVec3};

use crate::billboards::Billboards;
use crate::bodies::{Body, BodyHit};
use crate::contact::Ground;
use crate::creases::ribbons_of;
use crate::form::Form;
use crate::hull::{Covered, Hull};
use crate::light::Light;
use crate::pattern::{On, Sheet, Spot, packed_radius, rounded};
use crate::ray::Camera;
use crate::scene::{Pattern, Scene, Volumes};
use crate::shade::{Part, Shade, Shadow, display, ink_of, linear};
use crate::surfaces::Solids;
use crate::volumes::Volume;

/// First number of surfaces that are not smoke.
const SURFACES: u32 = 1 << 20;
const BACKDROP: u32 = SURFACES - 1;
/// Bodies keep this distance from both ends of the depth range.
const DEPTH_MARGIN: f64 = 4e-7;
/// Maximum count of an 8-bit stencil.
const MOST: u32 = 255;

/// The nearest surface in a pixel.
#[derive(Clone, Copy)]
struct Nearest {
    shade: Shade,
    /// Window depth, and view depth.
    window_depth: f64,
    depth: f64,
    what: u32,
    alpha: u8,
    /// Index of the visible surface, or of the one under another's line.
    group: Option<usize>,
    /// Of smoke, see `BodyHit`.
    place: DVec3,
    radius: f64,
    facing: f64,
}

/// Pixels row by row from the bottom.
pub struct Picture {
    colors: Vec<[u8; 4]>,
    counts: Vec<u8>,
    regions: Vec<u32>,
}

impl Picture {
    /// RGBA colours, one byte per channel; then shadow volume counts, one byte each; then region numbers, four bytes
    /// each, lowest first. The pixels of one region show the same tone of the same surface.
    pub fn to_bytes(&self) -> Vec<u8> {
        let regions = self.regions.iter().flat_map(|region| region.to_le_bytes());
        self.colors
            .iter()
            .flatten()
            .chain(&self.counts)
            .copied()
            .chain(regions)
            .collect()
    }
}

pub fn draw(scene: &Scene) -> Picture {
    let billboards = scene.puffs.layers.as_ref().map(Billboards::new);
    let painter = Painter::new(scene, billboards.as_ref());
    let mut seen: Vec<Nearest> = (0..scene.width * scene.height)
        .map(|pixel| painter.behind_smoke(pixel))
        .collect();
    for index in 0..scene.surfaces.len() {
        painter.draw_line(index, &mut seen);
    }
    for index in 0..scene.surfaces.len() {
        painter.draw_creases(index, &mut seen);
    }
    let ground = Ground {
        camera: &painter.camera,
        width: scene.width,
        depths: seen.iter().map(|seen| seen.window_depth).collect(),
    };
    let form = Form::new(scene, &painter.camera, &painter.light);
    for (index, &row) in scene.bodies.iter().enumerate() {
        let (camera, light) = (&painter.camera, &painter.light);
        if let Some(body) = Body::new(scene, billboards.as_ref(), camera, light, form.as_ref(), row) {
            painter.draw_body(&body, index as u32, &ground, &mut seen);
        }
    }
    let counts = seen
        .iter()
        .enumerate()
        .map(|(pixel, seen)| painter.shadows_over(pixel, seen))
        .collect();
    painter.finished(&seen, counts)
}

struct Painter<'a> {
    scene: &'a Scene,
    camera: Camera,
    solids: Solids<'a>,
    volumes: Vec<Volume<'a>>,
    light: Light,
}

impl<'a> Painter<'a> {
    fn new(scene: &'a Scene, billboards: Option<&'a Billboards>) -> Self {
        let (camera, light) = (Camera::new(scene), Light::new(&scene.light));
        Self {
            solids: Solids::new(&scene.surfaces),
            volumes: scene
                .casters
                .iter()
                .filter_map(|row| Volume::new(scene, billboards, &camera, &light, row))
                .collect(),
            light,
            scene,
            camera,
        }
    }

    fn middle_of(&self, pixel: usize) -> DVec2 {
        DVec2::new(
            (pixel % self.scene.width) as f64 + 0.5,
            (pixel / self.scene.width) as f64 + 0.5,
        )
    }

    /// 0 at the bottom of the picture, 1 at its top.
    fn height_of(&self, pixel: usize) -> f64 {
        self.middle_of(pixel).y / self.scene.height as f64
    }

    fn behind_smoke(&self, pixel: usize) -> Nearest {
        let ray = self.camera.ray_in_world(self.middle_of(pixel));
        let depths = [self.camera.near, self.camera.far];
        let style = &self.scene.style;
        let Some((index, depth, shade)) = self.solids.meet(ray, depths, &self.light, style) else {
            return backdrop(self.scene, self.height_of(pixel));
        };
        Nearest {
            shade,
            window_depth: self.camera.window_depth(depth),
            depth,
            what: SURFACES + index as u32,
            alpha: 255,
            group: Some(self.scene.surfaces[index].group),
            place: DVec3::ZERO,
            radius: 0.0,
            facing: 0.0,
        }
    }

    /// The outline of a surface.
    fn draw_line(&self, index: usize, seen: &mut [Nearest]) {
        let surface = &self.scene.surfaces[index];
        let hull = Hull::new(surface, &self.scene.style, &self.camera, &self.light);
        for Covered {
            x,
            y,
            depth,
            raised_depth,
        } in hull.covered(self.scene.width, self.scene.height)
        {
            let seen = &mut seen[y * self.scene.width + x];
            let window_depth = if seen.group == Some(surface.group) {
                depth
            } else {
                raised_depth
            };
            self.put_ink(index, window_depth, seen);
        }
    }

    /// Lines along the sharp edges of a surface, and along its seams with later surfaces.
    fn draw_creases(&self, index: usize, seen: &mut [Nearest]) {
        for ribbon in ribbons_of(index, self.scene, &self.camera) {
            for ([x, y], window_depth) in ribbon.covered(self.scene.width, self.scene.height) {
                self.put_ink(index, window_depth, &mut seen[y * self.scene.width + x]);
            }
        }
    }

    fn put_ink(&self, surface: usize, window_depth: f64, seen: &mut Nearest) {
        if window_depth <= seen.window_depth {
            *seen = Nearest {
                shade: Shade::same(ink_of(&self.scene.style), Part::Ink),
                window_depth,
                depth: self.camera.depth_of(window_depth),
                what: SURFACES + surface as u32,
                alpha: 255,
                ..*seen
            };
        }
    }

    fn draw_body(&self, body: &Body, what: u32, ground: &Ground, seen: &mut [Nearest]) {
        let [lowest, highest] = body.extent(&self.camera);
        let span = |low: f64, high: f64, size: usize| low.max(0.0) as usize..(high.max(0.0) as usize + 1).min(size);
        for y in span(lowest.y, highest.y, self.scene.height) {
            for x in span(lowest.x, highest.x, self.scene.width) {
                let pixel = y * self.scene.width + x;
                let ray = self.camera.ray(self.middle_of(pixel));
                if let Some(hit) = body.meet(ray, self.height_of(pixel), ground, [x as i64, y as i64]) {
                    self.put(hit, what, &mut seen[pixel]);
                }
            }
        }
    }

    /// At equal depth the later one wins.
    fn put(&self, hit: BodyHit, what: u32, seen: &mut Nearest) {
        let window_depth = self
            .camera
            .window_depth(hit.depth)
            .clamp(DEPTH_MARGIN, 1.0 - DEPTH_MARGIN);
        if window_depth <= seen.window_depth {
            *seen = Nearest {
                shade: hit.shade,
                window_depth,
                depth: hit.depth,
                what,
                alpha: 255,
                place: hit.place,
                radius: hit.radius,
                facing: hit.facing,
                ..*seen
            };
        }
    }

    fn finished(&self, nearest: &[Nearest], counts: Vec<u32>) -> Picture {
        let style = &self.scene.style;
        let shadows: Vec<Shadow> = counts.iter().map(|&count| Shadow::of(style, count)).collect();
        let covered = self.covered(nearest, &shadows);
        let colors = nearest
            .iter()
            .zip(&shadows)
            .zip(&covered)
            .map(|((seen, &shadow), &covered)| {
                let own = seen.shade.under(shadow, style);
                let color = match &style.pattern {
                    Some(pattern) if covered > 0.0 => {
                        display(linear(own).lerp(linear(DVec3::from(pattern.color)), covered))
                    }
                    _ => own,
                };
                let [red, green, blue] = color.to_array().map(|channel| channel.round().clamp(0.0, 255.0) as u8);
                [red, green, blue, seen.alpha]
            });
        Picture {
            colors: colors.collect(),
            counts: counts.iter().map(|&count| count.min(MOST) as u8).collect(),
            regions: regions_of(nearest, &shadows, &covered),
        }
    }

    /// Share of each pixel that marks cover.
    fn covered(&self, nearest: &[Nearest], shadows: &[Shadow]) -> Vec<f64> {
        let Some(pattern) = &self.scene.style.pattern else {
            return vec![0.0; nearest.len()];
        };
        let seen = nearest.iter().zip(shadows).enumerate();
        let spots = seen
            .map(|(pixel, (seen, &shadow))| self.spot(pattern, pixel, seen, shadow))
            .collect();
        let turn = DMat3::from_mat4(self.camera.view_from_world);
        let sheet = Sheet::new(pattern, self.scene.width, self.scene.height, spots, turn);
        (0..nearest.len()).map(|pixel| sheet.covered(pixel)).collect()
    }

    /// What marks are drawn on.
    fn spot(&self, pattern: &Pattern, pixel: usize, seen: &Nearest, shadow: Shadow) -> Spot {
        let Shade { lit, unlit, part, ink } = seen.shade;
        let is_shadowed = shadow != Shadow::No;
        let (on, at, amount) = match seen.what {
            BACKDROP => {
                let height = self.height_of(pixel);
                (
                    On::Backdrop,
                    self.camera.ray(self.middle_of(pixel)).at(1.0),
                    pattern.on_backdrop(height),
                )
            }
            SURFACES.. => {
                let place = self.camera.ray_in_world(self.middle_of(pixel)).at(seen.depth);
                (On::Surface, place, pattern.on_surface(!is_shadowed || lit == unlit))
            }
            _ => {
                let facing = rounded(seen.facing);
                let is_lit = !is_shadowed && facing >= self.scene.style.lit_from;
                let amount = match part {
                    Part::Tones { .. } if ink == 0.0 => pattern.on_smoke(is_lit, facing),
                    _ => 0.0,
                };
                (On::Smoke, seen.place, amount)
            }
        };
        Spot {
            on,
            at,
            amount,
            per_pixel: match on {
                On::Smoke => self.camera.metres_per_pixel(seen.depth) / packed_radius(seen.radius),
                _ => self.camera.metres_per_pixel(1.0),
            },
            ink: rounded(ink),
        }
    }

    /// Number of volumes that contain the visible surface. A volume through the near plane starts just behind it.
    fn shadows_over(&self, pixel: usize, seen: &Nearest) -> u32 {
        if !self.scene.shadows || seen.what == BACKDROP {
            return 0;
        }
        let ray = self.camera.ray_in_world(self.middle_of(pixel));
        let depth = seen.depth.max(self.camera.near);
        let contains = |volume: &&Volume| match self.scene.style.volumes {
            Volumes::Receiver => volume.contains(ray.at(depth)),
            Volumes::Counted => volume.holds(ray, depth),
        };
        let of_puffs = self.volumes.iter().filter(contains).count() as u32;
        let of_solids = self.solids.shadows_over(ray.at(depth), &self.light);
        // With two shadow steps solids count once.
        let most = self.scene.style.shadow_depth.map_or(u32::MAX, |_| 1);
        of_puffs + of_solids.min(most)
    }
}

fn backdrop(scene: &Scene, height: f64) -> Nearest {
    let color = scene.backdrop.as_ref().map_or(DVec3::ZERO, |stops| {
        let above = stops.partition_point(|stop| stop.from <= height);
        let [low, high] = [above.saturating_sub(1), above.min(stops.len() - 1)].map(|index| &stops[index]);
        let span = high.from - low.from;
        let share = if span > 0.0 { (height - low.from) / span } else { 0.0 };
        DVec3::from(low.color).lerp(DVec3::from(high.color), share)
    });
    Nearest {
        shade: Shade::same(color, Part::Only),
        window_depth: 1.0,
        depth: f64::INFINITY,
        what: BACKDROP,
        alpha: if scene.backdrop.is_some() { 255 } else { 0 },
        group: None,
        place: DVec3::ZERO,
        radius: 0.0,
        facing: 0.0,
    }
}

/// Numbers the regions: part, surface, shadow and marks of each pixel.
fn regions_of(nearest: &[Nearest], shadows: &[Shadow], covered: &[f64]) -> Vec<u32> {
    let mut numbers = HashMap::new();
    let mut number_of = |region| {
        let next = numbers.len() as u32;
        *numbers.entry(region).or_insert(next)
    };
    nearest
        .iter()
        .zip(shadows)
        .zip(covered)
        .map(|((seen, &shadow), covered)| {
            number_of((seen.what, seen.shade.part, shadow, (255.0 * covered).round() as u8))
        })
        .collect()
}
