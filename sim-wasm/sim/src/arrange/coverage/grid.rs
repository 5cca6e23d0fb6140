//! A grid of covered depths, with two coarser levels of 4 by 4 cells that hold the maximum depth.

use wide::f32x4;

use crate::arrange::coverage::chart::ChartExtent;
use crate::arrange::coverage::disc::Disc;
use crate::arrange::coverage::plan::Plan;
use crate::arrange::coverage::polygon::Polygon;

/// Cells along a side of a block; also the number of SIMD lanes.
const BLOCK: usize = 4;
/// Radius of the typical puff in cells.
const FINENESS: f32 = 10.0;
/// Minimum and maximum number of cells, and cells per particle.
const CELLS: [usize; 2] = [1 << 10, 1 << 16];
const CELLS_A_PARTICLE: usize = 64;

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
        let blocks = &mut self.blocks[..self.coarse.stride * self.coarse.rows];
        blocks.fill(OUTSIDE);
        for row in blocks.chunks_exact_mut(self.coarse.stride) {
            row[..self.coarse.columns].fill(NOTHING);
        }
        let fields = self.coarse.columns.div_ceil(BLOCK);
        self.coarsest = Lattice {
            columns: fields,
            rows: self.coarse.rows.div_ceil(BLOCK),
            stride: fields,
        };
        self.fields[..fields * self.coarsest.rows].fill(NOTHING);
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

    /// Returns true if the nearest point of the disc lies behind all fields it touches, or each part behind its block.
    pub(crate) fn hides_hull(&self, disc: &Disc) -> bool {
        if self.is_left_by(disc) {
            return false;
        }
        let nearest = disc.depth - disc.bulge * disc.radius;
        let [least, most] = self.range.map(|lanes| lanes.to_array()[0]);
        let nearest = nearest.max(least).min(most);
        let field = (BLOCK * BLOCK) as f32;
        let from = |at: f32| ((at - disc.rim) / field).max(0.0) as u32 as usize;
        let to = |at: f32, limit: usize| (((at + disc.rim) / field + 1.0).max(0.0) as u32 as usize).min(limit);
        let (right, high) = (to(disc.u, self.coarsest.columns), to(disc.v, self.coarsest.rows));
        let is_behind = (from(disc.v)..high).all(|row| {
            let line = &self.fields[row * self.coarsest.stride..][..self.coarsest.stride];
            (from(disc.u)..right).all(|column| line[column] < nearest)
        });
        is_behind || self.hides_block_by_block(disc)
    }

    /// Returns true if the whole polygon is covered.
    pub(crate) fn hides_polygon(&self, polygon: &Polygon) -> bool {
        self.farthest(polygon, polygon.depth) < polygon.depth
    }

    /// Maximum depth of the cells that the polygon touches, or the first depth of at least `enough`. Infinite if a cell
    /// is not covered.
    pub(crate) fn farthest(&self, polygon: &Polygon, enough: f32) -> f32 {
        let [left, low, right, high] = polygon.bounds();
        let [first, lowest, last, highest] = self.ends;
        if left < first || low < lowest || right > last || high > highest {
            return NOTHING;
        }
        let depths = &self.depths[(self.covers - 1) * self.layer()..];
        let mut farthest = OUTSIDE;
        for row in low.max(0.0) as usize..((high + 1.0) as usize).min(self.fine.rows) {
            let [left, right] = polygon.between(row as f32, (row + 1) as f32);
            farthest = self.fine.farthest(depths, row, [left, right]).max(farthest);
            if farthest >= enough {
                break;
            }
        }
        farthest
    }

    /// Returns true if the whole disc lies behind the maximum depth of each block that it touches.
    pub(crate) fn hides_block_by_block(&self, disc: &Disc) -> bool {
        if self.is_left_by(disc) {
            return false;
        }
        let disc = disc.on_coarser(BLOCK as f32);
        self.coarse.is_behind(&self.blocks, &disc, &self.range)
    }

    /// Returns true if the whole disc is covered.
    pub(crate) fn hides(&self, disc: &Disc) -> bool {
        let last = &self.depths[(self.covers - 1) * self.layer()..];
        self.hides_block_by_block(disc) || !self.is_left_by(disc) && self.fine.is_behind(last, disc, &self.range)
    }

    /// Returns true if part of the disc lies outside of the grid.
    fn is_left_by(&self, disc: &Disc) -> bool {
        let [left, low, right, high] = self.ends;
        let beyond = |at: f32, from: f32, to: f32| at - disc.rim < from || at + disc.rim > to;
        beyond(disc.u, left, right) || beyond(disc.v, low, high)
    }

    /// Adds the covered area of one puff. With several covers it must be a single disc.
    pub(crate) fn cover(&mut self, discs: &[Disc]) {
        debug_assert!(self.covers == 1 || discs.len() <= 1, "a puff would count twice");
        let layer = self.layer();
        let Some(mut touched) = discs.first().map(|disc| self.fine.around(disc, disc.radius)) else {
            return;
        };
        for disc in discs {
            self.fine.mark(&mut self.depths, layer, self.covers, disc, &self.range);
            let within = self.fine.around(disc, disc.radius);
            touched = [
                touched[0].min(within[0]),
                touched[1].min(within[1]),
                touched[2].max(within[2]),
                touched[3].max(within[3]),
            ];
        }
        self.gather(touched, (self.covers - 1) * layer);
    }

    /// Updates the blocks for a range of cells: left, low, right, high, ends excluded.
    fn gather(&mut self, [left, low, right, high]: [usize; 4], first: usize) {
        for row in low / BLOCK..high.div_ceil(BLOCK) {
            for column in left / BLOCK..right.div_ceil(BLOCK) {
                let corner = first + row * BLOCK * self.fine.stride + column * BLOCK;
                let mut farthest = load(&self.depths, corner);
                for line in 1..BLOCK {
                    farthest = farthest.fast_max(load(&self.depths, corner + line * self.fine.stride));
                }
                let [a, b, c, d] = farthest.to_array();
                self.blocks[row * self.coarse.stride + column] = a.max(b).max(c.max(d));
            }
        }
        self.gather_fields([left, low, right, high].map(|cell| cell / BLOCK));
    }

    /// Updates the fields around a range of blocks, ends included.
    fn gather_fields(&mut self, [left, low, right, high]: [usize; 4]) {
        let last = |block: usize, limit: usize| (block / BLOCK + 1).min(limit);
        for row in low / BLOCK..last(high, self.coarsest.rows) {
            for column in left / BLOCK..last(right, self.coarsest.columns) {
                let lines = (row * BLOCK..(row + 1) * BLOCK).take_while(|line| *line < self.coarse.rows);
                let farthest = lines.fold(f32x4::splat(OUTSIDE), |farthest, line| {
                    farthest.fast_max(load(&self.blocks, line * self.coarse.stride + column * BLOCK))
                });
                self.fields[row * self.coarsest.stride + column] =
                    farthest.to_array().into_iter().fold(OUTSIDE, f32::max);
            }
        }
    }
}

