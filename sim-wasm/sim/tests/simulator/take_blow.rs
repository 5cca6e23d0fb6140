//! Blows: place and time of the air motion.

use crate::common::{STILL, newborn, place, simulator, steps};
use sim::Simulator;
use sim::layout::blow::BlowNumbers;

/// Along z through the origin, upwards.
const BLOW: BlowNumbers = BlowNumbers {
    origin: [0.0, 0.0, 5.0],
    ray: [0.0, 0.0, -3.0],
    velocity: [0.0, 2.0, 0.0],
    radius: 0.5,
    seconds: 0.5,
};

/// Displacement by a whole gust of one particle at each position.
fn carried(places: &[[f32; 3]], blow: &BlowNumbers) -> Vec<[f32; 3]> {
    let mut simulator = simulator(places.len() as u32, 1, &[STILL, &[("emission.rate", 0.0)]]);
    places.iter().for_each(|place| assert!(simulator.add(&newborn(*place))));
    simulator.input_blow(blow).unwrap();
    steps(&mut simulator, 60);
    let way = |i: usize| std::array::from_fn(|axis| place(&simulator, i)[axis] - places[i][axis]);
    (0..places.len()).map(way).collect()
}

#[test]
fn a_gentle_blow_carries_by_the_integral_of_its_level() {
    // The integral of 16 s^2 (1 - s)^2 over the gust's time T is 8/15 T; a slow gust moves no particle off the ray.
    let gentle = BlowNumbers {
        velocity: [0.0, 0.05, 0.0],
        ..BLOW
    };
    let at = |x: f32| [x, 0.0, 0.0];
    let ways = carried(&[at(0.0), at(0.25), at(0.45), at(0.51), [0.0, 0.0, 6.0]], &gentle);
    let whole = 0.05 * 0.5 * 8.0 / 15.0;
    for (way, x) in ways.iter().zip([0.0_f32, 0.25, 0.45]) {
        let share = (1.0 - (x / 0.5).powi(2)).powi(2);
        assert!((way[1] - whole * share).abs() < 0.02 * whole, "{way:?} at {x}");
        assert_eq!((way[0], way[2]), (0.0, 0.0));
    }
    assert_eq!(ways[3], [0.0; 3], "beyond the radius");
    assert_eq!(ways[4], [0.0; 3], "behind the origin");
}

#[test]
fn a_blow_ends() {
    let [mut simulator, mut silent] = [1, 1].map(|seed| simulator(1, seed, &[STILL]));
    simulator.input_blow(&BLOW).unwrap();
    assert_eq!(simulator.hash(), silent.hash(), "it has not begun to blow");
    let speed = |simulator: &Simulator| simulator.air_velocity([0.0; 3])[1];
    steps(&mut simulator, 15);
    steps(&mut silent, 15);
    assert_ne!(simulator.hash(), silent.hash(), "what blows belongs to the state");
    assert!((speed(&simulator) - 2.0).abs() < 0.05, "{}", speed(&simulator));
    steps(&mut simulator, 14);
    assert!(speed(&simulator) > 0.0);
    simulator.step();
    assert_eq!(speed(&simulator), 0.0);
}

#[test]
fn many_blows_at_once_are_bounded() {
    let mut simulator = simulator(1, 1, &[STILL]);
    for _ in 0..100 {
        simulator.input_blow(&BlowNumbers { seconds: 10.0, ..BLOW }).unwrap();
        simulator.step();
    }
    // Sixteen of the hundred gusts are active, the oldest for 16 of its 600 steps.
    let most = 16.0 * 2.0 * 16.0 * (16.0_f32 / 600.0).powi(2);
    let speed = simulator.air_velocity([0.0; 3])[1];
    assert!(speed > 0.0 && speed < most, "{speed}");
}
