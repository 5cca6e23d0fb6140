//! The spread of sizes.

use crate::common::{STILL, simulator, steps};
use sim::emission::swelling::{OF_LIFETIME, SWELL_TIME, factor, level};

#[test]
fn factors_have_the_mean_1_and_few_are_large() {
    let count = 200;
    let share = |number: i32| (f64::from(number) + 0.5) / f64::from(count);
    let factors: Vec<f32> = (0..count)
        .flat_map(|own| (0..count).map(move |shared| factor(1.0, share(shared) as f32, share(own) as f32)))
        .collect();
    let mean = factors.iter().sum::<f32>() / factors.len() as f32;
    assert!((mean - 1.0).abs() < 0.06, "{mean}");
    let below = factors.iter().filter(|factor| **factor < mean).count() as f32 / factors.len() as f32;
    assert!(below > 0.55, "{below}");
    assert_eq!(factor(0.0, 0.9, 0.9), 1.0);
}

#[test]
fn levels_are_smooth_and_differ_between_emitters_and_seeds() {
    let mut before = level(1, 0, 0.0);
    for step in 1..6000 {
        let now = level(1, 0, f64::from(step) / 600.0);
        // The steepest slope of a smooth step is 1.5.
        assert!((now - before).abs() <= (1.5 / SWELL_TIME / 600.0) as f32 * 1.001);
        before = now;
    }
    assert_ne!(level(1, 0, 0.6), level(1, 1, 0.6));
    assert_ne!(level(1, 0, 0.6), level(2, 0, 0.6));
}

#[test]
fn neighbours_in_time_have_like_sizes_and_large_ones_live_longer() {
    let even = [
        ("emission.rate", 600.0),
        ("emission.lifetime", 60.0),
        ("emitters.0.sizeVariation", 0.0),
        ("emitters.0.lifetimeVariation", 0.0),
        ("emission.sizeSpread", 1.0),
    ];
    let mut simulator = simulator(6000, 1, &[STILL, &even]);
    steps(&mut simulator, 500);
    let particles = simulator.particles();
    let factors: Vec<f32> = particles.size[..5000].iter().map(|size| size / 0.3).collect();
    for (factor, lifetime) in factors.iter().zip(&particles.lifetime) {
        let expected = 60.0 * (1.0 + OF_LIFETIME * (factor - 1.0));
        assert!((lifetime - expected).abs() < 1e-3, "{lifetime}, not {expected}");
    }
    let mean = factors.iter().sum::<f32>() / 5000.0;
    let product = |lag: usize| {
        let pairs = factors.iter().zip(&factors[lag..]);
        pairs.map(|(a, b)| (a - mean) * (b - mean)).sum::<f32>() / (5000 - lag) as f32
    };
    // Births are 1/600 s apart: 6 are within 10 ms, 1,200 are two seconds.
    let [near, far] = [6, 1200].map(|lag| product(lag) / product(0));
    assert!(near > 0.4 && far < near / 2.0, "{near}, {far}");
}
