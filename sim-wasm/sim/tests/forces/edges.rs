//! Every force at its singular points, and in mirrored scenes.

use crate::common::{STILL, newborn, place, simulator, slip, steps};
use sim::Simulator;
use sim::particles::Newborn;

/// One item of each list of forces, about the origin or along its axes.
const ALL: &[(&str, f64)] = &[
    ("winds.0.velocity.x", 0.4),
    ("winds.0.shear", 0.3),
    ("vortices.0.circulation", 2.0),
    ("gravities.0.acceleration.y", -1.0),
    ("buoyancies.0.acceleration", 1.0),
    ("drags.0.rate", 0.3),
    ("drags.0.quadratic", 0.2),
    ("attractors.0.acceleration", 3.0),
    ("orbits.0.acceleration", 2.0),
    ("orbits.1.acceleration", 2.0),
    ("orbits.1.axis.y", 1.0),
    ("spirals.0.turn", 2.0),
    ("spirals.0.inward", 0.3),
    ("spirals.0.along", 0.2),
    ("explosions.0.impulse", 2.0),
    ("explosions.0.envelope.period", 0.25),
    ("jets.0.speed", 2.0),
    ("speedLimits.0.speed", 3.0),
    ("flows.0.speed", 1.5),
    ("flows.0.swirl", 2.0),
    ("flows.0.inflow", 0.5),
    // Smoke in a shape moves by all of its smoke, which amplifies the last bits.
    ("shapes.0.speed", 0.2),
    // A square.
    ("shapes.0.outline.000", 17_955_998_253_921.0),
    ("shapes.0.outline.001", 33.0),
];

fn lists() -> Vec<&'static str> {
    let mut names: Vec<_> = ALL.iter().map(|(key, _)| key.split('.').next().unwrap()).collect();
    names.dedup();
    names
}

fn of_list(name: &str) -> Vec<(&'static str, f64)> {
    let prefix = format!("{name}.");
    let entries = ALL.iter().filter(|(key, _)| key.starts_with(&prefix));
    entries.copied().collect()
}

#[test]
fn every_force_is_finite_at_its_centre_beside_it_and_far_away() {
    let places = [
        [0.0; 3],
        [1e-30, 0.0, 0.0],
        [0.0, 1e-30, -1e-30],
        [1e-20, 1e-20, 1e-20],
        [0.0, 1e-3, 0.0],
        [0.0, 5.0, 0.0],
        [0.0, 0.0, 7.0],
        [5000.0, -5000.0, 5000.0],
        [9999.0, 0.0, 0.0],
    ];
    for name in lists() {
        for integrator in [0.0, 1.0] {
            let settings = [of_list(name), vec![("simulation.integrator", integrator)]].concat();
            let mut simulator = simulator(places.len() as u32, 1, &[STILL, &settings]);
            for place in places {
                simulator.add(&newborn(place));
                assert!(
                    simulator.air_velocity(place).iter().all(|part| part.is_finite()),
                    "{name}: air at {place:?}"
                );
            }
            for _ in 0..40 {
                simulator.step();
                for i in 0..simulator.alive() {
                    let numbers = [place(&simulator, i), slip(&simulator, i)].concat();
                    assert!(
                        numbers.iter().all(|number| number.is_finite() && number.abs() < 2e4),
                        "{name}: {numbers:?}"
                    );
                }
            }
        }
    }
}

#[test]
fn a_force_without_strength_leaves_the_motion_bit_exact() {
    let hash = |settings: &[(&str, f64)]| {
        let mut simulator = simulator(50, 3, &[crate::common::LIVELY, settings]);
        steps(&mut simulator, 60);
        simulator.hash()
    };
    let without = hash(&[]);
    for list in [
        "attractors",
        "orbits",
        "spirals",
        "explosions",
        "jets",
        "speedLimits",
        "flows",
        "shapes",
    ] {
        let key = format!("{list}.0.envelope.start");
        assert_eq!(hash(&[(&key, 0.0)]), without, "{list}");
    }
}

