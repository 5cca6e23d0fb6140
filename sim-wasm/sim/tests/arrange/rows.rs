//! Rows: selection, order and packing.

use crate::common::{LIVELY, STILL, newborn, place, simulator, steps};
use sim::Simulator;
use sim::arrange::row_layout::EROSION;
use sim::arrange::view_layout::{VIEW_LENGTH, ViewNumbers};
use sim::math::random::Random;
use sim::particles::Newborn;

/// The law of the paper: particles start at full size and have a row from the start.
const FULL: &[(&str, f64)] = &[("simulation.integrator", 1.0)];
const BOX: [f32; 6] = [-12.0, -1.0, -12.0, 12.0, 12.0, 12.0];

/// A view that culls nothing, ordered along -z.
fn view() -> ViewNumbers {
    ViewNumbers {
        blend: 1.0,
        clip_from_world: perspective(),
        direction: [0.0, 0.0, -1.0],
        reach: 1.0,
        receivers: BOX,
        ..ViewNumbers::default()
    }
}

/// clipFromWorld by columns: eye at (1, 2, 9), looking along -z, 50 degrees high, a quarter off-axis.
fn perspective() -> [f32; 16] {
    let (f, near, far) = (1.0 / 25_f32.to_radians().tan(), 0.1, 60.0);
    let (a, b) = ((far + near) / (near - far), 2.0 * far * near / (near - far));
    let projection = [
        f / 1.5,
        0.0,
        0.0,
        0.0,
        0.0,
        f,
        0.0,
        0.0,
        0.25,
        0.0,
        a,
        -1.0,
        0.0,
        0.0,
        b,
        0.0,
    ];
    moved(projection, [-1.0, -2.0, -9.0])
}

fn orthographic() -> [f32; 16] {
    let mut projection = [0.0; 16];
    (projection[0], projection[5], projection[10], projection[15]) = (0.25, 0.4, -0.02, 1.0);
    moved(projection, [0.5, -1.0, -5.0])
}

/// `projection` after a move by `by`.
fn moved(mut projection: [f32; 16], by: [f32; 3]) -> [f32; 16] {
    for row in 0..4 {
        projection[12 + row] += (0..3)
            .map(|column| projection[4 * column + row] * by[column])
            .sum::<f32>();
    }
    projection
}

fn cloud(count: u32) -> Simulator {
    let mut simulator = simulator(count, 1, &[STILL, FULL]);
    let mut random = Random::new(8);
    for _ in 0..count {
        let position = [random.signed() * 12.0, random.unit() * 12.0, random.signed() * 12.0];
        let size = 0.05 + random.unit() * 0.5;
        simulator.add(&Newborn {
            size,
            attributes: random.bits(),
            ..newborn(position)
        });
    }
    simulator
}

fn rows(simulator: &mut Simulator, view: &ViewNumbers) -> Vec<[f32; 4]> {
    let count = simulator.arrange(&view.to_array()).unwrap();
    simulator.place()[..count].to_vec()
}

#[test]
fn rows_come_near_to_far_and_are_complete() {
    let mut simulator = cloud(1001);
    for direction in [[0.0, 0.0, -1.0], [0.6, -0.8, 0.0], [0.48, -0.6, 0.64]] {
        let view = ViewNumbers { direction, ..view() };
        let rows = rows(&mut simulator, &view);
        let depth = |row: &[f32; 4]| row[0] * direction[0] + row[1] * direction[1] + row[2] * direction[2];
        assert!(
            rows.windows(2).all(|pair| depth(&pair[0]) <= depth(&pair[1]) + 1e-5),
            "out of order"
        );
        let mut places = rows.clone();
        places.sort_by(|a, b| a[0].total_cmp(&b[0]));
        places.dedup();
        assert_eq!(places.len(), 1001);
    }
    let lamp = [3.0, 8.0, -2.0];
    let view = ViewNumbers {
        purpose: 2.0,
        lamp,
        ..view()
    };
    let rows = rows(&mut simulator, &view);
    let distance = |row: &[f32; 4]| (0..3).map(|i| (row[i] - lamp[i]).powi(2)).sum::<f32>().sqrt();
    assert_eq!(rows.len(), 1001);
    assert!(
        rows.windows(2)
            .all(|pair| distance(&pair[0]) >= distance(&pair[1]) - 1e-5),
        "out of order around a lamp"
    );
}

