//! Random inputs for property tests.
#![allow(dead_code, reason = "each test file uses its own part")]

use proptest::prelude::*;
use sim::Simulator;
use sim::layout::blow::BlowNumbers;
use sim::layout::parameters::rows;

/// An input of the user.
#[derive(Clone, Debug)]
pub enum Act {
    Set(&'static str, f64),
    Resize(u32),
    Steer(u32, f64),
    Blow([f64; 3], [f64; 3], f64, f64),
    Move(u32, [f64; 3]),
    Drag(u32, [f64; 3], f64),
    Release(u32),
    Clear,
    Emit(Option<u64>, f64, f64),
    Look(u32, u32),
}

/// Parameters that users change, with ranges of strong effects.
const TURNED: &[(&str, f64, f64)] = &[
    ("emission.rate", 0.0, 2000.0),
    ("emission.lifetime", 0.1, 3.0),
    ("forces.wind.x", -3.0, 3.0),
    ("forces.turbulence", 0.0, 3.0),
    ("vortices.2.circulation", -5.0, 5.0),
    ("emitters.0.speed", 0.0, 5.0),
    ("emitters.1.perMetre", 0.0, 200.0),
    ("emitters.1.position.x", -0.5, 0.5),
];

/// Any input.
pub fn act() -> impl Strategy<Value = Act> {
    let place = || prop::array::uniform3(-2.0..2.0);
    prop_oneof![
        4 => (prop::sample::select(TURNED), 0.0..1.0).prop_map(|((key, min, max), s)| Act::Set(key, min + s * (max - min))),
        1 => (0..2_u32).prop_map(|integrator| Act::Set("simulation.integrator", f64::from(integrator))),
        1 => (50_u32..600).prop_map(Act::Resize),
        2 => (0_u32..8, -1.0..1.0).prop_map(|(channel, value)| Act::Steer(channel, value)),
        2 => (place(), place(), 0.05..2.0, 0.02..1.0).prop_map(|(at, way, radius, time)| Act::Blow(at, way, radius, time)),
        2 => (0_u32..2, place()).prop_map(|(rigid, place)| Act::Move(rigid, place)),
        2 => (0_u32..2, place(), 1.0..100.0).prop_map(|(rigid, place, stiffness)| Act::Drag(rigid, place, stiffness)),
        1 => (0_u32..2).prop_map(Act::Release),
        1 => Just(Act::Clear),
        2 => (prop::option::of(0_u64..3000), 0.0..0.3, 0.0..400.0).prop_map(|(changed, delay, rate)| Act::Emit(changed, delay, rate)),
        2 => (0..3_u32, 0..4_u32).prop_map(|(emitter, look)| Act::Look(emitter, look)),
    ]
}

/// Applies it to a simulator. With rigids, rigid 0 must be kinematic and rigid 1 dynamic.
pub fn perform(simulator: &mut Simulator, act: &Act) {
    match act {
        Act::Set(key, value) => simulator.input_values(&[(key, *value)]),
        Act::Resize(capacity) => simulator.input_capacity(*capacity),
        Act::Steer(channel, value) => simulator.input_steer(*channel, *value),
        Act::Blow(origin, velocity, radius, seconds) => simulator.input_blow(&BlowNumbers {
            origin: *origin,
            ray: [0.3, 1.0, -0.2],
            velocity: *velocity,
            radius: *radius,
            seconds: *seconds,
        }),
        Act::Clear => simulator.input_clear(),
        Act::Emit(changed, delay, rate) => {
            let start = if changed.is_some() { f64::NAN } else { *delay };
            let emission = [("share", *rate), ("envelope.start", start), ("envelope.duration", 0.2)];
            let look = [("look.drag", 0.5), ("look.style", 9.0)];
            let changes = [&emission[..], if *rate > 200.0 { &look } else { &[] }].concat();
            let numbers = emitter(&changes);
            simulator.input_emission(&numbers, *changed).map(|_| ())
        }
        Act::Look(emitter, look) => {
            let look = f64::from(*look);
            let numbers = [
                ("style", look),
                ("drag", 1.0 + look),
                ("lifetime", 0.4 * look),
                ("dissolve", look),
            ];
            let keys = numbers.map(|(name, _)| format!("emitters.{emitter}.look.{name}"));
            let entries: Vec<_> = keys
                .iter()
                .zip(numbers)
                .map(|(key, (_, value))| (key.as_str(), value))
                .collect();
            simulator.input_values(&entries)
        }
        #[cfg(feature = "rigids")]
        Act::Move(rigid, [x, y, z]) => simulator.input_pose(*rigid, [*x, *y, *z, 0.0, 0.1, 0.0, 1.0]),
        #[cfg(feature = "rigids")]
        Act::Drag(rigid, [x, y, z], stiffness) => simulator.input_drag(*rigid, [0.1, 0.0, 0.0, *x, *y, *z, *stiffness]),
        #[cfg(feature = "rigids")]
        Act::Release(rigid) => simulator.input_release(*rigid),
        #[cfg(not(feature = "rigids"))]
        Act::Move(..) | Act::Drag(..) | Act::Release(_) => Ok(()),
    }
    .unwrap();
}

/// Inputs with the number of steps before each.
pub fn script() -> impl Strategy<Value = Vec<(usize, Act)>> {
    prop::collection::vec((prop_oneof![3 => 0..3_usize, 1 => 3..20_usize], act()), 1..40)
}

/// The numbers of an emitter with the defaults of the table, except `changes` by their keys in `emitters.#`.
pub fn emitter(changes: &[(&str, f64)]) -> Vec<f64> {
    let rows = rows();
    let own: Vec<_> = rows
        .iter()
        .filter_map(|row| Some((row.key.strip_prefix("emitters.#.")?, row.default)))
        .collect();
    for (key, _) in changes {
        assert!(own.iter().any(|(name, _)| name == key), "{key}");
    }
    own.iter()
        .map(|(name, default)| {
            changes
                .iter()
                .find(|(key, _)| key == name)
                .map_or(*default, |change| change.1)
        })
        .collect()
}
