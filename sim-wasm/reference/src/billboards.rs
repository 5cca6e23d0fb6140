//! Billboards: the baked front of a puff, rotated about the view axis by its roll. Small billboards read mipmaps, whose
//! texels are means of four.

use glam::{DVec2, DVec3};

use crate::scene::Layers;

/// Normal and depth as the layers hold them, then the colour and the coverage from 0 to 1.
type Texel = [f64; 8];

/// The mipmaps of the fronts of all variations, largest first.
pub struct Billboards {
    levels: Vec<Level>,
    variations: usize,
    pad: f64,
    distance_range: f64,
}

struct Level {
    size: usize,
    texels: Vec<Texel>,
}

/// The texel at a position of a front.
pub struct Front {
    /// Height over the centre plane (radii).
    pub height: f64,
    /// Distance to the silhouette (radii), at most 0 inside.
    pub outside: f64,
    /// Unit normal, without the roll.
    pub normal: DVec3,
    /// C of Eq. 2, 0 to 1.
    pub color: DVec3,
}

impl Billboards {
    pub fn new(layers: &Layers) -> Self {
        let texels: Vec<Texel> = layers
            .normal_depth
            .chunks_exact(4)
            .zip(layers.color_coverage.chunks_exact(4))
            .map(|(front, paint)| std::array::from_fn(|at| if at < 4 { front[at] } else { paint[at - 4] / 255.0 }))
            .collect();
        let variations = texels.len() / (layers.size * layers.size);
        let size = layers.size;
        let mut levels = vec![Level { size, texels }];
        while let Some(level) = levels.last().filter(|level| level.size > 1) {
            levels.push(level.halved(variations));
        }
        Self {
            levels,
            variations,
            pad: layers.pad,
            distance_range: layers.distance_range,
        }
    }

    /// `point`: in radii, in the frame of the front. `pixel`: radii per pixel of the picture.
    pub fn at(&self, variation: usize, point: DVec2, pixel: f64) -> Front {
        let place = 0.5 + 0.5 * point / self.pad;
        let smallest = (self.levels.len() - 1) as f64;
        let texels = pixel * self.levels[0].size as f64 / (2.0 * self.pad);
        let level = texels.log2().clamp(0.0, smallest);
        let (lower, share) = (level.floor(), level.fract());
        let read = |level: f64| self.levels[level.min(smallest) as usize].at(variation % self.variations, place);
        let [x, y, z, depth, red, green, blue, coverage] = mixed(read(lower), read(lower + 1.0), share);
        Front {
            height: (depth - 0.5) * 2.0 * self.pad,
            outside: (coverage - 0.5) * self.distance_range,
            normal: (2.0 * DVec3::new(x, y, z) - 1.0).normalize(),
            color: DVec3::new(red, green, blue),
        }
    }
}

impl Level {
    fn halved(&self, variations: usize) -> Self {
        let size = self.size / 2;
        let mut texels = Vec::with_capacity(variations * size * size);
        for row in 0..variations * size {
            for column in 0..size {
                let four = [0, 1, self.size, self.size + 1].map(|step| 2 * row * self.size + 2 * column + step);
                texels.push(std::array::from_fn(|value| {
                    four.map(|at| self.texels[at][value]).iter().sum::<f64>() / 4.0
                }));
            }
        }
        Self { size, texels }
    }

    /// Bilinear, clamped to the border. `place`: 0 to 1.
    fn at(&self, variation: usize, place: DVec2) -> Texel {
        let last = (self.size - 1) as f64;
        let [x, y] = (self.size as f64 * place - 0.5)
            .clamp(DVec2::ZERO, DVec2::splat(last))
            .to_array();
        let texel = |x: f64, y: f64| {
            let row = variation * self.size + y.min(last) as usize;
            self.texels[row * self.size + x.min(last) as usize]
        };
        let (left, low) = (x.floor(), y.floor());
        let row = |y: f64| mixed(texel(left, y), texel(left + 1.0, y), x.fract());
        mixed(row(low), row(low + 1.0), y.fract())
    }
}

fn mixed(one: Texel, other: Texel, share: f64) -> Texel {
    std::array::from_fn(|value| one[value] + share * (other[value] - one[value]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_slope_is_read_as_a_slope_at_any_size() {
        let size = 16;
        let depth = |column: usize| 0.5 + 0.01 * (column as f64 + 0.5 - 8.0);
        let layers = Layers {
            size,
            pad: 1.25,
            distance_range: 2.0,
            normal_depth: (0..size * size)
                .flat_map(|at| [0.5, 0.5, 1.0, depth(at % size)])
                .collect(),
            color_coverage: vec![255.0; 4 * size * size],
        };
        let boards = Billboards::new(&layers);
        for pixel in [0.01, 0.2, 0.35] {
            let front = boards.at(3, DVec2::new(0.3, -0.4), pixel);
            // In sixteenths of the side of 2.5 radii.
            assert!((front.height - 2.5 * 0.01 * 0.3 * 16.0 / 2.5).abs() < 1e-9);
            assert!(front.outside == 1.0 && front.normal.distance(DVec3::Z) < 1e-9);
        }
    }
}
