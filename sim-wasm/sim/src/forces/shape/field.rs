//! The field that spreads smoke evenly over the cells of a shape.
//!
//! Smoke and shape are as opposite charges: the potential solves -lap(u) = inside - smoke * cells / all smoke, with closed
//! borders. Its gradient leads from where there is too much smoke to where the shape lacks it, and is 0 where the smoke
//! is even and all inside. After Schmaltz, Gwosdek, Bruhn and Weickert, "Electrostatic Halftoning", Computer Graphics
//! Forum 29, 2010, on a grid as in Hockney and Eastwood, "Computer Simulation Using Particles", 1981: smoke is
//! distributed over the nearest cells by the same weights by which the gradient is read, so that a puff does not push
//! itself.
//!
//! The potential is approximate, and the same in every step from the same places: from the coarsest of four grids to
//! the finest, each with a few rounds of Jacobi's method from the values of the one before.

use wide::f32x4;

use crate::forces::shape::cells::Cells;
use crate::math::simd::{CELL_ZERO, LANES, Vector4, blocks, cell_and_fraction, positive_part, smaller};

/// Grids, each with half the columns and rows of the one before.
const LEVELS: usize = 4;
/// Rounds on the coarsest grid, and on the others.
const COARSE_ROUNDS: usize = 12;
const ROUNDS: usize = 3;
/// Damping of Jacobi's method.
const DAMPING: f32 = 0.8;
/// Additional charge of the shape, relative to its own: without it, smoke beside a filled shape would stay there.
const PULL: f32 = 0.12;
/// Least smoke (particles) from which on there is a field.
const LEAST_SMOKE: f32 = 0.5;

/// One grid with a border of one cell, whose values repeat those beside it.
#[derive(Clone, Debug)]
struct Level {
    columns: usize,
    rows: usize,
    charge: Vec<f32>,
    potential: Vec<f32>,
    next: Vec<f32>,
}

/// The field of a shape.
#[derive(Clone, Debug)]
pub struct Field {
    cells: Cells,
    /// Smoke in each cell, and its sum in each lane (particles).
    smoke: Vec<f32>,
    all: f32x4,
    levels: Vec<Level>,
    /// Gradient of the potential in each cell along x, y and z, per cell.
    gradient: Vec<f32x4>,
}

/// Four places within the grid: the cell below each, and the weights of it and the next ones along x, y and z.
pub struct Spots {
    cells: [usize; LANES],
    /// Of the cell, and of the next along x, along y, and along both.
    weights: [f32x4; 4],
    layers: f32x4,
}

impl Field {
    pub fn new(cells: Cells) -> Self {
        let level = |level: usize| {
            let (columns, rows) = (cells.columns >> level, cells.rows >> level);
            let size = (columns + 2) * (rows + 2) * cells.layers;
            let zeros = || vec![0.0; size];
            Level {
                columns,
                rows,
                charge: vec![0.0; columns * rows * cells.layers],
                potential: zeros(),
                next: zeros(),
            }
        };
        Self {
            smoke: vec![0.0; cells.inside.len()],
            all: f32x4::ZERO,
            levels: (0..LEVELS).map(level).collect(),
            gradient: vec![f32x4::ZERO; cells.inside.len()],
            cells,
        }
    }

    /// The grid.
    pub fn cells(&self) -> &Cells {
        &self.cells
    }

    /// The cells around places, in cells from the lower left back corner of the grid. Places beyond it are moved to it.
    #[inline(always)]
    pub fn spots(&self, places: Vector4) -> Spots {
        let Cells {
            columns, rows, layers, ..
        } = self.cells;
        // The cell below, at most the last but one, and the weight of the next.
        let below = |place: f32x4, count: usize| {
            let place = positive_part(place - f32x4::HALF);
            let cell = smaller(place, f32x4::splat(count as f32 - 2.0)).floor();
            (cell, smaller(place - cell, f32x4::ONE))
        };
        let ((i, u), (j, v)) = (below(places.x, columns), below(places.y, rows));
        let (k, w) = match layers {
            1 => (f32x4::ZERO, f32x4::ZERO),
            _ => below(places.z, layers),
        };
        let index = i + f32x4::splat(columns as f32) * (j + f32x4::splat(rows as f32) * k);
        let (bits, _) = cell_and_fraction(index);
        let (before, left) = (f32x4::ONE - v, f32x4::ONE - u);
        Spots {
            cells: bits.to_array().map(|bits| (bits - CELL_ZERO) as usize),
            weights: [left * before, u * before, left * v, u * v],
            layers: w,
        }
    }

    /// Cells from a layer to the next; 0 if there is only one.
    #[inline(always)]
    fn to_next_layer(&self) -> usize {
        match self.cells.layers {
            1 => 0,
            _ => self.cells.columns * self.cells.rows,
        }
    }

