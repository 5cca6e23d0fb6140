//! Parameters of `jets.#`.

use std::mem::offset_of;

use bytemuck::{Pod, Zeroable};

use crate::layout::parameters::field::{DIRECTION, Field, PLACE, number, vector};
use crate::layout::parameters::item::{Group, Item, Scope};

/// `jets.#.*`.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct Jet {
    pub speed: f64,
    pub radius: f64,
    pub spread: f64,
    pub reach: f64,
    pub position: [f64; 3],
    pub direction: [f64; 3],
    pub scope: Scope,
}

impl Item for Jet {
    const FIELDS: &'static [Field] = &[
        number("speed", "m/s", [0.0, 100.0], 0.0, offset_of!(Self, speed))
            .starts_at(4.0)
            .says("Speed", "How fast the air leaves the nozzle."),
        number("radius", "m", [0.001, 50.0], 0.1, offset_of!(Self, radius))
            .says("Nozzle radius", "Radius of the nozzle."),
        number("spread", "1", [0.01, 1.0], 0.113, offset_of!(Self, spread)).says(
            "Spread",
            "Increase of the jet's width per metre; a jet of air in air has 0.113.",
        ),
        number("reach", "m", [0.05, 1000.0], 5.0, offset_of!(Self, reach)).says(
            "Reach",
            "Distance from the nozzle at which the jet has faded to nothing.",
        ),
        vector("position", "m", PLACE, [0.0; 3], offset_of!(Self, position)).says("Position", "Centre of the nozzle."),
        vector(
            "direction",
            "1",
            DIRECTION,
            [0.0, 1.0, 0.0],
            offset_of!(Self, direction),
        )
        .says("Direction", "Direction of the jet."),
    ];

    const LABEL: &'static str = "Jet";

    const SCOPE: Group = Group::new(offset_of!(Self, scope), Scope::FIELDS);
}
