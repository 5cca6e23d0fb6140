//! The class `Simulator`: one call of `sim` behind each method.

use wasm_bindgen::prelude::*;

use crate::error::{parameter_error, plain_error};

/// Floats of one rigid in the pose array: position and quaternion (x, y, z, w) one step earlier, then now.
pub const RIGID_FLOATS: usize = 14;

/// Particles, forces and colliders, and rigids in the variant that has them. Errors are error objects
/// `{ key, value, min, max, message }`; after one nothing has changed.
#[wasm_bindgen]
pub struct Simulator {
    pub(crate) simulator: sim::Simulator,
}

#[wasm_bindgen]
impl Simulator {
    /// A simulator for at most `capacity` particles; all memory it needs for them is taken here.
    #[wasm_bindgen(constructor)]
    pub fn new(capacity: u32, seed: u32) -> Result<Simulator, JsValue> {
        let simulator = sim::Simulator::new(capacity, seed).map_err(parameter_error)?;
        Ok(Simulator { simulator })
    }

    /// Sets `values[i]` for the i-th line of `keys`; all or none.
    pub fn set(&mut self, keys: &str, values: &[f64]) -> Result<(), JsValue> {
        let pairs: Vec<(&str, f64)> = keys.lines().zip(values.iter().copied()).collect();
        self.simulator.set_all(&pairs).map_err(parameter_error)
    }

    /// Takes up the surface of a mesh for emitters and returns its number: `sim::emission::surface::Surface::new`.
    #[wasm_bindgen(js_name = addSurface)]
    pub fn add_surface(&mut self, vertices: &[f32], indices: &[u32]) -> Result<u32, JsValue> {
        self.simulator.add_surface(vertices, indices).map_err(parameter_error)
    }

    /// Says where the parts of the scene are in the coming step: `sim::layout::scope::parts::Parts::place`.
    #[wasm_bindgen(js_name = placeParts)]
    pub fn place_parts(&mut self, numbers: &[f32]) -> Result<(), JsValue> {
        self.simulator.place_parts(numbers).map_err(parameter_error)
    }

    /// Advances by `count` steps of 1/60 s.
    pub fn step(&mut self, count: u32) {
        for _ in 0..count {
            self.simulator.step();
        }
    }

    /// Changes how many particles can live at once; those that live are carried over as far as they fit.
    pub fn resize(&mut self, capacity: u32) -> Result<(), JsValue> {
        self.simulator.resize(capacity).map_err(parameter_error)
    }

    /// Writes the rows for a view, its floats and then its solids; returns how many were kept.
    pub fn arrange(&mut self, view: &[f32]) -> Result<u32, JsValue> {
        self.simulator
            .arrange(view)
            .map(|count| count as u32)
            .map_err(parameter_error)
    }

    /// Address of the place rows, four float32 each.
    #[wasm_bindgen(getter = placePointer)]
    pub fn place_pointer(&self) -> u32 {
        self.simulator.place().as_ptr() as u32
    }

    /// Columns, rows, cells from one row to the next, left, low and density of the grid of the last arrange.
    #[wasm_bindgen(getter = coverageShape)]
    pub fn coverage_shape(&self) -> Vec<f32> {
        self.simulator.coverage_shape().to_vec()
    }

    /// Address of its depths, a float32 for each cell.
    #[wasm_bindgen(getter = coveragePointer)]
    pub fn coverage_pointer(&self) -> u32 {
        self.simulator.coverage_depths().as_ptr() as u32
    }

    /// Address of the attribute rows, two uint32 each.
    #[wasm_bindgen(getter = lookPointer)]
    pub fn look_pointer(&self) -> u32 {
        self.simulator.attributes().as_ptr() as u32
    }

    /// Address of seven float32: least and greatest x, y, z and the greatest radius of what lives, as of the last arrange.
    #[wasm_bindgen(getter = boundsPointer)]
    pub fn bounds_pointer(&self) -> u32 {
        self.simulator.bounds().as_ptr() as u32
    }

    /// Particles that live.
    #[wasm_bindgen(getter)]
    pub fn alive(&self) -> u32 {
        self.simulator.alive() as u32
    }

    /// Particles that wait for room.
    #[wasm_bindgen(getter)]
    pub fn waiting(&self) -> f64 {
        self.simulator.waiting() as f64
    }

    /// Vortex particles that live.
    #[wasm_bindgen(getter = vortexParticles)]
    pub fn vortex_particles(&self) -> u32 {
        self.simulator.vortex_particles() as u32
    }

    /// Steps since creation.
    #[wasm_bindgen(getter)]
    pub fn steps(&self) -> f64 {
        self.simulator.steps() as f64
    }

    /// The state's fingerprint, 16 hexadecimal digits.
    pub fn hash(&self) -> String {
        format!("{:016x}", self.simulator.hash())
    }

    /// The whole state as bytes.
    pub fn save(&self) -> Vec<u8> {
        self.simulator.save()
    }

    /// Takes up what `save` gave.
    pub fn restore(&mut self, bytes: &[u8]) -> Result<(), JsValue> {
        self.simulator
            .restore(bytes)
            .map_err(|error| plain_error(&error.message))
    }
}
