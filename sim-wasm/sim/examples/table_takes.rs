//! Takes with random parameters over the whole table and random inputs, and their native hashes: one line
//! each, `rigids steps alive hash take`, with the take in hexadecimal digits. Other builds must reach the same hashes.

use sim::Simulator;
use sim::layout::blow::BlowNumbers;
use sim::layout::parameters;
use sim::math::random::Random;

const TAKES: u32 = 40;
const STEPS: u32 = 120;
const CAPACITY: u32 = 400;
/// Maximum number of items of each list. With more, the effect of a single force rarely shows.
const MAX_ITEMS: u32 = 3;

fn main() {
    for seed in 0..TAKES {
        let mut simulator = configured(seed);
        // After the first change a take contains its whole scene, including rigids.
        simulator.step();
        simulator.record();
        live(&mut simulator, &mut Random::new(1000 + seed));
        let take = simulator.take("").expect("it records");
        println!(
            "{} {} {} {:016x} {}",
            u8::from(has_rigids(seed)),
            simulator.steps(),
            simulator.alive(),
            simulator.hash(),
            take.iter().map(|byte| format!("{byte:02x}")).collect::<String>()
        );
    }
}

fn has_rigids(seed: u32) -> bool {
    cfg!(feature = "rigids") && seed % 2 == 1
}

/// Takes without rare forces also run in the core build.
fn has_rare_forces(seed: u32) -> bool {
    !seed.is_multiple_of(4)
}

fn configured(seed: u32) -> Simulator {
    let mut random = Random::new(seed);
    let mut simulator = Simulator::new(CAPACITY, seed).expect("the capacity is in range");
    let rows = parameters::describe();
    let mut lengths: Vec<(String, u32)> = Vec::new();
    for row in rows.lines() {
        let mut words = row.split(' ');
        let key = words.next().expect("a row begins with its key");
        let [min, max, default] = [0; 3].map(|_| words.next().and_then(|word| word.parse().ok()).expect("a number"));
        let is_whole = words.next() == Some("whole");
        let list = key.split_once(".#").map(|(list, _)| list.to_owned());
        if !has_rare_forces(seed) && list.as_deref().is_some_and(|list| ["flows", "shapes"].contains(&list)) {
            continue;
        }
        let length = list.map_or(1, |list| length_of(&mut lengths, list, &mut random));
        for index in 0..length {
            let key = key.replace('#', &index.to_string());
            let value = value_between(min, max, default, is_whole, &mut random);
            simulator.set(&key, value).expect("the value is in range");
        }
    }
    // In every case a plain emitter follows the last random one, so that particles exist.
    let smoke = [
        ("emission.rate", 400.0),
        ("emission.lifetime", 3.0),
        ("emitters.3.share", 1000.0),
    ];
    simulator.set_all(&smoke).expect("all of these exist");
    #[cfg(feature = "rigids")]
    if has_rigids(seed) {
        add_rigids(&mut simulator, &mut random);
    }
    simulator
}

fn length_of(lengths: &mut Vec<(String, u32)>, list: String, random: &mut Random) -> u32 {
    if let Some((_, length)) = lengths.iter().find(|(known, _)| *known == list) {
        return *length;
    }
    let length = random.below(MAX_ITEMS + 1);
    lengths.push((list, length));
    length
}

/// The default, or a value at a random distance from it within the range.
fn value_between(min: f64, max: f64, default: f64, is_whole: bool, random: &mut Random) -> f64 {
    let farness = [0.0, 0.003, 0.03, 1.0][random.below(4) as usize];
    let anywhere = min + (max - min) * f64::from(random.unit());
    let value = (default + (anywhere - default) * farness).clamp(min, max);
    if is_whole { value.round() } else { value }
}

#[cfg(feature = "rigids")]
fn add_rigids(simulator: &mut Simulator, random: &mut Random) {
    use sim::rigids::{RigidDescription, RigidKind, RigidShape, pose_of};
    for number in 0..4 {
        let place = [0; 3].map(|_| random.signed());
        let pose = pose_of(&[place[0], place[1], place[2], 0.1, random.signed(), 0.2, 0.9]).expect("a pose");
        let kind = if number == 0 {
            RigidKind::Kinematic
        } else {
            RigidKind::Dynamic
        };
        let shape = match number % 3 {
            0 => RigidShape::Ball { radius: 0.3 },
            1 => RigidShape::Cuboid {
                half_extents: [0.2, 0.3, 0.1],
            },
            _ => RigidShape::Capsule {
                half_height: 0.2,
                radius: 0.15,
            },
        };
        let rigid = RigidDescription::new(kind, shape, pose);
        simulator.rigids_mut().add(rigid).expect("the shape is sound");
    }
}

fn live(simulator: &mut Simulator, random: &mut Random) {
    for _ in 1..STEPS {
        match random.below(12) {
            0 => simulator.input_steer(random.below(8), f64::from(random.signed())),
            1 => simulator.input_blow(&BlowNumbers {
                origin: [0; 3].map(|_| f64::from(random.signed())),
                ray: [0.2, f64::from(random.signed()), 0.5],
                velocity: [0; 3].map(|_| 5.0 * f64::from(random.signed())),
                radius: 1.0,
                seconds: 0.4,
            }),
            2 => simulator.input_values(&[("forces.wind.x", f64::from(random.signed()))]),
            3 => simulator.input_values(&[("simulation.integrator", f64::from(random.below(2)))]),
            4 => simulator.input_capacity(200 + random.below(300)),
            #[cfg(feature = "rigids")]
            5 if simulator.rigids().count() > 0 => {
                let [x, y, z] = [0; 3].map(|_| f64::from(random.signed()));
                simulator.input_pose(0, [x, y, z, 0.0, 0.0, 0.6, 0.8])
            }
            #[cfg(feature = "rigids")]
            6 if simulator.rigids().count() > 0 => {
                let [x, y, z] = [0; 3].map(|_| f64::from(random.signed()));
                simulator.input_drag(1, [0.1, 0.0, 0.1, x, y, z, 12.5])
            }
            _ => Ok(()),
        }
        .expect("every input is in range");
        simulator.step();
    }
}
