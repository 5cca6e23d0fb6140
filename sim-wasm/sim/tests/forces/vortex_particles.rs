//! Vortex particles: velocity, interaction, spreading, death and saving.

use crate::common::{LIVELY, STILL, newborn, place, simulator, steps};
use sim::Simulator;
use sim::forces::vortex_particles::{MAX_VORTEX_PARTICLES, VortexParticle};
use sim::layout::limits::STEP;
use sim::math::random::Random;

/// A vortex particle at the origin that rotates about z at 1 rad/s and neither spreads nor noticeably fades.
const ONE: VortexParticle = VortexParticle {
    position: [0.0; 3],
    swirl: [0.0, 0.0, 1.0],
    core_radius: 0.5,
    viscosity: 0.0,
    age: 0.0,
    lifetime: 1e4,
};

fn still(capacity: u32) -> Simulator {
    simulator(capacity, 1, &[STILL])
}

/// Air velocity at `place` by `particle`, from the formula.
fn closed_form(particle: &VortexParticle, place: [f32; 3]) -> [f64; 3] {
    let [x, y, z] = std::array::from_fn(|i| f64::from(place[i]) - f64::from(particle.position[i]));
    let [wx, wy, wz] = particle.swirl.map(f64::from);
    let q = (x * x + y * y + z * z) / (9.0 * f64::from(particle.core_radius).powi(2));
    let g = if q < 1.0 {
        (1.0 - q).powi(2) * (1.0 - 2.56 * q + 2.88 * q * q)
    } else {
        0.0
    };
    [wy * z - wz * y, wz * x - wx * z, wx * y - wy * x].map(|part| part * g)
}

fn distance(a: [f32; 3], b: [f64; 3]) -> f64 {
    (0..3).map(|i| (f64::from(a[i]) - b[i]).powi(2)).sum::<f64>().sqrt()
}

fn anywhere(random: &mut Random, half: f32) -> [f32; 3] {
    std::array::from_fn(|_| random.signed() * half)
}

/// Many vortex particles of all sizes in an elongated box.
fn many(count: usize, seed: u32) -> Vec<VortexParticle> {
    let mut random = Random::new(seed);
    (0..count)
        .map(|_| {
            let [x, y, z] = anywhere(&mut random, 2.0);
            VortexParticle {
                position: [4.0 * x, y, 0.5 * z],
                swirl: anywhere(&mut random, 3.0),
                core_radius: 0.05 + 0.3 * random.unit(),
                ..ONE
            }
        })
        .collect()
}

#[test]
fn one_follows_the_velocity_formula_and_ends_at_its_reach() {
    let mut simulator = still(4);
    let particle = VortexParticle {
        position: [1.0, 2.0, -3.0],
        swirl: [0.5, -1.0, 2.0],
        ..ONE
    };
    assert!(simulator.add_vortex_particle(&particle));
    let mut random = Random::new(2);
    for _ in 0..2000 {
        let offset = anywhere(&mut random, 1.2);
        let place = std::array::from_fn(|i| particle.position[i] + offset[i]);
        let expected = closed_form(&particle, place);
        let got = simulator.air_velocity(place);
        assert!(
            distance(got, expected) < 2e-6,
            "at {place:?}: {got:?}, not {expected:?}"
        );
    }
    for direction in 0..3 {
        let mut place = particle.position;
        place[direction] += 1.5001;
        assert_eq!(simulator.air_velocity(place), [0.0; 3]);
    }
    // Across the axis, compared with the Gaussian that it approximates.
    let mut alone = still(4);
    alone.add_vortex_particle(&ONE);
    for i in 0..150 {
        let r = 0.01 * i as f32;
        let gaussian = r * (-r * r / 0.5).exp();
        let [_, y, _] = alone.air_velocity([r, 0.0, 0.0]);
        assert!((y - gaussian).abs() < 0.06 * 0.303, "at {r}: {y}, not near {gaussian}");
    }
}

