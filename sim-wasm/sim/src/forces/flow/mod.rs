//! Flows: air moves along a stroke, turns about it and is drawn to it.
//!
//! With c the nearest point of the stroke, t its direction there and r the part of p - c across t, the air at p moves at
//!
//! (1 - |p - c|^2 / R^2)^2 * (U t + w t x r - 25 sqrt(5) / 16 I r / R),  and is still where |p - c| >= R.
//!
//! Parameters: `flows.#.speed` U (m/s), `.radius` R (m), `.swirl` w (rad/s, counter-clockwise seen against t), `.inflow`
//! I (m/s, the greatest speed towards the stroke), `.points.*` and `.closed` (the stroke, see `path`), `.position.*` (m,
//! origin of the points), `.scale` (factor on the points and on R). The last step limits the inflow to half of the way to
//! the stroke. Beyond an end the flow fades as a ball, without a pull back to that end.
//!
//! The stroke is followed by its nearest sample and the parabola through it. The swirl must not move a particle
//! outwards: it moves along the chord of its circle.

mod kernel;
mod near;
pub(crate) mod path;
