//! Density curves, growth by entrainment, and continuity of the radius.

use crate::common::{STILL, newborn, simulator, steps};
use proptest::prelude::*;
use sim::Simulator;
use sim::arrange::view_layout::ViewNumbers;
use sim::layout::parameters::Parameters;
use sim::particles::Newborn;
use sim::particles::entrainment::MAX_SIZE;
use sim::particles::radius::{MIN_GROWTH_TIME, RadiusLaw};

const STEP: f64 = 1.0 / 60.0;

fn parameters(stops: &[(f64, f64)]) -> Parameters {
    let mut parameters = Parameters::default();
    for (index, (age, value)) in stops.iter().enumerate() {
        parameters.set(&format!("density.{index}.age"), *age).unwrap();
        parameters.set(&format!("density.{index}.value"), *value).unwrap();
    }
    parameters
}

/// Density at the fraction `worn` of a lifetime long enough that growth is complete.
fn density(stops: &[(f64, f64)], worn: f64) -> f64 {
    let lifetime = 1000.0;
    f64::from(RadiusLaw::new(&parameters(stops)).radius(1.0, (worn * lifetime) as f32, lifetime as f32))
}

#[test]
fn a_curve_goes_straight_from_stop_to_stop() {
    let stops = [(0.2, 0.5), (0.4, 1.0), (0.8, 0.25)];
    let cases = [
        (0.1, 0.5),
        (0.2, 0.5),
        (0.3, 0.75),
        (0.4, 1.0),
        (0.6, 0.625),
        (0.8, 0.25),
        (0.9, 0.25),
        (0.98, 0.25),
        (0.99, 0.2),
        (0.995, 0.1),
        (1.0, 0.0),
    ];
    for (worn, expected) in cases {
        let found = density(&stops, worn);
        assert!((found - expected).abs() < 1e-4, "{found}, not {expected}, at {worn}");
    }
}

/// Radius and erosion of a particle of size 1 at the fraction `worn` of its life, with `emission.dissolve` `erode`.
fn eroded(stops: &[(f64, f64)], worn: f64) -> (f64, f64) {
    let mut parameters = parameters(stops);
    parameters.set("emission.dissolve", 1.0).unwrap();
    let (law, lifetime) = (RadiusLaw::new(&parameters), 1000.0);
    let age = (worn * lifetime) as f32;
    let radius = law.radius(1.0, age, lifetime as f32);
    // Rows have the erosion between 0 and 1.
    (
        f64::from(radius),
        f64::from(law.erosion(law.dissolution(age, lifetime as f32))).clamp(0.0, 1.0),
    )
}

#[test]
fn an_eroded_puff_keeps_its_radius_until_its_erosion_is_complete() {
    let cases = [
        (0.2, 1.0, 0.0),
        (0.25, 1.0, 0.0),
        (0.5, 1.0, 0.5),
        (0.75, 1.0, 1.0),
        (0.875, 0.5, 1.0),
        (1.0, 0.0, 1.0),
    ];
    for (worn, radius, erosion) in cases {
        let found = eroded(&[], worn);
        assert!((found.0 - radius).abs() < 1e-4, "radius {} at {worn}", found.0);
        assert!((found.1 - erosion).abs() < 1e-4, "erosion {} at {worn}", found.1);
        assert_eq!(RadiusLaw::new(&parameters(&[])).erosion(erosion as f32), 0.0);
    }
    // By a curve that ends earlier.
    let (radius, erosion) = eroded(&[(0.0, 1.0), (0.4, 0.5), (0.6, 0.125)], 0.4);
    assert!((radius - 1.0).abs() < 1e-4 && (erosion - 0.5).abs() < 1e-4);
    assert!((eroded(&[(0.0, 1.0), (0.4, 0.5), (0.6, 0.125)], 0.7).0 - 0.5).abs() < 1e-4);
}

#[test]
fn stops_are_taken_in_the_order_of_their_ages() {
    let ordered = [(0.1, 0.3), (0.5, 0.9), (0.7, 0.4)];
    let scrambled = [ordered[2], ordered[0], ordered[1]];
    for worn in 0..100 {
        let worn = f64::from(worn) / 100.0;
        assert_eq!(density(&ordered, worn).to_bits(), density(&scrambled, worn).to_bits());
    }
}

