//! Places of birth on each shape, by moments and counts of uniform distributions.

use crate::common::{STILL, place, simulator, steps};
use sim::Simulator;

const COUNT: usize = 8000;
const BORN: &[(&str, f64)] = &[
    ("emission.rate", COUNT as f64),
    ("emission.lifetime", 60.0),
    ("emitters.0.lifetimeVariation", 0.0),
    ("emitters.0.speedVariation", 0.0),
    ("emitters.0.speed", 0.0),
    ("emitters.0.radius", 2.0),
];

fn born(shape: f64, settings: &[(&str, f64)]) -> Simulator {
    let mut simulator = simulator(
        COUNT as u32,
        1,
        &[STILL, BORN, &[("emitters.0.shape", shape)], settings],
    );
    steps(&mut simulator, 60);
    assert_eq!(simulator.alive(), COUNT);
    simulator
}

fn places(simulator: &Simulator) -> Vec<[f64; 3]> {
    (0..COUNT).map(|i| place(simulator, i).map(f64::from)).collect()
}

fn length(v: &[f64; 3]) -> f64 {
    v.iter().map(|part| part * part).sum::<f64>().sqrt()
}

/// Pearson's chi-squared statistic of `values` in `bins`. For uniform values in 0..1 its mean is `bins - 1` and
/// its variance twice that.
fn chi_square(values: impl Iterator<Item = f64>, bins: usize) -> f64 {
    let mut counts = vec![0.0; bins];
    values.for_each(|value| counts[((value * bins as f64) as usize).min(bins - 1)] += 1.0);
    let expected = COUNT as f64 / bins as f64;
    counts
        .iter()
        .map(|count: &f64| (count - expected).powi(2) / expected)
        .sum()
}

fn assert_even(values: impl Iterator<Item = f64>, what: &str) {
    // Mean 49, standard deviation 10: a deviation of 6 is not chance.
    let statistic = chi_square(values, 50);
    assert!(
        statistic < 110.0,
        "{what}: chi-square {statistic} for 49 degrees of freedom"
    );
}

/// Angle about the y axis as a fraction of a turn.
fn turn([x, _, z]: &[f64; 3]) -> f64 {
    z.atan2(*x) / std::f64::consts::TAU + 0.5
}

#[test]
fn a_point_is_a_point() {
    assert!(
        places(&born(0.0, &[("emitters.0.position.x", 3.0)]))
            .iter()
            .all(|p| *p == [3.0, 0.0, 0.0])
    );
}

#[test]
fn a_disc_is_even_by_area() {
    let places = places(&born(1.0, &[]));
    assert_even(places.iter().map(|p| (length(p) / 2.0).powi(2)), "radius");
    assert_even(places.iter().map(turn), "angle");
    assert!(places.iter().all(|p| p[1].abs() < 1e-6));
}

#[test]
fn a_ball_is_even_by_volume() {
    let places = places(&born(2.0, &[]));
    assert_even(places.iter().map(|p| (length(p) / 2.0).powi(3)), "radius");
    assert_even(places.iter().map(|p| (p[1] / length(p) + 1.0) / 2.0), "height");
    assert_even(places.iter().map(turn), "angle");
}

#[test]
fn a_ring_is_even_between_its_radii() {
    let places = places(&born(3.0, &[("emitters.0.inner", 0.5)]));
    assert_even(places.iter().map(|p| (length(p).powi(2) - 1.0) / 3.0), "radius");
    assert_even(places.iter().map(turn), "angle");
    let circle = self::places(&born(3.0, &[("emitters.0.inner", 1.0)]));
    assert!(
        circle
            .iter()
            .all(|p| (length(p) - 2.0).abs() < 1e-5 && p[1].abs() < 1e-6)
    );
}

#[test]
fn a_sphere_is_a_shell_that_smokes_outwards() {
    let settings = [("emitters.0.speed", 3.0), ("emitters.0.spread", 0.0)];
    let still = places(&born(4.0, &[]));
    assert!(still.iter().all(|p| (length(p) - 2.0).abs() < 1e-5));
    assert_even(still.iter().map(|p| (p[1] / 2.0 + 1.0) / 2.0), "height");
    assert_even(still.iter().map(turn), "angle");
    let blowing = born(4.0, &settings);
    let slips = blowing.particles();
    for (i, p) in places(&blowing).iter().enumerate() {
        let slip = [slips.sx[i], slips.sy[i], slips.sz[i]].map(f64::from);
        let along: f64 = (0..3).map(|axis| slip[axis] * p[axis]).sum::<f64>() / length(p);
        assert!((along - 3.0).abs() < 1e-4, "slip {slip:?} at {p:?}");
    }
}

#[test]
fn a_box_is_even_along_each_side() {
    let sides = [
        ("emitters.0.extent.x", 1.0),
        ("emitters.0.extent.y", 0.25),
        ("emitters.0.extent.z", 3.0),
    ];
    let places = places(&born(5.0, &sides));
    for (axis, (name, half)) in sides.iter().enumerate() {
        assert_even(places.iter().map(|p| (p[axis] / half + 1.0) / 2.0), name);
    }
    let product = places.iter().map(|p| p[0] * p[2] / 3.0).sum::<f64>() / COUNT as f64;
    assert!(
        product.abs() < 5.0 / 3.0 / (COUNT as f64).sqrt(),
        "sides go together: {product}"
    );
}

#[test]
fn a_cone_fans_out_from_its_apex() {
    for spread in [0.0, 0.3, 1.2] {
        let blowing = born(6.0, &[("emitters.0.speed", 2.0), ("emitters.0.spread", spread)]);
        let disc = born(6.0, &[("emitters.0.spread", spread)]);
        assert_even(places(&disc).iter().map(|p| (length(p) / 2.0).powi(2)), "radius");
        // All paths meet radius / tan(spread) behind the disc; 1 / tan(0) is infinite.
        let particles = blowing.particles();
        for (i, p) in places(&disc).iter().enumerate() {
            let slip = [particles.sx[i], particles.sy[i], particles.sz[i]].map(f64::from);
            assert!((length(&slip) - 2.0).abs() < 1e-5);
            let expected = length(p) / 2.0 * spread.tan();
            let found = (slip[0].hypot(slip[2])) / slip[1];
            assert!((found - expected).abs() < 1e-4, "{found}, not {expected}, at {p:?}");
            assert!(slip[0] * p[0] + slip[2] * p[2] >= -1e-9, "inwards at {p:?}");
        }
    }
}

#[test]
fn the_widest_cone_is_still_finite() {
    let blowing = born(
        6.0,
        &[("emitters.0.speed", 2.0), ("emitters.0.spread", std::f64::consts::PI)],
    );
    assert!(blowing.particles().sy[..COUNT].iter().all(|y| *y > 0.0 && *y <= 2.0));
}

#[test]
fn a_line_is_even_from_end_to_end() {
    let ends = [
        ("emitters.0.extent.x", -1.0),
        ("emitters.0.extent.y", 0.5),
        ("emitters.0.extent.z", 2.0),
    ];
    let places = places(&born(7.0, &ends));
    assert_even(places.iter().map(|p| (1.0 - p[0]) / 2.0), "place");
    assert!(
        places
            .iter()
            .all(|p| (p[0] + 2.0 * p[1]).abs() < 1e-5 && (p[2] + 2.0 * p[0]).abs() < 1e-5)
    );
}
