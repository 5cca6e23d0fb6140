//! Parameters of `gravities.#`.

use std::mem::offset_of;

use bytemuck::{Pod, Zeroable};

use crate::layout::parameters::field::{Field, vector};
use crate::layout::parameters::item::{Group, Item, Scope};

/// `gravities.#.*`.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct Gravity {
    pub acceleration: [f64; 3],
    pub scope: Scope,
}

impl Item for Gravity {
    const LABEL: &'static str = "Gravity";
    const FIELDS: &'static [Field] = &[vector(
        "acceleration",
        "m/s2",
        [-100.0, 100.0],
        [0.0; 3],
        offset_of!(Self, acceleration),
    )
    .starts_at(1.0)
    .says("Acceleration", "Acceleration of all smoke in the region.")];

    const SCOPE: Group = Group::new(offset_of!(Self, scope), Scope::FIELDS);
}
