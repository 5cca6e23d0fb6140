//! The turbulence field: divergence, speed and isotropy.

use sim::forces::force::TurbulenceState;
use sim::forces::turbulence;
use sim::forces::turbulence::Swirls;
use sim::forces::turbulence::octave::CELLS;
use sim::layout::parameters::LIST_LIMIT;
use sim::layout::parameters::Parameters;
use sim::layout::parameters::settings::Pattern;
use sim::math::random::Random;
use sim::math::simd::Vector4;

/// Shift of the lattice of the first octave, in cells.
const SHIFT: f64 = 0.37;

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

/// Central difference of component `of` along `along`; the step is a power of two, so that positions are exact.
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
fn swirls_rotate_equally_often_in_both_directions() {
    let field = field(1.0, 0.8);
    let (mut helicity, mut speed, mut vorticity) = (0.0, 0.0, 0.0);
    for place in places(4000) {
        let d = |of: usize, along: usize| slope(&field, place, of, along);
        let curl = [d(2, 1) - d(1, 2), d(0, 2) - d(2, 0), d(1, 0) - d(0, 1)];
        let u = at(&field, place);
        helicity += u.iter().zip(curl).map(|(u, w)| u * w).sum::<f64>();
        speed += u.iter().map(|u| u * u).sum::<f64>();
        vorticity += curl.iter().map(|w| w * w).sum::<f64>();
    }
    let handedness = helicity / (speed * vorticity).sqrt();
    assert!(handedness.abs() < 0.05, "{handedness} of a corkscrew's");
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

/// The point at `skewed` coordinates of the lattice, in cells, of `field(1.0, _)`.
fn from_skewed(skewed: [f64; 3]) -> [f32; 3] {
    let cells = skewed.map(|component| component + SHIFT);
    let lean = cells.iter().sum::<f64>() / 6.0;
    cells.map(|component| ((component - lean) * 0.8 / CELLS) as f32)
}

/// Root mean square speed at the same point of many cells.
fn speed_within_cells(field: &Swirls, fraction: [f64; 3]) -> f64 {
    const CELL_COUNT: usize = 3000;
    let mut random = Random::new(11);
    let sum: f64 = (0..CELL_COUNT)
        .map(|_| {
            let cell: [f64; 3] = std::array::from_fn(|_| f64::from((random.signed() * 15.0).round()));
            let place = from_skewed(std::array::from_fn(|i| cell[i] + fraction[i]));
            at(field, place).iter().map(|u| u * u).sum::<f64>()
        })
        .sum();
    (sum / CELL_COUNT as f64).sqrt()
}

#[test]
fn speed_is_even_within_the_cell() {
    const GRID: u32 = 6;
    let field = field(1.0, 0.8);
    let (mut least, mut greatest) = (f64::MAX, 0.0_f64);
    for number in 0..GRID.pow(3) {
        let fraction = [number % GRID, number / GRID % GRID, number / GRID / GRID];
        let speed = speed_within_cells(&field, fraction.map(|i| f64::from(i) / f64::from(GRID)));
        (least, greatest) = (least.min(speed), greatest.max(speed));
    }
    // 1.39 by the formula, with 2 % of noise in both directions.
    assert!(greatest / least < 1.45, "between {least} and {greatest} m/s");
}

#[test]
fn velocity_and_its_slopes_are_continuous_across_faces() {
    const STEP: f64 = 1.0 / 256.0;
    let field = field(1.0, 0.4);
    let mut random = Random::new(7);
    let mut share = || f64::from(random.signed()) * 0.5 + 0.5;
    let (mut jumps, mut kinks, mut bends) = (0.0, 0.0, 0.0);
    for number in 0..3000 {
        let (a, b) = (share(), share());
        // On the faces of the skewed cubes, and where two fractions are equal.
        let face = [[0.0, a, b], [a, 0.0, b], [a, b, 0.0], [a, a, b], [a, b, a], [b, a, a]][number % 6];
        let across = [
            [1.0, 0.0, 0.0],
            [0.0, 1.0, 0.0],
            [0.0, 0.0, 1.0],
            [1.0, -1.0, 0.0],
            [1.0, 0.0, -1.0],
            [0.0, 1.0, -1.0],
        ];
        let beside = |steps: f64| {
            let place = std::array::from_fn(|i| face[i] + across[number % 6][i] * steps * STEP);
            at(&field, from_skewed(place))
        };
        let [before, left, middle, right, after] = [-2.0, -1.0, 0.0, 1.0, 2.0].map(beside);
        let [tiny_left, tiny_right] = [-0.01, 0.01].map(beside);
        for i in 0..3 {
            jumps = f64::max(jumps, (tiny_right[i] - tiny_left[i]).abs());
            // The change of the slope across the face, and the typical change of slopes.
            let slopes = [
                left[i] - before[i],
                middle[i] - left[i],
                right[i] - middle[i],
                after[i] - right[i],
            ];
            kinks = f64::max(kinks, (slopes[2] - slopes[1]).abs());
            bends = f64::max(bends, slopes.iter().fold(0.0, |most: f64, slope| most.max(slope.abs())));
        }
    }
    assert!(jumps < 5e-3, "a jump of {jumps} m/s");
    assert!(
        kinks < 0.1 * bends,
        "slopes of up to {bends} change by {kinks} at a face"
    );
}

#[test]
fn speed_stays_the_same_at_the_end_of_the_world() {
    let pattern = Pattern {
        scale: 0.05,
        ..pattern(4.0)
    };
    let state = TurbulenceState {
        drift: [3e5, -3e5, 1e5],
        phase: 1e6,
    };
    let field = Swirls::new(&pattern, 1.0, &state, 5).unwrap();
    for place in places(20_000) {
        let far = place.map(|component| component * 500.0);
        let speed = at(&field, far).iter().map(|u| u * u).sum::<f64>().sqrt();
        assert!(speed < 12.0, "{speed} m/s at {far:?}");
    }
}

#[test]
fn a_quarter_turn_of_the_phase_replaces_the_pattern() {
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
