//! A grid of covered depths, with two coarser levels of 4 by 4 cells that hold the maximum depth.

use wide::{f32x4, u32x4};

use crate::arrange::coverage::chart::ChartExtent;
use crate::arrange::coverage::disc::{Disc, DiscGroup, Discs};
use crate::arrange::coverage::plan::Plan;
use crate::arrange::coverage::polygon::Polygon;
use crate::math::scalar::greater;

/// Cells along a side of a block; also the number of SIMD lanes.
const BLOCK: usize = 4;
/// Radius of the typical puff in cells.
const FINENESS: f32 = 10.0;
/// Minimum and maximum number of cells, and cells per particle.
const CELLS: [usize; 2] = [1 << 10, 1 << 16];
const CELLS_A_PARTICLE: usize = 64;

/// For each mask the positions of its bits; the rest means nothing.
const POSITIONS: [[u32; BLOCK]; 1 << BLOCK] = positions();
/// Blocks that are tested at a time.
const BATCH: usize = 64;
/// Distance from the middle of a block to its edge, in cells.
const BLOCK_EDGE: f32 = BLOCK as f32 / 2.0;

const NOTHING: f32 = f32::INFINITY;
/// Depth of cells that no puff can show in: everything is hidden there.
const OUTSIDE: f32 = f32::NEG_INFINITY;

/// Dimensions of a level. The stride is a whole number of blocks.
#[derive(Clone, Copy, Debug, Default)]
struct Lattice {
    columns: usize,
    rows: usize,
    stride: usize,
}

/// Depths (m) along the view; infinite where nothing covers.
#[derive(Debug)]
pub(crate) struct CoverageGrid {
    /// The smallest depths, then the second smallest and so on, one layer per cover.
    depths: Vec<f32>,
    fine: Lattice,
    blocks: Vec<f32>,
    coarse: Lattice,
    /// Maxima of 4 by 4 blocks.
    fields: Vec<f32>,
    coarsest: Lattice,
    /// The blocks in which the hull may show that was tested last: column, and row in the upper half; and their number.
    open: Vec<u32>,
    open_count: usize,
    covers: usize,
    /// Limits of the grid beyond which puffs may show: left, low, right, high, in cells.
    ends: [f32; 4],
    /// Chart coordinates of the corner, and cells per unit of the chart.
    pub corner: [f32; 2],
    pub density: f32,
    /// Drawing clamps depths to this range.
    range: [f32x4; 2],
}

impl CoverageGrid {
    pub(crate) fn new(capacity: usize) -> Self {
        let cells = (capacity * CELLS_A_PARTICLE).clamp(CELLS[0], CELLS[1]);
        Self {
            depths: vec![NOTHING; cells],
            fine: Lattice::default(),
            // A row of blocks may be padded by three.
            blocks: vec![NOTHING; cells / 4 + BLOCK],
            coarse: Lattice::default(),
            fields: vec![NOTHING; cells / 16 + BLOCK],
            coarsest: Lattice::default(),
            open: vec![0; cells / 4 + BLOCK],
            open_count: 0,
            covers: 1,
            ends: [0.0; 4],
            corner: [0.0; 2],
            density: 1.0,
            range: [f32x4::ZERO; 2],
        }
    }

    /// Resets the grid to the extent of all puffs. The typical size and the capacity determine its resolution.
    pub(crate) fn reset(&mut self, plan: &Plan, extent: &ChartExtent) {
        let [left, low, right, high] = extent.box_within(&plan.chart.limits, plan.margin());
        let (width, height) = ((right - left).max(1e-6), (high - low).max(1e-6));
        let room = (self.depths.len() / plan.covers) as f32;
        let mut cell = (extent.typical() / FINENESS).max((width * height / room).sqrt());
        let fits = |cell: f32| {
            let across = |length: f32| (length / cell) as usize / BLOCK * BLOCK + 2 * BLOCK;
            across(width).saturating_mul(across(height)) <= room as usize
        };
        while !fits(cell) && cell < width + height {
            cell *= 1.05;
        }
        (self.corner, self.density, self.covers) = ([left, low], 1.0 / cell, plan.covers);
        self.range = plan.range.map(f32x4::splat);
        self.clear((width / cell) as usize + 1, (height / cell) as usize + 1);
        // Beyond a limit of the view nothing shows.
        let limits = plan.chart.limits;
        let end = |at: f32, limit: f32, cells: f32, beyond: f32| if at == limit { beyond } else { cells };
        self.ends = [
            end(left, limits[0], 0.0, f32::NEG_INFINITY),
            end(low, limits[1], 0.0, f32::NEG_INFINITY),
            end(right, limits[2], self.fine.columns as f32, f32::INFINITY),
            end(high, limits[3], self.fine.rows as f32, f32::INFINITY),
        ];
    }

