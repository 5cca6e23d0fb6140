//! Parameters of `speedLimits.#`.

use std::mem::offset_of;

use bytemuck::{Pod, Zeroable};

use crate::layout::parameters::field::{Field, number};
use crate::layout::parameters::item::{Group, Item, Scope};

/// `speedLimits.#.*`.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct SpeedLimit {
    pub speed: f64,
    pub scope: Scope,
}

impl Item for SpeedLimit {
    const FIELDS: &'static [Field] = &[number("speed", "m/s", [0.0, 1000.0], 1000.0, offset_of!(Self, speed))
        .starts_at(0.5)
        .says("Maximum speed", "Maximum speed of smoke in the region.")];

    const LABEL: &'static str = "Speed limit";

    const SCOPE: Group = Group::new(offset_of!(Self, scope), Scope::FIELDS);
}
