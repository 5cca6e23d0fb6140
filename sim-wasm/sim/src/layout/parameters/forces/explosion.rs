//! Parameters of `explosions.#`.

use std::mem::offset_of;

use bytemuck::{Pod, Zeroable};

use crate::layout::parameters::field::{Field, PLACE, number, vector};
use crate::layout::parameters::item::{Group, Item, Scope};

/// `explosions.#.*`.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct Explosion {
    pub impulse: f64,
    pub speed: f64,
    pub reach: f64,
    pub position: [f64; 3],
    pub scope: Scope,
}

impl Item for Explosion {
    const FIELDS: &'static [Field] = &[
        number("impulse", "m/s", [-100.0, 100.0], 0.0, offset_of!(Self, impulse))
            .starts_at(4.0)
            .says("Impulse", "Speed that smoke gains at the centre; negative is inwards."),
        number("speed", "m/s", [0.1, 1000.0], 20.0, offset_of!(Self, speed)).says(
            "Front speed",
            "Speed of the front. Smoke is accelerated when the front passes.",
        ),
        number("reach", "m", [0.05, 1000.0], 3.0, offset_of!(Self, reach))
            .says("Reach", "Distance at which the effect has faded to nothing."),
        vector("position", "m", PLACE, [0.0; 3], offset_of!(Self, position))
            .says("Position", "Centre of the explosion."),
    ];

    const LABEL: &'static str = "Explosion";

    const STARTS: &'static [(&'static str, f64)] = &[("envelope.period", 2.0)];

    const SCOPE: Group = Group::new(offset_of!(Self, scope), Scope::FIELDS);
}