#[test]
fn the_divergence_vanishes() {
    let mut simulator = still(4);
    for particle in many(200, 5) {
        simulator.add_vortex_particle(&particle);
    }
    let mut random = Random::new(6);
    let (mut of_divergence, mut of_gradient) = (0.0_f64, 0.0_f64);
    for _ in 0..500 {
        let place = anywhere(&mut random, 1.0);
        let slope = |axis: usize, part: usize| {
            let at = |step: f32| {
                let mut place = place;
                place[axis] += step;
                f64::from(simulator.air_velocity(place)[part])
            };
            // A difference of fourth order: the remainder is rounding.
            (8.0 * (at(0.01) - at(-0.01)) - (at(0.02) - at(-0.02))) / 0.12
        };
        let divergence: f64 = (0..3).map(|axis| slope(axis, axis)).sum();
        of_divergence += divergence * divergence;
        of_gradient += (0..9).map(|i| slope(i / 3, i % 3).powi(2)).sum::<f64>();
    }
    assert!(of_gradient > 500.0, "there is hardly a flow: {of_gradient}");
    let share = (of_divergence / of_gradient).sqrt();
    assert!(share < 2e-3, "divergence is {share} of the gradient");
}

#[test]
fn all_together_equal_the_sum_of_each() {
    for seed in 0..4 {
        let all = many(1000, seed);
        let mut simulator = still(4);
        for particle in &all {
            simulator.add_vortex_particle(particle);
        }
        let mut random = Random::new(seed + 100);
        let mut fastest = 0.0_f64;
        for _ in 0..1000 {
            let [x, y, z] = anywhere(&mut random, 2.0);
            let place = [4.4 * x, 1.1 * y, 0.7 * z];
            let each = all.iter().map(|particle| closed_form(particle, place));
            let sum = each.fold([0.0; 3], |sum, part| std::array::from_fn(|i| sum[i] + part[i]));
            let got = simulator.air_velocity(place);
            assert!(distance(got, sum) < 2e-5, "at {place:?}: {got:?}, not {sum:?}");
            fastest = fastest.max(distance([0.0; 3], sum));
        }
        assert!(fastest > 1.0, "there is hardly a flow: {fastest}");
    }
}

#[test]
fn smoke_circles_about_one() {
    let mut simulator = still(4);
    simulator.add_vortex_particle(&ONE);
    simulator.add(&newborn([0.4, 0.0, 0.2]));
    let speed = distance([0.0; 3], closed_form(&ONE, [0.4, 0.0, 0.2]));
    steps(&mut simulator, 240);
    let [x, y, z] = place(&simulator, 0).map(f64::from);
    let angle = speed / 0.4 * 240.0 * STEP;
    assert!(angle > 2.0, "it has to come around: {angle}");
    // With the midpoint rule the radius grows by a^4 / 8 for a rotation by a, and the angle lags.
    let expected = [0.4 * angle.cos(), 0.4 * angle.sin(), 0.2];
    assert!(
        distance([x, y, z].map(|part| part as f32), expected) < 2e-3,
        "{:?}, not {expected:?}",
        [x, y, z]
    );
}

#[test]
fn two_of_opposite_rotation_travel_together() {
    let mut simulator = still(4);
    for side in [1.0, -1.0] {
        simulator.add_vortex_particle(&VortexParticle {
            position: [0.25 * side, 1.0, 0.0],
            swirl: [0.0, 0.0, 4.0 * side],
            ..ONE
        });
    }
    // Each one moves at the speed of the air that the other one rotates.
    let particle = VortexParticle {
        swirl: [0.0, 0.0, 4.0],
        ..ONE
    };
    let speed = closed_form(&particle, [0.5, 0.0, 0.0])[1];
    steps(&mut simulator, 120);
    let down = 1.0 - f64::from(simulator.vortex_particle(0).unwrap().position[1]);
    assert!(
        (down - speed * 2.0).abs() < 1e-3 * speed,
        "{down} in 2 s at {speed} m/s"
    );
    for (index, side) in [(0, 1.0), (1, -1.0)] {
        let [x, y, z] = simulator.vortex_particle(index).unwrap().position;
        assert!((x - 0.25 * side).abs() < 1e-6 && z == 0.0, "it left its way: {x} {z}");
        assert!((f64::from(y) - (1.0 - down)).abs() < 1e-6);
    }
}

