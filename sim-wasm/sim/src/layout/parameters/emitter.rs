//! Parameters of `emitters.#`.

use crate::layout::parameters::field::{DIRECTION, Field, PLACE, SHARE, number, vector};
use crate::layout::parameters::item::{Item, Scope, WHEN_AND_ON_WHAT};

/// Maximum number of surfaces.
pub const MAX_SURFACES: usize = 16;

/// `emitters.#.*`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Emitter {
    pub shape: f64,
    pub position: [f64; 3],
    pub direction: [f64; 3],
    pub radius: f64,
    pub inner: f64,
    pub extent: [f64; 3],
    pub surface: f64,
    pub speed: f64,
    pub speed_variation: f64,
    pub spread: f64,
    pub inherit: f64,
    pub size: f64,
    pub size_variation: f64,
    pub lifetime: f64,
    pub lifetime_variation: f64,
    pub temperature: f64,
    pub tint: f64,
    pub share: f64,
    pub burst_count: f64,
    pub scope: Scope,
}

impl Item for Emitter {
    const LABEL: &'static str = "Emitter";
    const FIELDS: &'static [Field<Self>] = &[
        number("shape", "1", [0.0, 8.0], 0.0, |e: &mut Self| &mut e.shape)
            .named(&[
                "point", "disc", "ball", "ring", "sphere", "box", "cone", "line", "surface",
            ])
            .says(
                "Shape",
                "Shape of the source. From a sphere or a surface, puffs leave outwards.",
            ),
        vector("position", "m", PLACE, [0.0; 3], |e: &mut Self| &mut e.position)
            .says("Position", "Centre of the shape."),
        vector("direction", "1", DIRECTION, [0.0, 1.0, 0.0], |e: &mut Self| {
            &mut e.direction
        })
        .says("Direction", "Direction in which puffs leave."),
        number("radius", "m", [0.0, 100.0], 0.1, |e: &mut Self| &mut e.radius)
            .says("Radius", "Radius of a disc, ball, ring, sphere or cone."),
        number("inner", "1", SHARE, 0.8, |e: &mut Self| &mut e.inner)
            .says("Inner radius", "Inner radius of a ring, as a fraction of its radius."),
        vector("extent", "m", PLACE, [0.5; 3], |e: &mut Self| &mut e.extent).says(
            "Extent",
            "Half sides of a box. A line goes from the position minus this vector to the position plus it.",
        ),
        number("surface", "1", [0.0, MAX_SURFACES as f64 - 1.0], 0.0, |e: &mut Self| {
            &mut e.surface
        })
        .whole()
        .says("Surface", "Number of the mesh that emits the puffs."),
        number("speed", "m/s", [0.0, 50.0], 0.5, |e: &mut Self| &mut e.speed)
            .says("Speed", "Speed at which puffs leave, relative to the air."),
        number("speedVariation", "1", SHARE, 0.2, |e: &mut Self| &mut e.speed_variation)
            .says("Speed variation", "Largest random change of the speed, as a fraction."),
        number("spread", "rad", [0.0, std::f64::consts::PI], 0.3, |e: &mut Self| {
            &mut e.spread
        })
        .says("Spread", "Half angle of the cone in which puffs leave."),
        number("inherit", "1", SHARE, 0.0, |e: &mut Self| &mut e.inherit).says(
            "Inherited velocity",
            "Fraction of the emitter's own velocity that its puffs inherit.",
        ),
        number("size", "m", [0.001, 20.0], 0.3, |e: &mut Self| &mut e.size)
            .says("Size", "Radius of puffs at full density."),
        number("sizeVariation", "1", SHARE, 0.2, |e: &mut Self| &mut e.size_variation)
            .says("Size variation", "Largest random change of the size, as a fraction."),
        number("lifetime", "1", [0.05, 20.0], 1.0, |e: &mut Self| &mut e.lifetime).says(
            "Lifetime",
            "Lifetime of its puffs, relative to the lifetime of all smoke.",
        ),
        number("lifetimeVariation", "1", SHARE, 0.2, |e: &mut Self| {
            &mut e.lifetime_variation
        })
        .says(
            "Lifetime variation",
            "Largest random change of the lifetime, as a fraction.",
        ),
        number("temperature", "1", [0.0, 4.0], 1.0, |e: &mut Self| &mut e.temperature)
            .says("Temperature", "Temperature of new puffs. Warm smoke rises."),
        number("tint", "1", [0.0, 15.0], 0.0, |e: &mut Self| &mut e.tint)
            .whole()
            .says(
                "Tint",
                "Number of the tint of new puffs; 0 is none. There are three colours, which repeat: 4 is as 1.",
            ),
        number("share", "1", [0.0, 1000.0], 1.0, |e: &mut Self| &mut e.share)
            .says("Share", "Share of the emission rate, relative to the other emitters."),
        number("burst.count", "particles", [0.0, 20_000.0], 0.0, |e: &mut Self| {
            &mut e.burst_count
        })
        .whole()
        .says("Burst", "Number of puffs emitted at once at each start."),
    ];

    const SCOPE: &'static [Field<Scope>] = WHEN_AND_ON_WHAT;

    fn scope(&mut self) -> Option<&mut Scope> {
        Some(&mut self.scope)
    }
}
