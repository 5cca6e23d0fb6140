//! Occlusion culling: drops puffs that other puffs certainly hide, and casters whose shadow others certainly throw.
//!
//! Both use one algorithm. Puffs are processed from near to far, along the view or along the light. A puff is dropped
//! if everything it could show lies behind the covered depths so far; otherwise its certain interior is added to the
//! grid. A cell keeps the maximum depth of the opaque interior that covers it entirely. So a puff with a farther centre
//! that bulges to the front stays, and ink, which lies deeper than its puff, never covers. The test is conservative:
//! the picture, drawn in the same order, is identical without it.

pub(crate) mod chart;
pub(crate) mod disc;
pub(crate) mod grid;
pub(crate) mod outline;
pub(crate) mod plan;
pub(crate) mod polygon;
pub(crate) mod solids;
pub(crate) mod start_caps;

use crate::arrange::coverage::grid::CoverageGrid;
use crate::arrange::coverage::outline::{NOTHING_LEFT, Outline, Outliner};
use crate::arrange::coverage::plan::PlanKind;
use crate::arrange::coverage::solids::Orientations;
use crate::arrange::row_layout::{Attributes, NO_END};
use crate::math::radix_sort::Entry;

pub use plan::Plan;

pub(crate) use chart::ChartExtent;

/// The grid and its tables. Allocated once and used for all views.
#[derive(Debug)]
pub(crate) struct Coverage {
    pub grid: CoverageGrid,
    /// See [`Outliner::billow`].
    pub billow: Option<f32>,
    orientations: Orientations,
    outline: Outline,
}

impl Coverage {
    /// Creates the grid for at most `capacity` particles.
    pub(crate) fn new(capacity: usize) -> Self {
        Self {
            grid: CoverageGrid::new(capacity),
            billow: None,
            orientations: Orientations::new(),
            outline: Outline::default(),
        }
    }

    /// Culls `rows`: keys and particle indices, in order. `places` and `shape` are those of the particles. Returns the
    /// number of rows that stay, with their shapes in `shapes`. For shadows the keys become ends.
    pub(crate) fn cull(
        &mut self,
        plan: &Plan,
        extent: &ChartExtent,
        rows: &mut [Entry],
        shapes: &mut [Attributes],
        places: &[[f32; 4]],
        shape: impl Fn(usize) -> Attributes,
    ) -> usize {
        self.grid.reset(plan, extent);
        let outliner = Outliner::new(plan, &self.grid, &self.orientations, self.billow);
        let mut kept = 0;
        let mut batch = [[0.0; 4]; BATCH];
        for at in 0..rows.len() {
            if at % BATCH == 0 {
                // Read together: the places are in no order, and a processor waits for several reads at once.
                let ahead = batch.iter_mut().zip(&rows[at..]);
                ahead.for_each(|(place, row)| *place = places[row[1] as usize]);
            }
            let (particle, place) = (rows[at][1] as usize, batch[at % BATCH]);
            if !outliner.place(place, &mut self.outline) || self.grid.hides_hull(&self.outline.hull) {
                continue;
            }
            let shape = shape(particle);
            outliner.draw(place, shape, &mut self.outline);
            if self.is_hidden(plan) {
                continue;
            }
            self.grid.cover(&self.outline.inner);
            (rows[kept], shapes[kept]) = (rows[at], shape);
            kept += 1;
        }
        if plan.has_ends() {
            kept = self.shorten(plan, extent, &mut rows[..kept], shapes, places);
        }
        kept
    }

    fn is_hidden(&self, plan: &Plan) -> bool {
        match plan.kind {
            PlanKind::Bodies(_) => self.grid.hides(&self.outline.outer),
            PlanKind::Shadows(_) => self.grid.hides_polygon(&self.outline.polygon),
        }
    }

    /// Shortens shadows that others certainly continue. Large puffs are selected first as those that do not end, which
    /// minimises their number.
    fn shorten(
        &mut self,
        plan: &Plan,
        extent: &ChartExtent,
        rows: &mut [Entry],
        shapes: &mut [Attributes],
        places: &[[f32; 4]],
    ) -> usize {
        self.grid.reset(plan, extent);
        let outliner = Outliner::new(plan, &self.grid, &self.orientations, self.billow);
        let typical = extent.typical() / plan.radius_factor();
        for are_large in [true, false] {
            for (row, shape) in rows.iter_mut().zip(&*shapes) {
                let place = places[row[1] as usize];
                if (place[3] > LARGE * typical) != are_large {
                    continue;
                }
                outliner.place(place, &mut self.outline);
                if self.grid.hides_hull(&self.outline.hull) {
                    row[0] = NOTHING_LEFT;
                    continue;
                }
                outliner.draw(place, *shape, &mut self.outline);
                let polygon = &self.outline.polygon;
                let farthest = self.grid.farthest(polygon, polygon.depth, f32::INFINITY);
                row[0] = outliner.end(place, farthest, &self.outline);
                if row[0] == NO_END {
                    self.grid.cover(&self.outline.inner);
                }
            }
        }
        let mut kept = 0;
        for at in 0..rows.len() {
            if rows[at][0] != NOTHING_LEFT {
                (rows[kept], shapes[kept]) = (rows[at], shapes[at]);
                kept += 1;
            }
        }
        kept
    }
}

/// Places that are read at a time.
const BATCH: usize = 64;
/// Minimum size of a large puff, in typical radii.
const LARGE: f32 = 1.25;
