//! The triangles of a surface in world space, and corners at equal positions.

use std::collections::HashMap;

use glam::{DMat3, DMat4, DVec3};

use crate::scene::Shape;

/// Corners are at the same position if they agree to a hundredth of a millimetre.
const PLACES_PER_METRE: f64 = 1e5;

pub struct Mesh {
    /// World-space positions with their shading normals.
    pub points: Vec<DVec3>,
    pub normals: Vec<DVec3>,
    /// Three corners each, counter-clockwise from outside.
    pub faces: Vec<[usize; 3]>,
    /// Position index of each corner: a corner with several normals occurs several times at one position.
    pub places: Vec<usize>,
}

impl Mesh {
    /// None for a shape that is not a mesh.
    pub fn of(shape: &Shape) -> Option<Self> {
        let Shape::Triangles {
            positions,
            normals,
            indices,
            world_from_model,
        } = shape
        else {
            return None;
        };
        let world = world_from_model
            .as_ref()
            .map_or(DMat4::IDENTITY, DMat4::from_cols_array);
        let turn = DMat3::from_mat4(world);
        let mut numbers = HashMap::new();
        let mut place_of = |place: [i64; 3]| {
            let next = numbers.len();
            *numbers.entry(place).or_insert(next)
        };
        let triples = |values: &[f64]| values.chunks_exact(3).map(DVec3::from_slice).collect::<Vec<_>>();
        let own = triples(positions);
        Some(Self {
            places: own
                .iter()
                .map(|&point| place_of((PLACES_PER_METRE * point).to_array().map(|value| value.round() as i64)))
                .collect(),
            points: own.iter().map(|&point| world.transform_point3(point)).collect(),
            normals: triples(normals).iter().map(|&normal| turn * normal).collect(),
            faces: indices
                .chunks_exact(3)
                .map(|face| [face[0], face[1], face[2]])
                .collect(),
        })
    }

    pub fn corners(&self, face: [usize; 3]) -> [DVec3; 3] {
        face.map(|corner| self.points[corner])
    }

    /// Unit normal of a face; none without an area.
    pub fn face_normal(&self, face: [usize; 3]) -> Option<DVec3> {
        let [a, b, c] = self.corners(face);
        let twice = (b - a).cross(c - a);
        (twice.length() > 1e-12).then(|| twice.normalize())
    }
}
