//! Which puffs other puffs certainly hide, and which casters' shadow others certainly throw already.
//!
//! One routine for both. Puffs come near to far, along the eye's view or along the light. Each is asked whether all that
//! it could add lies behind what is certain so far; if not it stays, and what is certain of it goes into the grid. A cell
//! keeps the farthest depth of the opaque interior that covers all of it, so that a puff whose centre lies farther but
//! which bulges to the front stays, and ink, which lies deeper than its puff, never covers. Conservative: it errs
//! towards keeping, and what it leaves out changes no pixel of the picture that is drawn in the same order.

pub(crate) mod chart;
pub(crate) mod disc;
pub(crate) mod grid;
pub(crate) mod outline;
pub(crate) mod plan;
pub(crate) mod polygon;
pub(crate) mod solids;
pub(crate) mod start_caps;

use crate::arrange::coverage::grid::CoverageGrid;
use crate::arrange::coverage::outline::{NO_END, NOTHING_LEFT, Outline, Outliner};
use crate::arrange::coverage::plan::PlanKind;
use crate::arrange::coverage::solids::Orientations;
use crate::math::radix_sort::Entry;

pub use plan::Plan;

pub(crate) use chart::ChartExtent;

/// The grid and the tables; their memory is taken once and used for every view.
#[derive(Debug)]
pub(crate) struct Coverage {
    pub grid: CoverageGrid,
    orientations: Orientations,
    outline: Outline,
}

impl Coverage {
    /// For at most `capacity` particles: few of them need no fine grid.
    pub(crate) fn new(capacity: usize) -> Self {
        Self {
            grid: CoverageGrid::new(capacity),
            orientations: Orientations::new(),
            outline: Outline::default(),
        }
    }

    /// Keeps those of `rows` that `plan` cannot rule out, in their order: keys and particles. `places` has those of the
    /// particles, `attributes` gives theirs. Returns how many stay; of shadows the keys become ends.
    pub(crate) fn cull(
        &mut self,
        plan: &Plan,
        extent: &ChartExtent,
        rows: &mut [Entry],
        places: &[[f32; 4]],
        attributes: impl Fn(usize) -> [u32; 2],
    ) -> usize {
        self.grid.reset(plan, extent);
        let outliner = Outliner::new(plan, &self.grid, &self.orientations);
        let mut kept = 0;
        for at in 0..rows.len() {
            let particle = rows[at][1] as usize;
            let place = places[particle];
            if !outliner.place(place, &mut self.outline) || self.grid.hides_hull(&self.outline.hull) {
                continue;
            }
            outliner.draw(place, attributes(particle), &mut self.outline);
            if self.is_hidden(plan) {
                continue;
            }
            self.grid.cover(self.outline.inner());
            rows[kept] = rows[at];
            kept += 1;
        }
        if plan.has_ends() {
            kept = self.shorten(plan, extent, &mut rows[..kept], places, attributes);
        }
        kept
    }

    fn is_hidden(&self, plan: &Plan) -> bool {
        match plan.kind {
            PlanKind::Bodies(_) => self.outline.outer().iter().all(|disc| self.grid.hides(disc)),
            PlanKind::Shadows(_) => self.grid.hides_polygon(&self.outline.polygon),
        }
    }

    /// Lets shadows end where others certainly go on. Those that do not end are chosen first among the large ones, which
    /// leave the fewest.
    fn shorten(
        &mut self,
        plan: &Plan,
        extent: &ChartExtent,
        rows: &mut [Entry],
        places: &[[f32; 4]],
        attributes: impl Fn(usize) -> [u32; 2],
    ) -> usize {
        self.grid.reset(plan, extent);
        let outliner = Outliner::new(plan, &self.grid, &self.orientations);
        let typical = extent.typical() / plan.radius_factor();
        for are_large in [true, false] {
            for row in rows.iter_mut() {
                let particle = row[1] as usize;
                let place = places[particle];
                if (place[3] > LARGE * typical) != are_large {
                    continue;
                }
                outliner.place(place, &mut self.outline);
                outliner.draw(place, attributes(particle), &mut self.outline);
                let farthest = self.grid.farthest(&self.outline.polygon, f32::INFINITY);
                row[0] = outliner.end(place, farthest, &self.outline);
                if row[0] == NO_END {
                    self.grid.cover(self.outline.inner());
                }
            }
        }
        let mut kept = 0;
        for at in 0..rows.len() {
            if rows[at][0] != NOTHING_LEFT {
                rows[kept] = rows[at];
                kept += 1;
            }
        }
        kept
    }
}

/// Typical radii from which a puff is large.
const LARGE: f32 = 1.25;
