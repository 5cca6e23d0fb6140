//! The simulation under test.

use std::cell::RefCell;

use sim::Simulator;
use sim::layout::parameters;

const CAPACITY: u32 = 64;
/// Number of steps that must succeed after an accepted input.
const STEPS: usize = 3;
/// Longer configurations find nothing more, and each entry compares the whole state.
const MAX_ENTRIES: usize = 48;
/// Start of most configurations, so that there is smoke.
const LIVELY: &[(&str, f64)] = &[
    ("emission.rate", 400.0),
    ("emission.lifetime", 1.0),
    ("emitters.0.share", 1.0),
    ("emitters.0.speed", 2.0),
    ("emitters.1.look.drag", 2.0),
    ("emitters.1.look.lifetime", 0.3),
    ("emitters.1.tint", 4.0),
    ("emitters.1.perMetre", 50.0),
    ("turbulence.speed", 0.5),
    ("turbulence.octaves", 2.0),
    ("vortices.0.circulation", 2.0),
    ("colliders.0.position.y", -0.5),
];

pub struct Running {
    simulator: Simulator,
    keys: Vec<String>,
}

/// Passes the running simulation to `action`; the same one unless an action changed it.
pub fn with(action: impl FnOnce(&mut Running)) {
    thread_local! {
        static RUNNING: RefCell<Running> = RefCell::new(Running::new());
    }
    RUNNING.with_borrow_mut(action);
}

/// A simulation after some steps, with a take of a few inputs.
pub fn lively() -> Simulator {
    let mut simulator = Simulator::new(CAPACITY, 7).expect("the capacity is in range");
    simulator.set_all(LIVELY).expect("all of these exist");
    simulator.record();
    for step in 0..12 {
        let _ = simulator.input_steer(step % 8, f64::from(step) / 12.0);
        let _ = simulator.input_values(&[("forces.wind.x", f64::from(step))]);
        let _ = simulator.input_values(&[("emitters.1.position.x", f64::from(step) / 50.0)]);
        let _ = simulator.input_emission(&emitter(step), None);
        simulator.step();
    }
    simulator
}

/// The numbers of an emitter of the pool that ends soon; every other one has a look.
fn emitter(step: u32) -> Vec<f64> {
    let rows = parameters::rows();
    let own = rows.iter().filter_map(|row| Some((row.key.strip_prefix("emitters.#.")?, row.default)));
    own.map(|(key, default)| match key {
        "share" => 100.0,
        "envelope.duration" => 0.1,
        "look.style" | "look.dissolve" => f64::from(step % 2),
        _ => default,
    })
    .collect()
}

impl Running {
    fn new() -> Self {
        let rows = parameters::describe();
        let keys = rows.lines().filter_map(|row| row.split(' ').next());
        Self {
            simulator: lively(),
            keys: keys.map(str::to_owned).collect(),
        }
    }

    /// Ten bytes per entry: two select a key and the item of a list, eight are the value.
    pub fn configure(&mut self, bytes: &[u8]) {
        for entry in bytes.as_chunks::<10>().0.iter().take(MAX_ENTRIES) {
            let [a, b, value @ ..] = *entry;
            let choice = usize::from(u16::from_le_bytes([a, b]));
            let key = self.keys[choice / 8 % self.keys.len()].replace('#', &(choice % 8).to_string());
            self.attempt(|simulator| simulator.input_values(&[(&key, f64::from_le_bytes(value))]).is_ok());
        }
        self.go_on();
    }

    pub fn restore(&mut self, bytes: &[u8]) {
        if self.attempt(|simulator| simulator.restore(bytes).is_ok()) {
            self.go_on();
        }
    }

    pub fn replay(&mut self, bytes: &[u8]) {
        if self.attempt(|simulator| simulator.replay(bytes).is_ok()) {
            self.go_on();
        }
    }

    /// Performs an action; if it fails, nothing may have changed.
    fn attempt(&mut self, action: impl FnOnce(&mut Simulator) -> bool) -> bool {
        let state = |simulator: &Simulator| (simulator.hash(), simulator.inputs(), *simulator.parameters());
        let before = state(&self.simulator);
        let is_taken = action(&mut self.simulator);
        assert!(
            is_taken || state(&self.simulator) == before,
            "what was refused changed the state"
        );
        is_taken
    }

    /// After a change the simulation must step, stay finite, save and restore. A fresh one replaces it.
    fn go_on(&mut self) {
        let simulator = &mut self.simulator;
        (0..STEPS).for_each(|_| simulator.step());
        let alive = simulator.alive();
        for column in simulator.particles().float_columns() {
            assert!(column[..alive].iter().all(|number| number.is_finite()));
        }
        let (bytes, hash) = (simulator.save(), simulator.hash());
        simulator.restore(&bytes).expect("what was saved can be restored");
        assert_eq!(simulator.hash(), hash);
        *simulator = lively();
    }
}
