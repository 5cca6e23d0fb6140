//! Times of births: bursts, envelopes, settings per emitter, and a full simulator.

use crate::common::{STILL, simulator, steps};
use sim::Simulator;

const EVEN: &[(&str, f64)] = &[
    ("emission.rate", 0.0),
    ("emission.lifetime", 60.0),
    ("emitters.0.lifetimeVariation", 0.0),
    ("emitters.0.speedVariation", 0.0),
];

/// Number of births in each step.
fn births(simulator: &mut Simulator, count: usize) -> Vec<usize> {
    let born = |simulator: &Simulator| simulator.alive() + simulator.waiting() as usize;
    let mut before = born(simulator);
    let mut births = Vec::new();
    for _ in 0..count {
        simulator.step();
        births.push(born(simulator) - before);
        before = born(simulator);
    }
    births
}

/// The steps with births, and their numbers.
fn moments(births: &[usize]) -> Vec<(usize, usize)> {
    births
        .iter()
        .copied()
        .enumerate()
        .filter(|(_, count)| *count > 0)
        .collect()
}

type Settings<'a> = &'a [(&'a str, f64)];
type Moments<'a> = &'a [(usize, usize)];

#[test]
fn a_burst_comes_at_each_start_of_the_envelope() {
    let cases: [(Settings, Moments); 4] = [
        (&[], &[(0, 25)]),
        (&[("emitters.0.envelope.start", 0.5)], &[(30, 25)]),
        (
            &[("emitters.0.envelope.start", 0.5), ("emitters.0.envelope.period", 1.25)],
            &[(30, 25), (105, 25), (180, 25), (255, 25)],
        ),
        // The period is shorter than a step: each step has two or three starts.
        (
            &[
                ("emitters.0.envelope.start", 4.95),
                ("emitters.0.envelope.period", 1.0 / 150.0),
            ],
            &[(297, 50), (298, 50), (299, 75)],
        ),
    ];
    for (settings, expected) in cases {
        let mut simulator = simulator(5000, 1, &[STILL, EVEN, &[("emitters.0.burst.count", 25.0)], settings]);
        assert_eq!(moments(&births(&mut simulator, 300)), expected, "{settings:?}");
    }
}

#[test]
fn a_burst_is_spread_over_its_step() {
    let settings = [
        ("emitters.0.burst.count", 50.0),
        ("emitters.0.speed", 6.0),
        ("emitters.0.spread", 0.0),
    ];
    let mut simulator = simulator(50, 1, &[STILL, EVEN, &settings]);
    steps(&mut simulator, 10);
    let mut heights = simulator.particles().y[..50].to_vec();
    heights.sort_by(f32::total_cmp);
    for pair in heights.windows(2) {
        assert!((pair[1] - pair[0] - 0.1 / 50.0).abs() < 1e-6, "{pair:?}");
    }
}

#[test]
fn a_burst_that_finds_no_room_waits_and_none_is_lost() {
    let settings = [
        ("emitters.0.burst.count", 1000.0),
        ("emission.lifetime", 0.5),
        ("emitters.0.envelope.period", 2.0),
    ];
    let mut simulator = simulator(100, 1, &[STILL, EVEN, &settings]);
    simulator.step();
    assert_eq!((simulator.alive(), simulator.waiting()), (100, 900));
    let restored = {
        let mut other = crate::common::simulator(100, 5, &[]);
        other.restore(&simulator.save()).unwrap();
        other
    };
    for mut simulator in [simulator, restored] {
        let mut last = u64::MAX;
        while simulator.steps() < 120 {
            assert!(simulator.waiting() <= last && simulator.alive() <= 100);
            last = simulator.waiting();
            simulator.step();
        }
        // A burst of a hundred every half second: four so far, and the next one in the next step.
        assert_eq!(simulator.waiting(), 600);
        simulator.step();
        assert_eq!(simulator.waiting() + simulator.alive() as u64, 600 + 100 + 1000);
    }
}

#[test]
fn an_envelope_switches_the_rate() {
    let settings = [
        ("emission.rate", 600.0),
        ("emitters.0.envelope.start", 0.5),
        ("emitters.0.envelope.duration", 0.25),
        ("emitters.0.envelope.period", 1.0),
    ];
    let mut simulator = simulator(5000, 1, &[STILL, EVEN, &settings]);
    for (step, born) in births(&mut simulator, 240).into_iter().enumerate() {
        let on = (30..45).contains(&(step % 60));
        assert_eq!(born, if on { 10 } else { 0 }, "step {step}");
    }
}

#[test]
fn a_fading_envelope_emits_the_integral_of_its_level() {
    let settings = [
        ("emission.rate", 1000.0),
        ("emitters.0.envelope.duration", 3.0),
        ("emitters.0.envelope.fade", 1.0),
    ];
    let mut simulator = simulator(5000, 1, &[STILL, EVEN, &settings]);
    steps(&mut simulator, 240);
    // The integral of 3 s^2 - 2 s^3 is one half at either end.
    assert!(simulator.alive().abs_diff(2000) <= 1, "{}", simulator.alive());
}

#[test]
fn an_emitter_that_is_off_does_not_affect_the_others() {
    let settings = [
        ("emission.rate", 600.0),
        ("emitters.1.share", 2.0),
        ("emitters.0.envelope.start", 100.0),
    ];
    let mut simulator = simulator(5000, 1, &[STILL, EVEN, &settings]);
    steps(&mut simulator, 60);
    assert_eq!(simulator.alive(), 400);
}

#[test]
fn lifetimes_are_per_emitter() {
    let settings = [
        ("emission.rate", 600.0),
        ("emission.lifetime", 4.0),
        ("emitters.0.lifetime", 0.25),
        ("emitters.1.lifetime", 3.0),
        ("emitters.1.lifetimeVariation", 0.5),
        ("emitters.1.position.x", 100.0),
    ];
    let mut simulator = simulator(5000, 1, &[STILL, EVEN, &settings]);
    steps(&mut simulator, 50);
    let particles = simulator.particles();
    for i in 0..simulator.alive() {
        let (lifetime, second) = (particles.lifetime[i], particles.x[i] > 50.0);
        assert!(
            if second {
                (6.0..=18.0).contains(&lifetime)
            } else {
                lifetime == 1.0
            },
            "{lifetime}"
        );
    }
}

#[test]
fn tints_are_per_emitter() {
    let settings = [
        ("emission.rate", 600.0),
        ("emitters.0.tint", 15.0),
        ("emitters.1.position.x", 100.0),
    ];
    let mut simulator = simulator(5000, 1, &[STILL, EVEN, &settings]);
    steps(&mut simulator, 50);
    let particles = simulator.particles();
    for i in 0..simulator.alive() {
        let tint = if particles.x[i] > 50.0 { 0 } else { 15 };
        assert_eq!(particles.attributes[i] >> 28, tint);
    }
}

#[test]
fn tiny_periods_are_no_division_by_zero() {
    let settings = [
        ("emission.rate", 600.0),
        ("emitters.0.burst.count", 3.0),
        ("emitters.0.envelope.period", 1e-300),
        ("emitters.0.envelope.duration", 1e-300),
        ("emitters.0.envelope.fade", 1e-300),
    ];
    let mut simulator = simulator(500, 1, &[STILL, EVEN, &settings]);
    steps(&mut simulator, 10);
    // The limit is a thousand starts per second.
    assert!(
        (480..=510).contains(&(simulator.alive() as u64 + simulator.waiting())),
        "{}",
        simulator.waiting()
    );
}