#[test]
fn equal_depths_keep_the_order_of_slots() {
    let mut simulator = simulator(40, 1, &[STILL, FULL]);
    (0..40).for_each(|i| assert!(simulator.add(&newborn([i as f32, 0.0, (i % 2) as f32 * -0.0]))));
    let rows = rows(&mut simulator, &view());
    assert!(rows.windows(2).all(|pair| pair[0][0] < pair[1][0]), "{rows:?}");
}

#[test]
fn arranging_changes_nothing_and_repeats() {
    let mut simulator = simulator(2000, 1, &[LIVELY]);
    steps(&mut simulator, 200);
    let hash = simulator.hash();
    let first = rows(&mut simulator, &view());
    assert_eq!(rows(&mut simulator, &view()), first);
    assert_eq!(simulator.hash(), hash);
}

#[test]
fn blend_runs_from_the_previous_step_to_this_one() {
    let settings = [("forces.wind.x", 6.0), ("emission.growthTime", 0.0)];
    let mut simulator = simulator(1, 1, &[STILL, &settings]);
    simulator.add(&Newborn {
        lifetime: 1.0,
        ..newborn([0.0, 1.0, 0.0])
    });
    steps(&mut simulator, 7);
    for (blend, x, age) in [(0.0, 0.6, 6.0), (0.5, 0.65, 6.5), (1.0, 0.7, 7.0)] {
        let view = ViewNumbers { blend, ..view() };
        let row = rows(&mut simulator, &view)[0];
        let radius = 0.2 * (1.0 - age / 60.0);
        assert!(
            (row[0] - x).abs() < 1e-5 && (row[3] - radius).abs() < 1e-6,
            "blend {blend}: {row:?}"
        );
        let word = simulator.attributes()[0][0];
        assert_eq!(word >> 16, (age / 60.0 * 65_535.0 + 0.5) as u32, "age at blend {blend}");
    }
    let early = ViewNumbers { blend: 0.0, ..view() };
    assert_eq!(rows(&mut simulator, &early)[0][0], simulator.particles().px[0]);
}

#[test]
fn unborn_particles_and_zero_radii_have_no_row() {
    let settings = [
        ("emission.rate", 60.0 * 64.0),
        ("emitters.0.speed", 3.0),
        ("emission.growthTime", 0.0),
    ];
    let mut newborns = simulator(64, 1, &[STILL, FULL, &settings]);
    newborns.step();
    for (blend, expected) in [(0.0, 0), (0.25, 16), (0.5, 32), (1.0, 64)] {
        let view = ViewNumbers { blend, ..view() };
        assert_eq!(rows(&mut newborns, &view).len(), expected, "blend {blend}");
    }
    let mut simulator = simulator(2, 1, &[STILL, &[("emission.growthTime", 1.0)]]);
    simulator.add(&newborn([0.0; 3]));
    simulator.add(&Newborn {
        age: 0.5,
        ..newborn([0.0; 3])
    });
    assert_eq!(rows(&mut simulator, &view()).len(), 1);
}

#[test]
fn particles_outside_of_the_world_have_no_row() {
    let mut simulator = simulator(4, 1, &[STILL, FULL]);
    simulator.add(&newborn([0.0; 3]));
    simulator.add(&newborn([20_000.0, 0.0, 0.0]));
    simulator.step();
    assert_eq!(rows(&mut simulator, &view()).len(), 1);
    assert!(simulator.bounds()[3] < 1.0);
}

#[test]
fn attributes_are_packed_as_documented() {
    let mut simulator = simulator(3, 1, &[STILL, FULL]);
    let attributes = 3 | 200 << 8 | 0x400 << 16 | 9 << 28;
    for (age, temperature) in [(0.0, 0.0), (10.0, 1.0), (30.0, 9.0)] {
        simulator.add(&Newborn {
            attributes,
            age,
            temperature,
            lifetime: 40.0,
            ..newborn([age, 0.0, -age])
        });
    }
    simulator.arrange(&view().to_array()).unwrap();
    let spin = |age: f32| 0x4000 + (age * (200.0 - 127.5) / 127.5 * 0.04 * 65_536.0) as u32;
    let expected = |age: f32, heat: u32| {
        [
            (spin(age) & 0xffff) | ((age / 40.0 * 65_535.0 + 0.5) as u32) << 16,
            3 | 200 << 8 | heat << 16 | 9 << 24,
            0,
            0,
        ]
    };
    assert_eq!(
        simulator.attributes()[..3],
        [expected(0.0, 0), expected(10.0, 64), expected(30.0, 255)]
    );
}

