//! Shared helpers.
#![allow(dead_code, reason = "each test file uses its own part")]

pub mod inputs;

use sim::Simulator;
use sim::particles::Newborn;

/// Still air and weightless smoke.
pub const STILL: &[(&str, f64)] = &[
    ("buoyancy.acceleration", 0.0),
    ("gravity.acceleration", 0.0),
    ("drag.rate", 0.0),
    ("turbulence.octaves", 0.0),
];

/// A lively scene with every force, an emitter of each shape and a collider.
pub const LIVELY: &[(&str, f64)] = &[
    ("emission.rate", 600.0),
    ("emission.lifetime", 1.5),
    ("emission.growthTime", 0.3),
    ("emitters.0.speed", 2.0),
    ("emitters.1.shape", 1.0),
    ("emitters.1.position.x", 1.0),
    ("emitters.2.shape", 2.0),
    ("emitters.2.position.x", -1.0),
    ("emitters.2.radius", 0.5),
    ("gravity.acceleration", 0.4),
    ("forces.wind.x", 0.3),
    ("turbulence.speed", 0.5),
    ("turbulence.octaves", 2.0),
    ("vortices.0.circulation", 2.0),
    ("vortices.0.position.y", 1.0),
    ("vortices.1.circulation", -1.0),
    ("vortices.1.axis.x", 1.0),
    ("colliders.0.position.y", -0.5),
    ("colliders.1.shape", 1.0),
    ("colliders.1.position.y", 1.5),
];

/// A simulator with these parameters.
pub fn simulator(capacity: u32, seed: u32, settings: &[&[(&str, f64)]]) -> Simulator {
    let mut simulator = Simulator::new(capacity, seed).unwrap();
    settings.iter().for_each(|entries| simulator.set_all(entries).unwrap());
    simulator
}

/// A particle at rest in the air with a practically unlimited lifetime.
pub fn newborn(position: [f32; 3]) -> Newborn {
    Newborn {
        position,
        slip: [0.0; 3],
        age: 0.0,
        lifetime: 1e6,
        size: 0.2,
        temperature: 1.0,
        attributes: 0,
    }
}

/// Takes `count` steps.
pub fn steps(simulator: &mut Simulator, count: usize) {
    (0..count).for_each(|_| simulator.step());
}

/// Position of particle `i`.
pub fn place(simulator: &Simulator, i: usize) -> [f32; 3] {
    let particles = simulator.particles();
    [particles.x[i], particles.y[i], particles.z[i]]
}

/// Length of a step (s).
pub const STEP: f64 = sim::layout::limits::STEP;

/// A simulator in still air with one particle, which has this slip.
pub fn alone(settings: &[(&str, f64)], position: [f32; 3], slip: [f32; 3]) -> Simulator {
    let mut simulator = simulator(1, 1, &[STILL, settings]);
    simulator.add(&Newborn {
        slip,
        ..newborn(position)
    });
    simulator
}

/// The slip of particle `i`.
pub fn slip(simulator: &Simulator, i: usize) -> [f32; 3] {
    let particles = simulator.particles();
    [particles.sx[i], particles.sy[i], particles.sz[i]]
}

/// Asserts that `value` is `expected` within the relative `tolerance`.
pub fn assert_close(name: &str, value: f64, expected: f64, tolerance: f64) {
    assert!(
        (value - expected).abs() <= tolerance * expected.abs(),
        "{name}: {value}, expected {expected}"
    );
}
