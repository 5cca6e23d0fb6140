//! What rare forces derive from their parameters: made anew only when those change, because it takes long. What they
//! derive from the smoke is made anew in each step.

#[cfg(feature = "rare")]
use std::sync::Arc;

#[cfg(feature = "rare")]
use crate::forces::flow::path::Path;
#[cfg(feature = "rare")]
use crate::forces::shape::grids::Shapes;
#[cfg(feature = "rare")]
use crate::layout::parameters::item::LIST_LIMIT;
use crate::layout::parameters::table::Parameters;
use crate::layout::scope::StepTime;
use crate::particles::Particles;

/// The derived data of all rare forces. Builds without their kernels have none.
#[derive(Default)]
pub struct Prepared {
    /// Of each flow; none if its stroke has no length.
    #[cfg(feature = "rare")]
    pub(super) paths: [Option<Arc<Path>>; LIST_LIMIT],
    #[cfg(feature = "rare")]
    pub(super) shapes: Shapes,
}

impl Prepared {
    /// Follows a change of parameters.
    #[cfg(feature = "rare")]
    pub fn follow(&mut self, parameters: &Parameters) {
        for (path, flow) in self.paths.iter_mut().zip(parameters.lists.flows.items()) {
            if !path.as_ref().is_some_and(|path| path.is_of(flow)) {
                *path = Path::new(flow).map(Arc::new);
            }
        }
        self.shapes.prepare(parameters.lists.shapes.items());
    }

    /// Follows the places of particles before a step.
    #[cfg(feature = "rare")]
    pub fn measure(&mut self, parameters: &Parameters, particles: &Particles, now: &StepTime) {
        self.shapes.measure(parameters.lists.shapes.items(), particles, now);
    }

    /// Does nothing.
    #[cfg(not(feature = "rare"))]
    pub fn follow(&mut self, _parameters: &Parameters) {}

    /// Does nothing.
    #[cfg(not(feature = "rare"))]
    pub fn measure(&mut self, _parameters: &Parameters, _particles: &Particles, _now: &StepTime) {}
}
