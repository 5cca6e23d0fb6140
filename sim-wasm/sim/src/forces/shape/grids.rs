//! The grids of all shapes: where their smoke is, and where it goes.

use std::sync::Arc;

use wide::f32x4;

use crate::forces::frames::{direction_in, place_in};
use crate::forces::shape::cells::Cells;
use crate::forces::shape::field::Field;
use crate::layout::parameters::forces::shape::Shape;
use crate::layout::parameters::item::LIST_LIMIT;
use crate::layout::scope::{Reach, StepTime};
use crate::math::double;
use crate::math::simd::{LANES, Vector4, blocks};
use crate::particles::Particles;

/// Distance from the layers up to which smoke is of the shape, in cells.
const NEAR: f32 = 2.0;

/// The fields of all shapes. Their memory is allocated when an outline is set.
#[derive(Default)]
pub struct Shapes {
    pub(super) of_items: [Option<Outlined>; LIST_LIMIT],
}

/// The field of an outline.
pub(super) struct Outlined {
    outline: Box<[f64]>,
    pub(super) field: Arc<Field>,
}

impl Shapes {
    /// Makes the fields of new outlines and drops those of removed ones.
    pub fn prepare(&mut self, shapes: &[Shape]) {
        for (index, own) in self.of_items.iter_mut().enumerate() {
            let shape = shapes.get(index).filter(|shape| shape.speed > 0.0);
            if own.as_ref().map(|own| &*own.outline) != shape.map(|shape| &shape.outline[..]) {
                *own = shape.and_then(Outlined::new);
            }
        }
    }

    /// Computes the fields for the places of `particles`.
    pub fn measure(&mut self, shapes: &[Shape], particles: &Particles, now: &StepTime) {
        for (own, shape) in self.of_items.iter_mut().zip(shapes) {
            // Only during a change of the integrator within a step do kernels still hold the field, which is then copied.
            let field = own.as_mut().map(|own| Arc::make_mut(&mut own.field));
            if let (Some(field), Some(reach)) = (field, Reach::new(&shape.scope, now)) {
                let placement = Placement::new(shape, field.cells(), now);
                placement.distribute(particles, &reach, field);
                field.solve(placement.thickness);
            }
        }
    }
}

impl Outlined {
    fn new(shape: &Shape) -> Option<Self> {
        let field = Arc::new(Field::new(Cells::new(&shape.outline)?));
        Some(Self {
            outline: Box::new(shape.outline),
            field,
        })
    }
}

/// The coordinates of a grid: in cells from its lower left back corner, layers along z.
#[derive(Clone, Copy, Debug)]
pub(super) struct Placement {
    origin: Vector4,
    right: Vector4,
    up: Vector4,
    facing: Vector4,
    /// Cells in a metre.
    pub(super) per_metre: f32,
    /// Thickness of a layer in cells.
    pub(super) thickness: f32,
    /// Columns, rows and layers.
    pub(super) size: [f32; 3],
}

impl Placement {
    pub(super) fn new(shape: &Shape, cells: &Cells, now: &StepTime) -> Self {
        let frame = now.frame(&shape.scope);
        let facing = double::unit(if shape.facing == [0.0; 3] {
            [0.0, 0.0, 1.0]
        } else {
            shape.facing
        });
        // A shape that is read from above has its upper side at the back.
        let upwards = if facing[0] * facing[0] + facing[2] * facing[2] > 1e-12 {
            [0.0, 1.0, 0.0]
        } else {
            [0.0, 0.0, -1.0]
        };
        let right = double::unit(double::cross(upwards, facing));
        let per_metre = cells.extent / shape.size as f32;
        Self {
            origin: place_in(&frame, shape.position),
            right: direction_in(&frame, right),
            up: direction_in(&frame, double::cross(facing, right)),
            facing: direction_in(&frame, facing),
            per_metre,
            thickness: (shape.depth as f32 * per_metre / cells.layers as f32).max(0.01),
            size: [cells.columns, cells.rows, cells.layers].map(|count| count as f32),
        }
    }

    /// Converts places to coordinates of the grid.
    #[inline(always)]
    pub(super) fn local(&self, place: Vector4) -> Vector4 {
        let offset = place - self.origin;
        let [columns, rows, layers] = self.size.map(|size| f32x4::splat(size * 0.5));
        let per_metre = f32x4::splat(self.per_metre);
        Vector4 {
            x: self.right.dot(offset) * per_metre + columns,
            y: self.up.dot(offset) * per_metre + rows,
            z: self.facing.dot(offset) * f32x4::splat(self.per_metre / self.thickness) + layers,
        }
    }

    /// Rotates a vector of the grid to world space.
    #[inline(always)]
    pub(super) fn rotated(&self, vector: Vector4) -> Vector4 {
        self.right * vector.x + self.up * vector.y + self.facing * vector.z
    }

    /// Counts the smoke in each cell.
    fn distribute(&self, particles: &Particles, reach: &Reach, field: &mut Field) {
        field.clear();
        let alive = particles.alive();
        let count = alive.div_ceil(LANES);
        let [x, y, z] = [&particles.x, &particles.y, &particles.z].map(|column| blocks(column, count));
        let margin = NEAR / self.thickness;
        let lanes = f32x4::new([0.0, 1.0, 2.0, 3.0]);
        for block in 0..count {
            let place = Vector4::load(x, y, z, block);
            let mut weights = [f32x4::ZERO];
            reach.weigh(&[place], &mut weights);
            let local = self.local(place);
            let is_within = |place: f32x4, margin: f32, size: f32| {
                place.simd_ge(f32x4::splat(-margin)) & place.simd_le(f32x4::splat(size + margin))
            };
            let [columns, rows, layers] = self.size;
            let within = is_within(local.x, 0.0, columns) & is_within(local.y, 0.0, rows);
            // The last block has lanes without particles.
            let is_alive = f32x4::splat((alive - block * LANES) as f32).simd_gt(lanes);
            let amounts = weights[0] & is_alive & within & is_within(local.z, margin, layers);
            if amounts.to_array() != [0.0; LANES] {
                field.add(&field.spots(local), amounts);
            }
        }
    }
}