impl Lattice {
    /// The cells that a square touches: left, low, right, high, ends excluded; columns in whole blocks.
    #[inline(always)]
    fn around(&self, disc: &Disc, reach: f32) -> [usize; 4] {
        let from = |at: f32| (at - reach).max(0.0) as u32 as usize;
        let to = |at: f32, limit: usize| ((at + reach + 1.0).max(0.0) as u32 as usize).min(limit);
        let (right, high) = (to(disc.u, self.columns), to(disc.v, self.rows));
        [from(disc.u) / BLOCK * BLOCK, from(disc.v), right, high]
    }

    /// Maximum depth of a row's cells between two positions.
    #[inline(always)]
    fn farthest(&self, depths: &[f32], row: usize, [left, right]: [f32; 2]) -> f32 {
        let (from, to) = (
            left.max(0.0) as u32 as usize,
            (right.max(0.0) as u32 as usize + 1).min(self.columns),
        );
        let line = &depths[row * self.stride..(row + 1) * self.stride];
        let mut farthest = f32x4::splat(OUTSIDE);
        for column in (from / BLOCK * BLOCK..to).step_by(BLOCK) {
            let at = f32x4::new([0.0, 1.0, 2.0, 3.0]) + f32x4::splat(column as f32);
            let touched = at.simd_ge(f32x4::splat(from as f32)) & at.simd_lt(f32x4::splat(to as f32));
            farthest = farthest.fast_max(touched.select(load(line, column), f32x4::splat(OUTSIDE)));
        }
        farthest.to_array().into_iter().fold(OUTSIDE, f32::max)
    }

