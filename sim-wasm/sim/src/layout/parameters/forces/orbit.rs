//! Parameters of `orbits.#`.

use std::mem::offset_of;

use bytemuck::{Pod, Zeroable};

use crate::layout::parameters::field::{DIRECTION, Field, PLACE, number, vector};
use crate::layout::parameters::item::{Group, Item, Scope};

/// `orbits.#.*`.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct Orbit {
    pub acceleration: f64,
    pub core_radius: f64,
    pub position: [f64; 3],
    pub axis: [f64; 3],
    pub scope: Scope,
}

impl Item for Orbit {
    const FIELDS: &'static [Field] = &[
        number(
            "acceleration",
            "m/s2",
            [-100.0, 100.0],
            0.0,
            offset_of!(Self, acceleration),
        )
        .starts_at(2.0)
        .says(
            "Pull",
            "Acceleration at a distance of one metre. It is larger nearer the centre and smaller farther away.",
        ),
        number("coreRadius", "m", [0.01, 50.0], 0.1, offset_of!(Self, core_radius))
            .says("Core", "Radius within which the pull fades towards the centre."),
        vector("position", "m", PLACE, [0.0; 3], offset_of!(Self, position)).says(
            "Position",
            "Point that smoke orbits, or a point on the line that it orbits.",
        ),
        vector("axis", "1", DIRECTION, [0.0; 3], offset_of!(Self, axis))
            .says("Axis", "Direction of the line that smoke orbits; all 0 for a point."),
    ];

    const LABEL: &'static str = "Orbit";

    const SCOPE: Group = Group::new(offset_of!(Self, scope), Scope::FIELDS);
}
