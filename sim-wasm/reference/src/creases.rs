//! Lines along sharp edges of surfaces and along seams: ribbons of constant width slightly in front.

use std::collections::HashMap;

use glam::{DVec2, DVec3};

use crate::mesh::Mesh;
use crate::ray::Camera;
use crate::scene::{Scene, Surface};
use crate::seams::seams;

/// Minimum angle (degrees) between the faces of an edge with a line.
const SHARP_ANGLE: f64 = 40.0;

/// Distance in front of the surface, in line widths, and its maximum (m). Seams lie in hollows.
const CREASE_RAISED: (f64, f64) = (0.75, 0.03);
const SEAM_RAISED: (f64, f64) = (3.0, 0.05);

/// A line in world space.
struct Edge {
    ends: [DVec3; 2],
    /// Normals of the faces at an edge; none at a seam.
    normals: Vec<DVec3>,
    raised: (f64, f64),
}

/// A line in the picture: its ends (pixels) with their window depths.
pub struct Ribbon {
    from: DVec2,
    along: DVec2,
    length: f64,
    half_width: f64,
    depths: [f64; 2],
}

/// All lines of a surface.
pub fn ribbons_of(index: usize, scene: &Scene, camera: &Camera) -> Vec<Ribbon> {
    let surface = &scene.surfaces[index];
    let style = &scene.style;
    if !style.creases || style.ink_pixels <= 0.0 || !surface.inked {
        return Vec::new();
    }
    let Some(mesh) = Mesh::of(&surface.shape) else {
        return Vec::new();
    };
    let meets = |other: &&Surface| other.inked && other.carrier == surface.carrier && other.group != surface.group;
    let of_seams = scene.surfaces[index + 1..]
        .iter()
        .filter(meets)
        .filter_map(|other| Mesh::of(&other.shape))
        .flat_map(|other| seams(&mesh, &other))
        .map(|ends| Edge {
            ends,
            normals: Vec::new(),
            raised: SEAM_RAISED,
        });
    sharp_edges(&mesh)
        .into_iter()
        .chain(of_seams)
        .filter_map(|edge| ribbon(&edge, style.ink_pixels, camera))
        .collect()
}

/// Edges of a single face, and edges between faces at a sharp angle that do not share shading normals.
fn sharp_edges(mesh: &Mesh) -> Vec<Edge> {
    let mut edges: HashMap<[usize; 2], Vec<([usize; 2], DVec3)>> = HashMap::new();
    for &face in &mesh.faces {
        let Some(normal) = mesh.face_normal(face) else {
            continue;
        };
        for side in 0..3 {
            let mut ends = [face[side], face[(side + 1) % 3]];
            ends.sort_unstable();
            let mut places = ends.map(|corner| mesh.places[corner]);
            places.sort_unstable();
            edges.entry(places).or_default().push((ends, normal));
        }
    }
    let is_sharp = |faces: &[([usize; 2], DVec3)]| match faces {
        [_] => true,
        [(one, a), (other, b), ..] => one != other && a.dot(*b) < SHARP_ANGLE.to_radians().cos(),
        [] => false,
    };
    let edge = |faces: Vec<([usize; 2], DVec3)>| Edge {
        ends: faces[0].0.map(|corner| mesh.points[corner]),
        normals: faces.iter().map(|&(_, normal)| normal).collect(),
        raised: CREASE_RAISED,
    };
    edges.into_values().filter(|faces| is_sharp(faces)).map(edge).collect()
}

/// None for edges of the silhouette, with a face that points away, and behind the eye.
fn ribbon(edge: &Edge, width: f64, camera: &Camera) -> Option<Ribbon> {
    let [from, to] = edge.ends.map(|end| camera.view_from_world.transform_point3(end));
    let towards_eye = if camera.is_perspective() { -from } else { DVec3::Z };
    let looks_away = |&normal: &DVec3| camera.view_from_world.transform_vector3(normal).dot(towards_eye) < 0.0;
    if (-from.z).max(-to.z) < camera.near || edge.normals.iter().any(looks_away) {
        return None;
    }
    let [from, to] = [before(from, to, camera.near), before(to, from, camera.near)];
    let [start, end] = [from, to].map(|point| camera.pixel_of(point));
    let depth_of = |point: DVec3| {
        let (widths, most) = edge.raised;
        let raise = (widths * width * camera.metres_per_pixel(-point.z)).min(most);
        camera.window_depth((-point.z - raise).max(camera.near))
    };
    Some(Ribbon {
        from: start,
        along: (end - start).try_normalize().unwrap_or(DVec2::X),
        length: start.distance(end),
        half_width: 0.5 * width,
        depths: [from, to].map(depth_of),
    })
}

/// The end, or the intersection with the near plane.
fn before(end: DVec3, other: DVec3, near: f64) -> DVec3 {
    if -end.z >= near {
        end
    } else {
        end.lerp(other, (near + end.z) / (end.z - other.z))
    }
}

impl Ribbon {
    /// Covered pixels with their window depths. The line extends by half its width beyond both ends, so that no gap
    /// shows between lines.
    pub fn covered(&self, width: usize, height: usize) -> impl Iterator<Item = ([usize; 2], f64)> {
        let beyond = self.half_width * self.along;
        let (a, b) = (self.from - beyond, self.from + self.length * self.along + beyond);
        let reach = DVec2::splat(self.half_width);
        let lowest = (a.min(b) - reach).max(DVec2::ZERO);
        let highest = (a.max(b) + reach).max(DVec2::ZERO);
        let rows = lowest.y as usize..(highest.y as usize + 1).min(height);
        let columns = lowest.x as usize..(highest.x as usize + 1).min(width);
        rows.flat_map(move |y| columns.clone().map(move |x| [x, y]))
            .filter_map(|[x, y]| Some(([x, y], self.depth_at(DVec2::new(x as f64 + 0.5, y as f64 + 0.5))?)))
    }

    fn depth_at(&self, point: DVec2) -> Option<f64> {
        let offset = point - self.from;
        let (along, aside) = (offset.dot(self.along), offset.perp_dot(self.along));
        let is_inside =
            aside.abs() <= self.half_width && -self.half_width <= along && along <= self.length + self.half_width;
        let share = (along + self.half_width) / (self.length + 2.0 * self.half_width);
        is_inside.then(|| self.depths[0] + share * (self.depths[1] - self.depths[0]))
    }
}
