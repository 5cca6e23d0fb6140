//! Each force against its closed form.

use std::f64::consts::{PI, TAU};

use crate::common::{STILL, newborn, place, simulator, steps};
use sim::particles::Newborn;

const STEP: f64 = 1.0 / 60.0;

/// Height and upward velocity of one particle after `count` steps from `speed` upwards.
fn rise(settings: &[(&str, f64)], speed: f32, count: usize) -> (f64, f64) {
    let mut simulator = simulator(1, 1, &[STILL, settings]);
    simulator.add(&Newborn {
        slip: [0.0, speed, 0.0],
        ..newborn([0.0; 3])
    });
    steps(&mut simulator, count);
    (
        f64::from(simulator.particles().y[0]),
        f64::from(simulator.particles().sy[0]),
    )
}

fn assert_close(name: &str, value: f64, expected: f64, tolerance: f64) {
    assert!(
        (value - expected).abs() <= tolerance * expected.abs(),
        "{name}: {value}, expected {expected}"
    );
}

#[test]
fn ballistics_without_drag_is_the_parabola() {
    for count in [1_usize, 30, 90, 200] {
        let t = count as f64 * STEP;
        let (height, speed) = rise(&[("gravity.acceleration", 9.81)], 8.0, count);
        assert_close("height", height, 8.0 * t - 0.5 * 9.81 * t * t, 1e-3);
        assert_close("speed", speed, 8.0 - 9.81 * t, 1e-3);
    }
}

#[test]
fn ballistics_with_drag_is_the_closed_form() {
    for k in [1e-4, 0.3, 2.0, 20.0, 900.0] {
        let (t, terminal) = (100.0 * STEP, -9.81 / k);
        let left = (-k * t).exp();
        let (height, speed) = rise(&[("gravity.acceleration", 9.81), ("drag.rate", k)], 8.0, 100);
        assert_close(
            "height",
            height,
            terminal * t + (8.0 - terminal) * (1.0 - left) / k,
            1e-3,
        );
        assert_close("speed", speed, terminal + (8.0 - terminal) * left, 1e-3);
    }
}

#[test]
fn terminal_velocity_is_lift_over_drag() {
    let settings = [
        ("buoyancy.acceleration", 1.5),
        ("buoyancy.coolingTime", 1000.0),
        ("drag.rate", 2.0),
    ];
    let (height, speed) = rise(&settings, 0.0, 300);
    assert_close("terminal velocity", speed, 1.5 / 2.0, 0.01);
    assert_close("height", height, 0.75 * (5.0 - 0.5), 0.01);
    let multiplied = [("forces.buoyancy", 3.0), ("forces.drag", 0.5), ("forces.gravity", 2.0)];
    let settings = [settings.as_slice(), &multiplied, &[("gravity.acceleration", 0.5)]].concat();
    assert_close(
        "with multipliers",
        rise(&settings, 0.0, 600).1,
        (4.5 - 1.0) / 1.0,
        0.015,
    );
}

#[test]
fn buoyancy_fades_as_smoke_cools() {
    let (k, tau, b) = (2.0, 1.5, 1.2);
    let settings = [
        ("buoyancy.acceleration", b),
        ("buoyancy.coolingTime", tau),
        ("drag.rate", k),
    ];
    for count in [30_usize, 90, 240] {
        let t = count as f64 * STEP;
        let expected = b / (k - 1.0 / tau) * ((-t / tau).exp() - (-k * t).exp());
        assert_close("speed", rise(&settings, 0.0, count).1, expected, 0.01);
    }
    let mut cooling = simulator(1, 1, &[STILL, &settings]);
    cooling.add(&newborn([0.0; 3]));
    steps(&mut cooling, 90);
    assert_close(
        "temperature",
        f64::from(cooling.particles().temperature[0]),
        (-1.0_f64).exp(),
        1e-4,
    );
}

#[test]
fn wind_carries_exactly_and_drag_takes_slip_to_it() {
    for rate in [0.0, 1.0, 1000.0] {
        let settings = [
            ("forces.wind.x", 2.0),
            ("forces.wind.z", -1.0),
            ("drag.rate", rate),
            ("forces.drag", 10.0),
        ];
        let mut simulator = simulator(1, 1, &[STILL, &settings]);
        simulator.add(&newborn([0.0; 3]));
        steps(&mut simulator, 600);
        let [x, y, z] = place(&simulator, 0).map(f64::from);
        assert_close("x", x, 20.0, 1e-4);
        assert_close("z", z, -10.0, 1e-4);
        assert_eq!(y, 0.0);
    }
}

