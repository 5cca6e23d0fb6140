//! Which puffs other puffs certainly hide, and which casters' shadow others certainly throw already.
//!
//! One routine for both. Puffs come near to far, along the eye's view or along the light. Each is asked whether all that
//! it could add lies behind what is certain so far; if not it stays, and what is certain of it goes into the grid. A cell
//! keeps the farthest depth of the opaque interior that covers all of it, so that a puff whose centre lies farther but
//! which bulges to the front stays, and ink, which lies deeper than its puff, never covers. Conservative: it errs
//! towards keeping, and what it leaves out changes no pixel of the picture that is drawn in the same order.

mod chart;
mod disc;
mod grid;
mod outline;
mod plan;
mod solids;

pub use plan::Plan;
pub use solids::BALLS_LIMIT;

pub(crate) use chart::Footprint;
use grid::Grid;
use outline::{Outline, Outliner};
use solids::Turns;

/// The grid and the tables; their memory is taken once and used for every view.
#[derive(Debug)]
pub(crate) struct Coverage {
    grid: Grid,
    turns: Turns,
    outline: Outline,
}

impl Coverage {
    /// For at most `capacity` particles: few of them need no fine grid.
    pub(crate) fn new(capacity: usize) -> Self {
        Self {
            grid: Grid::new(capacity),
            turns: Turns::new(),
            outline: Outline::default(),
        }
    }

    /// Keeps those of `rows` that `plan` cannot rule out, in their order. `place` and `look` give those of a row, `keep`
    /// takes both for the next one that stays. Returns how many do.
    pub(crate) fn sift<R: Copy>(
        &mut self,
        plan: &Plan,
        footprint: &Footprint,
        rows: &[R],
        place: impl Fn(R) -> [f32; 4],
        look: impl Fn(R) -> [u32; 2],
        mut keep: impl FnMut(usize, [f32; 4], [u32; 2]),
    ) -> usize {
        self.grid.lay(plan, footprint);
        let outliner = Outliner::new(plan, &self.grid, &self.turns);
        let mut kept = 0;
        for row in rows {
            let place = place(*row);
            if !outliner.place(place, &mut self.outline) || self.grid.hides_block_by_block(&self.outline.hull) {
                continue;
            }
            let look = look(*row);
            outliner.draw(place, look, &mut self.outline);
            if self.outline.outer().iter().all(|disc| self.grid.hides(disc)) {
                continue;
            }
            self.grid.cover(self.outline.inner());
            keep(kept, place, look);
            kept += 1;
        }
        kept
    }
}