    fn clear(&mut self, columns: usize, rows: usize) {
        let lattice = |columns: usize, rows: usize| Lattice {
            columns,
            rows,
            stride: columns.next_multiple_of(BLOCK),
        };
        self.fine = lattice(columns, rows);
        self.coarse = lattice(columns.div_ceil(BLOCK), rows.div_ceil(BLOCK));
        let padded = self.fine.stride * rows.next_multiple_of(BLOCK);
        self.depths[..padded * self.covers].fill(OUTSIDE);
        for layer in self.depths.chunks_exact_mut(padded).take(self.covers) {
            for row in layer.chunks_exact_mut(self.fine.stride).take(rows) {
                row[..columns].fill(NOTHING);
            }
        }
        self.coarsest = lattice(self.coarse.columns.div_ceil(BLOCK), self.coarse.rows.div_ceil(BLOCK));
        for (level, depths) in [(&self.coarse, &mut self.blocks), (&self.coarsest, &mut self.fields)] {
            let depths = &mut depths[..level.stride * level.rows];
            depths.fill(OUTSIDE);
            for row in depths.chunks_exact_mut(level.stride) {
                row[..level.columns].fill(NOTHING);
            }
        }
    }

    /// Empties the grid.
    pub(crate) fn empty(&mut self) {
        self.fine = Lattice::default();
    }

    /// Columns, rows and stride; chart coordinates of the corner, and cells per unit.
    pub(crate) fn shape(&self) -> [f32; 6] {
        let Lattice { columns, rows, stride } = self.fine;
        let [left, low] = self.corner;
        [columns as f32, rows as f32, stride as f32, left, low, self.density]
    }

    /// The smallest covered depth of each cell, row by row.
    pub(crate) fn depths(&self) -> &[f32] {
        &self.depths[..self.fine.stride * self.fine.rows]
    }

    /// Number of cells per layer.
    fn layer(&self) -> usize {
        self.fine.stride * self.fine.rows.next_multiple_of(BLOCK)
    }

    /// Returns true if the whole hull of a puff is covered. Finds the blocks in which it may show, for the calls that
    /// follow for the same puff.
    pub(crate) fn hides_hull(&mut self, hull: &Disc) -> bool {
        self.open_count = 0;
        let (fields, blocks) = (hull.on_coarser((BLOCK * BLOCK) as f32), hull.on_coarser(BLOCK as f32));
        let [left, low, right, high] = self.coarsest.around(&fields);
        for row in low..high {
            let beside = nearest_squared(row, fields.v);
            for column in (left..right).step_by(BLOCK) {
                let depths = load(&self.fields, row * self.coarsest.stride + column);
                let mask = fields.shows(nearest(&fields, column, beside), depths);
                // The last lanes may lie in the next row.
                for lane in lanes(mask).take_while(|lane| column + lane < right) {
                    self.open_blocks(&blocks, column + lane, row);
                }
            }
        }
        self.open_count == 0 && !self.is_left_by(hull)
    }

    /// Finds the blocks of a field in which a hull may show; its lengths are in blocks.
    #[inline(always)]
    fn open_blocks(&mut self, hull: &Disc, column: usize, row: usize) {
        let column = column * BLOCK;
        for row in row * BLOCK..((row + 1) * BLOCK).min(self.coarse.rows) {
            let squared = nearest(hull, column, nearest_squared(row, hull.v));
            let mask = hull.shows(squared, load(&self.blocks, row * self.coarse.stride + column));
            // Without a branch for each block: of four numbers, as many count as there are bits.
            let found = u32x4::splat((row << 16 | column) as u32) + u32x4::new(POSITIONS[mask as usize]);
            self.open[self.open_count..self.open_count + BLOCK].copy_from_slice(found.as_array());
            self.open_count += mask.count_ones() as usize;
        }
    }

    /// Returns true if the whole polygon is covered.
    pub(crate) fn hides_polygon(&self, polygon: &Polygon) -> bool {
        self.farthest(polygon, polygon.depth, polygon.depth) < polygon.depth
    }

