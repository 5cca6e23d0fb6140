//! Takes: what a person did, by step, so that it can be done again to the same hash.
//!
//! A simulation that records keeps its state at the start of the take and a log of inputs. An input is quantised first
//! and acts then, so that what was live and what is replayed are the same. It acts in the step that follows: the
//! inputs of step k are those given after k steps were made. They are no part of the hash after k steps, with two
//! exceptions that change particles at once: another capacity that is too small, and another integrator. [`Simulator::rewind`] goes back and the log runs again;
//! an input that comes while the log runs takes over, and the rest of the log is dropped.
//!
//! What the program does by itself at the same steps, such as a scene that steers a rigid by the clock, is no input.

pub mod active_inputs;
mod blow;
mod bytes;
mod columns;
pub mod input;
mod live;
pub mod log;
mod pose;
mod replay;

use active_inputs::ActiveInputs;
pub use blow::{Blow, BlowNumbers};
pub use bytes::Take;
use log::{Log, Record};

use crate::bytes::Writer;
use crate::hash::Hash;
use crate::parameters::Parameters;
use crate::simulator::Simulator;

/// Where a take begins.
#[derive(Clone, Debug)]
pub struct Origin {
    /// The simulation as `save` writes it; empty in a take that was read and begins with a fresh scene.
    state: Vec<u8>,
    /// Nothing has happened yet: seed, capacity and parameters say all, in the same scene.
    is_fresh: bool,
    /// Fingerprint of the rigids and of the surfaces that emitters smoke from.
    scene: u64,
    pub seed: u32,
    pub capacity: u32,
    /// Steps made before the take.
    pub step: u64,
    parameters: Parameters,
}

impl Origin {
    fn of(simulator: &Simulator) -> Self {
        Self {
            state: simulator.save(),
            is_fresh: simulator.steps == 0 && simulator.alive() == 0 && simulator.active_inputs.is_nothing(),
            scene: scene_of(simulator),
            seed: simulator.seed,
            capacity: simulator.capacity() as u32,
            step: simulator.steps,
            parameters: simulator.parameters,
        }
    }
}

/// Keeps a log from an origin on; without an origin it keeps nothing.
#[derive(Clone, Debug, Default)]
pub(crate) struct Recorder {
    origin: Option<Box<Origin>>,
    log: Log,
    /// Steps that had been made at the farthest point of the take.
    end: u64,
}

impl Recorder {
    fn new(origin: Origin, log: Log, end: u64) -> Self {
        let origin = Some(Box::new(origin));
        Self { origin, log, end }
    }

    pub fn is_on(&self) -> bool {
        self.origin.is_some()
    }

    /// The first input that has not been done.
    fn next(&self, active_inputs: &ActiveInputs) -> Option<&Record> {
        self.log.records.get(active_inputs.done as usize)
    }

    fn write(&self, origin: &Origin, note: &str) -> Vec<u8> {
        let mut body = Writer::default();
        bytes::write(&mut body, origin, &self.log, self.end, note);
        bytes::seal(body)
    }
}

fn scene_of(simulator: &Simulator) -> u64 {
    let mut hash = Hash::new();
    #[cfg(feature = "rigids")]
    simulator.rigids.hash_into(&mut hash);
    simulator.surfaces.hash_into(&mut hash);
    hash.finish()
}
