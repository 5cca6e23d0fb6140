//! Arranging particles into rows: the visible ones, near to far, or the casters of a light, far to near, in a reused
//! buffer.
//!
//! The result depends only on the particles and the view, and the simulation does not change. One pass over the
//! particles interpolates, culls and measures. The rest is sorted by depth along the view direction, then by index, and
//! written as rows. Rows of eroded puffs, which have other shaders, follow all others. The memory of the attributes holds the entries while sorting.

pub(crate) mod coverage;
pub(crate) mod deformation;
pub mod glow;
pub mod row_layout;
pub mod rows;
pub(crate) mod view;
pub mod view_layout;
pub(crate) mod volume;

use wide::f32x4;

use crate::arrange::coverage::Coverage;
use crate::arrange::coverage::chart::ChartExtent;
use crate::arrange::row_layout::{ATTRIBUTE_WORDS, Attributes, EROSION, NO_END, PLACE_FLOATS};
use crate::arrange::rows::{RowSampler, caster};
use crate::arrange::view::View;
use crate::math::radix_sort::{self, Entry, Histogram};
use crate::math::simd::{LANES, Vector4, blocks};
use crate::particles::Particles;

/// The rows of the last call, and scratch memory. 40 bytes per particle.
#[derive(Debug)]
pub struct Arranger {
    place: Vec<[f32; PLACE_FLOATS]>,
    attributes: Vec<Attributes>,
    order: Vec<Entry>,
    histogram: Histogram,
    coverage: Coverage,
    bounds: [f32; 7],
    count: usize,
    whole: usize,
}

impl Arranger {
    /// Creates the buffers for `capacity` particles.
    pub fn new(capacity: usize) -> Self {
        Self {
            // Places are written in whole blocks.
            place: vec![[0.0; PLACE_FLOATS]; capacity.next_multiple_of(LANES)],
            attributes: vec![[0; ATTRIBUTE_WORDS]; capacity],
            order: vec![[0; 2]; capacity],
            histogram: Histogram::new(),
            coverage: Coverage::new(capacity),
            bounds: [0.0; 7],
            count: 0,
            whole: 0,
        }
    }

    /// Places and radii of the rows. Valid up to the count of the last call.
    pub fn place(&self) -> &[[f32; PLACE_FLOATS]] {
        &self.place
    }

    /// Packed attributes of the rows. Valid up to the count of the last call.
    pub fn attributes(&self) -> &[Attributes] {
        &self.attributes
    }

    /// Minimum corner, then maximum corner (m) of all particles with their radii, culled or not, then the largest
    /// radius. Zeros if no particle is visible.
    pub fn bounds(&self) -> &[f32; 7] {
        &self.bounds
    }

    /// Number of rows whose puffs are not eroded. They come first.
    pub fn whole(&self) -> usize {
        self.whole
    }

    /// Displacement (m) of each row's particle in the latest step. Held particles do not move.
    pub fn moves(&self, particles: &Particles) -> Vec<[f32; 3]> {
        let moved = |i: usize| {
            [
                particles.x[i] - particles.px[i],
                particles.y[i] - particles.py[i],
                particles.z[i] - particles.pz[i],
            ]
        };
        let rows = self.order[..self.count].iter();
        rows.map(|[_, particle]| match particles.held {
            Some(_) => [0.0; 3],
            None => moved(*particle as usize),
        })
        .collect()
    }

    /// The coverage grid of the last call: columns, rows, stride, chart coordinates of its corner (left, low), and
    /// cells per unit of the chart. No rows if coverage was off.
    pub fn coverage_shape(&self) -> [f32; 6] {
        self.coverage.grid.shape()
    }

    /// Covered depth (m) along the view of each cell; infinite where nothing covers.
    pub fn coverage_depths(&self) -> &[f32] {
        self.coverage.grid.depths()
    }

