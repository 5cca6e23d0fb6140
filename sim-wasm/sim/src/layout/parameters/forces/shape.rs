//! Parameters of `shapes.#`.

use std::mem::offset_of;

use bytemuck::{Pod, Zeroable};

use crate::layout::parameters::field::{DIRECTION, Field, LENGTH, OUTLINE_NUMBERS, PLACE, number, outline, vector};
use crate::layout::parameters::item::{Group, Item, Scope};

/// `shapes.#.*`.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
pub struct Shape {
    pub speed: f64,
    pub hold: f64,
    pub size: f64,
    pub depth: f64,
    pub position: [f64; 3],
    pub facing: [f64; 3],
    pub outline: [f64; OUTLINE_NUMBERS],
    pub scope: Scope,
}

impl Default for Shape {
    fn default() -> Self {
        Self::zeroed()
    }
}

impl Item for Shape {
    const FIELDS: &'static [Field] = &[
        outline("outline", offset_of!(Self, outline)).says(
            "Outline",
            "The shape that smoke fills, as traced from a text, a picture or a mesh.",
        ),
        number("speed", "m/s", [0.0, 50.0], 0.0, offset_of!(Self, speed))
            .starts_at(2.0)
            .says(
                "Speed",
                "Greatest speed at which smoke goes to where the shape lacks it; 0 disables the shape.",
            ),
        number("hold", "1/s", [0.0, 100.0], 6.0, offset_of!(Self, hold)).says(
            "Hold",
            "How strongly smoke within the shape is slowed down, so that it does not rise or fall out of it.",
        ),
        number("size", "m", LENGTH, 2.0, offset_of!(Self, size)).says("Size", "Longer side of the shape."),
        number("depth", "m", LENGTH, 0.3, offset_of!(Self, depth)).says("Depth", "Thickness of the shape."),
        vector("position", "m", PLACE, [0.0, 1.5, 0.0], offset_of!(Self, position))
            .says("Position", "Centre of the shape."),
        vector("facing", "1", DIRECTION, [0.0, 0.0, 1.0], offset_of!(Self, facing))
            .says("Facing", "Direction from which the shape is read."),
    ];

    const LABEL: &'static str = "Shape";

    const SCOPE: Group = Group::new(offset_of!(Self, scope), Scope::FIELDS);
}
