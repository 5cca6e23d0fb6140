//! Sections that exist once. Their labels and texts are in `src/parameters/rows`.

use std::mem::offset_of;

use bytemuck::{Pod, Zeroable};

use crate::layout::parameters::field::{Field, PLACE, number, vector};
use crate::layout::parameters::item::Item;

const MULTIPLIER: [f64; 2] = [0.0, 10.0];

/// `emission.*`: settings of all emitters.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct Emission {
    pub rate: f64,
    pub lifetime: f64,
    pub growth_time: f64,
    pub entrainment: f64,
    /// See [`Dissolve`].
    pub dissolve: f64,
    pub company: f64,
    pub size_spread: f64,
}

impl Item for Emission {
    const FIELDS: &'static [Field] = &[
        number("rate", "particles/s", [0.0, 20_000.0], 28.0, offset_of!(Self, rate)),
        number("lifetime", "s", [0.1, 60.0], 7.0, offset_of!(Self, lifetime)),
        number("growthTime", "s", [0.0, 30.0], 2.6, offset_of!(Self, growth_time)),
        number("entrainment", "1", [0.0, 1.0], 0.0, offset_of!(Self, entrainment)),
        number("dissolve", "1", [0.0, 3.0], 0.0, offset_of!(Self, dissolve))
            .named(&["shrink", "erode", "tear", "thin"]),
        number("company", "1", [0.0, 1.0], 0.0, offset_of!(Self, company)),
        number("sizeSpread", "1", [0.0, 1.0], 0.0, offset_of!(Self, size_spread)),
    ];
}

/// `puff.*`.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct Puff {
    pub size: f64,
    pub variations: f64,
    pub turn: f64,
    pub stretch: f64,
    pub billow: f64,
}

impl Item for Puff {
    const FIELDS: &'static [Field] = &[
        number("size", "1", [0.1, 4.0], 1.0, offset_of!(Self, size)),
        number("variations", "1", [1.0, 32.0], 4.0, offset_of!(Self, variations)).whole(),
        number("turn", "1", [0.0, 2.0], 0.0, offset_of!(Self, turn)),
        number("stretch", "1", [1.0, 4.0], 1.0, offset_of!(Self, stretch)),
        number("billow", "1", [0.0, 1.0], 0.0, offset_of!(Self, billow)),
    ];
}

/// `forces.*`: multipliers of each kind of force, and the global wind.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct Multipliers {
    pub gravity: f64,
    pub buoyancy: f64,
    pub turbulence: f64,
    pub vortex: f64,
    pub drag: f64,
    pub wind: [f64; 3],
}

impl Item for Multipliers {
    const FIELDS: &'static [Field] = &[
        number("gravity", "1", MULTIPLIER, 1.0, offset_of!(Self, gravity)),
        number("buoyancy", "1", MULTIPLIER, 1.0, offset_of!(Self, buoyancy)),
        number("turbulence", "1", MULTIPLIER, 1.0, offset_of!(Self, turbulence)),
        number("vortex", "1", MULTIPLIER, 1.0, offset_of!(Self, vortex)),
        number("drag", "1", MULTIPLIER, 1.0, offset_of!(Self, drag)),
        vector("wind", "m/s", [-50.0, 50.0], [0.0; 3], offset_of!(Self, wind)),
    ];
}

/// `gravity.*`.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct UniformGravity {
    pub acceleration: f64,
}

impl Item for UniformGravity {
    const FIELDS: &'static [Field] = &[number(
        "acceleration",
        "m/s2",
        [0.0, 100.0],
        0.0,
        offset_of!(Self, acceleration),
    )];
}

/// `buoyancy.*`.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct UniformBuoyancy {
    pub acceleration: f64,
    pub cooling_time: f64,
}

impl Item for UniformBuoyancy {
    const FIELDS: &'static [Field] = &[
        number(
            "acceleration",
            "m/s2",
            [0.0, 100.0],
            1.5,
            offset_of!(Self, acceleration),
        ),
        number("coolingTime", "s", [0.01, 1000.0], 4.0, offset_of!(Self, cooling_time)),
    ];
}

/// `style.*`: the style settings that affect rows.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct Style {
    pub hold: f64,
}

impl Item for Style {
    const FIELDS: &'static [Field] = &[number("hold", "1", [1.0, 4.0], 1.0, offset_of!(Self, hold)).whole()];
}

/// `simulation.*`.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct SimulationSettings {
    pub integrator: f64,
}

impl Item for SimulationSettings {
    const FIELDS: &'static [Field] =
        &[number("integrator", "1", [0.0, 1.0], 0.0, offset_of!(Self, integrator)).named(&["airAndSlip", "paper"])];
}

/// `wind.*`: variation of `forces.wind.*` with height and time.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct Weather {
    pub gusts: f64,
    pub gust_time: f64,
    pub shear: f64,
    pub height: f64,
}

impl Item for Weather {
    const FIELDS: &'static [Field] = &[
        number("gusts", "m/s", [0.0, 20.0], 0.0, offset_of!(Self, gusts)),
        number("gustTime", "s", [0.1, 60.0], 2.0, offset_of!(Self, gust_time)),
        number("shear", "1/m", [-10.0, 10.0], 0.0, offset_of!(Self, shear)),
        number("height", "m", PLACE, 0.0, offset_of!(Self, height)),
    ];
}

/// `turbulence.*`: the global turbulence.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct Pattern {
    pub speed: f64,
    pub scale: f64,
    pub octaves: f64,
    pub evolution: f64,
}

impl Item for Pattern {
    const FIELDS: &'static [Field] = &[
        number("speed", "m/s", [0.0, 20.0], 0.13, offset_of!(Self, speed)),
        number("scale", "m", [0.05, 20.0], 0.9, offset_of!(Self, scale)),
        number("octaves", "1", [0.0, 4.0], 2.0, offset_of!(Self, octaves)).whole(),
        number("evolution", "1/s", [0.0, 10.0], 0.25, offset_of!(Self, evolution)),
    ];
}

/// `drag.*`: the global drag.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct Resistance {
    pub rate: f64,
    pub quadratic: f64,
}

impl Item for Resistance {
    const FIELDS: &'static [Field] = &[
        number("rate", "1/s", [0.0, 1000.0], 1.5, offset_of!(Self, rate)),
        number("quadratic", "1/m", [0.0, 1000.0], 0.0, offset_of!(Self, quadratic)),
    ];
}

/// How puffs end as their density falls.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dissolve {
    /// Puffs shrink.
    Shrink,
    /// Holes open in them.
    Erode,
    /// Holes open along the motion of a puff, and it stretches.
    Tear,
    /// Puffs shrink and stretch to strands.
    Thin,
}

impl Dissolve {
    /// The value of `emission.dissolve`, in the order of its names.
    pub fn from_parameter(value: f64) -> Self {
        match value {
            1.0 => Self::Erode,
            2.0 => Self::Tear,
            3.0 => Self::Thin,
            _ => Self::Shrink,
        }
    }

    /// Whether holes open.
    pub fn erodes(self) -> bool {
        matches!(self, Self::Erode | Self::Tear)
    }
}

/// The integrator of particle motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Integrator {
    /// Air velocity by the midpoint rule, slip in closed form.
    AirAndSlip,
    /// Forward Euler on one inertial velocity, as published.
    Paper,
}

impl Integrator {
    /// The value of `simulation.integrator`: 0 air and slip, 1 paper.
    pub fn from_parameter(value: f64) -> Self {
        if value == 1.0 { Self::Paper } else { Self::AirAndSlip }
    }
}
