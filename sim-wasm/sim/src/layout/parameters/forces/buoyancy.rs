//! Parameters of `buoyancies.#`.

use std::mem::offset_of;

use bytemuck::{Pod, Zeroable};

use crate::layout::parameters::field::{Field, number};
use crate::layout::parameters::item::{Group, Item, Scope};

/// `buoyancies.#.*`.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct Buoyancy {
    pub acceleration: f64,
    pub scope: Scope,
}

impl Item for Buoyancy {
    const LABEL: &'static str = "Buoyancy";
    const FIELDS: &'static [Field] = &[number(
        "acceleration",
        "m/s2",
        [-100.0, 100.0],
        0.0,
        offset_of!(Self, acceleration),
    )
    .starts_at(1.0)
    .says(
        "Acceleration",
        "Upward acceleration of smoke at temperature 1 in the region.",
    )];

    const SCOPE: Group = Group::new(offset_of!(Self, scope), Scope::FIELDS);
}
