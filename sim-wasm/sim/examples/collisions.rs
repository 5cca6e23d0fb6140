//! Prints what the parts of a step cost natively among moving rigids, beside Rapier's own queries:
//! `cargo run --release --package sim-tests --features bench --example collisions`. Read ratios, not milliseconds.

use std::time::Instant;

use sim::Simulator;
use sim::math::random::Random;
use sim::particles::Newborn;
use sim::rigids::{RigidDescription, RigidKind, RigidShape, pose_of};
use sim::simulator::StepPart;

const ROUNDS: usize = 9;
const STEPS: usize = 40;
const PARTICLES: u32 = 10_000;
/// Half side of the box of particles and rigids (m), the same as in tests/bench/sim/collide/obstacles.ts.
const HALF_SIDE: f32 = 1.5;
/// Maximum radius of a particle (m).
const REACH: f32 = 0.08;
const FORCES: &[(&str, f64)] = &[
    ("emission.rate", 0.0),
    ("emission.growthTime", 0.0),
    ("gravity.acceleration", 0.4),
    ("buoyancy.acceleration", 1.5),
    ("drag.rate", 1.5),
    ("vortices.0.circulation", 2.0),
    ("vortices.0.reach", 4.0),
    ("turbulence.speed", 0.3),
    ("turbulence.scale", 1.0),
    ("turbulence.octaves", 1.0),
    ("turbulence.evolution", 0.3),
];

/// A rigid that oscillates about its position.
struct Swing {
    place: [f32; 3],
    pace: f32,
    phase: f32,
}

/// Milliseconds per step.
#[derive(Default)]
struct Times {
    parts: [f64; 5],
    /// Rapier's queries for particles in boxes that a rigid touched, and for all.
    touched: f64,
    all: f64,
    count: usize,
}

fn main() {
    [1, 10, 100, 1000].into_iter().for_each(report);
}

fn report(rigids: usize) {
    let mut rounds: Vec<Times> = (0..ROUNDS).map(|_| round(rigids)).collect();
    let mut median = |read: &dyn Fn(&Times) -> f64| {
        rounds.sort_by(|a, b| read(a).total_cmp(&read(b)));
        read(&rounds[ROUNDS / 2])
    };
    let [world, follow, motion, collision, _] = std::array::from_fn(|part| median(&|times| times.parts[part]));
    let near = median(&|times| (times.parts[1] + times.parts[3]) / times.touched);
    let naive = median(&|times| times.all / (times.parts[1] + times.parts[3]));
    let count = rounds[0].count;
    println!(
        "{PARTICLES} among {rigids:4}: world {world:.3}, follow {follow:.3}, motion {motion:.3}, collision \
         {collision:.3} ms; near {near:.2} ({count} asked), vsNaive {naive:.2}"
    );
}

fn round(rigids: usize) -> Times {
    let mut random = Random::new(5);
    let mut simulator = cloud(&mut random);
    let swings: Vec<Swing> = (0..rigids)
        .map(|index| add(&mut simulator, &mut random, index))
        .collect();
    let (mut times, mut found, mut distances) = (Times::default(), Vec::new(), Vec::new());
    let everyone: Vec<u32> = (0..PARTICLES).collect();
    for step in 0..STEPS {
        for (index, swing) in swings.iter().enumerate() {
            let pose = pose_of(&swing.pose(step as f32 / 60.0)).expect("a pose");
            simulator
                .rigids_mut()
                .move_to(index as u32, pose)
                .expect("it is kinematic");
        }
        let mut start = Instant::now();
        simulator.step_observed(|part: StepPart| {
            times.parts[part as usize] += start.elapsed().as_secs_f64() * 1e3 / STEPS as f64;
            start = Instant::now();
        });
        simulator.find_in_touched_boxes(&mut found);
        times.count = found.len();
        times.touched += timed(|| simulator.project(&found, REACH, &mut distances)) / STEPS as f64;
        times.all += timed(|| simulator.project(&everyone, f32::MAX, &mut distances)) / STEPS as f64;
    }
    times
}

fn cloud(random: &mut Random) -> Simulator {
    let mut simulator = Simulator::new(PARTICLES, 1).expect("the capacity is allowed");
    simulator.set_all(FORCES).expect("the forces stay within their ranges");
    for _ in 0..PARTICLES {
        simulator.add(&Newborn {
            position: std::array::from_fn(|_| random.signed() * HALF_SIDE),
            slip: [0.0; 3],
            age: 0.0,
            lifetime: 1000.0,
            size: 0.06 + 0.02 * random.signed(),
            temperature: 0.4,
            attributes: 0,
        });
    }
    simulator
}

fn timed(work: impl FnOnce()) -> f64 {
    let start = Instant::now();
    work();
    start.elapsed().as_secs_f64() * 1e3
}

fn add(simulator: &mut Simulator, random: &mut Random, index: usize) -> Swing {
    let size = 0.13 + 0.05 * random.signed();
    let shape = match index % 4 {
        0 => RigidShape::Ball { radius: 1.2 * size },
        1 => RigidShape::Cuboid {
            half_extents: [size, 1.5 * size, 0.7 * size],
        },
        2 => RigidShape::Capsule {
            half_height: 1.5 * size,
            radius: 0.6 * size,
        },
        _ => RigidShape::Cylinder {
            half_height: size,
            radius: 0.9 * size,
        },
    };
    let swing = Swing {
        place: std::array::from_fn(|_| random.signed() * HALF_SIDE),
        pace: 1.0 + 0.5 * random.signed(),
        phase: 3.0 + 3.0 * random.signed(),
    };
    let pose = pose_of(&swing.pose(0.0)).expect("a pose");
    let description = RigidDescription {
        friction: 0.2,
        ..RigidDescription::new(RigidKind::Kinematic, shape, pose)
    };
    simulator.rigids_mut().add(description).expect("the shape has a volume");
    swing
}

impl Swing {
    fn pose(&self, seconds: f32) -> [f32; 7] {
        let angle = self.phase + self.pace * seconds;
        let [x, y, z] = self.place;
        let half = 0.5 * angle;
        [
            x + 0.3 * angle.cos(),
            y + 0.2 * (2.0 * angle).sin(),
            z + 0.3 * angle.sin(),
            half.sin() * 0.6,
            half.sin() * 0.8,
            0.0,
            half.cos(),
        ]
    }
}