#[test]
fn one_stop_is_a_constant_and_none_is_the_papers_law() {
    for worn in [0.01, 0.3, 0.6, 0.94] {
        assert!((density(&[(0.6, 0.7)], worn) - 0.7).abs() < 1e-6);
        assert!((density(&[], worn) - (1.0 - worn)).abs() < 1e-6);
        assert!((density(&[(0.0, 1.0), (1.0, 0.0)], worn) - (1.0 - worn)).abs() < 1e-6);
    }
}

#[test]
fn stops_of_the_same_age_are_separated() {
    let stops = [(0.5, 0.0), (0.5, 1.0), (0.5, 0.5)];
    for (worn, expected) in [
        (0.5, 0.0),
        (0.51, 0.5),
        (0.52, 1.0),
        (0.53, 0.75),
        (0.54, 0.5),
        (0.6, 0.5),
    ] {
        let found = density(&stops, worn);
        assert!((found - expected).abs() < 1e-3, "{found}, not {expected}, at {worn}");
    }
}

/// Radii of a particle at `parts` times within each step, from birth to death.
fn drawn(simulator: &mut Simulator, parts: usize) -> Vec<f32> {
    let mut view = ViewNumbers {
        clip_from_world: std::array::from_fn(|i| if i % 5 == 0 { 1.0 } else { 0.0 }),
        direction: [0.0, 0.0, -1.0],
        reach: 1.0,
        ..ViewNumbers::default()
    };
    let mut radii = Vec::new();
    while simulator.alive() > 0 {
        simulator.step();
        for part in 0..parts {
            view.blend = part as f32 / parts as f32;
            let rows = simulator.arrange(&view.to_array()).unwrap();
            radii.push(if rows == 0 { 0.0 } else { simulator.place()[0][3] });
        }
    }
    radii
}

fn greatest_change(radii: &[f32]) -> f64 {
    let change = radii.windows(2).map(|pair| f64::from((pair[1] - pair[0]).abs()));
    change.fold(0.0, f64::max)
}

#[test]
fn only_the_papers_integrator_allows_full_size_at_birth() {
    for growth_time in [0.0, 0.01, f64::from(MIN_GROWTH_TIME)] {
        let mut simulator = simulator(1, 1, &[STILL, &[("emission.growthTime", growth_time)]]);
        simulator.add(&Newborn {
            lifetime: 1.0,
            size: 0.4,
            ..newborn([0.0; 3])
        });
        let radii = drawn(&mut simulator, 4);
        let bound = 0.4 * STEP / 4.0 * (1.0 + 2.0 / f64::from(MIN_GROWTH_TIME));
        assert_eq!((radii[0], radii[radii.len() - 1]), (0.0, 0.0));
        let change = greatest_change(&radii);
        assert!(
            change <= bound * 1.001,
            "growth in {growth_time} s: {change}, bound {bound}"
        );
    }
    let mut paper = simulator(1, 1, &[STILL, &[("simulation.integrator", 1.0)]]);
    paper.add(&Newborn {
        lifetime: 1.0,
        size: 0.4,
        ..newborn([0.0; 3])
    });
    assert_eq!(drawn(&mut paper, 4)[0], 0.4);
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 64, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn every_curve_is_continuous(
        stops in prop::collection::vec((0.0..=1.0_f64, 0.0..=1.0_f64), 0..=8),
        // Repeated ages would cause a jump.
        grid in 1..8_i32,
        growth_time in 0.0..3.0_f64,
        lifetime in 0.2..5.0_f64,
    ) {
        let age = |age: f64| (age * f64::from(grid)).round() / f64::from(grid);
        let stops: Vec<(f64, f64)> = stops.into_iter().map(|(at, value)| (age(at), value)).collect();
        let mut simulator = simulator(1, 1, &[STILL, &[("emission.growthTime", growth_time)]]);
        for (key, value) in parameters(&stops).entries().iter().filter(|(key, _)| key.starts_with("density")) {
            simulator.set(key, *value).unwrap();
        }
        simulator.add(&Newborn { lifetime: lifetime as f32, size: 0.4, ..newborn([0.0; 3]) });
        let radii = drawn(&mut simulator, 2);
        let slope = if stops.is_empty() { 1.0 } else { 50.0 };
        let bound = 0.4 * STEP / 2.0 * (slope / lifetime + 2.0 / growth_time.max(0.1));
        prop_assert_eq!((radii[0], radii[radii.len() - 1]), (0.0, 0.0));
        prop_assert!(greatest_change(&radii) <= bound * 1.001 + 1e-6);
        prop_assert!(radii.iter().all(|radius| (0.0..=0.4).contains(radius)));
    }
}

