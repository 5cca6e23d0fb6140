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
pub mod gravity;
pub mod jet;
pub mod orbit;
pub mod speed_limit;
pub mod spiral;
pub mod turbulence;
pub mod vortex;
pub mod wind;

use arrayvec::ArrayVec;
use wide::f32x4;

use crate::collide::space::{Frame, Vector};
use crate::parameters::section::{Item, List, Many, Section};
use crate::parameters::{LIST_LIMIT, Parameters};
use crate::scope::StepTime;
use crate::simd::{Vector4, positive_part};
use crate::take::active_inputs::Gust;
use crate::tile::Tile;
use turbulence::TurbulenceState;

/// When in a step a force has its turn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Phase {
    /// Adds to the air's velocity, evaluated where the middle of the step is expected.
    Air,
    /// Adds accelerations and drag, or changes the slip.
    Push,
    /// Turns the air, once all else that moves the particle is known.
    Swirl,
    /// Limits the way of the step.
    Limit,
}

/// What forces are made ready from.
#[derive(Clone, Copy, Debug)]
pub struct ForceContext<'s> {
    pub parameters: &'s Parameters,
    pub now: StepTime<'s>,
    /// Chooses the patterns of chance.
    pub seed: u32,
    /// Of each turbulence of the list, then of the one that is everywhere.
    pub turbulence: &'s [TurbulenceState; LIST_LIMIT + 1],
    /// What people blow.
    pub gusts: &'s [Gust],
}

/// A kind of force, described by what one item of its list holds.
pub trait Force: Item {
    /// An item made ready for the lanes of one step.
    type Kernel;

    /// Its turn in a step.
    const PHASE: Phase;

    /// Makes item `index` ready; none where it does nothing in this step.
    fn kernel(&self, index: usize, context: &ForceContext) -> Option<Self::Kernel>;

    /// The force that acts everywhere by parameters of its own, beside the list.
    fn everywhere(_setting: &ForceContext) -> Option<Self::Kernel> {
        None
    }

    /// Lets all that are ready act on the particles of `tile`.
    fn act(kernels: &[Self::Kernel], tile: &mut Tile);
}

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
        /// The lists of forces.
        #[allow(non_snake_case, reason = "lists are called as they are in the table")]
        #[derive(Clone, Copy, Debug, Default, PartialEq)]
        pub struct Lists {
            $($(#[$doc])* pub $list: List<$Force>,)*
        }

        /// The lists as sections of the table.
        pub(crate) const SECTIONS: &[&dyn Section] = &[$(
            &Many {
                name: stringify!($list),
                of: |p| &mut p.lists.$list,
                len: |p| p.lists.$list.items().len(),
            },
        )*];

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

forces! {
    /// `winds.#.*`
    winds: wind::Wind,
    /// `turbulences.#.*`
    turbulences: turbulence::Turbulence,
    /// `vortices.#.*`
    vortices: vortex::Vortex,
    /// `gravities.#.*`
    gravities: gravity::Gravity,
    /// `buoyancies.#.*`
    buoyancies: buoyancy::Buoyancy,
    /// `drags.#.*`
    drags: drag::Drag,
    /// `attractors.#.*`
    attractors: attractor::Attractor,
    /// `orbits.#.*`
    orbits: orbit::Orbit,
    /// `spirals.#.*`
    spirals: spiral::Spiral,
    /// `explosions.#.*`
    explosions: explosion::Explosion,
    /// `jets.#.*`
    jets: jet::Jet,
    /// `speedLimits.#.*`
    speedLimits: speed_limit::SpeedLimit,
}

/// `v` with length 1; straight up where it has no length.
pub fn unit(v: [f64; 3]) -> [f32; 3] {
    let length = libm::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    if length < 1e-9 {
        return [0.0, 1.0, 0.0];
    }
    v.map(|component| (component / length) as f32)
}

/// A place (m) of `frame` in the world, in every lane.
fn place_in(frame: &Frame, place: [f64; 3]) -> Vector4 {
    let local = Vector::from(place.map(|metres| metres as f32));
    Vector4::splat(frame.world_from_local(local).into())
}

/// A vector of `frame` in the world, in every lane.
fn vector_in(frame: &Frame, vector: [f32; 3]) -> Vector4 {
    Vector4::splat(frame.rotate(Vector::from(vector)).into())
}

/// A direction of `frame` in the world with length 1, in every lane.
fn direction_in(frame: &Frame, direction: [f64; 3]) -> Vector4 {
    vector_in(frame, unit(direction))
}

/// (1 - r^2 / R^2)^2 for the squared distance r^2 and the inverse of R^2; 0 where r >= R.
#[inline(always)]
fn fade(squared: f32x4, inverse_reach_squared: f32x4) -> f32x4 {
    let left = positive_part(f32x4::ONE - squared * inverse_reach_squared);
    left * left
}