    #[inline(always)]
    fn is_behind(&self, depths: &[f32], disc: &Disc, range: &[f32x4; 2]) -> bool {
        let [left, low, right, high] = self.around(disc, disc.rim);
        let rim_squared = disc.rim * disc.rim;
        for row in low..high {
            let beside = ((row as f32 + 0.5 - disc.v).abs() - 0.5).max(0.0);
            let beside = beside * beside;
            if beside >= rim_squared {
                continue;
            }
            let line = &depths[row * self.stride..(row + 1) * self.stride];
            for column in (left..right).step_by(BLOCK) {
                if shows(disc, column, beside, load(line, column), range) {
                    return false;
                }
            }
        }
        true
    }

    #[inline(always)]
    fn mark(&self, depths: &mut [f32], layer: usize, covers: usize, disc: &Disc, range: &[f32x4; 2]) {
        let [left, low, right, high] = self.around(disc, disc.radius);
        for row in low..high {
            let beside = (row as f32 + 0.5 - disc.v).abs() + 0.5;
            let beside = beside * beside;
            if beside >= disc.radius * disc.radius {
                continue;
            }
            for column in (left..right).step_by(BLOCK) {
                let mut depth = certain(disc, column, beside, range);
                for cover in 0..covers {
                    if depth.simd_eq(f32x4::splat(NOTHING)).all() {
                        break;
                    }
                    let at = cover * layer + row * self.stride + column;
                    let cells = load(depths, at);
                    depths[at..at + BLOCK].copy_from_slice(cells.fast_min(depth).as_array());
                    depth = cells.fast_max(depth);
                }
            }
        }
    }
}

/// Returns true if the disc is nearer than the depth of a touched cell, of four in a row.
#[inline(always)]
fn shows(disc: &Disc, column: usize, beside: f32, cells: f32x4, range: &[f32x4; 2]) -> bool {
    let along = (away(disc, column) - f32x4::splat(0.5)).fast_max(f32x4::ZERO);
    let squared = along * along + f32x4::splat(beside);
    let touched = squared.simd_lt(f32x4::splat(disc.rim * disc.rim));
    let front = disc.front(squared).fast_min(f32x4::splat(disc.rim_depth));
    let drawn = front.fast_max(range[0]).fast_min(range[1]);
    (touched & !cells.simd_lt(drawn)).any()
}

/// Maximum depth of the disc in each of four cells in a row; infinite unless it covers the whole cell.
#[inline(always)]
fn certain(disc: &Disc, column: usize, beside: f32, range: &[f32x4; 2]) -> f32x4 {
    let along = away(disc, column) + f32x4::splat(0.5);
    let squared = along * along + f32x4::splat(beside);
    let depth = disc.front(squared).fast_max(range[0]);
    let covers = squared.simd_lt(f32x4::splat(disc.radius * disc.radius)) & depth.simd_lt(range[1]);
    covers.select(depth, f32x4::splat(NOTHING))
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
