//! Parameters of `emitters.#`.

use std::mem::offset_of;

use bytemuck::{Pod, Zeroable};

use crate::layout::parameters::field::{DIRECTION, Field, MAX_STOPS, PLACE, SHARE, Stops, number, stops, vector};
use crate::layout::parameters::item::{Group, Item, Scope, WHEN_AND_ON_WHAT};

/// Maximum number of surfaces.
pub const MAX_SURFACES: usize = 16;

/// `emitters.#.*`.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
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
    pub per_metre: f64,
    pub look: Look,
}

/// `emitters.#.look.*`: how its puffs differ from the rest of the smoke. By default they do not.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub struct Look {
    /// 0: that of the smoke, as all zeros here.
    pub lifetime: f64,
    pub growth_time: f64,
    pub size_curve: Stops,
    pub density_curve: Stops,
    /// One more than the value of `emission.dissolve`.
    pub dissolve: f64,
    pub drag: f64,
    pub buoyancy: f64,
    pub gravity: f64,
    /// Number of its colours and its ink, which only the page knows.
    pub style: f64,
}

impl Look {
    /// No difference.
    pub const NONE: Self = Self {
        lifetime: 0.0,
        growth_time: 0.0,
        size_curve: [0.0; MAX_STOPS],
        density_curve: [0.0; MAX_STOPS],
        dissolve: 0.0,
        drag: 1.0,
        buoyancy: 1.0,
        gravity: 1.0,
        style: 0.0,
    };

    /// Whether its puffs move as those without a look.
    pub fn moves_as_smoke(&self) -> bool {
        [self.drag, self.buoyancy, self.gravity] == [1.0; 3]
    }

    /// Whether its puffs end as strands.
    pub fn thins(&self) -> bool {
        self.dissolve > 2.0
    }
}

impl PartialEq for Look {
    // Once for all comparisons, which are not frequent.
    #[inline(never)]
    fn eq(&self, other: &Self) -> bool {
        let numbers = |look: &Self| bytemuck::cast::<Self, [f64; LOOK_NUMBERS]>(*look);
        numbers(self) == numbers(other)
    }
}

impl Default for Emitter {
    fn default() -> Self {
        Self::FREE
    }
}

/// Count of the numbers of a look.
const LOOK_NUMBERS: usize = size_of::<Look>() / size_of::<f64>();
/// Range of a factor on a force.
const FACTOR: [f64; 2] = [0.0, 10.0];
/// Greatest number of a style.
const MAX_STYLE: f64 = u32::MAX as f64;

impl Emitter {
    /// A free slot of the pool: all zeros but the look.
    pub const FREE: Self = {
        let zeros: Self = bytemuck::zeroed();
        Self {
            look: Look::NONE,
            ..zeros
        }
    };

    /// Whether its puffs differ from the rest of the smoke.
    pub fn has_look(&self) -> bool {
        self.look != Look::NONE
    }
}

