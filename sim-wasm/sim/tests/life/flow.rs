//! Turning and stretching with the air.

use crate::common::{LIVELY, STILL, newborn, simulator, steps};
use sim::Simulator;
use sim::arrange::row_layout::{Attributes, MAX_STRETCH, NO_ROTATION, QUATERNION_STEPS, STRETCH};
use sim::arrange::view_layout::ViewNumbers;
use sim::particles::Newborn;

const BOTH: &[(&str, f64)] = &[("puff.turn", 1.0), ("puff.stretch", 3.0)];

fn rows(simulator: &mut Simulator, blend: f32) -> Vec<([f32; 4], Attributes)> {
    let view = ViewNumbers {
        blend,
        direction: [0.0, 0.0, -1.0],
        ..ViewNumbers::default()
    };
    let count = simulator.arrange(&view.to_array()).unwrap();
    let rows = simulator.place()[..count].iter().zip(simulator.attributes());
    rows.map(|(place, attributes)| (*place, *attributes)).collect()
}

/// The quaternion x, y, z, w of a row.
fn turn(attributes: Attributes) -> [f64; 4] {
    let word = attributes[2] ^ NO_ROTATION;
    let largest = (word >> 30) as usize;
    let mut turn = [0.0; 4];
    for place in 0..3 {
        turn[(largest + 1 + place) % 4] =
            (f64::from(word >> (10 * place) & 0x3ff) - 512.0) / f64::from(QUATERNION_STEPS);
    }
    turn[largest] = (1.0 - turn.iter().map(|part| part * part).sum::<f64>()).sqrt();
    turn
}

/// Angle (rad) about z, -pi..pi.
fn angle_about_z(attributes: Attributes) -> f64 {
    let [x, y, z, w] = turn(attributes);
    assert!(x.abs() < 0.003 && y.abs() < 0.003, "turned about {x}, {y}, {z}");
    let angle = 2.0 * z.atan2(w);
    (angle + std::f64::consts::PI).rem_euclid(std::f64::consts::TAU) - std::f64::consts::PI
}

fn ratio(attributes: Attributes) -> f64 {
    1.0 + f64::from(MAX_STRETCH - 1.0) * f64::from(STRETCH.of(attributes)) / f64::from(STRETCH.max)
}

/// A particle with a speed (m/s) along x relative to the air.
fn thrown(settings: &[(&str, f64)], speed: f32) -> Simulator {
    let mut simulator = simulator(1, 1, &[STILL, &[("emission.growthTime", 0.0)], settings]);
    simulator.add(&Newborn {
        slip: [speed, 0.0, 0.0],
        ..newborn([0.0; 3])
    });
    simulator
}

fn one(settings: &[(&str, f64)], position: [f32; 3]) -> Simulator {
    let mut simulator = simulator(1, 1, &[STILL, &[("emission.growthTime", 0.0)], settings]);
    simulator.add(&newborn(position));
    simulator
}

#[test]
fn a_puff_in_a_solid_rotation_turns_with_it() {
    // The core of Rankine rotates at circulation / (2 pi c^2).
    for (speed, share) in [(0.4, 1.0), (-1.1, 1.0), (0.9, 0.5)] {
        let core = 3.0;
        let circulation = speed * std::f64::consts::TAU * core * core;
        let settings = [
            ("puff.turn", share),
            ("vortices.0.circulation", circulation),
            ("vortices.0.coreRadius", core),
            ("vortices.0.reach", 1000.0),
            ("vortices.0.profile", 1.0),
            ("vortices.0.axis.x", 0.0),
            ("vortices.0.axis.y", 0.0),
            ("vortices.0.axis.z", 1.0),
        ];
        let mut simulator = one(&settings, [0.4, 0.2, 0.0]);
        steps(&mut simulator, 12);
        let first = angle_about_z(rows(&mut simulator, 1.0)[0].1);
        steps(&mut simulator, 90);
        let turned = angle_about_z(rows(&mut simulator, 1.0)[0].1) - first;
        assert!((turned - share * speed * 1.5).abs() < 0.01, "{turned} at {speed} rad/s");
        let half = angle_about_z(rows(&mut simulator, 0.5)[0].1) - first;
        assert!(
            (half - share * speed * (1.5 - 0.5 / 60.0)).abs() < 0.01,
            "{half} half a step before"
        );
    }
}

