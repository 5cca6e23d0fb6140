//! Parameters of `drags.#`.

use crate::layout::parameters::field::{Field, number};
use crate::layout::parameters::item::{Item, Scope};

/// `drags.#.*`: drag in a region.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Drag {
    pub rate: f64,
    pub quadratic: f64,
    pub scope: Scope,
}

impl Item for Drag {
    const LABEL: &'static str = "Drag";
    const FIELDS: &'static [Field<Self>] = &[
        number("rate", "1/s", [0.0, 1000.0], 0.0, |d: &mut Self| &mut d.rate)
            .starts_at(2.0)
            .says("Drag", "How strongly the air of the region carries smoke."),
        number("quadratic", "1/m", [0.0, 1000.0], 0.0, |d: &mut Self| &mut d.quadratic).says(
            "Quadratic drag",
            "Drag that grows with speed, so it slows fast smoke most.",
        ),
    ];

    fn scope(&mut self) -> Option<&mut Scope> {
        Some(&mut self.scope)
    }
}
