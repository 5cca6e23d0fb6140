//! A uniform grid to find nearby rigids. It is rebuilt in each step over the intersection of rigids and particles.
//!
//! A rigid is entered in each cell that its box, widened by a margin, touches. A particle no larger than the margin
//! finds all nearby rigids in the cell of its centre. Rigids that would fill many cells go to a separate list.
//! Particles larger than the margin, or outside of the grid, test all rigids. The result does not depend on the grid.

use wide::{f32x4, i32x4};

use crate::collide::broad_phase::{GridLocation, NearLanes, ParticleExtent, SweptBoxes};
use crate::math::bounds::{Bounds, WideBounds};
use crate::math::simd::LANES;
use crate::math::vector::Vector;

const CELLS_PER_RIGID: usize = 64;
const MIN_CELLS: usize = 512;
const MAX_CELLS: usize = 32_768;
/// Maximum number of cells per rigid. Larger rigids are tested by every particle.
const MAX_CELLS_PER_RIGID: usize = 512;
const MAX_CELLS_PER_AXIS: f32 = 128.0;

/// The grid of one step.
#[derive(Debug, Default)]
pub struct RigidGrid {
    boxes: Vec<Bounds>,
    /// The same boxes in SIMD registers.
    wide: Vec<WideBounds>,
    margin: f32,
    /// Minimum corner and maximum corner (m).
    origin: Vector,
    end: Vector,
    cells_per_metre: [f32; 3],
    size: [usize; 3],
    /// First entry of each cell, then the number of entries.
    starts: Vec<u32>,
    entries: Vec<u16>,
    large: Vec<u16>,
}

/// Cells from..to along each axis.
struct CellRange {
    from: [usize; 3],
    to: [usize; 3],
}

impl CellRange {
    fn count(&self) -> usize {
        (0..3).map(|axis| self.to[axis] - self.from[axis]).product()
    }
}

impl RigidGrid {
    /// Reserves memory for one more rigid, so that rebuilding never allocates.
    pub fn add(&mut self, bounds: Bounds) {
        self.boxes.push(bounds);
        self.wide.push(WideBounds::from(&bounds));
        let count = self.boxes.len();
        self.starts
            .reserve((cell_limit(count) + 2).saturating_sub(self.starts.len()));
        self.entries
            .reserve((count * MAX_CELLS_PER_RIGID).saturating_sub(self.entries.len()));
        self.large.reserve(count.saturating_sub(self.large.len()));
    }

    /// Sets the box of a rigid during the coming step.
    pub fn place(&mut self, index: usize, bounds: Bounds) {
        self.boxes[index] = bounds;
        self.wide[index] = WideBounds::from(&bounds);
    }

    /// The box of all rigids.
    pub fn bounds(&self) -> Bounds {
        self.boxes.iter().fold(Bounds::NOTHING, |all, one| all.with(one))
    }

    /// Rebuilds the grid over the region in which most particles may be near a rigid.
    pub fn rebuild(&mut self, extent: &ParticleExtent) {
        // A few far larger or faster particles must not enlarge the cells of all others.
        let margin = extent.greatest_reach.min(3.0 * extent.mean_reach);
        let middles = &extent.middles;
        self.margin = margin;
        let rigids = self.bounds().wider(margin);
        let area = Bounds {
            min: rigids.min.greatest(middles.min - Vector::new(margin, margin, margin)),
            max: rigids.max.least(middles.max + Vector::new(margin, margin, margin)),
        };
        self.measure(&area);
        self.count_entries(&area);
        self.write_entries(&area);
    }

    /// Grid locations of four particles, and the lanes that may be near a rigid. `all` is the box of all rigids.
    #[inline]
    pub fn look(&self, swept_boxes: &SweptBoxes, all: &Bounds) -> NearLanes {
        match swept_boxes.touching(all) {
            0 => NearLanes::default(),
            lanes => {
                let near_lanes = self.near_lanes(swept_boxes);
                NearLanes {
                    lanes: lanes & near_lanes.lanes,
                    ..near_lanes
                }
            }
        }
    }

    #[inline]
    fn near_lanes(&self, swept_boxes: &SweptBoxes) -> NearLanes {
        let middles = swept_boxes.middles();
        let cells = self.cells_of(&middles);
        let large = swept_boxes.reaches().simd_gt(f32x4::splat(self.margin)).to_bitmask() | self.outside(&middles);
        let mut lanes = large;
        for index in &self.large {
            lanes |= swept_boxes.touching(&self.boxes[usize::from(*index)]);
        }
        let locations = std::array::from_fn(|lane| {
            let cell = cells[lane] as usize;
            lanes |= u32::from(self.starts[cell] != self.starts[cell + 1]) << lane;
            GridLocation {
                cell: cells[lane] as u32,
                is_large: large >> lane & 1 == 1,
            }
        });
        NearLanes { lanes, locations }
    }

    #[inline]
    fn outside(&self, middles: &[f32x4; 3]) -> u32 {
        let (least, most): ([f32; 3], [f32; 3]) = (self.origin.into(), self.end.into());
        let outside = |axis: usize| {
            middles[axis].simd_lt(f32x4::splat(least[axis])) | middles[axis].simd_gt(f32x4::splat(most[axis]))
        };
        (outside(0) | outside(1) | outside(2)).to_bitmask()
    }

