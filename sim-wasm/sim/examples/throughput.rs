//! Prints the native cost of a step and an arrange: `cargo run --release --package sim-tests --example throughput`.
//! Timings of a shared machine: read ratios, not milliseconds.

use std::time::Instant;

use sim::Simulator;
use sim::arrange::view_layout::{VIEW_LENGTH, ViewNumbers};
use sim::math::random::Random;
use sim::particles::Newborn;

const PARTICLES: u32 = 100_000;
const ROUNDS: usize = 60;

/// Settings of all cases: without the default accelerations.
const STILL: &[(&str, f64)] = &[
    ("emission.growthTime", 0.0),
    ("buoyancy.acceleration", 0.0),
    ("turbulence.octaves", 0.0),
    ("drag.rate", 0.0),
];
const SIMPLE: &[(&str, f64)] = &[
    ("gravity.acceleration", 1.0),
    ("buoyancy.acceleration", 1.5),
    ("drag.rate", 1.5),
    ("forces.wind.x", 0.5),
];
const VORTEX: &[(&str, f64)] = &[("vortices.0.circulation", 2.0), ("vortices.0.reach", 20.0)];
/// A stroke of six points through the cloud.
const FLOW: &[(&str, f64)] = &[
    ("flows.0.speed", 1.0),
    ("flows.0.inflow", 0.3),
    ("flows.0.radius", 1.5),
    ("flows.0.points.0", point(-4.0, -4.0, 0.5)),
    ("flows.0.points.1", point(1.0, -3.0, 0.0)),
    ("flows.0.points.2", point(3.0, 0.0, -1.0)),
    ("flows.0.points.3", point(-2.0, 1.0, 0.0)),
    ("flows.0.points.4", point(-3.0, 3.0, 2.0)),
    ("flows.0.points.5", point(4.0, 4.0, 1.0)),
];
const OCTAVE: &[(&str, f64)] = &[
    ("turbulence.speed", 0.3),
    ("turbulence.scale", 1.0),
    ("turbulence.octaves", 1.0),
    ("turbulence.evolution", 0.3),
];

fn main() {
    report("nothing", &[STILL]);
    let plain = report("simple forces", &[STILL, SIMPLE]);
    let vortex = report("simple forces, vortex", &[STILL, SIMPLE, VORTEX]);
    let flow = report("simple forces, flow", &[STILL, SIMPLE, FLOW]);
    let all = report(
        "simple forces, all in a flow",
        &[STILL, SIMPLE, FLOW, &[("flows.0.radius", 9.0)]],
    );
    println!("all of them in a flow: {:.2}", (all - plain) / (vortex - plain));
    let added = (flow - plain) / (vortex - plain);
    println!("a flow adds {added:.2} of what a vortex adds; particles are in no order, a third of them in the flow");
    report("six forces, one octave", &[STILL, SIMPLE, VORTEX, OCTAVE]);
}

/// A packed point of a stroke, in metres.
const fn point(x: f64, y: f64, z: f64) -> f64 {
    const fn part(metres: f64) -> f64 {
        metres * 1000.0 + 100_000.0
    }
    part(x) + 200_000.0 * (part(y) + 200_000.0 * part(z))
}

/// Prints a case. Returns the milliseconds of a step.
fn report(name: &str, settings: &[&[(&str, f64)]]) -> f64 {
    let mut simulator = cloud();
    for entries in settings {
        simulator.set_all(entries).expect("the cases stay within the ranges");
    }
    let step = best(|| simulator.step());
    let view = view();
    let arrange = best(|| {
        simulator.arrange(&view).expect("the view is well-formed");
    });
    assert_eq!(simulator.alive(), PARTICLES as usize);
    let rate = f64::from(PARTICLES) / step;
    println!("{name:24} step {step:6.3} ms, {rate:8.0} particles/ms; arrange {arrange:6.3} ms");
    step
}

fn cloud() -> Simulator {
    let mut random = Random::new(1);
    let mut simulator = Simulator::new(PARTICLES, 1).expect("the capacity is allowed");
    for _ in 0..PARTICLES {
        simulator.add(&Newborn {
            position: std::array::from_fn(|_| random.signed() * 5.0),
            slip: [0.0; 3],
            age: 0.0,
            lifetime: 1000.0,
            size: 0.2,
            temperature: 1.0,
            attributes: random.bits(),
        });
    }
    simulator
}

fn view() -> [f32; VIEW_LENGTH] {
    let view = ViewNumbers {
        blend: 0.5,
        clip_from_world: std::array::from_fn(|i| if i % 5 == 0 { 1.0 } else { 0.0 }),
        direction: [0.0, 0.0, -1.0],
        reach: 1.0,
        ..ViewNumbers::default()
    };
    view.to_array()
}

/// The best round in milliseconds, each over a few calls. Other processes can only slow a round down.
fn best(mut call: impl FnMut()) -> f64 {
    const CALLS: u32 = 3;
    (0..ROUNDS)
        .map(|_| {
            let start = Instant::now();
            (0..CALLS).for_each(|_| call());
            start.elapsed().as_secs_f64() * 1000.0 / f64::from(CALLS)
        })
        .fold(f64::INFINITY, f64::min)
}