#[test]
fn huge_drag_stops_slip_at_once_and_no_drag_keeps_it() {
    let stopped = rise(&[("drag.rate", 1000.0), ("forces.drag", 10.0)], 50.0, 600);
    assert!(stopped.1.abs() < 1e-6 && stopped.0 < 0.006, "{stopped:?}");
    let (height, speed) = rise(&[], 50.0, 60);
    assert_eq!(speed, 50.0);
    assert_close("height", height, 50.0, 1e-5);
}

/// Number of steps for `turns` revolutions about z, and the minimum and maximum distance during them.
fn circle(settings: &[(&str, f64)], r: f32, turns: f64) -> (f64, f64) {
    let mut simulator = simulator(1, 1, &[STILL, settings]);
    simulator.add(&newborn([r, 0.0, 0.3]));
    let (mut least, mut greatest, mut angle, mut before) = (f64::MAX, 0.0_f64, 0.0, 0.0);
    while angle < turns * TAU {
        simulator.step();
        let [x, y, _] = place(&simulator, 0).map(f64::from);
        let (distance, now) = (x.hypot(y), y.atan2(x));
        angle += (now - before).rem_euclid(TAU);
        before = now;
        (least, greatest) = (least.min(distance), greatest.max(distance));
        assert!(simulator.steps() < 500_000, "hardly turns at {r}");
    }
    (least, greatest)
}

#[test]
fn a_vortex_keeps_the_distance_over_20_turns() {
    for circulation in [4.0, 40.0] {
        let vortex = [("vortices.0.circulation", circulation), ("vortices.0.reach", 8.0)];
        for r in [0.05_f32, 0.25, 0.5, 1.0, 2.0] {
            let (least, greatest) = circle(&vortex, r, 20.0);
            let drift = (greatest / f64::from(r) - 1.0).max(1.0 - least / f64::from(r));
            assert!(
                drift < 0.01,
                "circulation {circulation}, distance {r}: drifts by {drift}"
            );
        }
    }
}

#[test]
fn a_vortex_turns_at_its_angular_velocity() {
    let r = 0.6_f64;
    let settings = [
        ("vortices.0.circulation", 2.0),
        ("vortices.0.coreRadius", 0.3),
        ("vortices.0.reach", 5.0),
    ];
    let mut simulator = simulator(1, 1, &[STILL, &settings]);
    simulator.add(&newborn([r as f32, 0.0, 0.0]));
    let fade = (1.0 - r * r / 25.0).powi(2);
    let velocity = 2.0 / (TAU * r * r) * (1.0 - (-r * r / 0.09).exp()) * fade;
    let count = (PI / 2.0 / velocity / STEP).round() as usize;
    steps(&mut simulator, count);
    let [x, y, _] = place(&simulator, 0).map(f64::from);
    assert_close("angle", y.atan2(x), velocity * count as f64 * STEP, 0.002);
}

#[test]
fn two_vortices_in_wind_follow_the_true_path() {
    let settings = [
        ("vortices.0.circulation", 1.5),
        ("vortices.0.reach", 6.0),
        ("vortices.1.circulation", -1.0),
        ("vortices.1.reach", 6.0),
        ("vortices.1.position.x", 1.2),
        ("vortices.1.axis.y", 0.7),
        ("forces.wind.x", 0.4),
    ];
    let mut simulator = simulator(1, 1, &[STILL, &settings]);
    simulator.add(&newborn([0.5, 0.1, 0.0]));
    steps(&mut simulator, 120);
    let velocity = |p: [f64; 3]| simulator.air_velocity(p.map(|c| c as f32)).map(f64::from);
    let shifted = |p: [f64; 3], v: [f64; 3], h: f64| std::array::from_fn(|i| p[i] + v[i] * h);
    let (mut p, h) = ([0.5, 0.1, 0.0], STEP / 10.0);
    for _ in 0..1200 {
        let a = velocity(p);
        let b = velocity(shifted(p, a, h / 2.0));
        let c = velocity(shifted(p, b, h / 2.0));
        let d = velocity(shifted(p, c, h));
        p = std::array::from_fn(|i| p[i] + h / 6.0 * (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i]));
    }
    let off = place(&simulator, 0)
        .iter()
        .zip(p)
        .map(|(a, b)| (f64::from(*a) - b).powi(2))
        .sum::<f64>()
        .sqrt();
    assert!(off < 5e-3, "{off} m beside the true path after 2 s");
}

