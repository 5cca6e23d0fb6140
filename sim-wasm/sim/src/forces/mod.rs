//! The forces. Wind, turbulence, vortices and jets say how the air moves; gravity, buoyancy, drag and the others act on
//! a particle's slip, which is its velocity relative to the air. What each does stands in its own file; how they move a
//! particle stands in `motion`.
//!
//! A force is a file here and a row of the table below. Its items are a list of the parameters, its kernel works on a
//! tile of particles at a time, and one that no item asks for costs nothing.

pub mod attractor;
pub mod blow;
pub mod buoyancy;
pub mod drag;
pub mod explosion;
pub mod force;
pub mod gravity;
pub mod jet;
pub mod orbit;
pub mod particle_motion;
pub mod speed_limit;
pub mod spiral;
pub mod turbulence;
pub mod vortex;
pub mod vortex_particles;
pub mod wind;

use arrayvec::ArrayVec;

use crate::forces::force::{Force, ForceContext, Phase};
use crate::layout::parameters::forces::attractor::Attractor;
use crate::layout::parameters::forces::buoyancy::Buoyancy;
use crate::layout::parameters::forces::drag::Drag;
use crate::layout::parameters::forces::explosion::Explosion;
use crate::layout::parameters::forces::for_each_force_list;
use crate::layout::parameters::forces::gravity::Gravity;
use crate::layout::parameters::forces::jet::Jet;
use crate::layout::parameters::forces::orbit::Orbit;
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
        /// All forces of one step, ready for the lanes.
        #[allow(non_snake_case, reason = "lists are called as they are in the table")]
        pub struct Forces {
            $($list: Kernels<$Force>,)*
            blows: blow::Kernels,
        }

        impl Forces {
            /// Those that act in this step.
            pub fn new(context: &ForceContext) -> Self {
                Self {
                    $($list: kernels(&context.parameters.lists.$list, context),)*
                    blows: blow::kernels(context),
                }
            }

            /// Lets those whose turn is `phase` act on the particles of `tile`.
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