    /// Maximum depth of the cells that the polygon touches, or the first depth of at least `enough`. Infinite if a cell
    /// is not covered. Below `least` it may be any smaller depth.
    pub(crate) fn farthest(&self, polygon: &Polygon, least: f32, enough: f32) -> f32 {
        let [left, low, right, high] = polygon.bounds();
        let [first, lowest, last, highest] = self.ends;
        if left < first || low < lowest || right > last || high > highest {
            return NOTHING;
        }
        let depths = &self.depths[(self.covers - 1) * self.layer()..];
        let (from, to) = (cell_at(low), (cell_at(high) + 1).min(self.fine.rows));
        let mut farthest = OUTSIDE;
        for block in from / BLOCK..to.div_ceil(BLOCK) {
            let first = block * BLOCK;
            let limits = polygon
                .between(first as f32, (first + BLOCK) as f32)
                .map(|at| at / BLOCK as f32);
            if self.coarse.farthest(&self.blocks, block, limits) < greater(farthest, least) {
                continue;
            }
            for row in first.max(from)..(first + BLOCK).min(to) {
                let limits = polygon.between(row as f32, (row + 1) as f32);
                farthest = greater(self.fine.farthest(depths, row, limits), farthest);
                if farthest >= enough {
                    return farthest;
                }
            }
        }
        farthest
    }

    /// Returns true if all discs of the puff are covered whose hull was tested last.
    pub(crate) fn hides(&self, discs: &Discs) -> bool {
        let last = &self.depths[(self.covers - 1) * self.layer()..];
        !discs.groups().iter().any(|group| self.is_left_by_any(group))
            && !(0..discs.count).any(|index| {
                let group = discs.groups[index];
                self.open[..self.open_count].iter().any(|block| {
                    let (column, row) = column_and_row(*block);
                    let squared = nearest_of(&group, column, row, BLOCK_EDGE, 0.0);
                    let depth = f32x4::splat(self.blocks[row * self.coarse.stride + column]);
                    lanes(group.shows(discs.bulge, squared, depth))
                        .any(|lane| self.shows_in_block(last, &discs.get(index * BLOCK + lane), column, row))
                })
            })
    }

    fn is_left_by_any(&self, group: &DiscGroup) -> bool {
        let [left, low, right, high] = self.ends.map(f32x4::splat);
        let beyond = |at: f32x4, from: f32x4, to: f32x4| (at - group.rim).simd_lt(from) | (at + group.rim).simd_gt(to);
        let is_left = beyond(group.u, left, right) | beyond(group.v, low, high);
        (is_left & group.rim.simd_gt(f32x4::ZERO)).any()
    }

    #[inline(always)]
    fn shows_in_block(&self, depths: &[f32], disc: &Disc, column: usize, row: usize) -> bool {
        let at = row * BLOCK * self.fine.stride + column * BLOCK;
        (0..BLOCK).any(|line| {
            let beside = nearest_squared(row * BLOCK + line, disc.v);
            let cells = load(depths, at + line * self.fine.stride);
            shown(disc, nearest(disc, column * BLOCK, beside), cells) != 0
        })
    }

    /// Returns true if part of the disc lies outside of the grid.
    fn is_left_by(&self, disc: &Disc) -> bool {
        let [left, low, right, high] = self.ends;
        let beyond = |at: f32, from: f32, to: f32| at - disc.rim < from || at + disc.rim > to;
        beyond(disc.u, left, right) || beyond(disc.v, low, high)
    }

    /// Adds the covered area of the puff whose hull was tested last. With several covers it must be a single disc.
    pub(crate) fn cover(&mut self, discs: &Discs) {
        let mut changed = [usize::MAX, usize::MAX, 0, 0];
        for from in (0..self.open_count).step_by(BATCH) {
            let mut batch = [0; BATCH];
            let count = (self.open_count - from).min(BATCH);
            let batch = &mut batch[..count];
            batch.copy_from_slice(&self.open[from..from + count]);
            let mut masks = [0; BATCH];
            for (index, group) in discs.groups().iter().enumerate() {
                let group = *group;
                for (block, mask) in batch.iter().zip(&mut masks) {
                    let (column, row) = column_and_row(*block);
                    // Only what covers a whole cell counts.
                    let squared = nearest_of(&group, column, row, BLOCK_EDGE - 1.0, 0.5);
                    let depth = f32x4::splat(self.blocks[row * self.coarse.stride + column]);
                    *mask |= group.covers(discs.bulge, squared, depth) << (index * BLOCK);
                }
            }
            for (block, mask) in batch.iter().zip(masks) {
                if mask != 0 {
                    let (column, row) = column_and_row(*block);
                    self.blocks[row * self.coarse.stride + column] = self.mark(discs, mask, column, row);
                    changed = [
                        changed[0].min(column),
                        changed[1].min(row),
                        changed[2].max(column),
                        changed[3].max(row),
                    ];
                }
            }
        }
        self.gather_fields(changed);
    }

