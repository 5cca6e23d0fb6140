//! Parameters of `attractors.#`.

use std::mem::offset_of;

use bytemuck::{Pod, Zeroable};

use crate::layout::parameters::field::{Field, PLACE, number, vector};
use crate::layout::parameters::item::{Group, Item, Scope};

/// `attractors.#.*`.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct Attractor {
    pub acceleration: f64,
    pub core_radius: f64,
    pub reach: f64,
    pub position: [f64; 3],
    pub scope: Scope,
}

impl Item for Attractor {
    const FIELDS: &'static [Field] = &[
        number(
            "acceleration",
            "m/s2",
            [-100.0, 100.0],
            0.0,
            offset_of!(Self, acceleration),
        )
        .starts_at(3.0)
        .says(
            "Pull",
            "Acceleration of smoke towards the centre; negative is away from it.",
        ),
        number("coreRadius", "m", [0.01, 50.0], 0.1, offset_of!(Self, core_radius))
            .says("Core", "Radius within which the pull fades towards the centre."),
        number("reach", "m", [0.05, 1000.0], 5.0, offset_of!(Self, reach))
            .says("Reach", "Distance at which the pull has faded to nothing."),
        vector("position", "m", PLACE, [0.0; 3], offset_of!(Self, position)).says("Position", "Centre of the pull."),
    ];

    const LABEL: &'static str = "Attractor";

    const SCOPE: Group = Group::new(offset_of!(Self, scope), Scope::FIELDS);
}
