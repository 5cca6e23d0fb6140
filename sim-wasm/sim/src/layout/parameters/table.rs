//! The sections of the table in order.
//!
//! Items consist of numbers only, so a section finds a parameter by its place: code for each type of item would be a part
//! of the module that pages load.

use std::slice::from_mut;

use bytemuck::Zeroable;

use crate::layout::parameters::collider::ColliderParameters;
use crate::layout::parameters::density_stop::Stop;
use crate::layout::parameters::emitter::Emitter;
use crate::layout::parameters::field::Field;
use crate::layout::parameters::forces::Lists;
use crate::layout::parameters::forces::attractor::Attractor;
use crate::layout::parameters::forces::buoyancy::Buoyancy;
use crate::layout::parameters::forces::drag::Drag;
use crate::layout::parameters::forces::explosion::Explosion;
use crate::layout::parameters::forces::flow::Flow;
use crate::layout::parameters::forces::for_each_force_list;
use crate::layout::parameters::forces::gravity::Gravity;
use crate::layout::parameters::forces::jet::Jet;
use crate::layout::parameters::forces::orbit::Orbit;
use crate::layout::parameters::forces::shape::Shape;
use crate::layout::parameters::forces::speed_limit::SpeedLimit;
use crate::layout::parameters::forces::spiral::Spiral;
use crate::layout::parameters::forces::turbulence::Turbulence;
use crate::layout::parameters::forces::vortex::Vortex;
use crate::layout::parameters::forces::wind::Wind;
use crate::layout::parameters::item::{Groups, Item, List, fields, numbers};
use crate::layout::parameters::settings::{
    Emission, Multipliers, Pattern, Puff, Resistance, SimulationSettings, Style, UniformBuoyancy, UniformGravity,
    Weather,
};
use crate::layout::parameters::shedder::Shedder;

/// A single group of parameters, or a list of groups.
#[derive(Clone, Copy, Debug)]
pub struct Section {
    /// First part of its keys.
    pub name: &'static str,
    /// True if an index follows the name in its keys.
    pub is_list: bool,
    /// Label of one item.
    pub label: &'static str,
    /// Initial values of scope parameters in a newly added item, by key.
    pub starts: &'static [(&'static str, f64)],
    groups: Groups,
    /// Count of the numbers of an item.
    stride: usize,
    /// The numbers of all items that can exist.
    numbers: fn(&mut Parameters) -> &mut [f64],
    /// The number of existing items of a list.
    len: Option<fn(&mut Parameters) -> &mut usize>,
}

impl Section {
    const fn new<I: Item>(
        name: &'static str,
        numbers: fn(&mut Parameters) -> &mut [f64],
        len: Option<fn(&mut Parameters) -> &mut usize>,
    ) -> Self {
        Self {
            name,
            is_list: len.is_some(),
            label: I::LABEL,
            starts: I::STARTS,
            groups: I::GROUPS,
            stride: size_of::<I>() / size_of::<f64>(),
            numbers,
            len,
        }
    }

    /// The parameters of an item in order, each with the index of its first number for [`Section::number`].
    pub fn fields(&self) -> impl Iterator<Item = (&'static Field, usize)> {
        fields(&self.groups)
    }

    /// Number of existing items; 1 for a single group.
    pub fn len(&self, parameters: &mut Parameters) -> usize {
        self.len.map_or(1, |len| *len(parameters))
    }

    /// Extends a list to `len` items. A list never becomes shorter.
    pub fn lengthen(&self, parameters: &mut Parameters, len: usize) {
        if let Some(own) = self.len {
            let own = own(parameters);
            *own = len.max(*own);
        }
    }

    /// A number of item `index`, existing or not.
    pub fn number<'p>(&self, parameters: &'p mut Parameters, index: usize, place: usize) -> &'p mut f64 {
        &mut (self.numbers)(parameters)[index * self.stride + place]
    }
}

/// All parameters, in the units of the table and within their ranges.
#[derive(Clone, Copy, Debug, PartialEq, Zeroable)]
pub struct Parameters {
    pub emission: Emission,
    pub puff: Puff,
    pub forces: Multipliers,
    pub gravity: UniformGravity,
    pub buoyancy: UniformBuoyancy,
    pub drag: Resistance,
    pub wind: Weather,
    pub turbulence: Pattern,
    pub simulation: SimulationSettings,
    pub style: Style,
    pub emitters: List<Emitter>,
    pub colliders: List<ColliderParameters>,
    pub density: List<Stop>,
    pub shedders: List<Shedder>,
    /// The lists of forces.
    pub lists: Lists,
}

impl Default for Parameters {
    /// The defaults of the table, with empty lists.
    fn default() -> Self {
        let mut parameters = Self::zeroed();
        for section in sections() {
            for (field, place) in section.fields() {
                for part in 0..field.parts.len() {
                    for item in (section.numbers)(&mut parameters).chunks_exact_mut(section.stride) {
                        item[place + part] = field.meta.default(part);
                    }
                }
            }
        }
        parameters
    }
}

macro_rules! force_sections {
    ($($(#[$doc:meta])* $list:ident: $Force:ty,)*) => {
        const FORCES: &[Section] = &[$(
            Section::new::<$Force>(
                stringify!($list),
                |p| numbers(&mut p.lists.$list.items),
                Some(|p| &mut p.lists.$list.len),
            ),
        )*];
    };
}

for_each_force_list!(force_sections);

macro_rules! own_sections {
    ($($single:ident: $Single:ty,)* ; $($list:ident: $Item:ty,)*) => {
        const OWN: &[Section] = &[
            $(Section::new::<$Single>(stringify!($single), |p| numbers(from_mut(&mut p.$single)), None),)*
            $(Section::new::<$Item>(stringify!($list), |p| numbers(&mut p.$list.items), Some(|p| &mut p.$list.len)),)*
        ];
    };
}

own_sections! {
    emission: Emission,
    puff: Puff,
    forces: Multipliers,
    gravity: UniformGravity,
    buoyancy: UniformBuoyancy,
    drag: Resistance,
    wind: Weather,
    turbulence: Pattern,
    simulation: SimulationSettings,
    style: Style,
    ;
    emitters: Emitter,
    colliders: ColliderParameters,
    density: Stop,
    shedders: Shedder,
}

/// All sections.
pub(super) fn sections() -> impl Iterator<Item = &'static Section> {
    OWN.iter().chain(FORCES)
}
