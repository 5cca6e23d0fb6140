//! Emitters: number, time, place and direction of births.

use crate::common::{LIVELY, STILL, newborn, place, simulator, steps};
use sim::particles::Newborn;

/// Without variation and without deaths.
const EVEN: &[(&str, f64)] = &[
    ("emission.lifetime", 60.0),
    ("emitters.0.speedVariation", 0.0),
    ("emitters.0.sizeVariation", 0.0),
    ("emitters.0.lifetimeVariation", 0.0),
    ("emitters.0.spread", 0.0),
];

#[test]
fn counts_are_exact_over_any_time() {
    for rate in [0.0, 0.3, 59.0, 60.0, 100.0, 137.3, 1000.1] {
        let mut simulator = simulator(20_000, 1, &[STILL, EVEN, &[("emission.rate", rate)]]);
        for step in 1..=900 {
            simulator.step();
            let due = (rate * f64::from(step) / 60.0 + 1e-7).floor() as usize;
            assert_eq!(simulator.alive(), due, "rate {rate}, step {step}");
        }
    }
}

#[test]
fn emitters_divide_the_rate_by_their_shares() {
    let shares = [
        ("emission.rate", 400.0),
        ("emitters.1.position.x", 100.0),
        ("emitters.1.share", 3.0),
    ];
    let mut simulator = simulator(5000, 1, &[STILL, EVEN, &shares]);
    steps(&mut simulator, 300);
    let second = simulator.particles().x[..simulator.alive()]
        .iter()
        .filter(|x| **x > 50.0)
        .count();
    assert_eq!((simulator.alive(), second), (2000, 1500));
}

#[test]
fn emitters_without_a_share_emit_nothing() {
    let mut simulator = simulator(100, 1, &[EVEN, &[("emitters.0.share", 0.0), ("emission.rate", 400.0)]]);
    steps(&mut simulator, 60);
    assert_eq!((simulator.alive(), simulator.waiting()), (0, 0));
}

#[test]
fn births_wait_for_capacity_and_none_is_lost() {
    let mut simulator = simulator(
        100,
        1,
        &[STILL, EVEN, &[("emission.rate", 600.0), ("emission.lifetime", 2.0)]],
    );
    steps(&mut simulator, 60);
    assert_eq!((simulator.alive(), simulator.waiting()), (100, 500));
    simulator.set("emission.rate", 0.0).unwrap();
    let mut made_up = 0;
    for _ in 0..900 {
        let waiting = simulator.waiting();
        simulator.step();
        made_up += waiting - simulator.waiting();
        assert!(simulator.alive() <= 100);
    }
    assert_eq!((made_up, simulator.waiting(), simulator.alive()), (500, 0, 0));
}

#[test]
fn no_emitter_starves_without_capacity() {
    let two = [
        ("emission.rate", 1200.0),
        ("emission.lifetime", 0.5),
        ("emitters.1.position.x", 100.0),
    ];
    let mut simulator = simulator(50, 1, &[STILL, EVEN, &two]);
    steps(&mut simulator, 600);
    let second = simulator.particles().x[..simulator.alive()]
        .iter()
        .filter(|x| **x > 50.0)
        .count();
    assert!(
        (10..=40).contains(&second),
        "{second} of {} are the second emitter's",
        simulator.alive()
    );
}

#[test]
fn a_small_emitter_gets_its_share_of_a_full_simulator() {
    let two = [
        ("emission.rate", 2000.0),
        ("emission.lifetime", 0.5),
        ("emitters.1.position.x", 100.0),
        ("emitters.1.share", 0.05),
    ];
    for lifetime in [0.5, 31.0 / 60.0] {
        let mut simulator = simulator(64, 1, &[STILL, EVEN, &two, &[("emission.lifetime", lifetime)]]);
        let mut seconds = 0;
        for _ in 0..1200 {
            simulator.step();
            let particles = simulator.particles();
            seconds += particles.x[..simulator.alive()].iter().filter(|x| **x > 50.0).count();
        }
        let share = seconds as f64 / (1200.0 * 64.0);
        // Rounding up gives the small one slightly more than 0.05 / 1.05.
        assert!((0.04..0.2).contains(&share), "{share} of all that live");
    }
}

/// Minimum and maximum distance between neighbours along `axis`.
fn gaps(settings: &[(&str, f64)], axis: usize) -> (f32, f32) {
    let mut simulator = simulator(1000, 1, &[STILL, EVEN, settings]);
    steps(&mut simulator, 60);
    let mut along: Vec<f32> = (0..simulator.alive()).map(|i| place(&simulator, i)[axis]).collect();
    along.sort_by(f32::total_cmp);
    let gaps = along.windows(2).map(|pair| pair[1] - pair[0]);
    gaps.fold((f32::MAX, 0.0), |(least, greatest), gap| {
        (least.min(gap), greatest.max(gap))
    })
}

#[test]
fn a_jet_in_wind_has_no_clusters() {
    let jet = gaps(&[("emission.rate", 300.0), ("emitters.0.speed", 12.0)], 1);
    assert!(jet.0 > 0.0396 && jet.1 < 0.0404, "a jet of 0.04 m has gaps {jet:?}");
    let wind = gaps(
        &[
            ("emission.rate", 300.0),
            ("emitters.0.speed", 0.0),
            ("forces.wind.x", 12.0),
        ],
        0,
    );
    assert!(
        wind.0 > 0.0396 && wind.1 < 0.0404,
        "a trail of 0.04 m has gaps {wind:?}"
    );
}

