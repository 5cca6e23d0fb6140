//! Parameters of `turbulences.#`.

use std::mem::offset_of;

use bytemuck::{Pod, Zeroable};

use crate::layout::parameters::field::{Field, number};
use crate::layout::parameters::item::{Group, Item, Scope};
use crate::layout::parameters::settings::Pattern;

/// `turbulences.#.*`: swirls in a region.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct Turbulence {
    pub pattern: Pattern,
    pub scope: Scope,
}

impl Item for Turbulence {
    const LABEL: &'static str = "Turbulence";
    const FIELDS: &'static [Field] = &[
        number("speed", "m/s", [0.0, 20.0], 0.0, offset_of!(Self, pattern.speed))
            .starts_at(0.5)
            .says(
                "Speed",
                "Typical (root mean square) speed of the swirls; 0 disables the turbulence.",
            ),
        number("scale", "m", [0.05, 100.0], 1.0, offset_of!(Self, pattern.scale))
            .says("Scale", "Size of the largest swirls."),
        number("octaves", "1", [0.0, 4.0], 1.0, offset_of!(Self, pattern.octaves))
            .whole()
            .says(
                "Octaves",
                "Number of layers of swirls, each finer than the one before; 0 is still air.",
            ),
        number(
            "evolution",
            "1/s",
            [0.0, 10.0],
            0.3,
            offset_of!(Self, pattern.evolution),
        )
        .says("Evolution", "Rate at which the pattern of swirls changes."),
    ];

    const SCOPE: Group = Group::new(offset_of!(Self, scope), Scope::FIELDS);
}
