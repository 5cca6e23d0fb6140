//! The field of turbulence: free of divergence, of the right speed, without favourites.

use sim::forces::turbulence::{self, Pattern, Swirls, TurbulenceState};
use sim::parameters::{LIST_LIMIT, Parameters};
use sim::random::Random;
use sim::simd::Vector4;

fn pattern(octaves: f64) -> Pattern {
    Pattern {
        speed: 2.0,
        scale: 0.8,
        octaves,
        evolution: 0.0,
    }
}

fn field(octaves: f64, phase: f64) -> Swirls {
    let state = TurbulenceState { drift: [0.0; 3], phase };
    Swirls::new(&pattern(octaves), 1.0, &state, 5).unwrap()
}

fn places(count: usize) -> impl Iterator<Item = [f32; 3]> {
    let mut random = Random::new(3);
    (0..count).map(move |_| std::array::from_fn(|_| random.signed() * 20.0))
}

fn at(field: &Swirls, place: [f32; 3]) -> [f64; 3] {
    field.velocity(Vector4::splat(place)).first().map(f64::from)
}

/// Central difference of component `of` along `along`; the step is a power of two, so that places are exact.
fn slope(field: &Swirls, place: [f32; 3], of: usize, along: usize) -> f64 {
    const STEP: f32 = 1.0 / 512.0;
    let place = place.map(|component| (component * 512.0).round() / 512.0);
    let moved = |sign: f32| std::array::from_fn(|i| if i == along { place[i] + sign * STEP } else { place[i] });
    (at(field, moved(1.0))[of] - at(field, moved(-1.0))[of]) / f64::from(2.0 * STEP)
}

#[test]
fn divergence_is_zero_and_vorticity_is_not() {
    for phase in [0.0, 0.8] {
        let field = field(1.0, phase);
        let (mut divergence, mut gradient) = (0.0, 0.0);
        for place in places(2000) {
            let diagonal: [f64; 3] = std::array::from_fn(|i| slope(&field, place, i, i));
            divergence += diagonal.iter().sum::<f64>().powi(2);
            gradient += diagonal.iter().map(|slope| slope * slope).sum::<f64>();
        }
        let share = (divergence / gradient).sqrt();
        assert!(
            gradient > 1000.0 && share < 2e-3,
            "phase {phase}: divergence is {share} of the gradient"
        );
    }
}

#[test]
fn speed_is_the_root_mean_square_whatever_octaves_and_phase() {
    for (octaves, phase) in [(1.0, 0.0), (1.0, 0.8), (2.0, 1.6), (4.0, 2.9)] {
        let field = field(octaves, phase);
        let mean: f64 = places(20_000)
            .map(|place| at(&field, place).map(|u| u * u).iter().sum::<f64>())
            .sum();
        let speed = (mean / 20_000.0).sqrt();
        assert!((speed - 2.0).abs() < 0.08, "octaves {octaves}, phase {phase}: {speed}");
    }
}

#[test]
fn no_direction_is_favoured() {
    let field = field(1.0, 0.4);
    let mut mean = [0.0; 3];
    for place in places(20_000) {
        let velocity = at(&field, place);
        mean.iter_mut().zip(velocity).for_each(|(sum, u)| *sum += u / 20_000.0);
    }
    assert!(mean.iter().all(|component| component.abs() < 0.06), "{mean:?}");
}

#[test]
fn every_direction_is_as_strong_while_the_pattern_evolves() {
    for phase in [0.0, 0.8, 2.4] {
        let field = field(1.0, phase);
        let mut moments = [[0.0; 3]; 3];
        for place in places(20_000) {
            let velocity = at(&field, place);
            for (i, row) in moments.iter_mut().enumerate() {
                row.iter_mut()
                    .zip(velocity)
                    .for_each(|(sum, u)| *sum += velocity[i] * u / 20_000.0);
            }
        }
        for (i, row) in moments.iter().enumerate() {
            for (j, moment) in row.iter().enumerate() {
                let expected = if i == j { 4.0 / 3.0 } else { 0.0 };
                assert!((moment - expected).abs() < 0.12, "phase {phase}: {moments:?}");
            }
        }
    }
}

#[test]
fn velocity_is_continuous_across_cubes() {
    let field = field(1.0, 0.4);
    for place in places(500) {
        let edge = [((place[0] / 0.8).floor() + 0.37) * 0.8, place[1], place[2]];
        let beside = |sign: f32| at(&field, [edge[0] + sign * 2e-5, edge[1], edge[2]]);
        let (left, right) = (beside(-1.0), beside(1.0));
        let jump = left.iter().zip(right).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(jump < 2e-3, "a jump of {jump} at {edge:?}");
    }
}

#[test]
fn a_quarter_turn_of_the_phase_forgets_the_pattern() {
    let (early, late) = (field(1.0, 0.0), field(1.0, std::f64::consts::FRAC_PI_2));
    let product = |a: [f64; 3], b: [f64; 3]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let mean: f64 = places(20_000)
        .map(|place| product(at(&early, place), at(&late, place)))
        .sum::<f64>()
        / 20_000.0;
    assert!(mean.abs() < 0.1 * 4.0, "correlation {mean}");
}

#[test]
fn wind_carries_the_pattern_along() {
    let mut parameters = Parameters::default();
    parameters.set("forces.wind.x", 3.0).unwrap();
    parameters.set("turbulence.evolution", 0.0).unwrap();
    let mut states = [TurbulenceState::default(); LIST_LIMIT + 1];
    turbulence::advance(&mut states, &parameters, 2.5);
    let [still, moved] = [TurbulenceState::default(), states[LIST_LIMIT]]
        .map(|state| Swirls::new(&pattern(2.0), 1.0, &state, 5).unwrap());
    for place in places(200) {
        let (before, after) = (at(&still, place), at(&moved, [place[0] + 7.5, place[1], place[2]]));
        let difference = before.iter().zip(after).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(difference < 1e-3, "at {place:?}: {before:?} and {after:?}");
    }
}