#[test]
fn a_puff_in_a_shear_turns_by_half_of_it() {
    let settings = [("puff.turn", 1.0), ("forces.wind.x", 2.0), ("wind.shear", 0.4)];
    let mut simulator = one(&settings, [0.0, 1.0, 0.0]);
    steps(&mut simulator, 12);
    let first = angle_about_z(rows(&mut simulator, 1.0)[0].1);
    steps(&mut simulator, 60);
    let turned = angle_about_z(rows(&mut simulator, 1.0)[0].1) - first;
    assert!((turned + 0.4).abs() < 0.01, "{turned}");
}

#[test]
fn a_puff_in_a_uniform_flow_does_not_turn() {
    let mut simulator = one(&[("puff.turn", 2.0), ("forces.wind.x", 7.0)], [0.3, 0.2, 0.1]);
    steps(&mut simulator, 100);
    assert_eq!(rows(&mut simulator, 0.3)[0].1[2], 0);
}

#[test]
fn the_stretch_rises_with_the_speed_to_its_limit() {
    let ratios = [0.0, 1.0, 4.0, 50.0].map(|speed| {
        let mut simulator = thrown(&[("puff.stretch", 3.0), ("forces.wind.x", -5.0)], speed);
        steps(&mut simulator, 120);
        let (_, attributes) = rows(&mut simulator, 1.0)[0];
        // The octahedral map has x at the right end of the first coordinate. The wind does not stretch.
        assert!(
            speed == 0.0 || attributes[3] & 0xffff == 127 << 8 | 254,
            "{attributes:x?}"
        );
        ratio(attributes)
    });
    assert!(ratios[0] == 1.0 && ratios.is_sorted() && ratios[3] <= 3.0, "{ratios:?}");
    // At 1 m/s the size of 0.2 m is half of the way in 0.4 s.
    assert!((ratios[1] - (1.0 + 2.0 * 2.0 / 3.0)).abs() < 0.02, "{ratios:?}");
}

#[test]
fn a_moving_puff_that_tears_or_thins_ends_longer() {
    // Dissolving, a speed (m/s) and the ratio at the end.
    for (dissolve, speed, end) in [
        (0.0, 4.0, 1.0),
        (1.0, 4.0, 1.0),
        (2.0, 4.0, 2.4),
        (3.0, 4.0, 4.0),
        (3.0, 0.0, 1.0),
    ] {
        let settings = [("emission.dissolve", dissolve), ("emission.growthTime", 0.0)];
        let mut simulator = simulator(1, 1, &[STILL, &settings]);
        simulator.add(&Newborn {
            slip: [speed, 0.0, 0.0],
            lifetime: 4.0,
            ..newborn([0.0; 3])
        });
        let mut ratios = Vec::new();
        loop {
            steps(&mut simulator, 1);
            let Some((_, attributes)) = rows(&mut simulator, 1.0).first().copied() else {
                break;
            };
            ratios.push(ratio(attributes));
        }
        let worn = |share: f64| ratios[(share * ratios.len() as f64) as usize];
        assert_eq!(worn(0.2), 1.0, "before it dissolves");
        assert!(
            (worn(0.5) - (3.0 + end) / 4.0).abs() < 0.1,
            "{} halfway to {end}",
            worn(0.5)
        );
        assert!((worn(0.9) - end).abs() < 0.02, "{} instead of {end}", worn(0.9));
        assert!(ratios.is_sorted(), "{ratios:?}");
    }
}