#[test]
fn two_of_the_same_rotation_orbit_each_other() {
    let mut simulator = still(4);
    for side in [1.0, -1.0] {
        simulator.add_vortex_particle(&VortexParticle {
            position: [0.25 * side, 0.0, 0.0],
            swirl: [0.0, 0.0, 4.0],
            ..ONE
        });
    }
    // A rotation by a in each step widens the circle by a^4 / 4, here 0.6 % in all; Euler's rule would double its size.
    steps(&mut simulator, 600);
    let [x, y, _] = simulator.vortex_particle(0).unwrap().position;
    assert!((x.hypot(y) - 0.25).abs() < 0.0025, "they drifted apart: {}", x.hypot(y));
}

#[test]
fn wind_turbulence_and_vortices_move_them_like_smoke() {
    let forces = [
        ("forces.wind.x", 0.7),
        ("turbulence.octaves", 2.0),
        ("turbulence.speed", 0.5),
        ("vortices.0.circulation", 2.0),
    ];
    let mut simulator = simulator(4, 1, &[STILL, &forces]);
    let start = [0.3, 0.5, 0.1];
    simulator.add(&newborn(start));
    simulator.add_vortex_particle(&VortexParticle { position: start, ..ONE });
    steps(&mut simulator, 120);
    let particle = simulator.vortex_particle(0).unwrap();
    // A first step has no previous displacement to continue, so the two differ only by rounding.
    let apart = distance(particle.position, place(&simulator, 0).map(f64::from));
    assert!(apart < 1e-4, "{apart} m apart after 2 s");
    assert!(distance(particle.position, start.map(f64::from)) > 0.3);
}

#[test]
fn one_spreads_and_fades_by_its_closed_form() {
    let particle = VortexParticle {
        core_radius: 0.2,
        viscosity: 0.01,
        lifetime: 4.0,
        ..ONE
    };
    let mut simulator = still(4);
    simulator.add_vortex_particle(&particle);
    for step in 1..240 {
        simulator.step();
        let t = f64::from(step) * STEP;
        let radius = (0.04 + 0.02 * t).sqrt();
        let swirl = (0.2 / radius).powi(5) * (1.0 - (t / 4.0).powi(2)).powi(2);
        let now = VortexParticle {
            swirl: [0.0, 0.0, swirl as f32],
            core_radius: radius as f32,
            ..ONE
        };
        let place = [0.15, 0.2, 0.1];
        let (got, expected) = (simulator.air_velocity(place), closed_form(&now, place));
        assert!(distance(got, expected) < 3e-6, "after {t} s: {got:?}, not {expected:?}");
    }
    // Sixtieths add up to 4 s except for rounding.
    steps(&mut simulator, 2);
    assert_eq!(
        (simulator.vortex_particles(), simulator.air_velocity([0.1; 3])),
        (0, [0.0; 3])
    );
}

#[test]
fn the_multiplier_of_vortices_multiplies_them() {
    let mut simulator = still(4);
    simulator.add_vortex_particle(&ONE);
    let before = simulator.air_velocity([0.3, 0.0, 0.0]);
    simulator.set("forces.vortex", 0.0).unwrap();
    assert_eq!(simulator.air_velocity([0.3, 0.0, 0.0]), [0.0; 3]);
    simulator.set("forces.vortex", 2.0).unwrap();
    assert_eq!(simulator.air_velocity([0.3, 0.0, 0.0]), before.map(|part| part * 2.0));
}