#[test]
fn eroded_rows_come_last_and_each_row_has_its_move() {
    let mut simulator = simulator(2000, 1, &[LIVELY, &[("emission.dissolve", 1.0)]]);
    steps(&mut simulator, 200);
    for purpose in [0.0, 1.0] {
        let rows = rows(&mut simulator, &ViewNumbers { purpose, ..view() });
        let whole = simulator.whole();
        assert!(whole > 0 && whole < rows.len(), "{whole} of {}", rows.len());
        let moves = simulator.moves();
        assert_eq!(moves.len(), rows.len());
        let particles = simulator.particles();
        for (row, found) in rows.iter().enumerate() {
            assert_eq!(EROSION.of(simulator.attributes()[row]) > 0, row >= whole, "row {row}");
            let i = (0..simulator.alive())
                .find(|i| place(&simulator, *i) == found[..3])
                .unwrap();
            let start = [particles.px[i], particles.py[i], particles.pz[i]];
            assert_eq!(moves[row], std::array::from_fn(|axis| found[axis] - start[axis]));
        }
    }
    simulator.set("emission.dissolve", 0.0).unwrap();
    assert_eq!(rows(&mut simulator, &view()).len(), simulator.whole());
}

#[test]
fn held_particles_do_not_move() {
    let mut simulator = simulator(2000, 1, &[LIVELY, &[("style.hold", 4.0)]]);
    steps(&mut simulator, 30);
    assert!(!rows(&mut simulator, &view()).is_empty());
    assert!(simulator.moves().iter().all(|by| *by == [0.0; 3]));
}

#[test]
fn the_number_of_living_variations_is_one_more_than_the_highest() {
    let mut simulator = simulator(2, 1, &[STILL]);
    assert_eq!(simulator.variations_alive(), 0);
    for attributes in [0xff03, 0x1_0007] {
        simulator.add(&Newborn {
            attributes,
            ..newborn([0.0; 3])
        });
    }
    assert_eq!(simulator.variations_alive(), 8);
}

#[test]
fn the_seed_selects_one_of_the_sides_of_a_variation() {
    let mut simulator = simulator(64, 1, &[STILL, FULL]);
    for number in 0..64_u32 {
        simulator.add(&Newborn {
            attributes: ((number * 37 % 256) << 8) | (number / 2),
            ..newborn([0.0; 3])
        });
    }
    for purpose in [0.0, 1.0] {
        for (sides, factor) in [(0.0, 1), (1.0, 1), (4.0, 4), (8.0, 8)] {
            let view = ViewNumbers {
                purpose,
                sides,
                ..view()
            };
            assert_eq!(rows(&mut simulator, &view).len(), 64);
            let mut found: Vec<u32> = simulator.attributes().iter().map(|row| row[1] & 0xffff).collect();
            found.sort_unstable();
            let mut expected: Vec<u32> = (0..64)
                .map(|number| (number * 37 % 256, number / 2))
                .map(|(seed, variation)| (seed << 8) | (variation * factor + seed % factor))
                .collect();
            expected.sort_unstable();
            assert_eq!(found, expected, "{sides} sides");
        }
    }
    let too_many = ViewNumbers { sides: 9.0, ..view() };
    assert!(simulator.arrange(&too_many.to_array()).is_err());
}

