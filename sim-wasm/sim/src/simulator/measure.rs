//! Measurements, by the feature `bench`: the parts of a step, and Rapier's own answers about the same particles and
//! rigids.

use crate::math::bounds::Bounds;
use crate::math::vector::Vector;
use crate::particles::radius::RadiusLaw;
use crate::simulator::Simulator;

pub use crate::simulator::StepPart;

impl Simulator {
    /// Same as [`Simulator::step`]. Calls `ended` at the end of each part.
    pub fn step_observed(&mut self, ended: impl FnMut(StepPart)) {
        self.step_observed_by(ended);
    }

    /// Writes the indices of the living particles whose box touches the box that a rigid swept in the last step. Any
    /// correct broad phase finds at least these.
    pub fn find_in_touched_boxes(&self, found: &mut Vec<u32>) {
        found.clear();
        let puff_size = RadiusLaw::new(&self.parameters).puff_size;
        for index in 0..self.alive() as u32 {
            let centre = self.centre(index);
            let radius = self.particles.size[index as usize] * puff_size;
            if self.rigids.any_touches(&Bounds::of_way(centre, centre, radius)) {
                found.push(index);
            }
        }
    }

    /// Writes the signed distance (m) from each particle in `asked` to the nearest point of any rigid, by Rapier's
    /// query pipeline. Distances are cut off at `limit` (m).
    pub fn project(&self, asked: &[u32], limit: f32, distances: &mut Vec<f32>) {
        distances.clear();
        let points = asked.iter().map(|index| self.centre(*index));
        self.rigids.project(points, limit, distances);
    }

    fn centre(&self, index: u32) -> Vector {
        let i = index as usize;
        Vector::new(self.particles.x[i], self.particles.y[i], self.particles.z[i])
    }
}
