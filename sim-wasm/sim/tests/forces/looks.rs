//! Factors of looks on drag, buoyancy and gravity.

use crate::common::{LIVELY, STEP, STILL, assert_close, simulator, steps};
use sim::Simulator;
use sim::layout::scope::parts::PART_FLOATS;

/// One puff of each emitter at time 0, at rest in the air and for longer than the tests.
fn one_each(emitters: usize, settings: &[(&str, f64)]) -> Simulator {
    let mut simulator = simulator(
        100,
        1,
        &[STILL, &[("emission.rate", 0.0), ("emission.lifetime", 60.0)], settings],
    );
    for emitter in 0..emitters {
        for (name, value) in [("speed", 0.0), ("burst.count", 1.0), ("lifetimeVariation", 0.0)] {
            simulator.set(&format!("emitters.{emitter}.{name}"), value).unwrap();
        }
    }
    simulator
}

/// Height and upward velocity of the puff of look `look`.
fn rise(simulator: &Simulator, look: u32) -> (f64, f64) {
    let particles = simulator.particles();
    let i = (0..simulator.alive()).find(|i| particles.look(*i) == look).unwrap();
    (f64::from(particles.y[i]), f64::from(particles.sy[i]))
}

#[test]
fn gravity_and_drag_of_each_look_have_the_closed_form() {
    let (g, k) = (9.81, 1.5);
    let looks = [(0.5, 1.0), (1.0, 0.25), (3.0, 2.0), (10.0, 0.0), (0.0, 0.0)];
    let mut simulator = one_each(6, &[("gravity.acceleration", g), ("drag.rate", k)]);
    for (emitter, (gravity, drag)) in looks.into_iter().enumerate() {
        simulator
            .set(&format!("emitters.{emitter}.look.gravity"), gravity)
            .unwrap();
        simulator.set(&format!("emitters.{emitter}.look.drag"), drag).unwrap();
    }
    steps(&mut simulator, 90);
    let t = 90.0 * STEP;
    let all = [&[(1.0, 1.0)], &looks[..]].concat();
    for (look, (gravity, drag)) in all.into_iter().enumerate() {
        let (g, k) = (g * gravity, k * drag);
        let (height, speed) = if k == 0.0 {
            (-0.5 * g * t * t, -g * t)
        } else {
            let gone = (1.0 - (-k * t).exp()) / k;
            (-g / k * (t - gone), -g * gone)
        };
        let found = rise(&simulator, look as u32);
        assert_close("height", found.0, height, 1e-3);
        assert_close("speed", found.1, speed, 1e-4);
    }
}

#[test]
fn buoyancy_of_a_look_has_the_closed_form() {
    let (k, tau, b) = (2.0, 1.5, 1.2);
    let settings = [
        ("buoyancy.acceleration", b),
        ("buoyancy.coolingTime", tau),
        ("drag.rate", k),
        ("emitters.0.look.buoyancy", 4.0),
        ("emitters.1.look.buoyancy", 0.0),
    ];
    let mut simulator = one_each(2, &settings);
    steps(&mut simulator, 90);
    let t = 90.0 * STEP;
    let expected = 4.0 * b / (k - 1.0 / tau) * ((-t / tau).exp() - (-k * t).exp());
    assert_close("speed", rise(&simulator, 1).1, expected, 0.01);
    assert_eq!(rise(&simulator, 2), (0.0, 0.0));
    // Factors do not change the temperature.
    assert_close(
        "temperature",
        f64::from(simulator.particles().temperature[0]),
        (-t / tau).exp(),
        1e-4,
    );
}

