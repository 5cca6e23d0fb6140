//! The particles near selected rigids: those with a boundary layer, or those that feel smoke. A separate grid keeps all
//! other rigids free of cost.

use crate::collide::broad_phase::{SweptBoxes, extent, for_each_near};
use crate::math::bounds::{Bounds, WideBounds};
use crate::math::vector::Vector;
use crate::particles::Particles;
use crate::particles::radius::RadiusLaw;
use crate::rigids::grid::RigidGrid;

/// Selected rigids, each with a box around it.
#[derive(Debug, Default)]
pub struct Shells {
    rigids: Vec<usize>,
    grid: RigidGrid,
    near: Vec<u32>,
}

impl Shells {
    /// Adds a rigid, unless it was added before. Rigids are in order, so that restored ones act in the same order.
    pub fn add(&mut self, rigid: usize) {
        if let Err(at) = self.rigids.binary_search(&rigid) {
            self.rigids.insert(at, rigid);
            self.grid.add(Bounds::NOTHING);
            self.near.reserve(self.rigids.len());
        }
    }

    /// Calls `meet` for each particle near the box of a rigid, ordered by particle, then by rigid. `bounds` returns the
    /// box; none skips the rigid in this step.
    pub fn for_each_near(
        &mut self,
        particles: &mut Particles,
        radii: &RadiusLaw,
        bounds: impl Fn(usize) -> Option<Bounds>,
        mut meet: impl FnMut(&mut Particles, usize, usize),
    ) {
        for (slot, rigid) in self.rigids.iter().enumerate() {
            self.grid.place(slot, bounds(*rigid).unwrap_or(Bounds::NOTHING));
        }
        let all = self.grid.bounds();
        if all == Bounds::NOTHING {
            return;
        }
        let extent = extent(particles, radii);
        self.grid.rebuild(&extent);
        let Self { rigids, grid, near } = self;
        let look = |swept_boxes: &SweptBoxes| grid.look(swept_boxes, &all);
        for_each_near(particles, radii, look, |particles, i, location| {
            near.clear();
            let way = way_of(particles, i, radii);
            grid.find_touching(&way, location, 0, near);
            near.sort_unstable();
            for slot in near.iter() {
                meet(particles, i, rigids[*slot as usize]);
            }
        });
    }
}

/// The box that a particle swept in the last step, radius included.
fn way_of(particles: &Particles, i: usize, radii: &RadiusLaw) -> WideBounds {
    let from = Vector::new(particles.px[i], particles.py[i], particles.pz[i]);
    let to = Vector::new(particles.x[i], particles.y[i], particles.z[i]);
    WideBounds::of_way(from, to, particles.size[i] * radii.puff_size)
}