    #[inline]
    fn cells_of(&self, middles: &[f32x4; 3]) -> [i32; LANES] {
        let origin: [f32; 3] = self.origin.into();
        let [x, y, z] = std::array::from_fn(|axis| {
            let place = (middles[axis] - f32x4::splat(origin[axis])) * f32x4::splat(self.cells_per_metre[axis]);
            let last = f32x4::splat((self.size[axis] - 1) as f32);
            place.fast_max(f32x4::splat(0.0)).fast_min(last).fast_trunc_int()
        });
        let [width, height] = [self.size[0] as i32, self.size[1] as i32].map(i32x4::splat);
        ((z * height + y) * width + x).to_array()
    }

    /// Appends the rigids whose boxes touch `bounds`; `first` is added to their indices. Never allocates.
    #[inline]
    pub fn find_touching(&self, bounds: &WideBounds, location: GridLocation, first: u32, near: &mut Vec<u32>) {
        let touches = |index: &usize| self.wide[*index].touches(bounds);
        if location.is_large {
            near.extend((0..self.wide.len()).filter(touches).map(|index| first + index as u32));
            return;
        }
        let large = self.large.iter().map(|index| usize::from(*index));
        near.extend(large.filter(touches).map(|index| first + index as u32));
        let cell = location.cell as usize;
        let entries = &self.entries[self.starts[cell] as usize..self.starts[cell + 1] as usize];
        // Written first and kept if it touches: branch-free, since the condition is unpredictable.
        let mut count = near.len();
        near.resize(count + entries.len(), 0);
        for index in entries {
            near[count] = first + u32::from(*index);
            count += usize::from(touches(&usize::from(*index)));
        }
        near.truncate(count);
    }

    fn measure(&mut self, area: &Bounds) {
        (self.origin, self.end) = (area.min, area.max);
        let extent = (area.max - area.min).greatest(Vector::new(1e-3, 1e-3, 1e-3));
        let cells = cell_limit(self.boxes.len());
        let side = libm::cbrtf(extent.x * extent.y * extent.z / cells as f32);
        let mut left = cells;
        for (axis, length) in <[f32; 3]>::from(extent).into_iter().enumerate() {
            let wanted = (length / side).clamp(1.0, MAX_CELLS_PER_AXIS) as usize;
            self.size[axis] = wanted.min(left).max(1);
            left /= self.size[axis];
            self.cells_per_metre[axis] = self.size[axis] as f32 / length;
        }
    }

    fn count_entries(&mut self, area: &Bounds) {
        let cells: usize = self.size.iter().product();
        self.starts.clear();
        self.starts.resize(cells + 2, 0);
        self.large.clear();
        for index in 0..self.boxes.len() {
            let Some(span) = self.span_of(index, area) else {
                continue;
            };
            if span.count() > MAX_CELLS_PER_RIGID {
                self.large.push(index as u16);
                continue;
            }
            // Shifted by two: after the prefix sums a cell's start is at the next index, where writing increments it.
            self.for_each_cell(&span, |starts, _, cell| starts[cell + 2] += 1);
        }
        for cell in 2..self.starts.len() {
            self.starts[cell] += self.starts[cell - 1];
        }
    }

    fn write_entries(&mut self, area: &Bounds) {
        self.entries.clear();
        self.entries.resize(self.starts[self.starts.len() - 1] as usize, 0);
        for index in 0..self.boxes.len() {
            let Some(span) = self.span_of(index, area) else {
                continue;
            };
            if span.count() > MAX_CELLS_PER_RIGID {
                continue;
            }
            self.for_each_cell(&span, |starts, entries, cell| {
                entries[starts[cell + 1] as usize] = index as u16;
                starts[cell + 1] += 1;
            });
        }
    }

    fn for_each_cell(&mut self, span: &CellRange, mut act: impl FnMut(&mut [u32], &mut [u16], usize)) {
        for z in span.from[2]..span.to[2] {
            for y in span.from[1]..span.to[1] {
                let row = (z * self.size[1] + y) * self.size[0];
                for x in span.from[0]..span.to[0] {
                    act(&mut self.starts, &mut self.entries, row + x);
                }
            }
        }
    }

    /// Cells of a rigid; none outside of the area.
    fn span_of(&self, index: usize, area: &Bounds) -> Option<CellRange> {
        let bounds = self.boxes[index].wider(self.margin);
        if !bounds.touches(area) {
            return None;
        }
        let (from, to) = (self.place_of(bounds.min), self.place_of(bounds.max));
        Some(CellRange {
            from,
            to: to.map(|last| last + 1),
        })
    }

    fn place_of(&self, point: Vector) -> [usize; 3] {
        let offset: [f32; 3] = (point - self.origin).into();
        std::array::from_fn(|axis| {
            let place = offset[axis] * self.cells_per_metre[axis];
            // Float to integer conversion saturates; negative numbers become 0.
            (place as usize).min(self.size[axis] - 1)
        })
    }
}

fn cell_limit(rigids: usize) -> usize {
    (rigids * CELLS_PER_RIGID).clamp(MIN_CELLS, MAX_CELLS)
}
