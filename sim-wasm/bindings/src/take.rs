//! Inputs and takes for JavaScript: each method is one call of `sim`.

use sim::layout::blow::BlowNumbers;
use sim::simulator::take::Take;
use wasm_bindgen::prelude::*;

use crate::error::{Object, parameter_error, plain_error};
use crate::simulator::Simulator;

#[wasm_bindgen]
impl Simulator {
    /// Starts a take at the current state.
    pub fn record(&mut self) {
        self.simulator.record();
    }

    /// Input: sets `values[i]` for line i of `keys`; all or none.
    #[wasm_bindgen(js_name = inputValues)]
    pub fn input_values(&mut self, keys: &str, values: &[f64]) -> Result<(), JsValue> {
        let pairs: Vec<(&str, f64)> = keys.lines().zip(values.iter().copied()).collect();
        self.simulator.input_values(&pairs).map_err(parameter_error)
    }

    /// Input: changes the capacity.
    #[wasm_bindgen(js_name = inputCapacity)]
    pub fn input_capacity(&mut self, capacity: u32) -> Result<(), JsValue> {
        self.simulator.input_capacity(capacity).map_err(parameter_error)
    }

    /// Input: sends a kinematic rigid to x, y, z and the quaternion x, y, z, w, or teleports a dynamic one.
    #[cfg_attr(not(feature = "meshes"), allow(unused_variables))]
    #[wasm_bindgen(js_name = inputPose)]
    pub fn input_pose(&mut self, rigid: u32, pose: &[f64]) -> Result<(), JsValue> {
        #[cfg(feature = "meshes")]
        return match pose.try_into() {
            Ok(numbers) => self.simulator.input_pose(rigid, numbers).map_err(parameter_error),
            Err(_) => Err(plain_error("a pose has seven numbers")),
        };
        #[cfg(not(feature = "meshes"))]
        Err(crate::rigids::without_rigids())
    }

    /// Input: drags a point of a rigid, as seven numbers: point, target and stiffness.
    #[cfg_attr(not(feature = "meshes"), allow(unused_variables))]
    #[wasm_bindgen(js_name = inputDrag)]
    pub fn input_drag(&mut self, rigid: u32, numbers: &[f64]) -> Result<(), JsValue> {
        #[cfg(feature = "meshes")]
        return match numbers.try_into() {
            Ok(numbers) => self.simulator.input_drag(rigid, numbers).map_err(parameter_error),
            Err(_) => Err(plain_error("a drag has seven numbers")),
        };
        #[cfg(not(feature = "meshes"))]
        Err(crate::rigids::without_rigids())
    }

    /// Input: ends the drag of a rigid.
    #[cfg_attr(not(feature = "meshes"), allow(unused_variables))]
    #[wasm_bindgen(js_name = inputRelease)]
    pub fn input_release(&mut self, rigid: u32) -> Result<(), JsValue> {
        #[cfg(feature = "meshes")]
        return self.simulator.input_release(rigid).map_err(parameter_error);
        #[cfg(not(feature = "meshes"))]
        Err(crate::rigids::without_rigids())
    }

    /// Input: sets a channel.
    #[wasm_bindgen(js_name = inputSteer)]
    pub fn input_steer(&mut self, channel: u32, value: f64) -> Result<(), JsValue> {
        self.simulator.input_steer(channel, value).map_err(parameter_error)
    }

    /// Input: starts a gust, as eleven numbers: origin, ray, velocity, radius and seconds.
    #[wasm_bindgen(js_name = inputBlow)]
    pub fn input_blow(&mut self, numbers: &[f64]) -> Result<(), JsValue> {
        let Ok([ox, oy, oz, rx, ry, rz, vx, vy, vz, radius, seconds]) = <[f64; 11]>::try_from(numbers) else {
            return Err(plain_error("a blow has eleven numbers"));
        };
        let blow = BlowNumbers {
            origin: [ox, oy, oz],
            ray: [rx, ry, rz],
            velocity: [vx, vy, vz],
            radius,
            seconds,
        };
        self.simulator.input_blow(&blow).map_err(parameter_error)
    }

