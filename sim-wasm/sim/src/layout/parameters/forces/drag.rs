//! Parameters of `drags.#`.

use std::mem::offset_of;

use bytemuck::{Pod, Zeroable};

use crate::layout::parameters::field::{Field, number};
use crate::layout::parameters::item::{Group, Item, Scope};

/// `drags.#.*`: drag in a region.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct Drag {
    pub rate: f64,
    pub quadratic: f64,
    pub scope: Scope,
}

impl Item for Drag {
    const LABEL: &'static str = "Drag";
    const FIELDS: &'static [Field] = &[
        number("rate", "1/s", [0.0, 1000.0], 0.0, offset_of!(Self, rate))
            .starts_at(2.0)
            .says("Drag", "How strongly the air of the region carries smoke."),
        number("quadratic", "1/m", [0.0, 1000.0], 0.0, offset_of!(Self, quadratic)).says(
            "Quadratic drag",
            "Drag that grows with speed, so it slows fast smoke most.",
        ),
    ];

    const SCOPE: Group = Group::new(offset_of!(Self, scope), Scope::FIELDS);
}
