//! A convex polygon around discs: everything that a shadow may darken, including the area between its discs.

use std::f32::consts::SQRT_2;

use wide::f32x4;

use crate::math::scalar::lesser;

/// Sixteen sides in groups of four. In each group: to the right and up, right and down, left and up, left and down; in
/// the first: right, up, left, down.
const GROUPS: usize = 4;
/// Tangent and secant of the first normal of all groups but the first. The normals are a sixteenth of a revolution
/// apart.
const NORMALS: [[f32; 2]; GROUPS - 1] = [[0.414_213_57, 1.082_392_2], [1.0, SQRT_2], [2.414_213_7, 2.613_126]];

/// Lengths in cells. The front is flat, at a depth in metres.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Polygon {
    pub u: f32,
    pub v: f32,
    pub depth: f32,
    /// Distance of each side from (u, v), along u except for the first group.
    sides: [f32x4; GROUPS],
}

impl Polygon {
    pub(crate) fn at(u: f32, v: f32, depth: f32) -> Self {
        Self {
            u,
            v,
            depth,
            sides: [f32x4::ZERO; GROUPS],
        }
    }

    /// Extends the polygon around what `reaches` holds.
    #[inline(always)]
    pub(crate) fn extend(&mut self, reaches: &Reaches) {
        for (side, reaches) in self.sides.iter_mut().zip(reaches.0) {
            *side = f32x4::transpose(reaches).into_iter().fold(*side, f32x4::fast_max);
        }
    }

    /// Left, low, right and high limit.
    pub(crate) fn bounds(&self) -> [f32; 4] {
        let [right, up, left, down] = self.sides[0].to_array();
        [self.u - left, self.v - down, self.u + right, self.v + up]
    }

    /// Left and right limit between two heights.
    #[inline(always)]
    pub(crate) fn between(&self, low: f32, high: f32) -> [f32; 2] {
        let [right, _, left, _] = self.sides[0].to_array();
        let (low, high) = (low - self.v, high - self.v);
        // A side that leans back upwards is wider at its low end.
        let widest = f32x4::new([low, -high, low, -high]);
        let mut limits = f32x4::new([right, right, left, left]);
        for (side, [tangent, _]) in self.sides[1..].iter().zip(NORMALS) {
            limits = limits.fast_min(*side - f32x4::splat(tangent) * widest);
        }
        let [right, other_right, left, other_left] = limits.to_array();
        [self.u - lesser(left, other_left), self.u + lesser(right, other_right)]
    }
}

/// How far discs reach in the directions of all sides; each lane has its own discs.
pub(crate) struct Reaches([[f32x4; 4]; GROUPS]);

impl Reaches {
    pub(crate) fn new() -> Self {
        Self([[f32x4::ZERO; 4]; GROUPS])
    }

    /// Adds four discs; their centres are relative to (u, v). A radius of minus infinity marks a missing one.
    #[inline(always)]
    pub(crate) fn add(&mut self, x: f32x4, y: f32x4, radius: f32x4) {
        let [[right, up, left, down], rest @ ..] = &mut self.0;
        *right = right.fast_max(x + radius);
        *up = up.fast_max(y + radius);
        *left = left.fast_max(radius - x);
        *down = down.fast_max(radius - y);
        for ([up, down, back_up, back_down], [tangent, secant]) in rest.iter_mut().zip(NORMALS) {
            let (along, radius) = (f32x4::splat(tangent) * y, f32x4::splat(secant) * radius);
            let (rising, falling) = (x + along, x - along);
            *up = up.fast_max(rising + radius);
            *down = down.fast_max(falling + radius);
            *back_up = back_up.fast_max(radius - falling);
            *back_down = back_down.fast_max(radius - rising);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::random::Random;

    #[test]
    fn contains_every_point_between_its_discs_and_hardly_more() {
        let mut random = Random::new(4);
        for _ in 0..200 {
            let discs: Vec<[f32; 3]> = (0..5)
                .map(|_| [random.signed() * 4.0, random.signed() * 4.0, random.unit()])
                .collect();
            let mut polygon = Polygon::at(10.0, 20.0, 0.0);
            let mut reaches = Reaches::new();
            for [x, y, radius] in &discs {
                let only = |value| f32x4::new([f32::NEG_INFINITY, f32::NEG_INFINITY, value, f32::NEG_INFINITY]);
                reaches.add(f32x4::splat(*x), f32x4::splat(*y), only(*radius));
            }
            polygon.extend(&reaches);
            let most = discs
                .iter()
                .map(|[x, y, radius]| x.hypot(*y) + radius)
                .fold(0.0, f32::max);
            for _ in 0..40 {
                let mut edge = || {
                    let [x, y, radius] = discs[random.bits() as usize % discs.len()];
                    let angle = random.unit() * std::f32::consts::TAU;
                    [x + radius * angle.cos(), y + radius * angle.sin()]
                };
                let (a, b, share) = (edge(), edge(), random.unit());
                let [u, v] = [0, 1].map(|i| a[i] + share * (b[i] - a[i]));
                let [left, right] = polygon.between(20.0 + v - 0.1, 20.0 + v + 0.1);
                assert!(left <= 10.0 + u + 1e-4 && 10.0 + u <= right + 1e-4);
                assert!(right <= 10.0 + 1.02 * most + 0.1 && left >= 10.0 - 1.02 * most - 0.1);
            }
        }
    }
}
