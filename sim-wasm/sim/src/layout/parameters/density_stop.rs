//! Parameters of `density.#`.

use std::mem::offset_of;

use bytemuck::{Pod, Zeroable};

use crate::layout::parameters::field::{Field, SHARE, number};
use crate::layout::parameters::item::Item;

/// `density.#.*`.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct Stop {
    pub age: f64,
    pub value: f64,
}

impl Item for Stop {
    const LABEL: &'static str = "Density stop";
    const FIELDS: &'static [Field] = &[
        number("age", "1", SHARE, 0.0, offset_of!(Self, age))
            .says("Age", "Age of a puff, as a fraction of its lifetime."),
        number("value", "1", SHARE, 1.0, offset_of!(Self, value)).says(
            "Density",
            "Fraction of its size that a puff has at this age. Without stops it shrinks evenly.",
        ),
    ];
}
