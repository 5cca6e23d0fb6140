//! The layout of a view: the numbers that callers of `arrange` give.
//!
//! [`VIEW_LENGTH`] numbers by index:
//! - 0: purpose, 0 for the eye, 1 for the light
//! - 1: blend, 0 for the previous step, 1 for now
//! - 2: frustum culling, 0 or 1
//! - 3: pad, metres added to each radius per unit of clip w
//! - 4 to 19: clipFromWorld by columns
//! - 20 to 22: direction of the order
//! - 23: reach, a factor on the radius
//! - 24 to 29: minimum and maximum corner of the box of the receivers
//!
//! The others are for `coverage`:
//! - 30: metres that a pixel spans per unit of clip w
//! - 31, 32: depths along the direction at the near and the far plane
//! - 33: number of covers that hide a row, 1 to 16, or 0 to disable occlusion culling
//! - 34, 35: maximum distance between the drawn puffs and the solids, in radii and in pixels
//! - 36: 1 if puffs rotate towards the eye
//! - 37: metres by which a surface raises ink in front of its lobe at most, per unit of clip w
//! - 38, 39: minimum and maximum distance behind the centre at which shadows start, in radii
//! - 40: maximum depth behind its centre at which a puff is visible, in radii
//! - 41: balls of a puff, 0, 4, 8 or 12. For each variation their x, y, z and radius follow the view, all in radii
//! - 42: number of boxes around surfaces that raise ink, 0 to 8
//! - 43 to 90: minimum and maximum corner of each of these boxes
//! - 91: 1 if the tables of start caps follow the balls of all variations, 2,048 numbers each

/// Numbers of a view, without its solids.
pub const VIEW_LENGTH: usize = CAPS_FOLLOW + 1;

/// Index of the flag for start caps behind the solids.
pub(crate) const CAPS_FOLLOW: usize = 43 + 6 * LIFTERS_LIMIT;

/// Maximum number of boxes of surfaces that lift ink.
pub(crate) const LIFTERS_LIMIT: usize = 8;
