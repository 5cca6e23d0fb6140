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
    /// Smoke in each cell, and its sum (particles).
    smoke: Vec<f32>,
    all: f32,
    levels: Vec<Level>,
    /// Gradient of the potential in each cell along x, y and z, per cell.
    gradient: Vec<f32x4>,
}

/// A place within the grid: its cell below, and the weights of it and the next ones along x, y and z.
#[derive(Clone, Copy)]
pub struct Spot {
    cell: usize,
    to_next_layer: usize,
    weights: [f32; 4],
    layer: f32,
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
            all: 0.0,
            levels: (0..LEVELS).map(level).collect(),
            gradient: vec![f32x4::ZERO; cells.inside.len()],
            cells,
        }
    }

    /// The grid.
    pub fn cells(&self) -> &Cells {
        &self.cells
    }

    /// The cells around a place within the grid, in cells from its lower left back corner.
    #[inline(always)]
    pub fn spot(&self, [x, y, z]: [f32; 3]) -> Spot {
        let Cells {
            columns, rows, layers, ..
        } = self.cells;
        let below = |place: f32, count: usize| {
            let place = (place - 0.5).max(0.0).min((count - 1) as f32);
            let cell = (place as usize).min(count.max(2) - 2);
            (cell, place - cell as f32)
        };
        let ((i, u), (j, v), (k, w)) = (below(x, columns), below(y, rows), below(z, layers));
        Spot {
            cell: i + columns * (j + rows * k),
            to_next_layer: if layers > 1 { columns * rows } else { 0 },
            weights: [(1.0 - u) * (1.0 - v), u * (1.0 - v), (1.0 - u) * v, u * v],
            layer: w,
        }
    }

    /// Forgets the smoke.
    pub fn clear(&mut self) {
        self.smoke.fill(0.0);
        self.all = 0.0;
    }

    /// Adds smoke (particles) at a place.
    #[inline(always)]
    pub fn add(&mut self, spot: &Spot, amount: f32) {
        self.all += amount;
        let columns = self.cells.columns;
        let mut add = |cell: usize, amount: f32| {
            let [a, b, c, d] = spot.weights;
            self.smoke[cell] += amount * a;
            self.smoke[cell + 1] += amount * b;
            self.smoke[cell + columns] += amount * c;
            self.smoke[cell + columns + 1] += amount * d;
        };
        if spot.to_next_layer == 0 {
            add(spot.cell, amount);
        } else {
            add(spot.cell, amount * (1.0 - spot.layer));
            add(spot.cell + spot.to_next_layer, amount * spot.layer);
        }
    }

    /// The gradient at a place.
    #[inline(always)]
    pub fn at(&self, spot: &Spot) -> f32x4 {
        let columns = self.cells.columns;
        let [a, b, c, d] = spot.weights.map(f32x4::splat);
        let of = |cell: usize| {
            let near = &self.gradient[cell..];
            near[0] * a + near[1] * b + near[columns] * c + near[columns + 1] * d
        };
        if spot.to_next_layer == 0 {
            return of(spot.cell);
        }
        let far = f32x4::splat(spot.layer);
        of(spot.cell) * (f32x4::ONE - far) + of(spot.cell + spot.to_next_layer) * far
    }

    /// Computes the gradient for the smoke that was added.
    ///
    /// # Arguments
    /// * `thickness` - Thickness of a layer in cells.
    pub fn solve(&mut self, thickness: f32) {
        if self.all < LEAST_SMOKE {
            self.gradient.fill(f32x4::ZERO);
            return;
        }
        let share = self.cells.mass / self.all;
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
        let mut gradient = self.gradient.iter_mut();
        for layer in 0..layers {
            let (back, front) = (layer.saturating_sub(1), (layer + 1).min(layers - 1));
            for row in 1..=level.rows {
                let start = layer * area + row * width + 1;
                for (at, gradient) in (start..start + level.columns).zip(&mut gradient) {
                    let x = (potential[at + 1] - potential[at - 1]) * 0.5;
                    let y = (potential[at + width] - potential[at - width]) * 0.5;
                    let z = potential[at + (front - layer) * area] - potential[at - (layer - back) * area];
                    *gradient = f32x4::new([x, y, z / (2.0 * thickness), 0.0]);
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
