//! Shapes against the outline that they fill.

use crate::common::{STILL, newborn, place, simulator, steps};
use sim::Simulator;

const DIGITS: &str = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_.;";

/// The numbers of an outline, as pages pack them.
fn packed(text: &str) -> Vec<(String, f64)> {
    let codes: Vec<u64> = text.chars().map(|each| DIGITS.find(each).unwrap() as u64 + 1).collect();
    let number = |part: &[u64]| part.iter().rev().fold(0, |sum, code| sum * 67 + code) as f64;
    let parts = codes.chunks(8).enumerate();
    parts
        .map(|(index, part)| (format!("shapes.0.outline.{index:03}"), number(part)))
        .collect()
}

/// The text of a line through these points of the sheet.
fn line(points: &[[i32; 2]]) -> String {
    let digit = |value: i32| char::from(DIGITS.as_bytes()[value as usize]);
    let [x, y] = points[0];
    let first = 256 * x + y;
    let mut text: String = [first >> 12, (first >> 6) & 63, first & 63].map(digit).iter().collect();
    for pair in points.windows(2) {
        let steps = 8;
        let at = |step: i32, axis: usize| pair[0][axis] + (pair[1][axis] - pair[0][axis]) * step / steps;
        for step in 1..=steps {
            for axis in 0..2 {
                text.push(digit(at(step, axis) - at(step - 1, axis) + 32));
            }
        }
    }
    text
}

fn rectangle([left, top, right, bottom]: [i32; 4]) -> String {
    line(&[[left, top], [right, top], [right, bottom], [left, bottom]])
}

/// A square of 200 units with a square hole of 100 units.
fn frame() -> String {
    format!("{}.{}", rectangle([28, 28, 228, 228]), rectangle([78, 78, 178, 178]))
}

/// Still smoke in a heap beside a shape.
fn heap(outline: &str, settings: &[(&str, f64)], count: usize) -> Simulator {
    let shape = [
        ("shapes.0.speed", 2.0),
        ("shapes.0.size", 2.0),
        ("shapes.0.depth", 0.2),
        ("shapes.0.position.y", 0.0),
    ];
    let mut simulator = simulator(count as u32, 1, &[STILL, &shape, settings]);
    let outline = packed(outline);
    let entries: Vec<(&str, f64)> = outline.iter().map(|(key, value)| (&key[..], *value)).collect();
    simulator.set_all(&entries).unwrap();
    // Golden ratio: places that no grid repeats.
    for index in 0..count {
        let part = |factor: f64| ((index as f64 * factor).fract() - 0.5) as f32;
        let place = [part(0.618_034), -1.3 + part(0.754_877) * 0.5, part(0.569_84) * 0.3];
        simulator.add(&newborn(place));
    }
    simulator
}

/// The part of `simulator`'s smoke that is in the frame of 2 m, or nearer to it than 0.06 m.
fn part_in_frame(simulator: &Simulator) -> f64 {
    let is_in = |[x, y, z]: [f32; 3]| {
        let outer = x.abs().max(y.abs());
        (0.44..=1.06).contains(&outer) && z.abs() <= 0.16
    };
    let count = simulator.alive();
    let inside = (0..count).filter(|index| is_in(place(simulator, *index))).count();
    inside as f64 / count as f64
}

/// The number of particles in each of the 300 tiles of 0.1 m of the frame of 2 m.
fn tiles_of_frame(simulator: &Simulator) -> Vec<f64> {
    let mut tiles = [[0; 20]; 20];
    for index in 0..simulator.alive() {
        let [x, y, _] = place(simulator, index);
        let tile = |place: f32| ((place + 1.0) * 10.0).clamp(0.0, 19.0) as usize;
        tiles[tile(y)][tile(x)] += 1;
    }
    let is_of_frame = |at: usize| !(5..15).contains(&at);
    let of_frame = (0..400).filter(|at| is_of_frame(at / 20) || is_of_frame(at % 20));
    of_frame.map(|at| f64::from(tiles[at / 20][at % 20])).collect()
}

#[test]
fn smoke_fills_all_of_a_shape_evenly_and_nothing_else() {
    for turbulence in [0.0, 2.0] {
        let swirls = [
            ("turbulence.octaves", turbulence),
            ("turbulence.speed", 0.3),
            ("turbulence.scale", 0.4),
        ];
        let mut simulator = heap(&frame(), &swirls, 2000);
        assert!(part_in_frame(&simulator) < 0.05, "the heap is beside the shape");
        steps(&mut simulator, 240);
        let inside = part_in_frame(&simulator);
        assert!(
            inside > 0.97,
            "{inside} of the smoke is inside, turbulence {turbulence}"
        );
        let tiles = tiles_of_frame(&simulator);
        let filled = tiles.iter().filter(|count| **count > 0.0).count();
        assert!(
            filled > 295,
            "{filled} of 300 tiles are filled, turbulence {turbulence}"
        );
        let mean = tiles.iter().sum::<f64>() / 300.0;
        let variance = tiles.iter().map(|count| (count - mean) * (count - mean)).sum::<f64>() / 300.0;
        // At random places the variance is the mean.
        assert!(
            variance < 0.6 * mean,
            "variance {variance} of {mean} particles, turbulence {turbulence}"
        );
    }
}