#[test]
fn upright_puffs_turn_back_without_a_jump() {
    let mut simulator = simulator(4, 1, &[STILL, FULL]);
    // Half a revolution to the left and to the right of upright, and a sixteenth; the last seed spins fastest.
    for (roll, seed) in [(0x7ff_u32, 255_u32), (0x801, 0), (0x100, 255), (0xf00, 0)] {
        simulator.add(&Newborn {
            attributes: (roll << 16) | (seed << 8),
            ..newborn([0.0; 3])
        });
    }
    let mut rolls = |upright: f32| -> Vec<i32> {
        let view = ViewNumbers { upright, ..view() };
        rows(&mut simulator, &view);
        let mut all: Vec<i32> = simulator
            .attributes()
            .iter()
            .map(|row| i32::from(row[0] as u16 as i16))
            .collect();
        all.sort_unstable();
        all
    };
    let free = rolls(0.0);
    assert!(free[0] < -30_000 && free[3] > 30_000, "{free:?}");
    for upright in [0.25_f32, 0.5, 0.9, 1.0] {
        for (found, roll) in rolls(upright).iter().zip(&free) {
            let expected = *roll as f32 * (1.0 - upright);
            assert!((*found as f32 - expected).abs() <= 1.0, "{upright}: {found} of {roll}");
        }
    }
    let too_far = ViewNumbers { upright: 1.1, ..view() };
    assert!(simulator.arrange(&too_far.to_array()).is_err());
}

#[test]
fn bounds_contain_all_living_particles_with_any_culling() {
    let mut simulator = simulator(3, 1, &[STILL, FULL]);
    let view = ViewNumbers { cull: 1.0, ..view() }.to_array();
    assert_eq!(simulator.arrange(&view).unwrap(), 0);
    assert_eq!(*simulator.bounds(), [0.0; 7]);
    simulator.add(&Newborn {
        size: 0.5,
        ..newborn([-100.0, 2.0, 3.0])
    });
    simulator.add(&Newborn {
        size: 1.0,
        ..newborn([4.0, 5.0, -60.0])
    });
    simulator.add(&Newborn {
        age: -1.0,
        ..newborn([0.0, 900.0, 0.0])
    });
    assert!(simulator.arrange(&view).unwrap() < 2);
    assert_eq!(*simulator.bounds(), [-100.5, 1.5, -61.0, 5.0, 6.0, 3.5, 1.0]);
}

#[test]
fn malformed_views_are_errors_with_their_key() {
    let mut simulator = cloud(10);
    type Change = fn(&mut ViewNumbers);
    let cases: [(Change, &str); 6] = [
        (|view| view.blend = -0.1, "view.blend"),
        (|view| view.blend = 1.1, "view.blend"),
        (|view| view.pad = -1.0, "view.pad"),
        (|view| view.clip_from_world[3] = f32::NAN, "view[7]"),
        (|view| view.direction[2] = 0.3, "view.direction"),
        (|view| view.reach = f32::INFINITY, "view[23]"),
    ];
    for (change, name) in cases {
        let mut view = view();
        change(&mut view);
        let error = simulator.arrange(&view.to_array()).unwrap_err();
        assert!(error.key.starts_with(name), "{error:?}");
    }
    assert_eq!(
        simulator
            .arrange(&view().to_array()[..VIEW_LENGTH - 1])
            .unwrap_err()
            .key,
        "view.length"
    );
}

/// Whether a point is between the four sides of the frustum.
fn is_inside(clip_from_world: &[f32], place: [f64; 3]) -> bool {
    let clip = |row: usize| {
        let column = |column: usize| f64::from(clip_from_world[4 * column + row]);
        column(0) * place[0] + column(1) * place[1] + column(2) * place[2] + column(3)
    };
    clip(0).abs() <= clip(3) && clip(1).abs() <= clip(3)
}

/// A point on the ball or inside it.
fn within(random: &mut Random, row: [f32; 4]) -> [f64; 3] {
    let way: [f64; 3] = std::array::from_fn(|_| f64::from(random.signed()));
    let length = way.iter().map(|c| c * c).sum::<f64>().sqrt();
    std::array::from_fn(|i| f64::from(row[i]) + way[i] / length * f64::from(row[3]))
}

/// Distance (m) from a point along a direction to the exit from the box, by small steps.
fn exit(place: [f32; 4], direction: [f32; 3]) -> f64 {
    let outside = |t: f64| {
        (0..3).any(|i| {
            let at = f64::from(place[i]) + t * f64::from(direction[i]);
            if direction[i] > 0.0 {
                at > f64::from(BOX[3 + i])
            } else {
                direction[i] < 0.0 && at < f64::from(BOX[i])
            }
        })
    };
    (0..10_000)
        .map(|step| f64::from(step) * 0.01)
        .find(|t| outside(*t))
        .unwrap()
}

