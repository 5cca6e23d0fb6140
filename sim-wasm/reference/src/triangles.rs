//! Intersection of lines and triangles.

use glam::DVec3;

use crate::mesh::Mesh;

/// Maximum number of triangles in a leaf.
const FEW: usize = 4;

/// Intersection of a line with a surface.
#[derive(Clone, Copy)]
pub struct Crossing {
    /// In lengths of the line's direction.
    pub at: f64,
    /// Outward normal of the face, and normal for shading.
    pub face: DVec3,
    pub normal: DVec3,
}

struct Triangle {
    corners: [DVec3; 3],
    normals: [DVec3; 3],
}

/// Triangles in a box, split in two halves if there are many.
pub struct Triangles {
    lowest: DVec3,
    highest: DVec3,
    own: Vec<Triangle>,
    halves: Vec<Triangles>,
}

impl Triangles {
    pub fn new(mesh: &Mesh) -> Self {
        let triangle = |&face: &[usize; 3]| Triangle {
            corners: mesh.corners(face),
            normals: face.map(|corner| mesh.normals[corner]),
        };
        Self::halved(mesh.faces.iter().map(triangle).collect())
    }

    fn halved(mut own: Vec<Triangle>) -> Self {
        let corners = || own.iter().flat_map(|triangle| triangle.corners);
        let lowest = corners().fold(DVec3::INFINITY, DVec3::min);
        let highest = corners().fold(DVec3::NEG_INFINITY, DVec3::max);
        let mut halves = Vec::new();
        if own.len() > FEW {
            let axis = (highest - lowest).max_position();
            own.sort_by(|a, b| a.middle(axis).total_cmp(&b.middle(axis)));
            let second = own.split_off(own.len() / 2);
            halves = vec![Self::halved(std::mem::take(&mut own)), Self::halved(second)];
        }
        Self {
            lowest,
            highest,
            own,
            halves,
        }
    }

    /// Calls back for each intersection of the line `origin + t direction`, for all t.
    pub fn cross(&self, origin: DVec3, direction: DVec3, found: &mut impl FnMut(Crossing)) {
        if !self.is_near(origin, direction) {
            return;
        }
        self.own
            .iter()
            .filter_map(|triangle| triangle.cross(origin, direction))
            .for_each(&mut *found);
        self.halves.iter().for_each(|half| half.cross(origin, direction, found));
    }

    /// Returns true if the line intersects the box.
    fn is_near(&self, origin: DVec3, direction: DVec3) -> bool {
        let (a, b) = ((self.lowest - origin) / direction, (self.highest - origin) / direction);
        a.min(b).max_element() <= a.max(b).min_element() + 1e-9
    }
}

impl Triangle {
    fn middle(&self, axis: usize) -> f64 {
        self.corners.iter().map(|corner| corner[axis]).sum()
    }

    fn cross(&self, origin: DVec3, direction: DVec3) -> Option<Crossing> {
        let [a, b, c] = self.corners;
        let face = (b - a).cross(c - a);
        let slant = face.dot(direction);
        if slant == 0.0 {
            return None;
        }
        let at = face.dot(a - origin) / slant;
        let point = origin + at * direction;
        let share = |from: DVec3, to: DVec3| (to - from).cross(point - from).dot(face) / face.length_squared();
        let weights = [share(b, c), share(c, a), share(a, b)];
        if weights.iter().any(|&weight| weight < 0.0) {
            return None;
        }
        let normal: DVec3 = (0..3).map(|i| weights[i] * self.normals[i]).sum();
        Some(Crossing {
            at,
            face: face.normalize(),
            normal: normal.normalize(),
        })
    }
}
