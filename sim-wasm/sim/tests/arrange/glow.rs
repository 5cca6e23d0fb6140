//! Lamps at the glowing parts of smoke.

use crate::common::{LIVELY, STILL, newborn, simulator, steps};
use sim::Simulator;
use sim::arrange::glow::{HEATS, LAMP_FLOATS, LAMPS};
use sim::math::random::Random;
use sim::particles::Newborn;

/// The law of the paper: particles start at full size.
const FULL: &[(&str, f64)] = &[("simulation.integrator", 1.0)];

/// Place, then light and luminance.
type Lamp = [f32; LAMP_FLOATS];

/// Light that rises with temperature from 0, red and half as green.
fn colors() -> Vec<f32> {
    let light = |heat: f32| [heat, 0.5 * heat, 0.0, 0.57 * heat];
    (0..=HEATS).flat_map(|step| light(step as f32 / HEATS as f32)).collect()
}

fn lamps(simulator: &Simulator, blend: f32) -> [Lamp; LAMPS] {
    let numbers = simulator.glow(blend, &colors());
    std::array::from_fn(|lamp| std::array::from_fn(|at| numbers[LAMP_FLOATS * lamp + at]))
}

/// Lamps from low to high.
fn from_below(simulator: &Simulator) -> [Lamp; LAMPS] {
    let mut lamps = lamps(simulator, 1.0);
    lamps.sort_by(|one, other| one[1].total_cmp(&other[1]));
    lamps
}

/// Adds particles within 0.2 m of a place. Returns the sum of their light, and the mean of their places weighted by it.
fn add_group(simulator: &mut Simulator, centre: [f32; 3], count: u32, temperature: f32) -> (f32, [f32; 3]) {
    let mut random = Random::new(count);
    let (mut light, mut sum) = (0.0, [0.0; 3]);
    for _ in 0..count {
        let position = centre.map(|middle| middle + 0.2 * random.signed());
        let size = 0.1 + 0.2 * random.unit();
        simulator.add(&Newborn {
            size,
            temperature,
            ..newborn(position)
        });
        light += temperature * size * size;
        sum = std::array::from_fn(|axis| sum[axis] + temperature * size * size * position[axis]);
    }
    (light, sum.map(|axis| axis / light))
}

fn distance(one: &[f32], other: &[f32]) -> f32 {
    let square = |axis: usize| (one[axis] - other[axis]) * (one[axis] - other[axis]);
    (square(0) + square(1) + square(2)).sqrt()
}

fn still() -> Simulator {
    simulator(2000, 1, &[STILL, FULL])
}

#[test]
fn separate_groups_have_lamps_at_their_weighted_centres_in_any_arrangement() {
    let arrangements = [
        [[0.0, 0.0, 0.0], [0.0, 4.0, 0.0], [0.0, 8.0, 0.0]],
        [[-3.0, 1.0, 0.0], [0.0, 1.1, 0.0], [4.0, 1.2, 0.0]],
        [[-3.0, 0.0, 2.0], [3.0, 0.1, 2.0], [0.0, 0.2, -3.0]],
        [[-2.0, 0.0, 2.0], [0.1, 2.0, 0.0], [2.0, 4.0, -2.0]],
        [[900.0, 2.0, -700.0], [903.0, 2.5, -700.0], [900.0, 6.0, -703.0]],
    ];
    for centres in arrangements {
        let mut simulator = still();
        let groups = [30, 80, 50].map(|count| (count, 1.0 / (count as f32).sqrt()));
        let expected: Vec<_> = centres
            .iter()
            .zip(groups)
            .map(|(centre, (count, heat))| add_group(&mut simulator, *centre, count, heat))
            .collect();
        // Cold smoke has no part.
        add_group(&mut simulator, [0.0, 20.0, 0.0], 100, 0.0);
        for (lamp, (light, centre)) in from_below(&simulator).iter().zip(expected) {
            assert!(distance(lamp, &centre) < 0.02, "{lamp:?} instead of {centre:?}");
            assert!((lamp[4] / light - 1.0).abs() < 0.01, "{lamp:?} instead of {light}");
            assert!((lamp[5] / lamp[4] - 0.5).abs() < 1e-3 && lamp[6] == 0.0, "{lamp:?}");
            assert!((lamp[7] / lamp[4] - 0.57).abs() < 1e-3, "{lamp:?}");
        }
    }
}

fn assert_dark(simulator: &Simulator) {
    assert!(
        lamps(simulator, 1.0)
            .iter()
            .flat_map(|lamp| &lamp[4..])
            .all(|light| *light == 0.0)
    );
}

#[test]
fn nothing_shines_without_heat_or_particles() {
    let mut simulator = still();
    assert_dark(&simulator);
    add_group(&mut simulator, [0.0; 3], 50, 0.0);
    assert_dark(&simulator);
    // A tint has its own colour.
    simulator.add(&Newborn {
        attributes: 1 << 28,
        ..newborn([0.0; 3])
    });
    assert_dark(&simulator);
}

