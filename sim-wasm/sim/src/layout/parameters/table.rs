//! The sections of the table in order.

use crate::layout::parameters::collider::ColliderParameters;
use crate::layout::parameters::density_stop::Stop;
use crate::layout::parameters::emitter::Emitter;
use crate::layout::parameters::field::Meta;
use crate::layout::parameters::forces::Lists;
use crate::layout::parameters::forces::for_each_force_list;
use crate::layout::parameters::item::{Item, List, Slot, item};
use crate::layout::parameters::item::{meta, value};
use crate::layout::parameters::settings::{
    Emission, Multipliers, Pattern, Puff, Resistance, SimulationSettings, Style, UniformBuoyancy, UniformGravity,
    Weather,
};
use crate::layout::parameters::shedder::Shedder;

#[cfg(not(target_family = "wasm"))]
use crate::layout::parameters::item::start;

/// A section with items of any type.
pub trait Section: Sync {
    /// First part of its keys.
    fn name(&self) -> &'static str;

    /// Returns true if an index follows the name in its keys.
    fn is_list(&self) -> bool;

    /// Label of one item.
    fn label(&self) -> &'static str;

    /// Initial value of a parameter in a newly added item, unless the parameter has its own.
    #[cfg(not(target_family = "wasm"))]
    fn start(&self, key: &str) -> Option<f64>;

    /// Number of existing items; 1 for a single group.
    fn len(&self, parameters: &Parameters) -> usize;

    /// Extends the list to `len` items.
    fn lengthen(&self, parameters: &mut Parameters, len: usize);

    /// Description and key suffixes of parameter `field`; none beyond the last.
    fn meta(&self, field: usize) -> Option<(&'static Meta, &'static [&'static str])>;

    /// Mutable access to the value in item `index`.
    fn value<'p>(&self, parameters: &'p mut Parameters, index: usize, slot: Slot) -> &'p mut f64;
}

/// A section that exists once.
pub struct Single<I: Item> {
    pub name: &'static str,
    pub of: fn(&mut Parameters) -> &mut I,
}

/// A section that is a list.
pub struct Many<I: Item> {
    pub name: &'static str,
    pub of: fn(&mut Parameters) -> &mut List<I>,
    pub len: fn(&Parameters) -> usize,
}

impl<I: Item> Section for Single<I> {
    fn name(&self) -> &'static str {
        self.name
    }

    fn is_list(&self) -> bool {
        false
    }

    fn label(&self) -> &'static str {
        I::LABEL
    }

    #[cfg(not(target_family = "wasm"))]
    fn start(&self, key: &str) -> Option<f64> {
        start::<I>(key)
    }

    fn len(&self, _parameters: &Parameters) -> usize {
        1
    }

    fn lengthen(&self, _parameters: &mut Parameters, _len: usize) {}

    fn meta(&self, field: usize) -> Option<(&'static Meta, &'static [&'static str])> {
        meta::<I>(field)
    }

    fn value<'p>(&self, parameters: &'p mut Parameters, _index: usize, slot: Slot) -> &'p mut f64 {
        value((self.of)(parameters), slot)
    }
}

impl<I: Item> Section for Many<I> {
    fn name(&self) -> &'static str {
        self.name
    }

    fn is_list(&self) -> bool {
        true
    }

    fn label(&self) -> &'static str {
        I::LABEL
    }

    #[cfg(not(target_family = "wasm"))]
    fn start(&self, key: &str) -> Option<f64> {
        start::<I>(key)
    }

    fn len(&self, parameters: &Parameters) -> usize {
        (self.len)(parameters)
    }

    fn lengthen(&self, parameters: &mut Parameters, len: usize) {
        (self.of)(parameters).lengthen(len);
    }

    fn meta(&self, field: usize) -> Option<(&'static Meta, &'static [&'static str])> {
        meta::<I>(field)
    }

    fn value<'p>(&self, parameters: &'p mut Parameters, index: usize, slot: Slot) -> &'p mut f64 {
        value((self.of)(parameters).item_mut(index), slot)
    }
}

/// All parameters, in the units of the table and within their ranges.
#[derive(Clone, Copy, Debug, PartialEq)]
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
        Self {
            emission: item(),
            puff: item(),
            forces: item(),
            gravity: item(),
            buoyancy: item(),
            drag: item(),
            wind: item(),
            turbulence: item(),
            simulation: item(),
            style: item(),
            emitters: List::default(),
            colliders: List::default(),
            density: List::default(),
            shedders: List::default(),
            lists: Lists::default(),
        }
    }
}

const fn once<I: Item>(name: &'static str, of: fn(&mut Parameters) -> &mut I) -> Single<I> {
    Single { name, of }
}

macro_rules! force_sections {
    ($($(#[$doc:meta])* $list:ident: $Force:ty,)*) => {
        const FORCES: &[&dyn Section] = &[$(
            &Many {
                name: stringify!($list),
                of: |p| &mut p.lists.$list,
                len: |p| p.lists.$list.items().len(),
            },
        )*];
    };
}

for_each_force_list!(force_sections);

const OWN: &[&dyn Section] = &[
    &once("emission", |p| &mut p.emission),
    &once("puff", |p| &mut p.puff),
    &once("forces", |p| &mut p.forces),
    &once("gravity", |p| &mut p.gravity),
    &once("buoyancy", |p| &mut p.buoyancy),
    &once("drag", |p| &mut p.drag),
    &once("wind", |p| &mut p.wind),
    &once("turbulence", |p| &mut p.turbulence),
    &once("simulation", |p| &mut p.simulation),
    &once("style", |p| &mut p.style),
    &Many {
        name: "emitters",
        of: |p| &mut p.emitters,
        len: |p| p.emitters.items().len(),
    },
    &Many {
        name: "colliders",
        of: |p| &mut p.colliders,
        len: |p| p.colliders.items().len(),
    },
    &Many {
        name: "density",
        of: |p| &mut p.density,
        len: |p| p.density.items().len(),
    },
    &Many {
        name: "shedders",
        of: |p| &mut p.shedders,
        len: |p| p.shedders.items().len(),
    },
];

/// All sections.
pub(super) fn sections() -> impl Iterator<Item = &'static dyn Section> {
    OWN.iter().chain(FORCES).copied()
}
