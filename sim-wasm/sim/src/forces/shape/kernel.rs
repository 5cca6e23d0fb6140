//! The kernel of shapes.

use std::sync::Arc;

use wide::f32x4;

use crate::forces::force::{Force, ForceContext, Phase};
use crate::forces::shape::field::Field;
use crate::forces::shape::grids::Placement;
use crate::layout::parameters::forces::shape::Shape;
use crate::layout::scope::Reach;
use crate::math::simd::{LANES, Vector4};
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
        let (nearest, beyond) = self.nearest(local);
        let mut gradients = [[0.0; 4]; LANES];
        for (lane, gradient) in gradients.iter_mut().enumerate() {
            *gradient = self.field.at(&self.field.spot(nearest[lane])).to_array();
        }
        let of = |axis: usize| f32x4::new(std::array::from_fn(|lane| gradients[lane][axis]));
        let towards = Vector4 {
            x: of(0) - beyond.x,
            y: of(1) - beyond.y,
            z: of(2) - beyond.z,
        };
        let velocity = towards * (self.speed * weight / (towards.length() + self.soft));
        let near = weight / (f32x4::ONE + beyond.dot(beyond));
        let kept = f32x4::ONE / (f32x4::ONE + self.hold * near);
        (self.placement.rotated(velocity), kept)
    }

    /// The nearest place in the grid in each lane, and the way from there, in cells.
    #[inline(always)]
    fn nearest(&self, local: Vector4) -> ([[f32; 3]; LANES], Vector4) {
        let [columns, rows, layers] = self.placement.size;
        let [xs, ys, zs] = [local.x, local.y, local.z].map(f32x4::to_array);
        let mut nearest = [[0.0; 3]; LANES];
        for (lane, nearest) in nearest.iter_mut().enumerate() {
            *nearest = [
                xs[lane].clamp(0.0, columns),
                ys[lane].clamp(0.0, rows),
                zs[lane].clamp(0.0, layers),
            ];
        }
        let of = |axis: usize| f32x4::new(std::array::from_fn(|lane| nearest[lane][axis]));
        let beyond = Vector4 {
            x: local.x - of(0),
            y: local.y - of(1),
            z: (local.z - of(2)) * f32x4::splat(self.placement.thickness),
        };
        (nearest, beyond)
    }
}
