//! The cells of an outline: which part of each is inside, by the even-odd rule.

use crate::forces::shape::outline::{Point, layers_of};

/// Cells inside an outline that the grid aims at, and the maximum of all.
const CELLS_INSIDE: f32 = 900.0;
const MAX_CELLS: usize = 4096;
/// Least number of cells between the outline and the border of the grid.
const MARGIN: usize = 3;
/// Columns and rows are multiples of it, so that they can be halved.
const MULTIPLE: usize = 8;
/// Samples of a cell along y.
const SAMPLES: usize = 4;

/// A grid over an outline. Rows go upwards, layers from back to front.
#[derive(Clone, Debug)]
pub struct Cells {
    pub columns: usize,
    pub rows: usize,
    pub layers: usize,
    /// Cells along the longer side of the outline.
    pub extent: f32,
    /// The part of each cell that is inside, 0..=1; cell `x + columns * (y + rows * layer)`.
    pub inside: Vec<f32>,
    /// The sum of `inside`.
    pub mass: f32,
}

impl Cells {
    /// Rasterises an outline; none if nothing is inside. The middle of the grid is that of the outline.
    pub fn new(numbers: &[f64]) -> Option<Self> {
        let layers = layers_of(numbers);
        let ends = |axis: usize| {
            let places = layers.iter().flatten().flatten().map(move |point| point[axis]);
            Some([places.clone().min()? as f32, places.max()? as f32])
        };
        let [across, down] = [ends(0)?, ends(1)?];
        let mut side = libm::sqrtf(area_of(&layers, down) / CELLS_INSIDE).max(1.0);
        let count = |[from, to]: [f32; 2], side: f32| {
            (libm::ceilf((to - from) / side) as usize + 2 * MARGIN).next_multiple_of(MULTIPLE)
        };
        while count(across, side) * count(down, side) * layers.len() > MAX_CELLS {
            side *= 1.05;
        }
        let (columns, rows) = (count(across, side), count(down, side));
        let mut inside = vec![0.0; columns * rows * layers.len()];
        let middle = [across, down].map(|[from, to]| (from + to) / 2.0);
        let left = middle[0] - columns as f32 / 2.0 * side;
        let bottom = middle[1] + rows as f32 / 2.0 * side;
        for (layer, lines) in layers.iter().enumerate() {
            for sample in 0..rows * SAMPLES {
                let y = bottom - (sample as f32 + 0.5) / SAMPLES as f32 * side;
                let row = &mut inside[(layer * rows + sample / SAMPLES) * columns..][..columns];
                for [from, to] in spans(lines, y) {
                    cover(row, (from - left) / side, (to - left) / side);
                }
            }
        }
        let mass = inside.iter().sum();
        let extent = (across[1] - across[0]).max(down[1] - down[0]) / side;
        (mass > 0.0).then_some(Self {
            columns,
            rows,
            layers: layers.len(),
            extent,
            inside,
            mass,
        })
    }
}

/// The area of all layers in units of the sheet.
fn area_of(layers: &[Vec<Vec<Point>>], [top, bottom]: [f32; 2]) -> f32 {
    let rows = top as i32..bottom as i32;
    let lengths = layers
        .iter()
        .flat_map(|lines| rows.clone().flat_map(|row| spans(lines, row as f32 + 0.5)));
    lengths.map(|[from, to]| to - from).sum()
}

/// The parts of the row `y` that are inside an odd number of lines.
fn spans(lines: &[Vec<Point>], y: f32) -> Vec<[f32; 2]> {
    let mut crossings = Vec::new();
    for line in lines {
        for (index, [ax, ay]) in line.iter().enumerate() {
            let [bx, by] = line[(index + 1) % line.len()];
            let [ax, ay, bx, by] = [*ax, *ay, bx, by].map(|place| place as f32);
            if (ay <= y) != (by <= y) {
                crossings.push(ax + (y - ay) / (by - ay) * (bx - ax));
            }
        }
    }
    crossings.sort_by(f32::total_cmp);
    crossings.as_chunks().0.to_vec()
}

/// Adds the share of a sample that each cell of a row has of `from..to`.
fn cover(row: &mut [f32], from: f32, to: f32) {
    for (cell, share) in row.iter_mut().enumerate().take(to as usize + 1).skip(from as usize) {
        let start = from.max(cell as f32);
        let end = to.min((cell + 1) as f32);
        *share += (end - start).max(0.0) / SAMPLES as f32;
    }
}