/// Positions, directions and axes of rotation, each with the components that a mirror in x negates.
fn mirrored(settings: &[(&'static str, f64)]) -> Vec<(&'static str, f64)> {
    let flips = |key: &str| {
        let is_sense = key.starts_with("vortices") || key.starts_with("spirals");
        if is_sense && key.contains(".axis.") {
            // An axis of rotation is a pseudovector: x stays, y and z change sign. The code below corrects the rise.
            !key.ends_with(".x")
        } else {
            key.ends_with(".x") && !key.contains(".size.") || key.ends_with("spirals.0.along") || key == "flows.0.swirl"
        }
    };
    let mirror = |key: &str, value: f64| {
        if key.contains(".points.") {
            point(100_000 - (value % 200_000.0) as i32)
        } else if flips(key) {
            -value
        } else {
            value
        }
    };
    settings
        .iter()
        .map(|(key, value)| (*key, mirror(key, *value)))
        .collect()
}

/// A packed point of a flow, 0.5 m high, by its x in millimetres.
fn point(x: i32) -> f64 {
    f64::from(x) + 100_000.0 + 200_000.0 * (100_500.0 + 200_000.0 * 100_300.0)
}

fn cloud(settings: &[(&str, f64)], side: f32) -> Simulator {
    let mut simulator = simulator(200, 1, &[STILL, settings]);
    for k in 0..200_u32 {
        let part = |salt: u32| (f64::from((k * 7919 + salt * 104_729) % 2003) / 1001.5 - 1.0) as f32;
        simulator.add(&Newborn {
            slip: [side * part(4), part(5), part(6)],
            ..newborn([side * 2.0 * part(1), 2.0 * part(2), 2.0 * part(3)])
        });
    }
    simulator
}

#[test]
fn a_mirrored_scene_moves_as_the_mirrored_particles() {
    let slanted = [
        ("winds.0.velocity.z", 0.2),
        ("winds.0.region.shape", 2.0),
        ("winds.0.region.position.x", 0.7),
        ("winds.0.region.size.x", 0.8),
        ("vortices.0.position.x", 0.5),
        ("vortices.0.axis.x", 0.6),
        ("vortices.0.axis.y", 0.3),
        ("vortices.1.circulation", -1.0),
        ("vortices.1.axis.x", -0.4),
        ("gravities.0.acceleration.x", 0.5),
        ("attractors.0.position.x", -1.0),
        ("orbits.0.position.x", 1.2),
        ("orbits.0.position.y", 0.4),
        ("orbits.1.axis.x", 0.5),
        ("spirals.0.position.x", -0.6),
        ("spirals.0.axis.x", 0.7),
        ("spirals.0.axis.y", 0.4),
        ("spirals.0.axis.z", -0.2),
        ("explosions.0.position.x", 0.3),
        ("jets.0.position.x", -0.4),
        ("jets.0.direction.x", 0.8),
        ("jets.0.direction.z", 0.3),
        ("flows.0.position.x", 0.4),
        ("flows.0.points.0", point(-900)),
        ("flows.0.points.1", point(800)),
        ("shapes.0.position.x", -0.3),
        ("shapes.0.facing.x", 0.4),
        ("forces.wind.x", 0.1),
        ("gravity.acceleration", 0.2),
        ("drag.rate", 0.5),
    ];
    // The list includes the default axis of a vortex, so that it is mirrored, too.
    let axes = [
        ("vortices.0.axis.z", 1.0),
        ("vortices.1.axis.z", 1.0),
        ("vortices.1.axis.y", 0.0),
    ];
    let settings = [ALL, &slanted, &axes].concat();
    let mut ours = cloud(&settings, 1.0);
    let mut theirs = cloud(&mirrored(&settings), -1.0);
    for step in 0..90 {
        ours.step();
        theirs.step();
        for i in 0..200 {
            let ([x, y, z], [mx, my, mz]) = (place(&ours, i), place(&theirs, i));
            let off = (x + mx).hypot(y - my).hypot(z - mz);
            assert!(off < 1e-4, "step {step}, particle {i}: {off} m beside its mirror image");
        }
    }
}
