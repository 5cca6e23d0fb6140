//! Vortices with inflow and updraft, Rankine's core, and mirrored scenes.

use std::f64::consts::TAU;

use crate::common::{STILL, newborn, place, simulator, steps};
use sim::Simulator;
use sim::math::random::Random;

const STEP: f64 = 1.0 / 60.0;
/// So far away that nothing fades.
const FAR: (&str, f64) = ("vortices.0.reach", 1000.0);

fn vortex(settings: &[(&'static str, f64)], at: [f32; 3]) -> Simulator {
    let mut simulator = simulator(1, 1, &[STILL, &[FAR], settings]);
    simulator.add(&newborn(at));
    simulator
}

fn radius(simulator: &Simulator) -> f64 {
    let [x, y, _] = place(simulator, 0).map(f64::from);
    x.hypot(y)
}

fn assert_close(name: &str, value: f64, expected: f64, tolerance: f64) {
    assert!(
        (value - expected).abs() <= tolerance * expected.abs(),
        "{name}: {value}, expected {expected}"
    );
}

#[test]
fn the_core_of_rankine_turns_like_a_solid() {
    let (circulation, core) = (3.0, 0.5);
    let turn = circulation / (TAU * core * core);
    for r in [0.1_f32, 0.3, 0.49] {
        let settings = [
            ("vortices.0.profile", 1.0),
            ("vortices.0.circulation", circulation),
            ("vortices.0.coreRadius", core),
        ];
        let mut simulator = vortex(&settings, [r, 0.0, 0.0]);
        steps(&mut simulator, 30);
        let [x, y, _] = place(&simulator, 0).map(f64::from);
        assert_close("angle", y.atan2(x), turn * 30.0 * STEP, 3e-3);
        steps(&mut simulator, 2000);
        assert_close("distance", radius(&simulator), f64::from(r), 2e-3);
    }
}

/// Distance from the axis of a particle that moves inwards at `speed(r)`, by small Runge-Kutta steps.
fn drawn_in(r: f64, seconds: f64, speed: impl Fn(f64) -> f64) -> f64 {
    let h = seconds / 20_000.0;
    (0..20_000).fold(r, |r, _| {
        let middle = r - speed(r) * h / 2.0;
        r - speed(middle) * h
    })
}

#[test]
fn inflow_draws_in_by_its_closed_form_at_any_swirl() {
    let (core, inflow) = (0.5, 0.4);
    let fast = 1.0 - (-1.0_f64).exp();
    for circulation in [0.0, 3.0, -60.0] {
        for profile in [0.0, 1.0] {
            let settings = [
                ("vortices.0.profile", profile),
                ("vortices.0.circulation", circulation),
                ("vortices.0.coreRadius", core),
                ("vortices.0.inflow", inflow),
            ];
            for (r, count) in [(0.45_f32, 60), (2.0, 120), (0.9, 120)] {
                let mut simulator = vortex(&settings, [r, 0.0, 0.2]);
                steps(&mut simulator, count);
                let expected = drawn_in(f64::from(r), count as f64 * STEP, |r| {
                    let q = r * r / (core * core);
                    let share = if profile == 1.0 {
                        q.min(1.0)
                    } else {
                        (1.0 - (-q).exp()) / fast
                    };
                    inflow * core / r * share
                });
                let name = format!("from {r}, circulation {circulation}, profile {profile}");
                assert_close(&name, radius(&simulator), expected, 4e-3);
                assert_eq!(place(&simulator, 0)[2], 0.2, "moved along the axis");
            }
        }
    }
}

#[test]
fn outflow_pushes_smoke_away() {
    let settings = [
        ("vortices.0.profile", 1.0),
        ("vortices.0.coreRadius", 0.5),
        ("vortices.0.inflow", -0.4),
    ];
    let mut simulator = vortex(&settings, [1.0, 0.0, 0.0]);
    steps(&mut simulator, 120);
    assert_close(
        "distance",
        radius(&simulator),
        (1.0_f64 + 2.0 * 0.4 * 0.5 * 2.0).sqrt(),
        1e-3,
    );
}

#[test]
fn the_strongest_inflow_neither_overshoots_nor_diverges() {
    let settings = [
        ("vortices.0.coreRadius", 0.01),
        ("vortices.0.inflow", 20.0),
        ("vortices.0.circulation", 200.0),
    ];
    let mut simulator = vortex(&settings, [0.5, 0.1, 0.0]);
    let mut before = radius(&simulator);
    for _ in 0..600 {
        simulator.step();
        let now = radius(&simulator);
        assert!(now <= before * 1.001 + 1e-6, "from {before} to {now}");
        before = now;
    }
    assert!(before < 1e-3, "{before} from the axis");
}

#[test]
fn updraft_lifts_only_in_the_core() {
    let settings = [
        ("vortices.0.circulation", 2.0),
        ("vortices.0.coreRadius", 0.5),
        ("vortices.0.updraft", 3.0),
    ];
    for (r, share) in [(0.0_f32, 1.0), (0.25, (1.0_f64 - 0.0625).powi(2)), (0.51, 0.0)] {
        let mut simulator = vortex(&settings, [r, 0.0, 0.0]);
        steps(&mut simulator, 60);
        let height = f64::from(place(&simulator, 0)[2]);
        assert!((height - 3.0 * share).abs() < 0.01, "{height} m at {r}");
        assert!((radius(&simulator) - f64::from(r)).abs() < 2e-3 * f64::from(r) + 1e-6);
    }
}

#[test]
fn a_region_weakens_inflow_and_updraft() {
    let settings = [
        ("vortices.0.inflow", 0.4),
        ("vortices.0.updraft", 3.0),
        ("vortices.0.region.shape", 1.0),
        ("vortices.0.region.position.x", 50.0),
    ];
    let mut simulator = vortex(&settings, [0.1, 0.0, 0.0]);
    steps(&mut simulator, 60);
    assert_eq!(place(&simulator, 0), [0.1, 0.0, 0.0]);
}

/// A scene with one item of each kind without randomness. `side` -1 is its mirror image in the plane x = 0.
fn scene(side: f64) -> Simulator {
    let settings = [
        ("vortices.0.circulation", 4.0 * side),
        ("vortices.0.position.x", 0.3 * side),
        ("vortices.0.axis.x", 0.4 * side),
        ("vortices.0.axis.y", 0.8),
        ("vortices.0.inflow", 0.5),
        ("vortices.0.updraft", 0.7),
        ("vortices.1.profile", 1.0),
        ("vortices.1.circulation", -3.0 * side),
        ("vortices.1.reach", 5.0),
        ("forces.wind.x", 0.4 * side),
        ("drag.rate", 1.2),
        ("buoyancy.acceleration", 1.5),
        ("gravity.acceleration", 0.3),
    ];
    let mut simulator = simulator(400, 1, &[STILL, &settings]);
    let mut random = Random::new(8);
    for _ in 0..400 {
        let [x, y, z]: [f32; 3] = std::array::from_fn(|_| random.signed() * 2.0);
        simulator.add(&newborn([x * side as f32, y, z]));
    }
    simulator
}

#[test]
fn a_mirrored_scene_gives_the_mirrored_picture() {
    let (mut one, mut other) = (scene(1.0), scene(-1.0));
    steps(&mut one, 120);
    steps(&mut other, 120);
    let mut moved = 0.0_f32;
    for i in 0..400 {
        let ([x, y, z], mirrored) = (place(&one, i), place(&other, i));
        // Mirroring an axis reverses the rotation: only signs differ.
        assert_eq!([-x, y, z], mirrored, "particle {i}");
        moved = moved.max(x.abs());
    }
    assert!(moved > 1.0);
}
