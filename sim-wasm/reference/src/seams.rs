//! Intersections of the faces of two meshes, and faces that end on each other.

use glam::DVec3;

use crate::mesh::Mesh;

/// Distance (m) up to which a corner lies on a plane: contact counts as intersection.
const TOUCHING: f64 = 1e-5;

struct Face {
    corners: [DVec3; 3],
    normal: DVec3,
    lowest: DVec3,
    highest: DVec3,
}

/// Both ends of each seam.
pub fn seams(one: &Mesh, other: &Mesh) -> Vec<[DVec3; 2]> {
    let (faces, others) = (faces_of(one), faces_of(other));
    let near = |faces: Vec<Face>, all: [DVec3; 2]| {
        let mut near: Vec<Face> = faces.into_iter().filter(|face| face.is_near(all)).collect();
        near.sort_by(|a, b| a.lowest.x.total_cmp(&b.lowest.x));
        near
    };
    let (box_of_one, box_of_other) = (box_of(&faces), box_of(&others));
    let (faces, others) = (near(faces, box_of_other), near(others, box_of_one));
    let mut found = Vec::new();
    for face in &faces {
        let reached = others.partition_point(|other| other.lowest.x <= face.highest.x + TOUCHING);
        for other in &others[..reached] {
            if other.is_near([face.lowest, face.highest]) {
                found.extend(seam(face, other));
            }
        }
    }
    found
}

fn faces_of(mesh: &Mesh) -> Vec<Face> {
    let face = |&face: &[usize; 3]| {
        let (corners, normal) = (mesh.corners(face), mesh.face_normal(face)?);
        let [a, b, c] = corners;
        Some(Face {
            corners,
            normal,
            lowest: a.min(b).min(c),
            highest: a.max(b).max(c),
        })
    };
    mesh.faces.iter().filter_map(face).collect()
}

fn box_of(faces: &[Face]) -> [DVec3; 2] {
    [
        faces.iter().fold(DVec3::INFINITY, |low, face| low.min(face.lowest)),
        faces
            .iter()
            .fold(DVec3::NEG_INFINITY, |high, face| high.max(face.highest)),
    ]
}

/// The part of the intersection line of two planes that lies in both faces. None for coplanar faces.
fn seam(a: &Face, b: &Face) -> Option<[DVec3; 2]> {
    let along = a.normal.cross(b.normal);
    if along.length() < 1e-6 {
        return None;
    }
    let along = along.normalize();
    let (of_a, of_b) = (a.stretch_on(b, along)?, b.stretch_on(a, along)?);
    let place = |point: DVec3| point.dot(along);
    let start = if place(of_a[0]) > place(of_b[0]) {
        of_a[0]
    } else {
        of_b[0]
    };
    let end = if place(of_a[1]) < place(of_b[1]) {
        of_a[1]
    } else {
        of_b[1]
    };
    (place(end) > place(start) && start.distance(end) > TOUCHING).then_some([start, end])
}

impl Face {
    fn is_near(&self, [lowest, highest]: [DVec3; 2]) -> bool {
        self.lowest.cmple(highest + TOUCHING).all() && lowest.cmple(self.highest + TOUCHING).all()
    }

    /// First and last point of its border on the plane of another face.
    fn stretch_on(&self, plane: &Face, along: DVec3) -> Option<[DVec3; 2]> {
        let above = self.corners.map(|corner| plane.normal.dot(corner - plane.corners[0]));
        let mut points = Vec::new();
        for (corner, next) in [(0, 1), (1, 2), (2, 0)] {
            let [from, to] = [above[corner], above[next]];
            if from.abs() <= TOUCHING {
                points.push(self.corners[corner]);
            } else if to.abs() > TOUCHING && (from > 0.0) != (to > 0.0) {
                points.push(self.corners[corner].lerp(self.corners[next], from / (from - to)));
            }
        }
        points.sort_by(|a, b| a.dot(along).total_cmp(&b.dot(along)));
        (points.len() > 1).then(|| [points[0], points[points.len() - 1]])
    }
}