#[test]
fn smoke_never_snaps() {
    let mut simulator = heap(&frame(), &[], 500);
    for step in 0..120 {
        simulator.step();
        let particles = simulator.particles();
        for i in 0..500 {
            let way = [
                particles.x[i] - particles.px[i],
                particles.y[i] - particles.py[i],
                particles.z[i] - particles.pz[i],
            ];
            let speed = way.iter().map(|metres| metres * metres).sum::<f32>().sqrt() * 60.0;
            assert!(speed <= 2.001, "particle {i} has {speed} m/s in step {step}");
        }
    }
}

#[test]
fn smoke_leaves_the_shape_when_its_time_is_over() {
    let until_3s = [
        ("shapes.0.envelope.duration", 3.0),
        ("gravity.acceleration", 1.0),
        ("drag.rate", 1.0),
    ];
    let mut simulator = heap(&frame(), &until_3s, 1000);
    steps(&mut simulator, 180);
    let held = part_in_frame(&simulator);
    assert!(held > 0.95, "{held} of the falling smoke is held");
    steps(&mut simulator, 240);
    let left = part_in_frame(&simulator);
    assert!(left < 0.05, "{left} of the smoke stays");
}

#[test]
fn layers_fill_the_depth() {
    // A small square at the back, a wide one in front.
    let outline = format!("{};{}", rectangle([108, 108, 148, 148]), rectangle([28, 28, 228, 228]));
    let mut simulator = heap(&outline, &[("shapes.0.depth", 1.0)], 2000);
    steps(&mut simulator, 240);
    let (mut back, mut front, mut wide) = (0.0, 0.0, 0.0);
    for index in 0..2000 {
        let [x, y, z] = place(&simulator, index);
        let is_wide = x.abs().max(y.abs()) > 0.35;
        back += f64::from(u8::from(z < 0.0 && !is_wide));
        front += f64::from(u8::from(z >= 0.0));
        wide += f64::from(u8::from(z < -0.1 && is_wide));
    }
    let expected = 2000.0 * 0.16 / 4.16;
    assert!(
        (back - expected).abs() < 0.5 * expected,
        "{back} at the back, expected {expected}"
    );
    assert!(front > 1600.0, "{front} in front");
    assert!(wide < 100.0, "{wide} beside the back");
}

#[test]
fn a_restored_shape_goes_on_alike() {
    let mut simulator = heap(&frame(), &[], 300);
    steps(&mut simulator, 30);
    let mut restored = Simulator::new(300, 2).unwrap();
    restored.restore(&simulator.save()).unwrap();
    steps(&mut simulator, 30);
    steps(&mut restored, 30);
    assert_eq!(simulator.hash(), restored.hash());
    // A change of the integrator reads the air between two steps.
    let mut twin = Simulator::new(300, 2).unwrap();
    twin.restore(&simulator.save()).unwrap();
    for each in [&mut simulator, &mut twin] {
        each.set("simulation.integrator", 1.0).unwrap();
        steps(each, 10);
    }
    assert_eq!(simulator.hash(), twin.hash());
}

#[test]
fn hostile_outlines_leave_finite_smoke() {
    let top = 67_f64.powi(8) - 1.0;
    let cases: [&[f64]; 6] = [
        &[top; 128],
        &[1.0],
        // Only ends of layers, then only ends of lines.
        &[406_067_677_556_640.0; 128],
        &[399_917_459_714_388.0; 128],
        // A point; a line without area.
        &[5000.0],
        &[20_151_121_000.0, 3.0],
    ];
    for numbers in cases {
        let mut simulator = heap(&frame(), &[], 50);
        for (index, number) in numbers.iter().enumerate() {
            simulator.set(&format!("shapes.0.outline.{index:03}"), *number).unwrap();
        }
        steps(&mut simulator, 20);
        assert!(
            simulator.particles().x[..50].iter().all(|x| x.is_finite()),
            "{numbers:?}"
        );
    }
    let mut simulator = heap(&frame(), &[], 1);
    assert!(simulator.set("shapes.0.outline.000", top + 1.0).is_err());
    assert!(simulator.set("shapes.0.outline.128", 0.0).is_err());
    assert!(simulator.set("shapes.0.outline.001", 0.5).is_err());
}
