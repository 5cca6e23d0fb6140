//! The sections of the table in their order. The forces' lists stand in `forces`, a row each.

use super::section::{Item, List, Many, Section, Single, item};
use super::settings::{Emission, Multipliers, Puff, SimulationSettings, Style, UniformBuoyancy, UniformGravity};
use crate::emission::Emitter;
use crate::forces::drag::Resistance;
use crate::forces::turbulence::Pattern;
use crate::forces::wind::Weather;
use crate::forces::{self, Lists};
use crate::life::density::Stop;
use crate::obstacles::ColliderParameters;
use crate::vortex_particles::shedder::Shedder;

/// Every parameter, in the units of the table. All values are within their ranges, always.
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
    /// The defaults of the table, all lists empty.
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
    OWN.iter().chain(forces::SECTIONS).copied()
}