#[test]
fn beyond_the_limit_the_oldest_are_removed() {
    let mut simulator = still(4);
    for number in 0..MAX_VORTEX_PARTICLES + 10 {
        simulator.add_vortex_particle(&VortexParticle {
            position: [number as f32, 0.0, 0.0],
            ..ONE
        });
    }
    assert_eq!(simulator.vortex_particles(), MAX_VORTEX_PARTICLES);
    let first = simulator.vortex_particle(0).unwrap().position[0];
    let last = simulator.vortex_particle(MAX_VORTEX_PARTICLES - 1).unwrap().position[0];
    assert_eq!((first, last), (10.0, MAX_VORTEX_PARTICLES as f32 + 9.0));
    assert_eq!(simulator.vortex_particle(MAX_VORTEX_PARTICLES), None);
}

#[test]
fn an_invalid_vortex_particle_is_rejected() {
    let mut simulator = still(4);
    for broken in [
        VortexParticle {
            position: [f32::NAN, 0.0, 0.0],
            ..ONE
        },
        VortexParticle {
            position: [0.0, 2e5, 0.0],
            ..ONE
        },
        VortexParticle {
            swirl: [0.0, f32::INFINITY, 0.0],
            ..ONE
        },
        VortexParticle {
            core_radius: 0.0,
            ..ONE
        },
        VortexParticle { viscosity: -1.0, ..ONE },
        VortexParticle { lifetime: 0.0, ..ONE },
        VortexParticle { age: -0.1, ..ONE },
        VortexParticle { age: 1e4, ..ONE },
    ] {
        assert!(!simulator.add_vortex_particle(&broken), "{broken:?} was taken");
    }
    assert_eq!(simulator.vortex_particles(), 0);
}

/// Wind with a shedder, vortex particles of all sizes, and smoke.
fn with_vortex_particles() -> Simulator {
    let shedders = [
        ("shedders.0.rate", 300.0),
        ("shedders.0.strength", 1.0),
        ("shedders.0.scatter", 1.0),
        ("shedders.0.lifetime", 2.0),
        ("shedders.1.rate", 7.7),
        ("shedders.1.alternate", 1.0),
        ("shedders.1.extent.y", 0.3),
    ];
    let mut simulator = simulator(500, 3, &[LIVELY, &shedders]);
    steps(&mut simulator, 100);
    assert!(simulator.vortex_particles() > 480);
    simulator
}

#[test]
fn they_continue_from_a_restored_state_to_the_same_hash() {
    let mut original = with_vortex_particles();
    let mut restored = still(500);
    restored.add_vortex_particle(&ONE);
    restored.restore(&original.save()).unwrap();
    assert_eq!(restored.save(), original.save());
    for _ in 0..30 {
        steps(&mut original, 5);
        steps(&mut restored, 5);
        assert_eq!(restored.hash(), original.hash());
        assert_eq!(restored.air_velocity([0.1; 3]), original.air_velocity([0.1; 3]));
    }
    original.restore(&still(3).save()).unwrap();
    assert_eq!((original.vortex_particles(), original.hash()), (0, still(3).hash()));
}

#[test]
fn the_hash_includes_them() {
    let simulator = with_vortex_particles();
    let saved = simulator.save();
    let mut other = still(500);
    other.restore(&saved).unwrap();
    assert_eq!(other.hash(), simulator.hash());
    other.add_vortex_particle(&ONE);
    assert_ne!(other.hash(), simulator.hash());
}

#[test]
fn a_shedder_that_sheds_nothing_changes_no_smoke() {
    let mut plain = simulator(500, 3, &[LIVELY]);
    let mut with = simulator(500, 3, &[LIVELY, &[("shedders.0.perSpeed", 1.0)]]);
    steps(&mut plain, 60);
    steps(&mut with, 60);
    assert_eq!(plain.particles().x, with.particles().x);
    assert_eq!(with.vortex_particles(), 0);
}