impl Item for Emitter {
    const LABEL: &'static str = "Emitter";
    const FIELDS: &'static [Field] = &[
        number("shape", "1", [0.0, 8.0], 0.0, offset_of!(Self, shape))
            .named(&[
                "point", "disc", "ball", "ring", "sphere", "box", "cone", "line", "surface",
            ])
            .says(
                "Shape",
                "Shape of the source. From a sphere or a surface, puffs leave outwards.",
            ),
        vector("position", "m", PLACE, [0.0; 3], offset_of!(Self, position)).says("Position", "Centre of the shape."),
        vector(
            "direction",
            "1",
            DIRECTION,
            [0.0, 1.0, 0.0],
            offset_of!(Self, direction),
        )
        .says("Direction", "Direction in which puffs leave."),
        number("radius", "m", [0.0, 100.0], 0.1, offset_of!(Self, radius))
            .says("Radius", "Radius of a disc, ball, ring, sphere or cone."),
        number("inner", "1", SHARE, 0.8, offset_of!(Self, inner))
            .says("Inner radius", "Inner radius of a ring, as a fraction of its radius."),
        vector("extent", "m", PLACE, [0.5; 3], offset_of!(Self, extent)).says(
            "Extent",
            "Half sides of a box. A line goes from the position minus this vector to the position plus it.",
        ),
        number(
            "surface",
            "1",
            [0.0, MAX_SURFACES as f64 - 1.0],
            0.0,
            offset_of!(Self, surface),
        )
        .whole()
        .says("Surface", "Number of the mesh that emits the puffs."),
        number("speed", "m/s", [0.0, 50.0], 0.5, offset_of!(Self, speed))
            .says("Speed", "Speed at which puffs leave, relative to the air."),
        number("speedVariation", "1", SHARE, 0.2, offset_of!(Self, speed_variation))
            .says("Speed variation", "Largest random change of the speed, as a fraction."),
        number(
            "spread",
            "rad",
            [0.0, std::f64::consts::PI],
            0.3,
            offset_of!(Self, spread),
        )
        .says("Spread", "Half angle of the cone in which puffs leave."),
        number("inherit", "1", SHARE, 0.0, offset_of!(Self, inherit)).says(
            "Inherited velocity",
            "Fraction of the emitter's own velocity that its puffs inherit.",
        ),
        number("size", "m", [0.001, 20.0], 0.3, offset_of!(Self, size))
            .says("Size", "Radius of puffs at full density."),
        number("sizeVariation", "1", SHARE, 0.2, offset_of!(Self, size_variation))
            .says("Size variation", "Largest random change of the size, as a fraction."),
        number("lifetime", "1", [0.05, 20.0], 1.0, offset_of!(Self, lifetime)).says(
            "Lifetime",
            "Lifetime of its puffs, relative to the lifetime of all smoke.",
        ),
        number(
            "lifetimeVariation",
            "1",
            SHARE,
            0.2,
            offset_of!(Self, lifetime_variation),
        )
        .says(
            "Lifetime variation",
            "Largest random change of the lifetime, as a fraction.",
        ),
        number("temperature", "1", [0.0, 4.0], 1.0, offset_of!(Self, temperature))
            .says("Temperature", "Temperature of new puffs. Warm smoke rises."),
        number("tint", "1", [0.0, 15.0], 0.0, offset_of!(Self, tint))
            .whole()
            .says(
                "Tint",
                "Number of the tint of new puffs; 0 is none. There are three colours, which repeat: 4 is as 1.",
            ),
        number("share", "1", [0.0, 1000.0], 1.0, offset_of!(Self, share))
            .says("Share", "Share of the emission rate, relative to the other emitters."),
        number(
            "burst.count",
            "particles",
            [0.0, 20_000.0],
            0.0,
            offset_of!(Self, burst_count),
        )
        .whole()
        .says("Burst", "Number of puffs emitted at once at each start."),
    ];

    const LATER: &'static [Field] = &[
        number("perMetre", "1/m", [0.0, 1000.0], 0.0, offset_of!(Self, per_metre))
            .rare()
            .says(
                "Puffs per metre",
                "Number of puffs for each metre that the emitter travels, besides the emission rate.",
            ),
        number("look.lifetime", "s", [0.0, 600.0], 0.0, offset_of!(Self, look.lifetime))
            .rare()
            .says(
                "Own lifetime",
                "Lifetime of its puffs, which grow within a quarter of it; 0 is that of the smoke.",
            ),
        number(
            "look.growthTime",
            "s",
            [0.0, 20.0],
            0.0,
            offset_of!(Self, look.growth_time),
        )
        .rare()
        .says(
            "Own growth time",
            "Time in which its puffs reach their size; 0 is that of the smoke.",
        ),
        stops("look.sizeCurve", offset_of!(Self, look.size_curve))
            .says("Size over life", "Fraction of its size that a puff has at each age."),
        stops("look.densityCurve", offset_of!(Self, look.density_curve)).says(
            "Own density over life",
            "How dense its puffs are at each age, instead of the density of the smoke.",
        ),
        number("look.dissolve", "1", [0.0, 4.0], 0.0, offset_of!(Self, look.dissolve))
            .named(&["smoke", "shrink", "erode", "tear", "thin"])
            .rare()
            .says(
                "Own dissolution",
                "How its puffs end: as the rest of the smoke, or in another way.",
            ),
        number("look.drag", "1", FACTOR, 1.0, offset_of!(Self, look.drag))
            .rare()
            .says("Drag", "Factor on the drag of its puffs."),
        number("look.buoyancy", "1", FACTOR, 1.0, offset_of!(Self, look.buoyancy))
            .rare()
            .says("Buoyancy", "Factor on the buoyancy of its puffs."),
        number("look.gravity", "1", FACTOR, 1.0, offset_of!(Self, look.gravity))
            .rare()
            .says("Gravity", "Factor on the gravity of its puffs."),
        number("look.style", "1", [0.0, MAX_STYLE], 0.0, offset_of!(Self, look.style))
            .whole()
            .rare()
            .says(
                "Style",
                "Number of the colours and the ink of its puffs; 0 is those of the smoke.",
            ),
    ];

    const SCOPE: Group = Group::new(offset_of!(Self, scope), WHEN_AND_ON_WHAT);
}
