//! Parameters of `winds.#`.

use std::mem::offset_of;

use bytemuck::{Pod, Zeroable};

use crate::layout::parameters::field::{Field, PLACE, number, vector};
use crate::layout::parameters::item::{Group, Item, Scope};
use crate::layout::parameters::settings::Weather;

/// `winds.#.*`.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct Wind {
    pub velocity: [f64; 3],
    pub weather: Weather,
    pub scope: Scope,
}

impl Item for Wind {
    const LABEL: &'static str = "Wind";
    const FIELDS: &'static [Field] = &[
        vector("velocity", "m/s", [-50.0, 50.0], [0.0; 3], offset_of!(Self, velocity))
            .starts_at(0.5)
            .says("Wind", "Velocity of the wind."),
        number("gusts", "m/s", [0.0, 20.0], 0.0, offset_of!(Self, weather.gusts))
            .says("Gusts", "Typical (root mean square) speed of gusts along the wind."),
        number("gustTime", "s", [0.1, 60.0], 2.0, offset_of!(Self, weather.gust_time))
            .says("Gust time", "How long a strong gust lasts."),
        number("shear", "1/m", [-10.0, 10.0], 0.0, offset_of!(Self, weather.shear)).says(
            "Shear",
            "Increase of the wind speed per metre of height, as a fraction.",
        ),
        number("height", "m", PLACE, 0.0, offset_of!(Self, weather.height))
            .says("Shear height", "Height at which shear has no effect."),
    ];

    const SCOPE: Group = Group::new(offset_of!(Self, scope), Scope::FIELDS);
}
