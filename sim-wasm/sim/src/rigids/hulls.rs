//! Convex hulls as colliders, with Rapier only: what smoke pushes has them.

use parry3d::glamx::Vec3;
use parry3d::shape::{ConvexPolyhedron, SharedShape, TriMesh};
use parry3d::transformation::try_convex_hull;

use crate::collide::shapes::{Collider, Nearest};
use crate::layout::error::ParameterError;
use crate::math::bounds::Bounds;
use crate::math::vector::Vector;
use crate::rigids::checks::{MIN_HALF_EXTENT, shape_error};
use crate::rigids::meshes::{Mesh, oriented, ours};

/// Minimum volume, as a share of the box's.
const MIN_FILL_RATIO: f32 = 1e-4;

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
        self.mesh.bounds()
    }
}

/// The hull of points, in Rapier's form and in ours.
///
/// # Errors
/// The points span no volume.
pub fn hull(vertices: &[[f32; 3]]) -> Result<(SharedShape, Hull), ParameterError> {
    let points: Vec<Vec3> = vertices.iter().map(|vertex| Vec3::from(*vertex)).collect();
    let error = || {
        let message = "rigid.vertices span no volume; give at least four points that do not lie in one plane";
        shape_error("rigid.vertices", vertices.len() as f64, message.to_owned())
    };
    // Checked before the hull is built: its algorithm may fail for points on a line or a plane.
    if !spans_volume(&points) {
        return Err(error());
    }
    let (corners, triangles) = try_convex_hull(&points).map_err(|_| error())?;
    let polyhedron = ConvexPolyhedron::from_convex_mesh(corners.clone(), &triangles).ok_or_else(error)?;
    let mesh = oriented(corners, triangles).ok_or_else(error)?;
    Ok((SharedShape::new(polyhedron), Hull::new(mesh)))
}

/// Returns true if four of the points form a tetrahedron that is not degenerate for its size.
fn spans_volume(points: &[Vec3]) -> bool {
    let origin = points[0];
    let farthest = |measure: &dyn Fn(Vec3) -> f32| {
        let offsets = points.iter().map(|point| *point - origin);
        offsets
            .max_by(|a, b| measure(*a).total_cmp(&measure(*b)))
            .expect("there is a point")
    };
    let a = farthest(&|offset| offset.length());
    let length = a.length();
    let b = farthest(&|offset| a.cross(offset).length());
    let c = farthest(&|offset| a.cross(b).dot(offset).abs());
    let (area, volume) = (a.cross(b).length(), a.cross(b).dot(c).abs());
    length > MIN_HALF_EXTENT && area > MIN_FILL_RATIO * length * length && volume > MIN_FILL_RATIO * area * length
}
