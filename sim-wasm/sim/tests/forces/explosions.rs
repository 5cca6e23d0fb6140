//! Explosions and speed limits against their closed forms.

use crate::common::{STEP, STILL, alone, assert_close, newborn, place, simulator, slip, steps};

const BLAST: [(&str, f64); 4] = [
    ("explosions.0.impulse", 4.0),
    ("explosions.0.speed", 6.0),
    ("explosions.0.reach", 3.0),
    ("explosions.0.envelope.start", 0.5),
];

/// Outward speed after each step of a particle that starts at rest at the distance `r`.
fn speeds(settings: &[(&str, f64)], r: f32, count: usize) -> Vec<f64> {
    let mut simulator = alone(settings, [0.0, 0.0, r], [0.0; 3]);
    (0..count)
        .map(|_| {
            simulator.step();
            f64::from(slip(&simulator, 0)[2])
        })
        .collect()
}

#[test]
fn the_front_accelerates_once_when_it_passes() {
    for integrator in [0.0, 1.0] {
        let settings = [BLAST.as_slice(), &[("simulation.integrator", integrator)]].concat();
        for r in [0.05_f32, 0.77, 1.31, 2.9] {
            let speeds = speeds(&settings, r, 120);
            let passed = 0.5 + f64::from(r) / 6.0;
            let expected = 4.0 * (1.0 - f64::from(r).powi(2) / 9.0).powi(2);
            for (step, speed) in speeds.iter().enumerate() {
                let (start, end) = (step as f64 * STEP, (step + 1) as f64 * STEP);
                if end < passed {
                    assert_eq!(*speed, 0.0, "{r} m, thrown at {end} s, before {passed} s");
                } else if start > passed + STEP {
                    assert_close("speed", *speed, expected, 1e-4);
                }
            }
        }
    }
}

#[test]
fn there_is_no_effect_beyond_its_reach_or_before_its_start() {
    assert!(speeds(&BLAST, 3.01, 120).iter().all(|speed| *speed == 0.0));
    assert!(speeds(&BLAST, 0.01, 29).iter().all(|speed| *speed == 0.0));
}

#[test]
fn it_accelerates_again_in_each_period() {
    let settings = [
        BLAST.as_slice(),
        &[("explosions.0.envelope.period", 0.7), ("drag.rate", 1000.0)],
    ]
    .concat();
    let mut simulator = alone(&settings, [0.0, 0.0, 0.4], [0.0; 3]);
    let mut thrown = Vec::new();
    for step in 0..240_u32 {
        let before = place(&simulator, 0);
        simulator.step();
        if place(&simulator, 0) != before && thrown.last().is_none_or(|last| step - last > 5) {
            thrown.push(step);
        }
    }
    let times: Vec<_> = thrown.iter().map(|step| f64::from(*step) * STEP).collect();
    assert_eq!(times.len(), 5, "thrown at {times:?}");
    for (n, time) in times.iter().enumerate() {
        let passed = 0.5 + 0.7 * n as f64 + 0.4 / 6.0;
        assert!((time - passed).abs() < 2.0 * STEP, "thrown at {time} s, not {passed} s");
    }
}

#[test]
fn moving_smoke_is_also_accelerated_once() {
    for (velocity, integrator) in [(2.0, 0.0), (-2.0, 0.0), (2.0, 1.0), (-2.0, 1.0)] {
        let settings = [
            BLAST.as_slice(),
            &[("simulation.integrator", integrator), ("explosions.0.reach", 1000.0)],
        ]
        .concat();
        let mut simulator = alone(&settings, [9.0, 0.0, 0.0], [velocity, 0.0, 0.0]);
        steps(&mut simulator, 300);
        assert_close(
            "velocity",
            f64::from(slip(&simulator, 0)[0]),
            f64::from(velocity) + 4.0,
            1e-3,
        );
    }
}

#[test]
fn a_cloud_that_is_symmetric_gets_no_momentum() {
    let mut simulator = simulator(600, 1, &[STILL, &BLAST]);
    for k in 0..300_u32 {
        let at = |salt: u32| (f64::from((k * 7919 + salt * 104_729) % 2003) / 1001.5 - 1.0) as f32 * 1.5;
        let position = [at(1), at(2), at(3)];
        simulator.add(&newborn(position));
        simulator.add(&newborn(position.map(|c| -c)));
    }
    steps(&mut simulator, 120);
    for axis in 0..3 {
        let sum: f64 = (0..600).map(|i| f64::from(slip(&simulator, i)[axis])).sum();
        assert!(sum.abs() < 1e-3, "momentum {sum} along axis {axis}");
    }
    let thrown = (0..600).filter(|i| slip(&simulator, *i) != [0.0; 3]).count();
    assert_eq!(thrown, 600);
}

#[test]
fn wind_is_clamped_to_the_limit() {
    let settings = [
        ("forces.wind.x", 4.0),
        ("forces.wind.z", 3.0),
        ("speedLimits.0.speed", 1.5),
    ];
    let mut simulator = alone(&settings, [0.0; 3], [0.0; 3]);
    steps(&mut simulator, 60);
    let [x, y, z] = place(&simulator, 0).map(f64::from);
    assert_close("x", x, 1.2, 1e-4);
    assert_close("z", z, 0.9, 1e-4);
    assert_eq!(y, 0.0);
}

#[test]
fn a_fall_is_the_parabola_up_to_the_limit_and_then_even() {
    for integrator in [0.0, 1.0] {
        let settings = [
            ("gravity.acceleration", 5.0),
            ("speedLimits.0.speed", 2.0),
            ("simulation.integrator", integrator),
        ];
        let mut simulator = alone(&settings, [0.0; 3], [0.0; 3]);
        let mut before = 0.0;
        for step in 1..=120 {
            simulator.step();
            let (t, y) = (f64::from(step) * STEP, f64::from(place(&simulator, 0)[1]));
            // Euler lags by half a step.
            let expected = if t < 0.4 { -2.5 * t * t } else { -0.4 - 2.0 * (t - 0.4) };
            assert!((y - expected).abs() < 0.5 * STEP * 2.0 + 1e-4, "{y} after {t} s");
            assert!(before - y <= 2.0 * STEP * 1.000_1, "{} m/s", (before - y) / STEP);
            before = y;
        }
        assert!(f64::from(slip(&simulator, 0)[1]) >= -2.05, "slip piles up");
    }
}

#[test]
fn a_limit_does_not_affect_slower_or_outside_particles() {
    let settings = [
        ("speedLimits.0.speed", 1.0),
        ("speedLimits.0.region.shape", 1.0),
        ("speedLimits.0.region.softness", 0.0),
    ];
    let mut slow = alone(&settings, [0.0; 3], [0.999, 0.0, 0.0]);
    let mut outside = alone(&settings, [5.0, 0.0, 0.0], [3.0, 0.0, 0.0]);
    steps(&mut slow, 30);
    steps(&mut outside, 30);
    assert_eq!(slip(&slow, 0), [0.999, 0.0, 0.0]);
    assert_eq!(slip(&outside, 0), [3.0, 0.0, 0.0]);
    let mut stopped = alone(&[("speedLimits.0.speed", 0.0)], [1.0; 3], [9.0, 1.0, 0.0]);
    steps(&mut stopped, 2);
    assert_eq!((place(&stopped, 0), slip(&stopped, 0)), ([1.0; 3], [0.0; 3]));
}
