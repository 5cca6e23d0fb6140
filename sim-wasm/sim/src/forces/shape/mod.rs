//! Shapes: smoke fills an outline evenly and stays there, by its density.
//!
//! v = V g / (|g| + g0), for the greatest speed V and the gradient g of a potential that leads from where there is too
//! much smoke to where the shape lacks it (see `field`). Smoke beyond the grid goes towards it. The velocity is added to
//! the air's, so that turbulence goes on. The slip of smoke near the shape is slowed down at the rate `hold`. Parameters:
//! `shapes.#.outline` (see `outline`); `.speed` V (m/s); `.hold` (1/s); `.size` (m), the longer side of the outline;
//! `.depth` (m); `.position.*` (m), its centre; `.facing.*`, the direction from which it is read. The envelope of the
//! scope says from when to when smoke fills the shape.

mod cells;
mod field;
pub(crate) mod grids;
mod kernel;
mod outline;