/// A look that has factors on forces, against a smoke that has them for all.
#[test]
fn a_factor_of_a_look_equals_that_of_the_smoke() {
    let forces = [
        ("gravity.acceleration", 1.0),
        ("buoyancy.acceleration", 2.5),
        ("drag.rate", 0.8),
        ("drag.quadratic", 0.6),
        ("drags.0.rate", 0.7),
        ("gravities.0.acceleration.x", 1.5),
        ("buoyancies.0.acceleration", 0.9),
        ("forces.wind.z", 1.0),
    ];
    // Where up is not y, gravity and buoyancy are forces like others.
    let up = [[0.0, 1.0, 0.0], [0.6, 0.8, 0.0]];
    for (integrator, up) in [(0.0, up[0]), (0.0, up[1]), (1.0, up[0]), (1.0, up[1])] {
        let run = |prefix: &str| {
            let integrator = [("simulation.integrator", integrator)];
            let mut simulator = one_each(1, &[&forces[..], &integrator].concat());
            for (name, factor) in [("drag", 1.7), ("buoyancy", 0.4), ("gravity", 2.2)] {
                simulator.set(&format!("{prefix}.{name}"), factor).unwrap();
            }
            for _ in 0..60 {
                let parts = [0.0_f32; 2 * PART_FLOATS];
                let rest: Vec<f32> = parts
                    .iter()
                    .enumerate()
                    .map(|(at, _)| f32::from(u8::from(at % 8 == 7)))
                    .collect();
                simulator.place_parts(&[&rest[..], &up].concat()).unwrap();
                simulator.step();
            }
            let particles = simulator.particles();
            [
                particles.x[0],
                particles.y[0],
                particles.z[0],
                particles.sx[0],
                particles.sy[0],
                particles.sz[0],
            ]
        };
        let own = run("emitters.0.look");
        assert!(
            own[..5].iter().all(|number| number.abs() > 0.01),
            "nothing moved it: {own:?}"
        );
        for (ours, theirs) in own.into_iter().zip(run("forces")) {
            assert_close("with a look", f64::from(ours), f64::from(theirs), 1e-5);
        }
    }
}

/// All columns of the particles, as bits.
fn columns(simulator: &Simulator) -> Vec<Vec<u32>> {
    let alive = simulator.alive();
    let columns = simulator.particles().float_columns();
    columns
        .map(|column| column[..alive].iter().map(|value| value.to_bits()).collect())
        .to_vec()
}

#[test]
fn a_style_alone_moves_nothing() {
    for integrator in [0.0, 1.0] {
        let mut plain = simulator(2000, 5, &[LIVELY, &[("simulation.integrator", integrator)]]);
        let mut styled = simulator(2000, 5, &[LIVELY, &[("simulation.integrator", integrator)]]);
        styled.set("emitters.1.look.style", 7.0).unwrap();
        for _ in 0..6 {
            steps(&mut plain, 20);
            steps(&mut styled, 20);
            assert_eq!(columns(&plain), columns(&styled));
        }
        assert_ne!(plain.hash(), styled.hash());
    }
}

#[test]
fn puffs_without_a_look_move_as_if_no_others_had_one() {
    let settings = [("drag.quadratic", 0.3), ("emitters.2.speed", 1.0)];
    for settings in [&settings[..1], &settings[1..]] {
        let mut plain = simulator(4000, 5, &[LIVELY, settings]);
        let mut looking = simulator(4000, 5, &[LIVELY, settings]);
        let look = [
            ("emitters.1.look.drag", 3.0),
            ("emitters.1.look.gravity", 0.5),
            ("emitters.1.look.buoyancy", 2.0),
        ];
        looking.set_all(&look).unwrap();
        for _ in 0..6 {
            steps(&mut plain, 20);
            steps(&mut looking, 20);
            assert_eq!(plain.alive(), looking.alive());
            let (plain, with) = (columns(&plain), columns(&looking));
            let mut moved = 0;
            for i in 0..looking.alive() {
                let is_equal = plain.iter().zip(&with).all(|(a, b)| a[i] == b[i]);
                let has_look = looking.particles().look(i) > 0;
                assert!(is_equal || has_look, "particle {i} moves otherwise");
                moved += usize::from(!is_equal);
            }
            assert!(moved > 30);
        }
    }
}