#[test]
fn directions_fill_the_cone_and_stay_in_it() {
    for spread in [0.0, 0.4, 1.5, std::f64::consts::PI] {
        let cone = [
            ("emission.rate", 10_000.0),
            ("emitters.0.spread", spread),
            ("emitters.0.direction.x", 0.2),
            ("emitters.0.direction.y", -0.3),
            ("emitters.0.direction.z", -0.6),
            ("emitters.0.speed", 1.0),
        ];
        let mut simulator = simulator(10_000, 1, &[STILL, EVEN, &cone]);
        steps(&mut simulator, 60);
        let p = simulator.particles();
        let direction = |i: usize| (2.0 * p.sx[i] - 3.0 * p.sy[i] - 6.0 * p.sz[i]) / 7.0;
        let cosines: Vec<f64> = (0..simulator.alive()).map(|i| f64::from(direction(i))).collect();
        let least = cosines.iter().copied().fold(1.0, f64::min);
        assert!(
            least >= spread.cos() - 1e-5,
            "spread {spread}: {least} is outside of {}",
            spread.cos()
        );
        let mean = cosines.iter().sum::<f64>() / cosines.len() as f64;
        let expected = (1.0 + spread.cos()) / 2.0;
        assert!(
            (mean - expected).abs() < 0.02,
            "spread {spread}: mean {mean}, uniform would be {expected}"
        );
    }
}

#[test]
fn shapes_are_filled_evenly() {
    for (shape, dimensions) in [(1.0, 2), (2.0, 3)] {
        let settings = [
            ("emission.rate", 6000.0),
            ("emitters.0.shape", shape),
            ("emitters.0.radius", 2.0),
            ("emitters.0.speed", 0.0),
            ("emitters.0.direction.x", 1.0),
            ("emitters.0.direction.y", 0.0),
        ];
        let mut simulator = simulator(6000, 1, &[STILL, EVEN, &settings]);
        steps(&mut simulator, 60);
        let distance = |i: usize| {
            place(&simulator, i)
                .map(f64::from)
                .iter()
                .map(|c| c * c)
                .sum::<f64>()
                .sqrt()
        };
        let distances: Vec<f64> = (0..simulator.alive()).map(distance).collect();
        assert!(distances.iter().all(|d| *d <= 2.0 + 1e-5));
        let inner = distances.iter().filter(|d| **d < 1.0).count() as f64 / distances.len() as f64;
        let expected = 0.5_f64.powi(dimensions);
        assert!(
            (inner - expected).abs() < 0.03,
            "shape {shape}: {inner} in the inner half, {expected} if even"
        );
        let thickness = simulator.particles().x[..simulator.alive()]
            .iter()
            .fold(0.0_f32, |max, x| max.max(x.abs()));
        assert_eq!(thickness < 1e-5, dimensions == 2, "shape {shape} is {thickness} thick");
    }
}

#[test]
fn variations_are_all_used_and_kept_for_life() {
    let settings = [("puff.variations", 3.0), ("emission.rate", 600.0)];
    let mut simulator = simulator(600, 1, &[STILL, EVEN, &settings]);
    steps(&mut simulator, 60);
    let attributes = simulator.particles().attributes[..600].to_vec();
    for variation in 0..3 {
        let count = attributes
            .iter()
            .filter(|attributes| **attributes & 0xff == variation)
            .count();
        assert!((150..250).contains(&count), "variation {variation} has {count} of 600");
    }
    simulator.set("puff.variations", 1.0).unwrap();
    steps(&mut simulator, 60);
    assert_eq!(simulator.particles().attributes[..600], attributes);
}

#[test]
fn a_seed_repeats_and_another_differs() {
    let run = |seed| {
        let mut simulator = simulator(2000, seed, &[LIVELY]);
        steps(&mut simulator, 300);
        simulator.hash()
    };
    assert_eq!(run(1), run(1));
    assert_ne!(run(1), run(2));
}

#[test]
fn a_hash_notices_each_number_of_each_particle() {
    let hash = |last: Newborn| {
        let mut simulator = simulator(9, 1, &[STILL]);
        (0..8).for_each(|i| assert!(simulator.add(&newborn([i as f32, 0.0, 0.0]))));
        simulator.add(&last);
        simulator.hash()
    };
    let plain = newborn([1.0; 3]);
    let next = |value: f32| value.next_up();
    let changed = [
        Newborn {
            position: [1.0, next(1.0), 1.0],
            ..plain
        },
        Newborn {
            slip: [0.0, 0.0, next(0.0)],
            ..plain
        },
        Newborn {
            age: next(plain.age),
            ..plain
        },
        Newborn {
            lifetime: next(plain.lifetime),
            ..plain
        },
        Newborn {
            size: next(plain.size),
            ..plain
        },
        Newborn {
            temperature: next(plain.temperature),
            ..plain
        },
        Newborn {
            attributes: plain.attributes ^ 1 << 31,
            ..plain
        },
    ];
    let mut hashes: Vec<u64> = changed.into_iter().chain([plain]).map(hash).collect();
    hashes.sort_unstable();
    hashes.dedup();
    assert_eq!(hashes.len(), 8, "two different states have the same hash");
}

#[test]
fn a_hash_notices_the_smallest_change() {
    let mut lively = simulator(2000, 1, &[LIVELY]);
    steps(&mut lively, 30);
    let mut other = simulator(2000, 1, &[LIVELY]);
    steps(&mut other, 29);
    other.set("forces.wind.x", 0.300_000_1).unwrap();
    steps(&mut other, 1);
    assert_ne!(lively.hash(), other.hash());
}
