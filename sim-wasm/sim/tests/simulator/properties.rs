//! Property tests: after any accepted input every state of every step is valid.

use crate::common::steps;
use proptest::prelude::*;
use proptest::test_runner::{Config, TestRunner};
use sim::Simulator;
use sim::layout::parameters::{Row, rows};
use sim::life::WORLD_RADIUS;

const PARTICLES: u32 = 300;
const STEPS: usize = 120;
/// Number of cases in the ordinary test and in the long one.
const CASES: u32 = 96;
const MANY_CASES: u32 = 4000;

type Entries = Vec<(String, f64)>;

/// Both ends, the middle of the range, and values near the default and near zero, where most divisors are.
fn any_number(row: &Row) -> impl Strategy<Value = f64> + use<> {
    let (min, max, whole, default) = (row.meta.min, row.meta.max, row.meta.whole, row.default);
    let cubed = move |s: f64| s * s * s * (max - min) * 0.01;
    let number = prop_oneof![
        Just(min),
        Just(max),
        min..=max,
        (0.0..1.0_f64).prop_map(move |s| min + cubed(s)),
        (-1.0..1.0_f64).prop_map(move |s| (default + cubed(s)).clamp(min, max)),
        (-1.0..1.0_f64).prop_map(move |s| cubed(s).clamp(min, max)),
    ];
    number.prop_map(move |number| if whole { number.round() } else { number })
}

/// Any part of the table, from a few of its parameters to nearly all, for up to three items of each list.
fn any_parameters() -> impl Strategy<Value = Entries> {
    let table = rows();
    let entry = |(index, row): (usize, &Row)| {
        let key = row.key.replace('#', &(index % 3).to_string());
        any_number(row).prop_map(move |number| (key.clone(), number))
    };
    let count = table.len() * 2;
    let entries: Vec<_> = table.iter().cycle().take(count).enumerate().map(entry).collect();
    let chances = prop::collection::vec(0.0..1.0_f64, count);
    (entries, chances, 0.0..1.0_f64).prop_map(|(entries, chances, share)| {
        let used = entries
            .into_iter()
            .zip(chances)
            .filter(|(_, chance)| *chance < share * share);
        used.map(|(entry, _)| entry).collect()
    })
}

/// A simulator with these parameters and some births.
fn simulator(entries: &Entries, seed: u32) -> Simulator {
    let mut simulator = Simulator::new(PARTICLES, seed).unwrap();
    let births = [("emission.rate", 600.0), ("emitters.0.share", 1.0)];
    let rest = entries.iter().map(|(key, value)| (key.as_str(), *value));
    let bundle: Vec<_> = births.into_iter().chain(rest).collect();
    simulator.set_all(&bundle).unwrap();
    simulator
}

/// After each step all living particles have finite numbers and are in the world.
fn stays_sound(simulator: &mut Simulator) -> Result<(), TestCaseError> {
    for step in 0..STEPS {
        steps(simulator, 1);
        let alive = simulator.alive();
        let particles = simulator.particles();
        for (number, column) in particles.float_columns().into_iter().enumerate() {
            let sound = column[..alive].iter().all(|value| value.is_finite());
            prop_assert!(sound, "step {step}: column {number} is not finite");
        }
        for i in 0..alive {
            let place = crate::common::place(simulator, i);
            let square: f64 = place.iter().map(|part| f64::from(*part).powi(2)).sum();
            // The simulator squares in single precision.
            let inside = square.sqrt() <= f64::from(WORLD_RADIUS) * (1.0 + 1e-6);
            prop_assert!(inside, "step {step}: {place:?} is outside of the world");
        }
        for index in 0..simulator.vortex_particles() {
            let particle = simulator.vortex_particle(index).unwrap();
            let numbers = particle.position.into_iter().chain(particle.swirl);
            prop_assert!(numbers.into_iter().all(f32::is_finite), "step {step}: {particle:?}");
        }
        let air = simulator.air_velocity([0.0; 3]);
        prop_assert!(air.iter().all(|part| part.is_finite()), "step {step}: air {air:?}");
    }
    Ok(())
}

/// Runs `test` with `cases` of `strategy`.
fn check<S: Strategy>(cases: u32, strategy: S, test: impl Fn(S::Value) -> Result<(), TestCaseError>) {
    let config = Config {
        cases,
        failure_persistence: None,
        ..Config::default()
    };
    if let Err(error) = TestRunner::new(config).run(&strategy, test) {
        panic!("{error}");
    }
}

fn keep_particles_in_the_world(cases: u32) {
    check(cases, (any_parameters(), any::<u32>()), |(entries, seed)| {
        stays_sound(&mut simulator(&entries, seed))
    });
}

#[test]
fn any_parameters_keep_every_particle_finite_and_in_the_world() {
    keep_particles_in_the_world(CASES);
}

#[test]
#[ignore = "takes minutes"]
fn many_parameters_keep_every_particle_finite_and_in_the_world() {
    keep_particles_in_the_world(MANY_CASES);
}

#[cfg(feature = "rigids")]
mod rigids {
    use super::*;
    use sim::collide::contact::Action;
    use sim::math::pose::Pose;
    use sim::math::vector::Vector;
    use sim::rigids::{Grab, RigidDescription, RigidKind, RigidPart, RigidShape};

    /// Within a few metres, so that items interact, or anywhere in the world.
    fn any_place() -> impl Strategy<Value = [f32; 3]> {
        prop_oneof![
            8 => prop::array::uniform3(-2.0..2.0_f32),
            1 => prop::array::uniform3(-1e4..=1e4_f32),
        ]
    }

