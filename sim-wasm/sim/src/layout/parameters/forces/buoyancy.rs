//! Parameters of `buoyancies.#`.

use crate::layout::parameters::field::{Field, number};
use crate::layout::parameters::item::{Item, Scope};

/// `buoyancies.#.*`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Buoyancy {
    pub acceleration: f64,
    pub scope: Scope,
}

impl Item for Buoyancy {
    const LABEL: &'static str = "Buoyancy";
    const FIELDS: &'static [Field<Self>] = &[number("acceleration", "m/s2", [-100.0, 100.0], 0.0, |b: &mut Self| {
        &mut b.acceleration
    })
    .starts_at(1.0)
    .says(
        "Acceleration",
        "Upward acceleration of smoke at temperature 1 in the region.",
    )];

    fn scope(&mut self) -> Option<&mut Scope> {
        Some(&mut self.scope)
    }
}
