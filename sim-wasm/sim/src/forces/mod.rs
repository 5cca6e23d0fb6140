//! Forces. Wind, turbulence, vortices and jets define the air velocity. Gravity, buoyancy, drag and the others act on
//! the slip: a particle's velocity relative to the air. `particle_motion` integrates both.
//!
//! A force consists of its parameters in `layout::parameters::forces`, a row of the list there, and a kernel here that
//! processes a tile of particles at a time. A force without items costs nothing.
//!
//! The kernels of rare forces are in builds with the feature `rare` only, because most pages never need them. All builds
//! have their parameters, so that saved states are the same.

pub mod attractor;
pub mod blow;
pub mod buoyancy;
pub mod drag;
pub mod explosion;
#[cfg(feature = "rare")]
pub(crate) mod flow;
pub mod force;
mod frames;
pub mod gravity;
pub mod jet;
pub(crate) mod looks;
pub mod orbit;
pub mod particle_motion;
pub(crate) mod prepared;
#[cfg(feature = "rare")]
pub(crate) mod shape;
pub mod speed_limit;
pub mod spiral;
pub mod turbulence;
pub mod vortex;
pub mod vortex_particles;
pub mod wind;
#[cfg(not(feature = "rare"))]
mod without_kernels;

use arrayvec::ArrayVec;

use crate::forces::force::{Force, ForceContext, Phase};
use crate::layout::parameters::forces::attractor::Attractor;
use crate::layout::parameters::forces::buoyancy::Buoyancy;
use crate::layout::parameters::forces::drag::Drag;
use crate::layout::parameters::forces::explosion::Explosion;
use crate::layout::parameters::forces::flow::Flow;
use crate::layout::parameters::forces::for_each_force_list;
use crate::layout::parameters::forces::gravity::Gravity;
use crate::layout::parameters::forces::jet::Jet;
use crate::layout::parameters::forces::orbit::Orbit;
use crate::layout::parameters::forces::shape::Shape;
use crate::layout::parameters::forces::speed_limit::SpeedLimit;
use crate::layout::parameters::forces::spiral::Spiral;
use crate::layout::parameters::forces::turbulence::Turbulence;
use crate::layout::parameters::forces::vortex::Vortex;
use crate::layout::parameters::forces::wind::Wind;
use crate::layout::parameters::item::{LIST_LIMIT, List};
use crate::particles::tile::Tile;

type Kernels<F> = ArrayVec<<F as Force>::Kernel, { LIST_LIMIT + 1 }>;

fn kernels<F: Force>(list: &List<F>, context: &ForceContext) -> Kernels<F> {
    let items = list.items().iter().enumerate();
    let listed = items.filter_map(|(index, item)| item.kernel(index, context));
    F::everywhere(context).into_iter().chain(listed).collect()
}

fn act<F: Force>(kernels: &Kernels<F>, phase: Phase, tile: &mut Tile) {
    if F::PHASE == phase && !kernels.is_empty() {
        F::act(kernels, tile);
    }
}

macro_rules! forces {
    ($($(#[$doc:meta])* $list:ident: $Force:ty,)*) => {
        /// All forces in one step, prepared for SIMD lanes.
        #[allow(non_snake_case, reason = "lists are called as they are in the table")]
        pub struct Forces {
            $($list: Kernels<$Force>,)*
            blows: blow::Kernels,
        }

        impl Forces {
            /// Prepares the forces that act in this step.
            pub fn new(context: &ForceContext) -> Self {
                Self {
                    $($list: kernels(&context.parameters.lists.$list, context),)*
                    blows: blow::kernels(context),
                }
            }

            /// Applies the forces of `phase` to the particles of `tile`.
            pub fn act(&self, phase: Phase, tile: &mut Tile) {
                $(act::<$Force>(&self.$list, phase, tile);)*
                if phase == Phase::Air && !self.blows.is_empty() {
                    blow::act(&self.blows, tile);
                }
            }
        }
    };
}

for_each_force_list!(forces);

impl Forces {
    /// Adds the air velocity of the winds alone.
    pub fn wind(&self, tile: &mut Tile) {
        act::<Wind>(&self.winds, Phase::Air, tile);
    }
}
