//! Shedding of vortex particles.

use crate::common::{STILL, simulator, steps};
use sim::Simulator;
use sim::forces::vortex_particles::VortexParticle;
use sim::layout::limits::STEP;
use sim::math::pose::Pose;
use sim::math::vector::Vector;
use sim::rigids::{RigidDescription, RigidKind, RigidShape};

/// Speed of the rigid (m/s).
const SPEED: f32 = 3.0;

/// Sheds alternately at the upper and the lower side of a sphere of radius 0.2 m.
const STREET: &[(&str, f64)] = &[
    ("shedders.0.rate", 24.0),
    ("shedders.0.rigid", 0.0),
    ("shedders.0.alternate", 1.0),
    ("shedders.0.extent.y", 0.2),
    ("shedders.0.perSpeed", 0.5),
    ("shedders.0.coreRadius", 0.1),
    ("shedders.0.viscosity", 0.0),
    ("shedders.0.jitter", 0.0),
    ("shedders.0.lifetime", 60.0),
];

/// A kinematic ball at the origin, with a shedder.
fn ball(settings: &[(&str, f64)]) -> Simulator {
    seeded_ball(1, settings)
}

fn seeded_ball(seed: u32, settings: &[(&str, f64)]) -> Simulator {
    let mut simulator = simulator(4, seed, &[STILL, STREET, settings]);
    let shape = RigidShape::Ball { radius: 0.2 };
    let description = RigidDescription::new(RigidKind::Kinematic, shape, Pose::at(Vector::ZERO));
    simulator.rigids_mut().add(description).unwrap();
    simulator
}

/// Moves along x for `count` steps, rotated by `angle` about z.
fn go(simulator: &mut Simulator, from: f32, speed: f32, count: usize, angle: f32) {
    for step in 1..=count {
        let x = from + speed * step as f32 * STEP as f32;
        let rotation = [0.0, 0.0, (angle / 2.0).sin(), (angle / 2.0).cos()];
        let position = Vector::new(x, 0.0, 0.0);
        simulator.rigids_mut().move_to(0, Pose { position, rotation }).unwrap();
        simulator.step();
    }
}

fn all(simulator: &Simulator) -> Vec<VortexParticle> {
    (0..simulator.vortex_particles())
        .map(|index| simulator.vortex_particle(index).unwrap())
        .collect()
}

/// Peak air speed around it (m/s), with the sign of its rotation about z.
fn speed_of(particle: &VortexParticle) -> f32 {
    0.594_107 * particle.swirl[2] * particle.core_radius
}

#[test]
fn the_number_shed_follows_rate_and_time() {
    for (rate, count) in [(24.0, 48), (0.7, 1), (333.0, 666), (0.0, 0)] {
        let mut simulator = ball(&[("shedders.0.rate", rate)]);
        go(&mut simulator, 0.0, SPEED, 120, 0.0);
        assert_eq!(simulator.vortex_particles(), count, "at {rate} a second for 2 s");
    }
}

#[test]
fn strength_follows_the_speed_through_the_air() {
    for speed in [1.0, 3.0] {
        let mut simulator = ball(&[("shedders.0.strength", 0.25), ("shedders.0.alternate", 0.0)]);
        go(&mut simulator, 0.0, speed, 60, 0.0);
        for particle in all(&simulator) {
            let expected = 0.25 + 0.5 * speed;
            let got = speed_of(&particle);
            assert!((got - expected).abs() < 1e-3 * expected, "{got} m/s, not {expected}");
        }
    }
    // With a wind of the same velocity no air passes. Wind past a rigid at rest equals motion through still air.
    let mut carried = ball(&[("forces.wind.x", f64::from(SPEED))]);
    go(&mut carried, 0.0, SPEED, 60, 0.0);
    assert_eq!(carried.vortex_particles(), 0);
    let mut anchored = ball(&[("forces.wind.x", -f64::from(SPEED))]);
    steps(&mut anchored, 60);
    assert_eq!(anchored.vortex_particles(), 24);
    assert!((speed_of(&all(&anchored)[0]).abs() - 0.5 * SPEED).abs() < 1e-3);
}

#[test]
fn at_rest_nothing_is_shed() {
    let mut simulator = ball(&[]);
    steps(&mut simulator, 60);
    assert_eq!(simulator.vortex_particles(), 0);
}

