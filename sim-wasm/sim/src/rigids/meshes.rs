//! Triangle meshes as colliders. Parry's bounding volume hierarchy finds the nearest triangle.

use parry3d::glamx::Vec3;
use parry3d::query::PointQueryWithLocation;
use parry3d::shape::{TriMesh, TriMeshFlags};

use crate::collide::shapes::{Collider, Nearest};
use crate::math::bounds::Bounds;
use crate::math::vector::Vector;

/// A triangle mesh: a solid if it is closed, else a two-sided sheet.
pub struct Mesh {
    mesh: TriMesh,
    bounds: Bounds,
    /// Upper bound of the depth of inner points (m); 0 for a sheet.
    depth: f32,
}

impl Mesh {
    /// Creates a solid from a closed, oriented mesh, or a sheet.
    pub fn new(mesh: TriMesh, solid: bool) -> Self {
        let aabb = mesh.local_aabb();
        let bounds = Bounds {
            min: ours(aabb.mins),
            max: ours(aabb.maxs),
        };
        let half = (bounds.max - bounds.min) * 0.5;
        let depth = if solid { half.x.min(half.y).min(half.z) } else { 0.0 };
        Self { mesh, bounds, depth }
    }

    fn triangle_normal(&self, triangle: u32) -> Vector {
        ours(self.mesh.triangle(triangle).scaled_normal()).unit_or(Vector::Y)
    }
}

impl Collider for Mesh {
    fn nearest(&self, point: Vector, limit: f32) -> Nearest {
        let outside = distance_to_box(&self.bounds, point);
        if outside >= limit {
            return Nearest {
                distance: outside,
                normal: Vector::Y,
            };
        }
        // An inner point may be farther from the surface than `limit`, and must be found.
        let limit = if outside > 0.0 {
            limit
        } else {
            limit.max(self.depth * 1.01)
        };
        let found = self
            .mesh
            .project_local_point_and_get_location_with_max_dist(parrys(point), false, limit);
        let Some((projection, (triangle, _))) = found else {
            return Nearest {
                distance: limit,
                normal: Vector::Y,
            };
        };
        let offset = point - ours(projection.point);
        let length = offset.length();
        let side = if self.depth > 0.0 && projection.is_inside {
            -1.0
        } else {
            1.0
        };
        let normal = if length > 1e-6 {
            offset * (side / length)
        } else {
            self.triangle_normal(triangle)
        };
        Nearest {
            distance: side * length,
            normal,
        }
    }

    fn bounds(&self) -> Bounds {
        self.bounds
    }
}

/// A closed mesh whose inside parry finds.
pub fn oriented(corners: Vec<Vec3>, triangles: Vec<[u32; 3]>) -> Option<TriMesh> {
    TriMesh::with_flags(corners, triangles, TriMeshFlags::ORIENTED).ok()
}

/// Distance (m) from a point to a box; 0 inside.
pub fn distance_to_box(bounds: &Bounds, point: Vector) -> f32 {
    (bounds.min - point)
        .greatest(point - bounds.max)
        .greatest(Vector::ZERO)
        .length()
}

/// Converts to Parry's vector.
pub fn parrys(vector: Vector) -> Vec3 {
    Vec3::new(vector.x, vector.y, vector.z)
}

/// Converts from Parry's vector.
pub fn ours(vector: Vec3) -> Vector {
    Vector::new(vector.x, vector.y, vector.z)
}