    /// Input: removes all particles.
    #[wasm_bindgen(js_name = inputClear)]
    pub fn input_clear(&mut self) -> Result<(), JsValue> {
        self.simulator.input_clear().map_err(parameter_error)
    }

    /// Input: starts an emission, or changes the one with a number of at least 0. Returns its number; -1 if all slots are
    /// taken, or if the one to change is over.
    #[wasm_bindgen(js_name = inputEmission)]
    pub fn input_emission(&mut self, numbers: &[f64], changed: f64) -> Result<f64, JsValue> {
        let changed = (changed >= 0.0).then_some(changed as u64);
        let number = self
            .simulator
            .input_emission(numbers, changed)
            .map_err(parameter_error)?;
        Ok(number.map_or(-1.0, |number| number as f64))
    }

    /// Value of a channel.
    pub fn control(&self, channel: u32) -> f32 {
        self.simulator.control(channel)
    }

    /// Serialises the take.
    pub fn take(&self, note: &str) -> Result<Vec<u8>, JsValue> {
        self.simulator.take(note).map_err(|error| plain_error(&error.message))
    }

    /// Goes to the start of a take.
    pub fn replay(&mut self, take: &[u8]) -> Result<(), JsValue> {
        self.simulator.replay(take).map_err(|error| plain_error(&error.message))
    }

    /// Goes to a saved state within the take, or to its start.
    pub fn rewind(&mut self, state: Option<Vec<u8>>) -> Result<(), JsValue> {
        self.simulator
            .rewind(state.as_deref())
            .map_err(|error| plain_error(&error.message))
    }

    /// Number of inputs applied.
    #[wasm_bindgen(getter = inputsDone)]
    pub fn inputs_done(&self) -> u32 {
        self.simulator.inputs().0
    }

    /// Number of inputs in the take.
    #[wasm_bindgen(getter = inputCount)]
    pub fn input_count(&self) -> u32 {
        self.simulator.inputs().1
    }

    /// True if inputs exceeded the capacity of the take.
    #[wasm_bindgen(getter = isTruncated)]
    pub fn is_truncated(&self) -> bool {
        self.simulator.is_truncated()
    }

    /// Number of steps at the farthest point of the take.
    #[wasm_bindgen(getter = takeEnd)]
    pub fn take_end(&self) -> f64 {
        self.simulator.end() as f64
    }

    /// Maximum number of particles.
    #[wasm_bindgen(getter)]
    pub fn capacity(&self) -> u32 {
        self.simulator.capacity() as u32
    }

    /// The seed of the random numbers.
    #[wasm_bindgen(getter)]
    pub fn seed(&self) -> u32 {
        self.simulator.seed()
    }

    /// The keys of all existing parameters, one per line.
    #[wasm_bindgen(js_name = parameterKeys)]
    pub fn parameter_keys(&self) -> String {
        let mut keys = String::new();
        for (key, _) in self.simulator.parameters().entries() {
            if !keys.is_empty() {
                keys.push('\n');
            }
            keys.push_str(&key);
        }
        keys
    }

    /// The values of all existing parameters, in the order of their keys.
    #[wasm_bindgen(js_name = parameterValues)]
    pub fn parameter_values(&self) -> Vec<f64> {
        let entries = self.simulator.parameters().entries();
        entries.into_iter().map(|(_, value)| value).collect()
    }
}

/// Description of a take: `{ seed, mostParticles, start, end, inputs, isFresh, isTruncated, note }`.
#[wasm_bindgen(js_name = readTake)]
pub fn read_take(bytes: &[u8]) -> Result<JsValue, JsValue> {
    let take = Take::parse(bytes).map_err(|error| plain_error(&error.message))?;
    let numbers = [
        ("seed", f64::from(take.origin.seed)),
        ("mostParticles", f64::from(take.max_particles())),
        ("start", take.origin.step as f64),
        ("end", take.end as f64),
        ("inputs", take.log.len() as f64),
    ];
    let object = Object::new();
    for (name, number) in numbers {
        object.put(name, number.into());
    }
    object.put("isFresh", take.is_fresh().into());
    object.put("isTruncated", take.log.is_truncated().into());
    object.put("note", take.note.into());
    Ok(object.into())
}
