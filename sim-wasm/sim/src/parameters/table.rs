//! The rows of the table.

use std::f64::consts::PI;

use super::{LIST_LIMIT, ListName, Parameters};

type Field = fn(&mut Parameters, usize) -> &mut f64;

/// One parameter, or one of each item of a list.
#[derive(Clone, Copy)]
pub struct Row {
    /// The key; `#` stands for the index in a list.
    pub key: &'static str,
    pub min: f64,
    pub max: f64,
    pub default: f64,
    /// Only whole numbers.
    pub whole: bool,
    /// Unit, `1` for plain numbers.
    pub unit: &'static str,
    /// The list that the parameter belongs to, if any.
    pub list: Option<ListName>,
    field: Field,
}

impl Row {
    /// Where `parameters` keep it; `index` counts within the list.
    pub fn field<'p>(&self, parameters: &'p mut Parameters, index: usize) -> &'p mut f64 {
        (self.field)(parameters, index)
    }

    /// How many values the row can stand for.
    pub fn length(&self) -> usize {
        if self.list.is_some() { LIST_LIMIT } else { 1 }
    }

    /// The index that `key` gives for `#`, 0 without a list; none where `key` is not this row's.
    pub fn index_in(&self, key: &str) -> Option<usize> {
        let Some((before, after)) = self.key.split_once('#') else {
            return (key == self.key).then_some(0);
        };
        let digit = key.strip_prefix(before)?.strip_suffix(after)?;
        let index = (digit.len() == 1).then(|| digit.parse::<usize>().ok())??;
        (index < LIST_LIMIT).then_some(index)
    }

    const fn whole(mut self) -> Self {
        self.whole = true;
        self
    }

    const fn of(mut self, list: ListName) -> Self {
        self.list = Some(list);
        self
    }
}

const fn row(key: &'static str, unit: &'static str, range: [f64; 2], default: f64, field: Field) -> Row {
    Row {
        key,
        min: range[0],
        max: range[1],
        default,
        whole: false,
        unit,
        list: None,
        field,
    }
}

const fn emitter(key: &'static str, unit: &'static str, range: [f64; 2], default: f64, field: Field) -> Row {
    row(key, unit, range, default, field).of(ListName::Emitters)
}

const fn vortex(key: &'static str, unit: &'static str, range: [f64; 2], default: f64, field: Field) -> Row {
    row(key, unit, range, default, field).of(ListName::Vortices)
}

const fn collider(key: &'static str, unit: &'static str, range: [f64; 2], default: f64, field: Field) -> Row {
    row(key, unit, range, default, field).of(ListName::Colliders)
}

const MULTIPLIER: [f64; 2] = [0.0, 10.0];
const SHARE: [f64; 2] = [0.0, 1.0];
const PLACE: [f64; 2] = [-1000.0, 1000.0];
const DIRECTION: [f64; 2] = [-1000.0, 1000.0];
const WIND: [f64; 2] = [-50.0, 50.0];
const LENGTH: [f64; 2] = [0.001, 1000.0];

