//! Parameters of `shedders.#`.

use crate::layout::parameters::field::{DIRECTION, Field, PLACE, SHARE, number, vector};
use crate::layout::parameters::item::{Item, Scope};

const MAX_RATE: f64 = 2000.0;

/// `shedders.#.*`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Shedder {
    pub rate: f64,
    pub position: [f64; 3],
    pub extent: [f64; 3],
    pub scatter: f64,
    pub axis: [f64; 3],
    pub jitter: f64,
    pub alternate: f64,
    pub strength: f64,
    pub per_speed: f64,
    pub core_radius: f64,
    pub viscosity: f64,
    pub lifetime: f64,
    pub scope: Scope,
}

impl Item for Shedder {
    const LABEL: &'static str = "Vortex shedder";
    const FIELDS: &'static [Field<Self>] = &[
        number("rate", "1/s", [0.0, MAX_RATE], 0.0, |s: &mut Self| &mut s.rate)
            .starts_at(30.0)
            .says("Rate", "Swirls shed in a second; 0 takes this shedder away."),
        vector("position", "m", PLACE, [0.0; 3], |s: &mut Self| &mut s.position)
            .says("Place", "Where on the rigid swirls are shed: the middle."),
        vector("extent", "m", PLACE, [0.0; 3], |s: &mut Self| &mut s.extent).says(
            "Extent",
            "From the middle to one end of the line on which they are shed.",
        ),
        number("scatter", "m", [0.0, 100.0], 0.0, |s: &mut Self| &mut s.scatter)
            .says("Scatter", "How far from their place they may be born."),
        vector("axis", "1", DIRECTION, [0.0, 0.0, 1.0], |s: &mut Self| &mut s.axis)
            .says("Axis", "Direction of their axes on the rigid."),
        number("jitter", "1", SHARE, 0.1, |s: &mut Self| &mut s.jitter).says("Disorder", "How much their axes differ."),
        number("alternate", "1", [0.0, 1.0], 0.0, |s: &mut Self| &mut s.alternate)
            .named(&["alike", "alternating"])
            .says("Senses", "All turn alike, or by turns at both ends against each other."),
        number("strength", "m/s", [-20.0, 20.0], 0.0, |s: &mut Self| &mut s.strength)
            .starts_at(1.0)
            .says("Strength", "Fastest air around a fresh one, however slow the rigid is."),
        number("perSpeed", "1", [-4.0, 4.0], 0.5, |s: &mut Self| &mut s.per_speed).says(
            "With speed",
            "Share of the speed of the air past the rigid that is added to the strength.",
        ),
        number("coreRadius", "m", [0.01, 5.0], 0.15, |s: &mut Self| &mut s.core_radius)
            .says("Core", "Where a fresh one is fastest; it ends at three times that."),
        number("viscosity", "m2/s", [0.0, 1.0], 0.002, |s: &mut Self| &mut s.viscosity)
            .says("Viscosity", "How fast they grow wide and slow."),
        number("lifetime", "s", [0.1, 60.0], 3.0, |s: &mut Self| &mut s.lifetime)
            .says("Lifetime", "When they have faded away."),
    ];

    fn scope(&mut self) -> Option<&mut Scope> {
        Some(&mut self.scope)
    }
}
