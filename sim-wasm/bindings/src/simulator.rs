//! The class `Simulator`: each method is one call of `sim`.

use wasm_bindgen::prelude::*;

use crate::error::{parameter_error, plain_error};

/// Particles, forces and colliders; rigids in the larger variants. Errors are objects `{ key, value, min, max,
/// message }`; a call that fails changes nothing.
#[wasm_bindgen]
pub struct Simulator {
    pub(crate) simulator: sim::Simulator,
}

#[wasm_bindgen]
impl Simulator {
    /// Creates a simulator for at most `capacity` particles and allocates their memory.
    #[wasm_bindgen(constructor)]
    pub fn new(capacity: u32, seed: u32) -> Result<Simulator, JsValue> {
        let simulator = sim::Simulator::new(capacity, seed).map_err(parameter_error)?;
        Ok(Simulator { simulator })
    }

    /// Sets `values[i]` for line i of `keys`; all or none.
    pub fn set(&mut self, keys: &str, values: &[f64]) -> Result<(), JsValue> {
        let pairs: Vec<(&str, f64)> = keys.lines().zip(values.iter().copied()).collect();
        self.simulator.set_all(&pairs).map_err(parameter_error)
    }

    /// Adds the surface of a mesh for emitters and returns its index. See `sim::emission::surface::Surface::new`.
    #[wasm_bindgen(js_name = addSurface)]
    pub fn add_surface(&mut self, vertices: &[f32], indices: &[u32]) -> Result<u32, JsValue> {
        self.simulator.add_surface(vertices, indices).map_err(parameter_error)
    }

    /// Sets, frees or bursts an emitter. See `sim::emission::Births::put`. Returns the error, since a `Result` would be an
    /// array for each call.
    #[wasm_bindgen(js_name = setEmitter)]
    pub fn set_emitter(&mut self, index: u32, numbers: &[f64], count: u32) -> JsValue {
        let result = self.simulator.set_emitter(index, numbers, count);
        result.map_or_else(parameter_error, |()| JsValue::UNDEFINED)
    }

    /// Sets, moves or removes a collider. See `sim::collide::pool::ColliderPool::put`.
    #[wasm_bindgen(js_name = setCollider)]
    pub fn set_collider(&mut self, index: u32, numbers: &[f32]) -> Result<(), JsValue> {
        self.simulator.set_collider(index, numbers).map_err(parameter_error)
    }

    /// Sets the poses of the scene's parts for the coming step. See `sim::layout::scope::parts::Parts::place`.
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

    /// Changes the maximum number of particles. Living particles are kept as far as they fit.
    pub fn resize(&mut self, capacity: u32) -> Result<(), JsValue> {
        self.simulator.resize(capacity).map_err(parameter_error)
    }

    /// Writes the rows of a view, its floats and then its solids. Returns the number of rows.
    pub fn arrange(&mut self, view: &[f32]) -> Result<u32, JsValue> {
        self.simulator
            .arrange(view)
            .map(|count| count as u32)
            .map_err(parameter_error)
    }

    /// Number of rows of the last arrange whose puffs are not eroded. They come first.
    #[wasm_bindgen(getter)]
    pub fn whole(&self) -> u32 {
        self.simulator.whole() as u32
    }

    /// Displacement (m) in the latest step of each row of the last arrange, three floats each.
    pub fn moves(&self) -> Vec<f32> {
        self.simulator.moves().into_flattened()
    }

    /// Place and light of the lamps at the glowing parts of smoke, eight floats each. See `sim::arrange::glow`.
    pub fn glow(&self, blend: f32, colors: &[f32]) -> Vec<f32> {
        self.simulator.glow(blend, colors)
    }

    /// True if there are forces that only the larger variants have.
    #[wasm_bindgen(getter = hasRareForces)]
    pub fn has_rare_forces(&self) -> bool {
        self.simulator.has_rare_forces()
    }

    /// True if emitters have or had looks.
    #[wasm_bindgen(getter = hasLooks)]
    pub fn has_looks(&self) -> bool {
        self.simulator.has_looks()
    }

    /// Style, tint and dissolution of each look from 1 to 15, three numbers each as in the table; 0 for those that no puff
    /// has had. Empty unless there are looks. See `sim::particles::looks`.
    #[wasm_bindgen(js_name = lookStyles)]
    pub fn look_styles(&self) -> Vec<f64> {
        self.simulator.look_styles()
    }

    /// Number of steps at which the last puff of the latest burst of an emitter ends, known from the step of its births
    /// on; -1 before, and without a burst. See `sim::emission::Births::burst_end`.
    #[wasm_bindgen(js_name = burstEnd)]
    pub fn burst_end(&self, index: u32) -> f64 {
        self.simulator.burst_end(index).map_or(-1.0, |step| step as f64)
    }

    /// One more than the highest variation of a living particle; 0 without particles.
    #[wasm_bindgen(getter = variationsAlive)]
    pub fn variations_alive(&self) -> u32 {
        self.simulator.variations_alive()
    }

    /// Address of the place rows, four float32 each.
    #[wasm_bindgen(getter = placePointer)]
    pub fn place_pointer(&self) -> u32 {
        self.simulator.place().as_ptr() as u32
    }

    /// Columns, rows, stride, left, low and density of the coverage grid of the last arrange.
    #[wasm_bindgen(getter = coverageShape)]
    pub fn coverage_shape(&self) -> Vec<f32> {
        self.simulator.coverage_shape().to_vec()
    }

    /// Address of its depths, one float32 per cell.
    #[wasm_bindgen(getter = coveragePointer)]
    pub fn coverage_pointer(&self) -> u32 {
        self.simulator.coverage_depths().as_ptr() as u32
    }

    /// Address of the attribute rows, two uint32 each.
    #[wasm_bindgen(getter = lookPointer)]
    pub fn look_pointer(&self) -> u32 {
        self.simulator.attributes().as_ptr() as u32
    }

    /// Address of seven float32: minimum and maximum x, y, z and the largest radius of living particles at the last
    /// arrange.
    #[wasm_bindgen(getter = boundsPointer)]
    pub fn bounds_pointer(&self) -> u32 {
        self.simulator.bounds().as_ptr() as u32
    }

    /// Number of living particles.
    #[wasm_bindgen(getter)]
    pub fn alive(&self) -> u32 {
        self.simulator.alive() as u32
    }

    /// Number of particles that wait for capacity.
    #[wasm_bindgen(getter)]
    pub fn waiting(&self) -> f64 {
        self.simulator.waiting() as f64
    }

    /// Number of vortex particles.
    #[wasm_bindgen(getter = vortexParticles)]
    pub fn vortex_particles(&self) -> u32 {
        self.simulator.vortex_particles() as u32
    }

    /// Steps since creation.
    #[wasm_bindgen(getter)]
    pub fn steps(&self) -> f64 {
        self.simulator.steps() as f64
    }

    /// Hash of the state, 16 hexadecimal digits.
    pub fn hash(&self) -> String {
        format!("{:016x}", self.simulator.hash())
    }

    /// Serialises the whole state.
    pub fn save(&self) -> Vec<u8> {
        self.simulator.save()
    }

    /// Restores the bytes of `save`, with or without rigids and colliders outside of the table.
    pub fn restore(&mut self, bytes: &[u8], obstacles: bool) -> Result<(), JsValue> {
        self.simulator
            .restore_with(bytes, obstacles)
            .map_err(|error| plain_error(&error.message))
    }
}