#[test]
fn the_shear_layers_rotate_as_the_wake_drags_them() {
    for (speed, angle) in [(SPEED, 0.0), (-SPEED, 0.0), (SPEED, std::f32::consts::PI)] {
        // Weak enough to stay on their sides.
        let mut simulator = ball(&[("shedders.0.perSpeed", 0.01), ("shedders.0.rate", 0.0)]);
        go(&mut simulator, 0.0, 0.0, 10, angle);
        simulator.set("shedders.0.rate", 24.0).unwrap();
        go(&mut simulator, 0.0, speed, 60, angle);
        let mut sides = [0_u32; 2];
        for particle in all(&simulator) {
            let [_, y, z] = particle.position;
            assert!((y.abs() - 0.2).abs() < 0.03 && z.abs() < 1e-5, "shed at {y} {z}");
            // Air in the wake follows the ball: for motion towards +x the vortices above rotate counter-clockwise.
            let turn = speed_of(&particle) * y.signum() * speed.signum();
            assert!(turn > 0.0, "the wrong sense at {y} at {speed} m/s, turned by {angle}");
            sides[usize::from(y > 0.0)] += 1;
        }
        assert!(sides[0].abs_diff(sides[1]) <= 1 && sides[0] > 10, "{sides:?}");
    }
}

#[test]
fn the_vortices_of_both_wing_tips_have_opposite_rotation() {
    let wing = [
        ("shedders.0.extent.y", 0.0),
        ("shedders.0.extent.z", 1.0),
        ("shedders.0.axis.x", 1.0),
        ("shedders.0.axis.z", 0.0),
    ];
    let mut simulator = ball(&wing);
    go(&mut simulator, 0.0, SPEED, 60, 0.0);
    assert_eq!(simulator.vortex_particles(), 24);
    for particle in all(&simulator) {
        let [_, _, z] = particle.position;
        assert!(particle.swirl[0] * z > 0.0 && (z.abs() - 1.0).abs() < 0.1);
    }
}

#[test]
fn they_are_born_along_the_whole_path() {
    // Twenty per step, each at its own time, so the gaps within a step equal those between steps. With their axes
    // along the line they do not move each other.
    let line = [
        ("shedders.0.rate", 1200.0),
        ("shedders.0.alternate", 0.0),
        ("shedders.0.extent.y", 0.0),
        ("shedders.0.perSpeed", 0.0),
        ("shedders.0.strength", 0.1),
        ("shedders.0.axis.x", 1.0),
        ("shedders.0.axis.z", 0.0),
    ];
    let mut simulator = ball(&line);
    go(&mut simulator, 0.0, SPEED, 40, 0.0);
    let places: Vec<f32> = all(&simulator).iter().map(|particle| particle.position[0]).collect();
    assert_eq!(places.len(), 800);
    let gap = SPEED / 1200.0;
    for pair in places.windows(2) {
        assert!(
            (pair[1] - pair[0] - gap).abs() < 0.1 * gap,
            "a gap of {}",
            pair[1] - pair[0]
        );
    }
}

#[test]
fn the_seed_scatters_them() {
    let scattered = [
        ("shedders.0.scatter", 0.3),
        ("shedders.0.jitter", 0.5),
        ("shedders.0.perSpeed", 0.0),
        ("shedders.0.strength", 0.1),
    ];
    let run = |seed: u32| {
        let mut simulator = seeded_ball(seed, &scattered);
        go(&mut simulator, 0.0, SPEED, 60, 0.0);
        for particle in all(&simulator) {
            let [_, y, z] = particle.position;
            assert!((y.abs() - 0.2).hypot(z) < 0.4, "born too far away, at {y} {z}");
            let [wx, wy, wz] = particle.swirl;
            assert!(wx.hypot(wy) < 0.6 * wz.abs(), "turned too far: {:?}", particle.swirl);
        }
        let spread = all(&simulator)
            .iter()
            .map(|particle| particle.swirl[0].abs())
            .sum::<f32>();
        assert!(spread > 1.0, "hardly turned: {spread}");
        simulator.hash()
    };
    assert_eq!(run(1), run(1));
    assert_ne!(run(1), run(2));
}

#[test]
fn envelope_and_region_limit_time_and_place() {
    let mut pulsing = ball(&[
        ("shedders.0.envelope.start", 0.5),
        ("shedders.0.envelope.duration", 0.5),
    ]);
    go(&mut pulsing, 0.0, SPEED, 90, 0.0);
    assert_eq!(pulsing.vortex_particles(), 12);
    let within = [
        ("shedders.0.region.shape", 1.0),
        ("shedders.0.region.size.x", 0.1),
        ("shedders.0.region.softness", 0.0),
    ];
    // The region moves with the ball: the sides of the ball are always outside it.
    let mut simulator = ball(&within);
    go(&mut simulator, 0.0, SPEED, 60, 0.0);
    assert_eq!(simulator.vortex_particles(), 0);
}
