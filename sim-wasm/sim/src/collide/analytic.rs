//! Static obstacles in closed form: the parameters `colliders.#.*`.

use crate::collide::contact::{Action, Material, Obstacle};
use crate::collide::core::Core;
use crate::collide::shapes::{Ball, Capsule, Collider, Cuboid, HalfSpace, Nearest};
use crate::layout::parameters::collider::ColliderParameters;
use crate::layout::parameters::item::{LIST_LIMIT, item};
use crate::layout::parameters::table::Parameters;
use crate::math::bounds::Bounds;
use crate::math::double::direction;
use crate::math::pose::Pose;
use crate::math::pose_motion::PoseMotion;
use crate::math::vector::Vector;

/// Shape of an [`AnalyticCollider`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ColliderShape {
    /// The half space below `position`, with the outward normal `axis`.
    Plane,
    /// A ball of `radius`.
    Ball,
    /// A box of `half_extents`, with its y axis along `axis`.
    Box,
    /// A capsule of `radius` along `axis`, with a straight part of `half_extents[1]` to both sides of `position`.
    Capsule,
}

/// A static obstacle in closed form: the parameters `colliders.#.*`.
#[derive(Clone, Copy, Debug)]
pub struct AnalyticCollider {
    pub shape: ColliderShape,
    /// Centre, or a point on the plane (m).
    pub position: [f32; 3],
    /// Unit vector: normal of the plane, y axis of a capsule or box.
    pub axis: [f32; 3],
    /// Half extents of a box (m); a capsule uses the second.
    pub half_extents: [f32; 3],
    /// Radius of a ball or capsule (m).
    pub radius: f32,
    /// Share of the normal velocity that is reflected, 0..1.
    pub restitution: f32,
    /// Share of the tangential velocity that is lost, 0..1.
    pub friction: f32,
    /// Roughness, 0..1: the maximum distance that particles keep, as a share of the radius they have lost.
    pub roughness: f32,
    pub action: Action,
}

/// The shape of a static obstacle in its own space.
#[derive(Clone, Copy, Debug)]
pub enum AnalyticShape {
    HalfSpace(HalfSpace),
    Ball(Ball),
    Cuboid(Cuboid),
    Capsule(Capsule),
}

impl AnalyticCollider {
    /// Creates the obstacle that particles collide with.
    pub fn obstacle(&self) -> Obstacle<AnalyticShape> {
        let shape = self.own_shape();
        let pose = Pose::along(Vector::from(self.position), Vector::from(self.axis));
        let motion = PoseMotion::resting(pose);
        let bounds = match shape {
            AnalyticShape::HalfSpace(_) => half_space_bounds(pose.position, Vector::from(self.axis)),
            _ => motion.bounds_of(&shape.bounds()),
        };
        let material = Material {
            restitution: self.restitution,
            friction: self.friction,
            roughness: self.roughness,
            action: self.action,
        };
        Obstacle {
            shape,
            motion,
            material,
            bounds,
            core: shape.core(),
        }
    }

    fn own_shape(&self) -> AnalyticShape {
        let radius = self.radius;
        let half_extents = Vector::from(self.half_extents);
        match self.shape {
            ColliderShape::Plane => AnalyticShape::HalfSpace(HalfSpace),
            ColliderShape::Ball => AnalyticShape::Ball(Ball { radius }),
            ColliderShape::Box => AnalyticShape::Cuboid(Cuboid { half_extents }),
            ColliderShape::Capsule => AnalyticShape::Capsule(Capsule {
                half_height: half_extents.y,
                radius,
            }),
        }
    }
}

/// A level half space is bounded by its height, which skips the particles above; a tilted one has no box.
fn half_space_bounds(position: Vector, normal: Vector) -> Bounds {
    let mut bounds = Bounds::EVERYTHING;
    if normal == Vector::Y {
        bounds.max.y = position.y;
    }
    bounds
}

impl Collider for AnalyticShape {
    fn nearest(&self, point: Vector, limit: f32) -> Nearest {
        match self {
            AnalyticShape::HalfSpace(shape) => shape.nearest(point, limit),
            AnalyticShape::Ball(shape) => shape.nearest(point, limit),
            AnalyticShape::Cuboid(shape) => shape.nearest(point, limit),
            AnalyticShape::Capsule(shape) => shape.nearest(point, limit),
        }
    }

    fn bounds(&self) -> Bounds {
        match self {
            AnalyticShape::HalfSpace(shape) => shape.bounds(),
            AnalyticShape::Ball(shape) => shape.bounds(),
            AnalyticShape::Cuboid(shape) => shape.bounds(),
            AnalyticShape::Capsule(shape) => shape.bounds(),
        }
    }

    fn core(&self) -> Core {
        match self {
            AnalyticShape::HalfSpace(shape) => shape.core(),
            AnalyticShape::Ball(shape) => shape.core(),
            AnalyticShape::Cuboid(shape) => shape.core(),
            AnalyticShape::Capsule(shape) => shape.core(),
        }
    }
}

/// The colliders that `parameters` describe. Only the items of the list are valid.
pub fn colliders(parameters: &Parameters) -> [AnalyticCollider; LIST_LIMIT] {
    let items = parameters.colliders.items();
    std::array::from_fn(|i| collider(items.get(i).unwrap_or(&item())))
}

fn collider(parameters: &ColliderParameters) -> AnalyticCollider {
    AnalyticCollider {
        shape: shape(parameters.shape),
        position: parameters.position.map(|component| component as f32),
        axis: direction(parameters.axis),
        half_extents: parameters.half_extents.map(|component| component as f32),
        radius: parameters.radius as f32,
        restitution: parameters.restitution as f32,
        friction: parameters.friction as f32,
        roughness: parameters.roughness as f32,
        action: Action::from_numbers(parameters.action as u8, parameters.tint as u8),
    }
}

fn shape(parameter: f64) -> ColliderShape {
    match parameter as u32 {
        0 => ColliderShape::Plane,
        1 => ColliderShape::Ball,
        2 => ColliderShape::Box,
        _ => ColliderShape::Capsule,
    }
}
