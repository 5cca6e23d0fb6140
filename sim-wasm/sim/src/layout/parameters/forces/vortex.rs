//! Parameters of `vortices.#`.

use std::mem::offset_of;

use bytemuck::{Pod, Zeroable};

use crate::layout::parameters::field::{DIRECTION, Field, PLACE, number, vector};
use crate::layout::parameters::item::{Group, Item, Scope};

/// `vortices.#.*`.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct Vortex {
    pub circulation: f64,
    pub core_radius: f64,
    pub reach: f64,
    pub profile: f64,
    pub inflow: f64,
    pub updraft: f64,
    pub position: [f64; 3],
    pub axis: [f64; 3],
    pub scope: Scope,
}

impl Item for Vortex {
    const LABEL: &'static str = "Vortex";
    const FIELDS: &'static [Field] = &[
        number(
            "circulation",
            "m2/s",
            [-200.0, 200.0],
            0.0,
            offset_of!(Self, circulation),
        )
        .starts_at(2.0)
        .says("Circulation", "Strength of the swirl; the sign selects its direction."),
        number("coreRadius", "m", [0.01, 50.0], 0.25, offset_of!(Self, core_radius))
            .says("Core", "Radius of the calm core, at which the swirl is fastest."),
        number("reach", "m", [0.05, 1000.0], 2.0, offset_of!(Self, reach)).says(
            "Reach",
            "Distance from the axis at which the swirl has faded to nothing.",
        ),
        number("profile", "1", [0.0, 1.0], 0.0, offset_of!(Self, profile))
            .named(&["lambOseen", "rankine"])
            .says("Profile", "A smooth core, or one that rotates like a solid."),
        number("inflow", "m/s", [-20.0, 20.0], 0.0, offset_of!(Self, inflow)).says(
            "Inflow",
            "Speed at which smoke is drawn towards the axis, at the core radius.",
        ),
        number("updraft", "m/s", [-20.0, 20.0], 0.0, offset_of!(Self, updraft))
            .says("Updraft", "Speed along the axis at the centre of the core."),
        vector("position", "m", PLACE, [0.0; 3], offset_of!(Self, position)).says("Position", "A point on the axis."),
        vector("axis", "1", DIRECTION, [0.0, 0.0, 1.0], offset_of!(Self, axis)).says("Axis", "Direction of the axis."),
    ];

    const SCOPE: Group = Group::new(offset_of!(Self, scope), Scope::FIELDS);
}