    /// Adds the parts in a block of the discs in `mask`. Returns the new maximum depth of the last cover.
    #[inline(always)]
    fn mark(&mut self, discs: &Discs, mask: u32, column: usize, row: usize) -> f32 {
        let [mut first, mut second, mut third, mut fourth] = [f32x4::splat(NOTHING); BLOCK];
        for number in lanes(mask) {
            let disc = discs.get(number);
            let squared = |start: usize, at: f32| {
                let away = (middles(start) - f32x4::splat(at)).abs() + f32x4::splat(0.5);
                away * away
            };
            let along = away(&disc, column * BLOCK) + f32x4::splat(0.5);
            let along = along * along;
            let [a, b, c, d] = squared(row * BLOCK, disc.v).to_array();
            first = first.fast_min(certain(&disc, along, a, &self.range));
            second = second.fast_min(certain(&disc, along, b, &self.range));
            third = third.fast_min(certain(&disc, along, c, &self.range));
            fourth = fourth.fast_min(certain(&disc, along, d, &self.range));
        }
        let layer = self.layer();
        let mut farthest = f32x4::splat(OUTSIDE);
        for (line, mut depth) in [first, second, third, fourth].into_iter().enumerate() {
            for cover in 0..self.covers {
                let at = cover * layer + (row * BLOCK + line) * self.fine.stride + column * BLOCK;
                let cells = load(&self.depths, at);
                let least = cells.fast_min(depth);
                self.depths[at..at + BLOCK].copy_from_slice(least.as_array());
                depth = cells.fast_max(depth);
                if cover + 1 == self.covers {
                    farthest = farthest.fast_max(least);
                }
            }
        }
        greatest(farthest)
    }

    /// Updates the fields around a range of blocks: left, low, right, high, ends included.
    fn gather_fields(&mut self, [left, low, right, high]: [usize; 4]) {
        for row in low / BLOCK..high / BLOCK + 1 {
            for column in left / BLOCK..right / BLOCK + 1 {
                let lines = row * BLOCK..((row + 1) * BLOCK).min(self.coarse.rows);
                let farthest = lines.fold(f32x4::splat(OUTSIDE), |farthest, line| {
                    farthest.fast_max(load(&self.blocks, line * self.coarse.stride + column * BLOCK))
                });
                self.fields[row * self.coarsest.stride + column] = greatest(farthest);
            }
        }
    }
}

impl Lattice {
    /// The cells that the square around a disc touches: left, low, right, high, ends excluded.
    #[inline(always)]
    fn around(&self, disc: &Disc) -> [usize; 4] {
        let to = |at: f32, limit: usize| cell_at(at + disc.rim + 1.0).min(limit);
        let (right, high) = (to(disc.u, self.columns), to(disc.v, self.rows));
        let from = |at: f32, limit: usize| cell_at(at - disc.rim).min(limit);
        [from(disc.u, right), from(disc.v, high), right, high]
    }

    /// Maximum depth of a row's cells between two positions.
    #[inline(always)]
    fn farthest(&self, depths: &[f32], row: usize, [left, right]: [f32; 2]) -> f32 {
        let (from, to) = (cell_at(left), (cell_at(right) + 1).min(self.columns));
        let line = &depths[row * self.stride..(row + 1) * self.stride];
        let [first, last] = [from, to].map(|cell| f32x4::splat(cell as f32));
        let mut farthest = f32x4::splat(OUTSIDE);
        for column in (from / BLOCK * BLOCK..to).step_by(BLOCK) {
            let at = f32x4::new([0.0, 1.0, 2.0, 3.0]) + f32x4::splat(column as f32);
            let touched = at.simd_ge(first) & at.simd_lt(last);
            farthest = farthest.fast_max(touched.select(load(line, column), f32x4::splat(OUTSIDE)));
        }
        greatest(farthest)
    }
}

