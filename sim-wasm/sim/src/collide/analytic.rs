//! Obstacles in closed form: the parameters `colliders.#.*`, which are static, and those of the pool.

use crate::collide::contact::{Action, Material, Obstacle};
use crate::collide::core::Core;
use crate::collide::shapes::{Ball, Capsule, Collider, Cuboid, HalfSpace, Nearest};
use crate::layout::limits::STEP;
use crate::layout::parameters::collider::ColliderParameters;
use crate::layout::parameters::table::Parameters;
use crate::math::bounds::Bounds;
use crate::math::double::direction;
use crate::math::pose::Pose;
use crate::math::pose_motion::PoseMotion;
use crate::math::scalar::greater;
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

/// An obstacle in closed form.
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

/// The shape of an obstacle in its own space.
#[derive(Clone, Copy, Debug)]
pub enum AnalyticShape {
    HalfSpace(HalfSpace),
    Ball(Ball),
    Cuboid(Cuboid),
    Capsule(Capsule),
}

impl AnalyticCollider {
    /// Creates the static obstacle that particles collide with.
    pub fn obstacle(&self) -> Obstacle<AnalyticShape> {
        let pose = Pose::along(Vector::from(self.position), Vector::from(self.axis));
        self.moving(pose, pose)
    }

    /// Creates the obstacle that moves from pose to pose in a step, regardless of its own position and axis.
    #[inline(never)]
    pub(super) fn moving(&self, start: Pose, end: Pose) -> Obstacle<AnalyticShape> {
        let shape = self.own_shape();
        let motion = PoseMotion::between(start, end, STEP as f32, shape.is_round());
        let bounds = match shape {
            AnalyticShape::HalfSpace(_) => half_space_bounds(&start, &end),
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

    pub(super) fn own_shape(&self) -> AnalyticShape {
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
fn half_space_bounds(start: &Pose, end: &Pose) -> Bounds {
    let mut bounds = Bounds::EVERYTHING;
    if [start, end]
        .iter()
        .all(|Pose { rotation, .. }| rotation[0] == 0.0 && rotation[2] == 0.0)
    {
        bounds.max.y = greater(start.position.y, end.position.y);
    }
    bounds
}

impl AnalyticShape {
    /// Half extents of a box, and the radius about it that bounds the shape. A half space is unbounded.
    fn rounded_box(&self) -> (Vector, f32) {
        match self {
            AnalyticShape::HalfSpace(_) => (Bounds::EVERYTHING.max, 0.0),
            AnalyticShape::Ball(Ball { radius }) => (Vector::ZERO, *radius),
            AnalyticShape::Cuboid(Cuboid { half_extents }) => (*half_extents, 0.0),
            AnalyticShape::Capsule(Capsule { half_height, radius }) => (Vector::Y * *half_height, *radius),
        }
    }
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
        let (half, radius) = self.rounded_box();
        Bounds::of_way(-half, half, radius)
    }

    fn core(&self) -> Core {
        let (half, radius) = self.rounded_box();
        Core::around(half, radius)
    }

    fn is_round(&self) -> bool {
        matches!(self, AnalyticShape::Ball(_))
    }
}

/// The static obstacles that `parameters` describe.
pub(crate) fn obstacles(parameters: &Parameters) -> impl Iterator<Item = Obstacle<AnalyticShape>> {
    let items = parameters.colliders.items().iter();
    items.map(|item| collider(item).obstacle())
}

fn collider(parameters: &ColliderParameters) -> AnalyticCollider {
    AnalyticCollider {
        shape: shape(parameters.shape as u32),
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

/// The shape of a number, as in `colliders.#.shape`.
pub(super) fn shape(number: u32) -> ColliderShape {
    match number {
        0 => ColliderShape::Plane,
        1 => ColliderShape::Ball,
        2 => ColliderShape::Box,
        _ => ColliderShape::Capsule,
    }
}
