//! The lists of forces: one row and one file each.

pub mod attractor;
pub mod buoyancy;
pub mod drag;
pub mod explosion;
pub mod flow;
pub mod gravity;
pub mod jet;
pub mod orbit;
pub mod shape;
pub mod speed_limit;
pub mod spiral;
pub mod turbulence;
pub mod vortex;
pub mod wind;

use bytemuck::Zeroable;

use crate::layout::parameters::forces::attractor::Attractor;
use crate::layout::parameters::forces::buoyancy::Buoyancy;
use crate::layout::parameters::forces::drag::Drag;
use crate::layout::parameters::forces::explosion::Explosion;
use crate::layout::parameters::forces::flow::Flow;
use crate::layout::parameters::forces::gravity::Gravity;
use crate::layout::parameters::forces::jet::Jet;
use crate::layout::parameters::forces::orbit::Orbit;
use crate::layout::parameters::forces::shape::Shape;
use crate::layout::parameters::forces::speed_limit::SpeedLimit;
use crate::layout::parameters::forces::spiral::Spiral;
use crate::layout::parameters::forces::turbulence::Turbulence;
use crate::layout::parameters::forces::vortex::Vortex;
use crate::layout::parameters::forces::wind::Wind;
use crate::layout::parameters::item::List;

/// Calls the macro `$then` with a row `list: Type` for each list of forces, in the order of the table.
macro_rules! for_each_force_list {
    ($then:ident) => {
        $then! {
            /// `winds.#.*`
            winds: Wind,
            /// `turbulences.#.*`
            turbulences: Turbulence,
            /// `vortices.#.*`
            vortices: Vortex,
            /// `gravities.#.*`
            gravities: Gravity,
            /// `buoyancies.#.*`
            buoyancies: Buoyancy,
            /// `drags.#.*`
            drags: Drag,
            /// `attractors.#.*`
            attractors: Attractor,
            /// `orbits.#.*`
            orbits: Orbit,
            /// `spirals.#.*`
            spirals: Spiral,
            /// `explosions.#.*`
            explosions: Explosion,
            /// `jets.#.*`
            jets: Jet,
            /// `speedLimits.#.*`
            speedLimits: SpeedLimit,
            /// `flows.#.*`
            flows: Flow,
            /// `shapes.#.*`
            shapes: Shape,
        }
    };
}
pub(crate) use for_each_force_list;

macro_rules! lists {
    ($($(#[$doc:meta])* $list:ident: $Force:ty,)*) => {
        /// The lists of forces.
        #[allow(non_snake_case, reason = "lists are called as they are in the table")]
        #[derive(Clone, Copy, Debug, PartialEq, Zeroable)]
        pub struct Lists {
            $($(#[$doc])* pub $list: List<$Force>,)*
        }
    };
}

for_each_force_list!(lists);

impl Lists {
    /// Returns true if there are items of lists whose kernels only builds with the feature `rare` have.
    pub fn has_rare(&self) -> bool {
        !self.flows.items().is_empty() || !self.shapes.items().is_empty()
    }
}
