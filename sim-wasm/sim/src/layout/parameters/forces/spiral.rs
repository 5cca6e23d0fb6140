//! Parameters of `spirals.#`.

use std::mem::offset_of;

use bytemuck::{Pod, Zeroable};

use crate::layout::parameters::field::{DIRECTION, Field, PLACE, number, vector};
use crate::layout::parameters::item::{Group, Item, Scope};

/// `spirals.#.*`.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct Spiral {
    pub turn: f64,
    pub inward: f64,
    pub along: f64,
    pub core_radius: f64,
    pub reach: f64,
    pub position: [f64; 3],
    pub axis: [f64; 3],
    pub scope: Scope,
}

impl Item for Spiral {
    const FIELDS: &'static [Field] = &[
        number("turn", "rad/s", [-50.0, 50.0], 0.0, offset_of!(Self, turn))
            .starts_at(3.0)
            .says("Rotation speed", "Angular velocity of the air about the axis."),
        number("inward", "m/s", [-20.0, 20.0], 0.0, offset_of!(Self, inward)).says(
            "Inward speed",
            "Speed of the air towards the axis; negative is away from it.",
        ),
        number("along", "m/s", [-50.0, 50.0], 0.0, offset_of!(Self, along))
            .says("Axial speed", "Speed of the air along the axis."),
        number("coreRadius", "m", [0.01, 50.0], 0.25, offset_of!(Self, core_radius)).says(
            "Core",
            "Distance from the axis within which the inward flow slows down.",
        ),
        number("reach", "m", [0.05, 1000.0], 2.0, offset_of!(Self, reach)).says(
            "Reach",
            "Distance from the axis at which the spiral has faded to nothing.",
        ),
        vector("position", "m", PLACE, [0.0; 3], offset_of!(Self, position)).says("Position", "A point on the axis."),
        vector("axis", "1", DIRECTION, [0.0, 1.0, 0.0], offset_of!(Self, axis)).says("Axis", "Direction of the axis."),
    ];

    const LABEL: &'static str = "Spiral";

    const SCOPE: Group = Group::new(offset_of!(Self, scope), Scope::FIELDS);
}
