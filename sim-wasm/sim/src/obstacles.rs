//! From the parameters `colliders.#.*` to analytic colliders.

use crate::collide::{AnalyticCollider, ColliderShape};
use crate::forces::unit;
use crate::parameters::{Collider, LIST_LIMIT, Parameters};

/// The colliders that the parameters describe; only as many as the list is long are meant.
pub fn colliders(parameters: &Parameters) -> [AnalyticCollider; LIST_LIMIT] {
    let items = parameters.colliders.items();
    std::array::from_fn(|i| collider(items.get(i).unwrap_or(&Collider::default())))
}

fn collider(parameters: &Collider) -> AnalyticCollider {
    AnalyticCollider {
        shape: shape(parameters.shape),
        position: parameters.position.map(|component| component as f32),
        axis: unit(parameters.axis),
        half_extents: parameters.half_extents.map(|component| component as f32),
        radius: parameters.radius as f32,
        restitution: parameters.restitution as f32,
        friction: parameters.friction as f32,
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
