//! What rare forces derive from their parameters: made anew only when those change, because it takes long.

#[cfg(feature = "rare")]
use std::sync::Arc;

#[cfg(feature = "rare")]
use crate::forces::flow::path::Path;
#[cfg(feature = "rare")]
use crate::layout::parameters::item::LIST_LIMIT;
use crate::layout::parameters::table::Parameters;

/// The derived data of all rare forces. Builds without their kernels have none.
#[derive(Debug, Default)]
pub struct Prepared {
    /// Of each flow; none if its stroke has no length.
    #[cfg(feature = "rare")]
    pub(super) paths: [Option<Arc<Path>>; LIST_LIMIT],
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
    }

    /// Does nothing.
    #[cfg(not(feature = "rare"))]
    pub fn follow(&mut self, _parameters: &Parameters) {}
}
