//! Rare forces in builds without their kernels. A step with one of them is taken by larger builds only.

use crate::forces::force::{Force, ForceContext, Phase};
use crate::layout::parameters::forces::flow::Flow;
use crate::layout::parameters::forces::shape::Shape;
use crate::particles::tile::Tile;

macro_rules! without_kernels {
    ($($Force:ty),*) => {$(
        impl Force for $Force {
            type Kernel = ();
            const PHASE: Phase = Phase::Air;

            fn kernel(&self, _index: usize, _context: &ForceContext) -> Option<()> {
                None
            }

            fn act(_kernels: &[()], _tile: &mut Tile) {}
        }
    )*};
}

without_kernels!(Flow, Shape);
