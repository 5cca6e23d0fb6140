//! Parameters of `vortices.#`.

use crate::layout::parameters::field::{DIRECTION, Field, PLACE, number, vector};
use crate::layout::parameters::item::{Item, Scope};

/// `vortices.#.*`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
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
    const FIELDS: &'static [Field<Self>] = &[
        number("circulation", "m2/s", [-200.0, 200.0], 0.0, |v: &mut Self| {
            &mut v.circulation
        })
        .starts_at(2.0)
        .says("Circulation", "Strength of the swirl; the sign selects its direction."),
        number("coreRadius", "m", [0.01, 50.0], 0.25, |v: &mut Self| &mut v.core_radius)
            .says("Core", "Radius of the calm core, at which the swirl is fastest."),
        number("reach", "m", [0.05, 1000.0], 2.0, |v: &mut Self| &mut v.reach).says(
            "Reach",
            "Distance from the axis at which the swirl has faded to nothing.",
        ),
        number("profile", "1", [0.0, 1.0], 0.0, |v: &mut Self| &mut v.profile)
            .named(&["lambOseen", "rankine"])
            .says("Profile", "A smooth core, or one that rotates like a solid."),
        number("inflow", "m/s", [-20.0, 20.0], 0.0, |v: &mut Self| &mut v.inflow).says(
            "Inflow",
            "Speed at which smoke is drawn towards the axis, at the core radius.",
        ),
        number("updraft", "m/s", [-20.0, 20.0], 0.0, |v: &mut Self| &mut v.updraft)
            .says("Updraft", "Speed along the axis at the centre of the core."),
        vector("position", "m", PLACE, [0.0; 3], |v: &mut Self| &mut v.position)
            .says("Position", "A point on the axis."),
        vector("axis", "1", DIRECTION, [0.0, 0.0, 1.0], |v: &mut Self| &mut v.axis)
            .says("Axis", "Direction of the axis."),
    ];

    fn scope(&mut self) -> Option<&mut Scope> {
        Some(&mut self.scope)
    }
}
