//! The layout of a view: the numbers that callers of `arrange` give.
//!
//! [`VIEW_LENGTH`] numbers: \[0] purpose, 0 eye, 1 light; \[1] blend, 0 the previous step, 1 now; \[2] cull, 0 or 1; \[3] pad, metres
//! added to each radius per unit of clip w; \[4..19] clipFromWorld by columns; \[20..22] direction of the order; \[23]
//! reach, factor on the radius; \[24..29] box of the receivers, least and greatest corner.
//!
//! What follows serves coverage, see `coverage`: \[30] metres that a pixel spans per unit of clip w; \[31], \[32] depths
//! along the direction at the near and the far plane; \[33] how many covers make certain, 1 to 16, or 0 to leave nothing
//! out that others cover; \[34], \[35] how far what is drawn may be from the solids, in radii and in pixels; \[36] 1 where
//! puffs turn to the eye; \[37] metres by which ink may come nearer than its lobe where a surface lifts it, per unit of
//! clip w; \[38], \[39] where shadows start behind the centre, at least and at most; \[40] how deep behind its centre a
//! puff can be seen; \[41] balls of a puff, 0, 4, 8 or 12: for each variation their x, y, z and radii stand behind the
//! view, all in radii; \[42] how many boxes hold the surfaces that lift ink, 0 to 8; \[43..90] these boxes, each its least
//! and its greatest corner; \[91] 1 where behind the balls of all variations stand the tables of their start caps, 2,048
//! numbers each.

/// Numbers of a view, without its solids.
pub const VIEW_LENGTH: usize = CAPS_FOLLOW + 1;

/// Index of the flag for start caps behind the solids.
pub(crate) const CAPS_FOLLOW: usize = 43 + 6 * LIFTERS_LIMIT;

/// Maximum number of boxes of surfaces that lift ink.
pub(crate) const LIFTERS_LIMIT: usize = 8;
