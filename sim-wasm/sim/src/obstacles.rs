//! From the parameters `colliders.#.*` to analytic colliders.

use crate::collide::contact::Action;
use crate::collide::{AnalyticCollider, ColliderShape};
use crate::forces::unit;
use crate::parameters::field::{DIRECTION, Field, LENGTH, PLACE, SHARE, number, vector};
use crate::parameters::section::{Item, item};
use crate::parameters::{LIST_LIMIT, Parameters};

/// `colliders.#.*`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ColliderParameters {
    pub shape: f64,
    pub position: [f64; 3],
    pub axis: [f64; 3],
    pub half_extents: [f64; 3],
    pub radius: f64,
    pub restitution: f64,
    pub friction: f64,
    pub roughness: f64,
    pub action: f64,
    pub tint: f64,
}

impl Item for ColliderParameters {
    const LABEL: &'static str = "Obstacle";
    const FIELDS: &'static [Field<Self>] = &[
        number("shape", "1", [0.0, 3.0], 0.0, |c: &mut Self| &mut c.shape)
            .named(&["plane", "ball", "box", "capsule"])
            .says("Shape", "What smoke bumps into."),
        vector("position", "m", PLACE, [0.0; 3], |c: &mut Self| &mut c.position)
            .says("Place", "Its centre, or a point on the plane."),
        vector("axis", "1", DIRECTION, [0.0, 1.0, 0.0], |c: &mut Self| &mut c.axis)
            .says("Axis", "Where the plane faces, or the way up of a box or capsule."),
        vector("halfExtents", "m", LENGTH, [0.5; 3], |c: &mut Self| &mut c.half_extents).says(
            "Half sides",
            "Half sides of a box; of a capsule y is half its straight part.",
        ),
        number("radius", "m", LENGTH, 0.5, |c: &mut Self| &mut c.radius).says("Radius", "Radius of a ball or capsule."),
        number("restitution", "1", SHARE, 0.1, |c: &mut Self| &mut c.restitution)
            .says("Bounce", "Share of the speed with which smoke comes back."),
        number("friction", "1", SHARE, 0.2, |c: &mut Self| &mut c.friction)
            .says("Friction", "Share of the speed along it that smoke loses."),
        number("roughness", "1", SHARE, 0.0, |c: &mut Self| &mut c.roughness).says(
            "Roughness",
            "How unevenly smoke lies along it: of the size that a puff has lost, the share by which it keeps off at most.",
        ),
        number("action", "1", [0.0, 2.0], 0.0, |c: &mut Self| &mut c.action)
            .named(&["bounce", "kill", "tint"])
            .says("Touch", "What becomes of smoke that touches it."),
        number("tint", "1", [1.0, 15.0], 1.0, |c: &mut Self| &mut c.tint)
            .whole()
            .says("Tint", "The tint that it gives, where touching tints."),
    ];
}

/// The colliders that the parameters describe; only as many as the list is long are meant.
pub fn colliders(parameters: &Parameters) -> [AnalyticCollider; LIST_LIMIT] {
    let items = parameters.colliders.items();
    std::array::from_fn(|i| collider(items.get(i).unwrap_or(&item())))
}

fn collider(parameters: &ColliderParameters) -> AnalyticCollider {
    AnalyticCollider {
        shape: shape(parameters.shape),
        position: parameters.position.map(|component| component as f32),
        axis: unit(parameters.axis),
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
