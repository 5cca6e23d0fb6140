//! Parameters of `turbulences.#`.

use crate::layout::parameters::field::{Field, number};
use crate::layout::parameters::item::{Item, Scope};
use crate::layout::parameters::settings::Pattern;

/// `turbulences.#.*`: swirls in a region.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Turbulence {
    pub pattern: Pattern,
    pub scope: Scope,
}

impl Item for Turbulence {
    const LABEL: &'static str = "Turbulence";
    const FIELDS: &'static [Field<Self>] = &[
        number("speed", "m/s", [0.0, 20.0], 0.0, |t: &mut Self| &mut t.pattern.speed)
            .starts_at(0.5)
            .says(
                "Speed",
                "Typical (root mean square) speed of the swirls; 0 disables the turbulence.",
            ),
        number("scale", "m", [0.05, 100.0], 1.0, |t: &mut Self| &mut t.pattern.scale)
            .says("Scale", "Size of the largest swirls."),
        number("octaves", "1", [0.0, 4.0], 1.0, |t: &mut Self| &mut t.pattern.octaves)
            .whole()
            .says(
                "Octaves",
                "Number of layers of swirls, each finer than the one before; 0 is still air.",
            ),
        number("evolution", "1/s", [0.0, 10.0], 0.3, |t: &mut Self| {
            &mut t.pattern.evolution
        })
        .says("Evolution", "Rate at which the pattern of swirls changes."),
    ];

    fn scope(&mut self) -> Option<&mut Scope> {
        Some(&mut self.scope)
    }
}
