//! Parameters of `flows.#`.

use std::mem::offset_of;

use bytemuck::{Pod, Zeroable};

use crate::layout::parameters::field::{Field, PLACE, Points, number, points, vector};
use crate::layout::parameters::item::{Group, Item, Scope};

/// `flows.#.*`.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct Flow {
    pub speed: f64,
    pub radius: f64,
    pub swirl: f64,
    pub inflow: f64,
    pub closed: f64,
    pub points: Points,
    pub position: [f64; 3],
    pub scale: f64,
    pub scope: Scope,
}

impl Item for Flow {
    const FIELDS: &'static [Field] = &[
        number("speed", "m/s", [-50.0, 50.0], 0.0, offset_of!(Self, speed))
            .starts_at(1.5)
            .says(
                "Speed",
                "Speed of the air along the stroke; negative is from its end to its start.",
            ),
        number("radius", "m", [0.02, 50.0], 0.3, offset_of!(Self, radius)).says(
            "Radius",
            "Distance from the stroke at which the flow has faded to nothing.",
        ),
        number("swirl", "rad/s", [-50.0, 50.0], 0.0, offset_of!(Self, swirl))
            .says("Swirl", "Angular velocity of the air about the stroke."),
        number("inflow", "m/s", [-20.0, 20.0], 0.0, offset_of!(Self, inflow))
            .starts_at(0.5)
            .says(
                "Inflow",
                "Greatest speed at which smoke is drawn to the stroke; negative is away from it.",
            ),
        number("closed", "1", [0.0, 1.0], 0.0, offset_of!(Self, closed))
            .named(&["open", "ring"])
            .says("Ends", "Whether the stroke ends, or returns to its start."),
        points("points", offset_of!(Self, points)).says(
            "Stroke",
            "The points that the stroke passes through; without any it goes one metre up.",
        ),
        vector("position", "m", PLACE, [0.0; 3], offset_of!(Self, position)).says("Position", "Origin of the points."),
        number("scale", "1", [0.01, 100.0], 1.0, offset_of!(Self, scale)).says(
            "Scale",
            "Factor on the distances of the points from the origin, and on the radius.",
        ),
    ];

    const LABEL: &'static str = "Flow";

    const SCOPE: Group = Group::new(offset_of!(Self, scope), Scope::FIELDS);
}