/// Every parameter.
pub const ROWS: &[Row] = &[
    row("emission.rate", "particles/s", [0.0, 20_000.0], 120.0, |p, _| {
        &mut p.emission.rate
    }),
    row("emission.lifetime", "s", [0.1, 60.0], 4.0, |p, _| {
        &mut p.emission.lifetime
    }),
    row("emission.growthTime", "s", [0.0, 30.0], 0.0, |p, _| {
        &mut p.emission.growth_time
    }),
    row("puff.size", "1", [0.1, 4.0], 1.0, |p, _| &mut p.emission.puff_size),
    row("puff.variations", "1", [1.0, 255.0], 4.0, |p, _| {
        &mut p.emission.puff_variations
    })
    .whole(),
    row("forces.gravity", "1", MULTIPLIER, 1.0, |p, _| &mut p.forces.gravity),
    row("forces.buoyancy", "1", MULTIPLIER, 1.0, |p, _| &mut p.forces.buoyancy),
    row("forces.turbulence", "1", MULTIPLIER, 1.0, |p, _| {
        &mut p.forces.turbulence
    }),
    row("forces.vortex", "1", MULTIPLIER, 1.0, |p, _| &mut p.forces.vortex),
    row("forces.drag", "1", MULTIPLIER, 1.0, |p, _| &mut p.forces.drag),
    row("forces.wind.x", "m/s", WIND, 0.0, |p, _| &mut p.forces.wind[0]),
    row("forces.wind.y", "m/s", WIND, 0.0, |p, _| &mut p.forces.wind[1]),
    row("forces.wind.z", "m/s", WIND, 0.0, |p, _| &mut p.forces.wind[2]),
    row("gravity.acceleration", "m/s2", [0.0, 100.0], 0.0, |p, _| {
        &mut p.gravity_acceleration
    }),
    row("buoyancy.acceleration", "m/s2", [0.0, 100.0], 1.5, |p, _| {
        &mut p.buoyancy.acceleration
    }),
    row("buoyancy.coolingTime", "s", [0.01, 1000.0], 4.0, |p, _| {
        &mut p.buoyancy.cooling_time
    }),
    row("drag.rate", "1/s", [0.0, 1000.0], 1.5, |p, _| &mut p.drag_rate),
    row("turbulence.speed", "m/s", [0.0, 20.0], 0.0, |p, _| {
        &mut p.turbulence.speed
    }),
    row("turbulence.scale", "m", [0.05, 100.0], 1.0, |p, _| {
        &mut p.turbulence.scale
    }),
    row("turbulence.octaves", "1", [0.0, 4.0], 1.0, |p, _| {
        &mut p.turbulence.octaves
    })
    .whole(),
    row("turbulence.evolution", "1/s", [0.0, 10.0], 0.3, |p, _| {
        &mut p.turbulence.evolution
    }),
    row("simulation.integrator", "1", [0.0, 1.0], 0.0, |p, _| &mut p.integrator).whole(),
    emitter("emitters.#.shape", "1", [0.0, 2.0], 0.0, |p, i| {
        &mut p.emitters.items[i].shape
    })
    .whole(),
    emitter("emitters.#.position.x", "m", PLACE, 0.0, |p, i| {
        &mut p.emitters.items[i].position[0]
    }),
    emitter("emitters.#.position.y", "m", PLACE, 0.0, |p, i| {
        &mut p.emitters.items[i].position[1]
    }),
    emitter("emitters.#.position.z", "m", PLACE, 0.0, |p, i| {
        &mut p.emitters.items[i].position[2]
    }),
    emitter("emitters.#.direction.x", "1", DIRECTION, 0.0, |p, i| {
        &mut p.emitters.items[i].direction[0]
    }),
    emitter("emitters.#.direction.y", "1", DIRECTION, 1.0, |p, i| {
        &mut p.emitters.items[i].direction[1]
    }),
    emitter("emitters.#.direction.z", "1", DIRECTION, 0.0, |p, i| {
        &mut p.emitters.items[i].direction[2]
    }),
    emitter("emitters.#.radius", "m", [0.0, 100.0], 0.1, |p, i| {
        &mut p.emitters.items[i].radius
    }),
    emitter("emitters.#.speed", "m/s", [0.0, 50.0], 0.5, |p, i| {
        &mut p.emitters.items[i].speed
    }),
    emitter("emitters.#.speedVariation", "1", SHARE, 0.2, |p, i| {
        &mut p.emitters.items[i].speed_variation
    }),
    emitter("emitters.#.spread", "rad", [0.0, PI], 0.3, |p, i| {
        &mut p.emitters.items[i].spread
    }),
    emitter("emitters.#.size", "m", [0.001, 20.0], 0.3, |p, i| {
        &mut p.emitters.items[i].size
    }),
    emitter("emitters.#.sizeVariation", "1", SHARE, 0.2, |p, i| {
        &mut p.emitters.items[i].size_variation
    }),
    emitter("emitters.#.lifetimeVariation", "1", SHARE, 0.2, |p, i| {
        &mut p.emitters.items[i].lifetime_variation
    }),
    emitter("emitters.#.temperature", "1", [0.0, 4.0], 1.0, |p, i| {
        &mut p.emitters.items[i].temperature
    }),
    emitter("emitters.#.share", "1", [0.0, 1000.0], 1.0, |p, i| {
        &mut p.emitters.items[i].share
    }),
    vortex("vortices.#.position.x", "m", PLACE, 0.0, |p, i| {
        &mut p.vortices.items[i].position[0]
    }),
    vortex("vortices.#.position.y", "m", PLACE, 0.0, |p, i| {
        &mut p.vortices.items[i].position[1]
    }),
    vortex("vortices.#.position.z", "m", PLACE, 0.0, |p, i| {
        &mut p.vortices.items[i].position[2]
    }),
    vortex("vortices.#.axis.x", "1", DIRECTION, 0.0, |p, i| {
        &mut p.vortices.items[i].axis[0]
    }),
    vortex("vortices.#.axis.y", "1", DIRECTION, 0.0, |p, i| {
        &mut p.vortices.items[i].axis[1]
    }),
    vortex("vortices.#.axis.z", "1", DIRECTION, 1.0, |p, i| {
        &mut p.vortices.items[i].axis[2]
    }),
    vortex("vortices.#.circulation", "m2/s", [-200.0, 200.0], 0.0, |p, i| {
        &mut p.vortices.items[i].circulation
    }),
    vortex("vortices.#.coreRadius", "m", [0.01, 50.0], 0.25, |p, i| {
        &mut p.vortices.items[i].core_radius
    }),
    vortex("vortices.#.reach", "m", [0.05, 1000.0], 2.0, |p, i| {
        &mut p.vortices.items[i].reach
    }),
    collider("colliders.#.shape", "1", [0.0, 3.0], 0.0, |p, i| {
        &mut p.colliders.items[i].shape
    })
    .whole(),
    collider("colliders.#.position.x", "m", PLACE, 0.0, |p, i| {
        &mut p.colliders.items[i].position[0]
    }),
    collider("colliders.#.position.y", "m", PLACE, 0.0, |p, i| {
        &mut p.colliders.items[i].position[1]
    }),
    collider("colliders.#.position.z", "m", PLACE, 0.0, |p, i| {
        &mut p.colliders.items[i].position[2]
    }),
    collider("colliders.#.axis.x", "1", DIRECTION, 0.0, |p, i| {
        &mut p.colliders.items[i].axis[0]
    }),
    collider("colliders.#.axis.y", "1", DIRECTION, 1.0, |p, i| {
        &mut p.colliders.items[i].axis[1]
    }),
    collider("colliders.#.axis.z", "1", DIRECTION, 0.0, |p, i| {
        &mut p.colliders.items[i].axis[2]
    }),
    collider("colliders.#.halfExtents.x", "m", LENGTH, 0.5, |p, i| {
        &mut p.colliders.items[i].half_extents[0]
    }),
    collider("colliders.#.halfExtents.y", "m", LENGTH, 0.5, |p, i| {
        &mut p.colliders.items[i].half_extents[1]
    }),
    collider("colliders.#.halfExtents.z", "m", LENGTH, 0.5, |p, i| {
        &mut p.colliders.items[i].half_extents[2]
    }),
    collider("colliders.#.radius", "m", LENGTH, 0.5, |p, i| {
        &mut p.colliders.items[i].radius
    }),
    collider("colliders.#.restitution", "1", SHARE, 0.1, |p, i| {
        &mut p.colliders.items[i].restitution
    }),
    collider("colliders.#.friction", "1", SHARE, 0.2, |p, i| {
        &mut p.colliders.items[i].friction
    }),
];
