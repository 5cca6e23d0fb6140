//! Triangle meshes and convex hulls as colliders. Parry's bounding volume hierarchy finds the nearest triangle.

use rapier3d::glamx::Vec3;
use rapier3d::parry::query::PointQueryWithLocation;
use rapier3d::parry::shape::TriMesh;

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

/// A convex polyhedron: the planes of its faces give the depth of inner points and exclude far points.
pub struct Hull {
    mesh: Mesh,
    faces: Vec<Face>,
}

struct Face {
    normal: Vector,
    offset: f32,
}

impl Hull {
    /// The solid of `mesh`, which must be closed, convex and oriented.
    pub fn new(mesh: TriMesh) -> Self {
        let mut faces: Vec<Face> = Vec::new();
        for triangle in mesh.triangles() {
            let normal = ours(triangle.scaled_normal()).unit_or(Vector::ZERO);
            let known = |face: &Face| face.normal.dot(normal) > 0.999_999;
            if normal != Vector::ZERO && !faces.iter().any(known) {
                faces.push(Face {
                    normal,
                    offset: normal.dot(ours(triangle.a)),
                });
            }
        }
        Self {
            mesh: Mesh::new(mesh, true),
            faces,
        }
    }

    fn highest_face(&self, point: Vector) -> (f32, &Face) {
        let height = |face: &Face| face.normal.dot(point) - face.offset;
        let mut best = &self.faces[0];
        let mut highest = height(best);
        for face in &self.faces[1..] {
            let above = height(face);
            if above > highest {
                (highest, best) = (above, face);
            }
        }
        (highest, best)
    }
}

impl Collider for Hull {
    fn nearest(&self, point: Vector, limit: f32) -> Nearest {
        let (height, face) = self.highest_face(point);
        if height <= 0.0 || height >= limit {
            return Nearest {
                distance: height,
                normal: face.normal,
            };
        }
        let foot = point - face.normal * height;
        if self.highest_face(foot).0 <= 1e-6 {
            return Nearest {
                distance: height,
                normal: face.normal,
            };
        }
        self.mesh.nearest(point, limit)
    }

    fn bounds(&self) -> Bounds {
        self.mesh.bounds
    }
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
