//! Parameters of `jets.#`.

use crate::layout::parameters::field::{DIRECTION, Field, PLACE, number, vector};
use crate::layout::parameters::item::{Item, Scope};

/// `jets.#.*`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
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
    const FIELDS: &'static [Field<Self>] = &[
        number("speed", "m/s", [0.0, 100.0], 0.0, |j: &mut Self| &mut j.speed)
            .starts_at(4.0)
            .says("Speed", "How fast the air leaves the nozzle."),
        number("radius", "m", [0.001, 50.0], 0.1, |j: &mut Self| &mut j.radius)
            .says("Nozzle radius", "Radius of the nozzle."),
        number("spread", "1", [0.01, 1.0], 0.113, |j: &mut Self| &mut j.spread).says(
            "Spread",
            "Increase of the jet's width per metre; a jet of air in air has 0.113.",
        ),
        number("reach", "m", [0.05, 1000.0], 5.0, |j: &mut Self| &mut j.reach).says(
            "Reach",
            "Distance from the nozzle at which the jet has faded to nothing.",
        ),
        vector("position", "m", PLACE, [0.0; 3], |j: &mut Self| &mut j.position)
            .says("Position", "Centre of the nozzle."),
        vector("direction", "1", DIRECTION, [0.0, 1.0, 0.0], |j: &mut Self| {
            &mut j.direction
        })
        .says("Direction", "Direction of the jet."),
    ];

    const LABEL: &'static str = "Jet";

    fn scope(&mut self) -> Option<&mut Scope> {
        Some(&mut self.scope)
    }
}