    /// Forgets the smoke.
    pub fn clear(&mut self) {
        self.smoke.fill(0.0);
        self.all = f32x4::ZERO;
    }

    /// Adds smoke (particles) at places.
    #[inline(always)]
    pub fn add(&mut self, spots: &Spots, amounts: f32x4) {
        self.all += amounts;
        match self.to_next_layer() {
            0 => self.add_to_layer(spots, amounts, 0),
            to_next => {
                self.add_to_layer(spots, amounts * (f32x4::ONE - spots.layers), 0);
                self.add_to_layer(spots, amounts * spots.layers, to_next);
            }
        }
    }

    #[inline(always)]
    fn add_to_layer(&mut self, spots: &Spots, amounts: f32x4, cells_on: usize) {
        let parts = spots.weights.map(|weights| (weights * amounts).to_array());
        let columns = self.cells.columns;
        let mut add = |lane: usize| {
            let [a, b, c, d] = parts.map(|parts| parts[lane]);
            let mut add = |cell: usize, part: f32, next_part: f32| {
                if let [near, next, ..] = &mut self.smoke[cell..] {
                    *near += part;
                    *next += next_part;
                }
            };
            let cell = spots.cells[lane] + cells_on;
            add(cell, a, b);
            add(cell + columns, c, d);
        };
        // Written out: the compiler does not unroll a loop as long.
        add(0);
        add(1);
        add(2);
        add(3);
    }

    /// The gradients at places.
    #[inline(always)]
    pub fn at(&self, spots: &Spots) -> Vector4 {
        let near = self.in_layer(spots, 0);
        match self.to_next_layer() {
            0 => near,
            to_next => near * (f32x4::ONE - spots.layers) + self.in_layer(spots, to_next) * spots.layers,
        }
    }

    #[inline(always)]
    fn in_layer(&self, spots: &Spots, cells_on: usize) -> Vector4 {
        let row = |cell: usize| match &self.gradient[cell..] {
            [near, next, ..] => [*near, *next],
            _ => [f32x4::ZERO; 2],
        };
        let columns = self.cells.columns;
        let at = |lane: usize| {
            let [a, b, c, d] = spots.weights.map(|weights| f32x4::splat(weights.to_array()[lane]));
            let cell = spots.cells[lane] + cells_on;
            let ([near, right], [above, both]) = (row(cell), row(cell + columns));
            (near * a + right * b) + (above * c + both * d)
        };
        // Written out: the compiler does not unroll a loop as long.
        let [x, y, z, _] = f32x4::transpose([at(0), at(1), at(2), at(3)]);
        Vector4 { x, y, z }
    }

    /// Computes the gradient for the smoke that was added.
    ///
    /// # Arguments
    /// * `thickness` - Thickness of a layer in cells.
    pub fn solve(&mut self, thickness: f32) {
        let all = self.all.to_array().iter().sum::<f32>();
        if all < LEAST_SMOKE {
            self.gradient.fill(f32x4::ZERO);
            return;
        }
        let share = self.cells.mass / all;
        let outside = PULL * self.cells.mass / self.smoke.len() as f32;
        let charges = self.levels[0].charge.iter_mut();
        for ((charge, inside), smoke) in charges.zip(&self.cells.inside).zip(&self.smoke) {
            *charge = inside * (1.0 + PULL) - smoke * share - outside;
        }
        let layers = self.cells.layers;
        for level in 1..LEVELS {
            let (finer, coarser) = self.levels.split_at_mut(level);
            coarser[0].gather(&finer[level - 1], layers);
        }
        let coupling = |level: usize| (1 << (2 * level)) as f32 / (thickness * thickness).max(1.0);
        let coarsest = LEVELS - 1;
        self.levels[coarsest].potential.fill(0.0);
        self.levels[coarsest].relax(layers, coupling(coarsest), COARSE_ROUNDS);
        for level in (0..coarsest).rev() {
            let (finer, coarser) = self.levels.split_at_mut(level + 1);
            finer[level].refine(&coarser[0], layers);
            finer[level].relax(layers, coupling(level), ROUNDS);
        }
        self.differentiate(thickness);
    }