#[test]
fn culling_keeps_every_body_that_touches_the_frustum() {
    let mut simulator = cloud(4000);
    let all = rows(&mut simulator, &view());
    let mut random = Random::new(2);
    for clip_from_world in [perspective(), orthographic()] {
        let view = ViewNumbers {
            cull: 1.0,
            clip_from_world,
            ..view()
        };
        let kept = rows(&mut simulator, &view);
        for row in all.iter().filter(|row| !kept.contains(row)) {
            let mut touches = || is_inside(&clip_from_world, within(&mut random, *row));
            assert!(!(0..200).any(|_| touches()), "{row:?} can be seen and is missing");
        }
        assert!(
            kept.len() > 200 && kept.len() < 3000,
            "{} of {} kept",
            kept.len(),
            all.len()
        );
        assert!(
            kept.windows(2).all(|pair| pair[0][2] >= pair[1][2]),
            "kept rows are out of order"
        );
    }
}

#[test]
fn pad_and_reach_enlarge_the_kept_region() {
    let mut simulator = cloud(4000);
    let mut kept = |reach: f32, pad: f32| {
        let view = ViewNumbers {
            cull: 1.0,
            pad,
            reach,
            ..view()
        };
        simulator.arrange(&view.to_array()).unwrap()
    };
    let [plain, reached, padded] = [kept(1.0, 0.0), kept(1.5, 0.0), kept(1.0, 0.05)];
    assert!(
        reached > plain + 20 && padded > plain + 20,
        "{plain}, {reached} with reach, {padded} with pad"
    );
}

#[test]
fn culling_keeps_every_caster_whose_sweep_touches_the_frustum() {
    let mut simulator = cloud(2000);
    let all = rows(&mut simulator, &view());
    let mut random = Random::new(2);
    for direction in [[0.6, -0.8, 0.0], [-0.48, -0.6, 0.64], [0.0, 0.0, -1.0]] {
        let view = ViewNumbers {
            purpose: 1.0,
            cull: 1.0,
            direction,
            ..view()
        };
        let kept = rows(&mut simulator, &view);
        for row in all.iter().filter(|row| !kept.contains(row)) {
            let length = exit(*row, direction);
            let mut touches = || {
                let (t, place) = (f64::from(random.unit()) * length, within(&mut random, *row));
                is_inside(
                    &view.clip_from_world,
                    std::array::from_fn(|i| place[i] + t * f64::from(direction[i])),
                )
            };
            assert!(
                !(0..300).any(|_| touches()),
                "the shadow of {row:?} along {direction:?} can be seen"
            );
        }
        assert!(
            kept.len() > 200 && kept.len() < 1900,
            "{} of {} kept",
            kept.len(),
            all.len()
        );
    }
}

#[test]
fn culling_keeps_every_caster_whose_shadow_of_a_lamp_touches_the_frustum() {
    let mut simulator = cloud(2000);
    let all = rows(&mut simulator, &view());
    let mut random = Random::new(3);
    for lamp in [[-16.0, 20.0, 3.0], [2.0, 11.0, -14.0], [0.0, 6.0, 0.0]] {
        let view = ViewNumbers {
            purpose: 2.0,
            cull: 1.0,
            lamp,
            ..view()
        };
        let kept = rows(&mut simulator, &view);
        for row in all.iter().filter(|row| !kept.contains(row)) {
            let is_in_box = |at: [f64; 3]| (0..3).all(|i| f64::from(BOX[i]) <= at[i] && at[i] <= f64::from(BOX[3 + i]));
            let mut touches = || {
                let (ratio, place) = (1.0 + 9.0 * f64::from(random.unit()).powi(2), within(&mut random, *row));
                let from = lamp.map(f64::from);
                let at = [0, 1, 2].map(|i: usize| from[i] + ratio * (place[i] - from[i]));
                is_in_box(at) && is_inside(&view.clip_from_world, at)
            };
            assert!(
                !(0..300).any(|_| touches()),
                "the shadow of {row:?} from {lamp:?} can be seen"
            );
        }
        assert!(
            kept.len() > 200 && kept.len() < 1900,
            "{} of {} kept",
            kept.len(),
            all.len()
        );
    }
}
