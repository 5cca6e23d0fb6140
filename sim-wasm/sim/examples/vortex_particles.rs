//! Cost of vortex particles: a step of 20,000 particles under six forces with 1,000 vortex particles over the step
//! without them, interleaved, for cores that reach more and more of the smoke. `cargo run --release --example
//! vortex_particles`.

use std::time::Instant;

use sim::Simulator;
use sim::forces::vortex_particles::VortexParticle;
use sim::math::random::Random;
use sim::particles::Newborn;

const PARTICLES: u32 = 20_000;
const VORTEX_PARTICLES: usize = 1000;
/// Half side of the cube that particles and vortex particles fill (m).
const HALF_SIDE: f32 = 5.0;
const ROUNDS: usize = 11;
const STEPS: usize = 20;

/// The forces of `npm run bench -- sim`, one octave of turbulence among them.
const FORCES: &[(&str, f64)] = &[
    ("emission.rate", 0.0),
    ("gravity.acceleration", 0.4),
    ("buoyancy.acceleration", 1.5),
    ("drag.rate", 1.5),
    ("forces.wind.x", 0.5),
    ("turbulence.speed", 0.6),
    ("turbulence.octaves", 1.0),
    ("vortices.0.circulation", 6.0),
    ("vortices.0.reach", 20.0),
];

fn main() {
    println!("reached by  ratio (median of {ROUNDS}, least .. most)  us without .. with");
    for reached_by in [0.5, 2.0, 8.0, 32.0] {
        measure(reached_by);
    }
}

/// With cores of a size such that each point is within reach of this many on average.
fn measure(reached_by: f32) {
    let each = reached_by * (2.0 * HALF_SIDE).powi(3) / VORTEX_PARTICLES as f32;
    let core_radius = (each * 3.0 / (4.0 * std::f32::consts::PI)).cbrt() / 3.0;
    let mut pair = [scene(None), scene(Some(core_radius))];
    let mut rounds: Vec<[f64; 2]> = (0..ROUNDS)
        .map(|_| {
            let mut spent = [0.0; 2];
            for _ in 0..STEPS {
                for (simulator, spent) in pair.iter_mut().zip(&mut spent) {
                    let start = Instant::now();
                    simulator.step();
                    *spent += start.elapsed().as_secs_f64() * 1e6 / STEPS as f64;
                }
            }
            spent
        })
        .collect();
    let counts = (pair[1].alive() as u32, pair[1].vortex_particles());
    assert_eq!(counts, (PARTICLES, VORTEX_PARTICLES), "nobody may die meanwhile");
    rounds.sort_by(|a, b| (a[1] / a[0]).total_cmp(&(b[1] / b[0])));
    let ratio = |round: usize| rounds[round][1] / rounds[round][0];
    let [without, with] = rounds[ROUNDS / 2];
    println!(
        "{reached_by:10} {:6.2} ({:.2} .. {:.2}) {without:8.0} .. {with:.0}",
        ratio(ROUNDS / 2),
        ratio(0),
        ratio(ROUNDS - 1),
    );
}

fn scene(core_radius: Option<f32>) -> Simulator {
    let mut simulator = Simulator::new(PARTICLES, 7).expect("a capacity within the limit");
    simulator.set_all(FORCES).expect("parameters of the table");
    let mut random = Random::new(3);
    let mut somewhere = |half: f32| std::array::from_fn(|_| random.signed() * half);
    for _ in 0..PARTICLES {
        simulator.add(&Newborn {
            position: somewhere(HALF_SIDE),
            slip: [0.0; 3],
            age: 0.0,
            lifetime: 1000.0,
            size: 0.2,
            temperature: 0.5,
            attributes: 0,
        });
    }
    for core_radius in core_radius.iter().cycle().take(VORTEX_PARTICLES) {
        let is_added = simulator.add_vortex_particle(&VortexParticle {
            position: somewhere(HALF_SIDE),
            swirl: somewhere(1.0),
            core_radius: *core_radius,
            viscosity: 0.0,
            age: 0.0,
            lifetime: 1000.0,
        });
        assert!(is_added, "a sound vortex particle");
    }
    simulator
}
