//! Calls for benchmarks only: they read the clock inside of the module.

use wasm_bindgen::prelude::*;

use crate::simulator::Simulator;

#[wasm_bindgen]
extern "C" {
    #[wasm_bindgen(js_namespace = performance)]
    fn now() -> f64;
}

#[wasm_bindgen]
impl Simulator {
    /// Makes one step and returns the milliseconds of each of its parts, see `sim::simulator::StepPart`.
    #[wasm_bindgen(js_name = stepObserved)]
    pub fn step_observed(&mut self) -> Vec<f64> {
        let mut took = Vec::with_capacity(8);
        let mut start = now();
        self.simulator.step_observed(|_| {
            let end = now();
            took.push(end - start);
            start = end;
        });
        took
    }

    /// The particles whose boxes touch that of a rigid.
    #[wasm_bindgen(js_name = findInTouchedBoxes)]
    pub fn find_in_touched_boxes(&self) -> Vec<u32> {
        let mut found = Vec::new();
        self.simulator.find_in_touched_boxes(&mut found);
        found
    }

    /// Milliseconds in which Rapier's query pipeline projects the particles `asked`, up to `limit` metres away.
    #[wasm_bindgen(js_name = projectionTime)]
    pub fn projection_time(&self, asked: &[u32], limit: f32) -> f64 {
        let mut distances = Vec::with_capacity(asked.len());
        let start = now();
        self.simulator.project(asked, limit, &mut distances);
        now() - start
    }

    /// The distances (m) of these projections, negative inside.
    pub fn distances(&self, asked: &[u32], limit: f32) -> Vec<f32> {
        let mut distances = Vec::with_capacity(asked.len());
        self.simulator.project(asked, limit, &mut distances);
        distances
    }
}
