//! The outline of a surface: its back faces, extruded in the picture by the line width. A raised copy closes the line
//! where the surface stands on another; it does not cover the surface's own pixels.

use glam::{DVec2, DVec3};

use crate::ink::swelling;
use crate::light::Light;
use crate::mesh::Mesh;
use crate::ray::Camera;
use crate::scene::{Style, Surface};

/// Distance of the raised copy towards the eye in line widths, and its maximum (m).
const HULL_RAISED: (f64, f64) = (6.0, 0.05);

/// A corner of a hull (pixels), with its window depth in place and raised.
#[derive(Clone, Copy)]
struct Corner {
    pixel: DVec2,
    depths: DVec2,
}

/// The back faces of one surface in the picture.
pub struct Hull {
    faces: Vec<[Corner; 3]>,
}

/// A covered pixel with both depths.
pub struct Covered {
    pub x: usize,
    pub y: usize,
    pub depth: f64,
    pub raised_depth: f64,
}

impl Hull {
    /// Empty without a line. Only triangle meshes have one, and only entirely in front of the near plane.
    pub fn new(surface: &Surface, style: &Style, camera: &Camera, light: &Light) -> Self {
        let Some(mesh) = Mesh::of(&surface.shape).filter(|_| surface.inked && style.ink_pixels > 0.0) else {
            return Self { faces: Vec::new() };
        };
        // Surfaces that stand still have no raised copy if seams have lines of their own.
        let is_raised = !style.creases || surface.carrier.is_some();
        let corners: Vec<Option<Corner>> = mesh
            .points
            .iter()
            .zip(outward_of(&mesh))
            .map(|(&point, outward)| corner(point, outward, is_raised, style, camera, light))
            .collect();
        let faces = mesh
            .faces
            .iter()
            .filter_map(|face| Some([corners[face[0]]?, corners[face[1]]?, corners[face[2]]?]));
        Self {
            faces: faces
                .filter(|&[a, b, c]| turn(a.pixel, b.pixel, c.pixel) < 0.0)
                .collect(),
        }
    }

    /// All covered pixels; may repeat.
    pub fn covered(&self, width: usize, height: usize) -> impl Iterator<Item = Covered> {
        self.faces.iter().flat_map(move |face| covered_by(face, width, height))
    }
}

/// For each point the sum of the normals of all points at its position: a crease splits points but must not end a line.
fn outward_of(mesh: &Mesh) -> Vec<DVec3> {
    let mut sums = vec![DVec3::ZERO; mesh.points.len()];
    for (&place, normal) in mesh.places.iter().zip(&mesh.normals) {
        sums[place] += *normal;
    }
    mesh.places.iter().map(|&place| sums[place]).collect()
}

fn corner(
    point: DVec3,
    outward: DVec3,
    is_raised: bool,
    style: &Style,
    camera: &Camera,
    light: &Light,
) -> Option<Corner> {
    let center = camera.view_from_world.transform_point3(point);
    let depth = -center.z;
    if depth < camera.near {
        return None;
    }
    let aside = camera
        .view_from_world
        .transform_vector3(outward)
        .truncate()
        .normalize_or_zero();
    let towards_light = camera
        .view_from_world
        .transform_vector3(light.towards(point))
        .truncate();
    let width = style.ink_pixels * swelling(aside, towards_light, style.ink_swell);
    let widest = width.max(style.ink_pixels) * camera.metres_per_pixel(depth);
    let raise = if is_raised {
        (HULL_RAISED.0 * widest).min(HULL_RAISED.1)
    } else {
        0.0
    };
    let raised = depth - raise;
    Some(Corner {
        pixel: camera.pixel_of(center) + width * aside,
        depths: DVec2::new(camera.window_depth(depth), camera.window_depth(raised)),
    })
}

/// Twice the area of a triangle, negative if clockwise.
fn turn(a: DVec2, b: DVec2, c: DVec2) -> f64 {
    (b - a).perp_dot(c - a)
}

fn covered_by(&[a, b, c]: &[Corner; 3], width: usize, height: usize) -> impl Iterator<Item = Covered> + use<> {
    let lowest = a.pixel.min(b.pixel).min(c.pixel).max(DVec2::ZERO);
    let highest = a.pixel.max(b.pixel).max(c.pixel).max(DVec2::ZERO);
    let rows = lowest.y as usize..(highest.y as usize + 1).min(height);
    let columns = lowest.x as usize..(highest.x as usize + 1).min(width);
    let area = turn(a.pixel, b.pixel, c.pixel);
    rows.flat_map(move |y| columns.clone().map(move |x| (x, y)))
        .filter_map(move |(x, y)| {
            let middle = DVec2::new(x as f64 + 0.5, y as f64 + 0.5);
            let share = |from: Corner, to: Corner| turn(from.pixel, to.pixel, middle) / area;
            let weights = [share(b, c), share(c, a), share(a, b)];
            let depths = weights[0] * a.depths + weights[1] * b.depths + weights[2] * c.depths;
            let is_inside = weights.iter().all(|&weight| weight >= 0.0);
            is_inside.then_some(Covered {
                x,
                y,
                depth: depths.x,
                raised_depth: depths.y,
            })
        })
}