    fn any_pose() -> impl Strategy<Value = Pose> {
        let rotation = prop::array::uniform4(-1.0..1.0_f32).prop_filter("a direction", |q| length(q) > 0.01);
        (any_place(), rotation).prop_map(|([x, y, z], rotation)| Pose {
            position: Vector::new(x, y, z),
            rotation: rotation.map(|part| part / length(&rotation)),
        })
    }

    fn length(parts: &[f32]) -> f32 {
        parts.iter().map(|part| part * part).sum::<f32>().sqrt()
    }

    fn any_length() -> impl Strategy<Value = f32> {
        prop_oneof![6 => 0.05..2.0_f32, 1 => Just(1e-3), 1 => Just(1e3)]
    }

    fn any_single_shape() -> impl Strategy<Value = RigidShape> {
        prop_oneof![
            any_length().prop_map(|radius| RigidShape::Ball { radius }),
            [any_length(), any_length(), any_length()].prop_map(|half_extents| RigidShape::Cuboid { half_extents }),
            (any_length(), any_length()).prop_map(|(half_height, radius)| RigidShape::Capsule { half_height, radius }),
            (any_length(), any_length()).prop_map(|(half_height, radius)| RigidShape::Cylinder { half_height, radius }),
            any_length().prop_map(|size| RigidShape::ConvexHull {
                vertices: corners(size)
            }),
            (any_length(), any::<bool>()).prop_map(|(size, is_closed)| RigidShape::Trimesh {
                vertices: corners(size),
                indices: FACES[..if is_closed { 4 } else { 2 }].to_vec(),
            }),
        ]
    }

    const FACES: [[u32; 3]; 4] = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]];

    /// Of a tetrahedron.
    fn corners(size: f32) -> Vec<[f32; 3]> {
        vec![[0.0; 3], [size, 0.0, 0.0], [0.0, size, 0.0], [0.0, 0.0, size]]
    }

    fn any_shape() -> impl Strategy<Value = RigidShape> {
        let part = (any_single_shape(), any_pose()).prop_map(|(shape, pose)| RigidPart { shape, pose });
        let compound = prop::collection::vec(part, 1..4).prop_map(|parts| RigidShape::Compound { parts });
        prop_oneof![4 => any_single_shape(), 1 => compound]
    }

    fn any_description() -> impl Strategy<Value = RigidDescription> {
        let kind = prop_oneof![
            Just(RigidKind::Fixed),
            Just(RigidKind::Kinematic),
            Just(RigidKind::Dynamic)
        ];
        let action = prop_oneof![
            Just(Action::Bounce),
            Just(Action::Kill),
            (1..=15_u8).prop_map(Action::Tint)
        ];
        let touch = (0.0..=1.0_f32, 0.0..=1.0_f32, 0.01..=1e5_f32, action);
        let air = (0.0..=10.0_f32, 0.0..=10.0_f32);
        (kind, any_shape(), any_pose(), touch, air).prop_map(|(kind, shape, pose, touch, air)| {
            let (restitution, friction, density, action) = touch;
            RigidDescription {
                restitution,
                friction,
                density,
                action,
                boundary_layer: air.0,
                feels_smoke: air.1,
                ..RigidDescription::new(kind, shape, pose)
            }
        })
    }

    #[derive(Clone, Debug)]
    struct World {
        entries: Entries,
        seed: u32,
        rigids: Vec<RigidDescription>,
        poses: Vec<Pose>,
        target: [f32; 3],
    }

    fn any_world() -> impl Strategy<Value = World> {
        let rigids = prop::collection::vec(any_description(), 1..5);
        let poses = prop::collection::vec(any_pose(), 4);
        (any_parameters(), any::<u32>(), rigids, poses, any_place()).prop_map(
            |(entries, seed, rigids, poses, target)| World {
                entries,
                seed,
                rigids,
                poses,
                target,
            },
        )
    }

    /// Adds everything that is accepted. Not accepted are shapes without volume in single precision. Rigids that can
    /// move are sent to a pose.
    fn furnish(simulator: &mut Simulator, world: &World) {
        for (description, pose) in world.rigids.iter().zip(&world.poses) {
            if let Ok(index) = simulator.rigids_mut().add(description.clone()) {
                let _ = simulator.rigids_mut().move_to(index, *pose);
            }
        }
        let [x, y, z] = world.target;
        let grab = Grab {
            anchor: Vector::ZERO,
            target: Vector::new(x, y, z),
            stiffness: 30.0,
        };
        let _ = simulator.rigids_mut().drag(0, grab);
    }

    fn keep_all_in_the_world(cases: u32) {
        check(cases, any_world(), |world| {
            let mut simulator = simulator(&world.entries, world.seed);
            furnish(&mut simulator, &world);
            stays_sound(&mut simulator)?;
            let poses = simulator.rigids().poses();
            prop_assert!(
                poses.iter().all(|number| number.is_finite()),
                "a rigid has no pose: {poses:?}"
            );
            Ok(())
        });
    }

    #[test]
    fn any_rigids_keep_every_particle_finite_and_in_the_world() {
        keep_all_in_the_world(CASES);
    }

    #[test]
    #[ignore = "takes minutes"]
    fn many_rigids_keep_every_particle_finite_and_in_the_world() {
        keep_all_in_the_world(MANY_CASES);
    }

    #[test]
    fn most_rigids_of_these_worlds_are_accepted() {
        use std::cell::Cell;
        let (given, taken) = (Cell::new(0), Cell::new(0));
        check(CASES, any_world(), |world| {
            let mut simulator = simulator(&Vec::new(), world.seed);
            furnish(&mut simulator, &world);
            given.set(given.get() + world.rigids.len());
            taken.set(taken.get() + simulator.rigids().count());
            Ok(())
        });
        assert!(taken.get() * 10 > given.get() * 9, "{} of {}", taken.get(), given.get());
    }
}
