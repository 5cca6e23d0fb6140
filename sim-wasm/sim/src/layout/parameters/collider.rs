//! Parameters of `colliders.#`.

use crate::layout::parameters::field::{DIRECTION, Field, LENGTH, PLACE, SHARE, number, vector};
use crate::layout::parameters::item::Item;

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