#[test]
fn a_newborn_is_round_and_the_stretch_is_continuous() {
    let mut simulator = thrown(&[("puff.stretch", 4.0)], 2.25);
    let mut before = 1.0;
    for _ in 0..60 {
        simulator.step();
        for blend in [0.0, 0.5, 1.0] {
            let Some((_, attributes)) = rows(&mut simulator, blend).first().copied() else {
                continue;
            };
            let now = ratio(attributes);
            assert!((-0.02..0.7).contains(&(now - before)), "from {before} to {now}");
            before = now;
        }
    }
}

#[test]
fn drawing_does_not_change_the_state() {
    let mut plain = simulator(400, 5, &[LIVELY]);
    let mut turning = simulator(400, 5, &[LIVELY, BOTH, &[("puff.billow", 1.0)]]);
    for _ in 0..200 {
        plain.step();
        turning.step();
        assert_eq!(plain.hash(), turning.hash());
    }
    let (plain, turning) = (rows(&mut plain, 0.4), rows(&mut turning, 0.4));
    assert!(plain.iter().all(|(_, attributes)| attributes[2..] == [0, 0]));
    let changed = turning
        .iter()
        .filter(|(_, attributes)| attributes[2] != 0 && attributes[3] != 0);
    assert!(2 * changed.count() > turning.len());
    assert!(
        plain
            .iter()
            .zip(&turning)
            .all(|(a, b)| a.0 == b.0 && a.1[..2] == b.1[..2])
    );
}

#[test]
fn saved_and_restored_rows_are_equal_to_the_bit() {
    for hold in [1.0, 3.0] {
        let settings = [("style.hold", hold)];
        let mut original = simulator(400, 5, &[LIVELY, BOTH, &settings]);
        steps(&mut original, 131);
        let bytes = original.save();
        let mut restored = Simulator::new(400, 9).unwrap();
        restored.restore(&bytes).unwrap();
        for _ in 0..40 {
            for blend in [0.0, 0.7] {
                let [expected, found] = [&mut original, &mut restored].map(|simulator| rows(simulator, blend));
                let different = expected.iter().zip(&found).find(|(a, b)| a != b);
                assert!(
                    expected.len() == found.len() && different.is_none(),
                    "hold {hold}: {different:?}"
                );
            }
            steps(&mut original, 1);
            steps(&mut restored, 1);
        }
    }
}

#[test]
fn a_larger_simulator_keeps_the_turns() {
    let mut simulator = simulator(400, 5, &[LIVELY, BOTH]);
    steps(&mut simulator, 100);
    let before = rows(&mut simulator, 0.5);
    simulator.resize(900).unwrap();
    assert!(before == rows(&mut simulator, 0.5));
}

#[test]
fn a_gap_is_filled_with_the_whole_particle() {
    let mut simulator = simulator(2, 1, &[STILL, BOTH, &[("emission.growthTime", 0.0)]]);
    let slip = [5.0, 0.0, 0.0];
    simulator.add(&Newborn {
        lifetime: 0.3,
        slip,
        ..newborn([0.0; 3])
    });
    simulator.add(&Newborn {
        slip,
        ..newborn([3.0, 0.0, 0.0])
    });
    steps(&mut simulator, 15);
    let before = ratio(rows(&mut simulator, 1.0)[1].1);
    steps(&mut simulator, 15);
    let left = rows(&mut simulator, 1.0);
    assert!(
        left.len() == 1 && ratio(left[0].1) >= before && before > 1.5,
        "{left:?}"
    );
}

#[test]
fn a_particle_takes_at_most_112_bytes() {
    let mut simulator = simulator(400, 5, &[LIVELY, BOTH, &[("style.hold", 2.0)]]);
    steps(&mut simulator, 1);
    let particles = simulator.particles();
    let held = particles.held.as_ref().unwrap().columns().len();
    let flow = particles.flow.as_ref().unwrap().columns.len();
    assert!(4 * (particles.float_columns().len() + 1 + held + flow) <= 112);
}