    /// Writes the rows that `view` needs and returns their number.
    pub fn arrange(&mut self, particles: &Particles, view: &View, sampler: &RowSampler) -> usize {
        let mut chart_extent = view.coverage.map(|plan| ChartExtent::new(&plan.chart));
        let count = self.collect(particles, view, sampler, chart_extent.as_mut());
        radix_sort::sort(
            &mut entries(&mut self.attributes)[..count],
            &mut self.order[..count],
            &mut self.histogram,
        );
        let count = match (&view.coverage, &chart_extent) {
            (Some(plan), Some(chart_extent)) => {
                let shape = |particle: usize| sampler.shape(particles, particle);
                let rows = &mut self.order[..count];
                self.coverage.billow = sampler.is_deformed().then_some(sampler.billow);
                self.coverage
                    .cull(plan, chart_extent, rows, &mut self.attributes, &self.place, shape)
            }
            _ => {
                self.coverage.grid.empty();
                count
            }
        };
        self.write(particles, view, sampler, count);
        self.count = count;
        let erode = sampler.radii.erodes() || particles.looks.as_ref().is_some_and(|looks| looks.erode());
        self.whole = if erode { self.move_eroded_back() } else { count };
        count
    }

    /// Moves the rows of eroded puffs behind the others and returns the number of the others.
    fn move_eroded_back(&mut self) -> usize {
        let mut whole = 0;
        let mut end = self.count;
        while whole < end {
            if EROSION.of(self.attributes[whole]) == 0 {
                whole += 1;
                continue;
            }
            end -= 1;
            self.place.swap(whole, end);
            self.attributes.swap(whole, end);
            self.order.swap(whole, end);
        }
        whole
    }

    /// Writes the rows of the remaining entries over the places used for culling, which left the shapes of the rows.
    fn write(&mut self, particles: &Particles, view: &View, sampler: &RowSampler, count: usize) {
        if view.is_light {
            // On GPUs, which test the stencil before the fragment shader, volumes far to near run it less often.
            self.order[..count].reverse();
            self.attributes[..count].reverse();
        }
        let has_ends = view.coverage.is_some_and(|plan| plan.has_ends());
        for (row, [end, particle]) in self.order[..count].iter().enumerate() {
            let particle = *particle as usize;
            self.place[row] = sampler.place(particles, particle);
            let shape = match view.coverage {
                Some(_) => self.attributes[row],
                None => sampler.shape(particles, particle),
            };
            self.attributes[row] = match view.is_light {
                true => caster(shape, if has_ends { *end } else { NO_END }),
                false => sampler.body(particles, particle, shape),
            };
        }
    }

    /// Writes an entry for each particle that the view keeps, and measures the bounds.
    fn collect(
        &mut self,
        particles: &Particles,
        view: &View,
        sampler: &RowSampler,
        mut chart_extent: Option<&mut ChartExtent>,
    ) -> usize {
        let mut extent = RowBounds::new();
        let mut count = 0;
        let found = entries(&mut self.attributes);
        for block in 0..particles.padded_alive() / LANES {
            let (place, radius) = blend(particles, sampler, block);
            let seen = radius.simd_gt(f32x4::ZERO) & living(particles, block);
            extent.add(place, radius, seen);
            let kept = view.cull.map_or(seen, |cull| cull.keeps(place, radius) & seen);
            if let (Some(chart_extent), Some(plan)) = (chart_extent.as_deref_mut(), &view.coverage) {
                chart_extent.add(&plan.chart, place, radius * f32x4::splat(plan.radius_factor()), kept);
            }
            let kept = kept.to_bitmask() as usize;
            if view.coverage.is_some() {
                let rows = f32x4::transpose([place.x, place.y, place.z, radius]);
                let places = self.place[block * LANES..][..LANES].iter_mut();
                places.zip(rows).for_each(|(place, row)| *place = row.to_array());
            }
            let depth = view.depth(place).to_array();
            for (lane, depth) in depth.into_iter().enumerate() {
                // Without a branch: one more entry may be written than counts.
                found[count] = [radix_sort::key(depth), (block * LANES + lane) as u32];
                count += kept >> lane & 1;
            }
        }
        self.bounds = extent.corners();
        count
    }
}