#[test]
fn turbulence_follows_the_true_path_better_than_euler() {
    let settings = [
        ("turbulence.speed", 1.0),
        ("turbulence.octaves", 1.0),
        ("turbulence.evolution", 0.0),
    ];
    let mut simulator = simulator(1, 1, &[STILL, &settings]);
    simulator.add(&newborn([0.5, 0.1, 0.0]));
    steps(&mut simulator, 120);
    let path = |count: usize| {
        let h = 2.0 / count as f64;
        (0..count).fold([0.5, 0.1, 0.0], |p: [f64; 3], _| {
            let v = simulator.air_velocity(p.map(|c| c as f32)).map(f64::from);
            std::array::from_fn(|i| p[i] + h * v[i])
        })
    };
    let (exact, euler) = (path(100_000), path(120));
    let off = |p: [f64; 3]| p.iter().zip(exact).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt();
    let ours = off(place(&simulator, 0).map(f64::from));
    assert!(
        ours < 0.2 * off(euler),
        "{ours} m beside the true path, Euler {}",
        off(euler)
    );
}

#[test]
fn paper_is_forward_euler() {
    let settings = [
        ("simulation.integrator", 1.0),
        ("drag.rate", 1.5),
        ("forces.wind.x", 2.0),
        ("gravity.acceleration", 3.0),
    ];
    let mut simulator = simulator(1, 1, &[STILL, &settings]);
    simulator.add(&Newborn {
        slip: [0.0, 4.0, 0.0],
        ..newborn([0.0; 3])
    });
    let (mut p, mut v) = ([0.0_f64; 2], [0.0_f64, 4.0]);
    for _ in 0..100 {
        simulator.step();
        p = [p[0] + STEP * v[0], p[1] + STEP * v[1]];
        v = [v[0] + STEP * 1.5 * (2.0 - v[0]), v[1] + STEP * (-1.5 * v[1] - 3.0)];
    }
    let [x, y, _] = place(&simulator, 0).map(f64::from);
    assert_close("x", x, p[0], 1e-4);
    assert_close("y", y, p[1], 1e-4);
}

#[test]
fn paper_is_stable_under_any_drag() {
    let settings = [
        ("simulation.integrator", 1.0),
        ("drag.rate", 1000.0),
        ("forces.drag", 10.0),
        ("forces.wind.x", 2.0),
    ];
    let mut simulator = simulator(1, 1, &[STILL, &settings]);
    simulator.add(&newborn([0.0; 3]));
    steps(&mut simulator, 300);
    assert_eq!(simulator.particles().sx[0], 2.0);
}

#[test]
fn changing_the_integrator_keeps_the_velocity() {
    let mut simulator = simulator(
        1,
        1,
        &[STILL, &[("forces.wind.x", 2.0), ("vortices.0.circulation", 1.0)]],
    );
    simulator.add(&Newborn {
        slip: [0.0, 1.0, 0.5],
        ..newborn([0.5, 0.0, 0.0])
    });
    let moved = |simulator: &mut sim::Simulator| {
        simulator.step();
        let particles = simulator.particles();
        [
            particles.x[0] - particles.px[0],
            particles.y[0] - particles.py[0],
            particles.z[0] - particles.pz[0],
        ]
    };
    let before = moved(&mut simulator);
    simulator.set("simulation.integrator", 1.0).unwrap();
    let after = moved(&mut simulator);
    let change = before.iter().zip(after).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max);
    assert!(change < 0.003, "{before:?} then {after:?}");
    simulator.set("simulation.integrator", 0.0).unwrap();
    let slip = simulator.particles().sx[0].hypot(simulator.particles().sy[0] - 1.0);
    assert!(slip < 0.1, "the slip is {slip} off after there and back");
}
