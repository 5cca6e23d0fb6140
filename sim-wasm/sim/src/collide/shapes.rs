//! The interface of colliders, and shapes in closed form.
//!
//! Signed distances: negative inside. Closed forms after Quilez, 'Distance functions'.

use crate::collide::core::Core;
use crate::math::bounds::Bounds;
use crate::math::scalar::clamped;
use crate::math::vector::Vector;

/// The nearest point of a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Nearest {
    /// Distance to the surface (m), negative inside a solid.
    pub distance: f32,
    /// Unit gradient of the distance.
    pub normal: Vector,
}

/// A shape in its own space. For its motion see [`crate::math::pose_motion::PoseMotion`].
pub trait Collider {
    /// The surface nearest to `point`. If it is farther than `limit`, the result may be any distance from `limit` up to
    /// the true one, and any normal.
    fn nearest(&self, point: Vector, limit: f32) -> Nearest;

    /// The bounding box.
    fn bounds(&self) -> Bounds;

    /// A bounding solid, as tight as possible.
    fn core(&self) -> Core {
        Core::of(&self.bounds())
    }

    /// Returns true if rotation about the origin does not change the shape.
    fn is_round(&self) -> bool {
        false
    }
}

/// The half space below y = 0.
#[derive(Clone, Copy, Debug)]
pub struct HalfSpace;

impl Collider for HalfSpace {
    fn nearest(&self, point: Vector, _limit: f32) -> Nearest {
        Nearest {
            distance: point.y,
            normal: Vector::Y,
        }
    }

    fn bounds(&self) -> Bounds {
        let far = f32::INFINITY;
        Bounds {
            min: Vector::new(-far, -far, -far),
            max: Vector::new(far, 0.0, far),
        }
    }
}

/// A ball about the origin.
#[derive(Clone, Copy, Debug)]
pub struct Ball {
    pub radius: f32,
}

impl Collider for Ball {
    fn nearest(&self, point: Vector, _limit: f32) -> Nearest {
        Nearest {
            distance: point.length() - self.radius,
            normal: point.unit_or(Vector::Y),
        }
    }

    fn bounds(&self) -> Bounds {
        Bounds::of_way(Vector::ZERO, Vector::ZERO, self.radius)
    }

    fn core(&self) -> Core {
        Core::around(Vector::ZERO, self.radius)
    }

    fn is_round(&self) -> bool {
        true
    }
}

/// A box about the origin.
#[derive(Clone, Copy, Debug)]
pub struct Cuboid {
    pub half_extents: Vector,
}

impl Collider for Cuboid {
    fn nearest(&self, point: Vector, _limit: f32) -> Nearest {
        let over = point.abs() - self.half_extents;
        let outside = over.greatest(Vector::ZERO);
        let distance = outside.length();
        if distance > 0.0 {
            return Nearest {
                distance,
                normal: with_signs(outside * (1.0 / distance), point),
            };
        }
        let (depth, axis) = nearest_face(over);
        Nearest {
            distance: depth,
            normal: with_signs(axis, point),
        }
    }

    fn bounds(&self) -> Bounds {
        Bounds {
            min: -self.half_extents,
            max: self.half_extents,
        }
    }
}

fn nearest_face(over: Vector) -> (f32, Vector) {
    if over.x >= over.y && over.x >= over.z {
        (over.x, Vector::new(1.0, 0.0, 0.0))
    } else if over.y >= over.z {
        (over.y, Vector::Y)
    } else {
        (over.z, Vector::new(0.0, 0.0, 1.0))
    }
}

fn with_signs(lengths: Vector, signs: Vector) -> Vector {
    Vector::new(
        lengths.x.copysign(signs.x),
        lengths.y.copysign(signs.y),
        lengths.z.copysign(signs.z),
    )
}

/// A capsule along y.
#[derive(Clone, Copy, Debug)]
pub struct Capsule {
    pub half_height: f32,
    pub radius: f32,
}

impl Collider for Capsule {
    fn nearest(&self, point: Vector, _limit: f32) -> Nearest {
        let on_axis = clamped(point.y, -self.half_height, self.half_height);
        let offset = Vector::new(point.x, point.y - on_axis, point.z);
        Nearest {
            distance: offset.length() - self.radius,
            normal: offset.unit_or(Vector::new(1.0, 0.0, 0.0)),
        }
    }

    fn bounds(&self) -> Bounds {
        let tip = Vector::Y * self.half_height;
        Bounds::of_way(-tip, tip, self.radius)
    }

    fn core(&self) -> Core {
        Core::around(Vector::Y * self.half_height, self.radius)
    }
}

/// A cylinder along y.
#[derive(Clone, Copy, Debug)]
pub struct Cylinder {
    pub half_height: f32,
    pub radius: f32,
}

impl Collider for Cylinder {
    fn nearest(&self, point: Vector, _limit: f32) -> Nearest {
        let from_axis = Vector::new(point.x, 0.0, point.z);
        let radial = from_axis.unit_or(Vector::new(1.0, 0.0, 0.0));
        let axial = Vector::new(0.0, 1.0_f32.copysign(point.y), 0.0);
        let over_side = from_axis.length() - self.radius;
        let over_cap = point.y.abs() - self.half_height;
        if over_side > 0.0 && over_cap > 0.0 {
            let distance = (over_side * over_side + over_cap * over_cap).sqrt();
            let normal = (radial * over_side + axial * over_cap) * (1.0 / distance);
            return Nearest { distance, normal };
        }
        if over_side >= over_cap {
            Nearest {
                distance: over_side,
                normal: radial,
            }
        } else {
            Nearest {
                distance: over_cap,
                normal: axial,
            }
        }
    }

    fn bounds(&self) -> Bounds {
        let half = Vector::new(self.radius, self.half_height, self.radius);
        Bounds { min: -half, max: half }
    }

    fn core(&self) -> Core {
        Core::upright(self.half_height, self.radius)
    }
}