/// The memory of attributes as entries, at least one for each row.
fn entries(attributes: &mut [Attributes]) -> &mut [Entry] {
    attributes.as_flattened_mut().as_chunks_mut().0
}

/// Places and radii of a block. Same arithmetic as [`RowSampler::place`].
#[inline(always)]
fn blend<'p>(particles: &'p Particles, sampler: &RowSampler, block: usize) -> (Vector4, f32x4) {
    let column = |column: &'p [f32]| blocks(column, block + 1);
    if let Some(held) = &particles.held {
        let place = Vector4::load(column(&held.x), column(&held.y), column(&held.z), block);
        let lanes = |values: &'p [f32]| f32x4::new(column(values)[block]);
        let age = lanes(&held.age);
        let lifetime = lanes(&particles.lifetime);
        let radius = particles.radii(&sampler.radii, block, [lanes(&held.size), age, lifetime]);
        return (place, age.simd_ge(f32x4::ZERO) & radius);
    }
    let before = Vector4::load(
        column(&particles.px),
        column(&particles.py),
        column(&particles.pz),
        block,
    );
    let now = Vector4::load(column(&particles.x), column(&particles.y), column(&particles.z), block);
    let place = before * f32x4::splat(1.0 - sampler.blend) + now * f32x4::splat(sampler.blend);
    let lanes = |values: &'p [f32]| f32x4::new(column(values)[block]);
    let age = lanes(&particles.age) - f32x4::splat((1.0 - sampler.blend) * sampler.dt);
    let lifetime = lanes(&particles.lifetime);
    let radius = particles.radii(&sampler.radii, block, [lanes(&particles.size), age, lifetime]);
    (place, age.simd_ge(f32x4::ZERO) & radius)
}

/// A mask of the lanes of a block that hold living particles.
#[inline(always)]
fn living(particles: &Particles, block: usize) -> f32x4 {
    let left = (particles.alive() - block * LANES) as f32;
    f32x4::new([0.0, 1.0, 2.0, 3.0]).simd_lt(f32x4::splat(left))
}

/// Accumulates a bounding box.
struct RowBounds {
    least: Vector4,
    greatest: Vector4,
    radius: f32x4,
}

impl RowBounds {
    fn new() -> Self {
        Self {
            least: Vector4::splat([f32::INFINITY; 3]),
            greatest: Vector4::splat([f32::NEG_INFINITY; 3]),
            radius: f32x4::ZERO,
        }
    }

    #[inline(always)]
    fn add(&mut self, place: Vector4, radius: f32x4, seen: f32x4) {
        let lower = |least: f32x4, place: f32x4| seen.select(least.fast_min(place - radius), least);
        let upper = |greatest: f32x4, place: f32x4| seen.select(greatest.fast_max(place + radius), greatest);
        let (least, greatest) = (self.least, self.greatest);
        self.radius = seen.select(self.radius.fast_max(radius), self.radius);
        self.least = Vector4 {
            x: lower(least.x, place.x),
            y: lower(least.y, place.y),
            z: lower(least.z, place.z),
        };
        self.greatest = Vector4 {
            x: upper(greatest.x, place.x),
            y: upper(greatest.y, place.y),
            z: upper(greatest.z, place.z),
        };
    }

    fn corners(&self) -> [f32; 7] {
        let least = |lanes: f32x4| lanes.to_array().into_iter().fold(f32::INFINITY, f32::min);
        let greatest = |lanes: f32x4| lanes.to_array().into_iter().fold(f32::NEG_INFINITY, f32::max);
        let (low, high) = (self.least, self.greatest);
        let corners = [
            least(low.x),
            least(low.y),
            least(low.z),
            greatest(high.x),
            greatest(high.y),
            greatest(high.z),
            greatest(self.radius),
        ];
        if corners[0].is_finite() { corners } else { [0.0; 7] }
    }
}