/// A particle of 0.1 m at 3 m/s through still air, after `seconds`.
fn grown(settings: &[(&str, f64)], seconds: f64) -> f64 {
    let mut simulator = simulator(1, 1, &[STILL, &[("emission.entrainment", 0.12)], settings]);
    simulator.add(&Newborn {
        size: 0.1,
        slip: [1.0, 2.0, -2.0],
        ..newborn([50.0, 3.0, -20.0])
    });
    steps(&mut simulator, (seconds * 60.0).round() as usize);
    f64::from(simulator.particles().size[0])
}

#[test]
fn size_grows_with_the_distance_through_the_air() {
    for seconds in [0.5, 2.0, 10.0] {
        let (drag, rate) = (("drag.rate", 1.6), 1.6_f64);
        let slowed = 0.1 + 0.12 * 3.0 * (1.0 - (-rate * seconds).exp()) / rate;
        let free = 0.1 + 0.12 * 3.0 * seconds;
        // The wind carries smoke together with the air around it, so it adds no entrainment.
        let wind = ("forces.wind.x", 8.0);
        for (settings, expected) in [(&[][..], free), (&[drag][..], slowed), (&[drag, wind][..], slowed)] {
            let found = grown(settings, seconds);
            assert!(
                (found / expected - 1.0).abs() < 2e-5,
                "{found}, not {expected}, with {settings:?}"
            );
        }
        assert_eq!(grown(&[("emission.entrainment", 0.0)], seconds), f64::from(0.1_f32));
    }
}

#[test]
fn the_papers_integrator_uses_the_distance_relative_to_the_air() {
    let still = grown(&[("simulation.integrator", 1.0)], 2.0);
    assert!((still / (0.1 + 0.12 * 3.0 * 2.0) - 1.0).abs() < 2e-5, "{still}");
    let along = [("simulation.integrator", 1.0), ("forces.wind.x", 1.0)];
    let across = 0.1 + 0.12 * 8.0_f64.sqrt() * 2.0;
    let found = grown(&along, 2.0);
    assert!((found / across - 1.0).abs() < 2e-5, "{found}, not {across}");
}

#[test]
fn a_particle_born_late_in_a_step_grows_for_the_rest_of_it() {
    let settings = [
        ("emission.rate", 240.0),
        ("emission.entrainment", 0.5),
        ("emitters.0.speed", 2.0),
        ("emitters.0.speedVariation", 0.0),
        ("emitters.0.size", 0.1),
        ("emitters.0.sizeVariation", 0.0),
    ];
    let mut simulator = simulator(100, 1, &[STILL, &settings]);
    steps(&mut simulator, 3);
    let particles = simulator.particles();
    for i in 0..simulator.alive() {
        let expected = 0.1 + 0.5 * 2.0 * particles.age[i];
        assert!(
            (particles.size[i] - expected).abs() < 1e-5,
            "{} at {}",
            particles.size[i],
            particles.age[i]
        );
    }
    assert_eq!(simulator.alive(), 12);
}

#[test]
fn growth_has_a_limit() {
    let settings = [("emission.entrainment", 1.0)];
    let mut simulator = simulator(2, 1, &[STILL, &settings]);
    for size in [MAX_SIZE - 1.0, MAX_SIZE + 5.0] {
        simulator.add(&Newborn {
            size,
            slip: [0.0, 45.0, 0.0],
            ..newborn([0.0; 3])
        });
    }
    steps(&mut simulator, 120);
    assert_eq!(simulator.particles().size[..2], [MAX_SIZE, MAX_SIZE + 5.0]);
}
