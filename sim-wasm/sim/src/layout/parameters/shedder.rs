//! Parameters of `shedders.#`.

use std::mem::offset_of;

use bytemuck::{Pod, Zeroable};

use crate::layout::parameters::field::{DIRECTION, Field, PLACE, SHARE, number, vector};
use crate::layout::parameters::item::{Group, Item, Scope};

const MAX_RATE: f64 = 2000.0;

/// `shedders.#.*`.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
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
    const FIELDS: &'static [Field] = &[
        number("rate", "1/s", [0.0, MAX_RATE], 0.0, offset_of!(Self, rate))
            .starts_at(30.0)
            .says("Rate", "Vortex particles shed per second; 0 disables the shedder."),
        vector("position", "m", PLACE, [0.0; 3], offset_of!(Self, position)).says(
            "Position",
            "Middle of the line on which they are shed, relative to the rigid.",
        ),
        vector("extent", "m", PLACE, [0.0; 3], offset_of!(Self, extent))
            .says("Extent", "Vector from the middle of the line to one end."),
        number("scatter", "m", [0.0, 100.0], 0.0, offset_of!(Self, scatter))
            .says("Scatter", "Largest random distance from the line."),
        vector("axis", "1", DIRECTION, [0.0, 0.0, 1.0], offset_of!(Self, axis))
            .says("Axis", "Direction of their axes, relative to the rigid."),
        number("jitter", "1", SHARE, 0.1, offset_of!(Self, jitter))
            .says("Axis variation", "How much their axes vary at random."),
        number("alternate", "1", [0.0, 1.0], 0.0, offset_of!(Self, alternate))
            .named(&["alike", "alternating"])
            .says(
                "Rotation",
                "All rotate alike, or the two ends shed alternately with opposite rotation.",
            ),
        number("strength", "m/s", [-20.0, 20.0], 0.0, offset_of!(Self, strength))
            .starts_at(1.0)
            .says(
                "Strength",
                "Peak air speed around a new vortex particle, at any speed of the rigid.",
            ),
        number("perSpeed", "1", [-4.0, 4.0], 0.5, offset_of!(Self, per_speed)).says(
            "Strength by speed",
            "Fraction of the speed of the air past the rigid that is added to the strength.",
        ),
        number("coreRadius", "m", [0.01, 5.0], 0.15, offset_of!(Self, core_radius)).says(
            "Core",
            "Radius at which a new vortex particle is fastest. It ends at three times this radius.",
        ),
        number("viscosity", "m2/s", [0.0, 1.0], 0.002, offset_of!(Self, viscosity))
            .says("Viscosity", "How fast they widen and slow down."),
        number("lifetime", "s", [0.1, 60.0], 3.0, offset_of!(Self, lifetime))
            .says("Lifetime", "Time until they have faded away."),
    ];

    const SCOPE: Group = Group::new(offset_of!(Self, scope), Scope::FIELDS);
}