const fn positions() -> [[u32; BLOCK]; 1 << BLOCK] {
    let mut all = [[0; BLOCK]; 1 << BLOCK];
    let mut mask = 0;
    while mask < all.len() {
        let (mut lane, mut count) = (0, 0);
        while lane < BLOCK {
            if mask >> lane & 1 == 1 {
                all[mask][count] = lane as u32;
                count += 1;
            }
            lane += 1;
        }
        mask += 1;
    }
    all
}

/// The cell at a position; the first one left of or below the grid.
#[inline(always)]
fn cell_at(position: f32) -> usize {
    position as u32 as usize
}

/// The positions of the bits of a mask.
#[inline(always)]
fn lanes(mut mask: u32) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        let lane = mask.trailing_zeros();
        mask &= mask.wrapping_sub(1);
        (lane < u32::BITS).then_some(lane as usize)
    })
}

#[inline(always)]
fn greatest(lanes: f32x4) -> f32 {
    let [a, b, c, d] = lanes.to_array();
    greater(greater(a, b), greater(c, d))
}

/// Squared distance from a position to the nearest point of a row.
#[inline(always)]
fn nearest_squared(row: usize, position: f32) -> f32 {
    let beside = greater((row as f32 + 0.5 - position).abs() - 0.5, 0.0);
    beside * beside
}

/// Squared distances from the centre of the disc to the nearest points of four cells in a row.
#[inline(always)]
fn nearest(disc: &Disc, column: usize, beside: f32) -> f32x4 {
    let along = (away(disc, column) - f32x4::splat(0.5)).fast_max(f32x4::ZERO);
    along * along + f32x4::splat(beside)
}

/// Squared distances from the centres of discs to the nearest points of a block, at most `edge` away from its middle in
/// each direction and at least `least` away from the centre.
#[inline(always)]
fn nearest_of(group: &DiscGroup, column: usize, row: usize, edge: f32, least: f32) -> f32x4 {
    let away = |at: f32x4, block: usize| {
        let middle = (block * BLOCK) as f32 + BLOCK_EDGE;
        let away = (f32x4::splat(middle) - at).abs() - f32x4::splat(edge);
        away.fast_max(f32x4::splat(least))
    };
    let (along, beside) = (away(group.u, column), away(group.v, row));
    along * along + beside * beside
}

/// A mask of the cells, of four at these squared distances, that the disc touches and where it is not behind the depth.
/// Depths of cells are infinite or in the range of drawn depths, so clamping the disc to this range changes nothing.
#[inline(always)]
fn shown(disc: &Disc, squared: f32x4, cells: f32x4) -> u32 {
    let touched = squared.simd_lt(f32x4::splat(disc.rim * disc.rim));
    let front = disc.front(squared).fast_min(f32x4::splat(disc.rim_depth));
    (touched & cells.simd_ge(front)).to_bitmask()
}

/// Maximum depth of the disc in each of four cells, by the squared distances of their farthest corners along and beside
/// the row; infinite unless it covers the whole cell.
#[inline(always)]
fn certain(disc: &Disc, along: f32x4, beside: f32, range: &[f32x4; 2]) -> f32x4 {
    let squared = along + f32x4::splat(beside);
    let depth = disc.front(squared).fast_max(range[0]);
    let covers = squared.simd_lt(f32x4::splat(disc.radius * disc.radius)) & depth.simd_lt(range[1]);
    covers.select(depth, f32x4::splat(NOTHING))
}

/// Middles of four cells in a row or column from `start` on.
#[inline(always)]
fn middles(start: usize) -> f32x4 {
    f32x4::new([0.5, 1.5, 2.5, 3.5]) + f32x4::splat(start as f32)
}

/// Column and row of a block in a list.
#[inline(always)]
fn column_and_row(block: u32) -> (usize, usize) {
    ((block & 0xffff) as usize, (block >> 16) as usize)
}

/// Distance in cells from the centre of the disc to those of four cells in a row.
#[inline(always)]
fn away(disc: &Disc, column: usize) -> f32x4 {
    (f32x4::new([0.5, 1.5, 2.5, 3.5]) + f32x4::splat(column as f32 - disc.u)).abs()
}

#[inline(always)]
fn load(depths: &[f32], at: usize) -> f32x4 {
    let lanes: &[f32; BLOCK] = depths[at..at + BLOCK].try_into().expect("four cells");
    f32x4::new(*lanes)
}