#[test]
fn looks_have_colours_of_their_own() {
    let settings = [
        ("emission.rate", 0.0),
        ("emitters.0.burst.count", 10.0),
        ("emitters.0.look.style", 3.0),
        ("emitters.1.burst.count", 20.0),
        ("emitters.1.look.style", 4.0),
        ("emitters.2.burst.count", 30.0),
        ("emitters.3.burst.count", 40.0),
        ("emitters.3.tint", 2.0),
    ];
    let mut simulator = simulator(2000, 1, &[STILL, FULL, &settings]);
    steps(&mut simulator, 1);
    let area = |look: u32| -> f32 {
        let particles = simulator.particles();
        let own = (0..100).filter(|i| particles.look(*i) == look && particles.tint(*i) == 0);
        let radius = |i: usize| particles.size[i] * (1.0 - particles.age[i] / particles.lifetime[i]);
        own.map(|i| radius(i) * radius(i)).sum()
    };
    let light = |colors: &[f32]| -> f32 {
        let numbers = simulator.glow(1.0, colors);
        (0..LAMPS).map(|lamp| numbers[LAMP_FLOATS * lamp + 7]).sum()
    };
    let of_brightness = |brightness: f32| vec![brightness; 4 * (HEATS + 1)];
    let all = [of_brightness(1.0), of_brightness(10.0), of_brightness(100.0)].concat();
    let expected = area(0) + 10.0 * area(1) + 100.0 * area(2);
    assert!((light(&all) / expected - 1.0).abs() < 1e-3);
    // A look without colours has those of the smoke.
    let fewer = &all[..8 * (HEATS + 1)];
    let expected = area(0) + 10.0 * area(1) + area(2);
    assert!((light(fewer) / expected - 1.0).abs() < 1e-3);
}

#[test]
fn all_light_is_in_the_lamps_and_heat_above_1_counts_as_1() {
    let mut simulator = still();
    add_group(&mut simulator, [0.0; 3], 200, 3.0);
    let sizes = &simulator.particles().size[..simulator.alive()];
    let expected: f32 = sizes.iter().map(|size| size * size).sum();
    let sum: f32 = lamps(&simulator, 1.0).iter().map(|lamp| lamp[4]).sum();
    assert!((sum / expected - 1.0).abs() < 1e-4, "{sum} instead of {expected}");
}

#[test]
fn a_single_particle_and_particles_at_one_place_have_lamps_there() {
    for count in [1, 5] {
        let mut simulator = still();
        for _ in 0..count {
            simulator.add(&newborn([40.0, -3.0, 7.0]));
        }
        for lamp in lamps(&simulator, 1.0) {
            assert!(distance(&lamp, &[40.0, -3.0, 7.0]) < 1e-4, "{lamp:?}");
            assert!(lamp[4] > 0.0);
        }
    }
}

#[test]
fn equal_states_have_equal_lamps_to_the_bit_and_asking_changes_no_state() {
    let scene = || simulator(2000, 3, &[LIVELY, &[("emitters.0.temperature", 1.0)]]);
    let (mut asked, mut other) = (scene(), scene());
    for _ in 0..90 {
        asked.step();
        lamps(&asked, 0.5);
        other.step();
    }
    assert_eq!(asked.hash(), other.hash());
    let mut restored = scene();
    restored.restore(&asked.save()).unwrap();
    let bits = |simulator: &Simulator| lamps(simulator, 0.25).map(|lamp| lamp.map(f32::to_bits));
    assert_eq!(bits(&asked), bits(&other));
    assert_eq!(bits(&asked), bits(&restored));
    assert!(lamps(&asked, 1.0)[0][4] > 0.0);
}

#[test]
fn a_moving_group_moves_its_lamp_as_far_in_each_step_and_between_steps() {
    let mut simulator = still();
    add_group(&mut simulator, [0.0, 4.0, 0.0], 60, 1.0);
    add_group(&mut simulator, [0.0, 8.0, 0.0], 60, 1.0);
    for _ in 0..40 {
        simulator.add(&Newborn {
            slip: [1.2, 0.0, 0.0],
            ..newborn([-1.0, 0.0, 0.0])
        });
    }
    let mut before = from_below(&simulator);
    for _ in 0..120 {
        steps(&mut simulator, 1);
        let now = from_below(&simulator);
        let moves: Vec<f32> = now
            .iter()
            .zip(&before)
            .map(|(now, before)| distance(now, before))
            .collect();
        assert!((moves[0] - 0.02).abs() < 5e-4, "{moves:?}");
        assert!(moves[1] < 2e-3 && moves[2] < 2e-3, "{moves:?}");
        let halfway = lamps(&simulator, 0.5);
        let lowest = halfway.iter().min_by(|one, other| one[1].total_cmp(&other[1])).unwrap();
        assert!(
            (lowest[0] - 0.5 * (now[0][0] + before[0][0])).abs() < 1e-3,
            "{lowest:?}"
        );
        before = now;
    }
}

#[test]
fn the_lamps_of_a_fire_move_and_change_little_from_step_to_step() {
    let fire: &[(&str, f64)] = &[
        ("emission.rate", 70.0),
        ("emission.growthTime", 0.35),
        ("emission.lifetime", 4.4),
        ("emitters.0.radius", 0.3),
        ("emitters.0.speed", 0.7),
        ("emitters.0.temperature", 1.0),
        ("buoyancy.acceleration", 1.7),
        ("buoyancy.coolingTime", 0.85),
        ("turbulence.octaves", 2.0),
        ("turbulence.speed", 0.2),
    ];
    let mut simulator = simulator(800, 5, &[fire]);
    steps(&mut simulator, 180);
    let mut before = lamps(&simulator, 1.0);
    for step in 0..600 {
        steps(&mut simulator, 1);
        let start = lamps(&simulator, 0.0);
        let now = lamps(&simulator, 1.0);
        for lamp in 0..LAMPS {
            // A step at most of a fire that rises by 1 to 2 m/s.
            let way = distance(&now[lamp], &before[lamp]);
            assert!(way < 0.03, "lamp {lamp} moves {way} m in step {step}");
            let change = now[lamp][4] / before[lamp][4];
            assert!(
                (0.94..1.06).contains(&change),
                "the light of lamp {lamp} changes by {change} in step {step}"
            );
            // A picture at the start of a step is that at the end of the one before, but temperatures are those of the end.
            assert!(distance(&start[lamp], &before[lamp]) < 0.02);
        }
        before = now;
    }
}
