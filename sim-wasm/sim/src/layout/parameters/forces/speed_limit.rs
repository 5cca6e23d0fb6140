//! Parameters of `speedLimits.#`.

use crate::layout::parameters::field::{Field, number};
use crate::layout::parameters::item::{Item, Scope};

/// `speedLimits.#.*`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SpeedLimit {
    pub speed: f64,
    pub scope: Scope,
}

impl Item for SpeedLimit {
    const FIELDS: &'static [Field<Self>] =
        &[
            number("speed", "m/s", [0.0, 1000.0], 1000.0, |s: &mut Self| &mut s.speed)
                .starts_at(0.5)
                .says("Maximum speed", "Maximum speed of smoke in the region."),
        ];

    const LABEL: &'static str = "Speed limit";

    fn scope(&mut self) -> Option<&mut Scope> {
        Some(&mut self.scope)
    }
}
