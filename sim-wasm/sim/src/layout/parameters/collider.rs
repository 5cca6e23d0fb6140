//! Parameters of `colliders.#`.

use std::mem::offset_of;

use bytemuck::{Pod, Zeroable};

use crate::layout::parameters::field::{DIRECTION, Field, LENGTH, PLACE, SHARE, number, vector};
use crate::layout::parameters::item::Item;

/// `colliders.#.*`.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
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
    const FIELDS: &'static [Field] = &[
        number("shape", "1", [0.0, 3.0], 0.0, offset_of!(Self, shape))
            .named(&["plane", "ball", "box", "capsule"])
            .says("Shape", "Shape that smoke collides with."),
        vector("position", "m", PLACE, [0.0; 3], offset_of!(Self, position))
            .says("Position", "Centre, or a point on the plane."),
        vector("axis", "1", DIRECTION, [0.0, 1.0, 0.0], offset_of!(Self, axis))
            .says("Axis", "Normal of the plane, or the up axis of a box or capsule."),
        vector("halfExtents", "m", LENGTH, [0.5; 3], offset_of!(Self, half_extents)).says(
            "Half sides",
            "Half sides of a box. For a capsule, y is half the length of its straight part.",
        ),
        number("radius", "m", LENGTH, 0.5, offset_of!(Self, radius)).says("Radius", "Radius of a ball or capsule."),
        number("restitution", "1", SHARE, 0.1, offset_of!(Self, restitution))
            .says("Bounce", "Fraction of the normal speed that smoke keeps when it bounces."),
        number("friction", "1", SHARE, 0.2, offset_of!(Self, friction))
            .says("Friction", "Fraction of the tangential speed that smoke loses."),
        number("roughness", "1", SHARE, 0.0, offset_of!(Self, roughness)).says(
            "Roughness",
            "How much the distances of puffs from the surface vary: the largest is this fraction of the size that a puff has lost.",
        ),
        number("action", "1", [0.0, 2.0], 0.0, offset_of!(Self, action))
            .named(&["bounce", "kill", "tint"])
            .says("On contact", "What happens to smoke on contact."),
        number("tint", "1", [1.0, 15.0], 1.0, offset_of!(Self, tint))
            .whole()
            .says(
                "Tint",
                "Number of the tint that smoke gets, if contact tints. There are three colours, which repeat: 4 is as 1.",
            ),
    ];
}
