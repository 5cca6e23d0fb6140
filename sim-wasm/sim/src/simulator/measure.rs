//! What only measurements need, by the feature `bench`: a step in its parts, and the answers that Rapier itself gives
//! about the same particles and rigids.

use crate::math::bounds::Bounds;
use crate::math::vector::Vector;
use crate::particles::radius::RadiusLaw;
use crate::simulator::Simulator;

pub use crate::simulator::StepPart;

impl Simulator {
    /// As [`Simulator::step`]; calls `ended` at the end of each part.
    pub fn step_observed(&mut self, ended: impl FnMut(StepPart)) {
        self.step_observed_by(ended);
    }

    /// Writes the numbers of the living particles whose own box touches the box that a rigid swept in the last step:
    /// any cells that hold all that may touch hold at least these.
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

    /// Asks Rapier's query pipeline for the point of any rigid nearest to each of `asked` and writes the signed
    /// distance (m); for points farther than `limit` (m) that limit.
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
