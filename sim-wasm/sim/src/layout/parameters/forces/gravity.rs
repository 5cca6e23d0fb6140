//! Parameters of `gravities.#`.

use crate::layout::parameters::field::{Field, vector};
use crate::layout::parameters::item::{Item, Scope};

/// `gravities.#.*`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Gravity {
    pub acceleration: [f64; 3],
    pub scope: Scope,
}

impl Item for Gravity {
    const LABEL: &'static str = "Gravity";
    const FIELDS: &'static [Field<Self>] =
        &[
            vector("acceleration", "m/s2", [-100.0, 100.0], [0.0; 3], |g: &mut Self| {
                &mut g.acceleration
            })
            .starts_at(1.0)
            .says("Acceleration", "Acceleration of all smoke in the region."),
        ];

    fn scope(&mut self) -> Option<&mut Scope> {
        Some(&mut self.scope)
    }
}