    fn differentiate(&mut self, thickness: f32) {
        let (layers, level) = (self.cells.layers, &self.levels[0]);
        let (width, area) = (level.columns + 2, (level.columns + 2) * (level.rows + 2));
        let potential = &level.potential;
        let mut gradient = self.gradient.as_chunks_mut::<LANES>().0.iter_mut();
        let count = level.columns / LANES;
        let (half, deep) = (f32x4::HALF, f32x4::splat(0.5 / thickness));
        for layer in 0..layers {
            let (back, front) = (layer.saturating_sub(1), (layer + 1).min(layers - 1));
            for row in 1..=level.rows {
                let start = row * width + 1;
                let cells = |start: usize| blocks(&potential[start..], count);
                let (at, to_back, to_front) = (layer * area + start, back * area + start, front * area + start);
                let (left, right) = (cells(at - 1), cells(at + 1));
                let (below, above) = (cells(at - width), cells(at + width));
                let (behind, before) = (cells(to_back), cells(to_front));
                for (at, gradient) in (0..count).zip(&mut gradient) {
                    let difference =
                        |from: &[[f32; LANES]], to: &[[f32; LANES]]| f32x4::new(to[at]) - f32x4::new(from[at]);
                    *gradient = f32x4::transpose([
                        difference(left, right) * half,
                        difference(below, above) * half,
                        difference(behind, before) * deep,
                        f32x4::ZERO,
                    ]);
                }
            }
        }
    }
}

impl Level {
    /// Sums the charges of the four cells within each cell.
    fn gather(&mut self, finer: &Self, layers: usize) {
        let mut charges = self.charge.iter_mut();
        for row in 0..self.rows * layers {
            let below = &finer.charge[2 * row * finer.columns..][..2 * finer.columns];
            let (one, other) = below.split_at(finer.columns);
            for ((one, other), charge) in one
                .as_chunks::<2>()
                .0
                .iter()
                .zip(other.as_chunks::<2>().0)
                .zip(&mut charges)
            {
                *charge = (one[0] + one[1]) + (other[0] + other[1]);
            }
        }
    }

    /// Starts from the potential of the coarser grid, linear between its cells.
    fn refine(&mut self, coarser: &Self, layers: usize) {
        let (width, theirs) = (self.columns + 2, coarser.columns + 2);
        for layer in 0..layers {
            for row in 0..self.rows {
                let near = layer * (coarser.rows + 2) + row / 2 + 1;
                let far = if row % 2 == 0 { near - 1 } else { near + 1 };
                let (near, far) = (&coarser.potential[near * theirs..], &coarser.potential[far * theirs..]);
                let own = &mut self.potential[(layer * (self.rows + 2) + row + 1) * width + 1..][..self.columns];
                let mixed = |at: usize| near[at] * 0.75 + far[at] * 0.25;
                for (pair, own) in own.as_chunks_mut::<2>().0.iter_mut().enumerate() {
                    let [left, middle, right] = [mixed(pair), mixed(pair + 1), mixed(pair + 2)];
                    *own = [middle * 0.75 + left * 0.25, middle * 0.75 + right * 0.25];
                }
            }
        }
        self.close(layers);
    }

    /// Takes rounds of Jacobi's method. `coupling`: weight of the cells in the next layers, relative to those beside a cell.
    fn relax(&mut self, layers: usize, coupling: f32, rounds: usize) {
        let (width, area) = (self.columns + 2, (self.columns + 2) * (self.rows + 2));
        for _ in 0..rounds {
            for layer in 0..layers {
                let (back, front) = (layer.saturating_sub(1), (layer + 1).min(layers - 1));
                let sides = ((layer - back) + (front - layer)) as f32 * coupling;
                let share = DAMPING / (4.0 + sides);
                for row in 0..self.rows {
                    let start = layer * area + (row + 1) * width + 1;
                    let cells = |at: usize| &self.potential[at..][..self.columns];
                    let (here, left, right) = (cells(start), cells(start - 1), cells(start + 1));
                    let (below, above) = (cells(start - width), cells(start + width));
                    let charge = &self.charge[(layer * self.rows + row) * self.columns..][..self.columns];
                    let next = &mut self.next[start..][..self.columns];
                    for at in 0..self.columns {
                        let sum = (left[at] + right[at]) + (below[at] + above[at]);
                        next[at] = here[at] + share * (sum - 4.0 * here[at] + charge[at]);
                    }
                    for other in [back, front] {
                        if other != layer {
                            let others = &self.potential[start - layer * area + other * area..][..self.columns];
                            for at in 0..self.columns {
                                next[at] += share * coupling * (others[at] - here[at]);
                            }
                        }
                    }
                }
            }
            std::mem::swap(&mut self.potential, &mut self.next);
            self.close(layers);
        }
    }

    /// Repeats the cells at the border beyond it: nothing flows through.
    fn close(&mut self, layers: usize) {
        let width = self.columns + 2;
        let height = self.rows + 2;
        for layer in self.potential.chunks_exact_mut(width * height).take(layers) {
            for row in layer.chunks_exact_mut(width) {
                row[0] = row[1];
                row[width - 1] = row[width - 2];
            }
            layer.copy_within(width..2 * width, 0);
            layer.copy_within((height - 2) * width..(height - 1) * width, (height - 1) * width);
        }
    }
}
