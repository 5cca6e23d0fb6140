//! A convex polygon around discs: everything that a shadow may darken, including the area between its discs.

use std::f32::consts::FRAC_1_SQRT_2;

/// Number of sides. Their normals are a sixteenth of a revolution apart; the first is along u.
const SIDES: usize = 16;
const COSINES: [f32; SIDES] = [
    1.0,
    0.923_879_5,
    FRAC_1_SQRT_2,
    0.382_683_43,
    0.0,
    -0.382_683_43,
    -FRAC_1_SQRT_2,
    -0.923_879_5,
    -1.0,
    -0.923_879_5,
    -FRAC_1_SQRT_2,
    -0.382_683_43,
    0.0,
    0.382_683_43,
    FRAC_1_SQRT_2,
    0.923_879_5,
];
/// The sides with normals along v and opposite to it.
const UP: usize = SIDES / 4;
const DOWN: usize = 3 * SIDES / 4;

/// Lengths in cells. The front is flat, at a depth in metres.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Polygon {
    pub u: f32,
    pub v: f32,
    pub depth: f32,
    /// Distance of each side from (u, v).
    sides: [f32; SIDES],
}

impl Polygon {
    pub(crate) fn at(u: f32, v: f32, depth: f32) -> Self {
        Self {
            u,
            v,
            depth,
            sides: [0.0; SIDES],
        }
    }

    /// Extends the polygon around a disc; its centre is relative to (u, v).
    #[inline(always)]
    pub(crate) fn hold(&mut self, x: f32, y: f32, radius: f32) {
        for (side, at) in self.sides.iter_mut().enumerate() {
            let out = COSINES[side] * x + sine(side) * y + radius;
            *at = at.max(out);
        }
    }

    /// Left, low, right and high limit.
    pub(crate) fn bounds(&self) -> [f32; 4] {
        [
            self.u - self.sides[SIDES / 2],
            self.v - self.sides[DOWN],
            self.u + self.sides[0],
            self.v + self.sides[UP],
        ]
    }

    /// Left and right limit between two heights.
    #[inline(always)]
    pub(crate) fn between(&self, low: f32, high: f32) -> [f32; 2] {
        let (low, high) = (low - self.v, high - self.v);
        let (mut left, mut right) = (-self.sides[SIDES / 2], self.sides[0]);
        for (side, cosine, sine) in (1..UP).map(|side| (side, COSINES[side], sine(side))) {
            // A side that leans back upwards is wider at its low end.
            right = right
                .min((self.sides[side] - sine * low) / cosine)
                .min((self.sides[SIDES - side] + sine * high) / cosine);
            left = left
                .max((sine * low - self.sides[SIDES / 2 - side]) / cosine)
                .max((-sine * high - self.sides[SIDES / 2 + side]) / cosine);
        }
        [self.u + left, self.u + right]
    }
}

const fn sine(side: usize) -> f32 {
    COSINES[(side + SIDES - UP) % SIDES]
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
            discs.iter().for_each(|[x, y, radius]| polygon.hold(*x, *y, *radius));
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
