//! The kernel of shapes.

use std::sync::Arc;

use wide::f32x4;

use crate::forces::force::{Force, ForceContext, Phase};
use crate::forces::shape::field::Field;
use crate::forces::shape::grids::Placement;
use crate::layout::parameters::forces::shape::Shape;
use crate::layout::scope::Reach;
use crate::math::simd::{LANES, Vector4, positive_part, smaller};
use crate::particles::tile::Tile;

/// Least gradient at which smoke has half its greatest speed.
const SOFT: f32 = 0.4;
/// Cells for each unit of the gradient that smoke at most goes in a step. A longer way would go beyond what it leads to.
const LONGEST_WAY: f32 = 1.5;

/// A shape in one step.
pub struct Kernel {
    placement: Placement,
    field: Arc<Field>,
    speed: f32x4,
    /// Gradient at which smoke has half its speed.
    soft: f32x4,
    /// The hold in a step.
    hold: f32x4,
    scope: Reach,
}

impl Force for Shape {
    type Kernel = Kernel;
    const PHASE: Phase = Phase::Air;

    fn kernel(&self, index: usize, context: &ForceContext) -> Option<Kernel> {
        let outlined = context.prepared.shapes.of_items[index].as_ref()?;
        let placement = Placement::new(self, outlined.field.cells(), &context.now);
        let cells_a_step = self.speed as f32 * context.now.dt as f32 * placement.per_metre;
        Some(Kernel {
            placement,
            field: Arc::clone(&outlined.field),
            speed: f32x4::splat(self.speed as f32),
            soft: f32x4::splat((cells_a_step / LONGEST_WAY).max(SOFT)),
            hold: f32x4::splat((self.hold * context.now.dt) as f32),
            scope: Reach::new(&self.scope, &context.now)?,
        })
    }

    fn act(kernels: &[Kernel], tile: &mut Tile) {
        let columns = tile.columns();
        for kernel in kernels {
            kernel.scope.weigh(columns.ahead, columns.weight);
            let places = columns.ahead.iter().zip(&*columns.weight);
            let motions = columns.flow.iter_mut().zip(&mut *columns.slip);
            for ((ahead, weight), (flow, slip)) in places.zip(motions) {
                if weight.to_array() != [0.0; LANES] {
                    let (velocity, kept) = kernel.motion(*ahead, *weight);
                    *flow += velocity;
                    *slip = *slip * kept;
                }
            }
        }
    }
}

impl Kernel {
    /// The velocity (m/s) at places, and the part of the slip that is kept.
    #[inline(always)]
    fn motion(&self, place: Vector4, weight: f32x4) -> (Vector4, f32x4) {
        let local = self.placement.local(place);
        let beyond = self.beyond(local);
        let towards = self.field.at(&self.field.spots(local)) - beyond;
        let velocity = towards * (self.speed * weight / (towards.length() + self.soft));
        // 1 / (1 + hold * near) for near = weight / (1 + beyond^2), which is finite.
        let far = smaller(f32x4::ONE + beyond.dot(beyond), f32x4::splat(1e30));
        let kept = far / (far + self.hold * weight);
        (self.placement.rotated(velocity), kept)
    }

    /// The way to places from the nearest ones in the grid, in cells.
    #[inline(always)]
    fn beyond(&self, local: Vector4) -> Vector4 {
        let [columns, rows, layers] = self.placement.size;
        let beyond = |place: f32x4, size: f32| place - smaller(positive_part(place), f32x4::splat(size));
        Vector4 {
            x: beyond(local.x, columns),
            y: beyond(local.y, rows),
            z: beyond(local.z, layers) * f32x4::splat(self.placement.thickness),
        }
    }
}
