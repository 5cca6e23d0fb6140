//! Shapes: smoke fills an outline evenly and stays there, by its density.
//!
//! v = V g / (|g| + g0), for the greatest speed V and the gradient g of a potential that leads from where there is too
//! much smoke to where the shape lacks it (see `field`). Smoke beyond the grid goes towards it. The velocity is added to
//! the air's, so that turbulence goes on. The slip of smoke near the shape is slowed down at the rate `hold`. Parameters:
//! `shapes.#.outline` (see `outline`); `.speed` V (m/s); `.hold` (1/s); `.size` (m), the longer side of the outline;
//! `.depth` (m); `.position.*` (m), its centre; `.facing.*`, the direction from which it is read. The envelope of the
//! scope says from when to when smoke fills the shape.

#[cfg(feature = "rare")]
mod cells;
#[cfg(feature = "rare")]
mod field;
#[cfg(feature = "rare")]
pub(crate) mod grids;
#[cfg(feature = "rare")]
mod kernel;
#[cfg(feature = "rare")]
mod outline;

#[cfg(not(feature = "rare"))]
use crate::forces::force::{Force, ForceContext, Phase};
#[cfg(not(feature = "rare"))]
use crate::layout::parameters::forces::shape::Shape;
#[cfg(not(feature = "rare"))]
use crate::particles::tile::Tile;

/// A step with a shape is taken by larger builds only.
#[cfg(not(feature = "rare"))]
impl Force for Shape {
    type Kernel = ();
    const PHASE: Phase = Phase::Air;

    fn kernel(&self, _index: usize, _context: &ForceContext) -> Option<()> {
        None
    }

    fn act(_kernels: &[()], _tile: &mut Tile) {}
}
