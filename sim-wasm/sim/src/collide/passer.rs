//! One particle as the search for obstacles sees it.

use super::contact::{Obstacle, Traveller};
use super::space::{Vector, WideBounds};
use super::survey::Spot;

/// A particle that may pass obstacles by.
pub(crate) struct Passer {
    /// The box around its way.
    pub(crate) bounds: WideBounds,
    /// Where to look for rigids.
    #[cfg_attr(not(feature = "rigids"), expect(dead_code, reason = "there are none"))]
    pub(crate) spot: Spot,
    from: Vector,
    to: Vector,
    radius: f32,
    /// Its way takes the whole step.
    is_whole: bool,
}

impl Passer {
    /// `reach` is the greatest radius (m) that the particle may have.
    #[inline]
    pub(crate) fn new(traveller: &Traveller, reach: f32, spot: Spot) -> Self {
        Self {
            bounds: WideBounds::of_way(traveller.from, traveller.to, reach),
            spot,
            from: traveller.from,
            to: traveller.to,
            radius: traveller.radius,
            is_whole: traveller.began == 0.0,
        }
    }

    /// True when it surely does not touch the obstacle.
    #[inline]
    pub(crate) fn passes<C>(&self, obstacle: &Obstacle<C>) -> bool {
        let Obstacle { core, motion, .. } = obstacle;
        self.is_whole && core.is_passed_by(motion, self.from, self.to, self.radius)
    }
}
